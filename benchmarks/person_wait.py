"""How long a person waits for the next sheet: ``scenewright bench person_wait``.

Evolutions of a flat, a site and a hall as a person has them: she looks until the next candidates
are bred, says three things, and asks. Told are the seconds from asking to the screen, and to its
twelve pictures; and how long breeding took behind her back.
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
PATIENCE = 120.0
"""Seconds after which the person asks anyway."""


def records(quick: bool, progress: Callable[[float, str], None]) -> Iterator[dict[str, Any]]:
    """Records of waiting: the 95th percentile over screens."""
    cases = ("home-child",) if quick else CASES
    for number, case in enumerate(cases):
        progress(number / len(cases), case)
        waits = np.array(list(measure_waits(case, QUICK_SCREENS if quick else SCREENS)))
        for column, metric in enumerate(("next screen", "and its pictures", "bred meanwhile")):
            yield {
                "case": case,
                "metric": f"{metric}, 95th percentile",
                "unit": "s",
                "ours": round(float(np.percentile(waits[:, column], 95)), 3),
                "baseline": 1.0 if not column else None,
                "baseline_name": "what was asked" if not column else "",
                "ratio": round(float(np.percentile(waits[:, column], 95)), 3)
                if not column
                else None,
                "runs": len(waits),
            }


def measure_waits(case: str, screens: int) -> Iterator[tuple[float, float, float]]:
    """Seconds of every screen but the first: to the screen, to its pictures, of breeding."""
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
            asked = time.perf_counter()
            screen = evolution.ask()
            there = time.perf_counter()
            for one in screen.candidates:
                one.picture()
            yield there - asked, time.perf_counter() - asked, asked - began
