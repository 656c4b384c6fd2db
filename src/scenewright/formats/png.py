"""A picture of the whole scene from above at an angle: soft light, no screen needed.

Levels of a home stand side by side. Walls are cut just below the heads of doors and windows, and
lower still before a room, so that every room shows. Homes and halls are seen from the side that
fills the picture best and shows fronts (:mod:`scenewright.render.viewing_side`). Sites are seen as
a bird does.
"""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.atomic_file import atomic_write
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution
from scenewright.render.picture import PAGE, REACH, Camera, Pixels, RenderStage, render, view_of
from scenewright.render.stage import SHADOW, blocks_of, stage_of
from scenewright.render.viewing_side import choose_turn

WIDTH, TALLEST = 1440, 1026
INSIDE, OUTSIDE = float(np.deg2rad(17.0)), float(np.deg2rad(26.0))
"""Width of the view, radians: narrow indoors, where walls at its sides would hide what is behind
them."""
Direction = tuple[float, float, float]


class Look(NamedTuple):
    """How a kind of scene is shown: direction of view and to the sun, height in metres above each
    floor at which walls are cut, how far things darken each other, in metres, and the width of
    the view."""

    towards: Direction
    sun: Direction
    cut: float | None
    reach: float
    shadow: float
    angle: float


INDOORS = Look((0.05, 0.42, -1.0), (-0.30, -0.16, 1.0), 2.0, REACH, SHADOW, INSIDE)
"""Mostly down, a little to the north and east."""
OUTDOORS = Look((0.22, 0.80, -0.86), (-0.62, -0.48, 0.80), None, 14.0, 120.0, OUTSIDE)
"""From the south, as a bird sees it, on an afternoon."""
OPEN = frozenset(("site", "village", "extend"))
"""Functions of spaces that are open ground."""
MARGIN = 1.03
NARROWEST = 0.36
"""A picture is as narrow as this share of its usual width at most, for homes that are tall."""

Floats = NDArray[np.float64]


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the picture of a solution to ``path``; the file appears whole or not at all."""
    from PIL import Image

    from scenewright.catalog.loading import catalog_of
    from scenewright.domains import scene_of

    pixels = picture(scene_of(solution, plan), catalog_of(solution.brief.catalogs))
    with atomic_write(path) as partial:
        Image.fromarray(pixels).save(partial, format="png", compress_level=3)


def picture(scene: Scene, catalog: Catalog, width: int = WIDTH) -> Pixels:
    """The scene as pixels ``(height, width, 3)``; the height follows the scene's shape, and where
    the scene is taller than pictures may be, the width does."""
    look = OUTDOORS if any(OPEN & set(space.functions) for space in scene.spaces) else INDOORS
    stage, camera, shape = _stage_scene(scene, catalog, look)
    tallest = TALLEST * width // WIDTH
    width = min(width, round(tallest / shape))
    height = int(np.clip(round(width * shape), width // 3, tallest))
    return render(stage, camera, width, height, look.sun)


def _stage_scene(scene: Scene, catalog: Catalog, look: Look) -> tuple[RenderStage, Camera, float]:
    """The triangles, and a camera that sees them with the shape of its picture."""
    turn = choose_turn(scene, look.towards, TALLEST / WIDTH) if look.cut is not None else 0.0
    blocks = blocks_of(scene, catalog, look.cut, look.towards, turn)
    corners = [block.vertices for block in blocks] or [np.zeros((1, 3))]
    bounds = np.vstack(corners)
    camera, shape = frame_points(bounds, look.towards, look.angle)
    stage = stage_of(blocks, bounds, PAGE, look.shadow)
    return stage._replace(reach=look.reach), camera, shape


def frame_points(
    points: Floats, towards: Direction = INDOORS.towards, wide: float = INSIDE
) -> tuple[Camera, float]:
    """A camera that sees all points with a margin, and height by width of the picture.

    ``points`` (n, 3) in metres; ``wide`` is the width of the view, radians, of a picture of the
    usual shape.
    """
    ahead = np.array(towards) / np.linalg.norm(towards)
    target = (points.min(0) + points.max(0)) / 2
    away, shape, half, across = 10.0, 0.7, 1.0, 1.0
    for _ in range(16):
        view = view_of(Camera(tuple(target - ahead), tuple(target), wide), 1, 1)
        local = (points - target) @ view.axes.T.astype(float)
        deep = local[:, 2] + away
        x, y = local[:, 0] / deep, local[:, 1] / deep
        middle = np.array([x.min() + x.max(), y.min() + y.max()]) / 2 * away
        target = target + middle @ view.axes[:2].astype(float)
        half = max((x.max() - x.min()) / 2, (y.max() - y.min()) / 2 / (TALLEST / WIDTH)) * MARGIN
        across = max((x.max() - x.min()) / 2 * MARGIN, NARROWEST * half)
        shape = (y.max() - y.min() + 2 * (MARGIN - 1) * half) / (2 * across)
        away *= half / view.across
    angle = float(2 * np.arctan(np.tan(wide / 2) * across / half))
    return Camera(tuple(target - away * ahead), tuple(target), angle), float(shape)
