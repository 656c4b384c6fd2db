"""The referee on hand-made rooms: each rule just inside and just outside its tolerance."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from scenewright.brief import Brief
from scenewright.catalog import Catalog, Kind
from scenewright.check import Report, check
from scenewright.scene import Piece, Pose, Size
from scenewright.solution import Solution
from scenewright.space import Opening, Space

NORTH, SOUTH, EAST, WEST = math.pi / 2, -math.pi / 2, 0.0, math.pi

CATALOG = Catalog(
    {
        kind.category: kind
        for kind in (
            Kind("box"),
            Kind("wardrobe", access=("front",)),
            Kind("bed", access=("left", "right")),
            Kind("rug", flat=True),
            Kind("table"),
            Kind("chair", under=("table",)),
            Kind("hob", support="top", under=("counter",)),
            Kind("counter"),
            Kind("lamp", support="top"),
            Kind("pendant", support="ceiling"),
            Kind("picture", support="wall"),
            Kind("curtain", support="wall"),
        )
    }
)


def rectangle(x0: float, y0: float, x1: float, y1: float) -> np.ndarray:
    return np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]], float)


def door(x: float, y: float, u: tuple[float, float] = (1, 0), **more) -> Opening:
    wanted = {"width": 0.9, "thickness": 0.1, "sill": 0.0, "head": 2.05, "spaces": ("a",)}
    return Opening(more.pop("id", "door"), more.pop("kind", "door"), "0", x, y, *u, **wanted | more)


def room(**more) -> Space:
    """A room 4 m by 3 m with its door in the middle of the south wall."""
    entrance = door(2.0, -0.05)
    wanted = {"outline": rectangle(0, 0, 4, 3), "openings": (entrance,), "functions": ("other",)}
    return Space("a", "a", level="0", **wanted | more)


def piece(
    category: str, x: float, y: float, w: float = 1.0, d: float = 1.0, h: float = 1.0, **more
) -> Piece:
    z, heading = more.pop("z", 0.0), more.pop("heading", NORTH)
    named = more.pop("id", f"{category}@{x:g},{y:g}")
    pose, size, space = Pose(x, y, z, heading), Size(w, d, h), more.pop("space", "a")
    return Piece(named, category, "", space, pose, size, **more)


def judge(*pieces: Piece, spaces: tuple[Space, ...] | None = None, route: float = 0.6) -> Report:
    brief = Brief.model_validate(
        {"rooms": [{"outline": [[0, 0], [4, 0], [4, 3]]}], "route_width": route}
    )
    solution = Solution(brief, pieces, (), (), (), {}, "", "", 0, "", "", 0.0, 0)
    return check(solution, spaces=spaces or (room(),), catalog=CATALOG)


def kinds(report: Report) -> set[str]:
    return {found.kind for found in report.findings}


def test_an_empty_room_is_valid():
    report = judge()
    assert report.valid
    assert str(report) == "valid"
    assert report.figures["navigable_share"] == {"0": 1.0}


@pytest.mark.parametrize(("gap", "found"), [(0.0, set()), (-0.009, set()), (-0.011, {"collision"})])
def test_collision_tolerance(gap, found):
    assert kinds(judge(piece("box", 0.5, 2.5), piece("box", 1.5 + gap, 2.5))) == found


@pytest.mark.parametrize(("z", "found"), [(0.98, {"collision", "sunk"}), (0.995, set())])
def test_heights_part_pieces(z, found):
    table, lamp = piece("table", 1, 2, id="t"), piece("lamp", 1, 2, 0.2, 0.2, 0.4, z=z, on="other")
    report = judge(table, lamp, piece("box", 3, 2, id="other"))
    assert ("collision" in kinds(report)) == ("collision" in found)


def test_collision_tells_depth_area_and_names():
    (found,) = judge(piece("box", 0.5, 2.5, id="p"), piece("box", 1.3, 2.25, id="q")).findings
    assert (found.piece, found.other) == ("p", "q")
    assert found.amount == pytest.approx(0.2)
    assert found.area == pytest.approx(0.2 * 0.75)
    assert "0.20 m" in found.message


def test_rugs_and_curtains_collide_with_nothing():
    rug = piece("rug", 2, 2, 2, 1.5, 0.02)
    curtain = piece("curtain", 1, 2.95, 1.5, 0.1, 2.3, heading=SOUTH)
    assert judge(rug, curtain, piece("box", 1, 2.5)).valid
    assert not judge(piece("rug", 2, 2, 1, 1, 0.5), piece("box", 2, 2)).valid


@pytest.mark.parametrize(("out", "valid"), [(0.5, True), (0.10, True), (0.03, False)])
def test_a_chair_goes_under_its_table_but_not_its_back(out, valid):
    """The chair faces the table; ``out`` is how far its back end stays outside."""
    table = piece("table", 2, 2, 1.4, 0.8, 0.75)
    chair = piece("chair", 2, 1.6 - out + 0.25, 0.45, 0.5, 0.9, heading=NORTH)
    assert judge(table, chair).valid == valid


def test_a_chair_goes_under_nothing_else_and_a_hob_into_its_counter():
    assert "collision" in kinds(judge(piece("box", 2, 2), piece("chair", 2, 1.5, 0.4, 0.4)))
    counter, hob = piece("counter", 2, 2.7, 2, 0.6, 0.9), piece("hob", 2, 2.7, 0.6, 0.5, 0.06)
    assert judge(counter, replace(hob, pose=hob.pose._replace(z=0.88), on=counter.id)).valid


def test_what_stands_on_another_is_no_collision_but_must_not_sink():
    table = piece("table", 2, 2, h=0.7, id="t")
    lamp = piece("lamp", 2, 2, 0.2, 0.2, 0.4, z=0.685, on="t", id="l")
    assert judge(table, lamp).valid
    assert kinds(judge(table, replace(lamp, pose=lamp.pose._replace(z=0.6)))) == {"sunk"}
    assert kinds(judge(table, replace(lamp, pose=lamp.pose._replace(z=0.73)))) == {"floating"}
    assert kinds(judge(table, replace(lamp, pose=Pose(2.52, 2, 0.7, 0)))) == {"floating"}
    assert kinds(judge(lamp)) == {"floating"}


@pytest.mark.parametrize(("x", "found"), [(0.5, set()), (0.491, set()), (0.489, {"out_of_bounds"})])
def test_out_of_bounds_tolerance(x, found):
    assert kinds(judge(piece("box", x, 2.4))) == found


def test_holes_ceilings_and_corners_are_out_of_bounds():
    column = (rectangle(1, 1, 1.4, 1.4)[::-1],)
    pillar = room(holes=column)
    assert kinds(judge(piece("box", 1.95, 2.1), spaces=(pillar,))) == set()
    (found,) = judge(piece("box", 1.2, 1.6, 0.2, 0.6), spaces=(pillar,)).findings
    assert found.kind == "out_of_bounds"
    (found,) = judge(piece("box", 1, 2, h=2.62)).findings
    assert found.kind == "out_of_bounds"
    assert found.amount == pytest.approx(0.02)
    corner = room(outline=np.array([[0, 0], [4, 0], [4, 1.5], [2, 1.5], [2, 3], [0, 3]], float))
    assert kinds(judge(piece("box", 2, 2), spaces=(corner,))) == {"out_of_bounds"}


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
    assert report.valid


def test_one_chair_is_not_enough_for_a_table():
    dining = room(functions=("dining",))
    table = piece("dining_table", 2, 2)
    one, two = piece("dining_chair", 0.5, 2, 0.4, 0.4), piece("dining_chair", 3.5, 2, 0.4, 0.4)
    assert [n.missing for n in judge(table, one, spaces=(dining,)).notes] == ["two chairs"]
    assert judge(table, one, two, spaces=(dining,)).notes == ()


def test_every_essential_names_kinds_of_the_catalog():
    from scenewright.assets.kinds import KINDS
    from scenewright.check import ESSENTIALS, USABLE

    assert set(ESSENTIALS) == set(USABLE)
    for needs in ESSENTIALS.values():
        for need in needs:
            assert need.categories <= set(KINDS), need
