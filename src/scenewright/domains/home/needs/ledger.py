"""The ledger of a household: what its home owes, what it has, where, and why not the rest."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence

import shapely

from scenewright.catalog.classes import BEDS
from scenewright.core.brief import Room
from scenewright.core.explanation import LedgerRow
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Solution
from scenewright.core.space import Space
from scenewright.domains.home.needs.household import count_residents, is_dwelling
from scenewright.domains.home.needs.table import NEEDS, Need, Residence

NEARLY = 0.05
"""By how much less, in its unit, a need is still met."""
Rooms = Mapping[str, Sequence[Piece]]


def make_ledger(solution: Solution, plan: Plan) -> tuple[LedgerRow, ...]:
    """The rows of a home's needs; none of rooms that make no dwelling.

    >>> from scenewright.formats import read_planned
    >>> from scenewright.domains import solve
    >>> brief, plan = read_planned("sample:home-studio")
    >>> rows = make_ledger(solve(brief, plan=plan, steps=200), plan)
    >>> [(row.need, row.owed) for row in rows][:2]
    [('beds', 2.0), ('places to eat', 2.0)]
    """
    if not is_dwelling(plan.spaces):
        return ()
    rooms = defaultdict[str, list[Piece]](list)
    for piece in solution.pieces:
        rooms[piece.space].append(piece)
    home = describe_residence(plan.spaces, count_people(solution, plan.spaces, rooms))
    rows = (_make_row(need, home, plan, rooms, solution.left_out) for need in NEEDS)
    return tuple(row for row in rows if row.owed > 0.0)


def count_people(solution: Solution, spaces: Sequence[Space], rooms: Rooms) -> int:
    """How many live in a home: as stated, else those for whom it has bedrooms, of rooms whose beds
    were asked for those who sleep in them."""
    brief = solution.brief
    if brief.residents is not None:
        return brief.residents
    pairs = zip(brief.rooms, spaces, strict=True)
    asked = {space.id for room, space in pairs if room.ask is not None or _has_beds(room)}
    beds = NEEDS[0]
    slept = sum(int(beds.serve(rooms.get(space, ()))) for space in asked)
    return max(count_residents([s for s in spaces if s.id not in asked]) + slept, 1)


def _has_beds(room: Room) -> bool:
    return any(item.category in BEDS for item in room.fixed)


def describe_residence(spaces: Sequence[Space], people: int) -> Residence:
    """A home as its needs see it."""
    lived = [space for space in spaces if "balcony" not in space.functions]
    area = sum(shapely.Polygon(space.outline, list(space.holes)).area for space in lived)
    uses = frozenset[str]().union(*(space.functions for space in spaces))
    return Residence(people, float(area), uses)


def _make_row(
    need: Need, home: Residence, plan: Plan, rooms: Rooms, left_out: Sequence[LeftOut]
) -> LedgerRow:
    """One need of a home: in which rooms it stands, else which owe it."""
    amounts = {space.id: need.serve(rooms.get(space.id, ())) for space in plan.spaces}
    held = {space: amount for space, amount in amounts.items() if amount > 0.0}
    owed, stands = need.owed(home), sum(held.values())
    owing = _list_owing(need, plan.spaces)
    names = dict.fromkeys(plan.names[space] for space in (held or owing))
    why = "" if stands >= owed - NEARLY else _say_why(need, owing, plan.names, left_out)
    return LedgerRow(need.name, need.unit, owed, round(stands, 2), ", ".join(names), why)


def _list_owing(need: Need, spaces: Sequence[Space]) -> list[str]:
    """The rooms that owe a need: those of the first row of its rooms that the home has."""
    for functions in need.rooms:
        if found := [space.id for space in spaces if functions.intersection(space.functions)]:
            return found
    return []


def _say_why(
    need: Need, owing: Sequence[str], names: Mapping[str, str], left_out: Sequence[LeftOut]
) -> str:
    """What was reported of a need's groups, room by room; else that none holds more."""
    reasons = dict.fromkeys(
        f"{names.get(out.space, out.space)}: {out.reason}"
        for out in left_out
        if out.what in need.groups
    )
    if reasons:
        return "; ".join(reasons)
    return "what fits there holds no more" if owing else "no room of the home is for it"
