"""What stands too near to something else when a home is done, by hand, and in whole homes."""

from __future__ import annotations

from math import pi
from types import SimpleNamespace

import numpy as np
import pytest
from benchmarks.plans_r2v import adapt, raw_plans
from benchmarks.rescaled_r2v import rescale

import scenewright as sw
from scenewright.building.plan import spaces
from scenewright.catalog.classes import SOFT_SEATS
from scenewright.core.brief import Brief
from scenewright.core.passes import PassOptions
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer
from scenewright.domains.home.cases.library import SHIPPED, cases
from scenewright.domains.home.composing.spacing import rules, shifts
from scenewright.domains.home.composing.spacing.askew import square_up
from scenewright.domains.home.composing.spacing.leave_out import leave_out_near, may_leave_out
from scenewright.domains.home.composing.verdict import STUCK
from scenewright.domains.home.furnishing.enlarge import without_overlaps
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.living import BEHIND
from scenewright.domains.home.rules.told import list_broken
from scenewright.domains.home.rules.weigh_home import compile_table, list_faults, say_fault
from scenewright.domains.home.solving import solve


def group(name, category, x, y, heading, width, depth):
    piece = Piece(name, category, "", "a", Pose(x, y, 0.0, heading), Size(width, depth, 0.9), name)
    return FurnishedGroup(Wish(name, 1), name, None, (piece,))


def gap_of(metres, kind="fridge"):
    """A bed whose foot is so far from another piece."""
    bed = group("single", "single_bed", 0.0, 0.0, 0.0, 0.9, 2.0)
    other = group("other", kind, 1.0 + metres + 0.3, 0.0, pi, 0.6, 0.6)
    return [bed, other]


@pytest.mark.parametrize(
    ("metres", "kind", "near"),
    [
        (0.0, "fridge", True),
        (0.2, "sink_cabinet", True),
        (0.31, "sink_cabinet", False),
        (0.45, "fridge", True),
        (0.51, "fridge", False),
        (0.13, "wardrobe", True),
        (0.51, "wardrobe", False),
        (0.2, "nightstand", False),
    ],
)
def test_beds_keep_off_kitchens_and_doors_of_wardrobes(metres, kind, near):
    assert (rules.measure_closeness(gap_of(metres, kind)) > 0.0) == near


@pytest.mark.parametrize(
    ("metres", "kind", "near"),
    [(0.02, "hob_cabinet", True), (0.31, "hob_cabinet", False), (0.02, "bookcase", False)],
)
def test_a_screen_keeps_off_the_units_of_a_kitchen_beside_it(metres, kind, near):
    stand = group("media", "tv_stand", 0.0, 0.0, pi / 2, 1.4, 0.4)
    unit = group("kitchen", kind, 0.7 + metres + 0.3, 0.0, pi / 2, 0.6, 0.6)
    assert (rules.measure_closeness([stand, unit]) > 0.0) == near


def test_the_nearer_the_worse():
    costs = [rules.measure_closeness(gap_of(metres)) for metres in (0.0, 0.1, 0.2)]
    assert costs == sorted(costs, reverse=True)
    assert costs[0] > costs[2]


def test_chairs_can_be_pushed_back():
    chair = group("dining", "dining_chair", 0.0, 0.0, 0.0, 0.46, 0.5)
    sofa = group("seating", "sofa", -0.25 - 0.3 - 0.45, 0.0, pi, 2.0, 0.9)
    (close,) = rules.list_close([chair, sofa])
    assert (close.group, close.other) == ("dining", "seating")


def test_tables_keep_off_the_units_of_a_kitchen():
    table = group("dining", "dining_table", 0.0, 0.0, 0.0, 1.2, 0.8)
    near, far = (
        group("kitchen", "drawer_cabinet", 0.4 + gap + 0.3, 0.0, pi, 0.6, 0.6)
        for gap in (0.1, 0.31)
    )
    assert rules.measure_closeness([table, near]) > 0.0 == rules.measure_closeness([table, far])


def test_rugs_do_not_overlap_and_fixed_ones_stay():
    def rug(name, x, width, fixed=False):
        pose, size = Pose(x, 0.0, 0.0, 0.0), Size(width, 1.0, 0.012)
        return Piece(name, "rug", "", "a", pose, size, name, fixed=fixed)

    apart = [rug("a", 0.0, 2.0), rug("b", 1.3, 1.5)]
    assert [p.id for p in without_overlaps(apart)] == ["a", "b"]
    near = [rug("a", 0.0, 2.0, fixed=True), rug("b", 0.9, 2.5)]
    assert [p.id for p in without_overlaps(near)] == ["a"]


def close_in(solution):
    groups = {}
    for piece in solution.pieces:
        groups.setdefault((piece.space, piece.group), []).append(piece)
    rooms = {}
    for (space, name), pieces in groups.items():
        each = FurnishedGroup(Wish(name, 1), name, None, tuple(pieces))
        rooms.setdefault(space, []).append(each)
    return sum(rules.measure_closeness(each) for each in rooms.values())


def test_a_studio_has_its_sofa_off_the_kitchen():
    brief = sw.read("sample:home-studio")
    kept = sw.solve(brief, seed=0)
    left = solve(brief, seed=0, passes=PassOptions(frozenset(("mend rooms",))))
    assert close_in(kept) < close_in(left)
    assert check(kept).valid


def test_no_wish_that_was_met_is_given_up_for_distance():
    room = {
        "id": "r",
        "function": ["living", "kitchen"],
        "outline": [(0, 0), (3.4, 0), (3.4, 4.4), (0, 4.4)],
        "wishes": [{"what": "wardrobe", "by": "window"}],
        "doors": [{"at": (2.6, 0), "width": 0.9}],
        "windows": [{"at": (0, 2.2), "width": 1.6}],
    }
    solution = sw.solve(Brief.model_validate({"rooms": [room]}), seed=3)
    assert [wish["fulfilled"] for wish in check(solution).figures["wishes"]] == [True]


def _answer(*groups):
    return RoomAnswer(0.0, tuple(groups), (), (), None, 0.0, 0)


@pytest.mark.parametrize(
    ("name", "category", "to", "metres", "gone"),
    [
        ("shoes", "shoe_cabinet", "fridge", 0.1, True),
        ("shoes", "shoe_cabinet", "fridge", 0.5, False),
        ("coats", "coat_rack", "dining_wall", 0.05, True),
        ("coats", "coat_rack", "dining_wall", 0.4, False),
        ("media", "tv_stand", "fridge", 0.1, False),
        ("chest", "chest_of_drawers", "storage", 0.1, True),
        ("chest", "chest_of_drawers", "storage", 0.4, False),
        ("seating", "sofa", "storage", 0.1, False),
    ],
)
def test_what_stands_before_a_fridge_or_open_shelves_or_at_a_table_goes(
    name, category, to, metres, gone
):
    kind = {"fridge": "fridge", "storage": "storage_shelf"}.get(to, "dining_table")
    one = group(to, kind, 0.0, 0.0, 0.0, 0.6, 0.6)
    other = group(name, category, 0.3 + metres + 0.2, 0.0, 0.0, 0.6, 0.4)
    left = leave_out_near(_task(), _answer(one, other))
    assert [m.wish.group for m in left.missing] == ([name] if gone else [])
    asked = other._replace(wish=other.wish._replace(required=True))
    assert leave_out_near(_task(), _answer(one, asked)).placed == (one, asked)


@pytest.mark.parametrize(
    ("name", "category", "rank", "metres", "gone"),
    [
        ("counter", "drawer_cabinet", 1, 0.05, True),
        ("counter", "drawer_cabinet", 0, 0.05, False),
        ("counter", "drawer_cabinet", 1, 0.6, False),
        ("console", "console_table", 2, 0.05, True),
        ("chest", "chest_of_drawers", 2, 0.05, False),
    ],
    ids=["near", "essential", "apart", "welcome", "no-filling"],
)
def test_what_is_merely_welcome_gives_way_to_chairs_by_name(name, category, rank, metres, gone):
    chair = group("dining", "dining_chair", 0.0, 0.0, 0.0, 0.46, 0.5)
    other = group(name, category, -0.25 - metres - 0.2, 0.0, 0.0, 0.9, 0.4)
    other = other._replace(wish=Wish(name, rank))
    left = leave_out_near(_task(), _answer(chair, other))
    assert [g.name for g in left.placed] == (["dining"] if gone else ["dining", name])
    assert [m.wish.group for m in left.missing] == ([name] if gone else [])
    assert all("a chair cannot be drawn back" in m.reason for m in left.missing)


def test_rows_that_a_finished_home_breaks_are_said_with_the_name_of_the_other():
    chair = group("dining", "dining_chair", 0.0, 0.0, 0.0, 0.46, 0.5)
    other = group("console", "console_table", -0.5, 0.0, 0.0, 0.9, 0.4)
    outline = [[-3, -3], [3, -3], [3, 3], [-3, 3]]
    (space,) = spaces(Brief(rooms=[{"id": "a", "function": "dining", "outline": outline}]))
    said = {say_fault(fault) for fault in list_broken(space, (*chair.pieces, *other.pieces))}
    assert "a chair cannot be drawn back 0.5 m for the console table" in said


@pytest.mark.parametrize(("category", "counts"), [("sofa", True), ("armchair", False)])
def test_a_sofa_stands_square_to_some_wall(category, counts):
    square, askew = (group("seating", category, 1.0, 0.0, h, 2.0, 0.9) for h in (pi / 2, pi / 3))
    assert not rules.list_close([square], (), _ground())
    assert bool(rules.list_close([askew], (), _ground())) == counts
    assert square_up(pi / 3, _ground()) == pytest.approx(pi / 2)
    slanted = _ground()._replace(edges=np.array([[0.0, 0.0, 1.0, 3**0.5]]))
    found = list_faults(compile_table(rules.LATE), [askew], (), slanted)
    assert "askew" not in {fault.row.id for fault in found}


def test_a_sofa_keeps_off_the_sides_of_a_bed():
    bed = group("sleeping", "double_bed", 0.0, 0.0, 0.0, 1.6, 2.0)
    near, far = (
        group("seating", "sofa", 0.0, 0.8 + gap + 0.45, pi / 2, 2.0, 0.9) for gap in (0.1, 0.4)
    )
    assert rules.list_close([bed, near])
    assert not rules.list_close([bed, far])


def test_no_screen_is_moved_to_where_a_column_hides_it():
    home = sw.solve(sw.read("sample:home-curved"), seed=53)
    assert any(p.category == "tv" for p in home.pieces)


def test_a_chest_that_cannot_be_opened_is_left_out_by_name():
    chest = group("chest", "chest_of_drawers", 0.0, 0.0, 0.0, 1.0, 0.4)
    bed = group("sleeping", "double_bed", 1.2 + 0.1, 0.0, pi, 1.4, 2.0)
    groups = (chest._replace(wish=Wish("chest", 1)), bed)
    left = leave_out_near(_task(), _answer(*groups))
    assert [g.name for g in left.placed] == ["sleeping"]
    assert [m.wish.group for m in left.missing] == ["chest"]


def _task():
    return SimpleNamespace(
        preset=SimpleNamespace(settings=SimpleNamespace(exact=True)),
        accessible=False,
        fixed=(),
        ground=_ground(),
        library=SHIPPED,
        asked=None,
        space=SimpleNamespace(outlets=()),
    )


def _ground(keep_free=()):
    edges = np.array([[-1, -2, 3, -2], [3, -2, 3, 2], [3, 2, -1, 2], [-1, 2, -1, -2]], float)
    free, boxes, lines = np.array(keep_free, float).reshape(-1, 5), np.zeros((0, 5)), edges[:0]
    panes = np.zeros((0, 6))
    return Ground(edges, edges, free, boxes, boxes, panes, boxes, lines, np.zeros(4), 0.0)


def test_a_chair_with_a_wall_right_behind_it_is_wedged():
    near, far = (group("dining", "dining_chair", x, 0.0, 0.0, 0.46, 0.5) for x in (-0.65, -0.2))
    close = rules.list_close([near], (), _ground())
    assert {pair.group for pair in close} == {"dining"}
    assert sum(pair.cost for pair in close) > 5.0 / 2
    assert not rules.list_close([far], (), _ground())


@pytest.mark.parametrize("category", ["dining_chair", "stool"])
def test_a_chair_nobody_can_sit_on_is_worse_than_two_beside_one_another(category):
    """More than both at one side of their table costs, which is what one would do instead."""
    costs = PRESETS["default"].settings.composing.costs
    chair = group("dining", category, 0.0, 0.0, 0.0, 0.5, 0.5)
    cupboard = group("chest", "chest_of_drawers", -0.45, 0.0, pi, 1.0, 0.3)
    assert rules.measure_closeness([chair, cupboard]) > costs.abreast_wall
    wall = group("dining", category, -0.7, 0.0, 0.0, 0.5, 0.5)
    assert rules.measure_closeness([wall], (), _ground()) > costs.abreast_wall


def test_a_column_before_a_sofa_is_too_near():
    column = np.array([[1.6, 0.0, 1.4, 0.0], [1.4, 0.0, 1.4, 0.3]])
    column = np.vstack([column, [[1.4, 0.3, 1.6, 0.3], [1.6, 0.3, 1.6, 0.0]]])
    ground = _ground()._replace(edges=np.vstack([_ground().edges, column]))
    near, far = (group("seating", "sofa", x, 0.0, 0.0, 1.6, 0.9) for x in (0.7, 0.3))
    assert rules.list_close([near], (), ground)
    assert not rules.list_close([far], (), ground)


def test_a_stool_before_an_open_door_is_wedged():
    stool = group("dining_wall", "stool", 1.0, 0.0, 0.0, 0.38, 0.38)
    door = (0.5, 0.0, 0.0, 0.8, 0.4)
    assert rules.list_close([stool], (), _ground([door]))
    assert not rules.list_close([stool], (), _ground([(0.2, 0.0, 0.0, 0.8, 0.4)]))


@pytest.mark.parametrize(
    ("x", "heading", "category", "counts"),
    [
        (1.3, 0.0, "sofa", True),
        (1.3, pi, "sofa", False),
        (3.0, 0.0, "sofa", False),
        (1.2, 0.3, "dining_chair", True),
        (1.2, 0.0, "bookcase", False),
    ],
    ids=["back", "front", "far", "chair", "other"],
)
def test_an_armchair_does_not_look_at_a_back(x, heading, category, counts):
    armchair = group("reading", "armchair", 0.0, 0.0, 0.0, 0.8, 0.8)
    other = group("other", category, x, 0.0, heading, 0.9, 0.5)
    assert (rules.measure_closeness([armchair, other]) >= BEHIND) == counts


def test_a_table_is_shifted_and_turned_about_where_it_stands():
    box = np.array([2.0, 1.0, 0.5, 1.8, 1.2])
    boxes = shifts._shift(box, True)
    off = np.hypot(*(boxes[:, :2] - box[:2]).T)
    assert len(boxes) == 2 * (21 * 21 - 1 + 27 * 27 - 11 * 11)
    assert len(np.unique(boxes.round(6), axis=0)) == len(boxes)
    assert 0.09 < off.min() < off.max() < 3.7
    assert len(shifts._shift(box, False)) == 21 * 21 - 1
    assert set(np.round(boxes[:, 2] - box[2], 6)) == {0.0, round(pi / 2, 6)}


@pytest.mark.parametrize(
    ("category", "x", "near"),
    [
        *(("wardrobe", 2.4, True), ("wardrobe", 2.2, False), ("chest_of_drawers", 2.4, True)),
        *(("armchair", 2.5, True), ("armchair", 2.2, False)),
    ],
)
def test_what_opens_needs_floor_before_it_within_the_room(category, x, near):
    wall = group("wardrobe", category, x, 0.0, 0.0, 1.0, 0.6)
    assert bool(rules.list_close([wall], (), _ground())) == near


@pytest.mark.parametrize(("metres", "near"), [(0.05, True), (0.45, False)])
def test_the_back_of_a_sofa_keeps_off_the_foot_of_a_bed(metres, near):
    bed = group("single", "single_bed", 0.0, 0.0, 0.0, 0.9, 2.0)
    sofa = group("seating", "sofa", 1.0 + metres + 0.45, 0.0, 0.0, 1.8, 0.9)
    assert (rules.measure_closeness([bed, sofa]) > 0.0) == near


@pytest.mark.parametrize(("x", "near"), [(1.0, True), (0.6, False)])
def test_a_bookcase_does_not_stand_behind_an_open_door(x, near):
    door = (1.55, 0.0, 0.0, 1.0, 0.7)
    shelf = group("shelf", "bookcase", x, 0.0, 0.0, 0.9, 0.3)
    assert bool(rules.list_close([shelf], (), _ground([door]))) == near


@pytest.mark.parametrize(("kind", "near"), [("wall_shelf", True), ("picture", False)])
def test_a_hung_screen_keeps_off_the_units_of_a_kitchen(kind, near):
    pose, size = Pose(0.0, 0.0, 0.5, pi / 2), Size(0.9, 0.16, 0.03)
    board = Piece("media", kind, "", "a", pose, size, "media")
    media = FurnishedGroup(Wish("media", 1), "media", None, (board,))
    unit = group("kitchen", "drawer_cabinet", 0.45 + 0.1 + 0.3, 0.0, pi / 2, 0.6, 0.6)
    assert (rules.measure_closeness([media, unit]) > 0.0) == near


def test_nothing_that_was_learned_makes_room():
    library = SHIPPED._replace(own={"chest": cases("chest")})
    settings = SimpleNamespace(settings=SimpleNamespace(exact=True))
    task = SimpleNamespace(library=library, preset=settings, accessible=False)
    assert not may_leave_out(task)
    task.library = SHIPPED
    assert may_leave_out(task)


@pytest.mark.realdata(quick=True)
def test_every_chair_can_be_drawn_back(real_data):
    """A table for four whose end was wedged at the sofa of its room."""
    home = sw.solve(adapt(rescale(raw_plans()[923])).brief, seed=401, threads=1)
    chairs = [piece for piece in home.pieces if piece.category == "dining_chair"]
    soft = [piece for piece in home.pieces if piece.category in SOFT_SEATS]
    assert len(chairs) >= 3
    assert soft
    placed = [FurnishedGroup(Wish(p.function, 1), p.group, None, (p,)) for p in (*chairs, *soft)]
    assert not [pair for pair in rules.list_close(placed) if pair.cost >= STUCK]
