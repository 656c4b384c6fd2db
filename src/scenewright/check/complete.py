"""Completeness: does a room hold what its function is unthinkable without?

Validity says nothing is wrong; completeness that something is there. What counts as essential is
our own table, after the rooms people actually live in; it judges categories only.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.brief import Room
from scenewright.check.bodies import Bodies, Rooms, Shape
from scenewright.check.ceilings import SHOULDERS, lower_than
from scenewright.check.report import Note
from scenewright.room_names import says_nothing
from scenewright.space import Space


class Need(NamedTuple):
    """One thing a function needs: what it is called, the categories that serve, how many."""

    name: str
    categories: frozenset[str]
    least: int = 1


class Usable(NamedTuple):
    """The least floor area in square metres and inscribed width in metres for a function."""

    area: float
    width: float


def _need(name: str, categories: str, least: int = 1) -> Need:
    return Need(name, frozenset(categories.split()), least)


_SEAT = "sofa loveseat corner_sofa armchair"
_FOCAL = "tv tv_stand fireplace bookcase sideboard shelf_unit display_cabinet piano"
_BED = _need("bed", "single_bed double_bed bunk_bed cot")
_CLOTHES = _need("wardrobe", "wardrobe chest_of_drawers")
_STORAGE = "storage_shelf shelf_unit bookcase wardrobe chest_of_drawers tall_cabinet shoe_cabinet"
_COATS = "shoe_cabinet coat_rack console_table bench wardrobe sideboard storage_shelf"
_BASIN = "basin pedestal_basin"

ESSENTIALS: dict[str, tuple[Need, ...]] = {
    "living": (
        _need("seat", _SEAT),
        _need("table", "coffee_table side_table dining_table round_table"),
        _need("screen or focal point", _FOCAL),
    ),
    "dining": (
        _need("dining table", "dining_table round_table"),
        _need("two chairs", "dining_chair bar_stool stool bench", 2),
    ),
    "kitchen": (
        _need("sink", "sink_cabinet"),
        _need("hob", "hob_cabinet"),
        _need("fridge", "fridge"),
        _need("base units", "base_cabinet drawer_cabinet sink_cabinet hob_cabinet dishwasher", 2),
    ),
    "bedroom": (_BED, _CLOTHES),
    "double_bedroom": (
        _need("double bed", "double_bed"),
        _need("nightstand", "nightstand"),
        _CLOTHES,
    ),
    "single_bedroom": (_BED, _CLOTHES),
    "child_bedroom": (_BED, _CLOTHES),
    "study": (
        _need("desk", "desk kids_desk"),
        _need("chair", "office_chair dining_chair stool"),
    ),
    "bathroom": (
        _need("basin", _BASIN),
        _need("bath, shower or toilet", "bathtub shower toilet"),
    ),
    "toilet": (_need("toilet", "toilet"),),
    "washroom": (_need("basin or washing machine", f"{_BASIN} washing_machine"),),
    "storage": (_need("storage", _STORAGE),),
    "hall": (_need("somewhere for coats or shoes", _COATS),),
}
"""What each function needs; a room of several functions needs all of theirs."""

USABLE: dict[str, Usable] = {
    "living": Usable(7.0, 2.0),
    "dining": Usable(4.0, 1.8),
    "kitchen": Usable(3.0, 1.4),
    "bedroom": Usable(4.0, 1.6),
    "double_bedroom": Usable(7.0, 2.2),
    "single_bedroom": Usable(4.0, 1.6),
    "child_bedroom": Usable(4.0, 1.6),
    "study": Usable(3.0, 1.4),
    "bathroom": Usable(1.5, 1.0),
    "toilet": Usable(0.7, 0.7),
    "washroom": Usable(1.2, 0.8),
    "storage": Usable(0.5, 0.5),
    "hall": Usable(2.5, 1.1),
}
"""From which size on a room is expected to hold its essentials; smaller ones are never noted."""


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


def expected(functions: tuple[str, ...], shape: Shape) -> tuple[str, ...]:
    """The functions among ``functions`` whose essentials a room of this shape should hold.

    An open plan has to be large enough for all that have essentials together, else only for the
    first ones that fit.
    """
    left, width, kept = float(shape.area), inscribed_width(shape), []
    for function in functions:
        least = USABLE.get(function)
        if least and left >= least.area and width >= least.width:
            kept.append(function)
            left -= least.area
    return tuple(kept)


def find_incomplete(bodies: Bodies, rooms: Rooms) -> list[Note]:
    """A note for each essential thing a room of usable size lacks."""
    notes: list[Note] = []
    for i, space in enumerate(rooms.spaces):
        held = [bodies.pieces[k].category for k in np.flatnonzero(bodies.room == i)]
        for function in expected(space.functions, under_ceiling(space, rooms.shapes[i])):
            room = f"{space.id} ({function}, {rooms.shapes[i].area:.1f} m²)"
            notes += [
                Note(space.id, function, need.name, f"{room} has no {need.name}")
                for need in ESSENTIALS[function]
                if sum(category in need.categories for category in held) < need.least
            ]
    return notes


def find_unknown(asked: Mapping[str, Room], bodies: Bodies, rooms: Rooms) -> list[Note]:
    """A note for each room that stands empty because neither the brief nor its name says what it
    is for; shafts and other small ones are left out."""
    notes = []
    for i, space in enumerate(rooms.spaces):
        room = asked.get(space.id)
        if room is None or room.function or room.ask is not None or not says_nothing(room.name):
            continue
        held = [bodies.pieces[k].function for k in np.flatnonzero(bodies.room == i)]
        least, shape = USABLE["hall"], rooms.shapes[i]
        small = shape.area < least.area or inscribed_width(shape) < least.width
        if not (small or any(function != "light" for function in held)):
            said = f"{space.id} ({shape.area:.1f} m²) is left empty: its use is not known; "
            notes.append(Note(space.id, "other", "a use", said + 'give it a "function"'))
    return notes


def find_doorless(bodies: Bodies, rooms: Rooms) -> list[Note]:
    """A note for each room of usable size that no door or passage joins to anything.

    Rooms of function ``other`` (shafts, voids) and balconies, often stepped onto through a
    window, are left out, and those reached by a staircase in them.
    """
    stairs = with_stairs(bodies, rooms)
    notes = []
    for space, shape in zip(rooms.spaces, rooms.shapes, strict=True):
        joined = any(opening.kind != "window" for opening in space.openings)
        if joined or space.id in stairs or not lived_in(space.functions, shape):
            continue
        functions = ", ".join(space.functions)
        told = f"{space.id} ({functions}, {shape.area:.1f} m²) has no door: nobody can enter it"
        notes.append(Note(space.id, space.functions[0], "a door", told))
    return notes


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


def room_figures(bodies: Bodies, rooms: Rooms) -> dict[str, dict[str, Any]]:
    """Pieces, floor area in square metres and density of each space.

    Density is the share of the floor covered by what stands on it (rugs not counted).
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
