"""Names of layers in DXF for those of a plan, after the US National CAD Standard (AIA)."""

from __future__ import annotations

import re
from typing import NamedTuple


class LayerRow(NamedTuple):
    """A layer of DXF: its name, and its colour by AutoCAD's index (7 is black on white)."""

    name: str
    colour: int = 7


LAYERS = {
    "Walls": LayerRow("A-WALL"),
    "Windows and doors": LayerRow("A-DOOR"),
    "Ways in": LayerRow("A-DOOR-IDEN"),
    "Sills and heads": LayerRow("A-GLAZ-IDEN", 8),
    "Furniture": LayerRow("A-FURN"),
    "Short names": LayerRow("A-FURN-IDEN"),
    "Floors": LayerRow("A-AREA", 8),
    "Names": LayerRow("A-AREA-IDEN"),
    "Stairs": LayerRow("A-FLOR-STRS"),
    "Sloped ceilings": LayerRow("A-CLNG-SLOP", 8),
    "Outlets": LayerRow("E-POWR", 5),
    "Dimensions": LayerRow("A-ANNO-DIMS", 8),
    "Levels": LayerRow("A-ANNO-TEXT"),
    "Legend": LayerRow("A-ANNO-LEGN"),
    "Sheet": LayerRow("A-ANNO-TTLB"),
    "Zones": LayerRow("A-AREA-ZONE"),
    "Borders of zones": LayerRow("A-AREA-ZONE-BNDY"),
    "Route": LayerRow("A-FLOR-EVAC", 5),
    "Passages": LayerRow("A-FLOR-PASS", 1),
    "Turning circles": LayerRow("A-FLOR-ACCS", 5),
    "Ground": LayerRow("C-PROP"),
    "Border": LayerRow("C-PROP-LINE"),
    "Setback": LayerRow("C-PROP-SETB", 8),
    "Roads and paths": LayerRow("C-ROAD"),
    "Names of ways": LayerRow("C-ROAD-IDEN"),
    "Contours": LayerRow("C-TOPO"),
    "Water": LayerRow("C-TOPO-WATR"),
    "Streets": LayerRow("C-ROAD"),
    "Street sides": LayerRow("C-ROAD-EDGE"),
    "Lanes": LayerRow("C-ROAD-LANE"),
    "Lanes and walks": LayerRow("C-ROAD-LANE"),
    "Names of lanes": LayerRow("C-ROAD-IDEN"),
    "Yards and walks": LayerRow("L-WALK"),
    "Squares, parking and courts": LayerRow("L-SITE"),
    "Walls, hedges and beds": LayerRow("L-SITE-WALL"),
    "Plots": LayerRow("C-PROP-PLOT"),
    "Trees": LayerRow("L-PLNT-TREE", 3),
    "Buildings": LayerRow("C-BLDG"),
    "Houses": LayerRow("C-BLDG"),
    "New buildings": LayerRow("C-BLDG-NEW"),
    "Old buildings": LayerRow("C-BLDG-EXST"),
    "Numbers": LayerRow("C-BLDG-IDEN"),
    "Kinds": LayerRow("C-BLDG-IDEN"),
    "Violations": LayerRow("A-ANNO-REVC", 1),
    "Elevations": LayerRow("A-ELEV"),
    "Schedule": LayerRow("A-ANNO-SCHD"),
}
"""The layer of each layer of a plan; of others the name is made of theirs."""
HATCHES = "-PATT"
"""What is added to a layer's name for what fills its shapes."""
PAPER = ("Sheet", "Legend")
"""Layers of a plan that lie on the sheet, not in the model."""


def layer_row(name: str) -> LayerRow:
    """The layer of DXF for a layer of a plan.

    >>> layer_row("Walls").name, layer_row("Picnic rugs & trees").name
    ('A-WALL', 'A-PICNIC-RUGS-TREES')
    """
    known = LAYERS.get(name)
    return known or LayerRow("A-" + re.sub(r"[^A-Z0-9]+", "-", name.upper()).strip("-"))
