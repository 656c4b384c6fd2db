"""Completeness: does a room hold its essential furniture?

Validity says nothing is wrong; completeness that something is there. What counts as essential is
a table of :mod:`scenewright.building.room_needs`; which pieces serve as it is stated in their
kinds.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np
import shapely

from scenewright.building.open_spaces import find_open_spaces
from scenewright.building.room_names import says_nothing
from scenewright.building.room_needs import ESSENTIALS, USABLE
from scenewright.check.bodies import Bodies, Rooms, Shape
from scenewright.check.spaces import inscribed_width, under_ceiling
from scenewright.core.brief import Room
from scenewright.core.report import Finding, Note
from scenewright.core.solution import LeftOut
from scenewright.domains.home.needs.household import BED_PLACES

SHARED = frozenset(("living", "dining", "kitchen", "hall"))
"""Functions whose essentials may stand in any room of an open space."""


def find_expected_functions(functions: tuple[str, ...], shape: Shape) -> tuple[str, ...]:
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
    """A note for each essential thing a room of usable size lacks. Rooms that are one open space
    share what :data:`SHARED` functions need: it may stand in any of them, and is missed once, in
    the largest that should hold it."""
    due = [
        find_expected_functions(space.functions, under_ceiling(space, shape))
        for space, shape in zip(rooms.spaces, rooms.shapes, strict=True)
    ]
    notes: list[Note] = []
    for i, parts in enumerate(_open_parts(rooms)):
        for function in due[i]:
            shared = [k for k in parts if function in SHARED and function in due[k]] or [i]
            if i == max(shared, key=lambda k: float(rooms.shapes[k].area)):
                inside = parts if function in SHARED else (i,)
                notes += _lacking(i, function, inside, bodies, rooms)
    return notes


def _open_parts(rooms: Rooms) -> list[tuple[int, ...]]:
    """For each room the numbers of the rooms that are one open space with it, its own included."""
    number = {space.id: i for i, space in enumerate(rooms.spaces)}
    parts: list[tuple[int, ...]] = [(i,) for i in range(len(rooms.spaces))]
    for ids in find_open_spaces(rooms.spaces):
        together = tuple(sorted(number[space] for space in ids))
        for i in together:
            parts[i] = together
    return parts


def _lacking(
    room: int, function: str, parts: Sequence[int], bodies: Bodies, rooms: Rooms
) -> list[Note]:
    """Notes of what the function of a room needs and none of ``parts`` holds."""
    held = [bodies.kinds[k].essential for k in np.flatnonzero(np.isin(bodies.room, parts))]
    space = rooms.spaces[room]
    text = f"{space.id} ({function}, {rooms.shapes[room].area:.1f} m²)"
    return [
        Note(space.id, function, need.name, f"{text} has no {need.name}")
        for need in ESSENTIALS[function]
        if sum(need.name in serves for serves in held) < need.least
    ]


def find_unmet_asks(asked: Mapping[str, Room], bodies: Bodies, rooms: Rooms) -> list[Note]:
    """A note for each group required of a room that it has too few of."""
    notes = []
    for i, space in enumerate(rooms.spaces):
        room = asked.get(space.id)
        here = [bodies.pieces[k] for k in np.flatnonzero(bodies.room == i)]
        groups = Counter({piece.group or piece.id: piece.function for piece in here}.values())
        wanted: Counter[str] = Counter()
        for ask in (room.ask or ()) if room else ():
            wanted[ask.group] += ask.count if ask.required else 0
        notes += [
            Note(
                space.id,
                group,
                group,
                f"{space.id} was to hold {n} {group} and has {groups[group]}",
            )
            for group, n in wanted.items()
            if groups[group] < n
        ]
    return notes


def find_short_beds(residents: int | None, bodies: Bodies) -> list[Note]:
    """A note where fewer can sleep in a home than are stated to live in it."""
    held = sum(BED_PLACES.get(piece.category, 0) for piece in bodies.pieces)
    if residents is None or held >= residents:
        return []
    text = f"there are beds for {held or 'none'} of the {residents} residents"
    return [Note("", "sleeping", "beds", text)]


def find_missing(
    lacking: Sequence[Note], asked: Mapping[str, Room], rooms: Rooms, left_out: Sequence[LeftOut]
) -> list[Finding]:
    """A finding for each room that lacks something essential or asked for, where nothing is said to
    be left out of it, nor of one that is open to it, with a reason. Essentials of rooms that state
    what they are to hold, or are not to, are not owed."""
    if not lacking:
        return []
    told = {out.space for out in left_out if out.reason.strip()}
    open_to = [[rooms.spaces[k].id for k in parts] for parts in _open_parts(rooms)]
    beside = dict(zip((space.id for space in rooms.spaces), open_to, strict=True))
    found: dict[str, list[Note]] = {}
    for note in lacking:
        room = asked.get(note.space)
        own = room is not None and room.ask is not None and note.function != note.missing
        barred = room is not None and any(wish.forbid for wish in room.wishes)
        everywhere = told if not note.space else told & {*beside[note.space]}
        if not (own or barred or everywhere):
            found.setdefault(note.space, []).append(note)
    return [
        Finding("missing", "", space, "", "", f"{notes[0].message}{_and_more(notes)}")
        for space, notes in found.items()
    ]


def _and_more(notes: Sequence[Note]) -> str:
    rest = f" and lacks {len(notes) - 1} more" if len(notes) > 1 else ""
    return f"{rest}, and nothing says why"


def find_idle_hoods(bodies: Bodies, rooms: Rooms) -> list[Note]:
    """A note for each hood that hangs over nothing to cook on."""
    cooks = np.array(["hob" in kind.essential for kind in bodies.kinds], bool)
    notes = []
    for row, piece in enumerate(bodies.pieces):
        if piece.category == "hood":
            hobs = bodies.footprints[cooks & (bodies.room == bodies.room[row])]
            if not shapely.intersects(hobs, bodies.footprints[row]).any():
                space = rooms.spaces[bodies.room[row]].id
                text = f"{piece.id} of {space} hangs over no hob"
                notes.append(Note(space, "kitchen", "hob below the hood", text))
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
