"""Kernels made ready beforehand: one small run a kind of scene."""

from __future__ import annotations

from collections.abc import Callable

from scenewright import domains
from scenewright.core.solution import Solution
from scenewright.formats import read

SAMPLES = {
    "home": ("home-flat", "home-attic"),
    "hall": ("hall-reading-room", "hall-exhibition"),
    "site": ("site-30", "site-landmarks"),
    "village": ("village-hamlet",),
    "extend": ("extend-terrace",),
}
"""The briefs solved to compile a kind of scene."""
STEPS, FEW = 200, {"village": 2, "extend": 2}
"""How long, in steps; fewer where one makes a whole layout."""


def solve_briefly(kind: str, name: str, cancel: Callable[[], bool] | None = None) -> Solution:
    """A sample solved in as few steps as use every kernel of its kind, and judged."""
    brief = read(f"sample:{name}")
    solution = domains.solve(brief, steps=FEW.get(kind, STEPS), cancel=cancel)
    domains.check(solution)
    return solution
