"""Pieces along walls on the axis of what they belong to, in corners, off doors, square."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
import pytest
import shapely

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import Group
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains import check
from scenewright.domains.home import solving
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.alignment.align import align_groups
from scenewright.domains.home.composing.alignment.homes import align_rooms
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.furnishing.obstacles import standing_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.formats import read

UP, DOWN, LEFT, RIGHT = pi / 2, -pi / 2, pi, 0.0


def room_task(function: str = "bedroom", wide: float = 4.0, **more) -> RoomTask:
    outline = [[0, 0], [wide, 0], [wide, 4], [0, 4]]
    doors = [{"at": [wide - 0.6, 0.0], "width": 0.9}]
    room = {"id": "room", "function": function, "outline": outline, "doors": doors} | more
    brief, preset = Brief(rooms=[Room.model_validate(room)]), PRESETS["default"]
    (task,), _ = prepare(brief, preset)
    return task


def prepare(brief, preset):
    return solving.prepare_rooms(brief, spaces(brief), catalog_of(()), preset, preset.solver, 0)


def named(name: str, width: float) -> Group:
    return min(cases(name).groups, key=lambda c: (abs(c.width - width), -len(c.members)))


def stand(task: RoomTask, case: Group, at: tuple[float, float, float], *others: FurnishedGroup):
    group = make_unplaced(task, others, Wish(case.function, 0), case)
    box = np.array([*at, case.width, case.depth])
    standing = standing_of(tuple(p for g in others for p in g.pieces), frozenset())
    dressed = dress_group(task, group, case, box, standing)
    assert dressed is not None
    return dressed


def bed(task: RoomTask, y: float) -> FurnishedGroup:
    case = max(cases("sleeping").groups, key=lambda c: (len(c.members), -c.width))
    return stand(task, case, (case.depth / 2, y, RIGHT))


def test_a_chest_slides_onto_the_axis_of_the_bed_at_whose_foot_it_stands():
    task, case = room_task(), named("chest", 1.0)
    sleeping = bed(task, 2.3)
    chest = stand(task, case, (4.0 - case.depth / 2, 3.4, LEFT), sleeping)
    _, slid = align_groups(task, (sleeping, chest))
    assert slid.dressed.box[:3] == pytest.approx([4.0 - case.depth / 2, 2.3, LEFT])
    assert len(slid.pieces) == len(chest.pieces)


def test_a_screen_has_the_axis_of_a_bed_before_a_chest_has_it():
    task = room_task()
    sleeping, screen, case = bed(task, 2.3), named("media", 0.9), named("chest", 0.6)
    media = stand(task, screen, (4.0 - screen.depth / 2, 2.6, LEFT), sleeping)
    chest = stand(task, case, (4.0 - case.depth / 2, 3.6, LEFT), sleeping, media)
    _, first, second = align_groups(task, (sleeping, media, chest))
    assert first.dressed.box[1] == pytest.approx(2.3)
    assert abs(second.dressed.box[1] - 2.3) > 0.6


def test_what_is_before_the_foot_of_a_bed_keeps_its_floor():
    task, case = room_task(wide=2.9), named("chest", 0.6)
    sleeping = bed(task, 2.8)
    chest = stand(task, case, (2.9 - case.depth / 2, 1.45, LEFT), sleeping)
    assert sleeping.dressed.box[4] + 0.6 > 2.9 - case.depth
    slid = align_groups(task, (sleeping, chest))[1].dressed.box
    double = next(p for p in sleeping.pieces if p.category == "double_bed")
    assert 1.45 < slid[1] <= 2.8 - (double.size.width + case.width) / 2 + 0.05


def test_a_desk_slides_before_the_middle_of_its_window():
    window = {"at": [1.6, 4.0], "width": 1.4, "sill": 1.3}
    task, case = room_task("study", windows=[window]), named("desk", 1.0)
    desk = stand(task, case, (2.3, 4.0 - case.depth / 2, DOWN))
    (slid,) = align_groups(task, (desk,))
    assert slid.dressed.box[:2] == pytest.approx([1.6, 4.0 - case.depth / 2])


@pytest.mark.parametrize(("gap", "left"), [(0.3, 0.0), (0.05, 0.0), (0.9, 0.9)])
def test_no_dead_slit_is_left_between_a_shelf_and_the_corner(gap, left):
    task, case = room_task("study"), named("shelf", 1.0)
    shelf = stand(task, case, (gap + 0.5, 4.0 - case.depth / 2, DOWN))
    (slid,) = align_groups(task, (shelf,))
    assert slid.dressed.box[0] - 0.5 == pytest.approx(left, abs=0.002)


def test_neighbours_are_pushed_together():
    task, case, wide = room_task("study"), named("shelf", 1.0), named("chest", 1.0)
    shelf = stand(task, case, (0.5, 4.0 - case.depth / 2, DOWN))
    chest = stand(task, wide, (1.6, 4.0 - wide.depth / 2, DOWN), shelf)
    boxes = [g.dressed.box for g in align_groups(task, (shelf, chest))]
    assert boxes[1][0] - boxes[0][0] == pytest.approx(1.0, abs=0.003)


def test_what_ends_at_the_swing_of_a_door_moves_off_it():
    task, case = room_task("study"), named("shelf", 1.0)
    start = float((task.ground.keep_free[:, 0] - task.ground.keep_free[:, 3] / 2).min())
    shelf = stand(task, case, (start - 0.05 - 0.5, case.depth / 2, UP))
    (slid,) = align_groups(task, (shelf,))
    assert start - slid.dressed.box[0] - 0.5 >= 0.149


def test_what_is_skew_is_put_square_to_its_wall():
    task, case = room_task("study"), named("shelf", 1.0)
    shelf = stand(task, case, (2.0, 4.0 - case.depth / 2 - 0.007, DOWN + 0.012))
    (slid,) = align_groups(task, (shelf,))
    assert slid.dressed.box[2] == pytest.approx(DOWN, abs=1e-9)


def test_a_sofa_with_a_side_table_is_mirrored_where_that_brings_it_before_its_screen():
    task, screen = room_task("living"), named("media", 1.2)
    case = next(c for c in cases("seating").groups if c.name == "1.4 m sofa, side table")
    chair = named("shelf", 0.8)
    block = stand(task, chair, (0.4, 4.0 - chair.depth / 2, DOWN))
    media = stand(task, screen, (2.0, screen.depth / 2, UP), block)
    other = stand(task, chair, (3.6, 4.0 - chair.depth / 2, DOWN), block, media)
    sofa = stand(
        task, case, (3.2 - case.width / 2, 4.0 - case.depth / 2, DOWN), block, media, other
    )
    slid = align_groups(task, (block, other, media, sofa))
    seat = next(p for p in slid[3].pieces if p.category == "loveseat")
    tv = next(p for p in slid[2].pieces if p.category == "tv")
    assert abs(seat.pose.x - tv.pose.x) < 0.02


def test_a_home_is_aligned_where_its_ways_stay_open_and_else_move_by_move():
    task, case = room_task("study"), named("shelf", 1.0)
    first = stand(task, case, (0.8, 4.0 - case.depth / 2, DOWN))
    second = stand(task, case, (0.7, case.depth / 2, UP), first)
    answer = RoomAnswer(0.0, (first, second), (), (), None, 0.0, 0)

    def opened(bars):
        return lambda found: [a._replace(placed=()) if bars(a.placed) else a for a in found]

    def moved(placed):
        return tuple(a is not b for a, b in zip(placed, (first, second), strict=True))

    (free,) = align_rooms([task], [answer], opened(lambda _: False))
    (half,) = align_rooms([task], [answer], opened(lambda p: moved(p)[1]))
    (none,) = align_rooms([task], [answer], opened(lambda p: any(moved(p))))
    found = [[g.dressed.box[0] for g in a.placed] for a in (free, half, none)]
    assert found[0] == pytest.approx([0.5, 0.5], abs=0.002)
    assert found[1] == pytest.approx([0.5, 0.7], abs=0.002)
    assert found[2] == pytest.approx([0.8, 0.7])


def test_rooms_for_wheelchairs_and_printed_presets_are_left_as_they_are():
    task, case = room_task("study"), named("shelf", 1.0)
    shelf = stand(task, case, (0.8, 4.0 - case.depth / 2, DOWN))
    answer = RoomAnswer(0.0, (shelf,), (), (), None, 0.0, 0)
    for other in (task._replace(accessible=True), task._replace(preset=PRESETS["paper"])):
        assert align_rooms([other], [answer], list) == [answer]


def test_in_a_solved_home_shelves_stand_in_a_corner_or_hard_at_a_neighbour():
    home = solving.solve(read("sample:home-studio"), seed=0)
    (room,) = (r for r in spaces(home.brief) if "living" in r.functions)
    floor, standing = shapely.Polygon(room.outline), [p for p in home.pieces if p.pose.z < 0.01]
    for shelf in (p for p in standing if p.category == "bookcase"):
        turn, out = shelf.pose.heading, shelf.size.width / 2 + 0.01
        ends = [
            shapely.Point(
                shelf.pose.x - side * out * sin(turn), shelf.pose.y + side * out * cos(turn)
            )
            for side in (-1, 1)
        ]
        others = shapely.union_all(polygons_of([p for p in standing if p is not shelf]))
        assert any(others.intersects(end) or not floor.contains(end) for end in ends)
    assert check(home).valid
