"""Stairs: steps, footprint and well from where they begin and how high they lead.

In the frame of a flight of stairs the origin is the middle of the lowest step's front edge and
one sets out along +y. The number of steps follows from the height: rises near 0.175 m, goings by
Blondel's 2 r + g = 0.63 m. Nothing stands on or under stairs; above them the floor is open from
where a person would meet it (2 m of headroom, a floor 0.3 m thick).
"""

from __future__ import annotations

from math import cos, degrees, pi, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.brief.stairs import StairsBrief

Floats = NDArray[np.float64]
Point = tuple[float, float]

RISE = 0.175
PACE = 0.63
"""Twice the rise and the going of a comfortable step, metres (Blondel 1675)."""
GOINGS = (0.21, 0.30)
HEADROOM = 2.0
FLOOR = 0.3
"""Thickness of an upper floor, metres."""
EYE = 0.1
"""Between the two flights of a half turn, and the radius of a spiral's post, metres."""
ROUND = 1.5 * pi
"""How far a spiral turns; the quarter below its head is open."""
ARC = pi / 36


class Box(NamedTuple):
    """A rectangle: middle, heading of its front, width and depth."""

    x: float
    y: float
    heading: float
    width: float
    depth: float


class End(NamedTuple):
    """Where one steps on or off: the middle of the edge, the way one looks when stepping off, and
    the width."""

    x: float
    y: float
    heading: float
    width: float


class Tread(NamedTuple):
    """A step: its outline (k, 2) counter-clockwise, and its height above the lower floor. Its
    front edge (nosing) is from the first point to the second."""

    outline: Floats
    height: float


class Stairs(NamedTuple):
    """Stairs in the plan: lower and upper level, number of rises, rise and going in metres, the
    treads from the lowest on, the line one walks, the boxes taken on the lower floor, those open
    in the upper, foot and head."""

    id: str
    name: str
    level: str
    upper: str
    shape: str
    turn: str
    rises: int
    rise: float
    going: float
    treads: tuple[Tread, ...]
    walk: Floats
    taken: tuple[Box, ...]
    open: tuple[Box, ...]
    foot: End
    head: End


class Flight(NamedTuple):
    """Stairs in their own frame, turning left: treads, walk, boxes; the first box holds the foot,
    the last the head; ``first`` is how much of the first may stay closed above."""

    treads: tuple[Floats, ...]
    walk: tuple[Point, ...]
    boxes: tuple[Box, ...]
    head: End
    first: float


def steps(height: float) -> tuple[int, float]:
    """Number of rises and the comfortable going for a height in metres.

    >>> count, going = steps(2.9)
    >>> count, round(2.9 / count, 3), round(going, 3)
    (17, 0.171, 0.289)
    """
    count = max(3, round(height / RISE))
    return count, float(np.clip(PACE - 2 * height / count, *GOINGS))


def build_stairs(asked: StairsBrief, name: str, level: str, upper: str, height: float) -> Stairs:
    """Stairs as asked for, between two levels so far apart in height."""
    count, going = steps(height)
    going, w, rise = asked.going or going, asked.width, height / count
    flight = _FLIGHTS[asked.shape](count - 1, going, w)
    side = -1.0 if asked.turn == "right" and asked.shape != "straight" else 1.0
    x, y, turn = *asked.at, asked.heading - pi / 2
    if asked.shape == "spiral":
        going = ROUND / (count - 1) * (w / 2 + EYE)

    def place(points: Floats) -> Floats:
        px, py = points[..., 0] * side, points[..., 1]
        return np.stack(
            [x + cos(turn) * px - sin(turn) * py, y + sin(turn) * px + cos(turn) * py], -1
        )

    def place_box(box: Box) -> Box:
        px, py = place(np.array(box[:2])).tolist()
        heading = box.heading if side > 0 else pi - box.heading
        return Box(px, py, _wrap_angle(heading + turn), *box[3:])

    def tread(k: int, outline: Floats) -> Tread:
        points = place(outline)
        if side < 0:
            points = np.concatenate([points[1::-1], points[:1:-1]])
        return Tread(points, (k + 1) * rise)

    hx, hy = place(np.array(flight.head[:2])).tolist()
    heading = flight.head.heading if side > 0 else pi - flight.head.heading
    closed = max(0.0, height - FLOOR - HEADROOM) // rise * going
    return Stairs(
        name,
        asked.name,
        level,
        upper,
        asked.shape,
        asked.turn,
        count,
        rise,
        going,
        tuple(tread(k, outline) for k, outline in enumerate(flight.treads)),
        place(np.array(flight.walk)),
        tuple(place_box(box) for box in flight.boxes),
        tuple(place_box(box) for box in _list_open_boxes(flight, min(closed, flight.first))),
        End(x, y, _wrap_angle(asked.heading + pi), w),
        End(hx, hy, _wrap_angle(heading + turn), w),
    )


def _list_open_boxes(flight: Flight, closed: float) -> tuple[Box, ...]:
    """The boxes open above; the front of the last is the head's."""
    first, *rest = flight.boxes
    first = first._replace(y=first.y + closed / 2, depth=first.depth - closed)
    *others, last = (first, *rest)
    turned = flight.head.heading - last.heading
    sides = (last.width, last.depth) if abs(cos(turned)) > 0.5 else (last.depth, last.width)
    return (*others, Box(last.x, last.y, flight.head.heading, *sides))


def _wrap_angle(angle: float) -> float:
    return float((angle + pi) % (2 * pi) - pi)


def _across(x0: float, x1: float, y0: float, y1: float, heading: float = -pi / 2) -> Box:
    """A rectangle by its sides, looking along an axis."""
    wide, deep = x1 - x0, y1 - y0
    along = abs(sin(heading)) > 0.5
    return Box((x0 + x1) / 2, (y0 + y1) / 2, heading, *((wide, deep) if along else (deep, wide)))


def _rectangle(x0: float, x1: float, y0: float, y1: float) -> Floats:
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def _straight(count: int, g: float, w: float) -> Flight:
    treads = tuple(_rectangle(-w / 2, w / 2, k * g, (k + 1) * g) for k in range(count))
    long = count * g
    return Flight(
        treads,
        ((0.0, 0.0), (0.0, long)),
        (_across(-w / 2, w / 2, 0.0, long),),
        End(0.0, long, pi / 2, w),
        long - g,
    )


def _quarter(count: int, g: float, w: float) -> Flight:
    """A flight, a square landing, a flight to the left."""
    lower = (count - 1) // 2
    up, far = lower * g, (count - 1 - lower) * g
    treads = [_rectangle(-w / 2, w / 2, k * g, (k + 1) * g) for k in range(lower)]
    treads.append(_rectangle(-w / 2, w / 2, up, up + w))
    for k in range(count - 1 - lower):
        at = -w / 2 - k * g
        treads.append(np.array([(at, up), (at, up + w), (at - g, up + w), (at - g, up)]))
    end = -w / 2 - far
    boxes = (_across(-w / 2, w / 2, 0.0, up + w), _across(end, -w / 2, up, up + w))
    return Flight(
        tuple(treads),
        ((0.0, 0.0), (0.0, up + w / 2), (end, up + w / 2)),
        boxes,
        End(end, up + w / 2, pi, w),
        up,
    )


def _half(count: int, g: float, w: float) -> Flight:
    """A flight, a landing over both, a flight back on the left."""
    lower = count // 2
    up, down = lower * g, (count - 1 - lower) * g
    left, inner = -1.5 * w - EYE, -w / 2 - EYE
    treads = [_rectangle(-w / 2, w / 2, k * g, (k + 1) * g) for k in range(lower)]
    treads.append(_rectangle(left, w / 2, up, up + w))
    for k in range(count - 1 - lower):
        at = up - k * g
        treads.append(np.array([(inner, at), (left, at), (left, at - g), (inner, at - g)]))
    middle, end = -w - EYE, up - down
    boxes = (_across(inner, w / 2, 0.0, up + w), _across(left, inner, end, up + w))
    walk = ((0.0, 0.0), (0.0, up + w / 2), (middle, up + w / 2), (middle, end))
    return Flight(tuple(treads), walk, boxes, End(middle, end, -pi / 2, w), up)


def _spiral(count: int, _: float, w: float) -> Flight:
    """Three quarters of a circle to the left; one steps off into the fourth, above the foot."""
    radius, middle = w + EYE, EYE + w / 2
    each = ROUND / count

    def at(r: float, angle: float) -> Point:
        return -middle + r * cos(angle), r * sin(angle)

    treads = []
    for k in range(count):
        arc = np.linspace(k * each, (k + 1) * each, max(2, round(each / ARC)))
        outer = [at(radius, a) for a in arc]
        treads.append(np.array([at(EYE, k * each), *outer, at(EYE, (k + 1) * each)]))
    walk = tuple(at(middle, a) for a in np.linspace(0.0, ROUND, 28).tolist())
    x0, x1 = -middle - radius, -middle + radius
    boxes = (
        _across(-middle, x1, 0.0, radius),
        _across(x0, -middle, 0.0, radius),
        _across(x0, -middle, -radius, 0.0),
    )
    return Flight(tuple(treads), walk, boxes, End(*at(middle, ROUND), 0.0, w), 0.0)


_FLIGHTS = {"straight": _straight, "quarter": _quarter, "half": _half, "spiral": _spiral}


def describe_stairs(stairs: Stairs) -> str:
    """The stairs in words: ``17 rises of 17.1 cm, goings of 28.8 cm``."""
    return (
        f"{stairs.rises} rises of {100 * stairs.rise:.1f} cm, goings of {100 * stairs.going:.1f} cm"
    )


def slope(stairs: Stairs) -> float:
    """How steep the stairs are, degrees.

    >>> round(degrees(np.arctan2(0.17, 0.29)))
    30
    """
    return degrees(float(np.arctan2(stairs.rise, stairs.going)))
