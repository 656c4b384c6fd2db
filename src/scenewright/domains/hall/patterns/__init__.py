"""Patterns: how a group of like objects is laid out, and what a move changes.

A unit's *layers* are rows of an array (k, 5): how many objects, two measures in metres (see
:class:`scenewright.domains.hall.hall_layout.Layer`), the pattern of the layer and the part it
belongs to. Cao, Cheng, Zhang 2024 give five patterns; the grid is ours. A new pattern is one file
with a function that places its layers and one that lays out a unit, and one row here or one entry
point of another package, ``"hall.name" = "package.module:ROW"``; its code is its place among the
rows.
"""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

from scenewright.core.registry import load_added

GROUP = "scenewright.patterns"
NUMBER, ALONG, ACROSS, CODE, PART = range(5)
"""Columns of the layers."""

SINGLE, CHAIN, GRID, RADIATION, CIRCULATION, FAN, MIXTURE, WALL, AROUND = range(9)
"""Codes of the patterns: the rows of :data:`PATTERNS` in order."""


class PatternRow(NamedTuple):
    """One pattern: its name, what it is, what it is for, and where it comes from.

    ``place`` and ``layout``, as "package.module:name", are compiled functions:
    ``place(layers, first, last, extra, sizes, start, out, at) -> int`` writes the objects of layers
    ``first`` to ``last`` - 1 (see :func:`.chain.place_chain`); ``layout(code, layers, number,
    shape, wide, deep, along, across, near) -> (used, extra)`` writes the layers of a unit (see
    :func:`.chain.lay_chain`). Without ``place`` its layers are those of other patterns.
    ``centre`` is the origin of its objects: the middle of their bounds, or of their rings.
    ``moves`` tells what stretching changes, gaps or radii. ``extra`` is how the extra measure
    grows a metre, its least and its greatest. ``least`` is the fewest objects it is meant for.
    """

    name: str
    about: str
    used_for: str
    source: str
    place: str = ""
    layout: str = ""
    centre: Literal["bounds", "rings"] = "bounds"
    moves: Literal["gaps", "radii"] = "gaps"
    extra: tuple[float, float, float] = (0.0, -math.inf, math.inf)
    least: float = 1


_PAPER = "Cao, Cheng, Zhang 2024, Fig. 2"
_ROWS = (
    PatternRow(
        "single",
        "one object by itself",
        "counters, stages, landmarks",
        "Cao, Cheng, Zhang 2024, T = -1",
        layout=f"{__name__}.mixture:lay_single",
        least=math.inf,
    ),
    PatternRow(
        "chain",
        "rows one behind another, all facing the front",
        "shelves, seats, showcases",
        _PAPER,
        place=f"{__name__}.chain:place_chain",
        layout=f"{__name__}.chain:lay_chain",
    ),
    PatternRow(
        "grid",
        "rows and columns, aligned both ways",
        "tables, plinths, gates",
        "ours",
        place=f"{__name__}.grid:place_grid",
        layout=f"{__name__}.grid:lay_grid",
    ),
    PatternRow(
        "radiation",
        "rings of regular polygons around a centre, facing out",
        "showcases around a centrepiece",
        _PAPER,
        place=f"{__name__}.radiation:place_radiation",
        layout=f"{__name__}.radiation:lay_radiation",
        centre="rings",
        moves="radii",
    ),
    PatternRow(
        "circulation",
        "a closed ring of objects side by side, facing out",
        "ring shelves in shops",
        _PAPER,
        place=f"{__name__}.ring:place_circulation",
        layout=f"{__name__}.ring:lay_circulation",
        centre="rings",
        moves="radii",
    ),
    PatternRow(
        "fan",
        "arcs of a sector, facing its apex",
        "auditorium seats",
        _PAPER,
        place=f"{__name__}.fan:place_fan",
        layout=f"{__name__}.fan:lay_fan",
        moves="radii",
        extra=(0.1, 0.3, 0.95 * math.pi),
    ),
    PatternRow(
        "mixture",
        "several patterns side by side",
        "two chains and a radiation",
        _PAPER,
        layout=f"{__name__}.mixture:lay_mixture",
        extra=(1.0, 0.0, math.inf),
        least=6,
    ),
    PatternRow(
        "wall",
        "a row with its backs at the walls of the zone",
        "wall cases, wall shelving",
        "Cao, Cheng, Zhang 2024, wall objects",
        layout=f"{__name__}.mixture:lay_single",
    ),
    PatternRow(
        "around",
        "two by two, looking at each other over a low table",
        "lounge seats",
        "ours",
        place=f"{__name__}.around:place_around",
        layout=f"{__name__}.around:lay_around",
    ),
)
PATTERNS: dict[str, PatternRow] = {
    row.name: row for row in (*_ROWS, *load_added(GROUP, "hall", PatternRow))
}
"""All patterns by name, those of other packages last."""
