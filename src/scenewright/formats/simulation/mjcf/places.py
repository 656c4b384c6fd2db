"""Where robots begin and cameras stand: by the free floor of each room."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from scenewright.core.scene import Scene
from scenewright.core.space import Space
from scenewright.geometry.mesh import Floats
from scenewright.render.observations.floor import walkable_floor

EYE, VIEW = 1.4, 62.0
"""Height of cameras above the floor in metres, and their upright angle of view in degrees."""
LEAST = 0.25
"""Least free radius of a place to begin at, metres."""
BESIDE = 0.2
"""Least free radius of a place for a camera, metres."""


class RoomPlace(NamedTuple):
    """A room's freest place ``spawn`` (3,), on its floor, and the ``clear`` radius about it; the
    ``eye`` (3,) of its camera and the point ``seen`` (3,) in the middle of its picture."""

    space: Space
    spawn: Floats
    clear: float
    eye: Floats
    seen: Floats


def room_places(scene: Scene) -> Iterator[RoomPlace]:
    """The places of every room that has any: the camera stands as far as it can from the middle of
    the room and looks there."""
    for level in scene.levels:
        if not any(space.level == level.id for space in scene.spaces):
            continue
        floor = walkable_floor(scene, level.id, EYE)
        clear = floor.clear.values.reshape(-1)
        for number, space in enumerate(floor.spaces):
            cells = np.flatnonzero((floor.room == number).reshape(-1) & (clear >= BESIDE))
            if not len(cells):
                continue
            places = floor.centres(cells)
            best = int(clear[cells].argmax())
            if clear[cells[best]] < LEAST:
                continue
            middle = np.asarray(space.outline).mean(0)
            far = int(np.linalg.norm(places - middle, axis=1).argmax())
            yield RoomPlace(
                space,
                np.array([*places[best], floor.elevation]),
                float(clear[cells[best]]),
                np.array([*places[far], floor.elevation + EYE]),
                np.array([*middle, floor.elevation + 0.6 * EYE]),
            )


def camera_axes(eye: Floats, seen: Floats) -> Floats:
    """The directions right and up of a camera that looks from one point to another, as rows."""
    ahead = seen - eye
    right = np.array([ahead[1], -ahead[0], 0.0])
    right /= np.linalg.norm(right)
    up = np.cross(right, ahead / np.linalg.norm(ahead))
    return np.array([right, up])
