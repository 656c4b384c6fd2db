"""A planned extension as values: sources, areas with their ground and streets, what stays."""

from __future__ import annotations

from typing import NamedTuple

import shapely

from scenewright.core.footprint import Footprint
from scenewright.core.space import Points
from scenewright.domains.extend.brief import GrowthArea
from scenewright.domains.extend.pattern import SourcePattern
from scenewright.ground.buildings.built import BuiltRoad, BuiltScene
from scenewright.ground.plan import SitePlan

OLD = "source"
"""The id of the space of all that stood before."""


class StandingLock(NamedTuple):
    """A building of an area that stays: its kind, footprint ``outline`` (n, 2), box
    (x, y, heading, width, depth), height, model, and footprint in the frame of the box."""

    id: str
    kind: str
    model: str
    outline: Points
    box: tuple[float, float, float, float, float]
    height: float
    local: Footprint


class AreaPlan(NamedTuple):
    """A valid area: its whole ``outline``, what of it may be built on (``floor``), its streets,
    those of them that continue streets of the sources, what stays, and the brief's row."""

    id: str
    name: str
    outline: shapely.Polygon
    floor: shapely.Polygon
    roads: tuple[BuiltRoad, ...]
    continued: tuple[BuiltRoad, ...]
    fixed: tuple[StandingLock, ...]
    row: GrowthArea


class ExtendPlan(NamedTuple):
    """A valid extension: sources with the shares they are followed in and whether they stand, the
    pattern learned of them, areas, all ground as one for streets and pictures, and what was left
    out of the sources."""

    sources: tuple[BuiltScene, ...]
    shares: tuple[float, ...]
    stands: tuple[bool, ...]
    pattern: SourcePattern
    areas: tuple[AreaPlan, ...]
    ground: SitePlan
    left_out: tuple[str, ...]
