"""Twenty halls no rule of ours was written for: shops, canteens, exhibitions, waiting rooms,
libraries, gates and showrooms of many outlines and sizes.

A hall is one row: what it is called, its corners, its doors and what it is to hold, in words that
:func:`new_halls` reads. They guard rules that repair layouts (:mod:`.passes`).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

from scenewright.core.brief import Brief

Point = tuple[float, float]


class Door(NamedTuple):
    """Where the middle of a door is, how wide it is, in metres, and what it is used for."""

    x: float
    y: float
    width: float = 1.8
    use: str = "entrance"


class HallRow(NamedTuple):
    """A hall: its corners, its doors, its demands as ``"name: 6 category at zone; ..."`` (metres of
    front as ``12m``), its zones as ``"name area; ..."`` in square metres, columns by their middles,
    and by how many degrees all of it is turned."""

    outline: tuple[Point, ...]
    doors: tuple[Door, ...]
    demands: str
    zones: str = ""
    columns: tuple[Point, ...] = ()
    turned: float = 0.0


def rectangle(width: float, depth: float) -> tuple[Point, ...]:
    """The corners of a rectangle whose lower left corner is the origin, in metres."""
    return ((0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth))


def regular(corners: int, radius: float) -> tuple[Point, ...]:
    """The corners of a regular polygon about the origin with an edge in the south, in metres."""
    turns = [2.0 * math.pi * (k + 0.5) / corners - 0.5 * math.pi for k in range(corners)]
    return tuple((round(radius * math.cos(t), 3), round(radius * math.sin(t), 3)) for t in turns)


NEW_HALLS: dict[str, HallRow] = {
    "bakery": HallRow(
        rectangle(11.0, 7.5),
        (Door(3.0, 0.0, 1.4), Door(11.0, 6.0, 1.0, "exit")),
        "2 counter; 2 display_cabinet; 6 round_table; 1 vending_machine",
    ),
    "pharmacy": HallRow(
        ((0, 0), (14, 0), (14, 6), (8, 6), (8, 11), (0, 11)),
        (Door(11.0, 0.0, 1.6),),
        "2 counter; 14m wall_shelving; 4 gondola; 1 display_table; 2 dining_chair",
    ),
    "garden centre": HallRow(
        rectangle(34.0, 22.0),
        (Door(6.0, 0.0, 3.0), Door(34.0, 18.0, 1.6, "exit")),
        "3 checkout at tills; 2 basket_stack at tills; 40m gondola at goods;"
        " 14 display_table at plants;"
        " 6 potted_tree at plants; 16m wall_shelving at goods; 1 info_desk at tills",
        "tills 130; goods 330; plants 280",
        tuple((x, y) for x in (8.5, 17.0, 25.5) for y in (7.5, 15.0)),
    ),
    "shoe shop": HallRow(
        rectangle(6.5, 19.0),
        (Door(3.2, 0.0, 1.8),),
        "1 checkout; 16m wall_shelving; 3 bench; 3 display_table; 1 mannequin",
    ),
    "bookshop": HallRow(
        ((0, 0), (15, 0), (18, 4), (18, 13), (0, 13)),
        (Door(5.0, 0.0, 1.8), Door(0.0, 11.0, 1.0, "exit")),
        "1 checkout; 16 bookcase; 6 display_table; 12m book_stack; 1 sofa; 2 armchair;"
        " 1 coffee_table",
        turned=28.0,
    ),
    "clothes shop": HallRow(
        ((0, 0), (20, 0), (20, 9), (14, 9), (14, 15), (0, 15)),
        (Door(10.0, 0.0, 2.4), Door(0.0, 12.0, 1.2, "exit")),
        "2 checkout; 10 clothes_rail; 4 round_rack; 5 mannequin; 5 fitting_room; 10m wall_shelving;"
        " 3 pouf; 4 display_table",
    ),
    "school canteen": HallRow(
        rectangle(24.0, 14.0),
        (Door(3.0, 0.0, 2.0), Door(21.0, 0.0, 1.6, "exit")),
        "3 counter; 18 dining_table; 2 vending_machine; 3 litter_bin; 1 fridge_shelf",
        columns=((8.0, 7.0), (16.0, 7.0)),
    ),
    "office canteen": HallRow(
        regular(6, 10.5),
        (Door(0.0, -9.093, 2.0), Door(0.0, 9.093, 1.4, "exit")),
        "2 counter at buffet; 1 checkout at buffet; 10 round_table at seats;"
        " 4 dining_table at seats;"
        " 1 sofa at seats; 2 armchair at seats; 2 litter_bin",
        "buffet 80; seats 190",
    ),
    "village feast": HallRow(
        rectangle(28.0, 15.0),
        (Door(28.0, 7.5, 2.4), Door(4.0, 0.0, 1.4, "exit")),
        "stage: 1 stage; 24 dining_table; bar: 2 counter; 2 round_table",
    ),
    "town museum": HallRow(
        ((0, 0), (22, 0), (22, 8), (30, 8), (30, 18), (10, 18), (10, 10), (0, 10)),
        (Door(4.0, 0.0, 2.0), Door(30.0, 15.0, 1.4, "exit")),
        "1 info_desk at foyer; 3 bench at foyer; 6 lockers at foyer; 12 showcase at rooms;"
        " 12 wall_exhibit at rooms; 1 exhibit_island at rooms; 5 plinth at rooms",
        "foyer 100; rooms 290",
    ),
    "photo gallery": HallRow(
        ((0, 8), (9, 8), (9, 0), (15, 0), (15, 8), (24, 8), (24, 15), (0, 15)),
        (Door(12.0, 0.0, 2.0),),
        "photographs: 26 wall_exhibit; 5 bench; 6 exhibit_panel; 1 info_desk",
    ),
    "science centre": HallRow(
        regular(8, 13.0),
        (Door(0.0, -12.011, 2.6), Door(12.011, 0.0, 1.6, "exit")),
        "tickets: 1 counter at entry; 4 ticket_gate at entry; 8 lockers at entry;"
        " 8 interactive_table at show; skeleton: 1 exhibit_island at show; 8 showcase at show;"
        " 4 pouf at show; 4 exhibit_panel at show",
        "entry 110; show 340",
        ((-5.0, 2.0), (5.0, 2.0)),
    ),
    "clinic waiting room": HallRow(
        ((0, 0), (13, 0), (13, 9), (5, 9), (5, 6), (0, 6)),
        (Door(2.0, 0.0, 1.6), Door(13.0, 7.0, 1.0, "exit")),
        "reception: 1 info_desk; 12 lounge_seat; 2 coffee_table; 4 bench;"
        " 1 vending_machine; 2 potted_tree",
    ),
    "station hall": HallRow(
        rectangle(40.0, 18.0),
        (Door(8.0, 0.0, 4.0), Door(30.0, 18.0, 4.0, "exit"), Door(40.0, 5.0, 2.0)),
        "6 ticket_gate; 4 ticket_machine; tickets: 3 counter; 14 bench; 1 info_desk; 2 sign_totem;"
        " 2 cash_machine; 8 lockers; 4 litter_bin",
        columns=tuple((x, y) for x in (10.0, 20.0, 30.0) for y in (6.0, 12.0)),
    ),
    "boarding gate": HallRow(
        rectangle(22.0, 13.0),
        (Door(4.0, 0.0, 3.0), Door(18.0, 13.0, 1.8, "exit")),
        "2 counter; 3 ticket_gate; 40 auditorium_seat; 2 vending_machine;"
        " 6 rope_barrier; 2 litter_bin",
        turned=-17.0,
    ),
    "branch library": HallRow(
        ((0, 0), (26, 0), (26, 12), (18, 16), (0, 16)),
        (Door(6.0, 0.0, 2.0), Door(26.0, 9.0, 1.2, "exit")),
        "1 info_desk at entry; 2 catalogue_terminal at entry; 30m book_stack at books;"
        " 8 reading_table at reading; 6 carrel at reading; 8 lounge_seat at reading;"
        " 2 copier at entry;"
        " 8 bookcase at books",
        "entry 80; books 170; reading 150",
    ),
    "children's library": HallRow(
        rectangle(12.0, 10.0),
        (Door(0.0, 3.0, 1.6),),
        "1 info_desk; 10 shelf_unit; 10 pouf; 3 reading_table; 6m book_stack; 2 armchair",
        turned=45.0,
    ),
    "lecture room": HallRow(
        ((0, 0), (18, 0), (15, 14), (3, 14)),
        (Door(16.5, 7.0, 1.8), Door(1.5, 7.0, 1.6, "exit")),
        "1 stage; 1 lectern; 1 screen; 84 auditorium_seat",
    ),
    "car showroom": HallRow(
        ((0, 0), (26, 0), (26, 12), (20, 18), (0, 18)),
        (Door(13.0, 0.0, 3.0), Door(0.0, 14.0, 1.4, "exit")),
        "cars: 5 exhibit_island sized 4.4x1.8x1.5; 3 desk; 1 info_desk; 2 sofa;"
        " 1 coffee_table; 2 potted_tree",
    ),
    "bank branch": HallRow(
        ((0, 0), (16, 0), (16, 10), (10, 10), (10, 13), (0, 13)),
        (Door(4.0, 0.0, 1.8), Door(16.0, 8.0, 1.0, "exit")),
        "3 counter; 4 rope_barrier; 3 cash_machine; 3 desk; 2 sofa; 1 coffee_table;"
        " 1 info_desk; 1 sign_totem",
    ),
}
"""By name."""


def new_halls(rows: Mapping[str, HallRow] = NEW_HALLS) -> dict[str, Brief]:
    """The briefs of some halls by name.

    >>> halls = new_halls()
    >>> len(halls), halls["bakery"].rooms[0].demands[0].category
    (20, 'counter')
    """
    return {name: _read_brief(name, row) for name, row in rows.items()}


def _read_brief(name: str, row: HallRow) -> Brief:
    columns = [_turn(_column(x, y), row.turned) for x, y in row.columns]
    doors = [
        {
            "id": f"door {k}",
            "at": _turn(((door.x, door.y),), row.turned)[0],
            "width": door.width,
            "use": door.use,
        }
        for k, door in enumerate(row.doors, 1)
    ]
    hall = {
        "id": "hall",
        "name": name.capitalize(),
        "outline": _turn(row.outline, row.turned),
        "holes": columns,
        "height": 3.6,
        "doors": doors,
        "zones": [_read_zone(text) for text in row.zones.split(";") if text.strip()],
        "demands": [_read_demand(text) for text in row.demands.split(";")],
    }
    return Brief.model_validate({"domain": "hall", "name": name.capitalize(), "rooms": [hall]})


def _column(x: float, y: float, half: float = 0.25) -> tuple[Point, ...]:
    return ((x - half, y - half), (x - half, y + half), (x + half, y + half), (x + half, y - half))


def _turn(points: tuple[Point, ...], degrees: float) -> list[list[float]]:
    cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [[x * cos - y * sin, x * sin + y * cos] for x, y in points]


def _read_zone(text: str) -> dict[str, Any]:
    name, area = text.split()
    return {"id": name, "area": float(area)}


def _read_demand(text: str) -> dict[str, Any]:
    """One of ``"name: 6 category at zone sized 1x1x1"``: name, zone and size may be left out."""
    title, _, rest = text.rpartition(":")
    number, category, *more = rest.split()
    words = dict(zip(more[::2], more[1::2], strict=True))
    many = {"length": float(number[:-1])} if number.endswith("m") else {"count": int(number)}
    found: dict[str, Any] = {"category": category, "name": title.strip(), **many}
    if "at" in words:
        found["zone"] = words["at"]
    if "sized" in words:
        found["size"] = [float(side) for side in words["sized"].split("x")]
    return found
