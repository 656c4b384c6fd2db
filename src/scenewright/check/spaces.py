"""What the shape of a room says of its use: how wide it is, whether one lives there."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
import shapely

from scenewright.building.room_needs import USABLE
from scenewright.check.bodies import Bodies, Rooms, Shape
from scenewright.check.ceilings import SHOULDERS, lower_than
from scenewright.core.report import Note
from scenewright.core.space import Space


def inscribed_width(shape: Shape) -> float:
    """Diameter in metres of the largest circle that fits in a room.

    >>> round(inscribed_width(shapely.box(0, 0, 4, 2)), 2)
    2.0
    """
    if shape.is_empty or shape.area < 1e-6:
        return 0.0
    return 2 * float(shapely.length(shapely.maximum_inscribed_circle(shape, tolerance=0.005)))


def under_ceiling(space: Space, shape: Shape) -> Shape:
    """The part of a room's floor in which one can stand at least stooping, its ceiling
    :data:`SHOULDERS` high."""
    return shapely.difference(shape, lower_than(space, shape, SHOULDERS))


def with_stairs(bodies: Bodies, rooms: Rooms) -> set[str]:
    """The ids of the rooms that stairs lead into or out of."""
    known = {space.id for space in rooms.spaces if space.stairs}
    return known | {p.space for p in bodies.pieces if p.category == "staircase"}


def lived_in(functions: tuple[str, ...], shape: Shape) -> bool:
    """Whether a room is there for people and large enough for the first of its functions."""
    if not functions or set(functions) & {"other", "balcony"}:
        return False
    least = USABLE.get(functions[0], USABLE["storage"])
    return bool(shape.area >= least.area) and inscribed_width(shape) >= least.width


def find_doorless(bodies: Bodies, rooms: Rooms, visited: Collection[str] = ()) -> list[Note]:
    """A note for each room of usable size that no door or passage joins to anything.

    Rooms of function ``other`` (shafts, voids) and balconies, often stepped onto through a
    window, are left out, and those reached by a staircase in them, but for the spaces ``visited``
    whatever their functions.
    """
    stairs = with_stairs(bodies, rooms)
    notes = []
    for space, shape in zip(rooms.spaces, rooms.shapes, strict=True):
        joined = any(opening.kind != "window" for opening in space.openings)
        used = space.id in visited or lived_in(space.functions, shape)
        if joined or space.id in stairs or not used:
            continue
        functions = "".join(f"{name}, " for name in space.functions if name != "other")
        text = f"{space.id} ({functions}{shape.area:.1f} m²) has no door: nobody can enter it"
        notes.append(Note(space.id, next(iter(space.functions), ""), "a door", text))
    return notes


def room_figures(bodies: Bodies, rooms: Rooms) -> dict[str, dict[str, Any]]:
    """Pieces, floor area in square metres and density of each space.

    Density is the share of the floor covered by pieces (rugs not counted).
    """
    figures = {}
    stands = bodies.underfoot
    for i, space in enumerate(rooms.spaces):
        rows = np.flatnonzero(bodies.room == i)
        area = float(rooms.shapes[i].area)
        footprint = shapely.union_all(bodies.footprints[rows[stands[rows]]])
        covered = float(shapely.area(shapely.intersection(footprint, rooms.shapes[i])))
        figures[space.id] = {
            "pieces": len(rows),
            "area": round(area, 3),
            "density": round(covered / area, 4) if area else 0.0,
        }
    return figures
