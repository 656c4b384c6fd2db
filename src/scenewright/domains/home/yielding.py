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

from scenewright.catalog import Catalog
from scenewright.check.bodies import Rooms, bodies_of, rooms_of
from scenewright.check.reach import find_unreachable
from scenewright.check.report import Finding
from scenewright.check.routes import Ground, grounds_of, walk_in
from scenewright.domains.home.attempt import Furnished, Missing, Placed, penalty
from scenewright.domains.home.groups import GROUPS
from scenewright.scene import Piece
from scenewright.space import Space

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


def yielded(
    standing: Sequence[tuple[Piece, ...]], answers: Sequence[Furnished],
    rooms: tuple[Space, ...], catalog: Catalog, width: float,
) -> list[Furnished]:  # fmt: skip
    """The answers for all rooms of a home without what bars a way or cannot be walked to;
    ``standing`` is what is to stay in each room."""
    found, where = list(answers), rooms_of(rooms)
    grounds = grounds_of(where, width)
    for _ in range(ROUNDS):
        placed = [(*here, *_pieces(a)) for here, a in zip(standing, found, strict=True)]
        pieces = tuple(p for here in placed for p in here)
        findings = _unreached(pieces, where, grounds, catalog, width)
        losses = {loss for finding in findings if (loss := _least(finding, found)) is not None}
        if not losses:
            break
        for loss in _apart(losses):
            found[loss.room] = _without(found[loss.room], loss, findings)
    return found


def _unreached(
    pieces: tuple[Piece, ...], where: Rooms, grounds: list[Ground], catalog: Catalog, width: float
) -> list[Finding]:
    """What no route leads to, by the referee, but for what the brief came with."""
    bodies, _ = bodies_of(pieces, where, catalog)
    walks = [walk_in(bodies, ground, width / 2) for ground in grounds]
    return [found for found in find_unreachable(bodies, where, grounds, walks) if not found.given]


def _pieces(answer: Furnished) -> tuple[Piece, ...]:
    return tuple(piece for item in answer.placed for piece in item.pieces)


def _least(finding: Finding, answers: Sequence[Furnished]) -> Loss | None:
    """The cheapest thing to take away: what cannot be reached itself, or what is in the way."""
    losses = []
    for piece in filter(None, (finding.piece, *finding.other.split(","))):
        loss = _loss(piece, answers)
        if loss is not None:
            more = 0.0 if piece == finding.piece else KEPT
            losses.append(loss._replace(cost=loss.cost + more))
    return min(losses, key=lambda loss: loss.cost, default=None)


def _loss(piece: str, answers: Sequence[Furnished]) -> Loss | None:
    """Taking a piece away, with its group if that cannot do without; none for what was fixed."""
    for room, answer in enumerate(answers):
        for number, item in enumerate(answer.placed):
            for here in item.pieces:
                if here.id == piece:
                    spare = here.category not in GROUPS[item.wish.group].essential
                    cost = MEMBER if spare else penalty(item.wish)
                    return Loss(room, number, piece if spare else "", cost)
    return None


def _apart(losses: set[Loss]) -> list[Loss]:
    """One loss for every room: what one opens the next need not."""
    order = sorted(losses, key=lambda loss: (loss.cost, loss.room, loss.group, loss.piece))
    return list({loss.room: loss for loss in reversed(order)}.values())


def _without(answer: Furnished, loss: Loss, findings: Sequence[Finding]) -> Furnished:
    """An answer less one piece and what stands on it, or less a whole group."""
    item = answer.placed[loss.group]
    left = _remaining(item, loss.piece) if loss.piece else ()
    if left:
        placed = tuple(item._replace(pieces=left) if p is item else p for p in answer.placed)
        return answer._replace(placed=placed)
    ids = {piece.id for piece in item.pieces}
    told = "no walking route of the stated width would reach it"
    for finding in findings:
        if finding.piece not in ids and ids & set(finding.other.split(",")):
            what = finding.piece.rpartition("/")[2].replace("_", " ") or f"room {finding.space}"
            told = f"it would bar the walking route to the {what}"
    placed = tuple(p for p in answer.placed if p is not item)
    return answer._replace(placed=placed, missing=(*answer.missing, Missing(item.wish, told)))


def _remaining(item: Placed, gone: str) -> tuple[Piece, ...]:
    """The pieces of a group less one and all that stands on it."""
    away = {gone}
    for piece in item.pieces:
        if piece.on in away:
            away.add(piece.id)
    return tuple(piece for piece in item.pieces if piece.id not in away)
