"""The referee on hand-made halls: what is narrow, outside, closed off or seen; measures."""

from __future__ import annotations

import json
import math
import time
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.judged_halls import (
    CATALOG,
    EAST,
    NORTH,
    SOUTH,
    WEST,
    answer,
    box,
    group,
    hall_brief,
    judge,
    kinds,
    piece,
    tour,
    turned,
    wall,
    zone,
)

from scenewright.catalog import Catalog, Kind
from scenewright.check import check
from scenewright.check.escape import walking_distance
from scenewright.check.measures import aesthetic, circulation, principal_direction
from scenewright.check.passages import clear_width
from scenewright.scene_graph import Layer, Part, PlacedGroup, SceneGraph, Tour, Zone, ZoneLink

SOUTH_DOOR = {"at": [3, 0], "width": 1.6, "swing": "none"}
EAST_DOOR = {"at": [12, 3], "width": 1.6, "swing": "none", "use": "exit"}
WEST_ZONE, EAST_ZONE = zone("west", box(0, 0, 6, 6)), zone("east", box(6, 0, 12, 6))


def two_zones(*pieces, width=1.2, groups=(), tours=(), **more):
    """A hall 12 m by 6 m of two linked zones, entered from the south, left to the east."""
    brief = hall_brief(box(0, 0, 12, 6), (SOUTH_DOOR, EAST_DOOR), **more)
    links = (("west", "east", width),)
    return answer(brief, pieces, (WEST_ZONE, EAST_ZONE), links, groups, tours)


def gap(width: float):
    """Partitions along the border that leave a gap from y = 2 on."""
    return wall(6, 0, 6, 2), wall(6, 2 + width, 6, 6)


def figures(report):
    return report.figures["halls"]["h"]


@pytest.mark.parametrize(
    ("width", "found"), [(1.21, set()), (1.195, set()), (1.19, {"narrow_passage"})]
)
@pytest.mark.parametrize("angle", [0.0, 0.7])
def test_a_gap_in_a_partition_has_its_width(width, found, angle):
    report = judge(turned(two_zones(*gap(width)), angle, (20.0, -5.0)))
    assert kinds(report) == found
    assert figures(report)["passages"][0]["clear"] == pytest.approx(width, abs=0.012)


def test_a_narrow_passage_says_where_and_what_is_missing():
    (found,) = judge(two_zones(*gap(0.8))).findings
    assert found.amount == pytest.approx(0.4, abs=0.012)
    assert sorted(found.other.split(",wall")) == ["@6,2.8", "wall@6,0"]
    for word in ("west", "east", "1.20 m", "wall@6,0", "wall@6,2.8"):
        assert word in found.message
    x, y = figures(judge(two_zones(*gap(0.8))))["passages"][0]["at"]
    assert (x, y) == (pytest.approx(6, abs=0.11), pytest.approx(2.4, abs=0.02))


def test_a_piece_narrows_a_passage():
    """A gap of 2 m, and behind it a plinth whose corner comes within 1.10 m of the partition's."""
    behind = piece("plinth", 6.5, 4.05, 0.6, 1.9)
    report = judge(two_zones(*gap(2.0), behind))
    passage = figures(report)["passages"][0]
    assert kinds(report) == {"narrow_passage"}
    assert passage["clear"] == pytest.approx(math.hypot(0.1, 1.1), abs=0.012)
    assert {"plinth@6.5,4.05", "wall@6,0"} == set(passage["message"].split()) - {"between", "and"}


def test_a_partition_across_closes_the_passage():
    report = judge(two_zones(wall(6, 0, 6, 6)))
    found = report.of("narrow_passage")[0]
    assert found.amount == 1.2
    assert "closed" in found.message
    assert "wall@6,0" in found.message
    assert figures(report)["passages"][0]["clear"] == 0


def test_the_floor_of_no_zone_is_a_way_round():
    brief = hall_brief(box(0, 0, 12, 6), (SOUTH_DOOR,))
    zones = zone("west", box(0, 0, 6, 4)), zone("east", box(6, 0, 12, 4))
    around = answer(brief, (wall(6, 0, 6, 4),), zones, (("west", "east", 1.2),))
    assert not kinds(judge(around))
    third = (*zones, zone("north", box(0, 4, 12, 6)))
    assert kinds(judge(replace(around, graph=around.graph._replace(zones=third)))) == {
        "narrow_passage"
    }


def test_a_link_of_the_brief_counts_even_if_the_graph_lacks_it():
    outlines = [
        {"id": "west", "outline": box(0, 0, 6, 6)},
        {"id": "east", "outline": box(6, 0, 12, 6)},
    ]
    asked = {"zones": outlines, "links": [{"between": ["west", "east"]}], "passage_width": 1.5}
    closed = two_zones(*gap(1.4), **asked)
    silent = replace(closed, graph=closed.graph._replace(links=()))
    assert not kinds(judge(closed))
    assert kinds(judge(silent)) == {"narrow_passage"}
    fixed = tuple(replace(p, fixed=True) for p in silent.pieces)
    assert [f.given for f in judge(replace(silent, pieces=fixed)).findings] == [True]
    drawn_by_us = two_zones(*fixed, width=1.5)
    assert [f.given for f in judge(drawn_by_us).findings] == [False]


def test_links_of_brief_and_graph_are_judged_together():
    """The brief links a to b, the graph b to c; both borders are closed."""
    zones = [zone(n, box(4 * k, 0, 4 * k + 4, 6)) for k, n in enumerate("abc")]
    listed = [{"id": z.id, "outline": z.outline.tolist()} for z in zones]
    asked = {"zones": listed, "links": [{"between": ["a", "b"]}]}
    brief = hall_brief(box(0, 0, 12, 6), (SOUTH_DOOR, EAST_DOOR), **asked)
    walls = wall(4, 1.6, 4, 6), wall(8, 0, 8, 5)
    report = judge(answer(brief, walls, zones, (("b", "c", 1.1),)))
    rows = figures(report)["passages"]
    assert [(r["first"], r["second"], r["needed"]) for r in rows] == [
        ("b", "c", 1.1),
        ("a", "b", 1.2),
    ]
    assert len(report.of("narrow_passage")) == 1


@given(st.lists(st.tuples(st.floats(0, 8), st.floats(0, 3), st.floats(0.2, 1.5)), max_size=8))
@settings(max_examples=30, deadline=None)
def test_clear_width_agrees_with_a_raster(boxes):
    """The widest path over a fine raster: at each point twice the distance to what is nearest."""
    west, east = shapely.box(0, 0, 4, 3), shapely.box(4, 0, 8, 3)
    solid = [shapely.box(x - s / 2, y - s / 2, x + s / 2, y + s / 2) for x, y, s in boxes]
    free = shapely.difference(shapely.box(0, 0, 8, 3), shapely.union_all(solid))
    step = 0.05
    x, y = np.meshgrid(np.arange(step / 2, 8, step), np.arange(step / 2, 3, step), indexing="ij")
    points = shapely.points(x, y)
    room = np.where(shapely.contains(free, points), shapely.distance(points, free.boundary), 0)
    low, high = 0.0, 3.0
    while high - low > 0.02:  # bisect the width with a flood over the raster
        middle = (low + high) / 2
        open_ = room >= middle / 2
        inside = np.where(x < 4, 4 - x, 0) >= middle / 2
        flood = np.where(open_ & inside, 0.0, np.inf)
        reached = np.isfinite(walking_distance(open_, flood, step))
        target = open_ & (np.where(x > 4, x - 4, 0) >= middle / 2)
        low, high = (middle, high) if (reached & target).any() else (low, middle)
    assert clear_width(west, east, free) == pytest.approx(low, abs=0.12)


def test_pieces_of_a_group_stay_in_its_zone():
    inside, over = piece("case", 5.5, 3, 1, 1), piece("case", 5.515, 5, 1, 1)
    grouped = group("h/cases", "west", inside, over)
    report = judge(two_zones(inside, over, groups=(grouped,)))
    (found,) = report.findings
    assert (found.kind, found.piece, found.other) == ("outside_zone", over.id, "west")
    assert found.amount == pytest.approx(0.015)
    nearly = replace(over, pose=over.pose._replace(x=5.508))
    assert judge(two_zones(inside, nearly, groups=(grouped,))).valid


def ring(radius: float = 1.5, centre=(9.0, 3.0)):
    """Partitions round a square, closed."""
    x, y = centre
    corners = [(x - radius, y - radius), (x + radius, y - radius), (x + radius, y + radius),
               (x - radius, y + radius)]  # fmt: skip
    return tuple(wall(*a, *b) for a, b in zip(corners, corners[1:] + corners[:1], strict=True))


def test_a_ring_closes_off_a_group():
    cases = piece("case", 8.6, 3, 0.5, 0.5), piece("plinth", 9.4, 3, 0.5, 0.5)
    grouped = group("h/cases", "east", *cases)
    closed = two_zones(*cases, *ring(), groups=(grouped,), width=0.9)
    report = judge(closed)
    assert [found.kind for found in report.findings] == ["unreachable_group"]
    found = report.findings[0]
    assert found.piece == "h/cases"
    assert "wall@" in found.other
    assert " or " in found.message
    assert figures(report)["wheelchair"] == 0.0
    assert judge(two_zones(*cases, *ring()[1:], groups=(grouped,), width=0.9)).valid


def test_a_group_reached_in_part_is_told_piece_by_piece():
    cases = piece("case", 9.0, 3, 0.5, 0.5), piece("case", 2, 3, 0.5, 0.5)
    grouped = group("h/cases", "east", cases[0]), group("h/all", "", *cases)
    told = judge(two_zones(*cases, *ring(), groups=grouped[1:], width=0.9))
    assert [f.piece for f in told.of("unreachable_piece")] == [cases[0].id]
    assert not told.of("unreachable_group")
    told = judge(two_zones(*cases, *ring(), groups=grouped[:1], width=0.9))
    assert not told.of("unreachable_piece")


@pytest.mark.parametrize(("pitch", "reached"), [(0.95, True), (0.88, False)])
def test_seats_are_reached_sideways_along_their_row(pitch, reached):
    """Rows of seats 0.5 m deep from wall to wall but for an aisle: 0.45 or 0.38 m between them."""
    rows = [
        piece("theatre_seat", x, 1.5 + pitch * k, 0.55, 0.5, 0.9) for k in range(4)
        for x in np.arange(6.4, 11.8, 0.55)
    ]  # fmt: skip
    brief = hall_brief(box(0, 0, 12, 6), (SOUTH_DOOR,))
    seats = group("h/seats", "all", *rows)
    solution = answer(brief, rows, (zone("all", box(0, 0, 12, 6)),), (), (seats,))
    kind = Kind("theatre_seat", access=("front",))
    catalog = Catalog(CATALOG.kinds | {"theatre_seat": kind})
    report = check(solution, catalog=catalog)
    assert report.valid == reached
    cases = Catalog(CATALOG.kinds | {"case": kind})
    shelves = [replace(p, category="case") for p in rows]
    assert not check(replace(solution, pieces=tuple(shelves)), catalog=cases).valid


def test_many_closed_off_pieces_are_told_together():
    """Two nested rings: no single wall would open the way, so all share one set of blockers."""
    cases = [piece("case", 8.9, 2.5 + 0.5 * j, 0.2, 0.2) for j in range(3)]
    rings = *ring(1.3, (8.9, 3.0)), *ring(2.5, (8.9, 3.0))
    told = judge(two_zones(*cases, *rings, width=0.9)).of("unreachable_piece")
    assert len(told) == 3
    assert len({found.other for found in told}) == 1
    assert all(" and " in found.message for found in told)


def test_a_door_that_is_only_an_exit_is_no_way_in():
    """Everything east of a closed wall can be left by the exit, not entered."""
    case = piece("case", 10, 5, 0.5, 0.5)
    shut = two_zones(case, wall(6, 0, 6, 6))
    assert "unreachable_piece" in kinds(judge(shut))
    assert figures(judge(shut))["escape"]["distance"] < 9
    both = hall_brief(box(0, 0, 12, 6), (SOUTH_DOOR, EAST_DOOR | {"use": "both"}))
    assert "unreachable_piece" not in kinds(judge(replace(shut, brief=both)))


def test_what_stands_in_a_door_of_a_hall_blocks_it():
    assert "blocked_door" in kinds(judge(two_zones(piece("plinth", 3, 0.3, 1.4, 0.4))))
    assert "blocked_door" in kinds(judge(two_zones(wall(11.8, 0, 11.8, 6))))


def test_pictures_hang_at_partitions_and_partitions_join():
    panel = wall(6, 1, 6, 4), wall(5, 4, 7, 4)
    hung = piece("picture", 5.88, 2, 0.8, 0.04, 0.6, z=1.2, heading=WEST)
    assert judge(two_zones(*panel, hung)).valid
    away = replace(hung, pose=hung.pose._replace(x=5.8))
    assert kinds(judge(two_zones(*panel, away))) == {"floating"}


def grid(n: int = 2, pitch: float = 2.0, at=(2.0, 2.0), size: float = 1.0):
    return tuple(
        piece("case", at[0] + pitch * i, at[1] + pitch * j, size, size)
        for i in range(n)
        for j in range(n)
    )


def test_measures_of_a_grid_of_four():
    """Two lines each way through the middles, four through the edges; nothing is too close."""
    cases = grid()
    told = figures(judge(two_zones(*cases, groups=(group("h/cases", "west", *cases),))))
    assert told["aesthetic"] == pytest.approx(3 / 8, abs=1e-4)
    assert told["aesthetic_edges"] == pytest.approx(3 / 12, abs=1e-4)
    assert told["circulation"] == told["circulation_all"] == 0
    area = abs(4 / 36 - 4 / 72) + 4 / 72
    assert told["uniformity"] == pytest.approx(area / 2, abs=1e-4)
    assert told["floor_used"] == pytest.approx(4 / 72, abs=1e-4)


def test_two_readings_of_circulation():
    """Side by side 1 cm apart across, 0.4 m apart along; diagonals 0.4 m and a hair."""
    boxes = np.array([shapely.box(x, y, x + 1, y + 1) for x in (0, 1.01) for y in (0, 1.4)])
    diagonal = 0.6 - math.hypot(0.4, 0.01)
    apart, every = circulation(boxes)
    assert apart == pytest.approx(2 * 0.2 + 2 * diagonal)
    assert every == pytest.approx(2 * 0.2 + 2 * diagonal + 2 * 0.59)


def test_uniformity_of_walls():
    """A shelf 3 m long at the west zone's outer wall: 3 m of 14.4 m there, of 33.6 m in all."""
    shelf = piece("shelf", 0.2, 3, 3.0, 0.4, heading=EAST)
    told = figures(judge(two_zones(shelf, groups=(group("h/s", "west", shelf),))))
    lengths = 6 + 6 + 6 - 1.6, 6 + 6 + 6 - 1.6
    area = abs(1.2 / 36 - 1.2 / 72) + 1.2 / 72
    walls = abs(3 / lengths[0] - 3 / sum(lengths)) + 3 / sum(lengths)
    assert told["uniformity"] == pytest.approx((area + walls) / 2, rel=0.02)


@given(st.lists(st.tuples(st.floats(0, 20), st.floats(0, 20)), min_size=1, max_size=12))
def test_alignment_does_not_depend_on_order_or_mirroring(points):
    centres = np.array(points)
    corners = centres[:, None] + np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])[None] / 2
    assert aesthetic(corners, 0.0) == aesthetic(corners[::-1] * [-1, 1], 0.0)
    assert aesthetic(corners, 0.0)[0] >= aesthetic(corners, 0.0)[1]


def test_the_main_walls_give_the_direction():
    bent = shapely.Polygon([(0, 0), (6, 0), (6, 4), (3, 6), (0, 6)])
    assert principal_direction(bent) == pytest.approx(0, abs=1e-9)
    turned_ = principal_direction(shapely.affinity.rotate(bent, 20))
    assert turned_ == pytest.approx(math.radians(20), abs=1e-6)


def long_hall(*pieces, points=((0, 2.5), (19, 2.5), (20, 2.5)), groups=(), doors=None, **more):
    """A hall 20 m by 5 m, entered from the west, left to the east, with a tour along it."""
    ends = (
        {"at": [0, 2.5], "width": 2, "swing": "none"},
        {"at": [20, 2.5], "width": 2, "use": "exit"},
    )
    brief = hall_brief(box(0, 0, 20, 5), ends if doors is None else doors, **more)
    return answer(brief, pieces, (zone("all", box(0, 0, 20, 5)),), (), groups, (tour(*points),))


def test_the_tour_is_measured_again():
    """5 m between the walls, 3 m where a plinth stands 1.5 m from the line, 2 m in the doors."""
    free = figures(judge(long_hall(piece("plinth", 10, 4.5, 1, 1))))["tour"]
    assert free["least_width"] == pytest.approx(2.0)
    assert free["length"] == 20
    assert (free["free"], free["from_entrance"], free["to_exit"]) == (True, True, True)
    assert free["bottlenecks"] == []
    assert figures(judge(long_hall(points=((5, 2.5), (5, 2.5001)))))["tour"]["least_width"] == 5.0


def test_the_tour_tells_where_it_is_narrow_and_between_what():
    pair = piece("plinth", 10, 4, 1, 2), piece("plinth", 10, 1, 1, 2)
    told = figures(judge(long_hall(*pair)))["tour"]
    (place,) = told["bottlenecks"]
    assert place["width"] == pytest.approx(1.0, abs=1e-3)
    assert place["at"] == [pytest.approx(10, abs=0.6), 2.5]
    assert set(place["between"]) == {p.id for p in pair}
    assert "1.00 m between plinth@10," in place["message"]
    assert told["free"]


def test_a_tour_through_a_piece_is_not_free():
    told = figures(judge(long_hall(piece("plinth", 10, 2.5, 1, 1))))["tour"]
    assert (told["free"], told["least_width"]) == (False, 0)
    astray = figures(judge(long_hall(points=((0, 2.5), (10, 9), (20, 2.5)))))["tour"]
    assert not astray["free"]
    backwards = figures(judge(long_hall(points=((20, 2.5), (0, 2.5)))))["tour"]
    assert (backwards["from_entrance"], backwards["to_exit"]) == (False, True)
    middle = figures(judge(long_hall(points=((5, 2.5), (15, 2.5)))))["tour"]
    assert (middle["from_entrance"], middle["to_exit"]) == (False, False)


def test_what_is_passed_and_seen():
    """One case beside the tour, one behind partitions, one shelf that shows its back."""
    beside, behind = piece("case", 5, 4.5, 0.5, 0.5), piece("case", 10, 4.6, 0.5, 0.5)
    turned_away = piece("shelf", 15, 4.5, 1, 0.5, heading=NORTH)
    screens = wall(9, 4.1, 11, 4.1), wall(9, 4.1, 9, 5), wall(11, 4.1, 11, 5)
    cases = beside, behind, turned_away
    groups = tuple(group(f"h/{k}", "all", case) for k, case in enumerate(cases))
    told = figures(judge(long_hall(*cases, *screens, groups=groups)))["tour"]
    assert told["traversal"] == told["seen"] == pytest.approx(1 / 3, abs=1e-4)
    assert told["groups_missed"] == ["h/1", "h/2"]
    assert told["unseen"] == [behind.id, turned_away.id]
    low = tuple(replace(s, size=s.size._replace(height=1.2)) for s in screens)
    assert figures(judge(long_hall(*cases, *low, groups=groups)))["tour"]["seen"] < 0.4
    low = tuple(replace(s, category="plinth", size=s.size._replace(height=1.2)) for s in screens)
    assert figures(judge(long_hall(*cases, *low, groups=groups)))["tour"]["seen"] > 0.6
    far = ((0, 2.5), (1.6, 2.5))
    told = figures(judge(long_hall(*cases[:1], groups=groups[:1], points=far)))["tour"]
    assert (told["traversal"], told["seen"]) == (0.0, 1.0)


def test_the_way_out_is_walked_not_flown():
    """From behind a partition across all but 1 m of a hall, round its end."""
    only = ({"at": [0, 1], "width": 1.6, "swing": "none"},)
    straight = figures(judge(long_hall(doors=only)))["escape"]
    corner = math.hypot(20 - 0.2, 5 - 0.2 - 1)
    assert straight["distance"] == pytest.approx(corner, rel=0.035)
    assert straight["distance"] > corner - 0.5
    around = figures(judge(long_hall(wall(10, 0, 10, 4), doors=only)))["escape"]
    bent = math.hypot(10 - 0.1, 4.2 - 1) + 0.2 + math.hypot(9.7, 4)
    assert around["distance"] == pytest.approx(bent, rel=0.04)


def test_nobody_walks_through_a_wall_one_cell_thick():
    free = np.ones((6, 9), bool)
    free[:, 4] = False
    start = np.where((np.arange(9) == 0)[None] & free, 0.0, np.inf)
    assert np.isinf(walking_distance(free, start, 1.0)[:, 5:]).all()
    corner = np.eye(2, dtype=bool)
    from_one = np.array([[0.0, np.inf], [np.inf, np.inf]])
    assert np.isinf(walking_distance(corner, from_one, 1.0)[1, 1])


def test_ways_out_are_notes():
    crowd = judge(long_hall(doors=({"at": [0, 2.5], "width": 1.0},), people=250))
    assert crowd.valid
    assert [note.function for note in crowd.notes] == ["narrow_exits", "narrow_exits"]
    assert figures(crowd)["escape"]["exit_width_needed"] == 1.25
    far = hall_brief(box(0, 0, 60, 5), ({"at": [0, 2.5], "width": 1.0},), people=40)
    report = judge(answer(far))
    assert [note.function for note in report.notes] == ["long_escape"]
    assert figures(report)["escape"]["distance"] == pytest.approx(60, abs=1.5)


def test_a_wheelchair_turns_where_a_circle_can_be_rolled_into():
    """West is open; east is a closet 0.7 m deep; behind a gap of 0.8 m nobody comes at all."""
    free = figures(judge(two_zones()))
    assert free["turning"] == {"west": True, "east": True}
    narrow = judge(two_zones(piece("plinth", 9.35, 3, 5.3, 6), width=1.0))
    assert figures(narrow)["turning"] == {"west": True, "east": False}
    assert figures(judge(two_zones(*gap(0.8), width=0.7)))["turning"] == {
        "west": True,
        "east": False,
    }
    assert figures(judge(two_zones(*gap(1.0), width=0.7)))["turning"] == {
        "west": True,
        "east": True,
    }


FULL = two_zones(
    *gap(1.1), *grid(2, 2.0, (1.5, 2.0)), piece("case", 11.4, 4.9, 0.8, 0.8, heading=EAST),
    piece("shelf", 8, 5.7, 2, 0.4, 1.8, heading=SOUTH),
    groups=(
        group("h/cases", "west", *grid(2, 2.0, (1.5, 2.0))),
        group("h/shelf", "east", piece("shelf", 8, 5.7, 2, 0.4)),
        group("h/odd", "west", piece("case", 11.4, 4.9, 1, 1)),
    ),
    tours=(tour((3, 0), (2.5, 3), (6, 2.5), (9, 3), (12, 3)),),
)  # fmt: skip


def flat(value):
    """All numbers of nested figures, in order."""
    if isinstance(value, dict):
        return [
            n for key, part in value.items() if key not in ("at", "message") for n in flat(part)
        ]
    if isinstance(value, list):
        return [n for part in value for n in flat(part)]
    return [float(value)] if isinstance(value, (int, float)) else []


@pytest.mark.parametrize("angle", [0.4, math.pi / 2, 2.5])
def test_turning_a_hall_changes_nothing(angle):
    before, after = judge(FULL), judge(turned(FULL, angle, (30.0, -12.0)))
    assert [(f.kind, f.piece) for f in before.findings] == [
        (f.kind, f.piece) for f in after.findings
    ]
    assert {f.kind for f in before.findings} >= {"narrow_passage", "outside_zone"}
    out = [figures(report)["escape"].pop("distance") for report in (before, after)]
    assert out[0] == pytest.approx(out[1], rel=0.03, abs=0.4)  # a raster of 0.25 m
    assert flat(figures(before)) == pytest.approx(flat(figures(after)), rel=1e-3, abs=0.015)


def test_renaming_changes_only_names():
    def new(name):
        return f"x{name}" if name else name

    graph = FULL.graph
    renamed = replace(
        FULL,
        pieces=tuple(replace(p, id=new(p.id)) for p in FULL.pieces),
        graph=graph._replace(
            zones=tuple(z._replace(id=new(z.id)) for z in graph.zones),
            links=tuple(k._replace(first=new(k.first), second=new(k.second)) for k in graph.links),
            groups=tuple(
                g._replace(id=new(g.id), zone=new(g.zone), objects=tuple(map(new, g.objects)))
                for g in graph.groups
            ),
        ),
    )
    before, after = judge(FULL), judge(renamed)
    assert flat(figures(before)) == flat(figures(after))
    assert [(f.kind, f.amount) for f in before.findings] == [
        (f.kind, f.amount) for f in after.findings
    ]


def test_what_the_graph_names_has_to_be_there():
    case = piece("case", 2, 3, 1, 1)
    graph = SceneGraph(
        zones=(
            WEST_ZONE,
            WEST_ZONE,
            zone("line", [[0, 0], [1, 1], [2, 2]]),
            zone("z", box(0, 0, 1, 1), "?"),
        ),
        links=(ZoneLink("h", "west", "nowhere", 1.2), ZoneLink("h", "west", "west", 1.2)),
        groups=(
            group("a", "nowhere", case),
            group("b", "west", case, replace(case, id="gone")),
            group("c", "west", case, space="?"),
        ),
    )
    report = judge(replace(two_zones(case), graph=graph))
    told = [found.message for found in report.of("malformed")]
    assert len(told) == len(report.findings) == 8
    for word in ("there twice", "no floor", "zone nowhere is not there", "cannot be judged",
                 "in zone nowhere", "names gone", "no room"):  # fmt: skip
        assert [m for m in told if word in m], word


odd = st.one_of(st.floats(-5, 15), st.sampled_from([0.0, 1e-9, 1e4, 6.0]), st.floats())
rings = st.lists(st.tuples(odd, odd), max_size=6)
names = st.sampled_from(["a", "b", "?", ""])


zones_ = st.lists(st.tuples(names, rings, rings), max_size=4)
links_ = st.lists(st.tuples(names, names, odd), max_size=3)
groups_ = st.lists(st.tuples(names, st.lists(names, max_size=3)), max_size=3)


@given(zones_, links_, groups_, rings)
@settings(max_examples=60, deadline=None)
def test_nothing_a_graph_or_tour_holds_raises(zones, links, groups, points):
    """However odd the scene graph and the tour are, there is a report that JSON can hold."""
    pieces = (piece("case", 3, 3, 1, 1, id="a"), piece("partition", 6, 3, 1, 0.2, id="b"))
    part = (Part("grid", (Layer(1, math.nan, 1.0),)),)
    graph = SceneGraph(
        tuple(Zone(n, n, "h", np.array(o), (np.array(i),)) for n, o, i in zones),
        tuple(ZoneLink("h", *link) for link in links),
        tuple(PlacedGroup(z, z, "h", z, "?", (0, 0, 0), part, tuple(o)) for z, o in groups),
        ("?",),
    )
    tours = (
        Tour("h", np.array(points), np.ones(1), ()),
        Tour("?", np.zeros((2, 2)), np.ones(2), ()),
    )
    report = judge(replace(two_zones(*pieces), graph=graph, tours=tours))
    json.dumps(report.to_dict(), allow_nan=False)
    assert str(report)


def test_a_home_has_no_halls():
    assert "halls" not in judge(replace(FULL, graph=None)).figures


@pytest.mark.slow
def test_two_thousand_pieces_are_judged_quickly():
    """About 2.5 s of one core; the limit leaves room for a slower machine."""
    cases = [
        piece("case", 2 + 2 * i, 2 + 1.8 * j, 1, 0.6, 1.8) for i in range(50) for j in range(40)
    ]
    brief = hall_brief(box(0, 0, 104, 76), ({"at": [52, 0], "width": 2, "swing": "none"},))
    zones = [zone(f"z{k}", box(26 * k, 0, 26 * k + 26, 76)) for k in range(4)]
    groups = [group(f"g{k}", f"z{k}", *cases[k * 480 : k * 480 + 400]) for k in range(4)]
    lanes = [(x, 2.9 + 1.8 * j) for j in range(0, 40, 2) for x in ((1, 103) if j % 4 else (103, 1))]
    links = [(f"z{k}", f"z{k + 1}", 1.2) for k in range(3)]
    solution = answer(brief, cases, zones, links, groups, (tour((52, 0), *lanes),))
    start = time.process_time()
    report = judge(solution)
    assert time.process_time() - start < 10
    assert figures(report)["objects"] == 1600
