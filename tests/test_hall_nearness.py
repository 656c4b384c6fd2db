"""What keeps its distance in halls: exhibits from columns, and objects from other groups' seats."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely

import scenewright
from hall_briefs import box
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.solution import Solution
from scenewright.domains.hall import retouch


def laid(seed: int, outline: list[list[float]], **room: Any) -> Solution:
    doors = [{"id": "front", "at": [2, 0], "width": 1.4}]
    whole = {"id": "hall", "outline": outline, "height": 4, "doors": doors} | room
    brief = Brief.model_validate({"domain": "hall", "name": "hall", "rooms": [whole]})
    return scenewright.solve(brief, seed=seed, steps=2000, threads=1)


def measure_gap(solution: Solution, shapes: list[shapely.Polygon], category: str) -> float:
    """Metres between some shapes and the nearest object of a category."""
    mine = polygons_of([piece for piece in solution.pieces if piece.category == category])
    return float(np.min(shapely.distance(np.array(mine)[:, None], np.array(shapes))))


def set_up_cases(seed: int) -> float:
    """How near the showcases of a hall with columns are to one."""
    columns = [
        box(x - 0.25, y - 0.25, x + 0.25, y + 0.25)[::-1] for x in (4, 8, 12) for y in (4, 8)
    ]
    demand = {"category": "showcase", "count": 15, "patterns": ["radiation", "chain"]}
    found = laid(seed, box(0, 0, 16, 12), holes=columns, demands=[demand])
    assert scenewright.check(found).valid
    assert not found.left_out
    return measure_gap(found, [shapely.Polygon(ring) for ring in columns], "showcase")


def set_up_seats(seed: int) -> float:
    """How near panels are to armchairs in a small hall."""
    demands = [
        {"category": "lounge_seat", "count": 4},
        {"category": "exhibit_panel", "count": 2},
        {"category": "desk", "count": 3},
    ]
    found = laid(seed, box(0, 0, 8, 7), demands=demands)
    assert scenewright.check(found).valid
    seats = polygons_of([p for p in found.pieces if p.category == "lounge_seat"])
    return measure_gap(found, list(seats), "exhibit_panel")


@pytest.mark.parametrize(("hall", "seeds"), [(set_up_cases, (0, 13)), (set_up_seats, (12, 13))])
def test_nothing_stands_against_a_column_or_the_seats_of_others(
    hall: Any, seeds: tuple[int, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert min(hall(seed) for seed in seeds) > 0.45
    if hall is set_up_cases:  # rows among columns keep clear of them by themselves
        return
    others = tuple(row for row in retouch.RETOUCHES if row.name != "nearness")
    monkeypatch.setattr(retouch, "RETOUCHES", others)
    assert min(hall(seed) for seed in seeds) < 0.35
