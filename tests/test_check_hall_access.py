"""The referee on what can be reached in a hall."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.judged_halls import (
    CATALOG,
    WEST,
    answer,
    box,
    group,
    hall_brief,
    judge,
    kinds,
    piece,
    wall,
    zone,
)

from hall_floors import EAST_DOOR, SOUTH_DOOR, figures, two_zones
from scenewright.core.catalog import Catalog
from scenewright.core.kind import Kind
from scenewright.domains import check


def ring(radius: float = 1.5, centre=(9.0, 3.0)):
    """Partitions round a square, closed."""
    x, y = centre
    corners = [
        (x - radius, y - radius),
        (x + radius, y - radius),
        (x + radius, y + radius),
        (x - radius, y + radius),
    ]
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
        piece("theatre_seat", x, 1.5 + pitch * k, 0.55, 0.5, 0.9)
        for k in range(4)
        for x in np.arange(6.4, 11.8, 0.55)
    ]
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
