"""Surfaces of CityJSON geometries: polygons with holes, what they are, and their triangles."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models.facets import newell, triangles
from scenewright.catalog.models.model import MOST_FACES, check_count, merge_parts, part_of
from scenewright.core.catalog import Material, Part
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
Json = Mapping[str, Any]

MOST_CORNERS = 20_000
"""Corners of one surface."""
STEEP = 0.35
"""Least vertical part of a unit normal of what is taken for a roof where nothing is said."""

WALL = Material("wall", (0.87, 0.83, 0.76))
ROOF = Material("roof", (0.66, 0.36, 0.28))
GROUND = Material("ground", (0.55, 0.54, 0.52))
WINDOW = Material("window", (0.45, 0.58, 0.66), 0.2)
DOOR = Material("door", (0.42, 0.28, 0.19))
MATERIALS = {
    "RoofSurface": ROOF,
    "WallSurface": WALL,
    "GroundSurface": GROUND,
    "Window": WINDOW,
    "Door": DOOR,
    "OuterFloorSurface": GROUND,
    "OuterCeilingSurface": WALL,
    "ClosureSurface": WALL,
}


class CitySurface(NamedTuple):
    """Rings of corner numbers, the outline first, and what the surface is ('': not said)."""

    rings: tuple[tuple[int, ...], ...]
    kind: str


def surfaces_of(geometry: Json, corners: int) -> list[CitySurface]:
    """The surfaces of a geometry; of a solid its outer shell."""
    semantics = geometry.get("semantics")
    semantics = semantics if isinstance(semantics, dict) else {}
    kinds = _kinds(semantics.get("surfaces"))
    raw = _pair_surfaces(geometry.get("boundaries"), semantics.get("values"), str(geometry["type"]))
    found = []
    for rings, value in raw:
        kind = kinds[value] if isinstance(value, int) and 0 <= value < len(kinds) else ""
        found.append(CitySurface(_check_rings(rings, corners), kind))
        check_count(len(found), MOST_FACES, "surfaces")
    return found


def _kinds(surfaces: object) -> list[str]:
    rows = surfaces if isinstance(surfaces, list) else []
    return [str(row.get("type", "")) if isinstance(row, dict) else "" for row in rows]


def _pair_surfaces(
    boundaries: object, values: object, kind: str
) -> Iterator[tuple[object, object]]:
    """Each surface with the number of what it is, level by level; inner shells are left out."""
    if not isinstance(boundaries, list):
        raise InputError("boundaries are no list", "save the file again")
    lines = values if isinstance(values, list) else []
    if kind in ("MultiSurface", "CompositeSurface"):
        for k, surface in enumerate(boundaries):
            yield surface, lines[k] if k < len(lines) else None
    elif kind == "Solid":
        if boundaries:
            yield from _pair_surfaces(boundaries[0], lines[0] if lines else None, "MultiSurface")
    else:
        for k, solid in enumerate(boundaries):
            yield from _pair_surfaces(solid, lines[k] if k < len(lines) else None, "Solid")


def _check_rings(rings: object, corners: int) -> tuple[tuple[int, ...], ...]:
    if not isinstance(rings, list) or not all(isinstance(ring, list) for ring in rings):
        raise InputError("a surface is not a list of rings", "save the file again")
    if sum(len(ring) for ring in rings) > MOST_CORNERS:
        raise InputError(f"a surface has more than {MOST_CORNERS:,} corners", "simplify it")
    for ring in rings:
        for number in ring:
            if type(number) is not int or not 0 <= number < corners:
                raise InputError(
                    "a surface has a corner that is not there", f"the file has {corners}"
                )
    return tuple(tuple(ring) for ring in rings)


def parts_of(corners: Floats, surfaces: Sequence[CitySurface]) -> tuple[Part, ...]:
    """The surfaces as triangles, one part a material; those without area are left out.

    ``corners`` (n, 3) in metres, which the surfaces' rings name by index.
    """
    parts = []
    for surface in surfaces:
        rings = [corners[list(ring)] for ring in surface.rings if len(ring) >= 3]
        if not rings or len(surface.rings[0]) < 3:
            continue
        faces = triangles(rings)
        if len(faces):
            material = MATERIALS.get(surface.kind) or _guess_material(rings[0])
            parts.append(part_of(material, np.concatenate(rings), faces))
    if not parts:
        raise InputError("has no surface with an area", "give solids or surfaces")
    return merge_parts(parts)


def _guess_material(outline: Floats) -> Material:
    """Roof, wall or ground by which way a surface faces."""
    normal = newell(outline)
    rise = float(normal[2] / np.linalg.norm(normal))
    return ROOF if rise > STEEP else GROUND if rise < -0.9 else WALL
