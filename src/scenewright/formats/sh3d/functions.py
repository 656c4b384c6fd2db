"""What the rooms of a Sweet Home 3D level are for: by their names and by their furniture."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

import numpy as np
import shapely

from scenewright.building.room_names import functions_from_name, says_nothing, sort_functions
from scenewright.formats.sh3d.floors import DrawnFloor
from scenewright.formats.sh3d.kinds import kind_of
from scenewright.formats.sh3d.pieces import stays
from scenewright.formats.sh3d.xml import HomePiece

BEDROOM = 7.0
SIGNS = (
    ("bathroom", ("bathtub", "shower")),
    ("toilet", ("toilet",)),
    ("kitchen", ("hob_cabinet", "sink_cabinet", "oven_cabinet", "fridge")),
    ("living", ("sofa", "corner_sofa", "tv_stand")),
    ("double_bedroom", ("double_bed",)),
    ("bedroom", ("single_bed", "bunk_bed")),
    ("dining", ("dining_table", "round_table")),
    ("study", ("desk",)),
    ("washroom", ("washing_machine",)),
)
OPEN_PLAN = ("living", "dining", "kitchen")
LEAST_SIGNS = {"kitchen": 2, "living": 1, "double_bedroom": 1, "bedroom": 1}
"""Functions that a room named otherwise gets besides, and by how many different signs."""
SLEEPING = frozenset({"bedroom", "double_bedroom", "single_bedroom", "child_bedroom"})
SERVED: dict[str, AbstractSet[str]] = {
    "dining": {"living", "kitchen"},
    "study": SLEEPING | {"living"},
    "bedroom": SLEEPING,
    "double_bedroom": SLEEPING,
    "washroom": {"bathroom", "kitchen"},
    "toilet": {"bathroom"},
}
"""Functions that bring what is a sign of another."""


def room_functions(
    found: Sequence[DrawnFloor],
    inside: Sequence[Sequence[HomePiece]],
    doors: Sequence[HomePiece],
    keep: bool,
) -> list[tuple[str, ...]]:
    """By the room's name, with what else is taken out of it to be placed anew (nothing, to
    ``keep``); where it has none or it says nothing, by its furniture, else a hall if it has
    three doors, else (where no room is named) by size."""
    known = [
        _by_name(floor.name, pieces, keep) or function_from_pieces(pieces) or _hall(floor, doors)
        for floor, pieces in zip(found, inside, strict=True)
    ]
    if any(floor.name for floor in found):
        return [functions or ("other",) for functions in known]
    areas = [floor.polygon.area if not f else 0.0 for floor, f in zip(found, known, strict=True)]
    lived = any("living" in functions for functions in known)
    largest = int(np.argmax(areas)) if areas and not lived else -1
    return [
        functions
        or (("living",) if i == largest else ("bedroom",) if areas[i] >= BEDROOM else ("other",))
        for i, functions in enumerate(known)
    ]


def function_from_pieces(pieces: Sequence[HomePiece]) -> tuple[str, ...]:
    """What a room is for by its furniture; empty if nothing tells.

    A toilet with a bathtub or shower is a bathroom; living, dining and kitchen may go together.
    """
    kinds = {kind_of(piece) for piece in pieces}
    found = [function for function, signs in SIGNS if kinds.intersection(signs)]
    if not found or found[0] not in OPEN_PLAN:
        return tuple(found[:1])
    return tuple(function for function in found if function in OPEN_PLAN)


def is_brought(piece: HomePiece, functions: Sequence[str]) -> bool:
    """Whether a room of some functions is furnished with the like of a piece; true of what is the
    sign of no function."""
    kind = kind_of(piece)
    told = [function for function, signs in SIGNS if kind in signs]
    return not told or any(({f} | SERVED.get(f, set())) & {*functions} for f in told)


def _by_name(name: str, pieces: Sequence[HomePiece], keep: bool) -> tuple[str, ...]:
    """The functions a name says, and those of a dwelling that it does not say but that what is
    taken out tells: the kitchen in a living room, the bed in it. Empty if it says nothing."""
    if not name or says_nothing(name):
        return ()
    named = functions_from_name(name)
    if keep or not set(OPEN_PLAN) & {*named}:
        return named
    taken = {kind_of(piece) for piece in pieces if not stays(piece)}
    more = [
        function
        for function, signs in SIGNS
        if len(taken.intersection(signs)) >= LEAST_SIGNS.get(function, len(signs) + 1)
        and function not in named
        and not SERVED.get(function, set()) & {*named}
    ]
    return sort_functions([*named, *more])


def _hall(floor: DrawnFloor, doors: Sequence[HomePiece]) -> tuple[str, ...]:
    if not doors:
        return ()
    points = shapely.points([(door.x, door.y) for door in doors])
    near = np.flatnonzero(shapely.distance(floor.polygon, points) < 0.3)
    return ("hall",) if len(near) >= 3 else ()
