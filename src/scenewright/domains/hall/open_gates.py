"""Gates that lead nowhere are left out by name: those beside which the way stays open."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.barriers import BARRIERS
from scenewright.domains.hall.build_problem import HallContext, build_problem
from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.holdings import HallDemand
from scenewright.domains.hall.retouch.gates import find_gates
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.terms.state import Kept
from scenewright.engine.draws import streams

REASON = "nowhere would they and the barriers beside them close the way in"


def find_open(fitted: Fitted, layout: MeasuredLayout, pieces: tuple[Piece, ...]) -> tuple[int, ...]:
    """The units of gates of a layout without barriers among its ``pieces``."""
    closed = {piece.group for piece in pieces if piece.function.endswith(BARRIERS)}
    if layout.loose:
        return ()
    gates = find_gates(fitted.problem, layout.kept)
    return tuple(unit for unit in gates if fitted.problem.names[unit] not in closed)


def report_open(
    hall: HallContext, wishes: list[HallDemand], fitted: Fitted, gone: Collection[int]
) -> tuple[LeftOut, ...]:
    """Units that are left out because they stand open, by the names of their demands."""
    found = []
    for unit in (fitted.units[number] for number in gone):
        wish, many = wishes[unit.demand], unit.last - unit.first
        whole = f"{many} of {len(wish.sizes)} {wish.name}" if len(wish.sizes) > 1 else wish.name
        found.append(LeftOut(hall.space.id, whole, REASON, wish.required))
    return tuple(found)


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
    """What makes a layout less some of its units."""
    counts = np.diff(fitted.problem.units.spans, axis=1)[:, 0]
    owner = np.repeat(np.arange(len(counts)), capacity(counts))
    rows = [number for number in range(len(counts)) if number not in gone]
    layers = kept.layers[np.isin(owner, rows)]
    return kept._replace(pose=kept.pose[rows], rows=kept.rows[rows], layers=layers)
