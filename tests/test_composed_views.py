"""Sofas look at their screens, doors of wardrobes are free, tables have two chairs and room."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from math import pi

import numpy as np
import pytest
import shapely

from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home.attempts import drafts
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.modest import find_shortage
from scenewright.domains.home.composing.places.forms import cost_of_case
from scenewright.domains.home.composing.views import cost_of_view, is_unseen, measure_turn
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.groups.dining import dining_wall, tables_with_stools
from scenewright.domains.home.groups.living import shelf
from scenewright.domains.home.groups.sleeping import narrow_sides
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.weigh_home import (
    compile_table,
    find_rows,
    list_faults,
    sum_rows,
)
from scenewright.domains.home.solving import solve
from scenewright.formats import read

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
    chair = piece("office_chair", 0.525, 0.5, 0.6, 0.6)

    def measure_share(other: Piece) -> float:
        rows = compile_table(find_rows("doors"))
        faults = list_faults(rows, (_group("chest", other),), (wardrobe,))
        return sum(fault.degree for fault in faults)

    assert measure_share(half) == pytest.approx(0.5)
    assert measure_share(beside) == measure_share(chair) == 0.0


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
    faults = {name for name, _ in find_case_faults(case)}
    assert ("lone" in faults) == (len(chairs) < 2)


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


def _group(name: str, *pieces: Piece, box: tuple[float, ...] = (0.0,) * 5) -> FurnishedGroup:
    case = Group(name, name, 1.0, 1.0, ())
    dressed = FurnishedPatch(case, np.array(box), (True,), 0)
    return FurnishedGroup(Wish(name, 0), name, dressed, pieces)


@pytest.mark.parametrize(
    ("x", "y", "unseen"), [(2.5, 0.0, False), (2.2, 1.0, False), (0.2, 2.5, True)]
)
def test_a_screen_that_the_sofa_does_not_look_at_is_unseen(x, y, unseen):
    screen = replace(piece("tv", x, y, 0.9, 0.1), pose=Pose(x, y, 0.5, pi))
    seats = _group("seating", piece("loveseat", 0.0, 0.0, 1.2, 0.8))
    assert is_unseen((seats, _group("media", screen))) == unseen
    assert is_unseen((_group("media", screen),))
    chair = _group("reading", piece("armchair", 0.0, 0.0, 0.8, 0.8))
    assert is_unseen((chair, _group("media", screen))) == unseen
    table = _group("dining", piece("dining_table", x / 2, y / 2, 1.2, 0.8))
    assert is_unseen((seats, _group("media", screen), table))


def _room_with(column):
    """The edges of a room of 6 m about the origin less a column or a stub of wall."""
    x0, y0, x1, y1 = column
    room = shapely.box(-3.0, -3.0, 4.0, 3.0).difference(shapely.box(x0, y0, x1, y1))
    rings = [shapely.orient_polygons(room).exterior, *shapely.orient_polygons(room).interiors]
    rows = [np.array(ring.coords) for ring in rings]
    return np.concatenate([np.hstack([ring[:-1], ring[1:]]) for ring in rows])


def test_a_column_and_what_stands_right_before_a_screen_hide_it():
    screen = replace(piece("tv", 3.0, 0.0, 0.9, 0.1), pose=Pose(3.0, 0.0, 0.5, pi))
    both = (_group("seating", piece("sofa", 0.0, 0.0, 2.0, 0.9)), _group("media", screen))
    assert is_unseen(both, _room_with((1.3, -0.2, 1.7, 0.2)))
    assert not is_unseen(both, _room_with((1.3, 0.8, 1.7, 1.2)))
    assert is_unseen(both, _room_with((1.3, -3.0, 1.6, 0.1)))
    chest = piece("chest_of_drawers", 2.7, 0.3, 0.4, 0.4)
    assert is_unseen((*both, _group("chest", chest)))
    between = piece("chest_of_drawers", 1.5, 0.3, 0.4, 0.4)
    assert not is_unseen((*both, _group("chest", between)))


def test_a_wall_beside_the_sight_costs_before_it_hides_the_screen():
    screen = replace(piece("tv", 3.0, 0.0, 0.9, 0.1), pose=Pose(3.0, 0.0, 0.5, pi))
    both = (_group("seating", piece("sofa", 0.0, 0.0, 2.0, 0.9)), _group("media", screen))
    costs = PRESETS["default"].settings.composing.costs
    near, far = (_room_with((1.3, -3.0, 1.8, y)) for y in (-0.3, -0.5))
    assert not is_unseen(both, near)
    assert cost_of_view(both, costs, near) > cost_of_view(both, costs, far) == 0.0


@pytest.mark.parametrize(
    ("kind", "height", "unseen"), [("fridge", 1.9, True), ("island", 0.9, False)]
)
def test_of_a_kitchen_only_what_is_tall_hides_a_screen(kind, height, unseen):
    screen = replace(piece("tv", 3.0, 0.0, 1.2, 0.1), pose=Pose(3.0, 0.0, 0.5, pi))
    unit = replace(piece(kind, 2.6, 0.3, 0.6, 0.6), size=Size(0.6, 0.6, height))
    seats = _group("seating", piece("sofa", 0.0, 0.0, 2.0, 0.9))
    assert is_unseen((seats, _group("media", screen), _group("kitchen", unit))) == unseen


@pytest.mark.parametrize("books", [True, False])
def test_a_room_keeps_something_to_look_at_where_no_screen_is_seen(books, monkeypatch):
    """Books take the place of the screen of a first draft; where there may be none, it stays."""
    monkeypatch.setattr(drafts, "DRAFTS", 1)
    asked = read("sample:home-studio").model_dump(mode="json", exclude_unset=True)
    for room in asked["rooms"]:
        room["wishes"] = [] if books else [{"what": "bookcase", "forbid": True}]
    home = solve(Brief.model_validate(asked), seed=3, threads=1)
    there = {p.category for p in home.pieces} & {"tv", "bookcase"}
    assert there == ({"bookcase"} if books else {"tv"})
    assert any(out.what == "media" for out in home.left_out) == books
    assert not any(out.required for out in home.left_out)
    assert not check(home).notes


ASIDE = {
    "id": "living",
    "function": "living",
    "outline": [[3.2, 0], [3.2, 1.8], [0, 1.8], [0, 0]],
    "doors": [
        {"at": [0.6, 1.8], "width": 0.7},
        {"at": [0, 0.9], "width": 0.8},
        {"at": [2.0, 0], "width": 2.2, "swing": "slide"},
    ],
}


def test_a_low_cabinet_stands_for_a_screen_that_would_hang_beside_the_sofa():
    home = solve(Brief(rooms=[Room.model_validate(ASIDE)]), seed=0)
    there = {p.category for p in home.pieces}
    assert {"loveseat", "sideboard"} <= there
    assert not {"tv", "tv_stand"} & there
    assert [out.what for out in home.left_out] == ["media"]
    assert "seen from the sofa" in home.left_out[0].reason
    assert check(home).valid


def test_a_screen_that_was_asked_for_stands_wherever_it_may():
    ask = [{"group": g, "required": True} for g in ("seating", "media")]
    home = solve(Brief(rooms=[Room.model_validate(ASIDE | {"ask": ask})]), seed=0)
    assert any(p.category == "tv" for p in home.pieces)


def test_a_sofa_at_the_chairs_of_a_table_crowds_it():
    table = _group("dining", piece("dining_table", 0.0, 0.0, 0.8, 1.2), box=(0, 0, 0, 1.8, 1.2))

    def cost(x: float, category: str) -> float:
        return 10.0 * sum_rows(
            ("crowded",), (table, _group("seating", piece(category, x, 0, 2.0, 0.9)))
        )

    assert cost(1.0, "sofa") > cost(1.15, "sofa") > 5.0
    assert cost(1.3, "sofa") == cost(1.0, "tv_stand") == 0.0


def test_a_table_short_of_places_costs_twice_what_a_narrow_shelf_does():
    rule = PRESETS["default"].settings.composing
    two = next(case for case in dining_wall() if count_chairs(case) == 2)
    small = next(shelf())
    assert find_shortage(two, 13.0) == pytest.approx(0.5, abs=1e-3)
    assert cost_of_case(two, 13.0, rule) == pytest.approx(10.0, abs=0.1)
    assert cost_of_case(small, 13.0, rule) == pytest.approx(5.0, abs=0.1)


def count_chairs(case: Group) -> int:
    return sum(member.category == "dining_chair" for member in case.members)
