"""What keeps a furnished home in use: floor one gets to, cupboards that open, ways left free of
plants, chairs of balconies that look out, one kitchen."""

from __future__ import annotations

from math import cos, pi, sin
from types import SimpleNamespace

import numpy as np
import pytest

import scenewright as sw
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief, Room
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer
from scenewright.domains.home.cases.library import SHIPPED
from scenewright.domains.home.composing.spacing import cut_off, rules
from scenewright.domains.home.composing.spacing.leave_out import leave_out_near
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.needs.household import decide_household, share_out
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.programme import Wish, programme
from scenewright.domains.home.wished.places import spots_of

ROOM = {
    "id": "living",
    "function": "living",
    "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
    "doors": [{"at": [4.0, 0.0], "width": 0.9, "swing": "out"}],
}


def space_of(**changed):
    return spaces(Brief(rooms=[Room.model_validate(ROOM | changed)]))[0]


def group(name, category, x, y, heading, width, depth, rank=1):
    piece = Piece(name, category, "", "a", Pose(x, y, 0.0, heading), Size(width, depth, 0.9), name)
    return FurnishedGroup(Wish(name, rank), name, None, (piece,))


def row_at(x, length):
    """A sofa and its neighbour, with their backs to a strip ``x`` metres wide."""
    return [
        group("seating", "sofa", x + 0.45, 1.0, 0.0, 2.0, 0.9),
        group("shelf", "sideboard", x + 0.45, 2.0 + length / 2, 0.0, length, 0.9),
    ]


@pytest.mark.parametrize(
    ("x", "length", "cut"),
    [(1.2, 2.0, True), (1.2, 1.4, False), (0.4, 2.0, False)],
    ids=["closed", "a way round the end", "a strip nobody stands on"],
)
def test_floor_behind_a_sofa_is_got_to(x, length, cut):
    ground = ground_of(space_of(), (), 30.0)
    groups = row_at(x, length)
    pieces = [p for g in groups for p in g.pieces]
    assert (cut_off.measure_cut_off(pieces, ground) > cut_off.CUT_UNSEEN) == cut
    costs = [c.cost for c in rules.list_close(groups, (), ground) if c.cost >= cut_off.COST]
    assert bool(costs) == cut


def test_floor_that_is_cut_off_agrees_with_counting_by_hand():
    ground = ground_of(space_of(), (), 30.0)
    wall = [group("shelf", "bookcase", 2.0, 2.0, 0.0, 4.0, 0.2).pieces[0]]
    middles = (1.9 - cut_off.STAND) * (4.0 - cut_off.STAND)
    assert cut_off.measure_cut_off(wall, ground) == pytest.approx(middles, rel=0.1)
    assert cut_off.measure_cut_off([], ground) == 0.0


@pytest.mark.parametrize(
    ("gap", "hinge", "shut"),
    [(0.3, "left", True), (0.6, "left", False), (0.3, "right", True)],
    ids=["closed", "a way past its tip", "the other way round"],
)
def test_a_door_whose_leaf_shuts_it_off_counts(gap, hinge, shut):
    """A door in the middle of a wall, a cupboard on its free side and a sofa before its leaf."""
    doors = [
        {"at": [2.5, 0.0], "width": 0.8, "swing": "in", "hinge": hinge},
        {"at": [4.5, 4.0], "width": 0.9, "swing": "out"},
    ]
    ground = ground_of(space_of(doors=doors), (), 30.0)
    free = 2.5 - 0.6 * np.sign(ground.leaves[0, 0] - 2.5)
    cupboard = group("chest", "bookcase", free, 0.5, 0.0, 1.0, 0.3)
    sofa = group("seating", "sofa", 2.5, 0.8 + gap + 0.45, pi / 2, 2.4, 0.9)
    found = cut_off.cost_of_shut_off([*cupboard.pieces, *sofa.pieces], ground)
    assert found == (cut_off.SHUT if shut else 0.0)
    assert cut_off.cost_of_shut_off([], ground) == 0.0


def test_what_stands_already_is_nobodys_fault():
    ground = ground_of(space_of(), (), 30.0)
    wall = group("shelf", "bookcase", 2.0, 2.0, 0.0, 4.0, 0.2).pieces
    plant = group("plant", "potted_tree", 4.5, 3.5, 0.0, 0.4, 0.4)
    assert cut_off.cost_of_cut_off(wall, ground) > 0.0
    for groups in ([], [plant]):
        close = rules.list_close(groups, wall, ground)
        assert not [c for c in close if c.cost >= cut_off.COST]


def test_small_rooms_do_not_mind():
    ground = ground_of(space_of(outline=[[0, 0], [5, 0], [5, 1.8], [0, 1.8]]), (), 9.0)
    wall = [group("shelf", "bookcase", 2.0, 0.9, 0.0, 1.8, 0.2).pieces[0]]
    assert cut_off.measure_cut_off(wall, ground) > cut_off.CUT_UNSEEN
    assert cut_off.cost_of_cut_off(wall, ground) == 0.0


@pytest.mark.parametrize(
    ("category", "gap", "near"),
    [("sideboard", 0.1, True), ("sideboard", 0.5, False), ("fridge", 0.1, False)],
)
def test_no_cupboard_stands_across_a_worktop(category, gap, near):
    unit = group("counter", "drawer_cabinet", 0.0, 0.0, 0.0, 1.0, 0.6)
    other = group("other", category, 0.3 + gap + 0.2, 0.4, pi / 2, 0.4, 0.6)
    assert bool(rules.list_close([unit, other])) == near


def test_a_usual_bookcase_goes_if_it_cannot_be_opened_itself():
    task = SimpleNamespace(
        preset=SimpleNamespace(settings=SimpleNamespace(exact=True)),
        accessible=False,
        fixed=(),
        ground=None,
        library=SHIPPED,
        asked=None,
        space=SimpleNamespace(outlets=()),
    )
    shelf = group("shelf", "bookcase", 0.0, 0.0, 0.0, 1.0, 0.3)
    fridge = group("fridge", "fridge", 0.15 + 0.2 + 0.3, 0.0, 0.0, 0.6, 0.6)
    answer = RoomAnswer(0.0, (shelf, fridge), (), (), None, 0.0, 0)
    assert [g.name for g in leave_out_near(task, answer).placed] == ["fridge"]
    chair = group("dining", "dining_chair", 0.15 + 0.42 + 0.25, 0.0, 0.0, 0.46, 0.5)
    answer = answer._replace(placed=(shelf, chair))
    assert [g.name for g in leave_out_near(task, answer).placed] == ["shelf", "dining"]


def test_plants_stand_beside_the_ways_from_door_to_door():
    doors = [{"at": [1.0, 0.0], "width": 0.9}, {"at": [1.0, 4.0], "width": 0.9}]
    ground = ground_of(space_of(doors=doors), (), 30.0)
    on, off = (group("plant", "potted_tree", x, 2.0, 0.0, 0.5, 0.5) for x in (1.0, 4.5))
    assert rules.list_close([on], (), ground)
    assert not rules.list_close([off], (), ground)


def test_the_outlook_of_a_balcony_lies_across_from_its_doors():
    balcony = space_of(function="balcony", outline=[[0, 0], [5, 0], [5, 1.2], [0, 1.2]])
    (edge,) = spots_of(("outlook",), balcony, ())
    assert sorted(edge.tolist()) == pytest.approx([0.0, 1.2, 1.2, 5.0], abs=0.11)


@pytest.mark.parametrize("seed", range(3))
def test_who_sits_on_a_balcony_does_not_look_at_the_house(seed):
    room = ROOM | {
        "id": "b",
        "function": "balcony",
        "outline": [[0, 0], [3, 0], [3, 0.9], [0, 0.9]],
    }
    room["doors"] = [{"at": [1.9, 0.0], "width": 1.2, "swing": "slide"}]
    home = sw.solve(Brief(rooms=[Room.model_validate(room)]), seed=seed)
    chairs = [p for p in home.pieces if p.category == "outdoor_chair"]
    assert chairs
    into = np.array([0.0, 1.0])
    ahead = [np.array([cos(p.pose.heading), sin(p.pose.heading)]) @ into for p in chairs]
    assert min(ahead) > -0.1


@pytest.mark.parametrize(
    ("area", "functions", "cooks"),
    [
        (2.0, ["kitchen", "washroom"], False),
        (6.0, ["kitchen", "washroom"], False),
        (2.0, ["kitchen"], True),
    ],
)
def test_no_second_kitchen_in_a_wet_room(area, functions, cooks):
    def room(name, uses, deep):
        outline = [[0, 0], [2, 0], [2, deep], [0, deep]]
        return space_of(id=name, function=uses, outline=outline, doors=[])

    small, large = room("a", functions, area / 2), room("b", ["kitchen"], 5.0)
    wishes = (Wish("kitchen", 0), Wish("basin", 0))
    for rooms, both in (([small, large], cooks), ([small], True)):
        found = share_out(decide_household(rooms), "a", wishes, frozenset())
        assert ("kitchen" in {wish.group for wish in found}) == both


@pytest.mark.parametrize(
    ("x", "wall", "shut"),
    [(2.2, -1.4, True), (2.6, -1.4, False), (2.2, -1.0, False)],
    ids=["across the aisle", "beyond it", "no aisle"],
)
def test_nothing_stands_across_the_end_of_an_aisle_beside_a_bed(x, wall, shut):
    """A bed along x, its right side 0.4 m from a wall, or less, and a wardrobe at that wall."""
    edges = np.array([[-1.0, wall, 6, wall], [6, wall, 6, 3], [6, 3, -1, 3], [-1, 3, -1, wall]])
    no, lines, panes = np.zeros((0, 5)), np.zeros((0, 4)), np.zeros((0, 6))
    ground = Ground(edges, edges, no, no, no, panes, no, lines, np.zeros(4), 0.0)
    bed = group("sleeping", "double_bed", 0.0, 0.0, 0.0, 2.0, 2.0)
    wardrobe = group("wardrobe", "wardrobe", x, wall + 0.3, pi / 2, 2.0, 0.6)
    names = {c.other for c in rules.list_close([bed, wardrobe], (), ground) if c.cost >= 4.0}
    assert names == ({"wardrobe"} if shut else set())


def test_what_belongs_outside_stays_outside_and_no_second_toilet_is_in_a_kitchen():
    def groups(function, area, home=()):
        space = space_of(function=function)
        return {wish.group for wish in programme(space, area, frozenset(home))}

    assert {"terrace", "planter"} <= groups("balcony", 6.0)
    assert not groups(["balcony", "bathroom"], 6.0) & {"terrace", "lounger", "planter"}
    assert "toilet" in groups("bathroom", 6.0, {"toilet"})
    assert "toilet" not in groups(["bathroom", "kitchen"], 12.0, {"toilet"})
    assert "toilet" in groups(["bathroom", "kitchen"], 12.0)
