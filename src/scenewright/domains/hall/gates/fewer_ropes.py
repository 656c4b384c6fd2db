"""Fewer ropes where not all find room before what they guide people to."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.arranging.verdict import better
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.build_problem import build_problem
from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.gates.barring_ropes import count_missed_among
from scenewright.domains.hall.gates.idle_guides import (
    ASTRAY,
    BARRING,
    LONE,
    STRAY,
    drop_units,
    report_fewer,
)
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import (
    count_objects,
    find_layers,
    forgive_space,
    line_up,
)
from scenewright.domains.hall.retouch.ropes import (
    find_ropes,
    find_served,
    forms_lane,
    measure_ropes,
    propose_ropes,
)
from scenewright.domains.hall.search import HallSearch
from scenewright.domains.hall.solvers.chains import HallChain, begin_chain, layout_of
from scenewright.domains.hall.solvers.guided_metropolis import bring_back
from scenewright.domains.hall.solvers.outcome import MeasuredLayout, verdict_on
from scenewright.domains.hall.solvers.start import copy_frames
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.engine.draws import streams

FEWEST = 2
"""Ropes of a line that guides somebody, at least."""
ASIDE = (0.0, -0.6, 0.6, -1.2, 1.2, -1.8, 1.8)
"""Metres to the side of where ropes belong that are tried."""
PER_ROPE_METRE, DEAR, WALKED = 30.0, 120.0, 8
"""What a metre of fault costs beside the energy, by how much ropes may raise that of their hall,
and how many places are walked through."""


def place_fewer_of_each(
    search: HallSearch, fitted: Fitted, layout: MeasuredLayout, idle: dict[int, str], served: Floats
) -> tuple[Fitted, MeasuredLayout, dict[int, str], tuple[LeftOut, ...]]:
    """The layout with as many ropes of each ``idle`` unit as find room, the units that are idle
    still, and what is left out by that."""
    missing: tuple[LeftOut, ...] = ()
    for unit, why in [row for row in idle.items() if row[1] in (STRAY, BARRING, LONE)]:
        spare = not search.wishes[fitted.units[unit].demand].required
        fewer = place_fewer(search, fitted, layout, unit, served, lane=spare)
        if fewer is not None:
            gone = report_fewer(search.hall, search.wishes, fitted, fewer[0], unit, why)
            missing = (*missing, *gone)
            (fitted, layout), idle = fewer, {u: why for u, why in idle.items() if u != unit}
    return fitted, layout, idle, missing


def place_fewer(
    search: HallSearch,
    fitted: Fitted,
    layout: MeasuredLayout,
    unit: int,
    served: Floats,
    *,
    lane: bool = False,
) -> tuple[Fitted, MeasuredLayout] | None:
    """The layout with as many ropes of a unit as find room before what they guide people to, and
    let people by, to where they are ``served`` (k, 5) too, as the hall without them does; None if
    hardly any do. They form a ``lane`` if asked to."""
    bare, without = drop_units(search.hall, search.wishes, fitted, layout, [unit], search.catalog)
    missed = count_missed_among(bare.problem, without, served)
    none = verdict_on(without._replace(missed=missed), fewer=1.0)
    for count in range(int(count_objects(fitted.problem)[unit]), FEWEST - 1, -1):
        less = _shorten(search, fitted, layout.kept, unit, count)
        chain = begin_chain(less.problem, less.start, streams(0, 1)[0])
        first = int(fitted.problem.units.spans[unit, 0])
        gone = np.arange(first + count, fitted.problem.units.spans[unit, 1])
        boxes = np.delete(layout.boxes, gone, axis=0)
        for kept in _find_places(chain, less, boxes, unit, without.energy + DEAR, lane):
            found = layout_of(chain._replace(best=kept))
            missed = count_missed_among(less.problem, found, served)
            if better(verdict_on(found._replace(missed=missed), fewer=0.0), none):
                return less._replace(start=kept), found
    return None


def _shorten(search: HallSearch, fitted: Fitted, kept: Kept, unit: int, count: int) -> Fitted:
    """The same with ``count`` ropes of a unit, in one line where they stand."""
    mine = fitted.units[unit]
    units = [*fitted.units]
    units[unit] = mine._replace(last=mine.first + count)
    weights = fitted.problem.weights
    problem = build_problem(
        search.hall, search.wishes, units, fitted.hosts, weights, search.catalog
    )
    row, room = find_layers(fitted.problem, unit)
    left = int(capacity(np.array([count]))[0])
    layers = np.delete(kept.layers, np.arange(row + left, row + room), axis=0)
    start = line_up(problem, kept._replace(layers=layers), unit, kept.pose[unit])
    return Fitted(units, fitted.hosts, problem, start)


def _find_places(
    chain: HallChain, fitted: Fitted, boxes: Floats, unit: int, most: float, lane: bool
) -> list[Kept]:
    """Layouts with the ropes of a unit near their place that cost at most ``most``, the cheapest
    first."""
    found: list[tuple[float, int, Kept]] = []
    for number, kept in enumerate(_propose(fitted, boxes, unit)):
        energy = bring_back(chain.p, chain.s, chain.work, kept)
        if np.isfinite(energy):
            stand = np.zeros((len(chain.p.sizes), 5))
            copy_frames(chain.s, stand)
            fault = measure_ropes(fitted.problem, kept, stand, unit)
            forgiven = _forgive_queues(fitted.problem, kept, chain.p, chain.s)
            guides = not lane or forms_lane(fitted.problem, kept, stand, unit)
            if guides and fault <= ASTRAY and energy - forgiven <= most:
                found.append((energy - forgiven + PER_ROPE_METRE * fault, number, kept))
    return [kept for _, _, kept in sorted(found, key=lambda one: one[:2])[:WALKED]]


def _forgive_queues(problem: HallProblem, kept: Kept, p: PreparedHall, s: State) -> float:
    """What of the energy of a measured state comes from free floor that ropes and the desks in
    their zones share with others: the queue is on both."""
    ropes = find_ropes(problem, kept)
    shared = (one for unit in ropes for one in (unit, *find_served(problem, unit)))
    return sum(forgive_space(p, s, one, float(s.covered[one, ::2].sum())) for one in shared)


def _propose(fitted: Fitted, boxes: Floats, unit: int) -> Iterator[Kept]:
    """Layouts with the ropes of a unit where they belong, and to a side of that."""
    for kept in propose_ropes(fitted.problem, fitted.start, boxes):
        if (kept.pose[unit] == fitted.start.pose[unit]).all():
            continue
        heading = float(kept.pose[unit, 2])
        for axis in (heading, heading + 0.5 * np.pi):
            for aside in ASIDE:
                pose = kept.pose.copy()
                pose[unit, :2] += aside * np.array([np.cos(axis), np.sin(axis)])
                yield kept._replace(pose=pose)
