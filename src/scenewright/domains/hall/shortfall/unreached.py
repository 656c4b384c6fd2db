"""What nobody could get to, however it was laid out, is left out by name instead of standing there.

Optional groups go first where a required one is not reached: they are in its way.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.core.layout import ROUTES
from scenewright.domains.hall.build_problem import build_problem
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.problem import Ints
from scenewright.domains.hall.search import (
    HallSearch,
    measure_wrong,
    search_layout,
    show_found,
    weigh_wrong,
)
from scenewright.domains.hall.seats.seat_audiences import seat_found
from scenewright.domains.hall.solvers.chains import first_layout
from scenewright.domains.hall.solvers.outcome import HallFound, measure_layout
from scenewright.domains.hall.terms.table import REACH
from scenewright.domains.hall.zoning.assign import Unit

AFRESH, AGAIN, NOTHING, GIVEN, CHANCES = 3, 7919, 1e-6, 0.3, 6
"""How often all is tried at other places, the distance of the seeds of these, metres and objects
that count as none, the share of what is missed that is given up at a time, and how many first
places are tried for what is left."""


class Reached(NamedTuple):
    """The final layout, and the numbers of the demands with objects given up:
    for want of a way to it, or (``crowding``) only because passages were too narrow with it."""

    fitted: Fitted
    found: HallFound
    given_up: frozenset[int]
    crowding: frozenset[int] = frozenset()


def drop_unreached(search: HallSearch, fitted: Fitted, found: HallFound) -> Reached:
    """Solve again, elsewhere first and then without some of what the route misses, until it misses
    nothing and no passage is too narrow, or nothing is left to give up. What cannot be solved
    without is kept, for the referee to find."""
    given_up, crowding, begun = frozenset[int](), frozenset[int](), found
    if measure_wrong(found.layouts[0]) > NOTHING:
        fitted, found = seat_found(search, fitted, found)
    fitted, found = try_elsewhere(search, fitted, found, True)
    whole = _complete(search, fitted.units)
    for attempt in range(search.preset.settings.search.given_up):
        if measure_wrong(found.layouts[0]) <= NOTHING:
            break
        last = attempt + 1 == search.preset.settings.search.given_up
        units = _fewer(search, fitted, found, 1.0 if last else GIVEN)
        smaller = _fit_any(search, fitted, units, search.seed + 31 * (attempt + 1))
        if smaller is None:  # less of them has room where more has none
            units = _fewer(search, fitted, found, 2.0 * GIVEN)
            smaller = _fit_any(search, fitted, units, search.seed + 31 * (attempt + 1))
        if smaller is None:
            break
        dropped = _demands_with_fewer(fitted.units, units)
        if found.layouts[0].missed <= NOTHING:
            crowding |= dropped - given_up
        seen = found.evaluations
        fitted, found = search_layout(_tried_once(search), smaller, None, None)
        found = found._replace(evaluations=found.evaluations + seen)
        fitted, found = try_elsewhere(search, fitted, found, False)
        given_up |= dropped
    show_found(search, fitted, begun, found, ROUTES, "stands elsewhere, or less: ways are open")
    return Reached(fitted, found, given_up & whole, crowding & whole)


def try_elsewhere(
    search: HallSearch, fitted: Fitted, found: HallFound, patient: bool
) -> tuple[Fitted, HallFound]:
    """The same groups from other first places where something is wrong: the first layout in which
    everything is reached and no passage too narrow, else the one with fewest such faults. These
    outweigh all else meanwhile. Who is not ``patient`` gives up where as much is
    wrong twice."""
    once, seen, best = _tried_once(search), found.evaluations, (fitted, found)
    before = np.inf
    for attempt in range(AFRESH if measure_wrong(found.layouts[0]) > NOTHING else 0):
        again = _fit_units(search, fitted, fitted.units, search.seed + AGAIN * (attempt + 1))
        if again is None:
            continue
        heavy = again._replace(problem=weigh_wrong(again.problem))
        _, other = search_layout(once, heavy, None, None)
        seen += other.evaluations
        wrong = measure_wrong(other.layouts[0])
        if wrong <= NOTHING:
            return again, other._replace(evaluations=seen)
        if wrong < measure_wrong(best[1].layouts[0]):
            best = again, other
        if wrong == before and not patient:  # the search ends there, wherever it begins
            break
        before = wrong
    return best[0], best[1]._replace(evaluations=seen)


def _complete(search: HallSearch, units: list[Unit]) -> frozenset[int]:
    """The demands whose objects all have room: what they then lack was given up for its way."""
    counts = np.zeros(len(search.wishes), np.int64)
    for unit in units:
        counts[unit.demand] += unit.last - unit.first
    return frozenset(k for k, wish in enumerate(search.wishes) if counts[k] == len(wish.sizes))


def _tried_once(search: HallSearch) -> HallSearch:
    """The same search without further attempts: there will be a smaller one if it fails."""
    settings = search.preset.settings
    once = settings._replace(search=settings.search._replace(attempts=1))
    return search._replace(preset=search.preset._replace(settings=once))


def _fewer(search: HallSearch, fitted: Fitted, found: HallFound, share: float) -> list[Unit]:
    """Units less one optional group where a required one is not reached, else less a share of as
    many objects as the route misses, of the groups that have most of them; doors it misses cost
    the largest group one."""
    units, wishes = fitted.units, search.wishes
    _, s, _ = measure_layout(fitted.problem, found.layouts[0])
    missed = s.costs[REACH, : len(units)].astype(int)
    counts = np.array([unit.last - unit.first for unit in units])
    optional = [k for k, unit in enumerate(units) if not wishes[unit.demand].required]
    needed = any(missed[k] and wishes[unit.demand].required for k, unit in enumerate(units))
    if needed and optional:
        missed[:] = 0
        last = min(optional, key=lambda k: int(counts[k]))
        missed[last] = counts[last]
    elif not missed.any():
        missed[int(np.argmax(counts))] = 1
    else:
        missed = _take_share(missed, counts, share)
    left = zip(units, missed, strict=True)
    return [u._replace(last=u.last - int(n)) for u, n in left if u.last - u.first > n]


def _take_share(missed: Ints, counts: Ints, share: float) -> Ints:
    """How many objects of each group (g,) to give up for a share of those missed (g,) of
    ``counts`` (g,): one after another of the group that has most left, of like ones that asked
    for last; nothing there is one of goes before the others.

    >>> _take_share(np.array([2, 4, 1, 0]), np.array([2, 4, 1, 6]), 0.4).tolist()
    [0, 3, 0, 0]
    """
    given = np.zeros(len(missed), np.int64)
    for _ in range(int(np.ceil(share * missed.sum()))):
        left = np.where(given < missed, counts - given, -1)
        given[len(left) - 1 - int(np.argmax(left[::-1]))] += 1
    return given


def _fit_units(search: HallSearch, fitted: Fitted, units: list[Unit], seed: int) -> Fitted | None:
    """A first layout of other units in the same hall; none if there is no room for it."""
    problem = build_problem(
        search.hall, search.wishes, units, fitted.hosts, search.preset.weights, search.catalog
    )
    tried = search.preset.settings.fit.tried
    start, lost = first_layout(problem, fitted.start.walls, seed, tried)
    return None if lost else Fitted(units, fitted.hosts, problem, start)


def _fit_any(search: HallSearch, fitted: Fitted, units: list[Unit], seed: int) -> Fitted | None:
    """As :func:`_fit_units`, by the first of some seeds that finds room; none without units."""
    seeds = range(seed, seed + CHANCES) if units else range(0)
    tries = (_fit_units(search, fitted, units, one) for one in seeds)
    return next((one for one in tries if one is not None), None)


def _demands_with_fewer(before: list[Unit], after: list[Unit]) -> frozenset[int]:
    counts: dict[int, int] = {}
    for units, sign in ((before, 1), (after, -1)):
        for unit in units:
            counts[unit.demand] = counts.get(unit.demand, 0) + sign * (unit.last - unit.first)
    return frozenset(demand for demand, count in counts.items() if count > 0)
