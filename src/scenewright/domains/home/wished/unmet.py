"""Which wishes for places came true, and which outlets are within reach, while rooms are dressed.

Told by the referee's own measures, as nothing else says what a wish means.
"""

from __future__ import annotations

from scenewright.check.bodies import bodies_of, rooms_of
from scenewright.check.outlets import connections_of
from scenewright.core.brief import Room
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.check.wishes import wishes_told


def count_unmet_wishes(
    room: Room | None, space: Space, pieces: tuple[Piece, ...], catalog: Catalog
) -> int:
    """How many of a room's wishes for things, and of the outlets needed, ``pieces`` do not meet.

    What the brief puts out of reach itself is not counted: nothing will mend it.
    """
    if room is None or not (space.outlets or any(not wish.forbid for wish in room.wishes)):
        return 0
    where = rooms_of((space,))
    bodies, _ = bodies_of(pieces, where, catalog)
    told = zip(room.wishes, wishes_told(bodies, where, [room]), strict=True)
    return sum(not wish.forbid and not answer["fulfilled"] for wish, answer in told) + sum(
        not each.reached and not bodies.pieces[each.piece].fixed
        for each in connections_of(bodies, where)
    )
