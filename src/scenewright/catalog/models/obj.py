"""Wavefront OBJ: polygons with materials and textures; y up, front to +z unless stated.

Wavefront Technologies, *Object files* (1995). Points, lines and curves are passed over.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models import colours, mtl
from scenewright.catalog.models.facets import quads_cut, triangles
from scenewright.catalog.models.files import Beside
from scenewright.catalog.models.model import (
    FARTHEST,
    MOST_FACES,
    MOST_VERTICES,
    PLAIN,
    ImportOptions,
    RawModel,
    check_count,
    merge_parts,
    part_of,
)
from scenewright.core.catalog import Part
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MOST_CORNERS = 5000
"""Corners of one polygon."""
MOST_LIBRARIES = 50
BARE = mtl.MtlMaterial(PLAIN)


class Soup(NamedTuple):
    """All triangles: places ``(n, 3)``, texture places ``(t, 2)``, and for each triangle its
    corners ``(m, 3)`` among both (-1: no texture) and its material's number ``(m,)``."""

    places: Floats
    spots: Floats
    faces: Ints
    skins: Ints
    coats: Ints


@dataclass
class _Lines:
    """What has been read so far."""

    places: list[list[float]] = field(default_factory=list)
    spots: list[list[float]] = field(default_factory=list)
    polygons: dict[int, list[list[int]]] = field(default_factory=dict)
    names: dict[str, int] = field(default_factory=lambda: {"": 0})
    libraries: list[str] = field(default_factory=list)
    faces: int = 0


def read(content: bytes, stem: str, beside: Beside, _: ImportOptions) -> Iterator[RawModel]:
    """The one model of an OBJ file."""
    lines = _lines_of(content)
    if not lines.faces:
        raise InputError("holds no faces", "export the model with its surfaces")
    coats: dict[str, mtl.MtlMaterial] = {}
    for name in lines.libraries:
        found = beside(name, mtl.MOST_BYTES)
        try:
            coats |= mtl.coats(found) if found else {}
        except InputError as error:
            place = ": ".join(filter(None, (name[:60], error.place)))
            raise InputError(error.fault, error.remedy, place=place) from None
    parts = _parts(soup(lines), [coats.get(name, BARE) for name in lines.names], beside)
    yield RawModel(stem, stem, parts, "+y", "+z")


def _lines_of(content: bytes) -> _Lines:
    lines, coat = _Lines(), 0
    text = content.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ")
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        word = words[0] if words else b""
        try:
            if word == b"v":
                lines.places.append([float(words[1]), float(words[2]), float(words[3])])
                check_count(len(lines.places), MOST_VERTICES, "vertices")
            elif word == b"vt":
                lines.spots.append([float(words[1]), float(words[2]) if len(words) > 2 else 0.0])
                check_count(len(lines.spots), MOST_VERTICES, "texture places")
            elif word == b"f":
                _add_face(lines, words[1:], coat)
            elif word == b"usemtl":
                coat = lines.names.setdefault(_rest(line), len(lines.names))
                check_count(coat, mtl.MOST_MATERIALS, "materials")
            elif word == b"mtllib":
                lines.libraries.append(_rest(line))
                check_count(len(lines.libraries), MOST_LIBRARIES, "material libraries")
        except (ValueError, IndexError) as error:
            fault = error if isinstance(error, InputError) else None
            raise InputError(
                fault.fault if fault else f"'{_quote_line(line)}' cannot be read",
                fault.remedy if fault else "export the model again",
                place=f"line {number}",
            ) from None
    return lines


def _add_face(lines: _Lines, words: list[bytes], coat: int) -> None:
    """A polygon as places and texture places in turn; negative numbers count from the last."""
    if len(words) > MOST_CORNERS:
        raise InputError(f"a face has more than {MOST_CORNERS} corners", "simplify the model")
    if len(words) < 3:
        return  # a line or point drawn as a face
    places, spots = len(lines.places), len(lines.spots)
    corners: list[int] = []
    for word in words:
        first, _, rest = word.partition(b"/")
        second = rest.partition(b"/")[0]
        corners.append(_number(int(first), places))
        corners.append(_number(int(second), spots) if second else -1)
    lines.polygons.setdefault(coat, []).append(corners)
    lines.faces += len(words) - 2
    check_count(lines.faces, MOST_FACES, "triangles")


def _number(given: int, count: int) -> int:
    """From 1 onwards or -1 backwards to 0 onwards."""
    found = given - 1 if given > 0 else count + given
    if given == 0 or found < 0 or given > MOST_VERTICES:
        raise InputError(f"there is no corner {given}", "export the model again")
    return found


def soup(lines: _Lines) -> Soup:
    """The polygons as triangles, of places that are all there."""
    places = np.array(lines.places, np.float64).reshape(-1, 3)
    spots = np.array([*lines.spots, [0.0, 0.0]], np.float64)
    if not np.all(np.abs(places) <= FARTHEST):
        raise InputError("a corner is not at a finite place", "export the model again")
    pieces = [(coat, *_cut(places, len(spots) - 1, own)) for coat, own in lines.polygons.items()]
    faces = np.concatenate([piece[1] for piece in pieces])
    skins = np.concatenate([piece[2] for piece in pieces])
    numbers = np.repeat([piece[0] for piece in pieces], [len(piece[1]) for piece in pieces])
    return Soup(places, spots, faces, skins, numbers)


def _cut(places: Floats, spots: int, polygons: list[list[int]]) -> tuple[Ints, Ints]:
    """Triangles of polygons of one material: their places and their texture places."""
    by_size: dict[int, list[list[int]]] = {}
    for polygon in polygons:
        by_size.setdefault(len(polygon) // 2, []).append(polygon)
    faces, skins = [np.zeros((0, 3), np.int64)], [np.zeros((0, 3), np.int64)]
    for count, own in by_size.items():
        table = np.array(own, np.int64).reshape(-1, count, 2)
        if table[..., 0].max() >= len(places) or table[..., 1].max() >= spots:
            raise InputError("a face has a corner that is not there", "export the model again")
        base = np.arange(len(table))[:, None] * count + np.arange(count)
        corners = places[table[..., 0]].reshape(-1, 3)
        local = _triangles(corners, base)
        faces.append(table[..., 0].reshape(-1)[local])
        skins.append(table[..., 1].reshape(-1)[local])
    return np.concatenate(faces), np.concatenate(skins)


def _triangles(corners: Floats, polygons: Ints) -> Ints:
    """Triangles of polygons ``(p, n)`` of as many corners each."""
    if polygons.shape[1] == 3:
        return polygons
    if polygons.shape[1] == 4:
        return quads_cut(corners, polygons)
    return np.concatenate([polygon[triangles([corners[polygon]])] for polygon in polygons])


def _parts(found: Soup, coats: list[mtl.MtlMaterial], beside: Beside) -> tuple[Part, ...]:
    parts: list[Part] = []
    pictures: dict[str, colours.Pixels | None] = {}
    for number, coat in enumerate(coats):
        own = found.coats == number
        if not own.any():
            continue
        if coat.texture and coat.texture not in pictures:
            content = beside(coat.texture, colours.MOST_BYTES)
            pictures[coat.texture] = colours.picture(content) if content else None
        pixels = pictures.get(coat.texture)
        faces, skins = found.faces[own], found.skins[own]
        if pixels is None or skins.min() < 0:
            parts.append(part_of(coat.material, found.places, faces))
            continue
        spots = found.spots[skins] * [1.0, -1.0] + [0.0, 1.0]
        shades = colours.looked_up(pixels, spots) * np.array(coat.material.color)
        parts += colours.by_colour(coat.material, found.places, faces, shades)
    return merge_parts(parts)


def _rest(line: bytes) -> str:
    """What follows the first word."""
    return b" ".join(line.split(None, 1)[1:]).decode("utf-8", "replace").strip()


def _quote_line(line: bytes) -> str:
    text = line[:40].decode("ascii", "replace")
    return "".join(c if c.isprintable() else "?" for c in text)
