"""Footprints that are polygons: read, measured exactly, judged, and used for room."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

import scenewright as sw
from scenewright.core.errors import InputError
from scenewright.core.footprint import place_outline, read_footprint
from scenewright.core.piece_outlines import boxes_of, outline_of, polygons_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.formats import brief_json, solution_json
from scenewright.geometry.boxes import make_frame
from scenewright.geometry.rings import make_rings, ring_in_box, ring_in_polygon, ring_in_ring

ELL = ((-2.0, -1.0), (2.0, -1.0), (2.0, 0.0), (0.0, 0.0), (0.0, 1.0), (-2.0, 1.0))


def star(rng: np.random.Generator, corners: int, size: float) -> np.ndarray:
    """A simple polygon about the origin, counter-clockwise, some of its edges upright."""
    turns = np.sort(rng.uniform(0, 2 * math.pi, corners - 3))
    turns = np.sort(np.concatenate([turns, [0.1, 2.2, 4.3]]))
    spokes = size * rng.uniform(0.3, 1.0, corners)
    ring = np.column_stack([spokes * np.cos(turns), spokes * np.sin(turns)])
    ring[1, 0] = ring[0, 0] if rng.random() < 0.3 else ring[1, 0]
    shape = shapely.Polygon(ring)
    return ring if shape.is_valid and shapely.is_ccw(shape.exterior) else star(rng, corners, size)


def rotated_ell(x: float, y: float, heading: float, **more) -> Piece:
    return Piece(
        more.pop("id", "p"), "box", "", "r", Pose(x, y, 0, heading), Size(4, 2, 1), footprint=ELL
    )


@given(st.integers(0, 10**6), st.integers(4, 12), st.floats(0.1, 60), st.floats(0.1, 60))
def test_a_footprint_fills_its_box_and_reads_as_itself(
    seed: int, corners: int, width: float, depth: float
) -> None:
    ring = star(np.random.default_rng(seed), corners, 5.0)
    found = read_footprint(ring if seed % 2 else ring[::-1], width, depth)
    shape = shapely.Polygon(found)
    assert shape.is_valid
    assert shapely.is_ccw(shape.exterior)
    assert 2 * np.abs(found).max(0) == pytest.approx([width, depth], abs=1e-9)
    low, high = ring.min(0), ring.max(0)
    share = shapely.Polygon(ring).area / (high - low).prod()
    assert shape.area == pytest.approx(share * width * depth, rel=1e-6, abs=1e-7)
    assert read_footprint(found, width, depth) == found


@pytest.mark.parametrize(
    "points",
    [
        [(0, 0), (1, 0)],
        [(0, 0), (2, 0), (0, 2), (2, 2)],
        [(0, 0), (1, 0), (2, 0)],
        [(0, 0), (1, 0), (float("nan"), 1)],
        [(math.cos(k), math.sin(k)) for k in np.linspace(0, 6, 300)],
    ],
)
def test_what_is_no_simple_polygon_is_refused(points: list[tuple[float, float]]) -> None:
    with pytest.raises(InputError):
        read_footprint(points, 4.0, 2.0)


@given(st.integers(0, 10**6), st.floats(-7, 7), st.floats(-7, 7), st.floats(-4, 4))
def test_areas_of_rings_agree_with_exact_polygons(
    seed: int, x: float, y: float, heading: float
) -> None:
    rng = np.random.default_rng(seed)
    outlines = [star(rng, int(rng.integers(4, 14)), 5.0) for _ in range(2)]
    ground = star(rng, 20, 12.0)
    rings = make_rings(outlines, (0.0, 0.7))
    first, second = make_frame(x, y, heading, 2.0, 2.0), make_frame(1.0, -2.0, 0.8, 2.0, 3.0)
    edges = np.hstack([ground, np.roll(ground, -1, axis=0)])
    for grown in (0, 1):
        local = [rings.edges[slice(*rings.spans[k, grown]), :2] for k in (0, 1)]
        a = shapely.Polygon(place_outline(local[0], x, y, heading))
        b = shapely.Polygon(place_outline(local[1], 1.0, -2.0, 0.8))
        box = shapely.Polygon(
            place_outline(np.array([(-1, -1.5), (1, -1.5), (1, 1.5), (-1, 1.5)]), 1.0, -2.0, 0.8)
        )
        exact = [a.intersection(s).area for s in (b, shapely.Polygon(ground), box)]
        assert ring_in_ring(first, 0, second, 1, grown, rings) == pytest.approx(exact[0], abs=1e-9)
        assert ring_in_polygon(first, rings, 0, grown, edges) == pytest.approx(exact[1], abs=1e-9)
        assert ring_in_box(first, 0, grown, rings, second) == pytest.approx(exact[2], abs=1e-9)
        assert rings.facts[0, grown, 3] == pytest.approx(a.area)


@given(st.integers(0, 10**6), st.floats(-4, 4))
def test_boxes_cover_a_footprint(seed: int, heading: float) -> None:
    ring = star(np.random.default_rng(seed), 8, 3.0)
    footprint = read_footprint(ring, 4.0, 2.0)
    piece = replace(rotated_ell(1.0, 2.0, heading), footprint=footprint)
    covering = polygons_of([_as_piece(box) for box in boxes_of(piece)])
    covered = shapely.union_all(shapely.buffer(covering, 1e-5), grid_size=1e-6)
    assert shapely.Polygon(outline_of(piece)).difference(covered).area < 1e-6
    upright = polygons_of([_as_piece(box) for box in boxes_of(rotated_ell(0, 0, heading))])
    assert shapely.area(upright).sum() == pytest.approx(6.0)


def _as_piece(box: list[float]) -> Piece:
    x, y, heading, width, depth = box
    return Piece("b", "box", "", "r", Pose(x, y, 0, heading), Size(width, depth, 1.0))


def test_the_polygon_of_a_box_is_its_corners() -> None:
    plain = replace(rotated_ell(1, 2, 0.3), footprint=())
    ell = rotated_ell(1, 2, 0.3)
    both = polygons_of([plain, ell])
    assert both[0].area == pytest.approx(8.0)
    assert both[1].area == pytest.approx(6.0)
    assert both[0].buffer(1e-9).covers(both[1])
    assert boxes_of(plain) == [[1, 2, 0.3, 4, 2]]


def kitchen(**more) -> dict:
    counter = {
        "id": "counter",
        "category": "kitchen_island",
        "at": [1.5, 1.0],
        "heading": math.pi / 2,
        "size": [3.0, 2.0, 0.9],
        "footprint": [[0, 0], [3, 0], [3, 0.6], [0.6, 0.6], [0.6, 2], [0, 2]],
    }
    chair = {"id": "chair", "category": "armchair", "at": [2.1, 1.5], "size": [0.8, 0.8, 0.9]}
    return {
        "rooms": [
            {
                "id": "r",
                "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
                "doors": [{"at": [4.2, 0], "width": 0.9}],
                "ask": [],
                "fixed": [counter | more, chair],
            }
        ]
    }


def collisions(document: dict) -> list[str]:
    solution = sw.solve(brief_json.loads(json.dumps(document)), steps=50)
    return [f.message for f in sw.check(solution).findings if f.kind == "collision"]


def test_a_chair_stands_in_the_corner_of_a_counter() -> None:
    assert not collisions(kitchen())
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    assert "overlap" in collisions(kitchen(footprint=square))[0]


def test_a_footprint_is_saved_locked_and_drawn(tmp_path: Path) -> None:
    solution = sw.solve(brief_json.loads(json.dumps(kitchen())), steps=50)
    again = solution_json.loads(solution_json.dumps(solution))
    assert again.pieces == solution.pieces
    counter = next(p for p in again.pieces if p.id == "counter")
    assert len(counter.footprint) == 6
    locked = solution_json.brief_of(solution_json.to_document(again))
    kept = next(item for item in locked.rooms[0].fixed if item.id == "counter")
    assert kept.footprint == list(counter.footprint)
    plain = json.loads(solution_json.dumps(again))["pieces"]
    assert [("footprint" in piece) for piece in plain if piece["id"] == "chair"] == [False]
    sw.write(again, tmp_path / "k.svg")
    sw.write(again, tmp_path / "k.glb")
    assert (tmp_path / "k.glb").stat().st_size > 1000


def test_a_footprint_that_crosses_itself_is_one_line() -> None:
    with pytest.raises(
        InputError, match=r"rooms\[0\].fixed\[0\].footprint.*simple polygon"
    ) as told:
        brief_json.loads(json.dumps(kitchen(footprint=[[0, 0], [1, 1], [1, 0], [0, 1]])))
    assert "\n" not in str(told.value)
