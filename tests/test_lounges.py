"""Large living rooms: seats and screen are placed together, the sofa before the screen."""

from __future__ import annotations

from dataclasses import replace
from math import cos, hypot, pi, sin

import pytest

from scenewright.building.plan import spaces
from scenewright.core.brief import Brief, Room
from scenewright.core.scene import Pose, Size
from scenewright.domains import check
from scenewright.domains.home.composing.case_faults import count_seats
from scenewright.domains.home.composing.places.forms import list_further
from scenewright.domains.home.furnishing.enlarge import find_widest_screen
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.solving import solve

NICHE = {
    "id": "living",
    "function": "living",
    "outline": [[0, 3.24], [2.95, 3.24], [2.95, 0], [5.3, 0], [5.3, 7.8], [0, 7.8]],
    "doors": [
        {"at": [0.0, 4.0], "width": 1.0},
        {"at": [1.6, 7.8], "width": 0.9},
        {"at": [4.2, 7.8], "width": 1.3, "swing": "slide"},
    ],
    "windows": [{"at": [4.1, 0.0], "width": 1.3}],
    "ask": [{"group": g, "required": True} for g in ("dining", "seating", "media", "chest")],
}
SOFAS = ("sofa", "corner_sofa", "loveseat")


def test_a_large_room_with_doors_on_all_sides_has_seats_for_three_before_its_screen():
    home = solve(Brief(rooms=[Room.model_validate(NICHE)]), seed=0)
    sofa = next(p for p in home.pieces if p.category in SOFAS)
    screen = next(p for p in home.pieces if p.category == "tv")
    assert sofa.category != "loveseat"
    away = hypot(sofa.pose.x - screen.pose.x, sofa.pose.y - screen.pose.y)
    assert away <= 3.2 * screen.size.width
    ahead = (screen.pose.x - sofa.pose.x, screen.pose.y - sofa.pose.y)
    assert ahead[0] * cos(sofa.pose.heading) + ahead[1] * sin(sofa.pose.heading) > 0.8 * away
    assert check(home).valid


HEARTHS = [
    ([6.0, 4.8], [0.25, 2.4], 0.0, [5.3, 0.0], [1.5, 0.0]),
    ([7.0, 5.2], [3.5, 4.95], -pi / 2, [0.8, 0.0], [7.0, 2.6]),
]


@pytest.mark.parametrize(("size", "at", "heading", "door", "window"), HEARTHS)
def test_seats_look_at_a_fireplace_on_its_axis(size, at, heading, door, window):
    (wide, deep), axis = size, (cos(heading), sin(heading))
    hearth = {"category": "fireplace", "at": at, "heading": heading, "size": [1.4, 0.5, 1.1]}
    room = {
        "name": "Living room",
        "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
        "doors": [{"at": door, "width": 0.9}],
        "windows": [{"at": window, "width": 1.4}],
        "fixed": [hearth],
    }
    home = solve(Brief(rooms=[Room.model_validate(room)]), seed=0)
    sofa = next(p.pose for p in home.pieces if p.category in SOFAS)
    dx, dy = sofa.x - at[0], sofa.y - at[1]
    assert axis[0] * cos(sofa.heading) + axis[1] * sin(sofa.heading) < -0.95
    assert abs(dy * axis[0] - dx * axis[1]) < 0.7
    between = [
        p
        for p in home.pieces
        for x, y in [(p.pose.x - at[0], p.pose.y - at[1])]
        if abs(y * axis[0] - x * axis[1]) < 0.4
        and 0.3 < x * axis[0] + y * axis[1] < dx * axis[0] + dy * axis[1] - 0.1
        and p.pose.z < 1.0
    ]
    assert {p.function for p in between} <= {"seating"}
    assert check(home).valid


def test_what_stands_beside_a_stand_keeps_its_screen_narrow():
    brief = Brief(rooms=[Room.model_validate(NICHE)])
    home = solve(brief, seed=0, steps=500)
    stand = next(p for p in home.pieces if p.category == "tv_stand")
    (space,) = spaces(brief)
    ground = ground_of(space, (), 30.0)
    heading, over = stand.pose.heading, (stand.size.width + 0.4) / 2 + 0.02
    at = [
        (stand.pose.x + k * over * sin(heading), stand.pose.y - k * over * cos(heading))
        for k in (-1, 1)
    ]
    plants = [
        replace(
            stand, id=f"{k}", group="plant", pose=Pose(x, y, 0.0, 0.0), size=Size(0.4, 0.4, 1.5)
        )
        for k, (x, y) in enumerate(at)
    ]
    low = [replace(plant, size=Size(0.4, 0.4, 0.3)) for plant in plants]
    alone = find_widest_screen(stand, ground)
    assert alone > stand.size.width + 0.1
    assert find_widest_screen(stand, ground, low) == alone
    assert find_widest_screen(stand, ground, plants) <= stand.size.width + 0.04


def test_corner_sofas_seat_four_and_come_both_ways_round():
    corners = [g for g in list_further("seating") if g.members[0].category == "corner_sofa"]
    names = [g.members[0].asset for g in corners]
    assert names.count("corner_sofa") == names.count("corner_sofa_right") > 0
    for group in corners:
        assert count_seats(group) >= 4
        assert all(abs(m.x) <= group.width / 2 + 1e-9 for m in group.members)
        low = [m for m in group.members if m.category not in ("rug", "picture")]
        assert all(m.y + min(m.size.depth, m.size.width) / 2 <= group.depth / 2 for m in low)


def test_where_no_wall_holds_a_sofa_and_its_side_table_a_loveseat_stands_by_itself():
    room = {
        "id": "living",
        "function": "living",
        "outline": [[0, 0], [1.5, 0], [1.5, 3.2], [0, 3.2]],
        "doors": [{"at": [x, 1.4], "width": 0.8, "swing": "slide"} for x in (0.0, 1.5)],
    }
    home = solve(Brief(rooms=[Room.model_validate(room)]), seed=0)
    assert {"loveseat", "tv"} <= {p.category for p in home.pieces}
    assert check(home).valid
