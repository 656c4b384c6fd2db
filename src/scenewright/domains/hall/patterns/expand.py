"""From the layers of a unit to the boxes of its objects, and back to layers that make sense."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from scenewright.domains.hall.patterns import CODE, MIXTURE, PART, PATTERNS
from scenewright.engine.rows import load_function
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import compiled, inlined

_ROWS = tuple(PATTERNS.values())
CENTRED = tuple(code for code, row in enumerate(_ROWS) if row.centre == "rings")
GAPPED = tuple(code for code, row in enumerate(_ROWS) if row.moves == "gaps")
GROWTH = np.array([row.extra for row in _ROWS])
"""Codes of patterns whose objects stand round a middle, and of those that have gaps; how the extra
measure of each grows a metre, its least and its greatest (patterns, 3)."""


def _place_or(code: int, place: Callable[..., int], before: Callable[..., int]) -> Any:
    """The parts ``before`` can place, and those of one pattern more."""

    @inlined
    def place_part(
        layers: Floats,
        first: int,
        last: int,
        extra: float,
        sizes: Floats,
        start: int,
        out: Floats,
        at: int,
    ) -> int:
        """Place the layers of one part by their pattern; how many objects it has.

        ``layers`` (L, 5), ``sizes`` (n, 2) width and depth from row ``start``, ``out`` (m, 3)
        written from row ``at``; metres and radians.
        """
        if int(layers[first, CODE]) == code:
            return place(layers, first, last, extra, sizes, start, out, at)
        return before(layers, first, last, extra, sizes, start, out, at)

    return place_part


def _lay_or(own: int, lay: Callable[..., Any], before: Callable[..., Any]) -> Any:
    """The units ``before`` can lay out, and those of one pattern more."""

    @inlined
    def lay_unit(
        code: int,
        layers: Floats,
        number: int,
        shape: float,
        wide: float,
        deep: float,
        along: float,
        across: float,
        near: float,
    ) -> tuple[int, float]:
        """Write the layers of a unit by its pattern; see :func:`.chain.lay_chain`.

        ``layers`` (L, 5).
        """
        if code == own:
            return lay(code, layers, number, shape, wide, deep, along, across, near)
        return before(code, layers, number, shape, wide, deep, along, across, near)

    return lay_unit


place_part, lay_unit = (
    load_function(f"{__package__}.chain:{name}_chain") for name in ("place", "lay")
)
for _code, _row in enumerate(_ROWS):
    if _row.place:
        place_part = _place_or(_code, load_function(_row.place), place_part)
    lay_unit = _lay_or(_code, load_function(_row.layout), lay_unit)


@inlined
def shift_to(
    out: Floats, at: int, end: int, sizes: Floats, start: int, left: float, centred: bool
) -> float:
    """Move objects so that their bounds start at x = ``left`` (or are centred on x) and are
    centred on y; the width of the bounds.

    ``out`` (m, 3) rows ``at`` to ``end`` - 1, changed in place; ``sizes`` (n, 2) in metres from
    row ``start``.
    """
    x0, x1, y0, y1 = math.inf, -math.inf, math.inf, -math.inf
    for i in range(at, end):
        c, s = abs(math.cos(out[i, 2])), abs(math.sin(out[i, 2]))
        w, d = 0.5 * sizes[start + i - at, 0], 0.5 * sizes[start + i - at, 1]
        x0, x1 = min(x0, out[i, 0] - c * w - s * d), max(x1, out[i, 0] + c * w + s * d)
        y0, y1 = min(y0, out[i, 1] - s * w - c * d), max(y1, out[i, 1] + s * w + c * d)
    dx = -0.5 * (x0 + x1) if centred else left - x0
    for i in range(at, end):
        out[i, 0] += dx
        out[i, 1] -= 0.5 * (y0 + y1)
    return x1 - x0


@compiled
def expand(code: int, layers: Floats, extra: float, sizes: Floats, start: int, out: Floats) -> int:
    """Write x (right), y (ahead) and turn of a unit's objects in its own frame to ``out``.

    ``layers`` are the used ones; ``extra`` is the angle of a fan, the width of the aisles of a
    chain or the gap of a mixture. The origin is the middle of the bounds, for rings their centre.
    Not for wall rows. ``layers`` (k, 5), ``sizes`` (n, 2) width and depth in metres from row
    ``start``, ``out`` (m, 3) from row 0; returns how many were placed.
    """
    used, first, i, left = layers.shape[0], 0, 0, 0.0
    while first < used:
        last = first + 1
        while last < used and layers[last, PART] == layers[first, PART]:
            last += 1
        own = 0.0 if code == MIXTURE else extra
        placed = place_part(layers, first, last, own, sizes, start + i, out, i)
        if code == MIXTURE:
            left += extra + shift_to(out, i, i + placed, sizes, start + i, left, False)
        i, first = i + placed, last
    if code not in CENTRED:
        shift_to(out, 0, i, sizes, start, 0.0, True)
    return i


@compiled
def seed(
    code: int,
    number: int,
    shape: float,
    wide: float,
    deep: float,
    along: float,
    across: float,
    near: float,
    layers: Floats,
) -> tuple[int, float]:
    """Write layers (L, 5) for ``number`` objects; how many layers, and the unit's extra measure.

    See :func:`.chain.lay_chain` for the measures.
    """
    return lay_unit(code, layers, number, shape, wide, deep, along, across, near)


@compiled
def stretch(code: int, layers: Floats, extra: float, along: float, across: float) -> float:
    """Expand (positive) or shrink a pattern in place by metres along its rows and across them;
    the new extra measure.

    Rows change their gaps, rings and arcs their radii, further out the more. ``layers`` (k, 5)
    is changed in place.
    """
    rank = 0
    for k in range(layers.shape[0]):
        kind = int(layers[k, CODE])
        rank = rank + 1 if k > 0 and layers[k, PART] == layers[k - 1, PART] else 1
        if kind in GAPPED:
            layers[k, 1] = max(layers[k, 1] + along, 0.0)
            layers[k, 2] = max(layers[k, 2] + across, 0.0)
        elif layers[k, 2] > 0.0:
            layers[k, 2] = max(layers[k, 2] + across * rank, 0.3)
    return min(max(extra + GROWTH[code, 0] * along, GROWTH[code, 1]), GROWTH[code, 2])
