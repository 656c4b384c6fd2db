"""A hundred people rate layouts of one flat at once: ``scenewright bench raters``.

Each asks for a sheet, looks at it for a while, says which is best and which worst, and asks for the
next. All marks go through a project file, as in the studio. Times are those a rater waits, with the
processor seconds beside; what was said and is not in the file afterwards is lost.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from scenewright.engine.preference.events import Pick, Worst
from scenewright.formats import read
from scenewright.studio.people import People
from scenewright.workflow.evolution.log import EvolutionLog
from scenewright.workflow.evolution.raters import RaterPool
from scenewright.workflow.project import open_project

Record = dict[str, Any]
Progress = Callable[[float, str], None]
RATERS, QUICK = 100, 20
SHEETS, LOOK = 5, 20.0
"""Sheets of each, and seconds that a sheet is looked at, at most."""


class Waited(NamedTuple):
    """Seconds that the calls of one rater took, and how many marks she made."""

    asks: list[float]
    tells: list[float]
    marks: int


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """How long raters wait, and how many marks are lost."""
    if progress is not None:
        progress(0.0, "a pool of layouts")
    count = QUICK if quick else RATERS
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "flat.studio")
        people = People(open_project(path))
        number = people.begin_pool("flat")
        pool = RaterPool(
            read("sample:home-flat"),
            EvolutionLog(Path(folder, "flat.raters")),
            lambda *mark: people.keep(number, *mark),
        )
        pool.prepare()
        begun = time.process_time()
        with ThreadPoolExecutor(count) as workers:
            waited = [*workers.map(lambda k: rate(pool, k), range(count))]
        spent = time.process_time() - begun
        kept = [mark for mark in People(open_project(path)).marks(number) if mark.kind == "event"]
        pool.close()
    asks = [t for one in waited for t in one.asks]
    tells = [t for one in waited for t in one.tells]
    figures = {
        "ask, p95": (float(np.percentile(asks, 95)), "s"),
        "ask, median": (float(np.median(asks)), "s"),
        "tell, p95": (float(np.percentile(tells, 95)), "s"),
        "processor a sheet": (spent / len(asks), "s"),
        "marks lost": (sum(one.marks for one in waited) - len(kept), ""),
    }
    for metric, (value, unit) in figures.items():
        yield {
            "case": f"{count} raters",
            "metric": metric,
            "unit": unit,
            "ours": round(value, 4),
            "baseline": None,
            "baseline_name": "",
            "ratio": None,
            "runs": len(asks),
        }


def rate(pool: RaterPool, who: int) -> Waited:
    """One rater's sheets: she likes and dislikes by chance."""
    draw, waited = np.random.default_rng(who), Waited([], [], 2 * SHEETS)
    for _ in range(SHEETS):
        begun = time.perf_counter()
        shown = tuple(one.number for one in pool.ask(str(who)).candidates)
        waited.asks.append(time.perf_counter() - begun)
        time.sleep(float(draw.uniform(0.0, LOOK)))
        best, worst = (shown[k] for k in draw.permutation(len(shown))[:2])
        for mark in (Pick(best, shown), Worst(worst, shown)):
            begun = time.perf_counter()
            pool.tell(str(who), mark)
            waited.tells.append(time.perf_counter() - begun)
    return waited
