"""How long a person waits for sheets in the studio: ``scenewright bench sheets``.

A scene of each kind is bred as on the page: from *Breed* to the first layouts and to the first
twelve; then she marks the best and the worst of every sheet, looks for :data:`LOOK` seconds, and
asks for the next. All is drawn. Beside the seconds by the clock are those of the processor between
asking and the drawn sheet, what is bred meanwhile included; how many layouts were solved; and the
memory of the process once all these evolutions are open, ``--full`` as many as twenty people have.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from scenewright.formats import read
from scenewright.studio.breeding import FIRST_LOOK, Breeding
from scenewright.studio.shapes import Shapes

Record = dict[str, Any]
Progress = Callable[[float, str], None]
SCENES = (
    "home-flat",
    "hall-shop",
    "site-square",
    "site-landmarks",
    "village-street",
    "extend-court",
)
LATER, QUICK = 4, 1
"""Later sheets of each scene."""
LOOK, PATIENCE = 5.0, 0.01
SESSIONS = 20
GOALS = {"first four": 3.0, "first twelve": 10.0, "later sheet, slowest": 1.0}


class Waits(NamedTuple):
    """Seconds by the clock and of the processor until the first layouts, until the first sheet, and
    for every later sheet; how many layouts were solved."""

    four: tuple[float, float]
    twelve: tuple[float, float]
    later: list[tuple[float, float]]
    solved: int


def records(
    quick: bool = False, progress: Progress | None = None, full: bool = False
) -> Iterator[Record]:
    """How long each sheet takes, and the memory of all evolutions together."""
    begun, kept = read_memory(), list[Breeding]()
    for number, name in enumerate(SCENES[:1] if quick else SCENES):
        if progress is not None:
            progress(number / len(SCENES), name)
        waits, breeding = measure(name, QUICK if quick else LATER)
        kept.append(breeding)
        yield from describe(name, waits)
    while full and len(kept) < SESSIONS:
        kept.append(measure(SCENES[len(kept) % len(SCENES)], 1)[1])
    case = f"{len(kept)} evolutions open"
    yield make_record(case, "memory of the process", "MB", read_memory(), None, len(kept))
    yield make_record(case, "memory before", "MB", begun, None, 1)
    for breeding in kept:
        breeding.close()


def measure(name: str, later: int, look: float = LOOK) -> tuple[Waits, Breeding]:
    """The sheets of one scene, and its evolution, still open."""
    breeding, brief = Breeding(None, lambda _event: None, Shapes()), read(f"sample:{name}")
    since = time.perf_counter(), time.process_time()

    def spent() -> tuple[float, float]:
        return time.perf_counter() - since[0], time.process_time() - since[1]

    breeding.begin(brief)
    while breeding.running and len(breeding.early) < FIRST_LOOK:
        time.sleep(PATIENCE)
    four = spent()
    _draw_sheet(breeding)
    waits = Waits(four, spent(), [], 0)
    for number in range(later):
        breeding.say("3", number)
        breeding.say("worst 5", number)
        time.sleep(look)
        since = time.perf_counter(), time.process_time()
        breeding.next()
        _draw_sheet(breeding)
        waits.later.append(spent())
    assert breeding.evolution is not None
    return waits._replace(solved=breeding.evolution.size()), breeding


def _draw_sheet(breeding: Breeding) -> None:
    """Wait for a sheet and draw it."""
    while breeding.running:
        time.sleep(PATIENCE)
    breeding.draw([one["number"] for one in breeding.state()["shown"]])


def describe(name: str, waits: Waits) -> Iterator[Record]:
    """The records of one scene."""
    later = np.array(waits.later)
    figures = {
        "first four": waits.four,
        "first twelve": waits.twelve,
        "later sheet, median": tuple(np.median(later, axis=0).tolist()),
        "later sheet, slowest": tuple(later.max(0).tolist()),
    }
    for metric, (clock, processor) in figures.items():
        runs = len(later) if metric.startswith("later") else 1
        yield make_record(name, metric, "s", clock, GOALS.get(metric), runs)
        yield make_record(name, f"{metric}, of the processor", "s", processor, None, runs)
    yield make_record(name, "layouts solved", "", float(waits.solved), None, 1 + len(later))


def make_record(
    case: str, metric: str, unit: str, ours: float, goal: float | None, runs: int
) -> Record:
    """One record, beside what is asked for, if anything is."""
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(ours, 3),
        "baseline": goal,
        "baseline_name": "" if goal is None else "what is asked for",
        "ratio": None if goal is None else round(ours / goal, 3),
        "runs": runs,
    }


def read_memory() -> float:
    """Megabytes that the process holds, as Linux tells them."""
    for line in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1000.0
    raise RuntimeError("Linux tells no memory")
