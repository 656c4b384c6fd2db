"""Doors and windows that a Sweet Home 3D home lists among its furniture."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import shapely

from scenewright.formats.sh3d.kinds import kind_of
from scenewright.formats.sh3d.xml import HomePiece, HomeWall, middle_line
from scenewright.text import fold_letters

NAMES = re.compile(
    r"door|gate\b|porte\b|portail|tur\b|tuer\b|puerta|porta\b|portao|deur|drzwi|dver|двер|kapi\b|"
    r"门|門|ドア|扉|문$|window|fenetre|fenster|ventana|finestra|janela|raam\b|okno|окно|窗|窓|창|"
    r"pencere|passage|opening|ouverture|baie vitree"
)
"""Words for doors and windows, in plain letters."""
THICKEST = 0.6
"""Depth of what still is a door or window in a wall, metres."""
OFF = 0.05
"""How far its middle may be off the wall's, beside half the wall's thickness, metres."""
PARALLEL = 0.97


def opening_among(piece: HomePiece, walls: Sequence[HomeWall]) -> HomePiece:
    """The piece as a door or window if it is called one and lies in a wall, else as it is."""
    if piece.kind == "doorOrWindow" or piece.kind == "furnitureGroup" or piece.depth > THICKEST:
        return piece
    named = NAMES.search(fold_letters(f"{piece.name} {piece.catalog.rpartition('#')[2]}"))
    if not named or kind_of(piece) != "obstacle" or not any(_in(piece, wall) for wall in walls):
        return piece
    return piece._replace(kind="doorOrWindow")


def _in(piece: HomePiece, wall: HomeWall) -> bool:
    """Whether a piece lies in a wall and along it."""
    at, line = shapely.Point(piece.x, piece.y), middle_line(wall)
    parts = [shapely.LineString(pair) for pair in pairwise(line)]
    away = shapely.distance(parts, at)
    if away.min() > wall.thickness / 2 + OFF:
        return False
    way = np.diff(line, axis=0)[int(np.argmin(away))]
    along = way @ np.array([math.cos(piece.turn), math.sin(piece.turn)])
    return bool(abs(along) > PARALLEL * float(np.hypot(*way)))
