"""A room for cooking ends with sink and hob wherever a mini kitchen stands."""

from __future__ import annotations

import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.attempts.bed_first import with_narrow_ways
from scenewright.domains.home.attempts.kitchen_first import list_kitchens_first
from scenewright.domains.home.groups.mini_kitchens import WIDTHS, mini_kitchens
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import PRESETS, prepare_rooms, solve

KITCHEN, SHOES = Wish("kitchen", 0, core=True), Wish("shoes", 1)
CORRIDOR = ((1.64, 0.75), (2.5, 0.75), (2.5, 1.65), (0, 1.65), (0, 0.75), (0.6, 0.75))
DOORS = (((0, 1.2), 0.75), ((2.5, 1.2), 0.75), ((1.1, 1.65), 1.2))


def _brief(niche: float = 1.04, functions: tuple[str, ...] = ("kitchen", "hall")) -> Brief:
    """A corridor with doors at its ends and along it, and a niche across from these."""
    outline = ((0.6, 0), (0.6 + niche, 0), (0.6 + niche, 0.75), *CORRIDOR[1:])
    doors = [{"at": at, "width": width, "swing": "slide"} for at, width in DOORS]
    room = {"id": "r", "function": list(functions), "outline": outline, "doors": doors}
    return Brief.model_validate({"rooms": [room]})


def _task(brief: Brief) -> RoomTask:
    preset = PRESETS["default"]
    return prepare_rooms(brief, spaces(brief), shipped(), preset, preset.solver, 0)[0][0]


def _lacking(*wishes: Wish) -> RoomAnswer:
    return RoomAnswer(0.0, (), tuple(Missing(w, "") for w in wishes), (), None, 0.0, 0)


def test_niche_of_a_hall_that_is_cooked_in_holds_its_kitchen() -> None:
    home = solve(_brief(), seed=0, threads=1)
    held = {p.category for p in home.pieces}
    assert {"sink_cabinet", "hob_cabinet"} <= held
    assert "fridge" in held or "fridge" in {out.what for out in home.left_out if out.required}
    assert not check(home).findings


def test_kitchen_comes_before_the_shoes_and_leaves_the_ways_open() -> None:
    task, wishes = _task(_brief()), (KITCHEN, SHOES)
    found = list(list_kitchens_first(task, wishes, _lacking(*wishes)))
    assert found
    for answer in found:
        assert [p.wish.group for p in answer.placed] == ["kitchenette"]
        assert [m.wish.group for m in answer.missing] == ["shoes", "fridge"]
        assert not find_blocked(with_narrow_ways(task), answer.placed)
    widths = [answer.placed[0].dressed.case.width for answer in found]
    assert widths[0] == 1.0
    assert widths == sorted(widths, reverse=True)


def test_niche_as_wide_as_a_low_fridge_besides_has_one() -> None:
    wishes = (KITCHEN,)
    found = next(list_kitchens_first(_task(_brief(1.3)), wishes, _lacking(*wishes)))
    assert [p.wish.group for p in found.placed] == ["kitchen"]
    assert not found.missing


@pytest.mark.parametrize(
    "lacks",
    [(), (SHOES,), (KITCHEN._replace(most=(2.0, 0.7)),), (KITCHEN._replace(required=True),)],
)
def test_no_kitchen_goes_first_where_none_or_a_certain_one_is_lacking(lacks) -> None:
    found = list_kitchens_first(_task(_brief()), (KITCHEN, SHOES), _lacking(*lacks))
    assert not list(found)


def test_mini_kitchens_are_whole_and_as_wide_as_they_say() -> None:
    seen = []
    for group in mini_kitchens():
        low = [m for m in group.members if m.z == 0]
        assert sum(m.size.width for m in low) == pytest.approx(group.width)
        assert min(m.size.width for m in low) >= 0.1
        assert {"sink_cabinet", "hob_cabinet"} <= {m.category for m in low}
        assert any(m.category == "fridge" for m in low) == (group.function == "kitchen")
        seen.append((group.width, group.depth))
    assert {wide for wide, _ in seen} == set(WIDTHS)
    assert seen == sorted(seen, reverse=True)
