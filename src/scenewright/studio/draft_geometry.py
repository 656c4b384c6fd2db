"""Where things lie on a drawn plan: walls near a point, what is joined to a wall, numbers read."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from scenewright.core.errors import InputError
from scenewright.studio.shapes import Json

SAME = 1e-6
"""Metres within which two corners are one."""
REACH = 0.6
"""Metres from a wall within which an opening is put on it."""
SHORTEST = 0.05
"""Metres that a wall or an opening has at least."""
THICK = 0.6
"""Metres between the faces of a wall at most."""
MOST, FARTHEST = 200, 2000.0
"""Rows of a kind and corners of one at most; metres from the origin."""

Point = list[float]


class Edge(NamedTuple):
    """The wall nearest to a point: how far, of which room by number, from which corner by number,
    and at which share of its length."""

    far: float
    room: int = -1
    corner: int = 0
    share: float = 0.0


def on_level(draft: Json, group: str, level: str) -> list[Json]:
    """The rows of a group on one storey."""
    return [row for row in draft[group] if row["level"] == level]


def is_inner(draft: Json) -> bool:
    """Whether outlines of a draft are the inner faces of walls, as in a plan that was brought."""
    return bool(draft.get("kept", {}).get("outlines") == "inner")


def nearest_edge(draft: Json, at: Point, level: str) -> Edge:
    """The wall of a storey that is nearest to a point.

    >>> rooms = [{"outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "level": "1"}]
    >>> nearest_edge({"rooms": rooms}, [1.0, 0.5], "1")
    Edge(far=0.5, room=0, corner=0, share=0.25)
    >>> nearest_edge({"rooms": rooms}, [1.0, 0.5], "2").room
    -1
    """
    best, p = Edge(math.inf), np.array(at)
    for number, room in enumerate(draft["rooms"]):
        if room["level"] != level:
            continue
        for k, (a, b) in enumerate(edges_of(room["outline"])):
            along = b - a
            share = float(np.clip((p - a) @ along / max(float(along @ along), SAME), 0, 1))
            far = float(np.hypot(*(p - a - share * along)))
            if far < best.far - SAME:
                best = Edge(far, number, k, share)
    return best


def edges_of(outline: list[Point]) -> Iterator[tuple[Any, Any]]:
    """The ends of every side of an outline, as arrays."""
    corners = np.array(outline, float)
    yield from zip(corners, np.roll(corners, -1, axis=0), strict=True)


def close_edge(outline: list[Point], at: Point) -> Point:
    """The place on an outline that is nearest to a point.

    >>> close_edge([[0, 0], [4, 0], [4, 3], [0, 3]], [1.0, -0.1])
    [1.0, 0.0]
    """
    alone = {"rooms": [{"outline": outline, "level": ""}]}
    return point_along(alone, nearest_edge(alone, at, ""))


def place_on_wall(draft: Json, at: Point, level: str) -> Point:
    """The place on a wall that is nearest to a point; InputError where none is near."""
    edge = nearest_edge(draft, at, level)
    if edge.far > REACH:
        raise InputError("no wall is there", "choose a place on a wall")
    return point_along(draft, edge)


def point_along(draft: Json, edge: Edge) -> Point:
    """The place on a wall at its share."""
    a, b = [*edges_of(draft["rooms"][edge.room]["outline"])][edge.corner]
    return rounded(a + edge.share * (b - a))


def prolong(outlines: list[list[Point]], ends: list[Point]) -> list[Point]:
    """The ends of a wall with the walls in one line with it that it is joined to.

    >>> outlines = [[[0, 0], [2, 0], [2, 2], [0, 2]], [[2, 0], [5, 0], [5, 2], [2, 2]]]
    >>> prolong(outlines, [[0, 0], [2, 0]])
    [[0.0, 0.0], [5.0, 0.0]]
    """
    a, b = np.array(ends, float)
    long = float(np.hypot(*(b - a)))
    along = (b - a) / max(long, SAME)
    spans = []
    for outline in outlines:
        corners = np.array(outline, float) - a
        off, part = corners @ np.array([-along[1], along[0]]), corners @ along
        on = (abs(off) < SAME) & (abs(np.roll(off, -1)) < SAME)
        spans += np.sort(np.stack([part, np.roll(part, -1)], 1)[on], axis=1).tolist()
    low, high = 0.0, long
    for _ in spans:
        touching = [s for s in spans if s[0] <= high + SAME and s[1] >= low - SAME]
        low = min(low, *(s[0] for s in touching))
        high = max(high, *(s[1] for s in touching))
    return [rounded(a + low * along), rounded(a + high * along)]


def find_faces(outlines: list[list[Point]], ends: list[Point]) -> list[list[Point]]:
    """The sides of outlines that are faces of one wall, from one of its faces on: those in one line
    that are joined, and those that look at them from the other side of the wall.

    >>> outlines = [[[0, 0], [2, 0], [2, 2], [0, 2]], [[2.1, 0], [5, 0], [5, 2], [2.1, 2]]]
    >>> find_faces(outlines, [[2, 0], [2, 2]])
    [[[2.0, 0.0], [2.0, 2.0]], [[2.1, 2.0], [2.1, 0.0]]]
    """
    sides = [(a, b) for outline in outlines for a, b in edges_of(outline)]
    found, new = list[list[Point]](), [prolong(outlines, ends)]
    while new:
        face = new.pop()
        found.append(face)
        behind = [[*map(rounded, side)] for side in sides if _is_behind(face, *side)]
        for side in (prolong(outlines, one) for one in behind):
            known = any(lies_on(end, one) for one in (*found, *new) for end in (middle_of(side),))
            new += [] if known else [side]
    return found


def middle_of(ends: list[Point]) -> Point:
    """The middle between two places."""
    (ax, ay), (bx, by) = ends
    return [(ax + bx) / 2, (ay + by) / 2]


def _is_behind(face: list[Point], a: Any, b: Any) -> bool:
    """Whether a side looks at a face from the other side of a wall, or lies on it the other way
    round: it runs the other way, at most :data:`THICK` outside, and shares some of its length."""
    start, end = np.array(face, float)
    along, side = end - start, b - a
    long, wide = float(np.hypot(*along)), float(np.hypot(*side))
    if min(long, wide) < SAME or along @ side > -(1 - 1e-6) * long * wide:
        return False
    out = float((a - start) @ np.array([along[1], -along[0]])) / long
    low, high = sorted((float((b - start) @ along) / long, float((a - start) @ along) / long))
    return -SAME <= out <= THICK and min(high, long) - max(low, 0.0) > SHORTEST


def lies_on(at: Point, points: list[Point]) -> bool:
    """Whether a corner is one of some points, or lies between two of a wall."""
    if any(math.dist(at, point) < SAME for point in points):
        return True
    if len(points) != 2:
        return False
    a, b = points
    return abs(math.dist(a, at) + math.dist(at, b) - math.dist(a, b)) < SAME


def holds(outline: list[Point], x: float, y: float) -> bool:
    """Whether an outline goes round a point.

    >>> holds([[0, 0], [2, 0], [2, 2], [0, 2]], 1.0, 1.0)
    True
    """
    inside = False
    for (ax, ay), (bx, by) in zip(outline, [*outline[1:], outline[0]], strict=True):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
    return inside


def read_number(value: Any) -> float:
    """A number of metres; NaN for what is none."""
    plain = isinstance(value, int | float) and not isinstance(value, bool)
    return float(value) if plain and abs(value) <= FARTHEST else math.nan


def read_length(value: Any) -> float:
    """A length in metres; InputError for what is none."""
    number = read_number(value)
    if not number >= SHORTEST:
        raise InputError(f"{value!r} is no length", "type metres, such as 3.6")
    return number


def read_point(value: Any) -> Point:
    """A place in metres; InputError for what is none."""
    found = [read_number(one) for one in value] if isinstance(value, list) else []
    if len(found) != 2 or not all(math.isfinite(number) for number in found):
        raise InputError("is no place on the plan", "give [x, y] in metres")
    return rounded(found)


def read_points(value: Any, least: int = 1) -> list[Point]:
    """A list of ``least`` places or more; InputError for what is none."""
    if not isinstance(value, list) or not least <= len(value) <= MOST:
        raise InputError(f"is no list of {least} to {MOST} places", "give [[x, y], ...] in metres")
    return [read_point(one) for one in value]


def rounded(point: Any) -> Point:
    """A place to a tenth of a millimetre."""
    return [round(float(number), 4) for number in point]
