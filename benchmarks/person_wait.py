"""How long a person waits for the next sheet: ``scenewright bench person_wait``.

Evolutions of a flat, a site and a hall as a person has them: she looks until the next candidates
are bred, says three things, and asks. Told are the seconds from asking to the screen, and to its
twelve pictures, by the clock and of the processor (what it takes by itself where other work shares
the machine); and how long breeding took behind her back.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from scenewright.engine.preference.events import Pick, Reason, Worst
from scenewright.workflow.evolve import evolve

CASES = ("home-flat", "site-30", "hall-shop")
SCREENS, QUICK_SCREENS = 20, 2
COLUMNS = (
    "next screen",
    "next screen, of the processor",
    "and its pictures",
    "and its pictures, of the processor",
    "bred meanwhile",
)
PATIENCE = 120.0
"""Seconds after which the person asks anyway."""


def records(quick: bool, progress: Callable[[float, str], None]) -> Iterator[dict[str, Any]]:
    """Records of waiting: the 95th percentile over screens."""
    cases = ("home-child",) if quick else CASES
    for number, case in enumerate(cases):
        progress(number / len(cases), case)
        waits = np.array(list(measure_waits(case, QUICK_SCREENS if quick else SCREENS)))
        for column, metric in enumerate(COLUMNS):
            yield {
                "case": case,
                "metric": f"{metric}, 95th percentile",
                "unit": "s",
                "ours": round(float(np.percentile(waits[:, column], 95)), 3),
                "baseline": 1.0 if column < 2 else None,
                "baseline_name": "what was asked" if column < 2 else "",
                "ratio": round(float(np.percentile(waits[:, column], 95)), 3)
                if column < 2
                else None,
                "runs": len(waits),
            }


def measure_waits(case: str, screens: int) -> Iterator[tuple[float, float, float, float, float]]:
    """Seconds of every screen but the first, in the order of :data:`COLUMNS`."""
    rng = np.random.default_rng(0)
    with evolve(f"sample:{case}") as evolution:
        screen = evolution.ask()
        for _ in range(screens):
            shown = tuple(one.number for one in screen.candidates)
            best, worst = rng.permutation(len(shown))[:2].tolist()
            evolution.tell(Pick(shown[best], shown), Worst(shown[worst], shown))
            evolution.tell(Reason(shown[best], next(iter(evolution.reasons))))
            began = time.perf_counter()
            while not evolution.ready() and time.perf_counter() - began < PATIENCE:
                time.sleep(0.01)
            asked, busy = time.perf_counter(), time.thread_time()
            screen = evolution.ask()
            there, worked = time.perf_counter() - asked, time.thread_time() - busy
            for one in screen.candidates:
                one.picture()
            seen, drawn = time.perf_counter() - asked, time.thread_time() - busy
            yield there, worked, seen, drawn, asked - began
