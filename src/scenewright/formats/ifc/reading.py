"""A building model as a brief: IfcSpaces are rooms, else what the walls of a storey enclose.

Doors and windows stand where their openings are; columns become holes of their room, sanitary ware
and stairs stay where they stand, furniture is planned anew unless it is kept. What else a model
holds (slabs, roofs, pipes …) is counted in the input report.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import shapely
from pydantic import ValidationError

from scenewright.building.outlines import rings as clean_rings
from scenewright.building.room_names import functions_from_name, says_nothing
from scenewright.core.brief import Brief
from scenewright.core.brief.input_report import Fate, report_input
from scenewright.core.document_faults import to_input_error
from scenewright.core.errors import InputError
from scenewright.core.isolated_reading import Allowance, read_apart
from scenewright.formats.ifc.extract import GREATEST_FILE, HEAD, check_head
from scenewright.formats.ifc.openings import OPENINGS, add_open_sides, place_openings
from scenewright.formats.ifc.pieces import BUILT_IN, MOVABLE, fixed_item
from scenewright.formats.ifc.rooms import WALLS, DrawnRoom, Row, find_rooms, floor_of, is_outside
from scenewright.formats.ifc.source import ANEW, record_source

ALLOWANCE = Allowance(memory=768, per_size=24, seconds=300)
FAR = 5000.0
"""Coordinates beyond this, in metres, are brought near to the origin."""
BEDROOM = 7.0


def read_brief(path: Path, keep: bool = False) -> Brief:
    """The brief of an IFC file; ``keep`` leaves its furniture where it stands."""
    return brief_of(parse(path, keep), path, keep)


def parse(path: Path, keep: bool = False) -> Row:
    """The document of a file (:mod:`scenewright.formats.ifc.extract`), made by another process.
    Raises :class:`InputError` for whatever cannot be parsed."""
    if path.stat().st_size > GREATEST_FILE:
        fault = f"is larger than {GREATEST_FILE // 2**20} MiB"
        raise InputError(fault, "export one building, or its plan alone")
    with path.open("rb") as file:
        check_head(file.read(HEAD))
    return read_apart("scenewright.formats.ifc.extract", path, ALLOWANCE, {"keep": keep})


def brief_of(document: Row, path: Path, keep: bool = False) -> Brief:
    """The brief of a parsed model, the file at ``path``."""
    products = document["products"]
    move = _offset(products)
    rooms, fates = find_rooms(document, move)
    if not rooms:
        raise InputError(
            "holds no room: no IfcSpace with a floor, and no storey whose walls enclose one",
            "export spaces (rooms) from the program it was drawn in",
        )
    made = [_room(k, room) for k, room in enumerate(rooms)]
    fates += place_openings(products, rooms, made, move)
    add_open_sides(rooms, made)
    fates += _standing(products, rooms, made, move, keep)
    fates += _others(products, has_spaces=bool(rooms[0].row))
    levels = sorted({room.level for room in rooms})
    floors = {n: min(r.low for r in rooms if r.level == n) for n in levels}
    heights = {n: max(r.height for r in rooms if r.level == n) for n in levels}
    spaces = [row for row in products if row["kind"] == "IfcSpace" and not is_outside(row)]
    drawn = sum(floor_of(row, move).area for row in spaces)
    read = sum(room.floor.area for room in rooms)
    try:
        brief = Brief.model_validate(
            {
                "name": path.stem[:80],
                "levels": [
                    {
                        "id": str(n),
                        "name": document["storeys"][n]["name"] if n >= 0 else "",
                        "elevation": round(floors[n], 4),
                        "height": round(min(max(heights[n], 0.5), 100.0), 4),
                    }
                    for n in levels
                ],
                "rooms": made,
            }
        )
    except ValidationError as error:
        raise to_input_error(error) from None
    report = report_input(
        fates,
        format=f"IFC ({document['schema']})"[:100],
        system=f"moved by {-move[0]:.0f}, {-move[1]:.0f} m" if move.any() else "its own",
        unit=document["unit"] or "metre",
        drawn_floor=round(drawn or read, 3),
        read_floor=round(read, 3),
    )
    reported = brief.model_copy(update={"input_report": report})
    source = record_source(reported, path, document, rooms, move)
    return reported.model_copy(update={"source_file": source})


def _offset(products: Sequence[Row]) -> np.ndarray:
    """The offset taken off all coordinates: 0, unless they lie far from the origin."""
    corners = [row["rings"][0] for row in products if row["rings"]]
    if not corners:
        return np.zeros(2)
    low = np.floor(np.median(np.vstack(corners), axis=0))
    return low if np.abs(low).max() > FAR else np.zeros(2)


def _room(number: int, room: DrawnRoom) -> Row:
    """A room as keys of the brief."""
    outline, holes = clean_rings(room.floor)
    row = room.row
    name = (row.get("long_name") or row.get("name") or f"Room {number + 1}")[:80]
    functions = _functions(room, name)
    return {
        "name": name,
        **({"function": list(functions)} if functions else {}),
        "level": str(room.level),
        "outline": outline.tolist(),
        "holes": [hole.tolist() for hole in holes],
        "height": round(max(room.height, 0.5), 4),
        "doors": [],
        "windows": [],
        "fixed": [],
    }


def _functions(room: DrawnRoom, name: str) -> tuple[str, ...]:
    """What a room is for by its long name, name, object type, stated uses, else by size."""
    row = room.row
    for text in (name, row.get("name", ""), row.get("use", ""), *row.get("uses", ())):
        if not says_nothing(text):
            return functions_from_name(text)
    if row:
        return ()
    return (
        ("living",)
        if room.floor.area > 3 * BEDROOM
        else ("bedroom",)
        if room.floor.area > BEDROOM
        else ()
    )


def _standing(
    products: Sequence[Row],
    rooms: Sequence[DrawnRoom],
    made: list[Row],
    move: np.ndarray,
    keep: bool,
) -> list[Fate]:
    """The pieces in rooms: built in or kept, else planned anew."""
    fates, taken = [], set[str]()
    for row in products:
        kind = row["kind"]
        if kind not in BUILT_IN and kind not in MOVABLE:
            continue
        word, name = _word(kind), row["name"] or row["id"]
        if kind in MOVABLE and not keep:
            fates.append(Fate(name, word, "left out", ANEW))
            continue
        box = floor_of(row, move)
        number = _room_around(box, row, rooms) if box.area > 0 else None
        item = fixed_item(row, box, rooms[number].low) if number is not None else None
        if item is None or number is None:
            fates.append(Fate(name, word, "left out", "it stands in no room, or has no body"))
            continue
        made[number]["fixed"].append(item | {"id": _own_id(row, taken)})
        fates.append(Fate(name, word, "used"))
    return fates


def _own_id(row: Row, taken: set[str]) -> str:
    """The name of a product, with its identifier behind it where another has the same."""
    name = (row["name"] or row["id"])[:80]
    name = name if name not in taken else f"{name} {row['id']}"
    taken.add(name)
    return name


def _room_around(box: shapely.Polygon, row: Row, rooms: Sequence[DrawnRoom]) -> int | None:
    """The room most of a thing stands in."""
    shares = [
        (room.floor.intersection(box).area, k)
        for k, room in enumerate(rooms)
        if room.low - 0.5 <= row["low"] <= room.low + max(room.height, 2.2)
    ]
    share, number = max(shares, default=(0.0, 0))
    return number if share > 0.25 * box.area else None


def _others(products: Sequence[Row], *, has_spaces: bool) -> list[Fate]:
    """Walls, and what furnishing has no use for."""
    known = {"IfcSpace", *OPENINGS, *BUILT_IN, *MOVABLE}
    fates = []
    for row in products:
        if row["kind"] in known:
            continue
        name, word = row["name"] or row["id"], _word(row["kind"])
        if row["kind"] in WALLS:
            why = "drawn anew from the rooms it encloses"
            fates.append(Fate(name, word, "changed" if has_spaces else "used", why * has_spaces))
        else:
            fates.append(Fate(name, word, "left out", "furnishing has no use for it"))
    return fates


def _word(kind: str) -> str:
    """The plain name of an entity.

    >>> _word("IfcFlowTerminal"), _word("IfcWallStandardCase")
    ('flow terminal', 'wall')
    """
    text = kind.removeprefix("Ifc").replace("StandardCase", "").replace("ElementedCase", "")
    return "".join(f" {c.lower()}" if c.isupper() else c for c in text).strip()
