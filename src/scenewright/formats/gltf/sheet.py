"""The sheet: one picture with a band of every wood (and of the backs of books) and a cell of
every plain colour of a scene.

What wears nothing else is one material with it, so that a piece of many colours is drawn at once.
Across, a band repeats as its wood does; up and down each board keeps within it. Roughness, metal
and glow are pictures of a texel a cell, laid out alike.
"""

from __future__ import annotations

import io
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from scenewright.core.catalog import Material, Part
from scenewright.render.colour import coded_of, linear_of
from scenewright.render.textures.pictures import as_pixels, code_pixels, to_jpeg
from scenewright.render.textures.projection import boards_of, coordinates_of
from scenewright.render.textures.table import SHEET, bake, texture_of

Floats = NDArray[np.float64]
WIDE = SHEET[1]
CELL = 16
"""Side of a cell in pixels: a block of JPEG with hues at half the size."""
EDGE = 16
"""Pixels by which a band goes on above and below, so that smaller sizes of the picture do not mix
it with its neighbours."""
BAND = SHEET[0] + 2 * EDGE
OWN, SHARE = 0.5, 0.25
"""From this area on, in m², and from this share of a thing, a texture other than wood is kept."""


class Sheet(NamedTuple):
    """The materials with a band and those with a cell, in order; the height in pixels."""

    bands: dict[Material, int]
    cells: dict[Material, int]

    @property
    def height(self) -> int:
        """Pixels, a power of two."""
        rows = -(-len(self.cells) // (WIDE // CELL))
        least = len(self.bands) * BAND + rows * CELL
        return 1 << max(int(np.ceil(np.log2(max(least, CELL)))), 4)


class SheetPictures(NamedTuple):
    """Files: JPEG of colour, PNG of roughness and metal, PNG of glow (empty where nothing
    glows)."""

    color: bytes
    surface: bytes
    glow: bytes


def keep_textures(parts: Sequence[Part]) -> list[bool]:
    """Which parts of one thing are drawn in a material of their own: those one sees through, and
    those with a texture other than wood that is a large share of the thing.

    >>> from scenewright.geometry.prisms import box
    >>> cube = box((0, 0, 0), (1, 1, 1))
    >>> keep_textures([Part(Material(n, (1, 1, 1)), *cube) for n in ("oak", "linen", "chrome")])
    [False, True, False]
    """
    areas = [_area(part) for part in parts]
    shares: dict[Material, float] = {}
    for part, area in zip(parts, areas, strict=True):
        shares[part.material] = shares.get(part.material, 0.0) + area
    least = max(OWN, SHARE * sum(areas))
    return [part.material.opacity < 1 or _is_large(part, shares, least) for part in parts]


def _is_large(part: Part, shares: Mapping[Material, float], least: float) -> bool:
    row = texture_of(part.material.name)
    if row is None or row.banded:
        return False
    return row.always or shares[part.material] >= least


def lay_out(parts: Iterable[Part]) -> Sheet:
    """The sheet of parts that keep no texture of their own."""
    bands: dict[Material, int] = {}
    cells: dict[Material, int] = {}
    for part in parts:
        row = texture_of(part.material.name)
        held = bands if row is not None and row.banded else cells
        held.setdefault(part.material, len(held))
    return Sheet(bands, cells)


def places_on(sheet: Sheet, part: Part) -> Floats:
    """Places ``(m, 3, 2)`` of the corners of a part's faces on a sheet, in shares of it."""
    if part.material in sheet.cells:
        middle = np.array(_cell(sheet, part.material)) + CELL / 2
        return np.broadcast_to(middle / (WIDE, sheet.height), (len(part.faces), 3, 2))
    row = texture_of(part.material.name)
    assert row is not None
    tall, wide = row.metres
    across, up = np.moveaxis(coordinates_of(part, row.laying), -1, 0)
    board = boards_of(part.faces, len(part.vertices))[part.faces[:, 0]]
    low, high = (np.full(int(board.max()) + 1, sign * np.inf) for sign in (1, -1))
    np.minimum.at(low, board, up.min(1))
    np.maximum.at(high, board, up.max(1))
    span = (high - low)[board][:, None]
    within = (up - low[board][:, None]) * np.minimum(1.0, tall / np.maximum(span, 1e-9))
    slack = np.maximum(tall - span, 0.0) * (row.laying == "grain")
    shift = slack * np.modf(0.754877666 * (board + 1))[0][:, None]
    top = sheet.bands[part.material] * BAND + EDGE
    down = top + SHEET[0] * (1.0 - (within + shift) / tall)
    return np.stack([across / wide, down / sheet.height], -1)


def draw_sheet(sheet: Sheet) -> SheetPictures:
    """The pictures of a sheet."""
    color = np.full((sheet.height, WIDE, 3), 128, np.uint8)
    small = np.zeros((sheet.height // CELL, WIDE // CELL, 3))
    glow = np.zeros_like(small)
    for material, number in sheet.bands.items():
        row = texture_of(material.name)
        tone = np.pad(bake(row.name if row else "").tone, ((EDGE, EDGE), (0, 0), (0, 0)), "wrap")
        here = slice(number * BAND, (number + 1) * BAND)
        color[here] = code_pixels(tone * linear_of(np.array(material.color)).astype(np.float32))
        small[here.start // CELL : here.stop // CELL] = (0, material.roughness, material.metallic)
    for material in sheet.cells:
        x, y = _cell(sheet, material)
        linear = linear_of(np.array(material.color))
        color[y : y + CELL, x : x + CELL] = code_pixels(linear.astype(np.float32))
        small[y // CELL, x // CELL] = (0, material.roughness, material.metallic)
        glow[y // CELL, x // CELL] = linear * min(float(material.emission), 1.0)
    shining = _png(as_pixels(coded_of(glow))) if glow.any() else b""
    return SheetPictures(to_jpeg(color), _png(as_pixels(small)), shining)


def _cell(sheet: Sheet, material: Material) -> tuple[int, int]:
    """The left and upper pixel of a material's cell."""
    row, column = divmod(sheet.cells[material], WIDE // CELL)
    return column * CELL, len(sheet.bands) * BAND + row * CELL


def _area(part: Part) -> float:
    a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def _png(pixels: NDArray[np.uint8]) -> bytes:
    out = io.BytesIO()
    Image.fromarray(pixels).save(out, "PNG", optimize=True)
    return out.getvalue()
