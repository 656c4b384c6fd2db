"""Findings say where they lie, and judging without figures finds the same."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.report import Finding
from scenewright.core.solution import Solution


@pytest.fixture(scope="module")
def room() -> Solution:
    return sw.solve(sw.read("sample:home-room"), steps=300)


def put(solution: Solution, name: str, x: float, y: float) -> Solution:
    pieces = tuple(
        replace(p, pose=p.pose._replace(x=x, y=y)) if p.id.endswith(name) else p
        for p in solution.pieces
    )
    return replace(solution, pieces=pieces)


def one(solution: Solution, kind: str, name: str) -> Finding:
    found = [f for f in sw.check(solution).of(kind) if name in f.piece + f.other]
    return found[0]


def test_two_in_one_place_lie_where_they_overlap(room: Solution) -> None:
    bed = next(p for p in room.pieces if p.category == "single_bed")
    found = one(put(room, "wardrobe", bed.pose.x, bed.pose.y), "collision", "single_bed")
    assert sum(shapely.Polygon(ring).area for ring in found.polygons) == pytest.approx(
        found.area, abs=0.02
    )
    assert all(
        shapely.Polygon(ring).distance(shapely.Point(point)) == 0
        for ring, point in zip(found.polygons, found.points, strict=True)
    )


def test_what_sticks_out_is_the_part_outside(room: Solution) -> None:
    found = one(put(room, "wardrobe", 0.0, 2.0), "out_of_bounds", "wardrobe")
    assert all(x <= 0.0 for ring in found.polygons for x, _ in ring)


def test_a_blocked_door_is_looked_at_and_what_is_missing_lies_in_its_room(room: Solution) -> None:
    found = one(put(room, "wardrobe", 3.9, 0.4), "blocked_door", "wardrobe")
    assert min(abs(x - 3.9) + abs(y) for x, y in found.points) < 0.2
    without = replace(room, pieces=tuple(p for p in room.pieces if "single" not in p.id))
    missing = sw.check(without).of("missing")
    assert missing
    floor = shapely.box(0, 0, 4.6, 3.9)
    assert all(floor.contains(shapely.Point(found.points[0])) for found in missing)


def test_places_are_told_as_json_and_broken_pieces_have_none(room: Solution) -> None:
    told = sw.check(put(room, "wardrobe", float("nan"), 2.0))
    malformed = told.of("malformed")
    assert malformed
    assert malformed[0].polygons == ()
    rows = json.loads(json.dumps(told.to_dict()))["findings"]
    assert all({"polygons", "points"} <= set(row) for row in rows)


def test_without_figures_the_findings_are_the_same(room: Solution) -> None:
    rng = np.random.default_rng(1)
    for _ in range(4):
        moved = put(room, "wardrobe", *rng.uniform(0, 4, 2).tolist())
        full, quick = sw.check(moved), sw.check(moved, figures=False)
        assert quick.findings == full.findings
        assert quick.notes == full.notes
        assert "usability" in full.figures
        assert "usability" not in quick.figures
