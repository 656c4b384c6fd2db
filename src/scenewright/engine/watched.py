"""Reports of a solver as the best layouts of a space, for who watches a run."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from scenewright.core.layout import BestLayout, NamedBox, Watch
from scenewright.engine.solve import Progress, Report


def add_watch(
    progress: Progress | None,
    watch: Watch | None,
    space: str,
    rows: Callable[[Any], tuple[NamedBox, ...]],
) -> Progress | None:
    """A listener to a solver's reports that tells ``watch`` the best layout of ``space`` and passes
    every report on to ``progress``; ``rows`` makes rows of what the solver calls a layout.

    >>> listener = add_watch(None, lambda best: print(best.space, best.rows()), "hall", tuple)
    >>> listener(Report(0.5, 1.0, lambda: []))
    hall ()
    """
    if watch is None:
        return progress

    def hear(report: Report) -> None:
        watch(BestLayout(space, report.share, report.energy, lambda: rows(report.best())))
        if progress is not None:
            progress(report)

    return hear


def show(
    watch: Watch | None,
    space: str,
    rows: Callable[[], tuple[NamedBox, ...]],
    stage: str,
    reason: str = "",
) -> None:
    """Show a space as it stands after its search to who watches, if anybody does: at which
    ``stage``, and what changed it.

    >>> show(lambda best: print(best.stage, best.reason), "site", tuple, "routes", "no way leads")
    routes no way leads
    """
    if watch is not None:
        watch(BestLayout(space, 1.0, math.inf, rows, stage, reason))
