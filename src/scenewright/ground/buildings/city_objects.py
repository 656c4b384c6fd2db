"""Objects of a CityJSON 2.0 document: prisms over footprints, flat areas, vertices listed once.

Vertices are whole millimetres; prisms are of level of detail 1.2, every surface marked as ground,
wall or roof. Real roofs are added by :mod:`scenewright.ground.buildings.city_roofs`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scenewright.building.outlines import ring, signed_area
from scenewright.core.scene import Piece
from scenewright.core.space import Points
from scenewright.ground.plan import Way

SCALE = 0.001
GROUND, ROOF, WALL = 0, 1, 2
SURFACES = [{"type": "GroundSurface"}, {"type": "RoofSurface"}, {"type": "WallSurface"}]

Vertices = dict[tuple[int, int, int], int]
"""The number of each vertex, in whole millimetres."""


def prism_object(
    footprint: Points, low: float, high: float, attributes: dict[str, Any], vertices: Vertices
) -> dict[str, Any]:
    """A building as a prism between two heights: its underside looks down, its walls out, its top
    up; ``attributes`` are its attributes.

    >>> made = prism_object(np.array([[0, 0], [4, 0], [4, 3.0]]), 0.0, 6.0, {}, {})
    >>> len(made["geometry"][0]["boundaries"][0])
    5
    """
    corners = _whole(footprint)
    bottom, upper = round(low / SCALE), round(high / SCALE)
    floor = [add_vertex((x, y, bottom), vertices) for x, y in corners.tolist()]
    top = [add_vertex((x, y, upper), vertices) for x, y in corners.tolist()]
    count = len(corners)
    walls = [
        [[floor[i], floor[j], top[j], top[i]]]
        for i, j in ((k, (k + 1) % count) for k in range(count))
    ]
    geometry = {
        "type": "Solid",
        "lod": "1.2",
        "boundaries": [[[floor[::-1]], [top], *walls]],
        "semantics": {"surfaces": SURFACES, "values": [[GROUND, ROOF, *[WALL] * count]]},
    }
    return {"type": "Building", "attributes": attributes, "geometry": [geometry]}


def flat_object(
    kind: str, areas: Sequence[tuple[Points, ...]], attributes: dict[str, Any], vertices: Vertices
) -> dict[str, Any]:
    """Areas at height 0, each an outline and holes, as an object of a kind (``Road`` …)."""
    boundaries = [
        [
            [
                add_vertex((x, y, 0), vertices)
                for x, y in np.round(line / SCALE).astype(int).tolist()
            ]
            for line in area
        ]
        for area in areas
    ]
    geometry = {"type": "MultiSurface", "lod": "1", "boundaries": boundaries}
    return {"type": kind, "attributes": attributes, "geometry": [geometry]}


def add_roads(ways: Sequence[Way], objects: dict[str, Any], vertices: Vertices) -> None:
    """Add a ``Road`` for each street and path to the objects of a city model."""
    for way in ways:
        areas = [(area.outline, *area.holes) for area in way.areas]
        if areas:
            attributes = {"name": way.name or way.id, "class": way.kind, "width": way.width}
            objects[free_key(way.id, objects)] = flat_object("Road", areas, attributes, vertices)


PLANTED = {"tree": ("SolitaryVegetationObject", "tree"), "lamp_post": ("CityFurniture", "lamp")}
"""Kinds of objects and classes of what is planted or lit, by category."""


def add_planted(
    pieces: Sequence[Piece], old: str, objects: dict[str, Any], vertices: Vertices
) -> None:
    """Add trees and street lamps as points, ``new`` where they are not of the ``old`` space."""
    for piece in (p for p in pieces if p.category in PLANTED):
        kind, word = PLANTED[piece.category]
        x, y = (round(value / SCALE) for value in piece.pose[:2])
        points = [add_vertex((x, y, 0), vertices)]
        objects[free_key(piece.id, objects)] = {
            "type": kind,
            "attributes": {"class": word, "height": piece.size.height, "new": piece.space != old},
            "geometry": [{"type": "MultiPoint", "lod": "1", "boundaries": points}],
        }


def free_key(wish: str, taken: dict[str, Any]) -> str:
    """A key no object has yet.

    >>> free_key("road", {"road": {}})
    'road-2'
    """
    names = (wish if k == 1 else f"{wish}-{k}" for k in range(1, len(taken) + 2))
    return next(name for name in names if name not in taken)


def city_document(
    title: str,
    objects: dict[str, Any],
    vertices: Vertices,
    moved: tuple[float, float] = (0.0, 0.0),
    system: str = "",
    metres: tuple[float, float, float] = (1.0, 1.0, 1.0),
) -> dict[str, Any]:
    """The CityJSON document of objects: ``moved`` is added to x and y for coordinates of a
    reference ``system``, whose units along x, y and upwards are ``metres``."""
    whole = np.array(list(vertices), np.int64).reshape(-1, 3)
    shift, scale = (*moved, 0.0), [SCALE / metre for metre in metres]
    about: dict[str, Any] = {"title": title, "geographicalExtent": _extent(whole, shift, scale)}
    return {
        "type": "CityJSON",
        "version": "2.0",
        "transform": {"scale": scale, "translate": [*shift]},
        "metadata": about | ({"referenceSystem": system} if system else {}),
        "CityObjects": objects,
        "vertices": whole.tolist(),
    }


def _whole(footprint: Points) -> NDArray[np.int64]:
    """A footprint in whole millimetres, counter-clockwise, no corner twice."""
    rounded = np.round(ring(footprint) / SCALE).astype(np.int64)
    corners = rounded[(rounded != np.roll(rounded, 1, axis=0)).any(1)]
    return corners if signed_area(corners.astype(float)) > 0 else corners[::-1]


def add_vertex(at: tuple[int, int, int], vertices: Vertices) -> int:
    """The number of a vertex in whole millimetres, listed if it is new."""
    return vertices.setdefault(at, len(vertices))


def _extent(
    whole: NDArray[np.int64], moved: tuple[float, float, float], scale: list[float]
) -> list[float]:
    if not len(whole):
        return [*moved, *moved]
    step = np.array(scale)
    corners = np.concatenate([whole.min(0) * step + moved, whole.max(0) * step + moved])
    return [round(float(value), 3) for value in corners]
