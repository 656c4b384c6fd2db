"""Trees and street lamps of city models (CityJSON)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.catalog.models.cityjson import City, parts_at
from scenewright.catalog.models.gltf_scene import plan_of_parts
from scenewright.core.errors import InputError
from scenewright.ground.buildings.built import Floats, Spot
from scenewright.ground.planting.places import AVENUE

TREE, COVER, FURNITURE = "SolitaryVegetationObject", "PlantCover", "CityFurniture"
SOLID = "Solid"
"""How the types of geometry end that enclose something."""
LIGHTS = ("lamp", "lantern", "light")
"""Words in the class, function or usage of street furniture that is lit."""
STANDS = 2.0
"""Metres of height from which plants are trees, not beds or hedges."""
LOW = "{} x {}: not as high as {:g} m, lawns or beds: no trees"
OTHER = "{} x {}: has no place that can be read, or is no lamp"


class PlantedCity(NamedTuple):
    """Trees and lamps in metres, and what of plants and street furniture was left out."""

    trees: tuple[Spot, ...]
    lamps: tuple[Spot, ...]
    left_out: tuple[str, ...]


def planted_city(city: City) -> PlantedCity:
    """The trees and street lamps of a city model; plants that cover ground and stand high are a
    tree every :data:`~scenewright.ground.planting.places.AVENUE` metres."""
    kinds = {kind: _list_objects(city, kind) for kind in (TREE, COVER, FURNITURE)}
    trees = [_middle(corners) for _, _, corners in kinds[TREE] if len(corners)]
    lost, unlit = sum(not len(corners) for *_, corners in kinds[TREE]), 0
    low, lamps = 0, list[Spot]()
    for key, attributes, corners in kinds[COVER]:
        woods = _is_high(attributes, corners)
        trees += _fill(city, key) if woods else []
        low += not woods
    for _, attributes, corners in kinds[FURNITURE]:
        lit = len(corners) and _is_lamp(attributes)
        lamps += [_middle(corners)] if lit else []
        unlit += not lit
    told = [LOW.format(low, COVER, STANDS)] * bool(low)
    told += [OTHER.format(n, kind) for n, kind in ((lost, TREE), (unlit, FURNITURE)) if n]
    return PlantedCity(tuple(trees), tuple(lamps), tuple(told))


def _list_objects(city: City, kind: str) -> list[tuple[str, dict[str, Any], Floats]]:
    """The objects of a kind: key, attributes, corners (n, 3)."""
    found = []
    for key, one in city.objects.items():
        if one.get("type") == kind:
            attributes = one.get("attributes")
            given = one.get("geometry")
            listed = given if isinstance(given, list) else []
            rows = [row for row in listed if isinstance(row, dict)]
            parts = [row.get("boundaries") for row in rows]
            numbers = [n for n in list_numbers(parts) if 0 <= n < len(city.corners)]
            stated = dict(attributes) if isinstance(attributes, dict) else {}
            stated[SOLID] = any(str(row.get("type")).endswith(SOLID) for row in rows)
            found.append((key, stated, city.corners[np.array(numbers, np.int64)]))
    return found


def list_numbers(boundaries: object) -> Iterator[int]:
    """The numbers of vertices in boundaries, however deep they lie.

    >>> list(list_numbers([[0, 1], [[2]]]))
    [0, 1, 2]
    """
    waiting = [boundaries]
    while waiting:
        one = waiting.pop()
        if isinstance(one, list):
            waiting += one[::-1]
        elif isinstance(one, int) and not isinstance(one, bool):
            yield one


def _middle(corners: Floats) -> Spot:
    low, high = corners[:, :2].min(0), corners[:, :2].max(0)
    x, y = (0.5 * (low + high)).round(3).tolist()
    return x, y


def _is_high(attributes: dict[str, Any], corners: Floats) -> bool:
    stated = attributes.get("averageHeight", attributes.get("height"))
    if isinstance(stated, int | float) and not isinstance(stated, bool):
        return stated >= STANDS
    return attributes[SOLID] and bool(len(corners)) and float(np.ptp(corners[:, 2])) >= STANDS


def _is_lamp(attributes: dict[str, Any]) -> bool:
    told = " ".join(str(attributes.get(key, "")) for key in ("class", "function", "usage"))
    return any(word in told.casefold() for word in LIGHTS)


def _fill(city: City, key: str) -> list[Spot]:
    """A tree in the middle of each square of a grid that lies on an object."""
    try:
        floor = plan_of_parts(parts_at(city, key))
    except InputError:
        return []
    west, south, east, north = floor.bounds
    axes = (np.arange(a + AVENUE / 2, b, AVENUE) for a, b in ((west, east), (south, north)))
    grid = np.stack(np.meshgrid(*axes), -1).reshape(-1, 2)
    here = grid[shapely.contains_xy(floor, grid[:, 0], grid[:, 1])]
    return [(round(float(x), 3), round(float(y), 3)) for x, y in here]
