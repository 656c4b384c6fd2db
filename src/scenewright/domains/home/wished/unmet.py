"""Which wishes for places came true, and which outlets are within reach, while rooms are dressed.

The search's own measure, on boxes and segments; the referee measures the final pieces as polygons.
What a wish means (how near is near) is stated with the brief, in
:mod:`scenewright.core.brief.wishes`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.core.brief import Room
from scenewright.core.brief.wishes import NEAREST, OPENINGS, SIGHT, WishBrief
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.measures import FLATTEST, HAIR
from scenewright.domains.home.wished.gaps import (
    distance_between,
    distance_to_segments,
    sees_any,
    sides_of,
)
from scenewright.domains.home.wished.places import BACKWARD, spots_of
from scenewright.domains.home.wished.plugged import count_unplugged

Floats = NDArray[np.float64]


def count_unmet_wishes(
    room: Room | None, space: Space, pieces: tuple[Piece, ...], catalog: Catalog
) -> int:
    """How many of a room's wishes for things, and of the outlets needed, ``pieces`` do not meet.

    What the brief puts out of reach itself is not counted: nothing will mend it.
    """
    if room is None or not (space.outlets or any(not wish.forbid for wish in room.wishes)):
        return 0
    solid = [p for p in pieces if not _is_flat(p, catalog)]
    wanted = [wish for wish in room.wishes if not wish.forbid]
    unmet = sum(not is_met(wish, space, solid) for wish in wanted)
    return unmet + count_unplugged(pieces, space.outlets, catalog)


def is_met(wish: WishBrief, space: Space, pieces: Sequence[Piece]) -> bool:
    """Whether what is wished for stands in a room among its ``pieces``, and where it is to."""
    mine = _select_pieces(pieces, wish.what)
    boxes, others = boxes_of(mine), [p for p in pieces if p not in mine]
    return (
        bool(mine)
        and (not wish.by or distance_to_segments(boxes, _by(wish, space)) <= NEAREST[wish.by])
        and (not wish.face or _faces(wish, mine, space, others))
        and (not wish.near or _gap(boxes, wish.near, space, others) <= wish.within + HAIR)
        and (not wish.away_from or _keeps_away(wish, boxes, space, others))
    )


def _select_pieces(pieces: Sequence[Piece], name: str) -> list[Piece]:
    """The pieces of a group or kind."""
    return [p for p in pieces if name in (p.category, p.function)]


def boxes_of(pieces: Sequence[Piece]) -> Floats:
    """Pieces as boxes ``(n, 5)``."""
    rows = [(p.pose.x, p.pose.y, p.pose.heading, p.size.width, p.size.depth) for p in pieces]
    return np.array(rows, np.float64).reshape(-1, 5)


def _by(wish: WishBrief, space: Space) -> Floats:
    """The part of a room something is to stand by, as segments (k, 4)."""
    if wish.by == "corner":
        return np.hstack([space.outline, space.outline])
    return spots_of((str(wish.by),), space, ())


def _gap(boxes: Floats, name: str, space: Space, others: Sequence[Piece]) -> float:
    """The distance from boxes (n, 5) to what a name means; infinite if there is none."""
    if name in OPENINGS:
        return distance_to_segments(boxes, spots_of((name,), space, ()))
    return distance_between(boxes, boxes_of(_select_pieces(others, name)))


def _keeps_away(wish: WishBrief, boxes: Floats, space: Space, others: Sequence[Piece]) -> bool:
    """Nothing is too near to a piece that is not there; an opening that is not there is a slip."""
    gap = _gap(boxes, str(wish.away_from), space, others)
    missing = wish.away_from in OPENINGS and gap == np.inf
    return not missing and gap >= wish.beyond - HAIR


def _faces(wish: WishBrief, mine: Sequence[Piece], space: Space, others: Sequence[Piece]) -> bool:
    """Whether the largest of the pieces looks at what it is to face."""
    largest = max(mine, key=lambda p: p.size.width * p.size.depth)
    name = str(wish.face)
    if name in OPENINGS:
        there = spots_of((name,), space, ())
    else:
        there = sides_of(boxes_of(_select_pieces(others, name)))
    look = largest.pose.heading + (np.pi if largest.category in BACKWARD else 0.0)
    eye = np.array([largest.pose.x, largest.pose.y])
    return len(there) > 0 and sees_any(eye, look, SIGHT, there)


def _is_flat(piece: Piece, catalog: Catalog) -> bool:
    kind = catalog.kinds.get(piece.category)
    return kind is not None and kind.flat and piece.size.height <= FLATTEST
