"""The referee of villages on houses placed by hand, whose truth is known."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Patch, Solution
from scenewright.domains import plan_of

SOUTH = -math.pi / 2


def house(name: str, x: float, y: float, w=10.0, d=8.0, heading=SOUTH, **more) -> Piece:
    return Piece(
        f"b/{name}",
        "building",
        "house_rural_gabled",
        "b",
        Pose(x, y, more.pop("z", 0.0), heading),
        Size(w, d, 7.0),
        function=f"House {w:g} x {d:g}",
        **more,
    )


def judged(*pieces: Piece, patches: tuple[Patch, ...] = (), given: bool = False) -> sw.Report:
    outline = [[0, 0], [60, 0], [60, 50], [0, 50]]
    block = {"id": "b", "outline": outline, "streets": [0], "count": 0}
    brief = Brief.model_validate({"domain": "village", "blocks": [block]})
    solved: Solution = sw.solve(brief, plan=plan_of(brief), steps=1)
    block |= {"count": len(pieces), "fixed": [locked(p) for p in pieces] if given else []}
    library = {p.function: of_library(p) for p in pieces}
    houses = [*library.values()]
    brief = Brief.model_validate({"domain": "village", "blocks": [block], "houses": houses})
    return sw.check(replace(solved, brief=brief, pieces=pieces, patches=patches, detail=None))


def of_library(piece: Piece) -> dict[str, object]:
    """A house as the library of a brief has it."""
    width, depth, height = piece.size
    outline = [[0, 0], [width, 0], [width, depth], [0, depth]]
    return {"name": piece.function, "footprint": outline, "height": height}


def locked(piece: Piece) -> dict[str, object]:
    """A house as a brief has it where it stands."""
    keep = {"id": piece.id, "model": piece.asset, "at": piece.pose[:2]}
    return keep | {"heading": piece.pose.heading, "size": piece.size}


def kinds(report: sw.Report) -> list[str]:
    return [found.kind for found in report.findings]


def test_shared_walls_are_no_fault() -> None:
    assert judged(house("a", 10, 10), house("c", 20, 10)).valid


def test_more_than_a_wall_is_an_overlap_of_its_depth() -> None:
    report = judged(house("a", 10, 10), house("c", 19.5, 10))
    assert kinds(report) == ["collision"]
    assert report.findings[0].amount == pytest.approx(0.5)
    assert report.findings[0].area == pytest.approx(4.0)


def test_outside_is_measured() -> None:
    report = judged(house("a", 58, 20))
    assert "out_of_bounds" in kinds(report)
    found = report.of("out_of_bounds")[0]
    assert (found.amount, found.area) == (pytest.approx(3.0), pytest.approx(24.0))


def test_a_door_needs_free_ground_before_it() -> None:
    near = house("c", 10, 1.6, w=14.0, d=3.0)
    report = judged(house("a", 10, 7.5), near)
    assert report.of("blocked_door")[0].piece == "b/a"
    assert judged(house("a", 10, 9.5), near).valid


def test_a_door_may_open_on_the_street_but_not_on_the_neighbour() -> None:
    assert judged(house("a", 10, 4.0)).valid
    report = judged(house("a", 10, 46.0, heading=-SOUTH))
    assert "blocked_door" in kinds(report)


def test_a_yard_closed_all_round_is_reached_by_no_way() -> None:
    ring = (
        house("s", 30, 6, w=30, d=4),
        house("n", 30, 34, w=30, d=4, heading=-SOUTH),
        house("w", 17, 20, w=24, d=4, heading=math.pi),
        house("e", 43, 20, w=24, d=4, heading=0.0),
    )
    assert judged(*ring).valid
    report = judged(*ring, house("inside", 30, 20))
    assert kinds(report) == ["unreachable_building"]
    assert report.findings[0].piece == "b/inside"
    assert report.figures["blocks"]["b"]["reached_share"] == pytest.approx(0.8)


def test_the_square_stays_free() -> None:
    patch = Patch("b/square", "b", "square", (30.0, 7.5, SOUTH, 15.0, 15.0))
    assert kinds(judged(house("a", 30, 20), patches=(patch,))) == []
    assert kinds(judged(house("a", 30, 17), patches=(patch,))) == ["blocked_path"]


def test_what_came_with_the_brief_is_not_blamed() -> None:
    pair = house("a", 10, 10, fixed=True), house("c", 19.5, 10, fixed=True)
    report = judged(*pair, given=True)
    assert kinds(report) == ["collision"]
    assert report.valid
    said = judged(*pair)
    assert kinds(said) == ["collision"]
    assert not said.valid
    assert said.findings[0].locked


def test_broken_pieces_become_findings() -> None:
    report = judged(house("a", float("nan"), 10), house("c", 20, 10, z=1.0))
    assert kinds(report) == ["malformed", "floating"]
