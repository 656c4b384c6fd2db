"""What a finished room lacks, counted from the pieces that stand: whoever took it away.

The search tells what it gave up as it goes, but a piece may go in many places: while a group is
dressed, where ways are opened, for a smaller group of the same use. So at the end the finished room
is counted: what its functions cannot do without (by the referee's table) and what was asked for is
told as left out, with the reason if one is known.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from functools import cache

from scenewright.catalog.kinds import KINDS
from scenewright.check.bodies import bodies_of, rooms_of
from scenewright.core.brief import Room
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut
from scenewright.domains.home.attempt import RoomAnswer, RoomTask
from scenewright.domains.home.check.complete import ESSENTIALS, Essential, find_incomplete
from scenewright.domains.home.furnishing.whole import TOGETHER
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.wished.wishes import list_barred_groups


def complete_account(
    told: Sequence[LeftOut], room: Room, task: RoomTask, answer: RoomAnswer, pieces: Sequence[Piece]
) -> list[LeftOut]:
    """What a room lacks: as ``told`` by the search, with what is essential marked as such, and with
    what nobody told of; ``pieces`` are all that stand."""
    if not task.preset.exact:
        return [*told, *_smaller(told, room, task, answer)]
    found = [*told, *_smaller(told, room, task, answer)]
    for need in _lacking(room, task, tuple(pieces), task.catalog):
        serving = groups_serving(kinds_serving(need.name))
        if task.elsewhere.intersection(serving):
            continue  # in an open space another room holds it
        known = [k for k, out in enumerate(found) if out.what in serving]
        if known and not any(found[k].required for k in known):
            found[known[0]] = found[known[0]]._replace(required=True)
        elif not known and not list_barred_groups(room, task.library).issuperset(serving):
            found.append(_unmentioned(need, serving, task, answer))
    return found


def _lacking(
    room: Room, task: RoomTask, pieces: tuple[Piece, ...], catalog: Catalog
) -> list[Essential]:
    """The needs of a room's functions that its pieces do not meet; none where the user said what
    the room is to hold."""
    if room.ask is not None:
        return []
    rooms = rooms_of((task.space,))
    notes = find_incomplete(bodies_of(pieces, rooms, catalog)[0], rooms)
    return [
        need for note in notes for need in ESSENTIALS[note.function] if need.name == note.missing
    ]


@cache
def kinds_serving(need: str) -> frozenset[str]:
    """The categories whose rows say that they serve as something essential.

    >>> "sofa" in kinds_serving("seat")
    True
    """
    return frozenset(name for name, kind in KINDS.items() if need in kind.essential)


@cache
def groups_serving(categories: frozenset[str]) -> tuple[str, ...]:
    """The groups that bring one of some categories as what they are for.

    >>> groups_serving(frozenset(("hob_cabinet",)))
    ('kitchen', 'kitchenette')
    """
    found = []
    for name, kind in GROUPS.items():
        needs = [names for names, _ in TOGETHER.get(name, ())]
        if categories & frozenset(kind.essential).union(*needs):
            found.append(name)
    return tuple(found) or tuple(
        name
        for name, kind in GROUPS.items()
        if any(m.category in categories for case in kind.cases() for m in case.members)
    )


def _unmentioned(
    need: Essential, serving: tuple[str, ...], task: RoomTask, answer: RoomAnswer
) -> LeftOut:
    """A need that nothing told of: with its reason if a piece that serves it gave way."""
    placed = [p.wish.group for p in answer.placed if p.wish.group in serving]
    why = next(
        (gone.reason for gone in answer.gone if gone.category in kinds_serving(need.name)),
        "what fits here comes without it" if placed else "no place was found for it",
    )
    area = f"({task.ground.area:.1f} m² of floor)"
    what = (placed or [g for g in serving if g in GROUPS])[0]
    return LeftOut(task.space.id, what, f"{need.name}: {why} {area}", True)


def _smaller(
    told: Iterable[LeftOut], room: Room, task: RoomTask, answer: RoomAnswer
) -> list[LeftOut]:
    """What was asked for and has only something else of its use in its place."""
    standing = Counter(p.wish.group for p in answer.placed)
    standing.update({p.group: p.function for p in task.fixed}.values())
    standing.update(out.what for out in told)
    found = []
    for ask in room.ask or ():
        short = ask.count - standing[ask.group]
        standing[ask.group] -= ask.count
        reason = "only something smaller of its use fits"
        found += [LeftOut(task.space.id, ask.group, reason, ask.required)] * max(short, 0)
    return found
