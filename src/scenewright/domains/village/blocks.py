"""Blocks of a village as values: their houses, which sides are streets, the lanes beside."""

from __future__ import annotations

from typing import NamedTuple

import shapely

from scenewright.core.footprint import Footprint
from scenewright.core.space import Points
from scenewright.domains.village.house import House
from scenewright.domains.village.learned.style import VillageStyle
from scenewright.domains.village.paper.nets_file import PaperNets
from scenewright.ground.plan import SitePlan, Way


class StandingHouse(NamedTuple):
    """A house that stays: its id, name in the library, the asset that draws it, its footprint
    ``outline`` (n, 2) in the plan, box (x, y, heading, width, depth), height, and footprint in the
    frame of the box (empty: the box)."""

    id: str
    house: str
    asset: str
    outline: Points
    box: tuple[float, float, float, float, float]
    height: float
    local: Footprint


class BlockPlan(NamedTuple):
    """A valid block: its ``outline`` (n, 2) counter-clockwise, square metres, street sides
    (s, 2, 2), the share of its outline that is street, houses that stay, and ``ground``: the same
    with the lanes beside it, the verge included, as walks and pictures of streets take it.
    ``lanes`` is the ground of the block that lanes, drives and footways of the brief cover."""

    id: str
    name: str
    outline: Points
    area: float
    streets: Points
    street_share: float
    fixed: tuple[StandingHouse, ...]
    ground: SitePlan
    lanes: shapely.Geometry = shapely.Polygon()


class VillagePlan(NamedTuple):
    """A valid village: its blocks, all lanes, the houses to choose from, the ``look`` of those that
    are built here, the style they stand in, and the networks that the paper's solver asks (None:
    those that ship)."""

    blocks: tuple[BlockPlan, ...]
    lanes: tuple[Way, ...]
    houses: tuple[House, ...]
    look: str
    style: VillageStyle
    nets: PaperNets | None = None
