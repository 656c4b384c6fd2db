"""Seats and screen on one axis, nothing between; shelves without gaps; balconies to sit on."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import Group
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.alignment.align import align_groups
from scenewright.domains.home.composing.filling.bare_floor import furnish_bare_floor
from scenewright.domains.home.composing.filling.bare_walls import furnish_bare_walls
from scenewright.domains.home.composing.places.forms import list_further
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.composing.views import cost_of_view, list_between
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.furnishing.obstacles import standing_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.settings import CompositionCosts
from scenewright.domains.home.solving import prepare_rooms, solve
from scenewright.geometry.fit import is_backed

COSTS = CompositionCosts()


def _task(function: str, wide: float, deep: float) -> RoomTask:
    room = {
        "id": "room",
        "function": function,
        "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
        "doors": [{"at": [0.0, deep / 2], "width": 0.9}],
    }
    brief, preset = Brief(rooms=[Room.model_validate(room)]), PRESETS["default"]
    (task,), _ = prepare_rooms(brief, spaces(brief), catalog_of(()), preset, preset.solver, 0)
    return task


def _stand(
    task: RoomTask, case: Group, x: float, y: float, heading: float, *others: FurnishedGroup
):
    group = make_unplaced(task, others, Wish(case.function, 0), case)
    box = np.array([x, y, heading, case.width, case.depth])
    standing = standing_of([p for g in others for p in g.pieces], frozenset())
    dressed = dress_group(task, group, case, box, standing)
    assert dressed is not None
    return dressed


def _group(name: str, category: str, pose: Pose, size: Size) -> FurnishedGroup:
    patch = FurnishedPatch(Group(name, name, 1.0, 1.0, ()), np.zeros(5), (True,), 0)
    return FurnishedGroup(Wish(name, 0), name, patch, (Piece(name, category, "", "a", pose, size),))


SOFA = _group("seating", "sofa", Pose(0.0, 0.0, 0.0, 0.0), Size(2.0, 0.9, 0.8))
SCREEN = _group("media", "tv", Pose(2.6, 0.0, 0.5, pi), Size(1.1, 0.1, 0.6))


def _screen_at(x: float, y: float) -> FurnishedGroup:
    piece = SCREEN.pieces[0]
    return SCREEN._replace(pieces=(replace(piece, pose=Pose(x, y, 0.5, pi)),))


def test_a_screen_off_the_axis_too_near_or_too_far_costs_by_how_much():
    costs = [cost_of_view((SOFA, _screen_at(2.6, y)), COSTS) for y in (0.0, 0.1, 0.5, 1.0)]
    assert costs[:2] == [0.0, 0.0]
    assert 0.0 < costs[2] < costs[3]
    away = [cost_of_view((SOFA, _screen_at(x, 0.0)), COSTS) for x in (1.1, 1.4, 3.9, 4.5, 5.0)]
    assert away[0] > away[1] > away[2] == 0.0 < away[3] < away[4]


def test_too_near_costs_far_more_than_as_much_too_far():
    near, far = (cost_of_view((SOFA, _screen_at(x, 0.0)), COSTS) for x in (1.3, 4.2))
    assert near > 9.0 * far > 0.0


@pytest.mark.parametrize(
    ("y", "z", "category", "counts"),
    [
        (0.0, 0.0, "dining_table", True),
        (1.2, 0.0, "dining_table", False),
        (0.0, 2.0, "dining_table", False),
        (0.0, 0.0, "rug", False),
    ],
    ids=["between", "beside", "above", "flat"],
)
def test_what_stands_between_seats_and_screen_is_named_and_costs(y, z, category, counts):
    table = _group("dining", category, Pose(1.3, y, z, 0.0), Size(1.2, 0.8, 0.75))
    groups = (SOFA, SCREEN, table)
    assert list_between(groups) == (frozenset(("dining",)) if counts else frozenset())
    assert (cost_of_view(groups, COSTS) > 0.0) == counts


@pytest.mark.parametrize("aside", [-1.2, 0.5, 1.2])
def test_a_screen_moves_along_its_wall_onto_the_axis_of_the_sofa(aside):
    task = _task("living", 5.0, 4.0)
    sofa = next(c for c in cases("seating").groups if c.name == "2.0 m sofa, table")
    stand = next(c for c in cases("media").groups if c.width == 1.2)
    seats = _stand(task, sofa, 2.5, sofa.depth / 2, pi / 2)
    media = _stand(task, stand, 2.5 + aside, 4.0 - stand.depth / 2, -pi / 2, seats)
    placed = (seats, media)
    moved = align_groups(task, placed)
    screen = next(p for g in moved for p in g.pieces if p.category == "tv")
    assert screen.pose.x == pytest.approx(2.5, abs=0.05)
    assert screen.pose.y == pytest.approx(media.pieces[1].pose.y)


def test_walls_round_a_wide_empty_floor_take_a_sideboard_and_a_shelf():
    task = _task("living", 6.5, 4.5)
    answer = RoomAnswer(0.0, (), (), (), None, 0.0, 0)
    more = furnish_bare_walls(task, answer, frozenset()).placed
    assert [g.wish.group for g in more][:2] == ["sideboard", "shelf"]
    assert all(is_backed(g.dressed.box, task.ground.walls, 0.05) for g in more)
    small = _task("living", 3.8, 3.0)
    assert furnish_bare_walls(small, answer, frozenset()).placed == ()


@pytest.mark.parametrize(("wide", "chairs"), [(6.5, 2), (4.0, 1)], ids=["large", "small"])
def test_two_armchairs_stand_in_a_large_bare_room_where_one_did(wide, chairs):
    task = _task("living", wide, 4.5)
    one = next(c for c in cases("reading").groups if len(c.members) == 2)
    lone = _stand(task, one, wide - one.width / 2, one.depth / 2, pi / 2)
    lone = lone._replace(wish=lone.wish._replace(rank=2))
    answer = RoomAnswer(0.0, (lone,), (), (), None, 0.0, 0)
    held = furnish_bare_floor(task, answer, frozenset()).placed
    first = next(g for g in held if g.wish == lone.wish)
    assert sum(p.category == "armchair" for p in first.pieces) == chairs


BALCONIES = {
    "small": (2.4, 0.9, Counter(outdoor_chair=1, side_table=1)),
    "bistro": (3.0, 1.2, Counter(outdoor_chair=2, outdoor_table=1)),
    "long and thin": (6.0, 0.75, Counter(outdoor_chair=1)),
}


@pytest.mark.parametrize("name", BALCONIES)
def test_a_balcony_is_sat_on(name):
    wide, deep, held = BALCONIES[name]
    room = {
        "id": "balcony",
        "function": "balcony",
        "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
        "doors": [{"at": [wide / 2 - 0.5, deep], "width": 0.9, "swing": "slide"}],
    }
    home = solve(Brief(rooms=[Room.model_validate(room)]), seed=0)
    stands = Counter(p.category for p in home.pieces)
    assert stands >= held + Counter(planter=1), stands
    assert check(home).valid


def test_two_outdoor_chairs_sit_face_to_face_where_they_can():
    forms = (*cases("terrace").groups, *list_further("terrace"))
    apart = {len({m.heading for m in f.members if m.category == "outdoor_chair"}) for f in forms}
    assert apart == {1, 2}
