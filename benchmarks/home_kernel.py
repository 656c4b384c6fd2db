"""Our kernels against the same loops in C: the energy of a population of boxes.

``kernel.c`` is compiled with ``cc -O3 -march=native`` (numba too compiles for the processor it runs
on) where there is a compiler, else this part is skipped with a word. Both run in one thread, are
timed by that thread's processor time, and must agree to 1e-9 of the energy.
"""

from __future__ import annotations

import ctypes
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.instances import read_instance
from benchmarks.shapely_home import INSTANCES, Record, draw
from scenewright.domains.home.energy import fill_energies, prepare, route_grid
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.terms.assemble import make_costs
from scenewright.domains.home.terms.table import (
    AGAINST_WALL_PRINTED,
    BOUNDARY,
    KEEP_FREE,
    MAIN_WALL_PRINTED,
    OVERLAP,
    PAIRS_PRINTED,
    SIZE,
)
from scenewright.geometry.boxes import frames_of

Floats = NDArray[np.float64]
SOURCE = Path(__file__).with_name("kernel.c")
FLAGS = ("-O3", "-march=native", "-shared", "-fPIC")
WEIGHTS = (
    BOUNDARY,
    OVERLAP,
    KEEP_FREE,
    MAIN_WALL_PRINTED,
    AGAINST_WALL_PRINTED,
    PAIRS_PRINTED,
    SIZE,
)
POPULATION = 40
ALIKE = 1e-9


class Room(ctypes.Structure):
    """The structure of the same name in ``kernel.c``."""

    _fields_ = (
        *(
            (name, ctypes.c_void_p)
            for name in ("edges", "walls", "zones", "back", "role", "targets", "weights", "pairs")
        ),
        *((name, ctypes.c_double) for name in ("area", "normal")),
        *((name, ctypes.c_longlong) for name in ("edges_", "walls_", "zones_", "items_", "pairs_")),
    )


class Kernel(NamedTuple):
    """A way to fill energies (P,) of layouts (P, n, 5); ``keeps`` holds what it points to."""

    fill: Callable[[Floats, Floats], None]
    keeps: tuple[Any, ...]


def compile_c(folder: Path) -> Any:
    """The library made of ``kernel.c``; ``None`` where there is no C compiler."""
    compiler = shutil.which("cc")
    if compiler is None:
        return None
    library = folder / "kernel.so"
    command = [compiler, *FLAGS, str(SOURCE), "-o", str(library), "-lm"]
    subprocess.run(command, check=True, capture_output=True)
    return ctypes.CDLL(str(library))


def in_c(library: Any, problem: Problem) -> Kernel:
    """The energy of a printed problem by the C library."""
    p = prepare(problem)
    zones, traits = np.ascontiguousarray(p.zones[:, :8]), np.ascontiguousarray(p.traits[:, 1:3].T)
    weights, n = np.ascontiguousarray(p.weights[list(WEIGHTS)]), len(p.limits)
    arrays = (p.edges, p.walls, zones, traits[0], traits[1], p.targets, weights, p.pairs)
    frames = np.empty((n, 8))
    room = Room(
        *(a.ctypes.data for a in arrays),
        p.area,
        p.normal,
        len(p.edges),
        len(p.walls),
        len(zones),
        n,
        len(p.pairs),
    )
    pointer = ctypes.c_void_p

    def fill(population: Floats, found: Floats) -> None:
        library.energies(
            ctypes.byref(room),
            pointer(population.ctypes.data),
            ctypes.c_longlong(len(found)),
            pointer(frames.ctypes.data),
            pointer(found.ctypes.data),
        )

    return Kernel(fill, (library, room, arrays, frames))


def ours(problem: Problem) -> Kernel:
    """The energy of a problem by our kernels."""
    p, grid = prepare(problem), route_grid(problem, 0.1)
    costs = make_costs(1, len(p.limits), len(p.pairs))
    free, reached = np.empty_like(grid.free), np.empty_like(grid.free)

    def fill(population: Floats, found: Floats) -> None:
        routes = np.empty(len(found))
        frames = frames_of(population.reshape(-1, 5)).reshape(*population.shape[:2], 8)
        usual = np.zeros((0, 0))
        fill_energies(p, grid, frames, usual, found, routes, costs, free, reached)

    return Kernel(fill, ())


def seconds(kernel: Kernel, population: Floats, found: Floats, repeats: int) -> float:
    """Seconds of this thread for so many evaluations of a whole population."""
    begun = time.thread_time()
    for _ in range(repeats):
        kernel.fill(population, found)
    return time.thread_time() - begun


def compare(library: Any, name: str, runs: int, repeats: int = 200) -> Record:
    """Evaluations a second of both on one instance, in turns; raises where they do not agree."""
    problem = read_instance(name)
    population = np.ascontiguousarray(draw(problem, POPULATION, 0))
    mine, other = ours(problem), in_c(library, problem)
    a, b = np.empty(POPULATION), np.empty(POPULATION)
    mine.fill(population, a)
    other.fill(population, b)
    if not np.allclose(a, b, rtol=ALIKE, atol=0.0):
        raise AssertionError(f"{name}: energies differ by {np.abs(a / b - 1.0).max():.1e}")
    taken = [
        (seconds(mine, population, a, repeats), seconds(other, population, b, repeats))
        for _ in range(runs)
    ]
    made = POPULATION * repeats
    ratio = statistics.median(theirs / ours_ for ours_, theirs in taken)
    return Record(
        case=name,
        metric="evaluations, one thread",
        unit="1/s",
        ours=made / statistics.median(t[0] for t in taken),
        baseline=made / statistics.median(t[1] for t in taken),
        baseline_name=f"the same loops in C, {' '.join(FLAGS[:2])}",
        ratio=ratio,
        runs=runs,
    )


def bench_kernel(runs: int = 15) -> list[Record]:
    """Both instances; nothing, with a word, where there is no C compiler."""
    with tempfile.TemporaryDirectory() as folder:
        library = compile_c(Path(folder))
        if library is None:
            sys.stderr.write("no C compiler (cc) here: kernels are not compared with C\n")
            return []
        return [compare(library, name, runs) for name in INSTANCES]


if __name__ == "__main__":
    for row in bench_kernel():
        print(
            f"{row['case']:7} ours {row['ours']:12.0f}/s  C {row['baseline']:12.0f}/s"
            f"  ratio {row['ratio']:.2f}"
        )
