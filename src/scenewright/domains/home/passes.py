"""The passes of homes, and their trace: what each changed when the home is solved again."""

from __future__ import annotations

from typing import Any

from scenewright.core import passes
from scenewright.core.passes import Pass, PassTrace
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.home.composing.home_passes import HOME_PASSES
from scenewright.domains.home.composing.room_passes import ROOM_PASSES
from scenewright.domains.home.solving import solve

PASSES: tuple[Pass[Any], ...] = (*ROOM_PASSES, *HOME_PASSES)


def trace_passes(solution: Solution, plan: Plan) -> PassTrace:
    """What each pass changes, in drafts and further tries of a room too."""
    return passes.trace_passes(PASSES, solve, solution, plan)
