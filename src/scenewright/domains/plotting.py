"""Plots of open ground, by domain."""

from __future__ import annotations

from scenewright.core.plan import Plan
from scenewright.core.registry import domain_of
from scenewright.core.solution import Solution
from scenewright.domains import plan_of
from scenewright.ground.streetside.plots import Plot


def plots_of(solution: Solution, plan: Plan | None = None) -> tuple[Plot, ...]:
    """The plot of each dwelling of a village or extension: its ground to the middle of the gap to
    its neighbours and to its street, with its outbuildings; none in other domains.

    >>> import scenewright as sw
    >>> hamlet = sw.solve(sw.read("sample:village-hamlet"), preset="quick")
    >>> plots = sw.plots_of(hamlet)
    >>> all(plot.area > 40 for plot in plots)
    True
    """
    domain = domain_of(solution.brief.domain)
    if not domain.has("plots"):
        return ()
    found: tuple[Plot, ...] = domain.verb("plots")(solution, plan or plan_of(solution.brief))
    return found
