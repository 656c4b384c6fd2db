"""Bar stools: before counters to sit at, and round high tables."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.kinds.usual import HIGH, is_high
from scenewright.core.scene import Piece, Size
from scenewright.domains.hall.accessories.counter_rows import join_counters
from scenewright.domains.hall.accessories.setting import Setting
from scenewright.domains.hall.accessories.spots import Spots, face, join_spots, make_spots
from scenewright.domains.hall.demands.holdings import HallDemand, may_stand_together
from scenewright.domains.hall.problem import Floats

COUNTER, STOOL, SHOW = "counter", "bar_stool", "display_table"
PLACE, OFF, SERVED = 0.6, 0.05, 0.9
"""Metres of a counter for each stool, between the two, and of each counter that stay free for who
is served standing."""
STOOL_CLOSE, STOOL_LITTLE = 0.55, 0.8
"""The same where one more finds a place so."""
AT_TABLE, SERVING, STOOL_NEXT = 0.5, 1.5, 0.04
"""What a place at a table costs more than one at a bar, one at any other counter, where others
queue, and each next one of the same."""
BARS = ("bar", "theke", "tresen", "barra", "comptoir à", "吧台", "バー", "カウンター席")
"""Parts of the names of counters to sit at."""
STOOL_GAP = 0.9
"""Metres from stool to stool before a counter at most."""
SMALL_STOOL = 0.9
"""Up to how many metres wide and deep a table has a place at each of its sides."""


def may_sit_high(wish: HallDemand, wishes: list[HallDemand]) -> bool:
    """Whether some counter or high table may stand in a zone of stools."""
    return any(
        (other.category == COUNTER or may_sit_at(other.category, other.sizes[0].height))
        and may_stand_together(wish, other)
        for other in wishes
    )


def may_sit_at(category: str, height: float) -> bool:
    """Whether one may sit on bar stools round a table: a high one, or one as high with something
    on it.

    >>> may_sit_at("round_table", 1.1), may_sit_at("display_table", 1.05)
    (True, True)
    >>> may_sit_at("display_table", 0.9)
    False
    """
    return is_high(category, height) or (category == SHOW and height >= HIGH)


def find_stool_spots(setting: Setting, size: Size) -> Spots:
    """Spots before the counters and round the high tables that stand."""
    parts = [make_spots(np.zeros((0, 5)), 0.0)]
    for row in join_counters([p for p in setting.pieces if p.category == COUNTER]):
        cost = 0.0 if is_bar(row.function) else SERVING
        parts.append(_weigh(list(_before(row, size)), cost))
    for piece in setting.pieces:
        if may_sit_at(piece.category, piece.size.height):
            parts.append(_weigh(list(_around(piece, size)), AT_TABLE))
    return join_spots(parts)


def _weigh(rows: list[Floats], cost: float) -> Spots:
    """Spots (k, 5) of one piece, each next one dearer."""
    boxes = np.array(rows).reshape(-1, 5)
    costs: Floats = cost + STOOL_NEXT * np.arange(len(boxes), dtype=np.float64)
    return make_spots(boxes, costs)


def _before(counter: Piece, size: Size) -> Iterator[Floats]:
    """Places along the front of a counter but for its last metre, looking at it."""
    heading, wide = counter.pose.heading, counter.size.width
    front = np.array([math.cos(heading), math.sin(heading)])
    right = np.array([front[1], -front[0]])
    at = np.array(counter.pose[:2]) + (0.5 * (counter.size.depth + size.depth) + OFF) * front
    count = count_before(wide)
    pitch = PLACE if count == _count(wide, PLACE, SERVED) else STOOL_CLOSE
    for number in range(count):
        along = (number + 0.5) * pitch - 0.5 * wide
        yield face((at + along * right)[None], heading + math.pi, size)[0]


def list_fronts(pieces: Sequence[Piece]) -> Iterator[tuple[Piece, float]]:
    """What stools stand before in lines, its front towards them, and how many metres of each stay
    free: counters, and both long sides of high tables."""
    for row in join_counters([p for p in pieces if p.category == COUNTER]):
        yield row, SERVED
    for table in pieces:
        if may_sit_at(table.category, table.size.height) and not sits_around(table.size):
            for turn in (0.0, math.pi):
                pose = table.pose._replace(heading=table.pose.heading + turn)
                yield replace(table, pose=pose), 0.0


def spread_stools(counter: Piece, boxes: Floats, served: float = SERVED) -> Floats:
    """Stools (k, 5) evenly along the middle of the front of the counter they stand before, but for
    the metres of it where others are ``served``.

    >>> from scenewright.core.scene import Pose
    >>> bar = Piece(id="bar", category="counter", asset="", space="",
    ...             pose=Pose(0, 0, 0, math.pi / 2), size=Size(3.0, 0.6, 1.1))
    >>> stools = np.array(list(_before(bar, Size(0.4, 0.4, 0.8)))[:2])
    >>> spread_stools(bar, stools)[:, 0].round(2) + 0.0
    array([-0.45,  0.45])
    """
    heading, count = counter.pose.heading, len(boxes)
    right = np.array([math.sin(heading), -math.cos(heading)])
    along = (boxes[:, :2] - counter.pose[:2]) @ right
    pitch = min(max((counter.size.width - served) / count, STOOL_CLOSE), STOOL_GAP)
    evenly, order = pitch * (np.arange(count) - 0.5 * (count - 1)), np.argsort(along)
    found = boxes.copy()
    found[order, :2] += (evenly - along[order])[:, None] * right
    return found


def stand_before(counter: Piece, boxes: Floats) -> NDArray[np.bool_]:
    """Which of some stools (k, 5) stand before a counter."""
    heading = counter.pose.heading
    front = np.array([math.cos(heading), math.sin(heading)])
    off = boxes[:, :2] - np.array(counter.pose[:2])
    ahead = off @ front - 0.5 * (counter.size.depth + boxes[:, 4])
    along = np.abs(off @ (front[1], -front[0]))
    return np.asarray((np.abs(ahead - OFF) < OFF) & (along < 0.5 * counter.size.width))


def count_before(wide: float) -> int:
    """How many stools fit before a counter ``wide`` metres long, closer together where that makes
    room for one more.

    >>> count_before(4.0), count_before(3.0)
    (5, 4)
    """
    return max(_count(wide, PLACE, SERVED), _count(wide, STOOL_CLOSE, STOOL_LITTLE))


def _count(wide: float, place: float, served: float) -> int:
    return max(int((wide - served) / place + 1e-9), 0)


def is_bar(name: str) -> bool:
    """Whether a counter of some name is one to sit at.

    >>> is_bar("coffee bar"), is_bar("bread counter")
    (True, False)
    """
    return any(word in name.casefold() for word in BARS)


def count_around(table: Size) -> int:
    """How many stools have a place at a table: at each side of a small one, else along two.

    >>> count_around(Size(0.7, 0.7, 1.1)), count_around(Size(1.8, 0.6, 1.1))
    (4, 6)
    """
    return 4 if sits_around(table) else 2 * max(int(table.width / PLACE + 1e-9), 1)


def sits_around(table: Size) -> bool:
    """Whether a table has a place at each of its sides."""
    return max(table.width, table.depth) <= SMALL_STOOL


def _around(table: Piece, size: Size) -> Iterator[Floats]:
    """Places at the sides of a table, each across from another, looking at it; first those in the
    middle."""
    sides = (0, 2, 1, 3) if sits_around(table.size) else (0, 2)
    each = count_around(table.size) // len(sides)
    pitch = table.size.width / each
    for number in sorted(range(each), key=lambda n: abs(2 * n - each + 1)):
        for turns in sides:
            angle = table.pose.heading + 0.5 * math.pi * turns
            deep = table.size.width if turns % 2 else table.size.depth
            front = np.array([math.cos(angle), math.sin(angle)])
            right = np.array([front[1], -front[0]])
            aside = ((number + 0.5) * pitch - 0.5 * table.size.width) * (1.0 - turns)
            at = np.array(table.pose[:2]) + (0.5 * (deep + size.depth) + OFF) * front
            at = at + aside * right * (len(sides) == 2)
            yield face(at[None], angle + math.pi, size)[0]
