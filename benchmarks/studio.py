"""What the page of the studio promises, measured: ``scenewright bench studio``.

Five kinds of scene on a warm server, in headless Chromium where it is a matter of the screen
(``pip install 'scenewright[browser]'``; Linux). What is seen on the screen is clock time on this
machine with all that runs beside it; processor time is told where it can be. Of several runs the
95th percentile counts.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from benchmarks import edits
from benchmarks.page_tables import tell_machine
from benchmarks.stages import Record, run_stages
from benchmarks.studio_cancel import end_early, list_work
from benchmarks.studio_page import PageFigures, browsing, measure_page, serving, visit
from benchmarks.studio_runs import measure_sessions, measure_telling
from scenewright.core.extras import require

Progress = Callable[[float, str], None]
SCENES = ("home-flat", "hall-shop", "site-square", "village-hamlet", "extend-terrace")
SMALL = ("home-room", "hall-shop")
"""What is measured in a hurry."""


class Much(NamedTuple):
    """How often each figure is measured: arrangements, visits and pairs of drags on the page;
    seeds of searches that are told; nudges; moments of stopping; sessions held at once."""

    runs: int
    seeds: int
    nudges: int
    moments: int
    sessions: int


QUICK, USUAL, FULL = Much(1, 1, 1, 2, 2), Much(4, 2, 5, 6, 20), Much(12, 6, 12, 12, 20)
QUICKLY_JUDGED = ("home", "village")
"""Kinds whose findings are to be there within 50 ms of a move; 100 ms in others."""


def records(
    quick: bool = False, progress: Progress | None = None, full: bool = False
) -> Iterator[Record]:
    """All figures of the page and what is below it, each with its goal."""
    require("playwright")
    scenes, much = SMALL if quick else SCENES, QUICK if quick else FULL if full else USUAL
    stages = [
        ("the page", partial(_measure_pages, scenes, much.runs)),
        *((f"telling, {name}", partial(_measure_telling, name, much.seeds)) for name in scenes),
        *((f"changes, {name}", partial(_measure_edits, name, much.nudges)) for name in scenes),
        *((f"stopping, {name}", partial(_measure_ends, name, much.moments)) for name in scenes),
        ("memory", partial(_measure_memory, scenes, much.sessions)),
    ]
    machine = f"{tell_machine()} with {os.getloadavg()[1]:.0f} programs at work"
    for row in run_stages(stages, progress):
        yield row | {"machine": machine}


def _measure_pages(scenes: Iterable[str], runs: int) -> Iterator[Record]:
    with serving() as served, browsing() as browser:
        yield _row("all", "the studio prints its link", served.seconds, "s", None, 1)
        page = visit(browser)
        page.goto(served.link)
        for name in scenes:
            yield from _tell_page(name, measure_page(page, browser, served, name, runs))


def _tell_page(name: str, found: PageFigures) -> Iterator[Record]:
    runs, kind = found.runs, name.partition("-")[0]
    soon = 0.05 if kind in QUICKLY_JUDGED else 0.1
    times = {
        "page usable": (found.page, 3.0),
        "first boxes on the screen": ([run.boxes for run in runs], 0.3),
        "first furniture on the screen": ([run.furniture for run in runs], 1.0),
        "silence before the layout": ([run.silence for run in runs], 0.5),
        "findings while dragging": (found.judged, soon),
        "change settled": (found.edited, 0.25),
        "arranged and on the screen": ([run.done for run in runs], None),
    }
    for metric, (seconds, goal) in times.items():
        if seconds:
            yield _row(name, metric, _late(seconds), "s", goal, len(seconds))
    spent = [run.processor for run in runs]
    yield _row(name, "arranged, processor of the server", _late(spent), "s", None, len(spent))
    share = _late([run.silence / run.done for run in runs])
    yield _row(name, "silence by the whole run", share, "share", None, len(runs))
    for metric, sizes, goal in (
        ("a layout while searched, most", found.layouts, 5000),
        ("a change, most", found.told, 3000),
        ("first visit with the 3D view", [found.first], 600_000),
    ):
        if sizes:
            yield _row(name, metric, max(sizes), "bytes", goal, len(sizes))


def _measure_telling(name: str, seeds: int) -> Iterator[Record]:
    found = measure_telling(name, seeds)
    yield _row(name, "cost of telling, processor", found.ratio, "ratio", 1.1, seeds)
    yield _row(name, "silence before the layout, processor", found.silence, "s", 0.5, seeds)


def _measure_edits(name: str, nudges: int) -> Iterator[Record]:
    for row in edits.measure(name, nudges):
        yield row | {"metric": f"{row['metric']}, processor"} if row["unit"] == "ms" else row


def _measure_ends(name: str, moments: int) -> Iterator[Record]:
    for what, seconds, work in list_work(name):
        found = end_early(work, moments, seconds)
        for metric, ms in (("processor", found.processor), ("clock", found.clock)):
            yield _row(name, f"{what} stopped, {metric}", ms, "ms", 200, found.times)
        if what == "arrange":
            yield _row(name, "stopped at once, said to be whole", found.whole, "", 0, 1)


def _measure_memory(scenes: Iterable[str], sessions: int) -> Iterator[Record]:
    for metric, size in measure_sessions([*scenes], sessions).items():
        what = {"VmRSS": "memory", "VmHWM": "memory at most"}[metric]
        yield _row(f"{sessions} sessions", what, size, "MB", 600, sessions)


def _late(values: Iterable[float]) -> float:
    return float(np.quantile([*values], 0.95))


def _row(
    case: str, metric: str, value: float, unit: str, goal: float | None, runs: int
) -> dict[str, Any]:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(value, 3 if value < 10 else 0),
        "baseline": goal,
        "baseline_name": "" if goal is None else "goal",
        "ratio": None if not goal else round(value / goal, 3),
        "runs": runs,
    }


ON_PAGE = (
    "page usable",
    "first boxes on the screen",
    "first furniture on the screen",
    "silence before the layout",
    "silence before the layout, processor",
    "cost of telling, processor",
    "findings while dragging",
    "judged while dragging, p95, processor",
    "change settled",
    "edit, p95, processor",
    "changed by a nudge beside its group, most",
    "a layout while searched, most",
    "a change, most",
    "first visit with the 3D view",
    "arrange stopped, processor",
    "arrange again stopped, processor",
    "breed stopped, processor",
)
"""The figures of the documentation."""


def page_lines(rows: list[Record]) -> Iterator[str]:
    """The table of the documentation: a column a kind of scene, the goal last."""
    cases = list(dict.fromkeys(row["case"] for row in rows if "-" in row["case"]))
    yield f"| | {' | '.join(cases)} | goal |"
    yield "|---|" + "---|" * (len(cases) + 1)
    found = {(row["case"], row["metric"]): row for row in rows}
    for metric in ON_PAGE:
        mine = [found.get((case, metric)) for case in cases]
        unit = next(row["unit"] for row in mine if row)
        goals = dict.fromkeys(f"{row['baseline']:g}" for row in mine if row and row["baseline"])
        cells = ["–" if row is None else f"{row['ours']:g}" for row in mine]
        yield f"| {metric}, {unit} | {' | '.join(cells)} | {' to '.join(goals) or '–'} |"
    yield ""
    others = [row for row in rows if row["case"] not in cases]
    yield (
        "; ".join(
            f"{row['case']}: {row['metric']} {row['ours']:g} {row['unit']}"
            + (f" (goal {row['baseline']:g})" if row["baseline"] else "")
            for row in others
        )
        + "."
    )
