"""What no way leads to is tried elsewhere before it is left out; what a tour stops at."""

from __future__ import annotations

from typing import Any

import pytest

import scenewright
from scenewright.core.brief import Brief
from thoroughness import only_thorough


def _solve(room: dict[str, Any], seed: int) -> Any:
    brief = Brief.model_validate({"domain": "hall", "rooms": [{"name": "Hall", **room}]})
    return scenewright.solve(brief, seed=seed, threads=1)


CAFE: dict[str, Any] = {
    "outline": [[0, 0], [11, 0], [11, 5], [7, 8], [0, 8]],
    "doors": [{"at": [5.5, 0], "width": 1.2}, {"at": [0, 7], "width": 0.9, "use": "exit"}],
    "demands": [
        {"category": "counter", "count": 2, "place": "wall"},
        {"category": "round_table", "count": 5},
        {"category": "dining_table", "count": 4},
        {"category": "dining_chair", "count": 24},
        {"category": "lounge_seat", "count": 6},
        {"category": "fridge", "place": "wall"},
    ],
}


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=only_thorough)])
def test_a_crowded_cafe_gives_up_a_few_tables_only(seed: int) -> None:
    found = _solve(CAFE, seed)
    count = {
        kind: sum(piece.category == kind for piece in found.pieces)
        for kind in ("counter", "fridge", "round_table", "dining_table", "dining_chair")
    }
    assert scenewright.check(found).valid
    assert count["counter"] == 2
    assert count["fridge"] == 1
    assert count["round_table"] + count["dining_table"] >= 4
    assert count["dining_chair"] >= 14
    assert all("of 24 " in row.what for row in found.left_out if "chair" in row.what)


def test_a_shop_with_a_passage_too_narrow_is_laid_out_anew() -> None:
    room = {
        "outline": [[0, 0], [12, 0], [12, 8], [0, 8]],
        "id": "s",
        "name": "Shop",
        "doors": [{"id": "d", "at": [2, 0], "width": 1.4}],
        "zones": [
            {"id": "sales"},
            {"id": "desk", "area": 15, "door": "d"},
            {"id": "fitting", "area": 12},
        ],
        "links": [{"between": ["desk", "sales"], "width": 1.5}, {"between": ["sales", "fitting"]}],
        "demands": [
            {"category": "checkout", "zone": "desk"},
            {"category": "gondola", "length": 14, "zone": "sales"},
            {"id": "wall", "category": "wall_shelving", "length": 12, "zone": "sales"},
            {"category": "clothes_rail", "count": 4, "zone": "sales"},
            {"category": "fitting_room", "count": 3, "zone": "fitting"},
        ],
    }
    found = _solve(room, 0)
    assert scenewright.check(found).valid
    assert not found.left_out


LIBRARY: dict[str, Any] = {
    "name": "School library",
    "outline": [[0, 0], [15, 0], [15, 9], [0, 9]],
    "doors": [
        {"id": "corridor", "at": [2, 0], "width": 1.2},
        {"id": "yard", "at": [15, 7.5], "width": 1.0, "swing": "out", "use": "exit"},
    ],
    "zones": [
        {"id": "desk", "door": "corridor", "area": 18},
        {"id": "work"},
        {"id": "corner", "area": 30},
    ],
    "demands": [
        {"category": "desk", "zone": "desk"},
        {"category": "reading_table", "count": 6, "zone": "work"},
        {"category": "bookcase", "count": 18, "zone": ["work", "corner"]},
        {"category": "book_stack", "count": 8, "zone": "work"},
        {"category": "pouf", "count": 8, "zone": "corner"},
        {"category": "lounge_seat", "count": 4, "zone": "corner"},
        {"category": "catalogue_terminal", "count": 2, "zone": "desk"},
    ],
}


@pytest.mark.parametrize("seed", [1, pytest.param(5, marks=only_thorough)])
def test_a_library_too_full_gives_up_what_no_way_reaches(seed: int) -> None:
    """However many first places find no room for what is left, some of it goes until one does."""
    found = _solve(LIBRARY, seed)
    assert scenewright.check(found).valid
    assert all(row.required for row in found.left_out)
    assert sum(piece.category == "reading_table" for piece in found.pieces) >= 4
    assert sum(piece.category == "bookcase" for piece in found.pieces) >= 10


def test_a_tour_stops_at_no_plants_or_bins() -> None:
    room = {
        "outline": [[0, 0], [12, 0], [12, 8], [0, 8]],
        "doors": [{"at": [2, 0], "width": 1.4}],
        "demands": [
            {"category": "showcase", "count": 3},
            {"category": "potted_tree", "count": 2},
            {"category": "litter_bin"},
        ],
    }
    found = _solve(room, 0)
    demand = {group.id: group.demand for group in found.detail.layout.groups}
    stops = {demand[stop.group] for stop in found.detail.tours[0].stops}
    assert set(demand.values()) >= {"potted_tree", "litter_bin"}
    assert stops == {"showcase"}
