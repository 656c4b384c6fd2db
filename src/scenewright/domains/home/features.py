"""What can be liked about a furnished home, as numbers, and the reasons people give."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Opening, Space
from scenewright.domains.home.terms.table import MEANINGS
from scenewright.engine.preference.features import (
    composition_features,
    mean_distance,
    stands_on_floor,
    term_features,
)

BEDS = ("sleeping", "single", "bunk", "cot")
PLACES = {
    "bed": BEDS,
    "desk": ("desk",),
    "sofa": ("seating",),
    "table": ("dining", "dining_wall"),
    "reading": ("reading",),
}
"""What people speak of, by the furniture groups it is in."""
FAR = 3.0
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


def measure_features(solution: Solution, plan: Plan) -> dict[str, float]:
    """The features of a furnished home by name: terms, composition of the rooms, and how far
    beds, desks, sofas and tables stand from windows and doors and which way they look."""
    found = term_features(solution, MEANINGS)
    found |= composition_features(solution, plan, _counts)
    for name, groups in PLACES.items():
        here = [p for p in solution.pieces if p.function in groups and stands_on_floor(p)]
        rooms = {space.id: space for space in plan.spaces}
        leads = _largest_of_groups(here)
        for kind in ("window", "door"):
            far = [_distance_to(p, rooms[p.space], kind) for p in leads]
            found[f"{name} to {kind}"] = float(np.mean(far)) if far else 1.0
        look = [p.pose.heading for p in leads]
        found[f"{name} looks east"] = float(np.mean(np.cos(look))) if look else 0.0
        found[f"{name} looks north"] = float(np.mean(np.sin(look))) if look else 0.0
    cook, eat = _of(solution, ("kitchen", "counter")), _of(solution, PLACES["table"])
    found["table to kitchen"] = mean_distance(eat, cook, FAR)
    return found


def _counts(piece: Piece) -> bool:
    return stands_on_floor(piece) and piece.category != "rug"


def _of(solution: Solution, groups: Sequence[str]) -> list[Piece]:
    return [p for p in solution.pieces if p.function in groups and stands_on_floor(p)]


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
    """Metres over :data:`FAR` from a piece to the nearest opening of a kind, at most 2."""
    ways: list[Opening] = [o for o in room.openings if o.kind == kind]
    far = [np.hypot(o.x - piece.pose.x, o.y - piece.pose.y) / FAR for o in ways]
    return float(min(far, default=2.0))
