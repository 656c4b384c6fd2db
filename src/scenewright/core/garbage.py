"""How often a process of ours looks for garbage in cycles.

Solving makes millions of small values and hardly a cycle; the tables and kernels it runs on are
large and stay. With the usual thresholds a tenth of the time goes into looking through them.
"""

from __future__ import annotations

import gc

THRESHOLDS = (50_000, 20, 50)
"""New values that bring on a look at the youngest, and looks that bring on one at older ones; 700,
10 and 10 unless set."""


def collect_rarely() -> None:
    """Look for garbage less often, in a process that does nothing but run Scenewright: the command
    line, workers of batches and benchmarks. A library leaves its host's settings alone.

    >>> before = gc.get_threshold()
    >>> collect_rarely()
    >>> gc.get_threshold()
    (50000, 20, 50)
    >>> gc.set_threshold(*before)
    """
    gc.set_threshold(*THRESHOLDS)
