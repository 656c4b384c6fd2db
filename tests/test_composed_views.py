"""Sofas look at their screens, doors of wardrobes are free, tables have two chairs."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from math import pi

import numpy as np
import pytest
import shapely

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.attempt import FurnishedGroup, RoomAnswer
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.fronts import measure_share
from scenewright.domains.home.composing.views import leave_out_blind_seats, measure_turn
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.groups.dining import dining_wall, tables_with_stools
from scenewright.domains.home.groups.sleeping import narrow_sides
from scenewright.domains.home.programme import Wish

SOFA = Pose(0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("screen", "off"),
    [
        (Pose(2.5, 0.0, 0.0, pi), 0.0),
        (Pose(2.5, 0.0, 0.0, 0.0), pi),
        (Pose(0.0, 2.5, 0.0, -pi / 2), pi / 2),
        (Pose(2.0, 2.0, 0.0, pi), pi / 4),
    ],
    ids=["opposite", "turned away", "at the side", "aslant"],
)
def test_a_sofa_and_its_screen_are_off_each_other_by_the_larger_angle(screen, off):
    assert measure_turn(SOFA, screen) == pytest.approx(off)
    assert measure_turn(screen, SOFA) == pytest.approx(off)


def piece(category: str, x: float, y: float, width: float, depth: float) -> Piece:
    return Piece(category, category, "", "a", Pose(x, y, 0.0, 0.0), Size(width, depth, 0.8))


def test_what_stands_before_a_wardrobe_counts_by_the_doors_it_shuts():
    wardrobe = piece("wardrobe", 0.0, 0.0, 2.0, 0.6)
    half = piece("chest_of_drawers", 0.525, 0.5, 1.0, 0.45)
    beside = piece("chest_of_drawers", 0.0, 1.6, 1.0, 0.45)
    assert measure_share(wardrobe, [wardrobe, half]) == pytest.approx(0.5)
    assert measure_share(wardrobe, [wardrobe, beside]) == 0.0
    assert measure_share(wardrobe, [piece("office_chair", 0.525, 0.0, 0.6, 0.6)]) == 0.0


def _floor(case: Group, member: Member) -> shapely.Polygon:
    across = abs(member.heading) > 1.0 and abs(member.heading) < 2.0
    w, d = member.size.depth if across else member.size.width, member.size.width
    d = d if across else member.size.depth
    box = shapely.box(member.x - w / 2, member.y - d / 2, member.x + w / 2, member.y + d / 2)
    assert (
        shapely.box(-case.width / 2 - 1e-9, -case.depth / 2 - 1e-9, case.width / 2, case.depth / 2)
        .buffer(1e-6)
        .contains(box)
    )
    return box


@pytest.mark.parametrize("case", list(dining_wall()), ids=lambda case: case.name)
def test_chairs_at_a_wall_table_stand_clear_of_each_other(case):
    chairs = [_floor(case, m) for m in case.members if m.category == "dining_chair"]
    assert all(a.intersection(b).area < 1e-9 for a, b in combinations(chairs, 2))
    assert bool(find_case_faults(case)) == (len(chairs) < 2)


@pytest.mark.parametrize("case", list(tables_with_stools()), ids=lambda case: case.name)
def test_two_stools_are_pushed_under_a_table_side_by_side(case):
    stools = [_floor(case, m) for m in case.members if m.category == "stool"]
    table = _floor(case, case.members[0])
    assert len(stools) == 2
    assert stools[0].distance(stools[1]) > 0.0
    assert all(0.5 < stool.intersection(table).area / stool.area < 1.0 for stool in stools)
    assert [name for name, _ in find_case_faults(case)] == ["stools"]


@pytest.mark.parametrize("case", list(narrow_sides()), ids=lambda case: case.name)
def test_a_narrow_nightstand_is_one_but_leaves_no_way(case):
    stands = [m for m in case.members if m.category == "nightstand"]
    assert len(stands) == 2
    assert _floor(case, stands[0]).disjoint(_floor(case, stands[1]))
    width = min(stand.size.width for stand in stands)
    (bed,) = (m.size for m in case.members if m.category == "double_bed")
    expected = ["one_side"] * (width < 0.35) + ["short_bed"] * (bed.depth < 2.0)
    assert [name for name, _ in find_case_faults(case)] == expected
    assert width == pytest.approx(0.3) or (bed.depth < 2.0 and width >= 0.4)


def _group(name: str, *pieces: Piece) -> FurnishedGroup:
    case = Group(name, name, 1.0, 1.0, ())
    return FurnishedGroup(
        Wish(name, 0), name, FurnishedPatch(case, np.zeros(5), (True,), 0), pieces
    )


@pytest.mark.parametrize(
    ("x", "y", "table", "stays"),
    [(2.5, 0.0, False, True), (0.2, 2.5, False, False), (0.2, 2.5, True, True)],
    ids=["before the screen", "beside it", "beside it, with its table"],
)
def test_a_sofa_by_itself_that_sees_nothing_of_the_screen_is_left_out(x, y, table, stays):
    sofa = piece("loveseat", 0.0, 0.0, 1.2, 0.8)
    screen = piece("tv", x, y, 0.9, 0.1)
    seats = (sofa, piece("coffee_table", 1.0, 0.0, 0.6, 0.4)) if table else (sofa,)
    placed = (_group("seating", *seats), _group("media", replace(screen, pose=Pose(x, y, 0.5, pi))))
    answer = leave_out_blind_seats(RoomAnswer(0.0, placed, (), (), None, 0.0, 0))
    assert [g.name for g in answer.placed] == (["seating", "media"] if stays else ["media"])
    assert [m.wish.group for m in answer.missing] == ([] if stays else ["seating"])
