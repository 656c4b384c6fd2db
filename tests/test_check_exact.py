"""The referee against slow references: sampled points for overlaps, a raster for routes."""

from __future__ import annotations

import json
import math

import numpy as np
import shapely
from hypothesis import assume, example, given
from hypothesis import strategies as st
from scipy import ndimage

from scenewright.check.collisions import penetration
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.kind import Kind
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.core.space import Opening, Space
from scenewright.domains import check

CATALOG = Catalog({"box": Kind("box"), "wardrobe": Kind("wardrobe", access=("front",))})
CELL = 0.02
OUTLINE = np.array([[0, 0], [4, 0], [4, 1.6], [2.5, 1.6], [2.5, 3], [0, 3]], float)

boxes = st.tuples(
    st.floats(-1, 1), st.floats(-1, 1), st.floats(-4, 4), st.floats(0.1, 1.5), st.floats(0.1, 1.5)
)


def corners(box) -> np.ndarray:
    x, y, heading, width, depth = box
    cos, sin = math.cos(heading), math.sin(heading)
    local = np.array([[1, -1], [1, 1], [-1, 1], [-1, -1]]) * [width / 2, depth / 2]
    return np.array([x, y]) + local @ np.array([[sin, -cos], [cos, sin]])


def inside(points: np.ndarray, box) -> np.ndarray:
    """How deep points lie within a box, negative outside."""
    x, y, heading, width, depth = box
    cos, sin = math.cos(heading), math.sin(heading)
    local = (points - [x, y]) @ np.array([[sin, cos], [-cos, sin]])
    return np.minimum(width / 2 - np.abs(local[:, 0]), depth / 2 - np.abs(local[:, 1]))


@given(boxes, boxes)
def test_penetration_agrees_with_sampled_points(first, second):
    depth = float(penetration(corners(first)[None], corners(second)[None])[0])
    shared = shapely.Polygon(corners(first)).intersection(shapely.Polygon(corners(second)))
    assert (depth > 0) == (shared.area > 0) or shared.area < 1e-9
    x0, y0 = corners(first).min(0)
    x1, y1 = corners(first).max(0)
    grid = np.stack(np.meshgrid(np.linspace(x0, x1, 80), np.linspace(y0, y1, 80)), -1)
    deepest = np.minimum(*(inside(grid.reshape(-1, 2), box) for box in (first, second))).max()
    assert depth >= 2 * deepest - 1e-9


@given(boxes, boxes)
def test_moving_by_the_depth_parts_and_by_less_does_not(first, second):
    a, b = corners(first), corners(second)
    depth = float(penetration(a[None], b[None])[0])
    assume(depth > 1e-3)
    turns = np.linspace(0, 2 * math.pi, 720, endpoint=False)
    ways = np.stack([np.cos(turns), np.sin(turns)], -1)
    shapes = shapely.polygons(b + 0.98 * depth * ways[:, None])
    assert (shapely.area(shapely.intersection(shapes, shapely.Polygon(a))) > 0).all()
    exact = np.concatenate([a - np.roll(a, 1, 0), b - np.roll(b, 1, 0)])
    exact /= np.linalg.norm(exact, axis=1, keepdims=True)
    shapes = shapely.polygons(b + 1.0001 * depth * exact[:, None])
    assert (shapely.area(shapely.intersection(shapes, shapely.Polygon(a))) < 1e-6).any()


def stand(category: str, box, name: str) -> Piece:
    x, y, heading, width, depth = box
    return Piece(name, category, "", "a", Pose(x, y, 0.0, heading), Size(width, depth, 1.0))


def judge(pieces: tuple[Piece, ...]):
    way = Opening("d", "door", "0", 0.6, -0.05, 1, 0, 0.9, 0.1, 0, 2.0, spaces=("a",))
    space = Space("a", "a", ("other",), "0", OUTLINE, openings=(way,))
    brief = Brief.model_validate({"rooms": [{"outline": [[0, 0], [4, 0], [4, 3]]}]})
    solution = Solution(brief, pieces, (), (), (), {}, "", "", 0, "", "", 0.0, 0)
    return check(solution, spaces=(space,), catalog=CATALOG)


def raster(solid: list, radius: float) -> tuple[np.ndarray, np.ndarray]:
    """Cells of the room and its doorway whose disc is free and joined to the door, and their
    centres."""
    xs, ys = np.arange(-0.5, 4.5, CELL), np.arange(-1.2, 3.5, CELL)
    points = np.stack(np.meshgrid(xs, ys), -1).reshape(-1, 2)
    x, y = points.T
    room = (x > 0) & (y > 0) & (x < 4) & (y < 3) & ~((x > 2.5) & (y > 1.6))
    doorway = (np.abs(x - 0.6) < 0.45) & (y <= 0)
    free = room | (doorway & (y > -0.9))
    for box in solid:
        free &= inside(points, box) < 0
    free = free.reshape(len(ys), len(xs))
    wide = ndimage.distance_transform_edt(free) * CELL >= radius
    label, _ = ndimage.label(wide)
    start = label[np.argmin(np.abs(ys + 0.05)), np.argmin(np.abs(xs - 0.6))]
    joined = (label == start) & (start > 0)
    return joined.ravel() & (room | (doorway & (y > -0.1))), points


placed = st.tuples(
    st.floats(0.3, 3.7),
    st.floats(0.3, 2.7),
    st.floats(-4, 4),
    st.floats(0.2, 1.8),
    st.floats(0.2, 0.8),
)


@given(placed, st.lists(placed, max_size=4))
def test_routes_agree_with_a_raster(wardrobe, others):
    """Where a raster is sure (at 3 cm more and less of width and reach), the referee agrees."""
    report = judge(
        (
            stand("wardrobe", wardrobe, "w"),
            *(stand("box", b, f"b{i}") for i, b in enumerate(others)),
        )
    )
    x, y, heading, width, depth = wardrobe
    sure = []
    for slack in (0.03, -0.03):
        joined, points = raster([wardrobe, *others], 0.3 + slack)
        front = (depth + 0.5) / 2
        zone = (x + front * math.cos(heading), y + front * math.sin(heading), heading, width, 0.5)
        sure.append(bool((joined & (inside(points, zone) > slack)).any()))
    assume(sure[0] == sure[1])
    missed = {(f.kind, f.piece) for f in report.findings} & {("unreachable_piece", "w")}
    unreachable_room = bool(report.of("unreachable_room"))
    assert (not missed and not unreachable_room) == sure[0]


@given(placed, st.lists(placed, max_size=4))
def test_what_blocks_truly_blocks(wardrobe, others):
    """Taking away any one of several named with *or*, all named with *and*, opens the way."""
    pieces = (
        stand("wardrobe", wardrobe, "w"),
        *(stand("box", b, f"b{i}") for i, b in enumerate(others)),
    )
    for found in judge(pieces).of("unreachable_piece"):
        names = [name for name in found.other.split(",") if name]
        sets = [names] if " and " in found.message else [[name] for name in names]
        for gone in sets if names else []:
            rest = judge(tuple(p for p in pieces if p.id not in gone))
            assert not rest.of("unreachable_piece")


@given(placed)
def test_out_of_bounds_agrees_with_sampled_points(box):
    found = judge((stand("box", box, "b"),)).of("out_of_bounds")
    x, y, heading, width, depth = box
    u, v = np.meshgrid(np.linspace(-0.5, 0.5, 41), np.linspace(-0.5, 0.5, 41))
    cos, sin = math.cos(heading), math.sin(heading)
    px = x + u * width * sin + v * depth * cos
    py = y - u * width * cos + v * depth * sin
    room = shapely.Polygon(OUTLINE)
    outside = shapely.distance(shapely.points(px, py), room).max()
    assume(abs(outside - 0.01) > 5e-3)
    assert bool(found) == (outside > 0.01)
    assert not found or abs(found[0].amount - outside) < 0.05


anything = st.floats(allow_nan=True, allow_infinity=True)
odd = st.one_of(st.floats(-5, 5), st.sampled_from([0.0, 1e-9, 1e-300, 1e4, -1e4]), anything)


@given(st.lists(st.tuples(odd, odd, odd, odd, odd, odd, odd), max_size=5), st.booleans())
@example([(1.0, 4.0, 0.0, 0.0, 1e-300, 1e-300, 1.0)], False)
@example([(0.0,) * 7, (0.0, 0.0, 0.0, 0.0, 1.0, 1e-300, 1.0)], False)
@example([(0.0,) * 7, (0.0, 0.0, 0.0, 0.0, 1e-300, 1.0, 1.0)], False)
@example([(0.0,) * 7] * 3 + [(math.inf, 0.0, 0.0, 0.0, 0.0, math.inf, 0.0)], False)
@example([(0.0,) * 7] * 3 + [(0.0, 0.0, 0.0, math.inf, 1.0, 1.0, 1.0)], True)
def test_nothing_a_piece_holds_raises(rows, named):
    """However odd poses and sizes are, there is a report that JSON can hold."""
    pieces = tuple(
        Piece(
            f"p{i}" if named else "",
            ("wardrobe", "box", "?")[i % 3],
            "",
            "a",
            Pose(*row[:4]),
            Size(*row[4:]),
            on="p0" if i == 3 else None,
        )
        for i, row in enumerate(rows)
    )
    report = judge(pieces)
    json.dumps(report.to_dict(), allow_nan=False)
    assert report.figures["pieces"] == len(rows)
    assert str(report)
