"""Seats that look past their stage are set up anew before it, as one group, as many as have room.

What the search leaves in several groups, or turned away, finds no way back by single moves: rows
are laid out afresh on the axis of what is shown, which may move to the middle of a wall; objects
there find other places. Seats that no rows hold are left out by name.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from scenewright.arranging.verdict import better
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.build_problem import HallContext, build_problem
from scenewright.domains.hall.classes import TABLE_CHAIRS, is_audience_seat
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.gates.idle_guides import drop_units
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch import retouch_named
from scenewright.domains.hall.retouch.audience import FEWEST
from scenewright.domains.hall.retouch.lines import count_objects, line_up
from scenewright.domains.hall.retouch.mending import SeenTouch, weigh_layout, weigh_proposals
from scenewright.domains.hall.search import HallSearch, weigh_wrong
from scenewright.domains.hall.seats.turns import SHARE, count_away
from scenewright.domains.hall.solvers.chains import HallChain, begin_chain, cooled_hall, layout_of
from scenewright.domains.hall.solvers.outcome import HallFound, MeasuredLayout, verdict_on
from scenewright.domains.hall.terms.state import Kept
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget

SHARES = (1.0, 0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4)
"""Parts of the seats that are tried one after another."""
WALKED, SETTLED, STEPS = 8, 3, 3000
"""How many layouts of seats are walked through unchanged, in how many of them all else is
annealed again, and for how many steps."""
REASON = "there is no room for them before what they are to look at"


def seat_audiences(
    search: HallSearch, fitted: Fitted, layout: MeasuredLayout
) -> tuple[Fitted, MeasuredLayout, tuple[LeftOut, ...]]:
    """The layout with the seats of each demand that look away, or stand in several groups, in rows
    before what they look at. Where no rows find room, those that look away are left out."""
    missing: tuple[LeftOut, ...] = ()
    for demand in [] if layout.loose else sorted(_find_astray(search, fitted, layout)):
        mine = _units_of(fitted, demand)
        found = _seat(search, fitted, layout, mine)
        if found is None and _count_away(fitted.problem, layout, mine):
            found = drop_units(search.hall, search.wishes, fitted, layout, mine, search.catalog)
        if found is not None:
            missing += _report(search.hall, search.wishes[demand], fitted, found[0], demand)
            fitted, layout = found
    return fitted, layout, missing


def seat_found(search: HallSearch, fitted: Fitted, found: HallFound) -> tuple[Fitted, HallFound]:
    """What was found with all seats before what they look at, or as it is where some have no room
    there."""
    seated, best, missing = seat_audiences(search, fitted, found.layouts[0])
    return (fitted, found) if missing else (seated, found._replace(layouts=(best,)))


def _find_astray(search: HallSearch, fitted: Fitted, layout: MeasuredLayout) -> Iterator[int]:
    """The demands of seats in one zone that alone look at one object, where too many look
    past it or they stand in several groups."""
    units = fitted.problem.units
    for demand in {unit.demand for unit in fitted.units}:
        mine, wish = _units_of(fitted, demand), search.wishes[demand]
        target = int(units.targets[mine[0]])
        watching = is_audience_seat(wish.category, wish.sizes[0].width)
        seats = watching or wish.category in TABLE_CHAIRS or wish.turned
        if not seats or target < 0 or "chain" not in wish.patterns:
            continue
        alone = sorted(np.flatnonzero(units.targets == target)) == mine
        together = len(set(units.zones[mine])) == 1 and np.diff(units.spans[target])[0] == 1
        many = int(count_objects(fitted.problem)[mine].sum()) >= FEWEST
        rows = alone and together and many
        if rows and (len(mine) > 1 or _count_away(fitted.problem, layout, mine)):
            yield demand


def _units_of(fitted: Fitted, demand: int) -> list[int]:
    return [number for number, unit in enumerate(fitted.units) if unit.demand == demand]


def _count_away(problem: HallProblem, layout: MeasuredLayout, mine: Sequence[int]) -> int:
    """How many seats of some units look past their stage, if those are more than may."""
    units = problem.units
    rows = [row for unit in mine for row in range(*units.spans[unit])]
    stage = layout.boxes[units.spans[units.targets[mine[0]], 0]]
    away = count_away(layout.boxes[rows], stage)
    return away if away > SHARE * len(rows) else 0


def _seat(
    search: HallSearch, fitted: Fitted, layout: MeasuredLayout, mine: list[int]
) -> tuple[Fitted, MeasuredLayout] | None:
    """The layout with as many seats of some units as find room in rows before their stage, joined
    in one; None if no more do than look at it already."""
    whole = int(count_objects(fitted.problem)[mine].sum())
    away = _count_away(fitted.problem, layout, mine)
    least, now = max(whole - away, FEWEST), verdict_on(layout, groups=len(mine), away=away)
    for count in dict.fromkeys(int(share * whole) for share in SHARES):
        if count < least or search.passes.cancelled():
            break
        joined = join_units(search, fitted, layout.kept, mine, count)
        chain = begin_chain(joined.problem, joined.start, streams(0, 1)[0])
        touch = SeenTouch(retouch_named("audience"), joined.problem)
        now_at = weigh_layout(chain, touch, joined.start)
        every = weigh_proposals(chain, touch, now_at, [], stopped=search.passes.cancelled)
        rows = sorted((p for p in every if np.isfinite(p.cost)), key=lambda p: p.cost)
        for found in _walk_through(search, chain, [p.kept for p in rows]):
            away = _count_away(joined.problem, found, mine[:1])
            if not away and better(verdict_on(found, groups=1.0), now):
                return joined._replace(start=found.kept), found
    return None


def _walk_through(
    search: HallSearch, chain: HallChain, rows: list[Kept]
) -> Iterator[MeasuredLayout]:
    """Some layouts by rising cost as they are, then the cheapest with all else settled anew."""
    yield from (layout_of(chain._replace(best=kept)) for kept in rows[:WALKED])
    heavy, budget = weigh_wrong(chain.problem), Budget(steps=STEPS, threads=search.budget.threads)
    for kept in rows[:SETTLED]:
        settled = cooled_hall(heavy, kept, budget, search.seed).layouts[0]
        yield layout_of(begin_chain(chain.problem, settled.kept, streams(0, 1)[0]))


def join_units(
    search: HallSearch, fitted: Fitted, kept: Kept, mine: list[int], count: int
) -> Fitted:
    """The same with ``count`` objects of some units of one demand as one of them, in two rows where
    the first stands."""
    first, gone = mine[0], mine[1:]
    begin = min(fitted.units[unit].first for unit in mine)
    units = [*fitted.units]
    units[first] = units[first]._replace(first=begin, last=begin + count)
    units = [unit for number, unit in enumerate(units) if number not in gone]
    weights, catalog = fitted.problem.weights, search.catalog
    problem = build_problem(search.hall, search.wishes, units, fitted.hosts, weights, catalog)
    rooms = capacity(count_objects(fitted.problem))
    ends = np.cumsum(rooms)
    blocks = [kept.layers[end - room : end] for end, room in zip(ends, rooms, strict=True)]
    blocks[first] = np.zeros((int(capacity(np.array([count]))[0]), 5))
    stay = [number for number in range(len(rooms)) if number not in gone]
    layers = np.concatenate([blocks[number] for number in stay])
    less = kept._replace(pose=kept.pose[stay], rows=kept.rows[stay], layers=layers)
    start = line_up(problem, less, first, kept.pose[first], 2, 1.0)
    return Fitted(units, fitted.hosts, problem, start)


def _report(
    hall: HallContext, wish: HallDemand, before: Fitted, after: Fitted, demand: int
) -> tuple[LeftOut, ...]:
    """The seats of a demand that no rows hold, unless more than those it needs stand."""
    old, new = (
        int(count_objects(one.problem)[_units_of(one, demand)].sum()) for one in (before, after)
    )
    if old == new or 0 < wish.least <= new:
        return ()
    what = f"{old - new} of {len(wish.sizes)} {wish.name}"
    return (LeftOut(hall.space.id, what, REASON, wish.required),)
