"""Runs of two methods side by side, as a record of a benchmark."""

from __future__ import annotations

import statistics
from collections.abc import Collection
from typing import Any

Row = dict[str, Any]


def figure(rows: list[Row], name: str, means: Collection[str]) -> float:
    """The mean over runs of a figure among ``means`` (shares, counts), the median of any other."""
    values = [float(row[name]) for row in rows]
    return statistics.fmean(values) if name in means else statistics.median(values)


def record(
    case: str, name: str, unit: str, ours: list[Row], theirs: list[Row], by: str,
    means: Collection[str],
) -> Row:  # fmt: skip
    """One figure of ours and of the method called ``by``, and their ratio."""
    a, b = figure(ours, name, means), figure(theirs, name, means)
    return {
        "case": case, "metric": name.replace("_", " "), "unit": unit, "ours": round(a, 4),
        "baseline": round(b, 4), "baseline_name": by, "ratio": round(a / b, 4) if b else None,
        "runs": len(ours),
    }  # fmt: skip
