"""A picture of open ground with buildings as one sees it standing in a street, at eye height.

Verticals stay upright, as on an architect's photograph: the camera looks level, and what it sees
of the ground below is cut off. The sun stands in the south half, where it lights what is seen.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog, Material
from scenewright.core.scene import Scene
from scenewright.ground.plan import SitePlan
from scenewright.render.picture import Air, Pixels, render
from scenewright.render.stage import blocks_of, stage_of
from scenewright.render.street_spot import HORIZON, TALL, camera_of, standpoint

WIDTH = 1280
AIR = Air((0.72, 0.80, 0.88), (0.22, 0.41, 0.72), 1400.0)
MEADOW = Material("meadow", (0.47, 0.54, 0.36), roughness=1.0)
"""The ground beyond what is drawn."""
HIGH, ASIDE = float(np.deg2rad(40.0)), float(np.deg2rad(55.0))
"""Height of the sun, and how far to the side of the camera's back it would stand best."""
REACH, SHADOW = 14.0, 150.0
"""How far away, in metres, things darken each other; how far around the site shadows are drawn."""


def render_street(
    scene: Scene, plans: Sequence[SitePlan], catalog: Catalog, width: int = WIDTH
) -> Pixels:
    """The street from its best spot as pixels ``(height, width, 3)``; ``plans`` are the grounds
    with their ways."""
    blocks = blocks_of(scene, catalog)
    bounds = np.vstack([block.vertices for block in blocks])
    ground = scene.terrain.deck if scene.terrain else None
    spot = standpoint(plans, scene.pieces, blocks, catalog, ground)
    stage = stage_of(blocks, bounds, MEADOW, SHADOW)._replace(reach=REACH, air=AIR)
    height = round(TALL * width)
    whole = round(2 * HORIZON * height)
    return render(stage, camera_of(spot), width, whole, sun_for(spot.way))[:height]


def sun_for(way: NDArray[np.float64]) -> tuple[float, float, float]:
    """The direction to the sun for a view along ``way`` (2,): behind the camera, to one side,
    never in the north.

    >>> sun_for(np.array([0.0, 1.0]))[1] < 0
    True
    """
    back = np.arctan2(-way[1], -way[0])
    wished = np.array([back + ASIDE, back - ASIDE])
    south = -np.pi / 2
    off = (wished - south + np.pi) % (2 * np.pi) - np.pi
    turn = south + float(np.clip(off[np.argmin(np.abs(off))], -np.pi / 2, np.pi / 2))
    return (
        float(np.cos(HIGH) * np.cos(turn)),
        float(np.cos(HIGH) * np.sin(turn)),
        float(np.sin(HIGH)),
    )
