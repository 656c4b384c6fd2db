"""The home benchmark: kernels against shapely and C, sample homes, the whole process, all methods.

``scenewright bench home`` takes a few minutes; ``--full`` also gives the methods a whole second
and takes more seeds and rooms, for most of an hour. Figures of speed are medians of several runs in
this process or of whole processes, ``runs`` of them; where nothing else does the same work the
baseline is the aim stated for it. The tables of all methods are printed in full by
``python -m benchmarks.home_methods``.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks import home_methods
from benchmarks.comparison import ratio
from benchmarks.home_kernel import bench_kernel
from benchmarks.plans_r2v import PLANS
from benchmarks.real_data import data_set
from benchmarks.shapely_home import bench_home
from benchmarks.stages import Stage, run_stages
from scenewright.domains import check
from scenewright.domains.home.solving import solve
from scenewright.formats import read, samples

Record = dict[str, Any]
Progress = Callable[[float, str], None]

DEMO = "sample:home-flat"
SUFFIXES = ("glb", "svg", "png", "json")


class Extent(NamedTuple):
    """How much is measured: runs of what is timed, seeds of each sample, seeds of each method on
    the instances, real rooms, and the budgets of methods."""

    runs: int
    sample_seeds: int
    method_seeds: int
    rooms: int
    budgets: tuple[str, ...]


QUICK = Extent(2, 2, 2, 0, ("4000 layouts",))
USUAL = Extent(5, 5, 5, 10, ("4000 layouts", "0.1 s"))
FULL = Extent(5, 20, 10, 50, tuple(home_methods.BUDGETS))


def records(
    quick: bool = False, progress: Progress | None = None, full: bool = False
) -> Iterator[Record]:
    """All records; ``quick`` leaves out the kernels against shapely and real rooms."""
    extent = QUICK if quick else FULL if full else USUAL
    home_methods.instances()  # whatever is missing is told before an hour's work
    if extent.rooms:
        data_set(PLANS)
    stages: list[Stage] = [
        ("solving the demo", lambda: bench_solving(extent.runs)),
        ("whole process", lambda: bench_process(extent.runs)),
        ("sample homes", lambda: bench_samples(extent.sample_seeds)),
    ]
    if not quick:
        stages.insert(0, ("kernels against C", lambda: map(dict, bench_kernel())))
        stages.append(("kernels and solvers", lambda: map(dict, bench_home(extent.runs))))
    stages.append(("methods", lambda: bench_methods(extent)))
    return run_stages(stages, progress)


def bench_methods(extent: Extent) -> Iterable[Record]:
    """All methods on the instances and on real rooms."""
    return home_methods.records(extent.method_seeds, extent.rooms, extent.budgets)


def bench_samples(seeds: int) -> Iterator[Record]:
    """Share of sample homes, over seeds, that the referee calls valid, and that are complete."""
    for name in (name for name in samples() if name.startswith("sample:home-")):
        reports = [check(solve(read(name), seed=seed)) for seed in range(seeds)]
        valid = sum(r.valid for r in reports) / seeds
        complete = sum(not r.notes for r in reports) / seeds
        yield _against(name, "valid homes", "share", valid, 1.0, seeds)
        yield _against(name, "complete homes", "share", complete, 1.0, seeds)


def bench_solving(runs: int) -> list[Record]:
    """Seconds of solving for the demo's home, warm."""
    brief = read(DEMO)
    solve(brief)
    taken = [solve(brief, seed=seed).seconds for seed in range(runs)]
    return [_against(DEMO, "solving, warm", "s", statistics.median(taken), 1.0, runs)]


def bench_process(runs: int) -> list[Record]:
    """Seconds of the whole command with all four files, warm and with an empty kernel cache, and
    the size of the GLB."""
    with tempfile.TemporaryDirectory() as folder:
        cold = _process(Path(folder))
        warm = statistics.median(_process(Path(folder)) for _ in range(runs))
        size = (Path(folder) / "home.glb").stat().st_size / 1e6
    return [
        _against(DEMO, "whole process, warm, four files", "s", warm, 3.0, runs),
        _against(DEMO, "compiling, first run only", "s", cold - warm, 15.0, 1),
        _against(DEMO, "size of the GLB", "MB", size, 5.0, 1),
    ]


def _against(case: str, metric: str, unit: str, ours: float, aim: float, runs: int) -> Record:
    """A figure beside its aim; the ratio says how many times better than the aim it is."""
    return Record(
        case=case,
        metric=metric,
        unit=unit,
        ours=ours,
        baseline=aim,
        baseline_name="aim",
        ratio=ratio(ours, aim, unit),
        runs=runs,
    )


def _process(folder: Path) -> float:
    outputs = [part for s in SUFFIXES for part in ("-o", str(folder / f"home.{s}"))]
    command = [sys.executable, "-m", "scenewright", "arrange", DEMO, *outputs, "--quiet"]
    started = time.perf_counter()
    subprocess.run(command, check=True, env=_environment(folder), capture_output=True)
    return time.perf_counter() - started


def _environment(folder: Path) -> dict[str, str]:
    return {**os.environ, "NUMBA_CACHE_DIR": str(folder / "kernels")}
