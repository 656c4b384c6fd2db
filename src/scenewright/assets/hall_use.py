"""How the furniture of public halls is placed unless a brief says otherwise.

Clearances follow planning guides (Neufert, *Architects' Data*; Panero & Zelnik, *Human Dimension
and Interior Space*, 1979): half of an aisle of 1.2 to 1.5 m before a shelf, since two that face
each other share it; about 0.45 m of seatway in a row of seats; 0.75 to 0.9 m for those who stop
and look; nothing beside what stands side by side with its like.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

Place = Literal["wall", "free"]
Sides = tuple[float, float, float, float]


class HallUse(NamedTuple):
    """How planners place objects of one category: at a wall or free on the floor, the
    ``clearance`` in metres before, to the left of, behind and to the right of each, and the
    patterns in which a group of them is laid out."""

    category: str
    place: Place
    clearance: Sides
    patterns: tuple[str, ...]


ELSE_CLEARANCE: Sides = (0.6, 0.6, 0.6, 0.6)
ELSE_PATTERNS = ("chain", "grid", "single")


def _free(names: str, clearance: Sides, patterns: str) -> tuple[HallUse, ...]:
    return tuple(HallUse(n, "free", clearance, tuple(patterns.split())) for n in names.split())


def _wall(names: str, front: float, sides: float = 0.0) -> tuple[HallUse, ...]:
    clearance = (front, sides, 0.0, sides)
    return tuple(HallUse(n, "wall", clearance, ("wall",)) for n in names.split())


def _round(depth: float) -> Sides:
    return depth, depth, depth, depth


_ROWS = (
    _free("showcase", (0.75, 0.45, 0.75, 0.45), "chain radiation grid"),
    _free("plinth", _round(0.75), "radiation grid chain"),
    _free("exhibit_panel", (0.75, 0.1, 0.75, 0.1), "chain radiation"),
    _free("exhibit_island", _round(0.9), "single grid"),
    _free("interactive_table", _round(0.75), "grid single"),
    _free("rope_barrier", (0.3, 0.0, 0.3, 0.0), "chain"),
    _free("ticket_gate", (1.2, 0.0, 1.2, 0.0), "chain"),
    _free("info_desk", (1.2, 0.3, 0.9, 0.3), "single"),
    _free("checkout", (0.9, 0.0, 0.6, 0.0), "chain single"),
    _free("counter", (0.9, 0.0, 0.9, 0.0), "chain single"),
    _free("gondola", (0.7, 0.0, 0.7, 0.0), "chain"),
    _free("book_stack", (0.6, 0.0, 0.6, 0.0), "chain"),
    _free("ring_shelf", (0.75, 0.0, 0.0, 0.0), "circulation chain"),
    _free("clothes_rail", (0.6, 0.2, 0.6, 0.2), "chain grid"),
    _free("round_rack", _round(0.6), "grid chain"),
    _free("mannequin", _round(0.3), "grid chain single"),
    _free("display_table", _round(0.6), "grid chain radiation"),
    _free("basket_stack", _round(0.3), "single chain"),
    _free("reading_table", (0.9, 0.6, 0.9, 0.6), "grid chain"),
    _free("reading_chair dining_chair office_chair", (0.1, 0.1, 0.5, 0.1), "grid fan chain"),
    _free("lounge_seat armchair sofa", (0.5, 0.15, 0.15, 0.15), "radiation circulation grid"),
    _free("bench pouf", (0.5, 0.2, 0.5, 0.2), "grid chain single"),
    _free("carrel", (0.75, 0.0, 0.0, 0.0), "chain grid"),
    _free("desk", (0.9, 0.0, 0.0, 0.0), "grid chain"),
    _free("dining_table round_table outdoor_table", _round(0.75), "grid chain"),
    _free("coffee_table", _round(0.4), "grid single"),
    _free("catalogue_terminal", (0.75, 0.1, 0.1, 0.1), "chain radiation single"),
    _free("auditorium_seat", (0.45, 0.0, 0.0, 0.0), "fan chain"),
    _free("lectern", (0.3, 0.3, 0.75, 0.3), "single"),
    _free("stage", (1.2, 0.0, 0.0, 0.0), "single"),
    _free("piano", (0.9, 0.3, 0.0, 0.3), "single"),
    _free("sign_totem litter_bin", (0.45, 0.15, 0.15, 0.15), "single"),
    _free("potted_tree planter", _round(0.15), "grid chain single"),
    _wall("wall_exhibit", 0.9, 0.1),
    _wall("wall_shelving fridge_shelf bookcase storage_shelf shelf_unit", 0.75),
    _wall("lockers vending_machine", 0.9),
    _wall("display_cabinet", 0.75, 0.1),
    _wall("fitting_room", 0.9),
    _wall("screen", 0.9, 0.1),
)

USE: dict[str, HallUse] = {row.category: row for rows in _ROWS for row in rows}


def hall_use(category: str) -> HallUse:
    """How a category is placed in a hall; what has no row stands free, 0.6 m clear all around.

    >>> hall_use("gondola").clearance
    (0.7, 0.0, 0.7, 0.0)
    >>> hall_use("fountain").place
    'free'
    """
    return USE.get(category) or HallUse(category, "free", ELSE_CLEARANCE, ELSE_PATTERNS)
