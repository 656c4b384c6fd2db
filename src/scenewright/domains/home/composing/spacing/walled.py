"""How near walls, columns, open doors and the ways between doors may be to a piece, as a table.

Who sits on a chair pushes it back, who sits on a sofa has their feet before it, and a wardrobe or a
drawer opens: for each the floor that takes is to be within the room, and of most of it no door is
to swing.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from scenewright.catalog.classes import SOFAS
from scenewright.core.scene import Piece
from scenewright.domains.home.composing.outlook import FEET
from scenewright.domains.home.problem import Ground
from scenewright.geometry.boxes import area_in_polygon, beyond, common_area, make_frame

FRONT, BACK = 0, 2
"""The side of a piece on which floor is left free."""


class Walled(NamedTuple):
    """Floor so many ``metres`` deep on a ``side`` of pieces ``of`` some kinds, which share of it
    may be beyond walls or, of what minds ``doors``, in the swing of one, and what it costs if more
    is."""

    of: frozenset[str]
    side: int
    metres: float
    share: float
    doors: bool
    cost: float


WALLED = (
    Walled(frozenset(("dining_chair", "bar_stool")), BACK, 0.4, 0.3, True, 5.0),
    Walled(frozenset(("stool",)), BACK, 0.55, 0.3, True, 5.0),
    Walled(frozenset(("dining_chair", "bar_stool", "stool")), BACK, 0.25, 0.08, False, 10.0),
    Walled(frozenset(SOFAS), FRONT, FEET, 0.03, False, 5.0),
    Walled(frozenset(("armchair",)), FRONT, 0.45, 0.3, False, 5.0),
    Walled(frozenset(("wardrobe",)), FRONT, 0.45, 0.15, False, 8.0),
    Walled(frozenset(("chest_of_drawers", "sideboard")), FRONT, 0.45, 0.15, False, 5.0),
    Walled(frozenset(("chest_of_drawers", "sideboard", "bookcase")), FRONT, 0.3, 0.6, True, 4.0),
)
"""The rows; a stool is pushed under its table and comes out farther than a chair."""
ASIDE = frozenset(("potted_tree", "floor_lamp"))
"""What stands beside the ways from door to door, not on them."""
ON_WAY, IN_THE_WAY = 0.3, 5.0
"""Which share of them may be on a way, and what it costs if more is."""


def list_walled(piece: Piece, ground: Ground) -> Iterator[float]:
    """For each row of a piece that is broken its cost, half for being so and half by the share of
    its floor that is missing; and that it stands in the way."""
    for row in WALLED:
        if piece.category in row.of:
            share = _measure_missing(piece, row, ground)
            if share > row.share:
                yield row.cost * (1.0 + min(share, 1.0)) / 2
    if piece.category in ASIDE and _measure_on_ways(piece, ground) > ON_WAY:
        yield IN_THE_WAY


def _measure_on_ways(piece: Piece, ground: Ground) -> float:
    """The share of a piece that stands on the ways from door to door."""
    (x, y, _, heading), (width, depth, _) = piece.pose, piece.size
    frame = make_frame(x, y, heading, width, depth)
    return float(area_in_polygon(frame, ground.paths)) / (width * depth)


def _measure_missing(piece: Piece, row: Walled, ground: Ground) -> float:
    """The share of a row's floor that is beyond walls or in the swing of doors."""
    (x, y, _, heading), size = piece.pose, piece.size
    floor = beyond(make_frame(x, y, heading, size.width, size.depth), row.side, row.metres)
    whole = 4 * floor[4] * floor[5]
    missing = whole - float(area_in_polygon(floor, ground.edges))
    if row.doors:
        swings = (make_frame(*box) for box in ground.keep_free.tolist())
        missing += sum(float(common_area(swing, floor)) for swing in swings)
    return missing / whole
