"""Retouching: what a planner sets right once everything stands.

Each touch counts a fault in metres and proposes layouts with less of it. The one of them that costs
least, its fault included, is kept if the route misses no more and no passage narrows.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np

from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.columns import (
    find_columns,
    forgive_columns,
    propose_pitches,
    stand_in_aisles,
)
from scenewright.domains.hall.retouch.desks import (
    desks_adrift,
    first_desks,
    mind_order,
    other_desks,
    propose_desks,
)
from scenewright.domains.hall.retouch.gates import gates_adrift, propose_gates
from scenewright.domains.hall.retouch.rings import propose_rings, rings_off
from scenewright.domains.hall.retouch.seats import propose_rows, sit_too_near
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.guided_metropolis import bring_back
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.solvers.start import copy_frames
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.engine.draws import streams

WEIGHT, LEAST, LOOKED = 6.0, 0.05, 6
"""What a metre of fault costs beside the energy, metres not worth a change, and how many proposals
are walked through at most."""


ROUNDS = 4
"""How often a touch is made at most: each proposal changes one group."""


class Retouch(NamedTuple):
    """One touch: what it has to know of a problem (``look``), its ``fault`` of boxes (n, 5) in
    metres, the layouts it proposes, and what of the energy of a measured state it does not count
    (``forgive``)."""

    look: Callable[[HallProblem], Any]
    fault: Callable[[Any, Kept, Floats], float]
    propose: Callable[[Any, Kept, Floats], Iterable[Kept]]
    forgive: Callable[[Any, Kept, Floats, PreparedHall, State], float] | None = None


def _whole(problem: HallProblem) -> HallProblem:
    return problem


RETOUCHES: dict[str, Retouch] = {
    "columns": Retouch(find_columns, stand_in_aisles, propose_pitches, forgive_columns),
    "seats": Retouch(_whole, sit_too_near, propose_rows),
    "rings": Retouch(_whole, rings_off, propose_rings),
    "gates": Retouch(_whole, gates_adrift, propose_gates),
    "desks": Retouch(first_desks, desks_adrift, propose_desks, mind_order),
    "counters": Retouch(other_desks, desks_adrift, propose_desks),
}
"""In the order in which they are made."""


def retouch_layout(problem: HallProblem, layout: MeasuredLayout) -> MeasuredLayout:
    """A layout of patterns with as little of each fault as it costs no more to mend."""
    if layout.loose or not len(layout.boxes):
        return layout
    for touch in RETOUCHES.values():
        seen = touch.look(problem)
        for _ in range(ROUNDS):
            if touch.fault(seen, layout.kept, layout.boxes) <= LEAST:
                break
            before, layout = layout, _mend(problem, seen, layout, touch)
            if layout is before:
                break
    return layout


def _mend(
    problem: HallProblem, seen: Any, layout: MeasuredLayout, touch: Retouch
) -> MeasuredLayout:
    """The layout with one touch, or as it is."""
    chain = begin_chain(problem, layout.kept, streams(0, 1)[0])
    boxes = np.zeros_like(layout.boxes)

    def cost(kept: Kept) -> float:
        energy = bring_back(chain.p, chain.s, chain.work, kept)
        if not np.isfinite(energy):
            return np.inf
        copy_frames(chain.s, boxes)
        if touch.forgive is not None:
            energy -= touch.forgive(seen, kept, boxes, chain.p, chain.s)
        return energy + WEIGHT * touch.fault(seen, kept, boxes)

    now = cost(layout.kept)
    found = [
        (cost(kept), k, kept)
        for k, kept in enumerate(touch.propose(seen, layout.kept, layout.boxes))
    ]
    better = sorted(row[:2] for row in found if row[0] < now - LEAST)[:LOOKED]
    for _, number in better:
        tried = layout_of(chain._replace(best=found[number][2]))
        if tried.missed <= layout.missed and tried.lacking <= layout.lacking + 1e-9:
            return tried
    return layout
