"""Runs that make whole layouts one after the other: reports from within the first."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from scenewright.engine.solve import BudgetWatch, Report

OnGrowth = Callable[[float, Callable[[], Any]], bool]
"""Gets the share of a layout that stands and what makes it as far as it is; whether to stop."""


def tell_growth(watch: BudgetWatch, done: int, steps: int | None) -> OnGrowth:
    """What a layout reports while it is made, ``done`` of ``steps`` others being complete (None:
    unknown). Only the first is reported, with an energy of infinity: later
    ones compete with one that is whole. Shares only rise; whether to stop is whether nobody waits.

    >>> from scenewright.engine.solve import Budget
    >>> shares = []
    >>> watch = BudgetWatch(Budget(steps=2), lambda one: shares.append(one.share), None)
    >>> tell = tell_growth(watch, 0, 2)
    >>> tell(0.5, tuple), tell(0.4, tuple), shares
    (False, False, [0.25, 0.25])
    """
    most = 0.0

    def tell(share: float, best: Callable[[], Any]) -> bool:
        nonlocal most
        if done == 0 and watch.progress is not None:
            most = max(most, min(share, 1.0) / steps if steps else 0.0, watch.share(0))
            watch.progress(Report(most, math.inf, best))
        return watch.cancelled()

    return tell
