"""What a finished room lacks, counted from the pieces that stand: whoever took it away.

The search tells what it gave up as it goes, but a piece may go in many places: while a group is
dressed, where ways are opened, for a smaller group of the same use. So at the end the finished room
is counted: what its functions cannot do without and what was asked for is reported as left out,
with the reason if one is known.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from functools import cache

import shapely

from scenewright.building.ceiling import SHOULDERS, below, planes
from scenewright.building.room_needs import ESSENTIALS, USABLE, Essential
from scenewright.catalog.kinds import KINDS
from scenewright.core.brief import Room
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import RoomAnswer, RoomTask
from scenewright.domains.home.furnishing.whole import TOGETHER
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.needs.household import BED_PLACES
from scenewright.domains.home.wished.wishes import list_barred_groups


def complete_account(
    listed: Sequence[LeftOut],
    room: Room,
    task: RoomTask,
    answer: RoomAnswer,
    pieces: Sequence[Piece],
) -> list[LeftOut]:
    """What a room lacks: as ``listed`` by the search, with what is essential marked as such, and
    what is not listed; ``pieces`` are all that stand."""
    found = [*listed, *_smaller(listed, room, task, answer)]
    for need in list_lacking(task.space, pieces, task.catalog) if room.ask is None else ():
        serving = groups_serving(kinds_serving(need.name))
        if task.elsewhere.intersection(serving):
            continue  # in an open space another room holds it
        known = [k for k, out in enumerate(found) if out.what in serving]
        if known and not any(found[k].required for k in known):
            found[known[0]] = found[known[0]]._replace(required=True)
        elif not known and not list_barred_groups(room, task.library).issuperset(serving):
            found.append(_leave_out(need, serving, task, answer))
    return found


def list_short_beds(
    residents: int | None, spaces: Sequence[Space], pieces: Iterable[Piece]
) -> list[LeftOut]:
    """The beds that the stated residents lack, one by one, of the first bedroom."""
    held = sum(BED_PLACES.get(piece.category, 0) for piece in pieces)
    if residents is None or held >= residents:
        return []
    room = next((s for s in spaces if "bedroom" in s.functions), spaces[0])
    reason = f"beds for {held or 'none'} of {residents} residents: no bedroom has room for more"
    return [LeftOut(room.id, "single", reason, True)] * (residents - held)


def list_lacking(space: Space, pieces: Iterable[Piece], catalog: Catalog) -> list[Essential]:
    """The needs of a room's functions that its ``pieces`` do not meet, of the functions it is
    large enough for."""
    serving = Counter(
        name
        for piece in pieces
        if piece.category in catalog.kinds
        for name in catalog.kinds[piece.category].essential
    )
    needs = [n for function in _list_usable_functions(space) for n in ESSENTIALS[function]]
    return [need for need in needs if serving[need.name] < need.least]


def _list_usable_functions(space: Space) -> list[str]:
    """The functions of a room for which its floor below a ceiling one can stand under, stooping, is
    wide enough and, after those before it, large enough."""
    floor = shapely.Polygon(space.outline, list(space.holes))
    floor = floor.difference(below(floor, planes(space), space.height, SHOULDERS))
    if floor.is_empty:
        return []
    area, found = floor.area, []
    width = 2 * shapely.maximum_inscribed_circle(floor, tolerance=0.005).length
    for function in space.functions:
        least = USABLE.get(function)
        if least is not None and area >= least.area and width >= least.width:
            found.append(function)
            area -= least.area
    return found


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


def _leave_out(
    need: Essential, serving: tuple[str, ...], task: RoomTask, answer: RoomAnswer
) -> LeftOut:
    """A need that nothing reported: with its reason if a piece that serves it gave way."""
    placed = [p.wish.group for p in answer.placed if p.wish.group in serving]
    why = next(
        (gone.reason for gone in answer.gone if gone.category in kinds_serving(need.name)),
        "what fits here comes without it" if placed else "no place was found for it",
    )
    area = f"({task.ground.area:.1f} m² of floor)"
    what = (placed or [g for g in serving if g in GROUPS])[0]
    return LeftOut(task.space.id, what, f"{need.name}: {why} {area}", True)


def _smaller(
    listed: Iterable[LeftOut], room: Room, task: RoomTask, answer: RoomAnswer
) -> list[LeftOut]:
    """What was asked for and has only something else of its use in its place."""
    standing = Counter(p.wish.group for p in answer.placed)
    standing.update({p.group: p.function for p in task.fixed}.values())
    standing.update(out.what for out in listed)
    found = []
    for ask in room.ask or ():
        short = ask.count - standing[ask.group]
        standing[ask.group] -= ask.count
        reason = "only something smaller of its use fits"
        found += [LeftOut(task.space.id, ask.group, reason, ask.required)] * max(short, 0)
    return found
