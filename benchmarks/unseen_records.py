"""Records of the counters of homes and halls nobody has looked at."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from benchmarks.composition_faults import Count

Record = dict[str, Any]
BEYOND = 0.1
"""Metres by which every threshold is moved in the second count."""


def add_up(counts: Iterable[Count]) -> Count:
    """Counts of several homes as one.

    >>> add_up([Count(1, 2), Count(0, 3)])
    Count(faulty=1, of=5)
    """
    listed = list(counts)
    return Count(sum(c.faulty for c in listed), sum(c.of for c in listed))


def make_record(
    case: str, metric: str, ours: float, runs: int, beyond: float | None = None
) -> Record:
    """One record; ``beyond`` is the share with the threshold moved."""
    return {
        "case": case,
        "metric": metric,
        "unit": "1",
        "ours": round(ours, 4),
        "baseline": None if beyond is None else round(beyond, 4),
        "baseline_name": "" if beyond is None else f"{BEYOND} m beyond",
        "ratio": None,
        "runs": runs,
    }
