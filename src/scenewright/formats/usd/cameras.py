"""A camera a room, where a photographer would stand."""

from __future__ import annotations

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Scene
from scenewright.formats.usd.names import free_path
from scenewright.render.observations.world import build_world
from scenewright.render.photo.following import PhotoFrame
from scenewright.render.photo.standpoints import stand_in_rooms

FOCAL = 0.24
"""24 mm in tenths of the unit of the scene, in which lenses and film are counted."""
SIZE, TRIED = (960, 600), 6
NEAR, FAR = 0.02, 200.0


def define_cameras(stage: Usd.Stage, parent: Sdf.Path, scene: Scene, catalog: Catalog) -> None:
    """A camera for each room that has a free place for one."""
    found = stand_in_rooms(build_world(scene, catalog), frozenset(), SIZE, tried=TRIED)
    for space, _, frame in found:
        path = free_path(stage, parent, space.name or space.id)
        _define_camera(stage, path, frame).GetPrim().SetDisplayName(space.name or space.id)


def _define_camera(stage: Usd.Stage, path: Sdf.Path, frame: PhotoFrame) -> UsdGeom.Camera:
    """The frame looks ahead along its third axis; a camera of USD looks back along its own."""
    camera = UsdGeom.Camera.Define(stage, path)
    right, up, ahead = (row.astype(np.float64).round(6) for row in frame.axes)
    rows = np.eye(4)
    rows[:3, :3], rows[3, :3] = [right, up, -ahead], frame.eye.astype(np.float64).round(6)
    camera.AddTransformOp().Set(Gf.Matrix4d(rows.tolist()))
    left, top, step = (float(value) for value in frame.frame)
    wide, high = -2 * left, frame.height * step
    camera.CreateFocalLengthAttr(FOCAL)
    camera.CreateHorizontalApertureAttr(wide * FOCAL)
    camera.CreateVerticalApertureAttr(high * FOCAL)
    camera.CreateVerticalApertureOffsetAttr((top - high / 2) * FOCAL)
    camera.CreateClippingRangeAttr(Gf.Vec2f(NEAR, FAR))
    return camera
