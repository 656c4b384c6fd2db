"""The floor of a hall's energy, and what is left out because nobody could get to it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from scenewright.core.brief import Brief
from scenewright.domains import check
from scenewright.domains.hall.floors import fewest_lines, floors_of
from scenewright.domains.hall.presets import PRESETS, count_steps
from scenewright.domains.hall.solving import solve
from scenewright.formats import read
from scenewright.workflow.documents import explained_document

Told = dict[str, Any]
KIOSK: Told = {
    "id": "kiosk",
    "outline": [[0, 0], [4, 0], [4, 3], [0, 3], [0, 2.1], [-4.1, 2.1], [-4.1, 1.5], [0, 1.5]],
    "doors": [{"id": "way", "at": [4, 1.5], "width": 1.0, "swing": "out"}],
}
"""A shop with an alcove 0.6 m wide, in which nobody reaches a thing."""


def kiosk(*demands: Told, **more: Any) -> Brief:
    room = {**KIOSK, **more, "demands": list(demands)}
    return Brief.model_validate(
        {"format": "scenewright/brief", "version": 1, "domain": "hall", "rooms": [room]}
    )


@pytest.mark.parametrize("preset", ["default", "paper", "paper-repaired", "paper-strict"])
@pytest.mark.parametrize("name", ["shop", "reading-room"])
def test_no_energy_is_below_its_floor(name: str, preset: str) -> None:
    solution = solve(read(f"sample:hall-{name}"), preset=preset, steps=1000)
    (space, energy), *_ = solution.energies.items()
    floor = floors_of(solution)[space]
    assert 0.0 < floor <= energy
    figures = check(solution).figures["halls"][space]
    assert figures["energy"] == pytest.approx(energy, abs=1e-3)
    assert figures["excess"] == pytest.approx(energy - floor, abs=1e-3)
    assert explained_document(solution)["floors"][space] == pytest.approx(floor)


def test_lines_are_as_few_as_a_search_over_all_grids_finds() -> None:
    for count in range(1, 200):
        sides = [a + b for a in range(1, count + 1) for b in range(1, count + 1) if a * b >= count]
        assert fewest_lines(count) == min(sides)


def test_work_grows_with_the_groups_of_a_hall() -> None:
    steps = [count_steps(PRESETS["default"], groups) for groups in range(1, 60)]
    assert (np.diff(steps) >= 0).all()
    assert steps[0] < steps[10] < steps[-1]
    assert {count_steps(PRESETS["paper"], groups) for groups in (1, 20, 60)} == {1000}


def test_what_no_route_reaches_is_left_out_by_name() -> None:
    zones = [
        {"id": "shop", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]]},
        {"id": "alcove", "outline": [[-4.1, 1.5], [-2.1, 1.5], [-2.1, 2.1], [-4.1, 2.1]]},
    ]
    rack = {"id": "rack", "category": "plinth", "size": [0.4, 0.4, 1], "zone": "alcove"}
    desk = {"id": "desk", "category": "plinth", "size": [0.8, 0.6, 1], "zone": "shop"}
    solution = solve(kiosk(rack, desk, zones=zones, links=[]), steps=2000)
    assert [(out.what, "a route 0.90 m wide" in out.reason) for out in solution.left_out] == [
        ("rack", True)
    ]
    assert [piece.function for piece in solution.pieces] == ["desk"]
    assert not [f for f in check(solution).findings if not f.given]


def test_what_is_optional_is_given_up_first() -> None:
    must = {"id": "desk", "category": "counter", "size": [2, 0.8, 1], "clearance": 0.9}
    may = {"id": "seats", "category": "lounge_seat", "count": 9, "required": False}
    solution = solve(kiosk(must, may), steps=2000)
    assert "desk" in {piece.function for piece in solution.pieces}
    assert not [f for f in check(solution).findings if not f.given]
