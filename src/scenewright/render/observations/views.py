"""Cameras in a world and what they see: colour, depth, instances, classes, normals.

The camera is a pinhole. Its pose is written as OpenCV has it: x to the right of the picture, y
down, z ahead; the world as everywhere here: metres, z up. With the focal length f in pixels a
point (X, Y, Z) of the camera's frame falls on

    u = f X / Z + width / 2,  v = f Y / Z + height / 2,

and the middle of the first pixel is at (0.5, 0.5).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.render.observations.world import VisibleWorld
from scenewright.render.picture import CENTRE, CameraView, Pixels, draw_view, look_through

KINDS = ("rgb", "depth", "instance", "semantic", "normals")
"""What can be observed."""
SUN = (-0.62, -0.48, 0.62)
"""The direction to the sun: low enough to come in by windows."""

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]


class Viewpoint(NamedTuple):
    """Where a camera is: its ``eye`` in the world, in metres; ``yaw`` from +x counter-clockwise
    and ``pitch`` upwards, in radians; the room and level it is in; how far it is from walls and
    pieces in plan, in metres (None: it was set by hand)."""

    eye: tuple[float, float, float]
    yaw: float
    pitch: float
    room: str = ""
    level: str = ""
    clearance: float | None = None


class Lens(NamedTuple):
    """Width and height of a picture in pixels, and the width of the view in radians."""

    width: int
    height: int
    fov: float

    @property
    def focal(self) -> float:
        """The focal length in pixels, the same in both directions.

        >>> round(Lens(640, 480, np.pi / 2).focal, 6)
        320.0
        """
        return float(self.width / 2 / np.tan(self.fov / 2))


class Observation(NamedTuple):
    """What a camera sees, ``(height, width)`` each and None where it was not asked for: ``rgb``
    (…, 3) in sRGB; ``depth`` along the axis of the camera in metres, 0 where nothing is met;
    ``instance`` the number of what a ray meets first, glass too, 0 for nothing; ``semantic`` the
    number of its class; ``normals`` (…, 3) unit vectors of the faces met in the world's frame,
    turned to the camera, 0 for nothing."""

    viewpoint: Viewpoint
    rgb: Pixels | None = None
    depth: Singles | None = None
    instance: NDArray[np.uint32] | None = None
    semantic: NDArray[np.uint16] | None = None
    normals: Singles | None = None


def axes_of(yaw: float, pitch: float) -> Floats:
    """Directions to the right, up and ahead, as rows.

    >>> axes_of(0.0, 0.0).round(6).tolist()
    [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]
    """
    (c, s), (cp, sp) = (np.cos(yaw), np.sin(yaw)), (np.cos(pitch), np.sin(pitch))
    ahead, right = np.array([cp * c, cp * s, sp]), np.array([s, -c, 0.0])
    return np.stack([right, np.cross(right, ahead), ahead]) + 0.0


def pose_of(viewpoint: Viewpoint) -> Floats:
    """The 4 x 4 matrix from the camera's frame, as OpenCV has it, to the world's.

    >>> pose_of(Viewpoint((1.0, 2.0, 1.5), 0.0, 0.0))[:3, 3].tolist()
    [1.0, 2.0, 1.5]
    """
    right, up, ahead = axes_of(viewpoint.yaw, viewpoint.pitch)
    pose = np.eye(4)
    pose[:3] = np.column_stack([right, -up, ahead, viewpoint.eye])
    return pose


def camera_view(viewpoint: Viewpoint, lens: Lens) -> CameraView:
    """The camera as numbers for rays."""
    axes = axes_of(viewpoint.yaw, viewpoint.pitch).astype(np.float32)
    eye = np.array(viewpoint.eye, np.float32)
    return CameraView(eye, axes, float(np.tan(lens.fov / 2)), lens.width, lens.height)


def observe_view(
    world: VisibleWorld, viewpoint: Viewpoint, lens: Lens, kinds: frozenset[str] = frozenset(KINDS)
) -> Observation:
    """What a camera sees, of each of ``kinds``."""
    view, found = camera_view(viewpoint, lens), Observation(viewpoint)
    if "rgb" in kinds:
        found = found._replace(rgb=draw_view(world.stage, world.casters, view, SUN))
    return _measure(world, view, found, kinds) if kinds - {"rgb"} else found


def _measure(
    world: VisibleWorld, view: CameraView, found: Observation, kinds: frozenset[str]
) -> Observation:
    shape = (view.height, view.width)
    every = np.arange(view.height * view.width, dtype=np.int32)
    seen = look_through(world.measured, world.every, view, every, CENTRE)
    missed = seen.met < 0
    numbers = np.maximum(seen.keys, 0)
    if "depth" in kinds:
        depth = (seen.points - view.eye) @ view.axes[2]
        depth[missed] = 0.0
        found = found._replace(depth=depth.reshape(shape))
    if "instance" in kinds:
        found = found._replace(instance=numbers.astype(np.uint32).reshape(shape))
    if "semantic" in kinds:
        found = found._replace(semantic=world.classes[numbers].reshape(shape))
    if "normals" in kinds:
        found = found._replace(normals=seen.facing.reshape(*shape, 3))
    return found
