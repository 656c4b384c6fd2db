"""What nobody could walk to is not furnished: the last look at a whole home, room by room.

Rooms are furnished one by one on a grid that says where a person can walk. A home is only right if
the exact routes of the referee, from the front door through every room, lead everywhere. So when
all rooms are done the referee's routes are walked once; what bars one, or what none leads to,
gives way, the least important first, and is told as left out. No other rule is looked at here: a
fault of the search in anything else stays to be seen.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from scenewright.check.bodies import Rooms, bodies_of, rooms_of
from scenewright.check.reach import find_unreachable
from scenewright.check.routes import JoinedFloor, grounds_of, walk_in
from scenewright.core.catalog import Catalog
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.attempt import FurnishedGroup, Missing, RoomAnswer, penalty
from scenewright.domains.home.furnishing.whole import Gone, is_whole, without

ROUNDS = 24
MEMBER = 4.0  # what it costs to lose one piece of a group that can do without, as in attempt
KEPT = 200.0  # what it costs more to take what is in the way than what cannot be reached


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
    catalog: Catalog,
    width: float,
) -> list[RoomAnswer]:
    """The answers for all rooms of a home without what bars a way or cannot be walked to;
    ``standing`` is what is to stay in each room."""
    found, where = list(answers), rooms_of(rooms)
    grounds = grounds_of(where, width)
    for _ in range(ROUNDS):
        placed = [(*here, *_pieces(a)) for here, a in zip(standing, found, strict=True)]
        pieces = tuple(p for here in placed for p in here)
        findings = _find_unreached(pieces, where, grounds, catalog, width)
        losses = {loss for finding in findings if (loss := _least(finding, found)) is not None}
        if not losses:
            break
        for loss in _apart(losses):
            found[loss.room] = _without(found[loss.room], loss, findings)
    return found


def _find_unreached(
    pieces: tuple[Piece, ...],
    where: Rooms,
    grounds: list[JoinedFloor],
    catalog: Catalog,
    width: float,
) -> list[Finding]:
    """What no route leads to, by the referee, but for what the brief came with."""
    bodies, _ = bodies_of(pieces, where, catalog)
    walks = [walk_in(bodies, ground, width / 2) for ground in grounds]
    return [found for found in find_unreachable(bodies, where, grounds, walks) if not found.given]


def _pieces(answer: RoomAnswer) -> tuple[Piece, ...]:
    return tuple(piece for item in answer.placed for piece in item.pieces)


def _least(finding: Finding, answers: Sequence[RoomAnswer]) -> Loss | None:
    """The cheapest thing to take away: what cannot be reached itself, or what is in the way."""
    losses = []
    for piece in filter(None, (finding.piece, *finding.other.split(","))):
        loss = _loss(piece, answers)
        if loss is not None:
            more = 0.0 if piece == finding.piece else KEPT
            losses.append(loss._replace(cost=loss.cost + more))
    return min(losses, key=lambda loss: loss.cost, default=None)


def _loss(piece: str, answers: Sequence[RoomAnswer]) -> Loss | None:
    """Taking a piece away, with its group if that cannot do without; none for what was fixed."""
    for room, answer in enumerate(answers):
        for number, item in enumerate(answer.placed):
            for here in item.pieces:
                if here.id == piece:
                    spare = _is_spare(item, piece)
                    cost = MEMBER if spare else penalty(item.wish)
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


def _without(answer: RoomAnswer, loss: Loss, findings: Sequence[Finding]) -> RoomAnswer:
    """An answer less one piece and what goes with it, or less a whole group."""
    item = answer.placed[loss.group]
    told = _reason(item, loss, findings)
    if loss.piece:
        placed = tuple(_less(p, loss.piece) if p is item else p for p in answer.placed)
        category = next(p.category for p in item.pieces if p.id == loss.piece)
        return answer._replace(placed=placed, gone=(*answer.gone, Gone(category, told)))
    placed = tuple(p for p in answer.placed if p is not item)
    return answer._replace(placed=placed, missing=(*answer.missing, Missing(item.wish, told)))


def _less(item: FurnishedGroup, piece: str) -> FurnishedGroup:
    return item._replace(pieces=without(item.pieces, piece))


def _reason(item: FurnishedGroup, loss: Loss, findings: Sequence[Finding]) -> str:
    """Why a piece, or a whole group, has to give way."""
    ids = {loss.piece} if loss.piece else {piece.id for piece in item.pieces}
    for finding in findings:
        if finding.piece not in ids and ids & set(finding.other.split(",")):
            what = finding.piece.rpartition("/")[2].replace("_", " ") or f"room {finding.space}"
            return f"it would bar the walking route to the {what}"
    return "no walking route of the stated width would reach it"
