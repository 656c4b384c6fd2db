"""The trace of a home's passes: what each changed when the home is solved again."""

from __future__ import annotations

from typing import Any

from scenewright.core.passes import Pass, PassOptions, PassRun, PassTrace, tally_passes
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.home.composing.home_passes import HOME_PASSES
from scenewright.domains.home.composing.room_passes import ROOM_PASSES
from scenewright.domains.home.solving import solve

PASSES: tuple[Pass[Any], ...] = (*ROOM_PASSES, *HOME_PASSES)


def trace_passes(solution: Solution, plan: Plan) -> PassTrace:
    """What each pass changes when the brief of a solution is solved again with its preset, solver
    and seed. Passes also run in drafts and further tries of a room: all of these are counted."""
    heard = list[PassRun]()
    again = solve(
        solution.brief,
        plan=plan,
        preset=solution.preset,
        solver=solution.solver,
        seed=solution.seed,
        passes=PassOptions(hear=heard.append),
    )
    return PassTrace(tally_passes(PASSES, heard), again.pieces == solution.pieces)
