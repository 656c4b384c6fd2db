"""What can be liked about a furnished home, as numbers, and the reasons people give."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Opening, Space
from scenewright.domains.home.terms.table import MEANINGS
from scenewright.engine.preference.features import (
    Floats,
    compose_space,
    space_area,
    stands_on_floor,
)
from scenewright.geometry.composition import NAMES

BED_OR_COT = ("sleeping", "single", "bunk", "cot")
PLACES = {
    "bed": BED_OR_COT,
    "desk": ("desk",),
    "sofa": ("seating",),
    "table": ("dining", "dining_wall"),
    "reading": ("reading",),
}
"""What people speak of, by the furniture groups it is in."""
WORDS = ("to window", "to door", "looks east", "looks north")
PLACE_NAMES = tuple(f"{name} {word}" for name in PLACES for word in WORDS)
TERM_NAMES = tuple(MEANINGS)
FAR_IN_ROOM = 3.0
"""Metres that count as far in a room."""

REASONS: dict[str, dict[str, float]] = {
    "too dense": {"density": -1, "open": 1, "gaps": 1, "enclosure": -0.5},
    "too empty": {"density": 1, "open": -1},
    "more sun": {"term daylight": -1, "sofa to window": -1, "desk to window": -1},
    "more open floor": {"open": 1, "enclosure": -1},
    "tidier": {"rows": 1, "alignment": 1, "uneven_gaps": -1},
    "desk to the window": {"desk to window": -1},
    "bed away from the door": {"bed to door": 1},
    "bed to the window": {"bed to window": -1},
    "sofa to the window": {"sofa to window": -1},
    "table to the window": {"table to window": -1},
    "furniture along the walls": {"from_edge": -1},
    "better balanced": {"term balance": -1},
}
"""Reasons by their words: features, and the sign in which they should change."""


class RoomFeatures(NamedTuple):
    """What can be liked about one room: what each term costs, the composition (17,), the weight it
    has in the home's (the area of a room that holds anything), and by name what was measured of
    beds, desks, sofas and tables there are."""

    terms: Floats
    composition: Floats
    weight: float
    places: Mapping[str, float]


def measure_features(solution: Solution, plan: Plan) -> dict[str, float]:
    """The features of a furnished home by name: terms, composition of the rooms, and how far
    beds, desks, sofas and tables stand from windows and doors and which way they look."""
    return combine_rooms([measure_room(solution, space) for space in plan.spaces])


def measure_room(solution: Solution, room: Space) -> RoomFeatures:
    """The features of one room of a home."""
    terms = np.zeros(len(TERM_NAMES))
    for row in solution.terms:
        if row.space == room.id and np.isfinite(row.cost):
            terms[TERM_NAMES.index(row.term)] += row.cost
    here = [p for p in solution.pieces if p.space == room.id and stands_on_floor(p)]
    counted = [p for p in here if p.category != "rug"]
    places: dict[str, float] = {}
    for name, groups in PLACES.items():
        leads = _largest_of_groups([p for p in counted if p.function in groups])
        if leads:
            values = np.mean([_measure_lead(piece, room) for piece in leads], axis=0)
            places |= zip((f"{name} {word}" for word in WORDS), values.tolist(), strict=True)
    composition = compose_space(counted, room) if counted else np.zeros(len(NAMES))
    return RoomFeatures(terms, composition, space_area(room) if counted else 0.0, places)


def combine_rooms(rooms: Sequence[RoomFeatures]) -> dict[str, float]:
    """The features of a home of such rooms: costs add up, composition is the mean by area, and
    what is measured of furniture the mean over rooms that have such."""
    terms = np.sum([room.terms for room in rooms], axis=0)
    weight = max(sum(room.weight for room in rooms), 1e-9)
    composition = np.sum([room.weight * room.composition for room in rooms], axis=0) / weight
    found = dict(zip((f"term {name}" for name in TERM_NAMES), terms.tolist(), strict=True))
    found |= zip(NAMES, composition.tolist(), strict=True)
    for name in PLACE_NAMES:
        values = [room.places[name] for room in rooms if name in room.places]
        found[name] = sum(values) / len(values) if values else 0.0
    return found


def _measure_lead(piece: Piece, room: Space) -> tuple[float, ...]:
    """How far a piece is from a window and a door, and the way it looks."""
    heading = piece.pose.heading
    window, door = _distance_to(piece, room, "window"), _distance_to(piece, room, "door")
    return window, door, float(np.cos(heading)), float(np.sin(heading))


def _largest_of_groups(pieces: Sequence[Piece]) -> list[Piece]:
    """The largest piece of each group: the bed, not its nightstands."""

    def size(piece: Piece) -> float:
        return piece.size.width * piece.size.depth

    best: dict[str, Piece] = {}
    for piece in pieces:
        if piece.category != "rug" and (
            piece.group not in best or size(piece) > size(best[piece.group])
        ):
            best[piece.group] = piece
    return list(best.values())


def _distance_to(piece: Piece, room: Space, kind: str) -> float:
    """Metres over :data:`FAR_IN_ROOM` from a piece to the nearest opening of a kind, at most 2."""
    ways: list[Opening] = [o for o in room.openings if o.kind == kind]
    far = [np.hypot(o.x - piece.pose.x, o.y - piece.pose.y) / FAR_IN_ROOM for o in ways]
    return float(min(far, default=2.0))
