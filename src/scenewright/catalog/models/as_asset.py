"""A model as an asset: drawn at any size, with its outline as plan symbol."""

from __future__ import annotations

from functools import cache

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.catalog.assets import shipped
from scenewright.catalog.models.categories import BUILDING
from scenewright.catalog.models.decimation import decimate
from scenewright.catalog.models.model import Model
from scenewright.core.catalog import Asset, Part
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Size

Floats = NDArray[np.float64]

MOST_DRAWN = 20_000
"""Faces up to which the plan symbol is the exact outline; beyond, its convex hull."""
HEAVY, LIGHT, LEAST = 25_000, 15_000, 12
"""Triangles above which furniture is drawn with fewer, how many these are, and least of a part."""
SQUARE = 0.85
"""Furniture that covers more of its box than this is drawn in plan by the symbol of its kind."""
ALIKE = 0.9
"""The share of a footprint and a building's plan together that both cover, where that building is
the one on the footprint."""
GRID = 1e-4
"""To what share of the model's size an outline is drawn."""


def asset_of(model: Model, category: str = "building", style: str = "", colour: str = "") -> Asset:
    """The asset ``model:<id>``; ``mesh(size)`` stretches the model to exactly that size.

    Its smallest, usual and largest size are the model's own, so that a catalog prefers the model
    that needs no stretching. Furniture of more than :data:`HEAVY` triangles is drawn with fewer.
    A building also stands on a footprint that is its own plan, rounded.
    """

    @cache
    def drawn() -> tuple[Part, ...]:
        return model.parts if category == BUILDING else lighter(model.parts)

    def mesh(size: Size) -> tuple[Part, ...]:
        scale = np.array(size) / np.array(model.size)
        return tuple(Part(part.material, part.vertices * scale, part.faces) for part in drawn())

    @cache
    def lines() -> tuple[Floats, ...]:
        return outline(model)

    def symbol(size: Size) -> tuple[Floats, ...]:
        usual = None if category == BUILDING else shipped().choose(category, size)
        if usual is not None and _area(lines()) > SQUARE * model.size.width * model.size.depth:
            return usual.symbol(size)
        scale = np.array([size.width / model.size.width, size.depth / model.size.depth])
        return tuple(line * scale for line in lines())

    def over(size: Size, footprint: Footprint) -> tuple[Part, ...]:
        plan = shapely.Polygon(symbol(size)[0])
        return mesh(size) if _are_alike(shapely.Polygon(footprint), plan) else ()

    return Asset(
        f"model:{model.id}",
        category,
        model.name,
        model.size,
        model.size,
        model.size,
        mesh,
        symbol,
        model.licence,
        model.author,
        style,
        colour,
        over=over if category == BUILDING else None,
    )


def _are_alike(one: shapely.Polygon, other: shapely.Polygon) -> bool:
    if not (one.is_valid and other.is_valid):
        return False
    return bool(one.intersection(other).area > ALIKE * one.union(other).area)


def _area(lines: tuple[Floats, ...]) -> float:
    return float(sum(shapely.area(shapely.polygons(line)) for line in lines))


def lighter(parts: tuple[Part, ...]) -> tuple[Part, ...]:
    """Parts with about :data:`LIGHT` triangles together, if they have more than :data:`HEAVY`."""
    count = sum(len(part.faces) for part in parts)
    if count <= HEAVY:
        return parts
    thin = (decimate(p, max(LEAST, len(p.faces) * LIGHT // count)) for p in parts)
    return tuple(part for part in thin if len(part.faces))


def outline(model: Model) -> tuple[Floats, ...]:
    """Closed lines ``(k, 2)`` round what the model covers in plan, the largest first."""
    corners = np.concatenate([part.vertices[part.faces][..., :2] for part in model.parts])
    grid = GRID * max(model.size.width, model.size.depth)
    if len(corners) <= MOST_DRAWN:
        a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        wide = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) > grid * grid
        shape = shapely.union_all(shapely.polygons(corners[wide]), grid_size=grid)
    else:
        shape = shapely.convex_hull(shapely.multipoints(corners.reshape(-1, 2)))
    shapes = [s for s in shapely.get_parts(shape) if s.geom_type == "Polygon" and not s.is_empty]
    shapes.sort(key=lambda s: -s.area)
    found = tuple(np.asarray(s.exterior.simplify(2 * grid).coords) for s in shapes)
    return found or (_rectangle(model.size),)


def _rectangle(size: Size) -> Floats:
    w, d = size.width / 2, size.depth / 2
    return np.array([[-w, -d], [w, -d], [w, d], [-w, d], [-w, -d]])
