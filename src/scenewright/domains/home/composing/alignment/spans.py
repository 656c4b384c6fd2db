"""The free stretch of wall that a piece stands in, what ends it, and what gaps beside it cost."""

from __future__ import annotations

from math import cos
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.composing.places.flush import AT, FLUSH_GAP, boxes_along, seen_from
from scenewright.domains.home.composing.places.wall_stretch import INSIDE, STOOD_OVER
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.grounds.wall_places import read_walls
from scenewright.domains.home.measures import ALIKE
from scenewright.domains.home.problem import Ground

Floats = NDArray[np.float64]

OPEN, CORNER, CASE, DOOR = range(4)
"""What ends a stretch: nothing that minds a gap, a wall, a case, the floor of a door."""
CASES = frozenset(
    (
        *("wardrobe", "chest_of_drawers", "bookcase", "shelf_unit", "storage_shelf", "sideboard"),
        *("tv_stand", "desk", "kids_desk", "vanity", "shoe_cabinet", "console_table", "toy_box"),
        *("nightstand", "fridge", "base_cabinet", "drawer_cabinet", "sink_cabinet", "hob_cabinet"),
        *("corner_cabinet", "dishwasher", "washing_machine", "fireplace"),
    )
)
"""Kinds with straight sides, beside which a slit shows."""
GAP_SHOWS, DEAD, SLIT = 0.02, 0.6, 0.3
"""Gap widths in metres from which a gap shows and up to which it is useless, and what one costs, in
metres off an axis."""
OFF_DOOR = 0.15  # what ends nearer to the floor of a door is brushed by who passes, metres


class Span(NamedTuple):
    """A stretch of a wall: x, y of the wall's start and its unit direction (``row``), the heading
    of what has its back there, from where to where along the wall nothing stands, the middle of
    the piece in it (``at``), metres, and what it ends at on either side."""

    row: tuple[float, float, float, float]
    heading: float
    start: float
    end: float
    at: float
    ends: tuple[int, int]

    def box_at(self, middle: float, case: Group) -> Floats:
        """The box (5,) of a case with its middle at ``middle`` metres along the wall."""
        return boxes_along(np.array([middle]), self.row, self.heading, case)[0]

    def along(self, x: float, y: float) -> float:
        """How many metres along the wall a point is."""
        return (x - self.row[0]) * self.row[2] + (y - self.row[1]) * self.row[3]

    def cost_at(self, middle: float, width: float) -> float:
        """What the gaps on both sides of a piece of ``width`` with that ``middle`` cost."""
        gaps = (middle - width / 2 - self.start, self.end - middle - width / 2)
        return sum(cost_of_gap(gap, end) for gap, end in zip(gaps, self.ends, strict=True))

    def list_flush(self, width: float) -> list[float]:
        """Middles at which a piece of ``width`` touches an end of the stretch, or keeps off a door
        there."""
        off = [OFF_DOOR * (end == DOOR) for end in self.ends]
        found = (self.start + off[0] + width / 2, self.end - off[1] - width / 2)
        return [m for m in found if self.holds(m, width)]

    def without_cases(self) -> Span:
        """The stretch for what may stand apart from walls and cases."""
        first, last = (end if end == DOOR else OPEN for end in self.ends)
        return self._replace(ends=(first, last))

    def holds(self, middle: float, width: float) -> bool:
        """Whether a piece of ``width`` with that ``middle`` is within the stretch."""
        room = min(middle - self.start, self.end - middle) - width / 2
        return room > -FLUSH_GAP


def cost_of_gap(gap: float, end: int) -> float:
    """What a ``gap`` (metres) to the ``end`` of a stretch costs.

    >>> [cost_of_gap(gap, CORNER) for gap in (0.0, 0.1, 0.5, 0.7)], cost_of_gap(0.1, OPEN)
    ([0.0, 0.3, 0.3, 0.0], 0.0)
    >>> cost_of_gap(0.05, DOOR), cost_of_gap(0.15, DOOR)
    (0.2, 0.0)
    """
    if end == DOOR:
        return round(SLIT * max(OFF_DOOR - gap, 0.0) / OFF_DOOR, 9)
    return SLIT if end != OPEN and GAP_SHOWS < gap < DEAD else 0.0


def find_span(
    ground: Ground, box: Floats, depth: float, height: float, standing: StandingObstacles
) -> Span | None:
    """The stretch of the wall behind a box (5,) that is free ``depth`` deep and ``height`` high
    beside ``standing``; None for a box at no wall."""
    walls = read_walls(ground)
    x, y, heading, _, deep = box.tolist()
    for number, turn in enumerate(walls.heading.tolist()):
        wx, wy, ux, uy, length = walls.rows[number].tolist()
        out, at = (y - wy) * ux - (x - wx) * uy, (x - wx) * ux + (y - wy) * uy
        if cos(turn - heading) > ALIKE and abs(out - deep / 2) < AT and 0.0 <= at <= length:
            ends = _list_ends(ground, standing, (wx, wy, ux, uy, length), depth, height)
            (start, first), (end, last) = _nearest(ends, at)
            return Span((wx, wy, ux, uy), turn, start, end, at, (first, last))
    return None


Row = tuple[float, float, float, float, float]
Ends = list[tuple[float, float, int]]


def _nearest(ends: Ends, at: float) -> tuple[tuple[float, int], tuple[float, int]]:
    """Where the stretch about ``at`` begins and ends, and at what, from the extents of obstacles
    along the wall; of two that end alike the one that minds a gap more."""
    before = max((high, kind) for low, high, kind in ends if low + high <= 2 * at)
    after = min((low, -kind) for low, high, kind in ends if low + high > 2 * at)
    return before, (after[0], -after[1])


def _list_ends(
    ground: Ground, standing: StandingObstacles, row: Row, depth: float, height: float
) -> Ends:
    """From where to where along a wall something stands before it, and what that is, the corners
    among them."""
    met = (standing.spans[:, 0] < height) & (standing.spans[:, 1] > STOOD_OVER)
    low = ground.windows[ground.windows[:, 5] < height, :5]
    named = [CASE if n in CASES else OPEN for n, m in zip(standing.names, met, strict=True) if m]
    doors = ground.strips[ground.strips[:, 5] == 0.0, :5]
    kinds = [*named, *[DOOR] * len(ground.keep_free), *[OPEN] * (len(low) + len(doors))]
    taken = np.concatenate([standing.boxes[met], ground.keep_free, low, doors])
    along, out, half, deep = seen_from(taken, *row[:4])
    there = (out - deep < depth - INSIDE) & (out + deep > INSIDE)
    lows, highs = (along - half - FLUSH_GAP).tolist(), (along + half + FLUSH_GAP).tolist()
    found = [(lows[k], highs[k], kinds[k]) for k in np.flatnonzero(there).tolist()]
    length, (first, last) = row[4], _list_corners(ground, row)
    return [*found, (-length - 1e3, 0.0, first), (length, 2 * length + 1e3, last)]


def _list_corners(ground: Ground, row: Row) -> tuple[int, int]:
    """What a wall itself ends at on either side: a corner where the next edge turns inwards."""
    x, y, ux, uy, length = row
    edges = ground.edges
    ways = edges[:, 2:] - edges[:, :2]
    inward = uy * ways[:, 0] - ux * ways[:, 1]  # of edges that come in: > 0 turns left
    ends_here = np.hypot(edges[:, 2] - x, edges[:, 3] - y) < AT
    starts_there = np.hypot(edges[:, 0] - x - ux * length, edges[:, 1] - y - uy * length) < AT
    first = bool((ends_here & (inward > AT)).any())
    last = bool((starts_there & (-inward > AT)).any())
    return CORNER if first else OPEN, CORNER if last else OPEN
