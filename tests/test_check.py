"""The referee on hand-made rooms: what hangs, what was given, what a room lacks; turned worlds."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from judged_rooms import NORTH, SOUTH, door, judge, kinds, piece, rectangle, room
from scenewright.core.scene import Piece, Pose
from scenewright.core.space import Opening


def test_an_empty_room_is_valid():
    report = judge()
    assert report.valid
    assert str(report) == "valid"
    assert report.figures["navigable_share"] == {"0": 1.0}


def test_things_hang_where_they_can():
    picture = piece("picture", 2, 2.98, 1, 0.04, 0.6, z=1.4, heading=SOUTH)
    assert judge(picture).valid
    assert kinds(judge(replace(picture, pose=Pose(2, 2.9, 1.4, SOUTH)))) == {"floating"}
    assert kinds(judge(replace(picture, pose=Pose(2, 2.98, 1.4, NORTH)))) == set()
    pendant = piece("pendant", 2, 2, 0.4, 0.4, 0.5, z=2.1)
    assert judge(pendant).valid
    assert kinds(judge(replace(pendant, pose=Pose(2, 2, 2.05, 0)))) == {"floating"}
    assert kinds(judge(piece("box", 2, 2, z=0.03))) == {"floating"}
    assert kinds(judge(piece("box", 2, 2, z=-0.03))) == {"sunk"}


@pytest.mark.parametrize(
    "broken",
    [
        piece("box", math.nan, 1),
        piece("box", 1, 1, z=math.inf),
        piece("box", 1, 1, 0.0),
        piece("box", 1, 1, d=-1.0),
        piece("box", 1, 1, h=0.0),
        piece("box", 1, 1, space="nowhere"),
        piece("box", 1e300, 1),
    ],
)
def test_broken_pieces_are_told(broken):
    report = judge(broken, piece("box", 1, 2))
    assert kinds(report) == {"malformed"}
    json.dumps(report.to_dict(), allow_nan=False)


def test_what_was_given_is_told_but_not_blamed():
    given = (piece("box", 1, 2, fixed=True), piece("box", 1.5, 2, fixed=True))
    report = judge(*given)
    assert kinds(report) == {"collision"}
    assert report.valid
    assert not judge(given[0], replace(given[1], fixed=False)).valid


def messy() -> tuple[Piece, ...]:
    """A few pieces with some of every fault."""
    return (
        piece("box", 0.5, 2.5, id="p"),
        piece("box", 1.3, 2.3, id="q", heading=0.4),
        piece("table", 2.0, 0.5, id="r", h=0.7),
        piece("lamp", 2.0, 0.6, 0.2, 0.2, 0.3, z=0.8, on="r", id="s"),
        piece("wardrobe", 3.7, 2.6, 1.0, 0.6, 2.0, id="t", heading=NORTH),
        piece("rug", 2.0, 1.5, 1.5, 1.0, 0.01, id="u"),
    )


def turned(pieces, spaces, angle: float, dx: float, dy: float):
    cos, sin = math.cos(angle), math.sin(angle)
    spin = np.array([[cos, sin], [-sin, cos]])

    def move(opening: Opening) -> Opening:
        x, y = np.array([opening.x, opening.y]) @ spin + [dx, dy]
        ux, uy = np.array([opening.ux, opening.uy]) @ spin
        return replace(opening, x=x, y=y, ux=ux, uy=uy)

    def shift(p: Piece) -> Piece:
        x, y = np.array(p.pose[:2]) @ spin + [dx, dy]
        return replace(p, pose=Pose(x, y, p.pose.z, p.pose.heading + angle))

    moved = tuple(
        replace(s, outline=s.outline @ spin + [dx, dy], openings=tuple(map(move, s.openings)))
        for s in spaces
    )
    return tuple(map(shift, pieces)), moved


@pytest.mark.parametrize("angle", [math.pi / 2, math.pi, 0.3, 2.5])
def test_moving_and_turning_the_world_changes_nothing(angle):
    spaces = (room(openings=(door(2.0, -0.05, hinge=-1, swing=1),)),)
    before = judge(*messy(), spaces=spaces)
    pieces, moved = turned(messy(), spaces, angle, 31.0, -7.5)
    after = judge(*pieces, spaces=moved)
    assert len(before.findings) >= 4
    told = [[(f.kind, f.piece, f.other) for f in r.findings] for r in (before, after)]
    assert told[0] == told[1]
    assert [f.amount for f in after.findings] == pytest.approx(
        [f.amount for f in before.findings], abs=2e-3
    )
    shares = [r.figures["navigable_share"]["0"] for r in (before, after)]
    assert shares[0] == pytest.approx(shares[1], abs=2e-3)


def test_names_and_order_do_not_matter():
    def renamed(p: Piece) -> Piece:
        return replace(p, id=f"x{p.id}", space="z", on=p.on and f"x{p.on}")

    before = judge(*messy())
    space = replace(room(), id="z", openings=(door(2.0, -0.05, spaces=("z",)),))
    after = judge(*map(renamed, reversed(messy())), spaces=(space,))
    assert sorted(f.kind for f in before.findings) == sorted(f.kind for f in after.findings)
    assert {f.piece for f in after.findings} | {f.other for f in after.findings} >= {"xp", "xq"}


def test_levels_do_not_meet():
    upper = replace(room(), id="up", level="1", openings=())
    pieces = piece("box", 1, 2), piece("box", 1, 2, space="up", id="v")
    assert judge(*pieces, spaces=(room(), upper)).valid


def test_a_usable_room_is_told_what_it_lacks():
    bedroom = room(functions=("bedroom",))
    assert {n.missing for n in judge(spaces=(bedroom,)).notes} == {"bed", "wardrobe"}
    small = room(functions=("bedroom",), outline=rectangle(0, 0, 2.4, 1.5))
    assert judge(spaces=(small,)).notes == ()
    bed = piece("single_bed", 0.5, 2.0, 0.9, 2.0, 0.5)
    report = judge(bed, spaces=(bedroom,))
    assert {n.missing for n in report.notes} == {"wardrobe"}
    assert kinds(report) == {"missing"}


def test_one_chair_is_not_enough_for_a_table():
    dining = room(functions=("dining",))
    table = piece("dining_table", 2, 2)
    one, two = piece("dining_chair", 0.5, 2, 0.4, 0.4), piece("dining_chair", 3.5, 2, 0.4, 0.4)
    assert [n.missing for n in judge(table, one, spaces=(dining,)).notes] == ["two chairs"]
    assert judge(table, one, two, spaces=(dining,)).notes == ()


def test_every_essential_is_served_by_some_kind():
    from scenewright.building.room_needs import ESSENTIALS, USABLE
    from scenewright.catalog.kinds import KINDS

    assert set(ESSENTIALS) == set(USABLE)
    served = {name for kind in KINDS.values() for name in kind.essential}
    assert served == {need.name for needs in ESSENTIALS.values() for need in needs}
