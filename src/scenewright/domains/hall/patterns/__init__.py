"""Patterns: how a group of like objects is laid out, and what a move changes.

A unit's *layers* are rows of an array (k, 5): how many objects, two measures in metres (see
:class:`scenewright.domains.hall.hall_layout.Layer`), the pattern of the layer and the part it
belongs to. Cao, Cheng, Zhang 2024 give five patterns; the grid is ours. A new pattern is one file
with a function that places its layers and one that seeds them, a row here and a line in
:mod:`.expand` and :mod:`.seed`.
"""

from __future__ import annotations

from typing import NamedTuple

NUMBER, ALONG, ACROSS, CODE, PART = range(5)
"""Columns of the layers."""

SINGLE, CHAIN, GRID, RADIATION, CIRCULATION, FAN, MIXTURE, WALL = range(8)
"""Codes of the patterns: the rows of :data:`PATTERNS` in order."""


class PatternRow(NamedTuple):
    """One pattern: its name, what it is, what it is for, and where it comes from."""

    name: str
    about: str
    used_for: str
    source: str


_PAPER = "Cao, Cheng, Zhang 2024, Fig. 2"
_ROWS = (
    PatternRow(
        "single",
        "one object by itself",
        "counters, stages, landmarks",
        "Cao, Cheng, Zhang 2024, T = -1",
    ),
    PatternRow(
        "chain",
        "rows one behind another, all facing the front",
        "shelves, seats, showcases",
        _PAPER,
    ),
    PatternRow("grid", "rows and columns, aligned both ways", "tables, plinths, gates", "ours"),
    PatternRow(
        "radiation",
        "rings of regular polygons around a centre, facing out",
        "showcases around a centrepiece",
        _PAPER,
    ),
    PatternRow(
        "circulation",
        "a closed ring of objects side by side, facing out",
        "ring shelves in shops",
        _PAPER,
    ),
    PatternRow("fan", "arcs of a sector, facing its apex", "auditorium seats", _PAPER),
    PatternRow("mixture", "several patterns side by side", "two chains and a radiation", _PAPER),
    PatternRow(
        "wall",
        "a row with its backs at the walls of the zone",
        "wall cases, wall shelving",
        "Cao, Cheng, Zhang 2024, wall objects",
    ),
)
PATTERNS: dict[str, PatternRow] = {row.name: row for row in _ROWS}
