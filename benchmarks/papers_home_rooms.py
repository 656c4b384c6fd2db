"""The rooms of the paper's experiments (Liu et al. 2017, 4.3 to 4.5), drawn anew.

Their figures are not to scale, so outlines are ours after what the text says: living rooms of some
32 m² with three patches, one with an acute corner and one with a curved wall; bedrooms of some
12 m²; doors and main walls are as plain as can be.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import shapely

from benchmarks.home_rooms import Case
from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.domains.home.build_problem import build_problem
from scenewright.domains.home.furnishing.pieces import parts_of, posed_pieces
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.paper_problem import as_in_paper
from scenewright.domains.home.presets import PAPER
from scenewright.domains.home.programme import Wish

Points = tuple[tuple[float, float], ...]
ROUTE = 0.6
LIVING, BEDROOM = ("seating", "media", "dining"), ("sleeping", "wardrobe", "desk")


class Drawn(NamedTuple):
    """A room of the experiments: outline, middles of its doors, the patches it is to hold."""

    name: str
    outline: Points
    doors: Points
    groups: tuple[str, ...]


def _bow(width: float, depth: float, bulge: float, parts: int = 8) -> Points:
    """A rectangle whose far wall is an arc, as a polyline."""
    arc = tuple(
        (width * (1 - k / parts), depth + bulge * math.sin(math.pi * k / parts))
        for k in range(parts + 1)
    )
    return ((0.0, 0.0), (width, 0.0), *arc)


ROOMS = (
    Drawn("living 1", ((0, 0), (6.4, 0), (6.4, 5), (0, 5)), ((0.8, 0), (5.6, 5)), LIVING),
    Drawn(
        "living 2, L",
        ((0, 0), (7, 0), (7, 4), (4, 4), (4, 6), (0, 6)),
        ((0.8, 0), (7, 3.2)),
        LIVING,
    ),
    Drawn("living 3, acute", ((0, 0), (8.4, 0), (5.2, 5), (0, 5)), ((0.8, 0), (0, 4.2)), LIVING),
    Drawn("living 4, curved", _bow(6.4, 4.4, 0.9), ((0.8, 0), (6.4, 0.8)), LIVING),
    Drawn("bedroom 1", ((0, 0), (4, 0), (4, 3), (0, 3)), ((0.7, 0),), BEDROOM),
    Drawn("bedroom 2", ((0, 0), (3.4, 0), (3.4, 3.6), (0, 3.6)), ((2.7, 0),), BEDROOM),
    Drawn(
        "bedroom 3, L",
        ((0, 0), (4.4, 0), (4.4, 2.4), (3, 2.4), (3, 3.6), (0, 3.6)),
        ((3.8, 0),),
        BEDROOM,
    ),
    Drawn("bedroom 4", ((0, 0), (4.2, 0), (4.2, 2.9), (0, 2.9)), ((0.7, 0), (4.2, 2.3)), BEDROOM),
)
BOXED = ", three boxes a door"
"""What is added to the name of a room whose doors ask for what ours do: the sweep of the leaf and
the floor on both sides, boxes that overlap, in place of the one area of C3."""
FOUR = ROOMS[0]._replace(name="living 1, four patches", groups=(*LIVING, "desk"))
"""The same room with a study area besides (4.4)."""


def case_of(room: Drawn) -> Case:
    """The room as the paper's problem, and as single pieces; with the doors that its name says."""
    doors = [{"at": at, "width": 0.8, "swing": "in", "hinge": "left"} for at in room.doors]
    stated = {"id": "r", "function": "living", "outline": room.outline, "doors": doors}
    (space,) = spaces(Brief.model_validate({"rooms": [stated]}))
    area = float(shapely.Polygon(space.outline).area)
    ground, wishes = ground_of(space, (), area), tuple(Wish(group, 0) for group in room.groups)
    problem = build_problem(ground, wishes, PAPER, True, ROUTE, area)
    parts = tuple(parts_of(wish, area, shipped()) for wish in wishes)
    pieces = posed_pieces(ground, parts, shipped(), PAPER, True, ROUTE)
    posed = as_in_paper(problem, wishes, space)
    if room.name.endswith(BOXED):
        posed = posed._replace(ground=posed.ground._replace(keep_free=ground.keep_free))
    return Case(room.name, posed, pieces, parts)
