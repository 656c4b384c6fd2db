"""The trace of a hall's retouches: what each changed when the hall is solved again."""

from __future__ import annotations

from scenewright.core import passes
from scenewright.core.passes import PassTrace
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.hall.retouch import RETOUCHES
from scenewright.domains.hall.solving import solve


def trace_passes(solution: Solution, plan: Plan) -> PassTrace:
    """What each retouch changes; where a hall is laid out again, in every layout."""
    return passes.trace_passes(RETOUCHES, solve, solution, plan)
