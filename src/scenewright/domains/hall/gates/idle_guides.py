"""What guides nobody is left out by name: gates beside which the way stays open, ropes before
nothing, and ropes that bar the way to what they guide people to."""

from __future__ import annotations

from collections.abc import Collection, Mapping

import numpy as np

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.build_problem import HallContext, build_problem
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.gates.barriers import BARRIERS
from scenewright.domains.hall.gates.barring_ropes import count_missed_among
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.retouch.gates import find_gates
from scenewright.domains.hall.retouch.ropes import find_ropes, forms_lane, measure_ropes
from scenewright.domains.hall.search import HallSearch
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.terms.state import Kept
from scenewright.engine.draws import streams

OPEN = (
    "nowhere would they and the barriers beside them close the way in: draw a zone at the entrance "
    "for them, ask for a narrower door, or for less beside it"
)
STRAY = "there is no room for them before what they guide people to"
LONE = "there is no room for two lines of them with a lane between before where people are served"
BARRING = "they would bar the way to where people are served"
ASTRAY = 1.5
"""Metres of fault from which on ropes guide nobody."""


def find_idle(
    wishes: list[HallDemand], fitted: Fitted, layout: MeasuredLayout, pieces: tuple[Piece, ...]
) -> dict[int, str]:
    """The units of a layout that guide nobody, and why: gates without barriers among its
    ``pieces``, ropes off their place, and those that may be left out and form no lane."""
    if layout.loose:
        return {}
    problem, kept, boxes = fitted.problem, layout.kept, layout.boxes
    closed = {piece.group for piece in pieces if piece.function.endswith(BARRIERS)}
    idle = {u: OPEN for u in find_gates(problem, kept) if problem.names[u] not in closed}
    ropes = find_ropes(problem, kept)
    spare = (u for u in ropes if not wishes[fitted.units[u].demand].required)
    lone = (u for u in spare if not forms_lane(problem, kept, boxes, u))
    astray = (u for u in ropes if measure_ropes(problem, kept, boxes, u) > ASTRAY)
    return idle | dict.fromkeys(lone, LONE) | dict.fromkeys(astray, STRAY)


def find_barring(
    search: HallSearch, fitted: Fitted, layout: MeasuredLayout, served: Floats
) -> dict[int, str]:
    """The ropes of a layout without which the route misses less of the fronts of boxes (k, 5) at
    which people are ``served``, and why they are idle."""
    ropes = [] if layout.loose else find_ropes(fitted.problem, layout.kept)
    missed = count_missed_among(fitted.problem, layout, served) if ropes else 0.0
    return {
        unit: BARRING
        for unit in ropes
        if missed > _less_missed(search, fitted, layout, served, unit)
    }


def _less_missed(
    search: HallSearch, fitted: Fitted, layout: MeasuredLayout, served: Floats, unit: int
) -> float:
    """How much the route misses without a unit."""
    less, found = drop_units(search.hall, search.wishes, fitted, layout, [unit], search.catalog)
    return count_missed_among(less.problem, found, served)


def report_idle(
    hall: HallContext, wishes: list[HallDemand], fitted: Fitted, idle: Mapping[int, str]
) -> tuple[LeftOut, ...]:
    """Units that are left out because they guide nobody, by the names of their demands."""
    found = []
    for number, reason in idle.items():
        unit = fitted.units[number]
        wish, many = wishes[unit.demand], unit.last - unit.first
        whole = f"{many} of {len(wish.sizes)} {wish.name}" if len(wish.sizes) > 1 else wish.name
        found.append(LeftOut(hall.space.id, whole, reason, wish.required))
    return tuple(found)


def report_fewer(
    hall: HallContext,
    wishes: list[HallDemand],
    before: Fitted,
    after: Fitted,
    unit: int,
    reason: str = STRAY,
) -> tuple[LeftOut, ...]:
    """The ropes of a unit that found no room beside the others of it, or not without harm."""
    wish = wishes[after.units[unit].demand]
    gone = before.units[unit].last - after.units[unit].last
    whole = f"{gone} of {len(wish.sizes)} {wish.name}"
    return (LeftOut(hall.space.id, whole, reason, wish.required),) if gone else ()


def drop_units(
    hall: HallContext,
    wishes: list[HallDemand],
    fitted: Fitted,
    layout: MeasuredLayout,
    gone: Collection[int],
    catalog: Catalog,
) -> tuple[Fitted, MeasuredLayout]:
    """The same layout without some units."""
    units = [unit for number, unit in enumerate(fitted.units) if number not in gone]
    weights = fitted.problem.weights
    problem = build_problem(hall, wishes, units, fitted.hosts, weights, catalog)
    kept = _less(fitted, layout.kept, gone)
    chain = begin_chain(problem, kept, streams(0, 1)[0])
    return Fitted(units, fitted.hosts, problem, kept), layout_of(chain)


def _less(fitted: Fitted, kept: Kept, gone: Collection[int]) -> Kept:
    """The layout without some of its units."""
    counts = np.diff(fitted.problem.units.spans, axis=1)[:, 0]
    owner = np.repeat(np.arange(len(counts)), capacity(counts))
    rows = [number for number in range(len(counts)) if number not in gone]
    layers = kept.layers[np.isin(owner, rows)]
    return kept._replace(pose=kept.pose[rows], rows=kept.rows[rows], layers=layers)
