"""How soon a home is solved again after one piece was moved, against solving all of it.

What makes each group on the floor is moved 0.3 m to its right, one after the other, each from the
same solved home. ``scenewright bench home_resolve``; warm, medians.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator
from math import cos, sin
from typing import Any

from benchmarks.comparison import ratio
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains import check, resolve, solve
from scenewright.domains.home.changes.edits import leads
from scenewright.formats import read

Record = dict[str, Any]
HOMES = ("sample:home-flat", "sample:home-house")
ASIDE = 0.3
AIM = 0.1
WHOLE_RUNS = 3


def records(quick: bool, progress: Callable[[float, str], None] | None = None) -> Iterator[Record]:
    """Seconds of solving again, share of the answers that are valid, for every home."""
    for number, name in enumerate(HOMES):
        if progress:
            progress(number / len(HOMES), name)
        yield from _of_home(name, quick)


def _of_home(name: str, quick: bool) -> list[Record]:
    brief = read(name)
    solve(brief)
    whole = [_timed(lambda: solve(brief, seed=0)) for _ in range(WHOLE_RUNS)]
    home = solve(brief, seed=0)
    movable = [p for p in home.pieces if leads(p) and not p.fixed][:: 4 if quick else 1]
    again, valid = [], 0
    for piece in movable:
        moved = {piece.id: _aside(piece)}
        try:
            resolve(home, move=moved)
        except ValueError:  # out of the home
            continue
        again.append(_timed(lambda: resolve(home, move=moved)))  # noqa: B023
        valid += _sound(resolve(home, move=moved))
    runs, took = len(again), statistics.median(again)
    slow = sorted(again)[int(0.9 * (runs - 1))]
    base = statistics.median(whole)
    return [
        _record(
            name,
            "solving again after one move",
            "s",
            took,
            base,
            f"solving all, {WHOLE_RUNS} runs",
            runs,
        ),
        _record(name, "the same, nine in ten", "s", slow, AIM, "aim", runs),
        _record(
            name,
            "answers in which nothing but the moved is wrong",
            "share",
            valid / runs,
            1.0,
            "aim",
            runs,
        ),
    ]


def _aside(piece: Piece) -> tuple[float, float]:
    x, y, _, heading = piece.pose
    return x + ASIDE * sin(heading), y - ASIDE * cos(heading)


def _sound(home: Solution) -> bool:
    """Whether the referee finds nothing but what concerns the moved group."""
    moved = {p.id for p in home.pieces if p.fixed}
    return all(f.given or {f.piece, f.other} & moved for f in check(home).findings)


def _timed(work: Callable[[], object]) -> float:
    started = time.perf_counter()
    work()
    return time.perf_counter() - started


def _record(
    case: str, metric: str, unit: str, ours: float, baseline: float, name: str, runs: int
) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": ours,
        "baseline": baseline,
        "baseline_name": name,
        "ratio": ratio(ours, baseline, unit),
        "runs": runs,
    }
