"""The trace of a hall's retouches: what each changed when the hall is solved again."""

from __future__ import annotations

from scenewright.core.passes import PassOptions, PassRun, PassTrace, tally_passes
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.hall.retouch import RETOUCHES
from scenewright.domains.hall.solving import solve


def trace_passes(solution: Solution, plan: Plan) -> PassTrace:
    """What each retouch changes when the brief of a solution is solved again with its preset,
    solver and seed; where a hall is laid out again, what was changed in every layout counts."""
    heard = list[PassRun]()
    again = solve(
        solution.brief,
        plan=plan,
        preset=solution.preset,
        solver=solution.solver,
        seed=solution.seed,
        passes=PassOptions(hear=heard.append),
    )
    return PassTrace(tally_passes(RETOUCHES, heard), again.pieces == solution.pieces)
