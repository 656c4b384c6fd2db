"""Room for the staff of counters at walls: they stand behind them, before the wall.

Counters of one group that ask for nothing at their sides stand in one line: a row of them is one
object until it is furnished.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from scenewright.catalog.kinds import KINDS
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.accessories.stools import may_sit_at
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.desks.counter_forms import list_forms
from scenewright.domains.hall.desks.ways import list_parted
from scenewright.domains.hall.fit import Fitted, fit, place_lacking
from scenewright.domains.hall.seats.chairs import grow_table
from scenewright.domains.hall.seats.lounges import count_parts, list_lounge_forms, part_lounges
from scenewright.domains.hall.seats.seating import grow_desk
from scenewright.engine.solve import Cancel

Place = tuple[Pose, Size]


def fit_with_staff(
    hall: HallContext,
    wishes: list[HallDemand],
    weights: dict[str, float],
    catalog: Catalog,
    seed: int,
    cancel: Cancel | None = None,
    small: Sequence[HallDemand] = (),
) -> tuple[list[HallDemand], Fitted]:
    """Demands as they find room, and their first layout (:func:`.fit.fit`): counters at walls in
    rows with room for their staff, else singly, else with their backs at the wall, whichever leaves
    least unplaced; lounges apart where they find no room; counters whose place
    the brief leaves open in the first form (:mod:`.counter_forms`,
    :mod:`.lounges`) by which nothing is lost that else would stand. As they are where groups stay
    as printed. ``small`` objects are set last. What lacks in the end is tried again beside all that
    stands."""

    def fit_one(asked: list[HallDemand]) -> Stand:
        fitted = fit(hall, asked, weights, catalog, seed, hall.settings.whole, cancel)
        count = sum(_count_objects(asked[u.demand], u.last - u.first) for u in fitted.units)
        return Stand(count, asked, fitted)

    if hall.settings.whole:
        return fit_one(wishes)[1:]
    best, every = _fit_forms(hall, wishes, small, fit_one)
    if best.placed < every and any(wish.lounges for wish in wishes):
        apart, _ = _fit_forms(hall, part_lounges(wishes), small, fit_one)
        best = apart if apart.placed > best.placed else best
    _, asked, fitted = best
    return asked, place_lacking(hall, asked, weights, catalog, seed, fitted, cancel)


def _fit_forms(
    hall: HallContext,
    wishes: list[HallDemand],
    small: Sequence[HallDemand],
    fit_one: Callable[[list[HallDemand]], Stand],
) -> tuple[Stand, int]:
    """Demands in the forms by which most find room, and how many objects they are in all."""
    every, lined = sum(_count_objects(w, len(w.sizes)) for w in wishes), hall.settings.lined
    forms = [list(_list_forms(hall, wish, small)) if lined else [] for wish in wishes]
    if any(forms):
        whole = fit_one(
            [_in_row(_with_staff((f or [w])[0])) for f, w in zip(forms, wishes, strict=True)]
        )
        if whole.placed == every and not _built_for(whole, wishes):
            return whole, every
    best = _fit_said(wishes, every, fit_one)
    for number, row in enumerate(forms):
        best = _line_up(best, number, row, fit_one)
    return best, every


def _list_forms(
    hall: HallContext, wish: HallDemand, small: Sequence[HallDemand]
) -> Iterator[HallDemand]:
    """The forms of counters, lounges and desks that leave these open."""
    yield from list_forms(hall, wish, small)
    yield from list_lounge_forms(wish)
    yield from list_parted(hall, wish)


class Stand(NamedTuple):
    """How many objects have a place, in what form they are asked for, and their first layout."""

    placed: int
    asked: list[HallDemand]
    fitted: Fitted


def _fit_said(
    wishes: list[HallDemand], every: int, fit_one: Callable[[list[HallDemand]], Stand]
) -> Stand:
    """The first form of what the brief says to stand at walls in which all ``every`` objects have
    a place, else that in which most do."""
    found: list[Stand] = []
    for asked in _ways_to_stand(wishes):
        found.append(fit_one(asked))
        if found[-1].placed == every:
            break
    return max(found, key=lambda one: one.placed)


def _line_up(
    best: Stand, number: int, forms: list[HallDemand], fit_one: Callable[[list[HallDemand]], Stand]
) -> Stand:
    """The same with one demand in the first of some forms by which nothing is lost; itself where
    there is none."""
    for form in forms:
        asked = [*best.asked[:number], form, *best.asked[number + 1 :]]
        tried = fit_one(asked)
        if tried.placed >= best.placed and not _built_for(tried, best.asked):
            return tried
    return best


def _built_for(stand: Stand, before: list[HallDemand]) -> bool:
    """Whether walls are built in zones of what was not to stand at walls before."""
    unasked = [a.at_wall and not b.at_wall for a, b in zip(stand.asked, before, strict=True)]
    zones = {unit.zone for unit in stand.fitted.units if unasked[unit.demand]}
    return any(zones & {int(host.row[4]), int(host.row[5])} for host in stand.fitted.hosts)


def _count_objects(wish: HallDemand, count: int) -> int:
    """How many furnished objects ``count`` objects of a demand become."""
    return count_parts(wish, count) * max(len(wish.row), 1) * (2 if wish.double else 1)


def _ways_to_stand(wishes: list[HallDemand]) -> Iterator[list[HallDemand]]:
    """The demands with their counters at walls in rows, each singly, and unchanged."""
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
    if kind is None or not kind.staff or not wish.at_wall or wish.staff:
        return wish
    sizes = tuple(size._replace(depth=size.depth + kind.staff) for size in wish.sizes)
    return wish._replace(sizes=sizes, staff=kind.staff)


def _in_row(wish: HallDemand) -> HallDemand:
    """Several counters of one depth, side by side, as one object."""
    sizes = wish.sizes
    alike = len({size.depth for size in sizes}) == 1
    sides = any(wish.clearance[1::2])
    if len(sizes) < 2 or not wish.staff or sides or wish.least or not alike or wish.row:
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
    if not wish.double:
        return _part_line(wish, pose, size)
    deep = wish.row[0].depth
    front, own = _ahead(pose, 0.5 * (size.depth - deep)), size._replace(depth=deep)
    back = _ahead(pose, -0.5 * (size.depth - deep))
    turned = back._replace(heading=math.remainder(pose.heading + math.pi, 2.0 * math.pi))
    return [*_part_line(wish, front, own), *_part_line(wish, turned, own)]


def _ahead(pose: Pose, far: float) -> Pose:
    """A pose ``far`` metres ahead."""
    x, y = pose.x + far * math.cos(pose.heading), pose.y + far * math.sin(pose.heading)
    return pose._replace(x=x, y=y)


def _part_line(wish: HallDemand, pose: Pose, size: Size) -> list[Place]:
    """Where the objects of a row stand side by side."""
    found, along = list[Place](), -0.5 * size.width
    for one in wish.row:
        at, along = along + 0.5 * one.width, along + one.width
        x, y = pose.x + at * math.sin(pose.heading), pose.y - at * math.cos(pose.heading)
        own = one._replace(depth=size.depth, height=min(one.height, size.height))
        found.append((pose._replace(x=x, y=y), own))
    return found


def grow_to_floor(piece: Piece, wish: HallDemand, catalog: Catalog) -> Piece:
    """A piece as large as the floor it takes with its chairs or staff; a high table as it is, for
    its stools are set last."""
    if wish.before and wish.seated:
        return grow_desk(piece, wish.before)
    if wish.staff or wish.double:
        return _grow_staff(piece, KINDS[wish.category].staff)
    stools = may_sit_at(piece.category, piece.size.height)
    return piece if stools else grow_table(piece, wish.chairs, catalog)


def _grow_staff(counter: Piece, staff: float) -> Piece:
    """A counter as large as the floor it takes with ``staff`` metres behind it."""
    pose, size = counter.pose, counter.size
    x = pose.x - 0.5 * staff * math.cos(pose.heading)
    y = pose.y - 0.5 * staff * math.sin(pose.heading)
    grown = size._replace(depth=size.depth + staff)
    return replace(counter, pose=pose._replace(x=x, y=y), size=grown)
