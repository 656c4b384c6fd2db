"""Rows of lights under the ceilings of rooms that are large or have no other light."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.door_uses import OPEN_AIR
from scenewright.core.catalog import Material, Part
from scenewright.core.space import Space
from scenewright.geometry.mesh import merge, translate_mesh
from scenewright.geometry.prisms import box
from scenewright.render.items import RenderItem, to_level_coordinates
from scenewright.render.lamps import Lamp, color_of_kelvin
from scenewright.render.public_rooms import LARGE, RAIL, is_public

LUX, COOL = 300.0, 4000.0
"""Rows of lights give this illuminance (EN 12464-1, sales areas and exhibitions: 300 lx) of this
colour temperature."""
DIM = 50.0
"""Lux: half of what corridors are lit with (EN 12464-1: 100 lx)."""
ROWS, MOST_LIGHTS = 3.0, 48
"""Distance of lights in metres, and the most of them in a room."""
BELOW, HUNG, TALL = 0.12, 0.4, 3.2
"""How far below the ceiling a light is, in metres; how far where that is at least so high."""
PANEL = (1.2, 0.2, 0.05)
LUMINOUS = Material("light panel", (1.0, 0.98, 0.94), 0.6, 0.0, 1.0, 0.9)

Floats = NDArray[np.float64]


class LightRow(NamedTuple):
    """The lights of a room: the name of its row, ``places`` (n, 3) in its level, the intensity of
    each in candela and its linear colour, of luminance 1."""

    name: str
    space: Space
    places: Floats
    candela: float
    color: tuple[float, float, float]


def light_rows(
    spaces: Sequence[Space], lit: frozenset[str], most: int = MOST_LIGHTS
) -> Iterator[LightRow]:
    """The rows of rooms by their ids ``lit`` by other lights: large ones, and those in the dark;
    ``most`` lights a room."""
    for space in spaces:
        shape = shapely.Polygon(space.outline, space.holes)
        if OPEN_AIR.isdisjoint(space.functions) and (shape.area > LARGE or space.id not in lit):
            apart = max(ROWS, float(np.sqrt(shape.area / most)))
            flat = _places_in(shape, apart)
            below = HUNG if space.height >= TALL else BELOW
            places = np.column_stack([flat, np.full(len(flat), space.height - below)])
            candela = LUX * shape.area / len(flat) / np.pi
            color = color_of_kelvin(COOL)
            yield LightRow(f"{space.id} light row", space, places, candela, color)


def dark_rows(
    spaces: Sequence[Space], lamps: Iterable[Lamp], most: int = MOST_LIGHTS
) -> Iterator[LightRow]:
    """The rows of large rooms in :func:`find_dark`; ``most`` lights a room."""
    dark = find_dark(spaces, lamps)
    yield from light_rows(dark, frozenset(space.id for space in dark), most)


def find_dark(spaces: Sequence[Space], lamps: Iterable[Lamp]) -> list[Space]:
    """The rooms whose own lamps give less than :data:`DIM` lumens a square metre, and those of the
    public that are large and have dark places: half of them get less than :data:`DIM` lux."""
    own = defaultdict[str, list[Lamp]](list)
    for lamp in lamps:
        own[lamp.item.space].append(lamp)
    return [space for space in spaces if _is_dark(space, own[space.id])]


def _is_dark(space: Space, lamps: Sequence[Lamp]) -> bool:
    shape = shapely.Polygon(space.outline, space.holes)
    if sum(lamp.lumens for lamp in lamps) < DIM * shape.area:
        return True
    return is_public(space) and float(np.median(_lux_at(_places_in(shape, ROWS / 2), lamps))) < DIM


def _lux_at(places: Floats, lamps: Sequence[Lamp]) -> Floats:
    """What lamps give to the floor at places (n, 2) if nothing is in between: of a ball of light
    flux / (4 pi) by the height over the cube of the distance."""
    found = np.zeros(len(places))
    for lamp in lamps:
        at = to_level_coordinates(lamp.item, np.array([lamp.at]))[0]
        square = ((places - at[:2]) ** 2).sum(1) + at[2] ** 2
        found += lamp.lumens / (4 * np.pi) * at[2] / np.maximum(square, 0.01) ** 1.5
    return found


def row_item(row: LightRow) -> RenderItem:
    """The panels of a row, as a thing to draw."""
    wide, deep, tall = PANEL
    panel = box((-wide / 2, -deep / 2, 0.01), (wide / 2, deep / 2, 0.01 + tall))
    top = row.space.height - row.places[0, 2]
    rods = [box((x - 0.004, -0.004, 0.06), (x + 0.004, 0.004, top)) for x in (-wide / 3, wide / 3)]
    meshes = [translate_mesh(panel, *place) for place in row.places]
    hung = merge([translate_mesh(rod, *place) for place in row.places for rod in rods])
    facts: dict[str, str | float] = {"category": "light row", "space": row.space.id}
    parts = (Part(LUMINOUS, *merge(meshes)), Part(RAIL, *hung))
    level, name = row.space.level, row.name
    return RenderItem(name, "light row", level, row.space.id, name, parts, (0, 0, 0), 0.0, facts)


def _places_in(shape: shapely.Polygon, apart: float) -> Floats:
    """Points of a grid inside a shape, at least one."""
    x0, y0, x1, y1 = shape.bounds
    columns, rows = (max(round(side / apart), 1) for side in (x1 - x0, y1 - y0))
    x = x0 + (np.arange(columns) + 0.5) * (x1 - x0) / columns
    y = y0 + (np.arange(rows) + 0.5) * (y1 - y0) / rows
    grid = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    inside = grid[shapely.contains_xy(shape, grid[:, 0], grid[:, 1])]
    inner = shape.representative_point()
    return inside if len(inside) else np.array([[inner.x, inner.y]])
