"""The referee under slopes: what is too tall, what hangs, and where nobody can walk."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from judged_rooms import NORTH, SOUTH, door, judge, kinds, piece, rectangle, room
from scenewright.core.space import Slope, Space

KNEE, PITCH = 1.0, math.pi / 4
ROOF = (Slope(2, KNEE, PITCH),)


def attic(**more: object) -> Space:
    """A room 4 m by 3 m, a door in the south; the ceiling rises from 1 m at the north wall."""
    return replace(room(height=2.5, **more), slopes=ROOF)


@pytest.mark.parametrize("gap", [0.0, 0.3, 0.6, 0.99, 1.05])
def test_a_wardrobe_rises_through_a_slope_exactly_where_it_does(gap: float) -> None:
    far = 3 - gap  # its back, and the ceiling over it
    wardrobe = piece("wardrobe", 2, far - 0.3, 1, 0.6, 2.05, heading=SOUTH)
    over = 2.05 - (KNEE + gap)
    report = judge(wardrobe, spaces=(attic(),))
    if over > 0.01:
        (found,) = report.of("through_slope")
        assert found.amount == pytest.approx(over, abs=1e-3)
        assert not report.valid
        assert "through the slope" in found.message
    else:
        assert kinds(report) == set()
    assert judge(wardrobe, spaces=(room(height=2.5),)).valid


def test_a_turned_piece_is_judged_by_its_nearest_corner() -> None:
    turned = piece("box", 2, 2.2, 1, 1, 1.05 + 0.8 - math.sqrt(0.5), heading=PITCH)
    (found,) = judge(turned, spaces=(attic(),)).of("through_slope")
    assert found.amount == pytest.approx(0.05, abs=1e-3)
    square = replace(turned, pose=turned.pose._replace(heading=NORTH))
    assert kinds(judge(square, spaces=(attic(),))) == set()


def test_what_was_given_under_a_slope_is_told_but_not_blamed() -> None:
    given = piece("box", 2, 2.7, 1, 0.6, 2.05, heading=SOUTH, fixed=True)
    report = judge(given, spaces=(attic(),))
    assert kinds(report) == {"through_slope"}
    assert report.valid


def test_lamps_hang_from_the_ceiling_there() -> None:
    lamp = piece("pendant", 2, 2.2, 0.4, 0.4, 0.3, z=1.3)  # lowest over it: 1 + 3 - 2.4 = 1.6
    assert judge(lamp, spaces=(attic(),)).valid
    lower = replace(lamp, pose=lamp.pose._replace(z=1.2))
    assert kinds(judge(lower, spaces=(attic(),))) == {"floating"}
    assert kinds(judge(lamp)) == {"floating"}


def test_one_bends_down_to_what_is_under_a_slope_but_does_not_walk_there() -> None:
    low = piece("wardrobe", 2, 2.8, 1, 0.4, 0.9, heading=SOUTH)
    assert judge(low, spaces=(attic(),)).valid
    aside = piece("wardrobe", 3.8, 2.5, 1, 0.4, 0.35, heading=math.pi)
    assert kinds(judge(aside, spaces=(replace(attic(), slopes=(Slope(2, 0.4, 0.5),)),))) == {
        "unreachable_piece"
    }
    assert judge(aside).valid


def test_a_room_is_expected_to_hold_what_fits_where_one_can_stand() -> None:
    bedroom = room(outline=rectangle(0, 0, 3, 2.4), functions=("bedroom",), height=2.5)
    assert {note.missing for note in judge(spaces=(bedroom,)).notes} == {"bed", "wardrobe"}
    low = replace(bedroom, slopes=(Slope(2, 0.2, 0.7),))
    assert judge(spaces=(low,)).notes == ()


def test_no_route_leads_through_a_low_part_of_a_room() -> None:
    two = rectangle(0, 0, 8, 3)
    doors = (door(0.6, -0.05), door(7.4, -0.05, id="other"))
    wall = piece("box", 4, 0.95, 0.2, 1.9, 2.0, heading=NORTH)
    hidden = piece("wardrobe", 6, 0.3, 1, 0.6, 0.9, heading=NORTH)
    plain = room(outline=two, openings=doors[:1], height=2.5)
    assert judge(wall, hidden, spaces=(plain,)).valid
    sloped = replace(plain, slopes=ROOF)
    assert "unreachable_piece" in kinds(judge(wall, hidden, spaces=(sloped,)))
