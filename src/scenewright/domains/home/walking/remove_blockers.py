"""What nobody could walk to is not furnished: the last look at a whole home, room by room.

Rooms are furnished one by one on a grid that says where a person can walk. A home is only right if
exact routes, from the front door through every room, lead everywhere. So when all rooms are done
these are walked once (:mod:`scenewright.domains.home.walking.barred`); what bars one, or what none
leads to, gives way, the least important first, and is reported as left out. No other rule is looked
at here: a fault of the search in anything else stays to be seen.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import FurnishedGroup, Missing, RoomAnswer, penalty
from scenewright.domains.home.furnishing.whole import Gone, is_whole, without
from scenewright.domains.home.settings import FaultCosts, HomeSettings
from scenewright.domains.home.walking.barred import Barred, find_barred
from scenewright.domains.home.walking.home_floor import HomeFloor

Opened = Callable[[Sequence[RoomAnswer]], list[RoomAnswer]]
"""The answers for all rooms of a home without what bars its ways."""


class Loss(NamedTuple):
    """What may be taken away to open a way: the room and group by number, the one piece of it
    (empty: the whole group), and what that costs."""

    room: int
    group: int
    piece: str
    cost: float


def remove_blockers(
    standing: Sequence[tuple[Piece, ...]],
    answers: Sequence[RoomAnswer],
    rooms: tuple[Space, ...],
    floors: Sequence[HomeFloor],
    catalog: Catalog,
    settings: HomeSettings,
) -> list[RoomAnswer]:
    """The answers for all rooms of a home without what bars a way on its ``floors`` or cannot be
    walked to; ``standing`` is what is to stay in each room, ``settings`` those of the preset."""
    found = list(answers)
    for _ in range(settings.retry.rounds):
        placed = [(*here, *_pieces(a)) for here, a in zip(standing, found, strict=True)]
        pieces = tuple(p for here in placed for p in here)
        barred = find_barred(pieces, rooms, floors, catalog)
        losses = {
            loss for each in barred if (loss := _least(each, found, settings.costs)) is not None
        }
        if not losses:
            break
        for loss in _apart(losses):
            found[loss.room] = _without(found[loss.room], loss, barred)
    return found


def _pieces(answer: RoomAnswer) -> tuple[Piece, ...]:
    return tuple(piece for item in answer.placed for piece in item.pieces)


def _least(barred: Barred, answers: Sequence[RoomAnswer], costs: FaultCosts) -> Loss | None:
    """The cheapest thing to take away: what cannot be reached itself, or what is in the way."""
    losses = []
    for piece in filter(None, (barred.piece, *barred.openers)):
        loss = _loss(piece, answers, costs)
        if loss is not None:
            more = 0.0 if piece == barred.piece else costs.in_the_way
            losses.append(loss._replace(cost=loss.cost + more))
    return min(losses, key=lambda loss: loss.cost, default=None)


def _loss(piece: str, answers: Sequence[RoomAnswer], costs: FaultCosts) -> Loss | None:
    """Taking a piece away, with its group if that cannot do without; none for what was fixed."""
    for room, answer in enumerate(answers):
        for number, item in enumerate(answer.placed):
            for here in item.pieces:
                if here.id == piece:
                    spare = _is_spare(item, piece)
                    cost = costs.piece if spare else penalty(item.wish, costs)
                    return Loss(room, number, piece if spare else "", cost)
    return None


def _is_spare(item: FurnishedGroup, piece: str) -> bool:
    """Whether a group is still of use without a piece and what goes with it."""
    left = [p.category for p in without(item.pieces, piece)]
    return is_whole(item.wish.group, [p.category for p in item.pieces], left)


def _apart(losses: set[Loss]) -> list[Loss]:
    """One loss for every room: what one opens the next need not."""
    order = sorted(losses, key=lambda loss: (loss.cost, loss.room, loss.group, loss.piece))
    return list({loss.room: loss for loss in reversed(order)}.values())


def _without(answer: RoomAnswer, loss: Loss, barred: Sequence[Barred]) -> RoomAnswer:
    """An answer less one piece and what goes with it, or less a whole group."""
    item = answer.placed[loss.group]
    reason = _reason(item, loss, barred)
    if loss.piece:
        placed = tuple(_less(p, loss.piece) if p is item else p for p in answer.placed)
        category = next(p.category for p in item.pieces if p.id == loss.piece)
        return answer._replace(placed=placed, gone=(*answer.gone, Gone(category, reason)))
    placed = tuple(p for p in answer.placed if p is not item)
    return answer._replace(placed=placed, missing=(*answer.missing, Missing(item.wish, reason)))


def _less(item: FurnishedGroup, piece: str) -> FurnishedGroup:
    return item._replace(pieces=without(item.pieces, piece))


def _reason(item: FurnishedGroup, loss: Loss, barred: Sequence[Barred]) -> str:
    """Why a piece, or a whole group, has to give way."""
    ids = {loss.piece} if loss.piece else {piece.id for piece in item.pieces}
    for each in barred:
        if each.piece not in ids and ids & set(each.openers):
            what = each.piece.rpartition("/")[2].replace("_", " ") or f"room {each.space}"
            return f"it would bar the walking route to the {what}"
    return "no walking route of the stated width would reach it"
