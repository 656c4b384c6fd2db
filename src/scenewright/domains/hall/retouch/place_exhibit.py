"""The main exhibit where it belongs, and all else settled round it.

Amid its zone it stands in the middle of what the search has laid out there: pushing that aside
leaves a ruin, so what gave way is annealed from there, cold, before the two are compared.
"""

from __future__ import annotations

import numpy as np

from scenewright.arranging.verdict import better
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.retouch import retouch_named
from scenewright.domains.hall.retouch.loop import judge_layout
from scenewright.domains.hall.retouch.mending import LEAST, SeenTouch, weigh_layout, weigh_proposals
from scenewright.domains.hall.search import HallSearch, weigh_wrong
from scenewright.domains.hall.solvers.chains import begin_chain, cooled_hall, layout_of
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget

WORTH_MOVING, BETTER = 2.0, 0.5
"""Metres of fault from which on it is worth it, and the part of it that has to be left at most."""
SETTLED, STEPS = 8, 4000
"""How many layouts settle at most until one is better, and in how many steps."""


def place_exhibit(search: HallSearch, fitted: Fitted, layout: MeasuredLayout) -> MeasuredLayout:
    """The layout with its main exhibit in its place, where that costs less with the fault and
    leaves nothing out of reach."""
    problem, touch = fitted.problem, retouch_named("exhibit")
    one = SeenTouch(touch, touch.look(problem))
    if (
        layout.loose
        or not len(layout.boxes)
        or one.fault(layout.kept, layout.boxes) <= WORTH_MOVING
    ):
        return layout
    chain = begin_chain(problem, layout.kept, streams(0, 1)[0])
    now = weigh_layout(chain, one, layout.kept)
    every = weigh_proposals(chain, one, now, [])
    most = BETTER * now.fault
    near = sorted(
        (p for p in every if np.isfinite(p.cost) and p.fault <= most), key=lambda p: p.cost
    )
    heavy, budget = weigh_wrong(problem), Budget(steps=STEPS, threads=search.budget.threads)
    touches = {"exhibit": one}
    verdict = judge_layout(chain, touches, layout.kept)
    for proposal in near[:SETTLED]:
        cooled = cooled_hall(heavy, proposal.kept, budget, search.seed).layouts[0]
        if better(judge_layout(chain, touches, cooled.kept), verdict, LEAST):
            return layout_of(begin_chain(problem, cooled.kept, streams(0, 1)[0]))
    return layout
