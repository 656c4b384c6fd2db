"""Counters that stand side by side are one to whoever sits before them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from scenewright.core.scene import Piece

COUNTER_GAP, LINE_OFF, LINE_TURNED = 0.08, 0.03, 0.01
"""Metres between two counters of one row at most and by which one stands farther back, and radians
by which one is turned."""


def join_counters(counters: Sequence[Piece]) -> list[Piece]:
    """The counters, those of one function side by side in a row as one as wide as the row.

    >>> from scenewright.core.scene import Pose, Size
    >>> def put(name, x, heading=math.pi / 2):
    ...     pose, size = Pose(x, 0.0, 0.0, heading), Size(1.6, 0.6, 1.05)
    ...     return Piece(name, "counter", "", "a", pose, size, "bar", "bar")
    >>> rows = join_counters([put("a", 0.0), put("c", 3.2), put("b", 1.6), put("d", 6.0)])
    >>> [(row.id, round(row.pose.x, 2), round(row.size.width, 2)) for row in rows]
    [('a', 1.6, 4.8), ('d', 6.0, 1.6)]
    """
    left, rows = list(counters), list[Piece]()
    while left:
        row = left.pop(0)
        while (more := next((one for one in left if _stand_in_line(row, one)), None)) is not None:
            left.remove(more)
            row = _join(row, more)
        rows.append(row)
    return rows


def _stand_in_line(row: Piece, one: Piece) -> bool:
    """Whether a counter goes on with a row at one of its ends."""
    if (
        row.function != one.function
        or abs(math.sin(row.pose.heading - one.pose.heading)) > LINE_TURNED
    ):
        return False
    if math.cos(row.pose.heading - one.pose.heading) < 0.0:
        return False
    along, ahead = _measure_off(row, one)
    gap = abs(along) - 0.5 * (row.size.width + one.size.width)
    return abs(ahead) <= LINE_OFF and gap <= COUNTER_GAP


def _join(row: Piece, one: Piece) -> Piece:
    """A row with a counter more at one of its ends."""
    along, _ = _measure_off(row, one)
    low = min(-0.5 * row.size.width, along - 0.5 * one.size.width)
    high = max(0.5 * row.size.width, along + 0.5 * one.size.width)
    right, middle = _right_of(row), 0.5 * (low + high)
    pose = row.pose._replace(x=row.pose.x + middle * right[0], y=row.pose.y + middle * right[1])
    return replace(row, pose=pose, size=row.size._replace(width=high - low))


def _measure_off(row: Piece, one: Piece) -> tuple[float, float]:
    """How far a counter lies from a row to its right and ahead, in metres."""
    x, y = one.pose.x - row.pose.x, one.pose.y - row.pose.y
    right = _right_of(row)
    return x * right[0] + y * right[1], x * -right[1] + y * right[0]


def _right_of(row: Piece) -> tuple[float, float]:
    """The direction to the right of its staff, looking ahead."""
    return math.sin(row.pose.heading), -math.cos(row.pose.heading)
