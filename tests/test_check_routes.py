"""The referee on what can be reached, and how."""

from __future__ import annotations

from dataclasses import replace

import pytest

from judged_rooms import EAST, NORTH, SOUTH, WEST, door, judge, kinds, piece, rectangle, room
from scenewright.core.space import Opening, Space


@pytest.mark.parametrize(("gap", "reached"), [(0.62, True), (0.58, False)])
def test_a_route_must_be_as_wide_as_asked(gap, reached):
    """A row of boxes across the room leaves a gap at the east wall; a wardrobe beyond."""
    row = piece("box", (4 - gap) / 2, 1.2, 4 - gap, 0.5, id="row")
    wardrobe = piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=SOUTH, id="w")
    report = judge(row, wardrobe)
    assert report.valid == reached
    if not reached:
        (found,) = report.findings
        assert (found.kind, found.piece, found.other) == ("unreachable_piece", "w", "row")


def test_a_side_is_used_from_within_reach():
    """The way is blocked 0.5 m before the front, and open on a bed's other side."""
    hidden = piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=NORTH)
    assert kinds(judge(hidden)) == {"unreachable_piece"}
    bed = piece("bed", 0.8, 2.0, 1.6, 2.0, 0.5, heading=SOUTH)
    assert judge(bed).valid
    squeezed = (piece("box", 2.15, 1.95, 1.1, 2.1, id="b"), piece("box", 0.8, 0.5, 1.4, 1.0))
    assert kinds(judge(bed, *squeezed)) == {"unreachable_piece"}


@pytest.mark.parametrize(("depth", "reached"), [(0.19, True), (0.21, False)])
def test_an_arm_reaches_over_what_stands_before(depth, reached):
    """A person of radius 0.3 m comes to 0.3 m from a low box, an arm 0.2 m further."""
    wardrobe = piece("wardrobe", 2, 2.75, 4, 0.5, 2, heading=SOUTH)
    step = piece("box", 2, 2.5 - depth / 2, 4, depth, 0.3, id="step")
    report = judge(wardrobe, step)
    assert report.valid == reached
    assert all(f.other == "step" for f in report.findings)


def test_one_walks_beneath_what_hangs_high():
    wardrobe = piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=SOUTH)
    shelf = piece("picture", 2, 1.2, 0.8, 4.0, 0.3, z=2.0, heading=EAST, id="shelf")
    assert not judge(wardrobe, shelf).of("unreachable_piece")
    low = replace(shelf, pose=shelf.pose._replace(z=1.9))
    assert judge(wardrobe, low).of("unreachable_piece")


def test_chairs_move_aside_and_tall_gaps_do_not():
    row = piece("chair", 1.8, 1.2, 3.6, 0.5)
    wardrobe = piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=SOUTH)
    assert judge(row, wardrobe).valid
    assert not judge(replace(row, category="box"), wardrobe).valid


def two_rooms(between: tuple[Opening, ...]) -> tuple[Space, ...]:
    """Room a (4 x 3) with the entrance and room b (3 x 3) east of it, beyond a wall of 0.1 m."""
    return (
        room(openings=(door(2.0, -0.05), *between)),
        Space("b", "b", ("other",), "0", rectangle(4.1, 0, 7, 3), openings=between),
    )


def test_rooms_behind_a_row_cannot_be_reached():
    joined = two_rooms((door(4.05, 1.5, (0, 1), id="inner", spaces=("a", "b")),))
    far = piece("wardrobe", 6.5, 1.5, 1, 1, 2, heading=WEST, space="b")
    assert judge(far, spaces=joined).valid
    row = piece("box", 3.2, 1.5, 0.2, 3.0, id="row")
    (found,) = judge(far, row, spaces=joined).findings
    assert (found.kind, found.space, found.other) == ("unreachable_room", "b", "row")


def test_a_toilet_may_be_used_sideways_but_not_through_a_gap_of_a_hand():
    """In 0.8 x 1.3 m a disc of 0.6 m cannot turn to the toilet from a door at the side."""
    side = door(-0.05, 1.0, (0, 1), width=0.6)
    closet = room(outline=rectangle(0, 0, 0.8, 1.3), openings=(side,))
    toilet = piece("wardrobe", 0.4, 0.33, 0.4, 0.66, 0.8)
    assert judge(toilet, spaces=(closet,)).valid
    longer = piece("wardrobe", 0.4, 0.475, 0.4, 0.95, 0.8)
    assert "unreachable_room" in kinds(judge(longer, spaces=(closet,)))
    wide = room(outline=rectangle(0, 0, 3, 1.3), openings=(side,))
    row = piece("box", 1.8, 0.65, 0.6, 1.3, id="row")
    beyond = piece("wardrobe", 2.7, 0.65, 0.5, 0.5, heading=WEST)
    assert judge(row, beyond, spaces=(wide,)).of("unreachable_piece")


def test_what_stands_on_a_blocker_is_not_blamed():
    row = piece("box", 2, 1.2, 4, 0.5, id="row")
    lamp = piece("lamp", 2, 1.2, 0.2, 0.2, 0.4, z=1.0, on="row")
    wardrobe = piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=SOUTH)
    (found,) = judge(row, lamp, wardrobe).findings
    assert found.other == "row"


def test_pieces_that_block_together_are_named_together():
    first, second = piece("box", 2, 0.9, 4, 0.2, id="p"), piece("box", 2, 1.9, 4, 0.2, id="q")
    wardrobe = piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=SOUTH)
    (found,) = judge(first, second, wardrobe).findings
    assert set(found.other.split(",")) == {"p", "q"}
    assert " and " in found.message


def test_a_narrow_door_still_lets_through_and_a_wall_does_not():
    narrow = two_rooms((door(4.05, 1.5, (0, 1), id="inner", width=0.5, spaces=("a", "b")),))
    far = piece("wardrobe", 6.5, 1.5, 1, 1, 2, heading=WEST, space="b")
    assert judge(far, spaces=narrow).valid
    # Its front is 5 cm from the wall: nobody reaches through the wall from the other room.
    hidden = piece("wardrobe", 4.4, 0.5, 1, 0.5, 2, heading=WEST, space="b")
    assert kinds(judge(hidden, spaces=narrow)) == {"unreachable_piece"}


def test_rooms_without_any_way_in_are_entered_somewhere():
    sealed = room(openings=())
    assert judge(piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=SOUTH), spaces=(sealed,)).valid


def test_navigable_share_is_the_largest_part():
    """A box cuts 4 x 3 m into strips 1.5 and 0.9 m wide: (1.1 x 2.6) and (0.5 x 2.6) for 0.2 m."""
    report = judge(piece("box", 2.3, 1.5, 1.6, 3.0, id="wall"), spaces=(room(openings=()),))
    assert report.figures["navigable_share"]["0"] == pytest.approx(1.1 / 1.6, abs=1e-3)
    assert report.figures["rooms"]["a"] == {"pieces": 1, "area": 12.0, "density": 0.4}


def test_what_bars_the_way_in_leaves_nothing_reachable():
    """All the free floor hangs together, yet a row of boxes before the door lets nobody in."""
    row = piece("box", 2, 0.26, 4, 0.5, fixed=True)
    shut, aside = judge(row).figures, judge(piece("box", 0.6, 0.26, 1.2, 0.5)).figures
    assert shut["navigable_share"]["0"] > 0.9
    assert shut["reachable_share"]["0"] == 0.0
    assert aside["reachable_share"]["0"] == judge().figures["reachable_share"]["0"] == 1.0
    cut = judge(piece("box", 2, 1.5, 4.0, 0.6)).figures["reachable_share"]["0"]
    assert cut == pytest.approx(0.5, abs=0.02)


def test_a_room_without_a_door_is_noted():
    sealed = room(openings=(door(2.0, -0.05, kind="window"),), functions=("study",))
    report = judge(spaces=(sealed,))
    assert report.notes[0].missing == "a door"
    assert report.figures["reachable_share"]["0"] == 0.0
    small = replace(sealed, outline=rectangle(0, 0, 1.0, 1.0))
    for harmless in (room(functions=("study",)), replace(sealed, functions=("other",)), small):
        assert "a door" not in {note.missing for note in judge(spaces=(harmless,)).notes}
    stairs = judge(piece("staircase", 1, 2), spaces=(sealed,))
    assert "a door" not in {note.missing for note in stairs.notes}
    assert stairs.figures["reachable_share"]["0"] == 1.0
