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
from scenewright.render.items import RenderItem
from scenewright.render.lamps import Lamp, color_of_kelvin

LARGE, LUX, COOL = 60.0, 300.0, 3500.0
"""Rooms larger than this, m², have rows of lights that give this illuminance (EN 12464-1, sales
areas and exhibitions: 300 lx) of this colour temperature."""
DIM = 50.0
"""Lumens a square metre: half of what corridors are lit with (EN 12464-1: 100 lx)."""
ROWS, MOST_LIGHTS = 3.0, 48
"""Distance of lights in metres, and the most of them in a room."""
BELOW = 0.12
"""How far below the ceiling a light is, in metres."""
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
            places = np.column_stack([flat, np.full(len(flat), space.height - BELOW)])
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
    """The rooms whose own lamps give less than :data:`DIM` lumens a square metre."""
    given = defaultdict[str, float](float)
    for lamp in lamps:
        given[lamp.item.space] += lamp.lumens
    return [
        space
        for space in spaces
        if given[space.id] < DIM * shapely.Polygon(space.outline, space.holes).area
    ]


def row_item(row: LightRow) -> RenderItem:
    """The panels of a row, as a thing to draw."""
    wide, deep, tall = PANEL
    panel = box((-wide / 2, -deep / 2, 0.01), (wide / 2, deep / 2, 0.01 + tall))
    meshes = [translate_mesh(panel, *place) for place in row.places]
    facts: dict[str, str | float] = {"category": "light row", "space": row.space.id}
    parts = (Part(LUMINOUS, *merge(meshes)),)
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
