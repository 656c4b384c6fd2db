"""Where chairs stand at a single desk: how many, on which side, looking at it."""

from __future__ import annotations

from math import cos, pi, sin

import pytest

from scenewright.catalog.assets import shipped
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.desks.chairs import desk_chairs
from scenewright.domains.hall.seats.chairs import CHAIRS

CATALOG = shipped()


def desk(category="desk", width=1.4, heading=0.0, x=0.0, y=0.0):
    pose = Pose(x, y, 0.0, heading)
    return Piece("d", category, "", "h", pose, Size(width, 0.8, 0.75), "group", "desks")


def chairs(*desks, name="", served=(), solid=()):
    return desk_chairs(desks, {"desks": name, "others": ""}, served, (*desks, *solid), CATALOG)


def seen_from(table, chair):
    """How far a chair is before a desk and to its right, and how it is turned to it."""
    c, s = cos(table.pose.heading), sin(table.pose.heading)
    dx, dy = chair.pose.x - table.pose.x, chair.pose.y - table.pose.y
    turn = (chair.pose.heading - table.pose.heading) % (2 * pi)
    return (dx * c + dy * s, dx * s - dy * c, cos(turn))


def depth_of(kind):
    return CATALOG.of(kind)[0].usual[1]


@pytest.mark.parametrize("heading", [0.0, 0.8, pi / 2, -2.4])
@pytest.mark.parametrize(
    ("category", "kind", "front"),
    [
        ("carrel", "reading_chair", 1),
        ("desk", "office_chair", 1),
        ("corner_desk", "office_chair", 1),
        ("info_desk", "office_chair", -1),
    ],
)
def test_a_chair_is_pushed_in_a_hand_on_the_side_where_one_works(heading, category, kind, front):
    table = desk(category, heading=heading, x=3.0, y=-2.0)
    (chair,) = chairs(table)
    ahead = front * (0.4 + depth_of(kind) / 2 - 0.2)
    assert chair.category == kind
    assert seen_from(table, chair) == pytest.approx((ahead, 0.0, -front))
    assert (chair.group, chair.function) == ("group", f"desks{CHAIRS}")
    assert -pi <= chair.pose.heading <= pi


@pytest.mark.parametrize(
    ("width", "aside"), [(1.2, [0.0]), (1.59, [0.0]), (1.6, [-0.36, 0.36]), (2.4, [-0.54, 0.54])]
)
def test_a_desk_of_the_staff_seats_two_from_160_cm_each_behind_a_screen(width, aside):
    table = desk("info_desk", width, heading=0.5)
    found = chairs(table)
    assert [seen_from(table, chair)[1] for chair in found] == pytest.approx(aside)
    assert len({chair.id for chair in found}) == len(aside)


@pytest.mark.parametrize(
    ("width", "aside"),
    [(1.0, [0.0]), (1.19, [0.0]), (1.2, [-0.288, 0.288]), (1.6, [-0.384, 0.384])],
)
@pytest.mark.parametrize("name", ["Travel advice", "BERATUNG", "mesas de Ventas"])
def test_customers_sit_across_a_desk_where_one_is_advised(width, aside, name):
    table = desk(width=width)
    staff, *customers = chairs(table, name=name)
    ahead = 0.4 + depth_of("dining_chair") / 2 - 0.05
    assert seen_from(table, staff)[0] > 0
    assert {chair.category for chair in customers} == {"dining_chair"}
    assert [seen_from(table, chair) for chair in customers] == [
        pytest.approx((-ahead, off, 1.0)) for off in aside
    ]
    assert len(chairs(table, name="exam desks")) == 1


def test_chairs_of_a_kind_that_is_asked_for_come_with_no_desk():
    asked = Piece("c", "office_chair", "", "h", Pose(9, 9, 0, 0), Size(0.6, 0.6, 1.0), "", "others")
    found = desk_chairs((desk(), asked), {"desks": "sales", "others": ""}, (), (), CATALOG)
    assert [chair.category for chair in found] == ["dining_chair"] * 2


def test_desks_served_by_chairs_of_their_own_have_none_at_their_front():
    assert not chairs(desk(), served=("desks",))
    assert len(chairs(desk(), served=("desks",), name="sales")) == 2
    assert len(chairs(desk("info_desk"), served=("desks",))) == 1


def test_a_chair_stands_in_nothing_solid():
    x, y, _, _ = chairs(desk())[0].pose
    column = Piece("p", "column", "", "h", Pose(x + 0.2, y, 0, 0), Size(0.3, 0.3, 3.0))
    assert not chairs(desk(), solid=(column,))
