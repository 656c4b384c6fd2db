"""Bare halves of living rooms get a second zone; screens hang where no stand has a place."""

from __future__ import annotations

from itertools import combinations
from math import hypot, pi

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import Group
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.composing.filling.bare_floor import PAIRS_APART, list_other
from scenewright.domains.home.composing.placed_faults import cost_of_group
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.furnishing.obstacles import standing_of
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.grounds.wall_places import free_boxes, stand_free
from scenewright.domains.home.groups.living import hung_screens, talking
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import solve

LONG = {
    "id": "living",
    "function": "living",
    "outline": [[0, 0], [9.2, 0], [9.2, 3.5], [0, 3.5]],
    "doors": [{"at": [5.4, 3.5], "width": 0.9}, {"at": [7.0, 0.0], "width": 2.4, "swing": "slide"}],
    "windows": [{"at": [9.2, 1.7], "width": 1.4}, {"at": [2.4, 0.0], "width": 2.0}],
}


def test_no_half_of_a_long_living_room_is_bare() -> None:
    brief = Brief(rooms=[Room.model_validate(LONG)])
    home = solve(brief, seed=0)
    low = tuple(p for p in home.pieces if p.pose.z < 0.05 and p.category != "rug")
    free = shapely.Polygon(LONG["outline"]).difference(shapely.union_all(polygons_of(low)))
    assert shapely.maximum_inscribed_circle(free, tolerance=0.02).length < 1.35
    assert check(home, spaces=spaces(brief)).valid


@pytest.mark.parametrize("case", list(hung_screens()), ids=lambda case: case.name)
def test_a_screen_hangs_before_no_window_and_no_door(case) -> None:
    space = spaces(Brief(rooms=[Room.model_validate(LONG)]))[0]
    ground = ground_of(space, (), 30.0)
    empty = standing_of((), frozenset())
    boxes = free_boxes(case, ground, empty, shipped(), 2.6, 0.1, whole=True)
    hung = shapely.polygons(corners(boxes))
    for zone in (*ground.windows[:, :5], *ground.keep_free):
        assert not (shapely.area(shapely.intersection(hung, _outline(zone))) > 0.01).any()
    assert len(boxes) > 10
    assert stand_free(boxes, case, (), ground, empty, shipped(), 2.6).all()
    boxes[:, 0] += 20.0
    assert not stand_free(boxes, case, (), ground, empty, shipped(), 2.6).any()


def _outline(box) -> shapely.Polygon:
    return shapely.Polygon(corners(box[None])[0])


def test_an_armchair_at_a_door_is_a_fault_and_one_a_step_aside_is_none() -> None:
    ground = ground_of(spaces(Brief(rooms=[Room.model_validate(LONG)]))[0], (), 30.0)
    rule, case = PRESETS["default"].settings.composing, Group("reading", "", 0.8, 0.8, ())

    def cost(x: float) -> float:
        chair = Piece("a", "armchair", "", "r", Pose(x, 3.1, 0.0, -pi / 2), Size(0.78, 0.8, 0.85))
        dressed = FurnishedPatch(case, np.zeros(5), (), 0)
        group = FurnishedGroup(Wish("reading", 2), "reading", dressed, (chair,))
        return cost_of_group(group, ground, rule)

    assert cost(4.4) > cost(3.8) == 0.0


def test_a_pair_of_armchairs_that_stands_is_not_put_a_second_time() -> None:
    one, *others = talking()
    dressed = FurnishedPatch(one, np.zeros(5), (), 0)
    placed = (FurnishedGroup(Wish("reading", 2), "reading", dressed, ()),)
    assert list(list_other(placed, talking())) == others
    assert list(list_other((), talking())) == [one, *others]


def test_two_pairs_of_armchairs_are_no_rows_of_seats() -> None:
    home = sw.solve(sw.read("sample:home-loft"), seed=41)
    lamps = [p.pose for p in home.pieces if p.category == "side_table" and "reading" in p.id]
    away = [hypot(a.x - b.x, a.y - b.y) for a, b in combinations(lamps, 2)]
    assert min(away, default=PAIRS_APART) >= PAIRS_APART - 0.3


def test_a_bare_kitchen_has_a_second_zone() -> None:
    large = {"id": "k", "function": "kitchen", "outline": [[0, 0], [8, 0], [8, 6], [0, 6]]}
    doors = [{"at": [0, 1], "width": 0.9}]
    home = solve(Brief(rooms=[Room.model_validate(large | {"doors": doors})]), seed=0)
    assert sum(p.category == "armchair" for p in home.pieces) >= 2
