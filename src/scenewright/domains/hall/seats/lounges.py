"""Lounges: a sofa asked for beside a low table stands at it, with the armchairs asked for there.

What makes up a lounge is laid out as one object, as a row of counters is, and furnished piece by
piece: the sofa at the back, the table before it, seats across from the sofa and at one end. The
other end stays open: one gets to all seats by it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from scenewright.core.scene import Pose, Size
from scenewright.domains.hall.classes import LOUNGE_CHAIRS
from scenewright.domains.hall.demands.holdings import HallDemand, LoungePart
from scenewright.domains.hall.seats.low_tables import CATEGORY as TABLE

SOFA = "sofa"
"""Kinds at the back of a lounge."""
LOUNGE_KNEES, LOUNGE_BESIDE, ROW = 0.45, 0.2, 3
"""Metres between a low table and the seats at it and between two chairs, and most chairs in a row
across from a sofa."""
LOUNGE_LITTLE = 0.03
"""Metres by which the way past a table to a sofa is wider than the route."""
CLEARANCE = (0.3, 0.6, 0.0, 0.6)
"""Metres free before a lounge, at its left, back and right: one comes in at an end."""
AROUND, COMPANY = ("around",), 2
"""The pattern of chairs without a sofa, and how many are a company."""


def join_lounges(wishes: list[HallDemand], route: float) -> list[HallDemand]:
    """Demands in which sofas, low tables and chairs of the same zones are lounges where the brief
    says no more of them; chairs without a sofa look at each other. A way ``route`` metres wide
    leads to every sofa."""
    left = {wish.id: wish for wish in wishes}
    for sofas in [wish for wish in wishes if wish.category == SOFA and _is_open(wish)]:
        joined = _join(sofas, left, route)
        if joined:
            left |= {wish.id: wish for wish in joined}
    return [_look_inwards(wish) for wish in left.values() if wish.sizes]


def _is_open(wish: HallDemand) -> bool:
    """Whether a brief leaves to us how sofas stand, or says no more than at a wall."""
    return wish.unstated or (wish.at_wall and not wish.facing and not wish.least)


def _look_inwards(wish: HallDemand) -> HallDemand:
    """Chairs in companies that look at each other."""
    seats = wish.category in LOUNGE_CHAIRS and wish.unstated and len(wish.sizes) >= COMPANY
    return wish._replace(patterns=AROUND) if seats else wish


def _join(sofas: HallDemand, left: dict[str, HallDemand], route: float) -> list[HallDemand]:
    """The sofas of a demand as lounges, and the demands of tables and chairs less those in them;
    nothing without tables enough."""
    near = [w for w in left.values() if w.zones == sofas.zones and w.unstated and w.sizes]
    tables = next((wish for wish in near if wish.category == TABLE), None)
    number = min(len(sofas.sizes), len(tables.sizes)) if tables else 0
    if not tables or len(sofas.sizes) > 2 * number:
        return []
    most = 2 if len(sofas.sizes) > number else ROW + 1
    asked = [w for w in near if w.category in LOUNGE_CHAIRS]
    seats = [(w, size) for w in asked for size in w.sizes][: most * number]
    lounges = tuple(
        _arrange(
            [LoungePart(sofas, size) for size in sofas.sizes[k::number]],
            LoungePart(tables, tables.sizes[k]),
            [LoungePart(*seat) for seat in seats[k::number]],
            route,
        )
        for k in range(number)
    )
    taken = [sum(w is seat for seat, _ in seats) for w in asked]
    rest = [w._replace(sizes=w.sizes[n:]) for w, n in zip(asked, taken, strict=True)]
    rest.append(tables._replace(sizes=tables.sizes[number:]))
    return [_as_one(sofas, tables, lounges), *rest]


def _as_one(
    sofas: HallDemand, tables: HallDemand, lounges: tuple[tuple[LoungePart, ...], ...]
) -> HallDemand:
    """A demand of sofas whose objects are each a whole lounge."""
    free = sofas.patterns if sofas.at_wall else ("single",)
    return lay_as_one(sofas, lounges)._replace(
        clearance=CLEARANCE,
        patterns=free if len(lounges) == 1 or sofas.at_wall else ("chain", "grid"),
        required=sofas.required or tables.required,
    )


def lay_as_one(wish: HallDemand, lounges: Sequence[tuple[LoungePart, ...]]) -> HallDemand:
    """A demand whose objects are each several pieces, its own first, until it is furnished."""
    own = {part.wish.id: part.wish for lounge in lounges for part in lounge}
    names = [other.name for other in own.values() if other.id != wish.id]
    return wish._replace(
        name=f"{wish.name} with {' and '.join(names)}" if names else wish.name,
        sizes=tuple(_measure(lounge) for lounge in lounges),
        lounges=tuple(_centre(lounge) for lounge in lounges),
    )


def _arrange(
    sofas: list[LoungePart], table: LoungePart, chairs: list[LoungePart], route: float
) -> tuple[LoungePart, ...]:
    """The pieces of a lounge about the middle of its table, the sofas first; these stand out at the
    open end, on the left, as far as one needs to come before them past the table."""
    across = 0 if len(sofas) > 1 else min(len(chairs), 2 if len(chairs) < ROW + 1 else ROW)
    past = 0.5 * (table.size.width + route) + LOUNGE_LITTLE
    sofas = [s._replace(along=min(0.5 * s.size.width - past, 0.0)) for s in sofas]
    row, end = [*sofas[1:], *chairs[:across]], chairs[across:]
    deep = 0.5 * table.size.depth + LOUNGE_KNEES
    back = sofas[0]._replace(ahead=-deep - 0.5 * sofas[0].size.depth)
    before = [
        part._replace(along=part.along + at, ahead=deep + 0.5 * part.size.depth, turn=math.pi)
        for part, at in _line_up(row)
    ]
    wide = 0.5 * table.size.width + LOUNGE_KNEES
    if len(end) > 1:
        wide = max(wide, *(s.along + 0.5 * s.size.width + LOUNGE_BESIDE for s in sofas))
    beside = [
        part._replace(along=wide + 0.5 * part.size.depth, ahead=at, turn=0.5 * math.pi)
        for part, at in _line_up(end)
    ]
    return (back, *before[: len(sofas) - 1], table, *before[len(sofas) - 1 :], *beside)


def _line_up(parts: list[LoungePart]) -> Iterator[tuple[LoungePart, float]]:
    """Seats side by side, and how far the middle of each is from that of their row."""
    at = -0.5 * (sum(part.size.width for part in parts) + LOUNGE_BESIDE * (len(parts) - 1))
    for part in parts:
        yield part, at + 0.5 * part.size.width
        at += part.size.width + LOUNGE_BESIDE


def _reach(parts: Iterable[LoungePart]) -> tuple[float, float, float, float]:
    """How far some pieces reach: along and ahead from, along and ahead to."""
    rows = list[tuple[float, float, float, float]]()
    for part in parts:
        wide, deep = part.size.width, part.size.depth
        if abs(math.cos(part.turn)) < 0.5:
            wide, deep = deep, wide
        low = part.along - 0.5 * wide, part.ahead - 0.5 * deep
        rows.append((*low, low[0] + wide, low[1] + deep))
    left, back, right, front = zip(*rows, strict=True)
    return min(left), min(back), max(right), max(front)


def _measure(lounge: tuple[LoungePart, ...]) -> Size:
    """The size of the box round a lounge."""
    left, back, right, front = _reach(lounge)
    return Size(right - left, front - back, max(part.size.height for part in lounge))


def _centre(lounge: tuple[LoungePart, ...]) -> tuple[LoungePart, ...]:
    """A lounge about the middle of its box."""
    left, back, right, front = _reach(lounge)
    along, ahead = 0.5 * (left + right), 0.5 * (back + front)
    return tuple(p._replace(along=p.along - along, ahead=p.ahead - ahead) for p in lounge)


def count_parts(wish: HallDemand, count: int) -> int:
    """How many pieces the first ``count`` objects of a demand are."""
    return sum(len(lounge) for lounge in wish.lounges[:count]) if wish.lounges else count


def list_lounge_forms(wish: HallDemand) -> Iterator[HallDemand]:
    """Lounges with the sofas' backs at a wall, where the brief leaves that open."""
    if wish.lounges and not wish.at_wall and not wish.aisle:
        yield wish._replace(patterns=("wall",))


def part_lounges(wishes: Iterable[HallDemand]) -> list[HallDemand]:
    """Demands with lounges taken apart again; rows stay broken."""
    found = dict[str, HallDemand]()
    for wish in wishes:
        lounges = () if wish.aisle else wish.lounges
        found |= {} if lounges else {wish.id: wish}
        for part in (part for lounge in lounges for part in lounge):
            there = found.get(part.wish.id, part.wish._replace(sizes=()))
            found[part.wish.id] = there._replace(sizes=(*there.sizes, part.size))
    return list(found.values())


def set_parts(lounge: tuple[LoungePart, ...], pose: Pose) -> Iterator[tuple[LoungePart, Pose]]:
    """The pieces of a lounge and where they stand where that stands at a pose."""
    c, s = math.cos(pose.heading), math.sin(pose.heading)
    for part in lounge:
        x, y = pose.x + part.along * s + part.ahead * c, pose.y - part.along * c + part.ahead * s
        heading = math.remainder(pose.heading + part.turn, 2.0 * math.pi)
        yield part, pose._replace(x=x, y=y, heading=heading)
