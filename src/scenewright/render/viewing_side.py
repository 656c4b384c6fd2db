"""The side from which a picture from above shows a scene: that from which it fills the picture and
shows fronts instead of backs.

A narrow flat seen along its length fills a third of a picture; a row of wardrobes seen from
behind is a row of boards. Of the four quarter turns the one of least cost is taken: 1 less the
share of the picture that is filled, the share of tall fronts (by metres) that look away from the
eye, and a little for every quarter turn away from the plan, on which north is up. Sides from which
a picture is taller than wide are taken only where all are.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.core.scene import Scene
from scenewright.render.stage import APART

Floats = NDArray[np.float64]

TALL, WIDE = 1.2, 0.6
"""Height and width, metres, from which on a piece seen from behind is a blank board."""
QUARTER = 0.12
"""Cost of a quarter turn; half a turn costs twice that."""
UPRIGHT = 0.95
"""Height by width from which on a scene comes out narrower than high, walls included."""
NARROW = 10.0
"""Cost of a picture twice as high as wide."""


def choose_turn(scene: Scene, towards: tuple[float, float, float], shape: float) -> float:
    """The turn of the scene about z, radians, for an eye that looks ``towards`` a direction, in a
    picture whose largest height by width is ``shape``."""
    turns = np.array([0.0, 0.5, -0.5, 1.0]) * np.pi
    unlike = QUARTER * np.array([0.0, 1.0, 1.0, 2.0])
    tall = np.array([_shape_of(scene, turn, towards) for turn in turns])
    fills = np.minimum(1.0, np.minimum(shape / tall, tall / shape))
    backs = np.array([_share_of_backs(scene, turn, towards) for turn in turns])
    narrow = NARROW * np.maximum(tall - UPRIGHT, 0.0)
    return float(turns[np.argmin(1.0 - fills + backs + unlike + narrow)])


def _shape_of(scene: Scene, turn: float, towards: tuple[float, float, float]) -> float:
    """Height by width of the boxes of the levels, side by side, as seen."""
    levels = [
        np.vstack([space.outline for space in scene.spaces if space.level == level.id])
        for level in scene.levels
        if any(space.level == level.id for space in scene.spaces)
    ]
    if not levels:
        return UPRIGHT
    extents = np.array([np.ptp(_turned(points, turn), axis=0) for points in levels])
    wide = float(extents[:, 0].sum()) + APART * (len(levels) - 1)
    deep = float(extents[:, 1].max()) * -towards[2] / float(np.linalg.norm(towards))
    return deep / wide


def _turned(points: Floats, turn: float) -> Floats:
    cos, sin = np.cos(turn), np.sin(turn)
    return np.asarray(points, np.float64) @ np.array([[cos, sin], [-sin, cos]])


def _share_of_backs(scene: Scene, turn: float, towards: tuple[float, float, float]) -> float:
    """Of the metres of tall fronts, what looks away from the eye; sideways counts nothing."""
    tall = [p for p in scene.pieces if p.size.height >= TALL and p.size.width >= WIDE]
    if not tall:
        return 0.0
    width = np.array([p.size.width for p in tall])
    heading = np.array([p.pose.heading for p in tall]) + turn
    away = np.cos(heading - np.arctan2(towards[1], towards[0]))
    return float((width * np.maximum(away, 0.0)).sum() / width.sum())
