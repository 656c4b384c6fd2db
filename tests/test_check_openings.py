"""The referee on doors and windows, at its tolerances."""

from __future__ import annotations

from dataclasses import replace

import pytest

from judged_rooms import SOUTH, door, judge, kinds, piece, rectangle, room
from scenewright.building.door_approach import door_zone, gates


@pytest.mark.parametrize(("y", "found"), [(1.0, set()), (0.991, set()), (0.98, {"blocked_door"})])
def test_the_threshold_is_free(y, found):
    report = judge(piece("box", 2.0, y), route=0.3)
    assert kinds(report) == found


def test_the_leaf_swings_free():
    swinging = room(openings=(door(2.0, -0.05, hinge=-1, swing=1),))
    near_hinge, beyond = piece("box", 1.6, 0.75, 0.3, 0.3), piece("box", 2.3, 1.0, 0.3, 0.3)
    assert kinds(judge(near_hinge, spaces=(swinging,))) == {"blocked_door"}
    assert kinds(judge(beyond, spaces=(swinging,))) == set()
    assert kinds(judge(near_hinge)) == set()
    other_hand = room(openings=(door(2.0, -0.05, hinge=1, swing=1),))
    assert kinds(judge(near_hinge, spaces=(other_hand,))) == set()
    outward = room(openings=(door(2.0, -0.05, hinge=-1, swing=-1),))
    assert kinds(judge(near_hinge, spaces=(outward,))) == set()


def test_doors_ignore_rugs_and_what_hangs_high():
    rug, shelf = piece("rug", 2, 0.5, h=0.02), piece("picture", 2, 0.15, 0.8, 0.3, 0.3, z=2.1)
    assert not judge(rug).of("blocked_door")
    assert not judge(shelf).of("blocked_door")
    low = replace(shelf, pose=shelf.pose._replace(z=1.6))
    assert judge(low).of("blocked_door")


def test_a_closet_may_be_filled_to_half_its_depth():
    closet = room(outline=rectangle(0, 0, 4, 0.6))
    assert not judge(piece("box", 2, 0.45, 1.5, 0.3), spaces=(closet,)).of("blocked_door")
    assert judge(piece("box", 2, 0.43, 1.5, 0.3), spaces=(closet,)).of("blocked_door")


@pytest.mark.parametrize(
    ("kind", "width", "kept"), [("passage", 2.4, 0.9), ("door", 2.4, 1.2), ("door", 1.4, 0.8)]
)
def test_a_wide_opening_needs_one_free_stretch(kind, width, kept):
    wide = room(openings=(door(2.0, -0.05, width=width, kind=kind),))
    left = 2.0 - width / 2 + kept
    just_free, just_not = (piece("box", left + 0.5 + by, 0.5) for by in (0.02, -0.02))
    assert not judge(just_free, spaces=(wide,)).of("blocked_door")
    assert judge(just_not, spaces=(wide,)).of("blocked_door")


@pytest.mark.parametrize(
    ("height", "y", "found"),
    [(0.94, 2.5, False), (0.96, 2.5, True), (0.96, 2.26, True), (0.96, 2.24, False)],
)
def test_nothing_tall_before_the_glass(height, y, found):
    window = door(2.0, 3.05, kind="window", id="w", width=1.0, sill=0.9, head=2.2)
    lit = room(openings=(door(2.0, -0.05), window))
    report = judge(piece("box", 2.0, y, 1, 1, height), spaces=(lit,))
    assert bool(report.of("blocked_window")) == found
    curtain = piece("curtain", 2, 2.95, 1.2, 0.1, 2.3, heading=SOUTH)
    assert judge(curtain, spaces=(lit,)).valid


@pytest.mark.parametrize(("y", "thickness"), [(-0.05, 0.1), (0.01, 0.02), (-0.01, 0.02)])
def test_what_the_search_keeps_free_is_enough(y, thickness):
    """Also where rooms touch without a wall, and the passage is a little off their edge."""
    opening = door(2.0, y, kind="passage", width=1.5, thickness=thickness)
    space = room(openings=(opening,))
    kept = door_zone(space, gates(space)[0])[0]
    end = kept[1] + kept[4] / 2
    assert not judge(piece("box", 2.0, end + 0.5, 3.0), spaces=(space,)).of("blocked_door")
    assert judge(piece("box", 2.0, end + 0.48, 3.0), spaces=(space,)).of("blocked_door")
