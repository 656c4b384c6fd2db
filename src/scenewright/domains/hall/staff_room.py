"""Room for the staff of counters at walls: they stand behind them, before the wall.

Counters of one group that ask for nothing at their sides stand in one line: a row of them is one
object until it is furnished.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from scenewright.catalog.kinds import KINDS
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.fit import Fitted, fit
from scenewright.domains.hall.holdings import HallDemand
from scenewright.engine.solve import Cancel

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
    found: list[tuple[int, list[HallDemand], Fitted]] = []
    whole = hall.settings.whole
    for asked in [wishes] if whole else _ways_to_stand(wishes):
        fitted = fit(hall, asked, weights, catalog, seed, whole, cancel)
        count = sum(_count_objects(asked[u.demand], u.last - u.first) for u in fitted.units)
        if count == sum(len(wish.sizes) for wish in wishes):
            return asked, fitted
        found.append((count, asked, fitted))
    return max(found, key=lambda one: one[0])[1:]


def _count_objects(wish: HallDemand, count: int) -> int:
    """How many objects so many of a demand are once they are furnished."""
    return count * max(len(wish.row), 1)


def _ways_to_stand(wishes: list[HallDemand]) -> Iterator[list[HallDemand]]:
    """The demands with their counters in rows, each by itself and as they are."""
    staffed = [_with_staff(wish) for wish in wishes]
    in_rows = [_in_row(wish) for wish in staffed]
    if in_rows != staffed:
        yield in_rows
    if staffed != wishes:
        yield staffed
    yield wishes


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


def grow_staff(counter: Piece, staff: float) -> Piece:
    """A counter as large as the floor it takes with ``staff`` metres behind it."""
    pose, size = counter.pose, counter.size
    x = pose.x - 0.5 * staff * math.cos(pose.heading)
    y = pose.y - 0.5 * staff * math.sin(pose.heading)
    grown = size._replace(depth=size.depth + staff)
    return replace(counter, pose=pose._replace(x=x, y=y), size=grown)
