"""The set of sheets a solution is printed as: plans, elevations, schedule, pictures."""

from __future__ import annotations

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains import draw_levels
from scenewright.drawing.layers import PlanDrawing


def draw_set(solution: Solution, plan: Plan | None = None) -> tuple[PlanDrawing, ...]:
    """All sheets of a solution in order."""
    return draw_levels(solution, plan)
