"""A room for sleeping ends with a bed wherever one stands, whatever else has to give way."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.attempts.bed_first import list_beds_first
from scenewright.domains.home.composing.places.wall_ends import list_wall_ends
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.grounds.wall_places import free_boxes
from scenewright.domains.home.groups.least import LEAST
from scenewright.domains.home.measures import NARROWER
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import PRESETS, prepare_rooms, solve

BED, WARDROBE = Wish("single", 0, core=True), Wish("wardrobe", 0)
SMALL = (2.34, 2.0, ((1.37, 2.0, 0.95), (2.34, 1.18, 1.1), (1.62, 0.0, 0.95)))
"""Beside the doors of three sides a bed of 1.9 m stands along the wall without."""
BETWEEN = (1.99, 2.92, ((1.99, 1.46, 1.4), (0.68, 2.92, 1.33), (1.05, 0.0, 1.15)))
"""1.92 m of a wall are free between the floor before two doors."""


def _brief(room: tuple, function: str = "bedroom") -> Brief:
    """A rectangle with sliding doors, each x, y, width."""
    width, depth, doors = room
    return Brief.model_validate(
        {
            "rooms": [
                {
                    "id": "r",
                    "function": function,
                    "outline": [(0, 0), (width, 0), (width, depth), (0, depth)],
                    "doors": [{"at": (x, y), "width": w, "swing": "slide"} for x, y, w in doors],
                }
            ]
        }
    )


def _task(room: tuple) -> RoomTask:
    brief, preset = _brief(room), PRESETS["default"]
    return prepare_rooms(brief, spaces(brief), shipped(), preset, preset.solver, 0)[0][0]


def _lacking(*wishes: Wish) -> RoomAnswer:
    missing = tuple(Missing(wish, "") for wish in wishes)
    return RoomAnswer(0.0, (), missing, (), None, 0.0, 0)


def test_bedroom_with_one_place_for_a_bed_has_it_and_tells_of_the_rest() -> None:
    home = solve(_brief(SMALL), seed=0, threads=1)
    assert any(p.category == "single_bed" for p in home.pieces)
    assert "single" not in {out.what for out in home.left_out}
    assert not check(home).findings


def test_bed_comes_before_the_wardrobe_and_leaves_the_ways_open() -> None:
    task, wishes = _task(SMALL), (BED, WARDROBE)
    found = list(list_beds_first(task, wishes, _lacking(*wishes)))
    assert found
    narrow = task._replace(
        route_width=task.route_width - NARROWER, use_width=task.use_width - NARROWER
    )
    for answer in found:
        assert [p.wish.group for p in answer.placed] == ["single"]
        assert [m.wish.group for m in answer.missing] == ["wardrobe"]
        assert not find_blocked(narrow, answer.placed)


@pytest.mark.parametrize("lacks", [(), (WARDROBE,), (BED, Wish("kitchen", 0, core=True))])
def test_no_bed_goes_first_where_none_or_a_kitchen_as_well_is_lacking(lacks) -> None:
    assert not list(list_beds_first(_task(SMALL), (BED, WARDROBE), _lacking(*lacks)))


def test_ends_of_a_stretch_hold_what_lies_between_two_steps() -> None:
    task, bed = _task(BETWEEN), list(LEAST["single"]())[-1]
    assert bed.width == 1.9
    standing = standing_of((), flat_kinds(task.catalog))
    ends = list_wall_ends(task, bed, standing)
    usual = free_boxes(bed, task.ground, standing, task.catalog, 2.5, 0.1, True)
    assert len(ends) == 2
    assert not len(usual)
    left = ends[np.abs(ends[:, 0] - 0.405) < 0.01]
    assert np.ptp(left[:, 1]) == pytest.approx(0.018, abs=0.003)
