"""Halls at equal layouts and equal time: how many runs count, and which of them is taken."""

from __future__ import annotations

from typing import Any

from benchmarks.papers_halls_equal import PICKS, HallRun, compare_seeds, remember, within
from benchmarks.papers_halls_equal_tables import markdown_lines, page_lines

OURS = HallRun(None, 0.0, 0.0, 2500, 0.5)  # type: ignore[arg-type]
RUNS = [
    OURS._replace(own=own, excess=excess, layouts=1000, seconds=0.2)
    for own, excess in ((3.0, 9.0), (1.0, 8.0), (2.0, 7.0))
]


def faulty(run: HallRun) -> dict[str, Any]:
    """The run of the least own energy breaks a rule."""
    bad = run.own == 1.0
    return {"sound": not bad, "faults": float(bad)}


def test_no_more_layouts_or_seconds_count_than_ours_has() -> None:
    assert within(RUNS, OURS, "layouts") == within(RUNS, OURS, "seconds") == RUNS[:2]
    assert within(RUNS, OURS._replace(seconds=0.1), "seconds") == RUNS[:1]
    assert within(RUNS, OURS._replace(seconds=9.0), "seconds") == RUNS


def test_what_is_taken_of_several_runs() -> None:
    assert PICKS["own"](RUNS, faulty).own == 1.0
    assert PICKS["referee"](RUNS, faulty).own == 2.0
    assert PICKS["best"](RUNS[:2], faulty).excess == 9.0
    assert PICKS["referee"](RUNS[1:2], faulty).own == 1.0


def test_no_more_runs_are_judged_than_it_takes_and_each_once() -> None:
    asked: list[HallRun] = []

    def judge(run: HallRun) -> dict[str, Any]:
        asked.append(run)
        return faulty(run)

    known = remember(judge)
    for name in PICKS:
        PICKS[name](RUNS, known)
    assert [run.own for run in asked] == [1.0, 2.0]


def row(excess: float, aesthetic: float = 0.1) -> dict[str, float]:
    """The figures of a run."""
    told = {"valid": 1.0, "aesthetic": aesthetic, "uniformity": 0.1, "circulation": 1.0}
    return told | {"excess": excess, "seconds": 0.5, "runs": 1.0}


def test_tables_tell_where_ours_is_worse() -> None:
    found = {"default": row(8.0)}
    for name, excess in (("best", 7.5), ("referee", 9.0), ("own", 9.0)):
        found[f"paper, equal seconds, {name}"] = row(excess, 0.2)
    records = list(compare_seeds("sample:hall-shop", [found, found]))
    text = "\n".join(markdown_lines(records))
    assert "| shop: **ours** | 100% | 0.1000 |" in text
    assert "at equal time | 0 of 1 halls | |" in text
    assert "| 1 of 3 cells | shop aesthetic (paper) |" in text
    assert "| shop: paper · seconds · referee | 100% | 0.2000 |" in text
    assert "paper · seconds · own" in "\n".join(page_lines(records))
