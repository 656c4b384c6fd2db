"""Rows of buildings: strip by strip from front to back, each behind the last as the rule says."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.site.solvers.blocks.strips import STEP, Turned, next_strip, write_spans
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

OPEN = 0.5
"""How many heights of a row the gap behind it widens by, at least, where there is room for it."""
SPREAD, HAIR = 1.5, 1e-9
"""How many gaps neighbours of a row are spread apart at most; metres that rounding may take."""


class StripRule(NamedTuple):
    """How rows are set: ``spacing`` between neighbours; behind a row the spacing, a ``way`` or its
    height times ``sun``, whichever is most. ``loose`` above 1 widens both, gaps behind by their
    height too. Rows that fill less than a whole strip are spread over it (``spread``), every other
    one is shifted by half a place (``staggered``)."""

    spacing: float
    way: float
    sun: float
    loose: float
    staggered: bool
    spread: bool

    def beside(self) -> float:
        """Metres between neighbours."""
        return self.spacing + (self.loose - 1.0) * max(self.spacing, self.way)


def rows(
    block: Turned, sizes: Floats, queue: list[int], rule: StripRule
) -> list[tuple[int, float, float]]:
    """Set buildings of a queue (rows of ``sizes`` (n, 3)) in strips from front to back; their
    numbers with x and y in the frame of the rows.

    A strip is as deep as the first building waiting; others join it if they are no deeper. Behind
    it stays what the rule says.
    """
    waiting, scratch = np.array(queue, np.int64), np.empty((2, len(block.edges), 2))
    placed, numbers = np.empty((len(waiting), 2)), np.empty(len(waiting), np.int64)
    count = set_rows(block.edges, sizes, waiting, rule, rule.beside(), scratch, placed, numbers)
    return [
        (i, x, y)
        for i, (x, y) in zip(numbers[:count].tolist(), placed[:count].tolist(), strict=True)
    ]


@compiled
def set_rows(
    edges: Floats,
    sizes: Floats,
    waiting: Ints,
    rule: StripRule,
    gap: float,
    scratch: Floats,
    placed: Floats,
    numbers: Ints,
) -> int:
    """Write the ``numbers`` (k,) of buildings set and where, ``placed`` (k, 2), and say how many;
    ``waiting`` (k,) are theirs in turn, -1 once set; ``scratch`` (2, e, 2)."""
    work, spans = scratch[0], scratch[1]
    top, bottom = -math.inf, math.inf
    for k in range(edges.shape[0]):
        top = max(top, max(edges[k, 1], edges[k, 3]))
        bottom = min(bottom, min(edges[k, 1], edges[k, 3]))
    count, strip, first = 0, 0, 0
    while first < waiting.shape[0]:
        deep = sizes[waiting[first], 1]
        if top - deep < bottom:
            break
        least = math.inf
        for k in range(first, waiting.shape[0]):
            if waiting[k] >= 0 and sizes[waiting[k], 1] <= deep + HAIR:
                least = min(least, sizes[waiting[k], 0])
        top = next_strip(edges, top, bottom, (deep, least), work, spans)
        found = write_spans(edges, top - deep, top, work, spans)
        free, row = spans[:found], (strip, count)
        after = fill_strip(sizes, waiting, first, free, top, deep, rule, gap, row, placed, numbers)
        if after == count:
            top -= STEP
            continue
        tall = 0.0
        for k in range(count, after):
            tall = max(tall, sizes[numbers[k], 2])
        nearest = max(max(rule.spacing, rule.way), rule.sun * tall)
        top -= deep + nearest + (rule.loose - 1.0) * max(nearest, OPEN * tall)
        count, strip = after, strip + 1
        while first < waiting.shape[0] and waiting[first] < 0:
            first += 1
    return count


@inlined
def fill_strip(
    sizes: Floats,
    waiting: Ints,
    first: int,
    spans: Floats,
    top: float,
    deep: float,
    rule: StripRule,
    gap: float,
    row: tuple[int, int],
    placed: Floats,
    numbers: Ints,
) -> int:
    """Set buildings in one strip, left to right in every free span (s, 2); how many are set then.
    ``row`` is the number of the strip from the front and how many stand in those before."""
    reach, strip, count = -math.inf, row[0], row[1]
    for s in range(spans.shape[0]):
        x0, begin = max(spans[s, 0], reach + gap), count
        room = spans[s, 1] - x0
        for k in range(first, waiting.shape[0]):
            here = waiting[k]
            if here < 0 or sizes[here, 1] > deep + HAIR:
                continue
            need = sizes[here, 0] + (gap if count > begin else 0.0)
            if need <= room + HAIR:
                numbers[count], waiting[k] = here, -1
                count += 1
                room -= need
            elif room < gap:
                break
        if count > begin:
            spread_row(sizes, numbers, begin, count, (x0, room, top), gap, rule, strip, placed)
            reach = placed[count - 1, 0] + 0.5 * sizes[numbers[count - 1], 0]
    return count


@inlined
def spread_row(
    sizes: Floats,
    numbers: Ints,
    begin: int,
    end: int,
    at: tuple[float, float, float],
    gap: float,
    rule: StripRule,
    strip: int,
    placed: Floats,
) -> None:
    """Write the places of a row ``at`` x0, with room left over, and y of its fronts: the room is
    shared among the gaps, half of the rest lies before it."""
    x0, room, top = at
    extra = min(room / (end - begin + 1) if rule.spread else 0.0, SPREAD * gap)
    over = room - extra * (end - begin - 1)
    x = x0 + 0.5 * over
    if rule.staggered:
        shift = min(over, sizes[numbers[begin], 0] + gap)
        x += 0.5 * shift if strip % 2 else -0.5 * shift
    for k in range(begin, end):
        wide = sizes[numbers[k], 0]
        placed[k, 0], placed[k, 1] = x + 0.5 * wide, top - 0.5 * sizes[numbers[k], 1]
        x += wide + gap + extra
