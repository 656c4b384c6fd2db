"""The problem of filling one block, and its answer."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.brief.uses import UseName, UseWish
from scenewright.core.space import Points
from scenewright.domains.village.house import House
from scenewright.domains.village.learned.style import VillageStyle
from scenewright.domains.village.paper.nets_file import PaperNets
from scenewright.domains.village.settings import VillageSettings
from scenewright.domains.village.standing import Floats, Indices, StandingHouses
from scenewright.engine.solve import Found


class VillageProblem(NamedTuple):
    """One block: its ground, street sides (s, 2, 2), the share of the outline that is street,
    where people may walk, houses that stay, the library, how many houses are asked for
    (``asked``, or the share ``coverage`` of the ground, or neither), shares of classes of area
    (3,; None: as real blocks like it have), settings, the style its houses stand in,
    what is to stay free: squares and lanes; and networks for the paper's solver (None: those that
    ship); ``rim``: the sides (r, 2, 2) of a square that fronts are to stand about; ``uses`` that
    are asked for beyond what stands."""

    name: str
    floor: shapely.Polygon
    streets: Points
    street_share: float
    walkable: shapely.Polygon
    fixed: StandingHouses
    houses: tuple[House, ...]
    asked: int | None
    coverage: float | None
    sizes: tuple[float, float, float] | None
    settings: VillageSettings
    style: VillageStyle
    kept_free: shapely.Geometry
    nets: PaperNets | None = None
    rim: Points = np.zeros((0, 2, 2))
    uses: tuple[tuple[UseName, UseWish], ...] = ()


class VillageLayout(NamedTuple):
    """A filled block: the number of each house in the library (n,), its pose (n, 3) in its own
    frame (x, y, angle), the side of its footprint with the door (n,), how many were ``asked``
    for, and what each measure of the layout says."""

    houses: Indices
    poses: Floats
    doors: Indices
    asked: int
    score: dict[str, float]


VillageFound = Found[VillageLayout]
