"""From the corners a user lists to clean rings: the geometry of one room.

A clean outline runs counter-clockwise, its holes clockwise, without double points, without points
in the middle of a straight edge, and never crosses or touches itself.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import shapely

from scenewright.core.brief.units import suggest_scale
from scenewright.core.errors import InputError
from scenewright.core.space import Points

SAME_POINT = 1e-3
STRAIGHT = 1e-5
LEAST_AREA = 0.1
GREATEST_EXTENT = 300.0
CURVE = np.cos(np.deg2rad(25.0))


def ring(points: Sequence[tuple[float, float]] | Points, *, clockwise: bool = False) -> Points:
    """The ring ``(m, 2)`` without double and straight points, in the direction asked for.

    Points within 1 mm of the one before are one point; a point is straight when it lies within
    0.01 mm of the line from the last point kept to the next one, so that fine curves survive.
    Spikes and slits narrower than 1 mm, where the outline runs out and back on itself, are left
    out. Read-only.

    >>> ring([(0, 0), (0, 1), (2, 1), (2, 0), (1, 0), (0, 0)]).tolist()
    [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]]
    """
    corners = _without_doubles(np.asarray(points, float).reshape(-1, 2))
    corners = _without_straight(_without_spikes(corners))
    if len(corners) > 2 and (signed_area(corners) < 0) != clockwise:
        corners = np.roll(corners[::-1], 1, axis=0)
    corners = np.ascontiguousarray(corners)
    corners.setflags(write=False)
    return corners


def signed_area(corners: Points) -> float:
    """Area of a ring ``(m, 2)``: sum of ``x_i y_(i+1) - x_(i+1) y_i`` over two; > 0 if ccw."""
    x, y = (corners - corners[0]).T
    return 0.5 * float(np.dot(x, np.roll(y, -1)) - np.dot(np.roll(x, -1), y))


def edges(corners: Points) -> Points:
    """Directed edges ``(m, 4)`` x0, y0, x1, y1 of a ring; edge i runs from corner i to i + 1."""
    return np.hstack([corners, np.roll(corners, -1, axis=0)])


def edge_meant(
    listed: Sequence[tuple[float, float]], number: int, corners: Points, what: str
) -> int:
    """The edge of a clean ring that lies nearest along edge ``number`` of the corners as
    ``listed``; InputErrors call the number ``what``.

    >>> edge_meant([(0, 0), (0, 3), (4, 3), (4, 0)], 1, ring([(0, 0), (4, 0), (4, 3), (0, 3)]), "")
    2
    """
    if number >= len(listed):
        raise InputError(
            f"{what} is {number}, but the outline has edges 0 to {len(listed) - 1}",
            "give the index of an edge",
        )
    start, end = np.array(listed[number]), np.array(listed[(number + 1) % len(listed)])
    if np.hypot(*(end - start)) < SAME_POINT:
        raise InputError(f"{what} {number} has no length", "give another edge")
    lines = np.array([shapely.LineString(row.reshape(2, 2)) for row in edges(corners)])
    meant = shapely.points(start + np.linspace(0.25, 0.75, 3)[:, None] * (end - start))
    return int(np.argmin(shapely.distance(lines[:, None], meant).sum(1)))


def polygon(
    outline: Sequence[tuple[float, float]] | Points,
    holes: Sequence[Sequence[tuple[float, float]] | Points] = (),
) -> shapely.Polygon:
    """The floor of one room as a valid polygon, or an InputError that says what is wrong.

    A hole that reaches over the outline (a column in the wall) is cut off the room.

    >>> round(polygon([(0, 0), (4, 0), (4, 3), (0, 3)], [[(1, 1), (2, 1), (2, 2), (1, 2)]]).area)
    11
    """
    floor = _simple(outline, "the outline")
    _check_extent(floor)
    if floor.area < LEAST_AREA:
        raise InputError(
            f"the outline holds only {floor.area:.2g} m² of floor", "give its corners in metres"
        )
    _check_width(floor)
    for number, hole in enumerate(holes):
        floor = _cut(floor, _simple(hole, f"holes[{number}]"), number)
    return floor


def shrink(floor: shapely.Polygon, by: float) -> shapely.Polygon:
    """The floor moved inwards by ``by`` metres with mitred corners: from the middle lines of the
    walls to their inner faces.

    Parts that fall off at a bottleneck narrower than the wall are dropped; the largest stays.
    """
    with np.errstate(all="ignore"):
        inner = floor.buffer(-by, join_style="mitre", mitre_limit=5.0)
    parts = [part for part in getattr(inner, "geoms", [inner]) if part.area >= LEAST_AREA]
    if not parts:
        raise InputError(
            f"nothing is left of the room inside walls {2 * by:g} m thick",
            'make it larger, or set outlines to "inner"',
        )
    largest: shapely.Polygon = max(parts, key=lambda part: part.area)
    return largest


def rings(floor: shapely.Polygon) -> tuple[Points, tuple[Points, ...]]:
    """Clean outline and holes of a polygon; holes of less than 1 cm² are left out."""
    holes = (ring(shapely.get_coordinates(hole), clockwise=True) for hole in floor.interiors)
    outline = ring(shapely.get_coordinates(floor.exterior))
    return outline, tuple(hole for hole in holes if len(hole) > 2 and -signed_area(hole) > 1e-4)


def wall_runs(ring: Points) -> list[Points]:
    """The walls of a ring as polylines: cut at every corner of more than 25 degrees.

    >>> len(wall_runs(ring([(0, 0), (4, 0), (4, 3), (0, 3)])))
    4
    """
    along = np.roll(ring, -1, axis=0) - ring
    along /= np.linalg.norm(along, axis=1)[:, None]
    turn = (along * np.roll(along, 1, axis=0)).sum(1)
    cuts = np.flatnonzero(turn < CURVE)
    if len(cuts) == 0:
        return [np.vstack([ring, ring[:1]])]
    turned = np.roll(ring, -cuts[0], axis=0)
    ends = [*(cuts - cuts[0]).tolist(), len(ring)]
    closed = np.vstack([turned, turned[:1]])
    return [closed[a : b + 1] for a, b in pairwise(ends)]


def run_lengths(run: Points) -> Points:
    """Arc length ``(n,)`` at every corner of a polyline ``(n, 2)``."""
    steps = np.linalg.norm(np.diff(run, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def project(run: Points, at: Points) -> tuple[float, float]:
    """Arc length and distance of the point of a polyline that is nearest to ``at``."""
    start, along = run[:-1], np.diff(run, axis=0)
    length = np.linalg.norm(along, axis=1)
    t = np.clip(((at - start) * along).sum(1) / length**2, 0.0, 1.0)
    away = np.linalg.norm(start + t[:, None] * along - at, axis=1)
    best = int(np.argmin(away))
    return float(length[:best].sum() + t[best] * length[best]), float(away[best])


def _without_doubles(corners: Points) -> Points:
    kept: list[Points] = []
    for corner in corners:
        if not kept or np.hypot(*(corner - kept[-1])) > SAME_POINT:
            kept.append(corner)
    while len(kept) > 1 and np.hypot(*(kept[-1] - kept[0])) <= SAME_POINT:
        kept.pop()
    return np.array(kept).reshape(-1, 2)


def _without_straight(corners: Points) -> Points:
    kept = [corners[i] for i in range(len(corners))]
    i = 0
    while i < len(kept) and len(kept) > 3:
        if _straight(kept[i - 1], kept[i], kept[(i + 1) % len(kept)]):
            kept.pop(i)
        else:
            i += 1
    return np.array(kept).reshape(-1, 2)


def _without_spikes(corners: Points) -> Points:
    """Without corners where the outline turns back along itself, within 1 mm of where it came."""
    turned = corners - np.roll(corners, 1, 0)
    ahead = np.roll(corners, -1, 0) - corners
    if not ((turned * ahead).sum(1) < 0).any():
        return corners
    kept = [corners[i] for i in range(len(corners))]
    i = 0
    while i < len(kept) and len(kept) > 3:
        if _is_spike(kept[i - 1], kept[i], kept[(i + 1) % len(kept)]):
            kept.pop(i)
            i = max(i - 2, 0)
        else:
            i += 1
    clean = _without_doubles(np.array(kept).reshape(-1, 2))
    return clean if len(clean) == len(corners) else _without_spikes(clean)


def _is_spike(before: Points, here: Points, after: Points) -> bool:
    """Whether a corner is the tip of a spike: the shorter side ends within 1 mm of the longer."""
    ax, ay = before[0] - here[0], before[1] - here[1]
    bx, by = after[0] - here[0], after[1] - here[1]
    longer = max(np.hypot(ax, ay), np.hypot(bx, by))
    shorter = min(np.hypot(ax, ay), np.hypot(bx, by))
    apart = abs(ax * by - ay * bx) / max(longer, 1e-12)
    return bool(ax * bx + ay * by > 0 and apart <= SAME_POINT and shorter > 2 * SAME_POINT)


def _straight(before: Points, here: Points, after: Points) -> bool:
    ax, ay = after[0] - before[0], after[1] - before[1]
    bx, by = here[0] - before[0], here[1] - before[1]
    ahead = 0 < ax * bx + ay * by < ax * ax + ay * ay
    return bool(ahead and abs(ax * by - ay * bx) <= STRAIGHT * np.hypot(ax, ay))


def _simple(points: Sequence[tuple[float, float]] | Points, what: str) -> shapely.Polygon:
    corners = ring(points)
    if not np.isfinite(corners).all():
        raise InputError(f"{what} has a corner that is not a number", "give finite coordinates")
    if len(corners) < 3:
        raise InputError(f"{what} has fewer than three different corners", "list its corners")
    shape = shapely.Polygon(corners)
    if not shape.is_valid:
        raise InputError(
            f"{what} crosses or touches itself{_where(shape)}",
            "list the corners in order, once around",
        )
    return shape


def _where(shape: shapely.Polygon) -> str:
    found = re.search(r"\[(\S+) (\S+?)\]", shapely.is_valid_reason(shape))
    return f" at ({float(found[1]):.2f}, {float(found[2]):.2f})" if found else ""


def _check_extent(floor: shapely.Polygon) -> None:
    x0, y0, x1, y1 = floor.bounds
    side = max(x1 - x0, y1 - y0)
    if side > GREATEST_EXTENT:
        raise InputError(
            f"the room is {side:.0f} m long",
            f"lengths are metres and a room is at most {GREATEST_EXTENT:.0f} m long: "
            f"{suggest_scale(side)}",
        )


def _check_width(floor: shapely.Polygon) -> None:
    """No part of a room hangs on it by less than 1 mm."""
    with np.errstate(all="ignore"):
        core = floor.buffer(-SAME_POINT / 2, join_style="mitre", mitre_limit=2.0)
    parts = [part for part in shapely.get_parts(core) if part.area > LEAST_AREA]
    if len(parts) > 1:
        first, second = sorted(parts, key=lambda part: -part.area)[:2]
        neck = shapely.shortest_line(first, second).centroid
        raise InputError(
            f"the outline is narrower than 1 mm near ({neck.x:.2f}, {neck.y:.2f})",
            "make its parts rooms of their own, or join them",
        )


def _cut(floor: shapely.Polygon, hole: shapely.Polygon, number: int) -> shapely.Polygon:
    if floor.intersection(hole).area < 0.5 * hole.area:
        raise InputError(f"holes[{number}] is outside the outline", "move it in or leave it out")
    rest = floor.difference(hole)
    if not isinstance(rest, shapely.Polygon) or rest.area < LEAST_AREA or not rest.is_valid:
        raise InputError(
            f"holes[{number}] cuts the room in pieces", "make each piece a room of its own"
        )
    return rest
