"""The hall benchmark: ``scenewright bench hall``.

All samples by every method (:mod:`.hall_methods`), our time to the paper's quality, steps a second
against plain shapely (:mod:`.shapely_hall_steps`), each energy left out (:mod:`.hall_ablation`),
halls of up to 2000 objects (:mod:`.hall_scale`) and real malls (:mod:`.hall_malls`). ``ours`` and
``baseline`` are medians (means of shares and counts) over ``runs``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from benchmarks import hall_ablation, hall_malls, hall_methods, hall_scale
from benchmarks.shapely_hall_steps import bench_evaluations, bench_steps
from benchmarks.stages import Stage, run_stages

Record = dict[str, Any]
Progress = Callable[[float, str], None]

SAMPLE_SIZED = (1.0, 2.0)
"""Scales of the hall of :mod:`.hall_instances`: 38 and about 75 objects, as the samples."""


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """All records; ``quick`` takes two seeds, halls of up to 100 objects and no malls."""
    seeds = 2 if quick else 20
    stages: list[Stage] = [
        *((f"methods, {case}", partial(_methods, seeds, case)) for case in hall_methods.halls()),
        *(
            (f"time to quality, {case}", partial(hall_methods.quality, seeds, [case]))
            for case in hall_methods.halls()
        ),
        ("steps", lambda: bench_speed(2 if quick else 5)),
        ("ablation", lambda: bench_ablation(seeds)),
        ("scale", lambda: bench_scale(quick)),
    ]
    if not quick:
        stages.append(("malls", hall_malls.records))
    yield from run_stages(stages, progress)


def _methods(seeds: int, case: str) -> list[Record]:
    return hall_methods.summary(hall_methods.rows(seeds, [case]))


def bench_speed(runs: int) -> list[Record]:
    """Steps and whole energies a second of the compiled chain against shapely, one thread."""
    kinds = (bench_steps, bench_evaluations)
    return [dict(kind(scale, runs)) for scale in SAMPLE_SIZED for kind in kinds]


def bench_ablation(seeds: int) -> list[Record]:
    """Each energy left out, by the paper's preset and by our chains on the same energies."""
    found = [hall_ablation.rows(seeds, solver=solver) for solver in ("gd-mh", "anneal")]
    return [record for rows in found for record in hall_ablation.summary(rows)]


def bench_scale(quick: bool) -> list[Record]:
    """Steps and whole plans of growing halls."""
    sizes = hall_scale.SIZES[:2] if quick else hall_scale.SIZES
    return hall_scale.summary(hall_scale.rows(sizes, runs=1 if quick else 3))
