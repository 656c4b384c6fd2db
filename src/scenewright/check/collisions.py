"""Object collisions: pairs of pieces that share more space than a tolerance.

SceneEval (Tam et al. 2025) calls two meshes colliding if they still touch after one is moved
5 mm away from the other. Here the bodies are boxes turned about the vertical, and the test is
exact: they collide if both their footprints and their height ranges overlap by more than 1 cm,
where the overlap of footprints is the *penetration depth*, the shortest move that parts them. Of
footprints that are no boxes it is the short side of the least rectangle about what they share.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.check.bodies import PARTITION, TOLERANCE, Bodies, Flags, Floats, Indices, Shape
from scenewright.check.shared_ground import intersect_footprints
from scenewright.core.report import Finding

_BACKREST = 0.05


def penetration(first: Floats, second: Floats) -> Floats:
    """Penetration depth in metres of rectangles ``(n, 4, 2)`` with rectangles ``(n, 4, 2)``.

    For convex shapes the shortest parting move is along the normal of some edge, so it is the
    least overlap of the projections on the four edge directions (Gottschalk et al. 1996,
    separating axes); 0 where they do not meet.

    >>> square = np.array([[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]])
    >>> penetration(square, square + [0.75, 0.5]).round(3).tolist()
    [0.25]
    """
    edges = [c[:, k + 1] - c[:, k] for c in (first, second) for k in (0, 1)]
    axes = np.stack(edges, 1)
    axes /= np.maximum(np.linalg.norm(axes, axis=-1, keepdims=True), 1e-12)
    a = np.einsum("nij,nkj->nik", first, axes)
    b = np.einsum("nij,nkj->nik", second, axes)
    apart = np.minimum(a.max(1) - b.min(1), b.max(1) - a.min(1))
    return np.maximum(apart.min(1), 0.0)


def find_collisions(bodies: Bodies, names: tuple[str, ...]) -> list[Finding]:
    """Every colliding pair once, with its deepest overlap; ``names`` are those of the levels.

    Allowed: flat things (rugs), curtains, a piece and the one it stands on, and a piece under
    or in another as its kind says (a chair under its table, its back staying outside), and
    partitions that join.
    """
    if len(bodies.pieces) < 2:
        return []
    i, j = shapely.STRtree(bodies.footprints).query(bodies.footprints, predicate="intersects")
    keep = (i < j) & (bodies.level[i] == bodies.level[j])
    order = np.lexsort((j[keep], i[keep]))
    i, j = i[keep][order], j[keep][order]
    tall = np.minimum(bodies.high[i], bodies.high[j]) - np.maximum(bodies.low[i], bodies.low[j])
    depth = _overlap(bodies, i, j)
    waived = bodies.flat[i] | bodies.flat[j] | bodies.soft[i] | bodies.soft[j]
    hit = (depth > TOLERANCE) & (tall > TOLERANCE) & ~waived
    hit[hit] &= ~_belong(bodies, i[hit], j[hit])
    i, j, depth, tall = i[hit], j[hit], depth[hit], tall[hit]
    area = shapely.area(intersect_footprints(bodies.footprints[i], bodies.footprints[j]))
    rows = zip(i, j, np.minimum(depth, tall), area, strict=True)
    return [_finding(bodies, names, int(a), int(b), float(d), float(s)) for a, b, d, s in rows]


def _overlap(bodies: Bodies, i: Indices, j: Indices) -> Floats:
    """How deep the footprints of pairs overlap, metres."""
    depth = penetration(bodies.corners[i], bodies.corners[j])
    shaped = np.array([bool(piece.footprint) for piece in bodies.pieces], bool)
    rows = np.flatnonzero((shaped[i] | shaped[j]) & (depth > TOLERANCE))
    shared = intersect_footprints(bodies.footprints[i[rows]], bodies.footprints[j[rows]])
    depth[rows] = [thickness(shape) for shape in shared]
    return depth


def thickness(shape: Shape) -> float:
    """The short side of the least rectangle about the thickest part of a shape; 0 without area.

    >>> thickness(shapely.MultiPolygon([shapely.box(0, 0, 3, 1), shapely.box(5, 0, 6, 2)]))
    1.0
    """
    parts = shapely.get_parts(shapely.get_parts(shape))
    solid = parts[shapely.area(parts) > TOLERANCE**2]
    if not len(solid):
        return 0.0
    frames = shapely.get_coordinates(shapely.minimum_rotated_rectangle(solid)).reshape(-1, 5, 2)
    sides = np.hypot(*np.moveaxis(np.diff(frames[:, :3], axis=1), -1, 0))
    return round(float(sides.min(1).max()), 12)


def _belong(bodies: Bodies, i: Indices, j: Indices) -> Flags:
    """Which pairs belong on, under or in each other."""
    return np.array(
        [_rests(bodies, a, b) or _rests(bodies, b, a) for a, b in zip(i, j, strict=True)], bool
    )


def _rests(bodies: Bodies, small: int, large: int) -> bool:
    """Whether ``small`` stands on ``large``, or may be under or in it."""
    if bodies.pieces[small].on == bodies.pieces[large].id:
        return True
    if bodies.pieces[small].category == bodies.pieces[large].category == PARTITION:
        return True
    if bodies.pieces[large].category not in bodies.kinds[small].under:
        return False
    if not bodies.seat[small] or bodies.high[small] < bodies.high[large]:
        return True
    return _back_outside(bodies.corners[small], bodies, large)


def _back_outside(seat: Floats, bodies: Bodies, large: int) -> bool:
    """Whether the rear 5 cm of a seat, its backrest, stay out of a table; a round one is a disc."""
    forward = seat[1] - seat[0]
    step = forward * min(_BACKREST / max(float(np.hypot(*forward)), 1e-12), 1.0)
    back = np.stack([seat[0], seat[0] + step, seat[3] + step, seat[3]])
    chairs, piece = bodies.kinds[large].chairs, bodies.pieces[large]
    if chairs is not None and chairs.around:
        disc = shapely.Point(piece.pose[:2]).buffer(0.5 * min(piece.size[:2]))
        return thickness(shapely.intersection(shapely.Polygon(back), disc)) <= TOLERANCE
    if piece.footprint:
        shared = shapely.intersection(shapely.Polygon(back), bodies.footprints[large])
        return thickness(shared) <= TOLERANCE
    return bool(penetration(back[None], bodies.corners[large][None])[0] <= TOLERANCE)


def _finding(
    bodies: Bodies, names: tuple[str, ...], i: int, j: int, depth: float, area: float
) -> Finding:
    a, b = bodies.pieces[i], bodies.pieces[j]
    return Finding(
        "collision",
        names[bodies.level[i]],
        a.space,
        a.id,
        b.id,
        f"{a.id} and {b.id} overlap by {depth:.2f} m ({area:.2f} m²)",
        round(depth, 4),
        round(area, 4),
        a.fixed and b.fixed,
    )
