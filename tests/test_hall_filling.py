"""Demands that say how full a hall is to be instead of how many: amounts by floor and wall."""

from __future__ import annotations

import json

import pytest

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains import check, plan_of, solve
from scenewright.domains.hall.demands.checked import floor_needed, sizes_of
from scenewright.domains.hall.zoning.zones import check_halls


def hall(*demands: dict[str, object]) -> Brief:
    """A hall of 12 by 8 m, one zone."""
    room = {
        "id": "hall",
        "outline": [[0, 0], [12, 0], [12, 8], [0, 8]],
        "height": 4,
        "doors": [{"id": "front", "at": [2, 0], "width": 1.8}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "hall", "rooms": [room]})


CASES = {"id": "cases", "category": "showcase", "count": 3}
PICTURES = {"id": "pictures", "category": "wall_exhibit", "count": 2, "place": "wall"}


@pytest.mark.parametrize("share", [0.2, 0.45])
def test_as_many_stand_as_bring_the_floor_in_use_to_the_share(share: float) -> None:
    solution = solve(hall({**CASES, "fill": share}), steps=3000, threads=1)
    (demand,) = solution.brief.rooms[0].demands
    one = floor_needed(demand) / len(sizes_of(demand))
    held = [piece for piece in solution.pieces if piece.category == "showcase"]
    assert abs(len(held) * one - share * 96.0) <= one
    assert (demand.count, demand.fill, demand.most) == (len(held), None, None)
    assert not solution.left_out
    assert not check(solution).findings


def test_two_that_fill_share_the_floor_and_walls_end_what_hangs() -> None:
    solution = solve(hall({**CASES, "fill": 0.5}, {**PICTURES, "fill": 0.5}), steps=3000, threads=1)
    cases, pictures = solution.brief.rooms[0].demands
    assert cases.count
    assert pictures.count
    needs = [floor_needed(demand) for demand in (cases, pictures)]
    assert sum(needs) <= 0.5 * 96.0
    assert min(needs) > 0.3 * sum(needs)


def test_a_demand_that_states_its_number_keeps_it() -> None:
    brief = hall(CASES)
    solution = solve(brief, steps=500, threads=1)
    assert solution.brief == brief
    assert "fill" not in json.dumps(brief.model_dump(mode="json"))


def test_above_the_least_nothing_is_missing() -> None:
    solution = solve(hall({**CASES, "most": 60}), steps=1000, threads=1)
    held = sum(piece.category == "showcase" for piece in solution.pieces)
    assert 3 < held < 60
    assert not solution.left_out


@pytest.mark.parametrize(
    ("keys", "told"),
    [
        ({"most": 2}, "most is 2, but count 3"),
        ({"count": None, "length": 6, "most": 9}, "both length and most"),
        ({"count": None, "sizes": [[1, 1, 1]], "fill": 0.4}, "both sizes and fill"),
    ],
)
def test_what_contradicts_itself_is_refused(keys: dict[str, object], told: str) -> None:
    brief = hall({**CASES, **keys})
    with pytest.raises(InputError, match=told):
        check_halls(brief, plan_of(brief))


@pytest.mark.parametrize(("called", "hung"), [("old paintings", True), ("finds", False)])
def test_what_is_called_a_painting_hangs_on_its_wall(called: str, hung: bool) -> None:
    solution = solve(hall({**PICTURES, "name": called, "id": "w"}), steps=500, threads=1)
    models = {piece.asset for piece in solution.pieces if piece.category == "wall_exhibit"}
    assert len(models) == 2
    assert all(("painting" in model) is hung for model in models)
