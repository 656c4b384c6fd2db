"""Homes whose file is not in centimetres, as Sweet Home 3D has them: what other programs wrote."""

from __future__ import annotations

from math import isclose, log
from statistics import median
from typing import Any

from scenewright.core.errors import InputError
from scenewright.formats.sh3d.xml import Home, HomePiece

UNITS = {"inches": 2.54, "millimetres": 0.1}
"""Centimetres of each."""
LOWEST, HIGHEST, USUAL = 1.3, 10.0, 2.5
"""Heights between which walls of rooms are, and the usual one, metres."""
ALIKE = 0.02


def to_centimetres(home: Home, scale: float) -> tuple[Home, float]:
    """A home and the scale to read its plan with. Where not even its highest wall is as high as
    rooms are, or most are far higher, and the ``scale`` is that of the unit they are in, the home
    with all its lengths times it and 1; without a scale an InputError that names it."""
    rows = [max(w.height or 0.0, w.height_at_end or 0.0) for w in home.walls]
    heights = [height for height in rows if height] or [home.wall_height]
    height = max(heights) if max(heights) < LOWEST else median(heights)
    if height <= HIGHEST and max(heights) >= LOWEST:
        return home, scale
    word, factor = min(UNITS.items(), key=lambda unit: abs(log(height * unit[1] / USUAL)))
    fits = LOWEST <= height * factor <= HIGHEST
    if fits and scale == 1.0:
        raise InputError(
            f"its walls are {height:.2f} m high",
            f"add --scale {factor:g} if it is drawn in {word}, not in centimetres",
        )
    meant = fits and isclose(scale, factor, rel_tol=ALIKE)
    return (_times(home, factor), 1.0) if meant else (home, scale)


def _times(home: Home, factor: float) -> Home:
    """A home with all lengths times a factor."""

    def longer(record: Any, *fields: str) -> Any:
        values = {name: _multiply(getattr(record, name), factor) for name in fields}
        return record._replace(**values)

    walls = (longer(w, "start", "end", "thickness", "height", "height_at_end") for w in home.walls)
    return home._replace(
        wall_height=home.wall_height * factor,
        levels=tuple(longer(level, "elevation", "height") for level in home.levels),
        walls=tuple(walls),
        rooms=tuple(longer(room, "corners") for room in home.rooms),
        pieces=tuple(_larger(piece, factor) for piece in home.pieces),
    )


def _larger(piece: HomePiece, factor: float) -> HomePiece:
    lengths = ("x", "y", "z", "width", "depth", "height", "upright")
    return piece._replace(
        **{name: _multiply(getattr(piece, name), factor) for name in lengths},
        sashes=tuple(
            s._replace(x=s.x * factor, y=s.y * factor, width=s.width * factor) for s in piece.sashes
        ),
        members=tuple(_larger(member, factor) for member in piece.members),
    )


def _multiply(value: Any, factor: float) -> Any:
    """A length, or what is made of lengths, times a factor; None stays."""
    if value is None:
        return None
    if isinstance(value, tuple):
        return tuple(_multiply(one, factor) for one in value)
    return value * factor
