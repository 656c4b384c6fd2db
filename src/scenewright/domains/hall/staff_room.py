"""Room for the staff of counters at walls: they stand behind them, before the wall.

Counters of one group that ask for nothing at their sides stand in one line: a row of them is one
object until it is furnished.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from scenewright.catalog.kinds import KINDS
from scenewright.core.brief.zones import Demand
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.assemble import Laid
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.chairs import grow_table
from scenewright.domains.hall.fit import Fitted, fit
from scenewright.domains.hall.holdings import HallDemand
from scenewright.domains.hall.seating import grow_desk
from scenewright.engine.solve import Cancel

COUNTER = "counter"
"""Of what several stand at a wall unless the brief says otherwise."""
NOTHING = 1e-6
"""What costs less costs nothing."""
Place = tuple[Pose, Size]


def fit_with_staff(
    hall: HallContext,
    wishes: list[HallDemand],
    weights: dict[str, float],
    catalog: Catalog,
    seed: int,
    cancel: Cancel | None = None,
) -> tuple[list[HallDemand], Fitted]:
    """Demands as they find room, and their first layout (:func:`.fit.fit`): counters at walls in
    rows with room for their staff, else each by itself, else with their backs at the wall. Where
    something lacks in any case, as lacks least; as they are where groups stay as printed."""
    whole, lined = hall.settings.whole, hall.settings.lined
    found: list[tuple[int, list[HallDemand], Fitted]] = []
    for asked in [wishes] if whole else _ways_to_stand(wishes, lined):
        fitted = fit(hall, asked, weights, catalog, seed, whole, cancel)
        count = sum(_count_objects(asked[u.demand], u.last - u.first) for u in fitted.units)
        unasked = any(a.at_wall and not b.at_wall for a, b in zip(asked, wishes, strict=True))
        if unasked and fitted.hosts:
            continue
        if count == sum(len(wish.sizes) for wish in wishes):
            return asked, fitted
        if not unasked:
            found.append((count, asked, fitted))
    return max(found, key=lambda one: one[0])[1:]


def _count_objects(wish: HallDemand, count: int) -> int:
    """How many objects so many of a demand are once they are furnished."""
    return count * max(len(wish.row), 1)


def _ways_to_stand(wishes: list[HallDemand], lined_up: bool) -> Iterator[list[HallDemand]]:
    """The demands with their counters in rows, where ``lined_up`` those too of which the brief
    leaves open where they stand, each by itself and as they are."""
    lined = [_in_row(_with_staff(_at_wall(wish))) for wish in wishes]
    staffed = [_with_staff(wish) for wish in wishes]
    in_rows = [_in_row(wish) for wish in staffed]
    if lined_up and lined != in_rows:
        yield lined
    if in_rows != staffed:
        yield in_rows
    if staffed != wishes:
        yield staffed
    yield wishes


def leaves_open(demands: list[Demand]) -> bool:
    """Whether some demands leave open where several counters stand."""
    open_ones = (d for d in demands if d.category == COUNTER and d.place is None)
    return any(not demand.patterns and demand.count != 1 for demand in open_ones)


def lacks(laid: Laid) -> bool:
    """Whether something is left out of a hall, or the route misses some of it or is too narrow."""
    missed = (part.cost for part in laid.parts if part.term in ("reach", "access"))
    return bool(laid.left_out) or sum(missed) > NOTHING


def _at_wall(wish: HallDemand) -> HallDemand:
    """Several counters at a wall, where the brief leaves open where they stand."""
    if wish.category != COUNTER or len(wish.sizes) < 2 or not wish.unplaced or wish.facing:
        return wish
    front, left, _, right = wish.clearance
    return wish._replace(patterns=("wall",), clearance=(front, left, 0.0, right))


def _with_staff(wish: HallDemand) -> HallDemand:
    """A demand with the room of its staff behind it, where it is served from there at a wall."""
    kind = KINDS.get(wish.category)
    if kind is None or not kind.staff or not wish.at_wall:
        return wish
    sizes = tuple(size._replace(depth=size.depth + kind.staff) for size in wish.sizes)
    return wish._replace(sizes=sizes, staff=kind.staff)


def _in_row(wish: HallDemand) -> HallDemand:
    """Several counters of one depth, side by side, as one object."""
    sizes = wish.sizes
    alike = len({size.depth for size in sizes}) == 1
    if len(sizes) < 2 or not wish.staff or any(wish.clearance[1::2]) or wish.least or not alike:
        return wish
    width, height = sum(size.width for size in sizes), max(size.height for size in sizes)
    return wish._replace(sizes=(Size(width, sizes[0].depth, height),), row=sizes)


def part_row(wish: HallDemand, pose: Pose, size: Size) -> list[Place]:
    """Where the objects stand that make up one object of a demand: itself, or those of its row.

    >>> row = (Size(2.0, 1.5, 1.0), Size(1.0, 1.5, 1.0))
    >>> wish = HallDemand("c", "c", "counter", (), (0.9, 0, 0, 0), (), (), "", True, row=row)
    >>> pose = Pose(0.0, 0.0, 0.0, math.pi / 2)
    >>> [at.x for at, _ in part_row(wish, pose, Size(3.0, 1.5, 1.0))]
    [-0.5, 1.0]
    """
    if not wish.row:
        return [(pose, size)]
    found, along = list[Place](), -0.5 * size.width
    for one in wish.row:
        at, along = along + 0.5 * one.width, along + one.width
        x, y = pose.x + at * math.sin(pose.heading), pose.y - at * math.cos(pose.heading)
        own = one._replace(depth=size.depth, height=min(one.height, size.height))
        found.append((pose._replace(x=x, y=y), own))
    return found


def grow_to_floor(piece: Piece, wish: HallDemand, catalog: Catalog) -> Piece:
    """A piece as large as the floor it takes with its chairs or staff."""
    if wish.before:
        return grow_desk(piece, wish.before)
    if wish.staff:
        return _grow_staff(piece, wish.staff)
    return grow_table(piece, wish.chairs, catalog)


def _grow_staff(counter: Piece, staff: float) -> Piece:
    """A counter as large as the floor it takes with ``staff`` metres behind it."""
    pose, size = counter.pose, counter.size
    x = pose.x - 0.5 * staff * math.cos(pose.heading)
    y = pose.y - 0.5 * staff * math.sin(pose.heading)
    grown = size._replace(depth=size.depth + staff)
    return replace(counter, pose=pose._replace(x=x, y=y), size=grown)
