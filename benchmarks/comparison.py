"""Runs of two methods side by side, as a record of a benchmark."""

from __future__ import annotations

import statistics
from collections.abc import Collection
from typing import Any

Row = dict[str, Any]
LESS = ("s", "ms/flat", "MB")
"""Units of which less is better."""


def ratio(ours: float, baseline: float | None, unit: str) -> float | None:
    """How many times better ours is: baseline / ours of seconds and what else is better the less
    it is (:data:`LESS`), else ours / baseline. None without a baseline and where one divides by
    nothing. Units do not tell of faults or energies that less is better: their ratio is ours /
    baseline all the same.

    >>> ratio(0.5, 2.0, "s"), ratio(0.9, 0.6, "share"), ratio(3.0, 0.0, "1")
    (4.0, 1.5, None)
    """
    if baseline is None:
        return None
    over, under = (baseline, ours) if unit in LESS else (ours, baseline)
    return round(over / under, 4) if under else None


def figure(rows: list[Row], name: str, means: Collection[str]) -> float:
    """The mean over runs of a figure among ``means`` (shares, counts), the median of any other."""
    values = [float(row[name]) for row in rows]
    return statistics.fmean(values) if name in means else statistics.median(values)


def record(
    case: str,
    name: str,
    unit: str,
    ours: list[Row],
    theirs: list[Row],
    by: str,
    means: Collection[str],
) -> Row:
    """One figure of ours and of the method called ``by``, and their :func:`ratio`; ``runs`` is of
    both, or of ours, and the name of the method tells its own."""
    by = by if len(theirs) == len(ours) else f"{by}, {len(theirs)} runs"
    a, b = figure(ours, name, means), figure(theirs, name, means)
    return {
        "case": case,
        "metric": name.replace("_", " "),
        "unit": unit,
        "ours": round(a, 4),
        "baseline": round(b, 4),
        "baseline_name": by,
        "ratio": ratio(a, b, unit),
        "runs": len(ours),
    }
