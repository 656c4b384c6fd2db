"""A ticket hall with an arched wall: counters, walls and barriers are at it or end before it."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright
from hall_chains import posed, two_zones
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.solution import Solution
from scenewright.domains.hall.walls.curved import WallNeed, space_places
from scenewright.domains.hall.zoning.borders import WallStretch

ARCH = [[32, 14], [29.5, 16.2], [26.6, 17.9], [23.2, 19.1], [19.6, 19.8], [16, 20], [12.4, 19.8]]
OUTLINE = [[0, 0], [32, 0], *ARCH, [8.8, 19.1], [5.4, 17.9], [2.5, 16.2], [0, 14]]
ROOM: dict[str, Any] = {
    "name": "Ticket hall",
    "outline": OUTLINE,
    "height": 5,
    "doors": [
        {"id": "square", "at": [16, 0], "width": 4.0, "swing": "slide", "use": "entrance"},
        {"id": "platforms", "at": [32, 7], "width": 4.0, "swing": "none"},
        {"id": "buses", "at": [0, 7], "width": 2.4, "swing": "slide"},
    ],
    "zones": [
        {"id": "tickets", "area": 190},
        {"id": "waiting", "area": 120},
        {"id": "gates", "door": "platforms", "area": 90},
        {"id": "middle", "door": "square"},
    ],
    "demands": [
        {
            "category": "counter",
            "count": 6,
            "size": [1.6, 0.9, 1.1],
            "zone": "tickets",
            "place": "wall",
        },
        {"category": "rope_barrier", "count": 8, "zone": "tickets"},
        {"category": "ticket_machine", "count": 8, "zone": ["tickets", "middle"]},
        {"category": "ticket_gate", "count": 5, "zone": "gates"},
        {"category": "bench", "count": 8, "size": [1.8, 0.6, 0.45], "zone": "waiting"},
        {"category": "lockers", "count": 10, "zone": "waiting"},
        {"category": "vending_machine", "count": 3, "zone": "waiting"},
    ],
}


@cache
def solve(seed: int) -> Solution:
    brief = Brief.model_validate({"domain": "hall", "rooms": [ROOM]})
    return scenewright.solve(brief, seed=seed, threads=1)


@pytest.mark.parametrize("seed", [3, 7])
def test_all_stands_in_it_and_nothing_is_left_out(seed: int) -> None:
    """The counters stand along two walls: ropes find their place before one of the rows."""
    found = solve(seed)
    assert scenewright.check(found).valid
    assert not found.left_out


@pytest.mark.parametrize("seed", [3, 7])
def test_walls_and_barriers_end_before_the_arch(seed: int) -> None:
    built = [p for p in solve(seed).pieces if p.category in ("partition", "glass_barrier")]
    assert built
    beyond = shapely.difference(polygons_of(built), shapely.Polygon(OUTLINE))
    assert shapely.area(beyond).max() < 1e-6


def test_no_wall_is_built_round_a_zone_with_gates() -> None:
    shelves = {"category": "wall_shelving", "count": 60, "zone": "east"}
    gates = {"category": "ticket_gate", "count": 2, "zone": "east"}
    assert posed(two_zones(shelves)).fitted.hosts
    assert not posed(two_zones(shelves, gates)).fitted.hosts


def test_what_is_wide_stands_on_straight_pieces_of_an_arch() -> None:
    ends = np.array([[32, 14], *ARCH[1:]], float)
    walls = [WallStretch(*map(float, (*a, *b))) for a, b in pairwise(ends)]
    narrow = space_places(walls, WallNeed(1.6, 1.8, 6, False))
    wide = space_places(walls, WallNeed(9.6, 1.8, 1, False))
    assert len(narrow) > 6
    assert wide == walls
