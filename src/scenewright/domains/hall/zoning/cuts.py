"""Cutting a floor in two by a straight line, so that one side has a given area.

Everything lies in the hall's own frame: x along its main direction, so that cuts are parallel to
an axis. Turning or moving the hall turns or moves its frame, and with it what is cut.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable
from contextlib import suppress
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building import outlines
from scenewright.core.space import Opening, Points, Space

MOST_WALLS = 64
ROUNDS = 40
CRUMB = 1e-3
GRID = 1e-9

Edges = list[tuple[float, float, float, float]]


class Frame(NamedTuple):
    """Where the hall's own axes lie: their origin and the unit direction of x in the plan."""

    x: float
    y: float
    cos: float
    sin: float


def frame_of(space: Space) -> Frame:
    """The frame of a hall: x along the direction in which, or across which, most of its walls
    run (to 3 degrees, weighed by squared lengths; a door as a wall of twice its width).

    It is turned so that the longest such wall has the hall on its left; of several as long, the
    one that leaves most floor, then the doors, ahead and to the left.
    """
    start, end = np.hsplit(outlines.edges(space.outline), 2)
    doors = [opening for opening in space.openings if opening.kind != "window"]
    along = [2.0 * door.width * complex(door.ux, door.uy) for door in doors]
    walls = (end - start) @ np.array([1.0, 1j])
    step = np.concatenate([walls, np.array(along, complex)])
    weight = np.abs(step) ** 2
    fourth = (step / np.abs(step)) ** 4  # the same for directions a quarter turn apart
    trial = np.argsort(-np.round(weight, 6), kind="stable")[:MOST_WALLS]
    alike = (fourth * fourth[trial, None].conj()).real > np.cos(4 * np.deg2rad(3.0))
    best = int(np.argmax(np.round((alike * weight).sum(1), 6)))
    axis = np.exp(0.25j * np.angle((alike[best] * weight * fourth).sum()))
    mine = alike[best, : len(walls)] * np.abs(walls)
    longest = walls[mine > mine.max() - 1e-6] / axis
    quarters = {int(np.round(np.angle(wall) / (np.pi / 2))) % 4 for wall in longest}
    return max((_frame(space, axis * 1j**k) for k in sorted(quarters)), key=_weights(space, doors))


def _frame(space: Space, axis: complex) -> Frame:
    """The frame with x along a direction and its origin at the least x and y of the outline."""
    cos, sin = _exact(axis.real), _exact(axis.imag)
    x, y = (space.outline @ np.array([[cos, -sin], [sin, cos]])).min(0)
    return Frame(float(cos * x - sin * y), float(sin * x + cos * y), cos, sin)


def _weights(space: Space, doors: list[Opening]) -> Callable[[Frame], tuple[float, ...]]:
    """Where the floor and the doors of a hall lie in a frame, to tenths of a millimetre."""
    floor = shapely.Polygon(space.outline, space.holes)
    points = np.array([floor.centroid.coords[0], *((door.x, door.y) for door in doors)])

    def measure(frame: Frame) -> tuple[float, ...]:
        moved = into(frame, points)
        return tuple(np.round(np.concatenate([moved[0], moved[1:].sum(0)]), 4).tolist())

    return measure


def into(frame: Frame, points: Points) -> Points:
    """Points (k, 2) of the plan in the hall's frame."""
    moved = np.asarray(points, float) - (frame.x, frame.y)
    return moved @ np.array([[frame.cos, -frame.sin], [frame.sin, frame.cos]])


def out_of(frame: Frame, points: Points) -> Points:
    """Points (k, 2) of the hall's frame in the plan."""
    turned = np.asarray(points, float) @ np.array([[frame.cos, frame.sin], [-frame.sin, frame.cos]])
    return np.add(turned, (frame.x, frame.y))


def cut(
    piece: shapely.Polygon, axis: int, area: float
) -> tuple[shapely.Polygon, shapely.Polygon] | None:
    """The parts of a piece at lower and at higher coordinates of an axis (0 cuts at an x, 1 at
    a y), the lower of the given area; None where no such cut leaves two pieces.

    Where the line falls apart (the arms of a U), one run of it is cut alone.

    >>> low, high = cut(shapely.box(0, 0, 4, 3), 0, 3.0)
    >>> low.bounds, high.bounds
    ((0.0, 0.0, 1.0, 3.0), (1.0, 0.0, 4.0, 3.0))
    """
    x0, y0, x1, y1 = piece.bounds
    whole = piece.area
    if whole > (1.0 - 1e-9) * (x1 - x0) * (y1 - y0):
        return _halves((x0, y0, x1, y1), axis, area / whole)
    at = _line_for(piece, axis, area)
    low, high = _sides(piece, axis, at)
    if len(low) == 1 and len(high) == 1:
        return low[0], high[0]
    for side, share, sign in ((low, area, 1), (high, whole - area, -1)):
        if len(side) > 1:
            for part in side:
                pocket = _pocket(piece, axis, share, part, sign)
                if pocket is not None:
                    return pocket if sign > 0 else (pocket[1], pocket[0])
    return None


def area_below(edges: Edges, at: float) -> float:
    """Area of a polygon below the abscissa ``at``.

    By Green's theorem the sum over its directed edges of the integral of min(x, at) dy: the mean
    of x over the part of the edge below, and ``at`` beyond.

    >>> area_below([(0, 0, 4, 0), (4, 0, 4, 3), (4, 3, 0, 3), (0, 3, 0, 0)], 1.0)
    3.0
    """
    total = 0.0
    for x0, y0, x1, y1 in edges:
        low, high = (x0, x1) if x0 < x1 else (x1, x0)
        if high <= at:
            mean = 0.5 * (low + high)
        elif low >= at:
            mean = at
        else:
            mean = at - 0.5 * (at - low) ** 2 / (high - low)
        total += (y1 - y0) * mean
    return total


def _halves(
    box: tuple[float, float, float, float], axis: int, share: float
) -> tuple[shapely.Polygon, shapely.Polygon]:
    """A rectangle cut in two, the lower part of the given share."""
    x0, y0, x1, y1 = box
    if axis == 0:
        at = x0 + share * (x1 - x0)
        return shapely.box(x0, y0, at, y1), shapely.box(at, y0, x1, y1)
    at = y0 + share * (y1 - y0)
    return shapely.box(x0, y0, x1, at), shapely.box(x0, at, x1, y1)


def _line_for(piece: shapely.Polygon, axis: int, area: float) -> float:
    """The coordinate below which a piece has the given area: the area is a parabola between
    neighbouring corners."""
    edges = _edges(piece, axis)
    knots = sorted({edge[0] for edge in edges})
    k = bisect_left(knots, area, 1, len(knots) - 1, key=lambda knot: area_below(edges, knot))
    low, high = knots[k - 1], knots[k]
    a, b, c = (area_below(edges, at) - area for at in (low, (low + high) / 2, high))
    curve, slope = 2 * (a - 2 * b + c), 4 * b - 3 * a - c
    steep = slope + math.sqrt(max(slope * slope - 4 * curve * a, 0.0))
    t = -2 * a / steep if steep > 0 else 0.5
    return low + min(max(t, 0.0), 1.0) * (high - low)


def _edges(piece: shapely.Polygon, axis: int) -> Edges:
    """Directed edges as across, along: for cuts at a y the axes are swapped, and the direction
    with them, so that areas stay positive."""
    edges: Edges = []
    for number, ring in enumerate((piece.exterior, *piece.interiors)):
        points = shapely.get_coordinates(ring).tolist()
        if axis == 1:
            points = [(y, x) for x, y in points]
        mine = [(x0, y0, x1, y1) for (x0, y0), (x1, y1) in pairwise(points)]
        if (area_below(mine, math.inf) > 0) != (number == 0):
            mine = [(x1, y1, x0, y0) for x0, y0, x1, y1 in mine]
        edges += mine
    return edges


def _sides(
    piece: shapely.Polygon, axis: int, at: float
) -> tuple[list[shapely.Polygon], list[shapely.Polygon]]:
    """The parts below and above a line, without crumbs."""
    x0, y0, x1, y1 = piece.bounds
    far = (x0 - 1, y0 - 1, x1 + 1, y1 + 1)
    low, high = list(far), list(far)
    low[2 + axis] = high[axis] = at
    below, above = _clip_piece(piece, low), _clip_piece(piece, high)
    if abs(below.area + above.area - piece.area) > 1e-6 * piece.area:
        below, above = (piece.intersection(shapely.box(*side)) for side in (low, high))
    return _parts(below), _parts(above)


def _clip_piece(piece: shapely.Polygon, bounds: list[float]) -> shapely.Geometry:
    """What lies within bounds: quickly, which may fail where the line falls apart or meets a
    hole, else surely."""
    if len(piece.interiors) == 0:
        with suppress(shapely.GEOSException):
            clipped = shapely.clip_by_rect(piece, *bounds)
            if shapely.is_valid(clipped):
                return clipped
    return piece.intersection(shapely.box(*bounds))


def _parts(shape: shapely.Geometry) -> list[shapely.Polygon]:
    parts = getattr(shape, "geoms", [shape])
    return [p for p in parts if p.geom_type == "Polygon" and p.area > CRUMB]


def _pocket(
    piece: shapely.Polygon, axis: int, area: float, part: shapely.Polygon, sign: int
) -> tuple[shapely.Polygon, shapely.Polygon] | None:
    """One connected part on the lower (sign 1) or higher (-1) side of a line moved until the
    part that holds the far end of ``part`` has the given area; and all the rest of the piece."""
    far = shapely.get_coordinates(part)
    tip = shapely.Point(far[np.argmin(sign * far[:, axis])])
    low, high = piece.bounds[axis], piece.bounds[2 + axis]
    found = part
    for _ in range(ROUNDS):
        at = (low + high) / 2
        side = _sides(piece, axis, at)[0 if sign > 0 else 1]
        found = min(side, key=tip.distance, default=found)
        small = not side or found.distance(tip) > CRUMB or found.area < area
        low, high = (at, high) if small == (sign > 0) else (low, at)
    rest = _parts(piece.difference(found, grid_size=GRID))
    exact = abs(found.area - area) < 1e-3 * area
    if len(rest) != 1 or not exact or rest[0].area > piece.area - 0.99 * found.area:
        return None
    return found, rest[0]


def _exact(value: float) -> float:
    """Sines and cosines of quarter turns without their last bit of noise."""
    near = round(value)
    return float(near) if abs(value - near) < 1e-12 else float(value)
