"""Runs spread over processes: in order, whole, and ended when their reader goes away."""

from __future__ import annotations

import math
import operator
import os
from functools import partial

import pytest
from benchmarks.spread import SpreadTable, spread, spread_tables


def test_results_come_in_order_from_other_processes() -> None:
    jobs = [partial(math.factorial, n) for n in (300, 1, 2)]
    assert list(spread(jobs, 2)) == [math.factorial(300), 1, 2]
    assert os.getpid() not in spread([os.getpid, os.getpid], 2)


def test_tables_keep_their_runs_apart_and_progress_does_not_go_back() -> None:
    heard: list[tuple[float, str]] = []
    tables = [
        SpreadTable("sums", [partial(sum, (1, n)) for n in range(3)], lambda got: [{"n": got}]),
        SpreadTable("one", [partial(abs, -7)], lambda got: [{"n": got}]),
    ]
    found = list(spread_tables(tables, lambda share, name: heard.append((share, name)), workers=1))
    assert found == [{"n": [1, 2, 3]}, {"n": [7]}]
    assert heard == sorted(heard, key=operator.itemgetter(0))
    assert [name for _, name in heard] == ["sums"] * 3 + ["one"]


def test_what_was_measured_before_a_fault_is_kept() -> None:
    tables = [
        SpreadTable("good", [partial(abs, -1)], lambda got: [{"n": got}]),
        SpreadTable("bad", [partial(operator.truediv, 1, 0)], lambda got: [{"n": got}]),
    ]
    records = spread_tables(tables, workers=2)
    assert next(records) == {"n": [1]}
    with pytest.raises(ZeroDivisionError):
        next(records)
