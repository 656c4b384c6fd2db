"""Chairs asked for beside desks and tables stand at them: both are laid out as one.

At a desk one chair stands before its front. Where there is something to look at (a stage, a screen)
desks stand in rows before it, turned so that people at them look ahead.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import cycle, pairwise, zip_longest

import numpy as np

from scenewright.catalog.kinds.usual import DESKS, is_high
from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.kind import TableChairs
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.classes import SHOWS
from scenewright.domains.hall.demands.holdings import SEATWAY, HallDemand, with_floor
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.seats.audience import MEALS
from scenewright.domains.hall.seats.chairs import company_of, count_places, places_at, seats_around
from scenewright.geometry.boxes import common_area, make_frame

TUCK, TOUCH = 0.2, 1e-4
"""How far a chair is pushed under its desk, in metres, and square metres two pieces may share."""
REASON = "no desk or table is left for them to stand at"


def join_chairs(wishes: list[HallDemand], catalog: Catalog) -> list[HallDemand]:
    """Demands whose chairs have joined the desks and tables they stand at; chairs beyond the places
    there stay demands by themselves. Where tables of several demands will do, each gets its share
    by the places it has."""
    joined = {wish.id: wish for wish in wishes}
    for chairs in (wish for wish in wishes if wish.at in joined):
        tables = [joined[name] for name in _tables_for(chairs, joined)]
        free = [_count_free(table, catalog) for table in tables]
        for table, count in zip(tables, _share_chairs(len(chairs.sizes), free), strict=True):
            left = joined[chairs.id].sizes
            if count:
                seated = chairs._replace(sizes=left[:count])
                joined[table.id] = _with_company(table, seated, wishes, catalog)
                joined[chairs.id] = chairs._replace(sizes=left[count:], at="")
    return [wish for wish in joined.values() if wish.sizes]


def _tables_for(chairs: HallDemand, joined: Mapping[str, HallDemand]) -> list[str]:
    """The ids of the demands at whose tables chairs stand: that they name, and where it is of
    tables to eat or read at all others of these in the same zones."""
    named = joined[chairs.at]
    meals = (w for w in joined.values() if w.category in MEALS and w.zones == named.zones)
    others = (w for w in meals if not is_high(w.category, max(s.height for s in w.sizes)))
    alike = [w.id for w in others if w.id != named.id and named.category in MEALS]
    return [named.id, *alike]


def _count_free(table: HallDemand, catalog: Catalog) -> int:
    """Places at the tables of a demand that no chair has taken."""
    places = sum(_count_places(table.category, size, catalog) for size in table.sizes)
    return max(places - sum(len(others.sizes) for others in table.seated), 0)


def _share_chairs(count: int, free: list[int]) -> list[int]:
    """How many of ``count`` chairs go to each of some tables with ``free`` places.

    >>> _share_chairs(24, [16, 20]), _share_chairs(9, [4, 4])
    ([10, 14], [4, 4])
    """
    whole = sum(free)
    count = min(count, whole)
    upto = [count * sum(free[:k]) // max(whole, 1) for k in range(len(free) + 1)]
    upto[-1] = count
    return [after - before for before, after in pairwise(upto)]


def _count_places(category: str, size: Size, catalog: Catalog) -> int:
    """Chairs that have room at one table, or at one desk."""
    company = company_of(category, catalog)
    if category in DESKS or company is None:
        return 1
    return count_places(size.width, company)


def _with_company(
    table: HallDemand, chairs: HallDemand, wishes: list[HallDemand], catalog: Catalog
) -> HallDemand:
    """Tables on the floor they take with the first chairs that join them; desks look at what is
    shown in their zone."""
    deep, seated = max(size.depth for size in chairs.sizes), (*table.seated, chairs)
    if table.seated:
        return table._replace(seated=seated)
    company = company_of(table.category, catalog)
    if table.category not in DESKS and company is not None:
        around = seats_around(table.category, catalog)
        return with_floor(table, deep - company.tuck, around)._replace(seated=seated)
    shown = table.facing or find_show(table, wishes)
    return with_chair(table, deep, shown)._replace(seated=seated)


def with_chair(table: HallDemand, deep: float, shown: str) -> HallDemand:
    """Desks on the floor they take with a chair ``deep`` metres deep before each, turned so that
    people there look at what is ``shown``, if anything is."""
    front, left, back, right = table.clearance
    before = deep - TUCK
    front = max(front - before, SEATWAY)
    sizes = tuple(size._replace(depth=size.depth + before) for size in table.sizes)
    if shown:
        front, back = back, front
    return table._replace(
        sizes=sizes,
        clearance=(front, left, back, right),
        facing=shown,
        before=before,
        turned=bool(shown),
    )


def find_show(table: HallDemand, wishes: list[HallDemand]) -> str:
    """The id of what is shown in the zone of some desks; empty without."""
    shown = [wish for wish in wishes if wish.category in SHOWS and wish.zones == table.zones]
    shown.sort(key=lambda wish: SHOWS.index(wish.category))
    return shown[0].id if shown else ""


def bare_tables(each: Iterable[HallDemand], boxes: Floats) -> Floats:
    """The boxes (n, 5) of tables, desks and all else without the floor of their chairs or staff,
    from those of the demands of ``each`` with it."""
    rows = [
        (2.0 * w.aside, 2.0 * w.chairs + w.before + w.staff, w.before, w.staff, float(w.turned))
        for w in each
    ]
    wide, deep, before, staff, turned = np.array(rows).reshape(-1, 5).T
    ahead, bare = (turned - 0.5) * before + 0.5 * staff, boxes.copy()
    bare[:, 0] += ahead * np.cos(boxes[:, 2])
    bare[:, 1] += ahead * np.sin(boxes[:, 2])
    bare[:, 2] += np.pi * turned
    bare[:, 3:] -= np.column_stack([wide, deep])
    return bare


def grow_desk(desk: Piece, before: float) -> Piece:
    """A desk as large as the floor it takes with a chair ``before`` its front."""
    pose, size = desk.pose, desk.size
    x = pose.x + 0.5 * before * math.cos(pose.heading)
    y = pose.y + 0.5 * before * math.sin(pose.heading)
    grown = size._replace(depth=size.depth + before)
    return replace(desk, pose=pose._replace(x=x, y=y), size=grown)


def seat_chairs(
    hall: HallContext,
    wishes: list[HallDemand],
    pieces: tuple[Piece, ...],
    others: tuple[Piece, ...],
    catalog: Catalog,
) -> tuple[tuple[Piece, ...], tuple[LeftOut, ...]]:
    """The chairs that have joined tables among ``pieces``, shared evenly by them, and those for
    which none of these is left: where tables are lacking the others take their chairs too."""
    found, taken = list[Piece](), Counter[str]()
    asked = _count_seated(wishes)
    spare: list[tuple[HallDemand, list[tuple[Piece, int, Pose]]]] = []
    for table in wishes:
        tables = [piece for piece in pieces if piece.function == table.id]
        places = _places(tables, table, (*pieces, *others), catalog)
        for chairs in table.seated:
            mine, places = places[: len(chairs.sizes)], places[len(chairs.sizes) :]
            found += _chairs_at(chairs, mine, catalog)
            taken[chairs.id] += len(mine)
        spare.append((table, places))
    for table, places in spare:
        for chairs in table.seated:
            lacking = asked[chairs.id] - taken[chairs.id]
            more, places = places[:lacking], places[lacking:]
            found += _chairs_at(chairs, more, catalog)
            taken[chairs.id] += len(more)
    kinds = {chairs.id: chairs for table in wishes for chairs in table.seated}
    short = asked - taken
    return tuple(found), tuple(_report(hall, kinds[k], n, asked[k]) for k, n in short.items())


def _count_seated(wishes: list[HallDemand]) -> Counter[str]:
    """How many chairs of each demand have joined tables."""
    counted = Counter[str]()
    for chairs in (chairs for table in wishes for chairs in table.seated):
        counted[chairs.id] += len(chairs.sizes)
    return counted


def _chairs_at(
    chairs: HallDemand, places: list[tuple[Piece, int, Pose]], catalog: Catalog
) -> list[Piece]:
    """Chairs of a demand at some places."""
    sizes = cycle(chairs.sizes)
    pairs = zip(sizes, places, strict=False)
    return [_chair(chairs, Size(*size), *place, catalog) for size, place in pairs]


def _report(hall: HallContext, chairs: HallDemand, lacking: int, count: int) -> LeftOut:
    """That some of the chairs of a demand find no table."""
    return LeftOut(hall.space.id, f"{lacking} of {count} {chairs.name}", REASON, chairs.required)


def _places(
    tables: list[Piece], wish: HallDemand, solid: tuple[Piece, ...], catalog: Catalog
) -> list[tuple[Piece, int, Pose]]:
    """Places at tables where a chair would stand in nothing, the first of each table first."""
    if not wish.seated:
        return []
    size = max((size for chairs in wish.seated for size in chairs.sizes), key=lambda s: s.depth)
    company = company_of(wish.category, catalog)
    if wish.category in DESKS or company is None:
        company = TableChairs("", math.inf, TUCK)
    rows = []
    for table in tables:
        mine = list(enumerate(places_at(table, company, size.depth), 1))
        mine = mine[:1] if math.isinf(company.pitch) else mine[::2] + mine[1::2]
        rows.append([(table, n, pose) for n, pose in mine if _is_free(pose, size, table, solid)])
    return [place for turn in zip_longest(*rows) for place in turn if place is not None]


def _is_free(pose: Pose, size: Size, table: Piece, solid: tuple[Piece, ...]) -> bool:
    """Whether a chair stands in nothing but under its own table."""
    frame = make_frame(pose.x, pose.y, pose.heading, size.width, size.depth)
    return all(
        common_area(frame, make_frame(*p.pose[:2], p.pose.heading, *p.size[:2])) <= TOUCH
        for p in solid
        if p.id != table.id
    )


def _chair(
    wish: HallDemand, size: Size, table: Piece, number: int, pose: Pose, catalog: Catalog
) -> Piece:
    """One chair at a table, in the group of that."""
    asset = catalog.choose(wish.category, size)
    return Piece(
        id=f"{table.id}/{wish.category}_{number}",
        category=wish.category,
        asset=asset.id if asset else "",
        space=table.space,
        pose=pose,
        size=size,
        group=table.group,
        function=wish.id,
        footprint=footprint_of(asset, size),
    )
