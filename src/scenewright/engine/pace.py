"""How a run is cut into slices: by steps or by the clock."""

from __future__ import annotations

import time
from collections.abc import Iterator


def pace_by_steps(steps: int, most: int) -> Iterator[tuple[int, float]]:
    """Slices of at most ``most`` steps and the share of all steps made after each.

    >>> list(pace_by_steps(10, 4))
    [(4, 0.4), (4, 0.8), (2, 1.0)]
    """
    for made in range(0, steps, most):
        yield min(most, steps - made), min(made + most, steps) / steps


def pace_by_clock(seconds: float, rate: float) -> Iterator[tuple[int, float]]:
    """Twelve slices in the given time (more in long ones: one each quarter of a second), or fewer
    if they take longer than ``rate`` foretells.

    The share follows the clock, so that a schedule always ends cold and in time.
    """
    begun, made, share = time.perf_counter(), 0, 0.0
    slices = max(12.0, seconds / 0.25)
    while share < 1.0:
        elapsed = time.perf_counter() - begun
        rate = made / elapsed if made else rate
        share = min(max(share, elapsed / max(seconds, 1e-6)) + 1.0 / slices, 1.0)
        steps = max(int(rate * seconds / slices), 16)
        made += steps
        yield steps, share
