"""What is shown of a candidate: its solution, a small picture, the plan to print, and figures."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright import domains
from scenewright.catalog.loading import catalog_of
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.drawing.svg import write_svg
from scenewright.engine.preference.trust import TrustRecord
from scenewright.render.picture import Pixels
from scenewright.render.plan_picture import draw_scene_plan
from scenewright.workflow.evolution.comparing import describe_differences

Floats = NDArray[np.float64]
SIDE = 320
"""Pixels across a small picture."""


class ShownCandidate(NamedTuple):
    """One layout on a screen: its number in the evolution, its solution and plan, and how much it
    would be liked, **predicted**: mean and standard deviation, in the unit of a choice (1 more: e
    times as likely to be picked), and with what chance it would be picked of those shown with it;
    none before anything was said; and whether the referee passes it (``valid``): ours are shown
    only then, a paper's method shows what it breeds."""

    number: int
    solution: Solution
    plan: Plan
    predicted: float | None = None
    deviation: float | None = None
    chance: float | None = None
    valid: bool = True

    def figures(self) -> dict[str, Any]:
        """What can be said of it in numbers; ``predicted`` is what the model expects, no more."""
        solution = self.solution
        figures: dict[str, Any] = {
            "candidate": self.number,
            "pieces": len(solution.pieces),
            "not placed": len(solution.left_out),
            "valid": self.valid,
        }
        if self.predicted is not None and self.deviation is not None and self.chance is not None:
            figures["predicted"] = round(self.predicted, 3)
            figures["predicted deviation"] = round(self.deviation, 3)
            figures["predicted chance"] = round(self.chance, 3)
        return figures | domains.features_of(solution, self.plan)

    def differences(self, other: ShownCandidate) -> list[str]:
        """In words what it is or has against another: pieces, places, what figures say."""
        figures = [domains.features_of(one.solution, one.plan) for one in (self, other)]
        return describe_differences(self.solution, other.solution, *figures)

    def faults(self) -> str:
        """What is to be marked on a sheet: that a rule is broken, and what has no place."""
        lacking = sum(out.required for out in self.solution.left_out)
        told = ("" if self.valid else "breaks a rule", f"lacks {lacking}" if lacking else "")
        return " · ".join(filter(None, told))

    def picture(self, side: int = SIDE) -> Pixels:
        """The plan as a small picture, ``side`` pixels across."""
        scene = domains.scene_of(self.solution, self.plan)
        return draw_scene_plan(scene, catalog_of(self.solution.brief.catalogs), side)

    def view(self, side: int = SIDE) -> Pixels:
        """A view of the scene from above at an angle, ``side`` pixels across."""
        from scenewright.formats.png import picture

        scene = domains.scene_of(self.solution, self.plan)
        return picture(scene, catalog_of(self.solution.brief.catalogs), side)

    def plan_svg(self) -> str:
        """The plan to print, as SVG text."""
        return write_svg(domains.draw_plan(self.solution, self.plan))


def predicted_shares(mean: Floats, deviation: Floats) -> Floats:
    """With what chance each of n layouts of predicted worth (n,) would be picked of them all; the
    less sure the worth, the more alike the chances (f / √(1 + πσ²/8), MacKay 1992).

    >>> predicted_shares(np.log([1.0, 3.0]), np.zeros(2)).round(2).tolist()
    [0.25, 0.75]
    >>> predicted_shares(np.log([1.0, 3.0]), np.full(2, 3.0)).round(2).tolist()
    [0.37, 0.63]
    """
    sure = 1.0 / np.sqrt(1.0 + np.pi * float(np.mean(deviation**2)) / 8.0)
    raised = np.exp(sure * (mean - mean.max()))
    shares: Floats = raised / raised.sum()
    return shares


class Screen(NamedTuple):
    """What is shown together: the screen's number from 0, the candidates in their places, which
    of them is the champion (by candidate number), and how far predictions may be trusted."""

    number: int
    candidates: tuple[ShownCandidate, ...]
    champion: int | None
    trust: TrustRecord
