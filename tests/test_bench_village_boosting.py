"""The net against boosting: differences with intervals, and what is not told apart."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.village_boosting import FAR, compare_methods, interval_of, markdown_lines

from scenewright.core.errors import InputError


def rows_of(gap: float, spread: float) -> dict[str, np.ndarray]:
    """Forty houses where the net has ``gap`` more nats than boosting, give or take ``spread``."""
    rng = np.random.default_rng(1)
    base = np.column_stack([rng.normal(0, 1, 40), np.full(40, 5.0), np.full(40, np.inf)])
    net = base + [[gap, 0.0, 0.0]] + spread * rng.normal(size=(40, 1)) * [[1.0, 0.0, 0.0]]
    return {"net": net, "boosting": base, "proposals": base}


def test_an_interval_holds_the_mean_and_narrows_with_more_houses() -> None:
    few, many = (interval_of(np.random.default_rng(2).normal(0, 1, n).tolist()) for n in (20, 500))
    for one in (few, many):
        assert one.low < one.mean < one.high
    assert many.high - many.low < few.high - few.low


@pytest.mark.parametrize(("gap", "spread", "apart"), [(1.0, 0.2, True), (0.02, 1.0, False)])
def test_what_differs_by_less_than_its_interval_is_not_told_apart(gap, spread, apart) -> None:
    told = list(compare_methods("all seeds", [rows_of(gap, spread)]))
    nats = told[0]
    assert nats["told_apart"] == apart
    assert nats["low"] <= nats["gap"] <= nats["high"]
    (line,) = [line for line in markdown_lines(told) if "net less boosting" in line]
    assert ("≈" in line.split("|")[3]) == (not apart)


def test_what_names_no_place_counts_as_far_and_boosting_is_needed() -> None:
    told = list(compare_methods("all seeds", [rows_of(0.0, 0.1)]))
    assert told[2]["ours"] == FAR
    with pytest.raises(InputError, match="scikit-learn"):
        list(compare_methods("a", [{"net": np.zeros((2, 3)), "proposals": np.zeros((2, 3))}]))
