"""The home problem the way it is usually written: one shapely object a box.

The baseline of ``scenewright bench home``: the paper's seven costs as printed, the same genetic
algorithm on top, and the measurements of our kernels against it, in one run.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from typing import Any, TypedDict

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import affinity

from benchmarks.instances import read_instance
from scenewright.domains.home.encodings.boxes import gene_bounds, to_boxes
from scenewright.domains.home.energy import energies_of, evaluate, prepare, route_grid
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers import SOLVERS
from scenewright.domains.home.solvers.anneal import anneal
from scenewright.engine.genetic import GENERATIONS, PaperGenetic
from scenewright.engine.solve import Budget, BudgetWatch, run_population

Floats = NDArray[np.float64]
INSTANCES = ("living", "big")
BASELINE = "one shapely object a box"


class Record(TypedDict):
    """One measured figure: ours, the baseline's, and how many times better ours is."""

    case: str
    metric: str
    unit: str
    ours: float
    baseline: float
    baseline_name: str
    ratio: float
    runs: int


def record(
    case: str,
    metric: str,
    unit: str,
    ours: list[float],
    baseline: list[float],
    name: str,
    statistic: Callable[[list[float]], float] = statistics.median,
) -> Record:
    """Medians (or means) of the runs and their ratio, the greater over the less; ``runs`` is of
    both, or of ours, and the name of the baseline tells its own."""
    name = name if len(baseline) == len(ours) else f"{name}, {len(baseline)} runs"
    a, b = float(statistic(ours)), float(statistic(baseline))
    ratio = a / b if unit.endswith("/s") else b / a
    return Record(
        case=case,
        metric=metric,
        unit=unit,
        ours=a,
        baseline=b,
        baseline_name=name,
        ratio=ratio,
        runs=len(ours),
    )


def rectangle(box: Floats) -> Any:
    """A box (5,) as a polygon."""
    x, y, heading, width, depth = box
    shape = shapely.box(-depth / 2, -width / 2, depth / 2, width / 2)
    return affinity.translate(affinity.rotate(shape, heading, (0, 0), use_radians=True), x, y)


class ShapelyHome:
    """The seven costs with one shapely object for each box, wall and zone."""

    def __init__(self, problem: Problem) -> None:
        ground = problem.ground
        self.items, self.weights = problem.items, problem.weights
        self.room = shapely.Polygon(ground.edges[:, :2])
        self.walls = [shapely.LineString(wall.reshape(2, 2)) for wall in ground.walls]
        self.keep_free = [rectangle(box) for box in ground.keep_free]
        wall = ground.main_wall[0]
        self.normal = np.arctan2(wall[2] - wall[0], wall[1] - wall[3])

    def areas(self, shapes: list[Any]) -> tuple[float, float, float, float]:
        """Summed area, and C1, C2, C3 in square metres."""
        total = sum(shape.area for shape in shapes)
        outside = sum(shape.difference(self.room).area for shape in shapes)
        shared = sum(a.intersection(b).area for k, a in enumerate(shapes) for b in shapes[:k])
        kept = sum(a.intersection(b).area for a in shapes for b in self.keep_free)
        return total, outside, shared, kept

    def turning(self, boxes: Floats) -> float:
        """C4 as printed: the signed sum, unwrapped."""
        role, angle = self.items.main_wall, (boxes[:, 2] - self.normal) % (2 * np.pi)
        return float(abs((role * (angle - (role + 1) * np.pi / 2)).sum()))

    def backs(self, boxes: Floats) -> float:
        """C5 as printed: middle of the back edge to the nearest wall."""
        total = 0.0
        for box, belongs in zip(boxes, self.items.back_to_wall, strict=True):
            if belongs:
                front = np.array([np.cos(box[2]), np.sin(box[2])])
                point = shapely.Point(box[:2] - front * box[4] / 2)
                distance = min(wall.distance(point) for wall in self.walls)
                total += belongs * (0.0 if distance <= 0.1 else 1.0 - (0.1 / distance) ** 2)
        return total

    def pairs(self, shapes: list[Any], boxes: Floats) -> float:
        """C6 as printed: distance of centres and angle in [0, π]."""
        total = 0.0
        for (i, j), target in zip(self.items.pairs, self.items.pair_targets, strict=True):
            distance = shapes[i].centroid.distance(shapes[j].centroid)
            angle = abs((boxes[j, 2] - boxes[i, 2] + np.pi) % (2 * np.pi) - np.pi)
            total += abs(distance - target[0]) + abs(angle - target[1])
        return total

    def cost(self, boxes: Floats) -> float:
        """The weighted sum for one layout (n, 5)."""
        shapes = [rectangle(box) for box in boxes]
        total, outside, shared, kept = self.areas(shapes)
        share, weights = total / self.room.area, self.weights
        size = 1 - (share / 0.40) ** 2 if share < 0.40 else 0.0
        size = 1 - (0.55 / share) ** 2 if share > 0.55 else size
        areas = weights["boundary"] * outside + weights["overlap"] * shared
        areas += weights["keep_free"] * kept
        return float(
            areas / total
            + weights["main_wall"] * self.turning(boxes)
            + weights["against_wall"] * self.backs(boxes)
            + weights["pairs"] * self.pairs(shapes, boxes)
            + weights["size"] * size
        )

    def costs(self, population: Floats) -> Floats:
        """Costs (P,) of layouts (P, n, 5)."""
        return np.array([self.cost(boxes) for boxes in population])


def draw(problem: Problem, count: int, seed: int) -> Floats:
    """Random layouts (count, n, 5)."""
    low, high = gene_bounds(problem)
    return to_boxes(np.random.default_rng(seed).uniform(low, high, (count, *low.shape)))


def rate(work: Callable[[], object], amount: float, repeats: int) -> float:
    """Amount of work a second."""
    begun = time.perf_counter()
    for _ in range(repeats):
        work()
    return amount * repeats / (time.perf_counter() - begun)


def bench_evaluations(name: str, runs: int) -> Record:
    """Evaluations a second, population of 40."""
    problem = read_instance(name)
    home, population = ShapelyHome(problem), draw(problem, 40, 0)
    p, grid = prepare(problem), route_grid(problem, 0.1)
    assert np.allclose(home.costs(population), evaluate(problem, population))
    ours = [rate(lambda: energies_of(p, grid, population), 40, 100) for _ in range(runs)]
    theirs = [rate(lambda: home.costs(population), 40, 1) for _ in range(runs)]
    return record(name, "evaluations, population 40", "1/s", ours, theirs, BASELINE)


def bench_steps(name: str, runs: int) -> Record:
    """Annealing steps a second on one thread, against whole evaluations on shapely."""
    problem = read_instance(name)
    home, population = ShapelyHome(problem), draw(problem, 5, 0)
    ours = [
        rate(lambda: anneal(problem, Budget(steps=200_000), 0, threads=1), 200_000, 1)
        for _ in range(runs)
    ]
    theirs = [rate(lambda: home.costs(population), 5, 2) for _ in range(runs)]
    return record(name, "annealing steps, one thread", "1/s", ours, theirs, BASELINE)


def shapely_ga(problem: Problem, seed: int) -> tuple[float, float]:
    """The paper's genetic algorithm on shapely: final cost and seconds."""
    begun, home = time.perf_counter(), ShapelyHome(problem)
    low, high = gene_bounds(problem)
    _, costs, _ = run_population(
        PaperGenetic(),
        lambda genes: home.costs(to_boxes(genes.reshape(-1, len(low), 5))),
        low.ravel(),
        high.ravel(),
        np.random.default_rng(seed),
        BudgetWatch(Budget(), None, None),
        tuple,
        GENERATIONS,
    )
    return float(costs[0]), time.perf_counter() - begun


def bench_genetic(name: str, runs: int) -> Record:
    """The paper's genetic algorithm from start to end, ours against the same on shapely."""
    problem, paper = read_instance(name), SOLVERS["paper-ga"]
    ours, theirs = [], []
    for seed in range(max(runs // 2, 1)):
        theirs.append(shapely_ga(problem, seed)[1])
        for again in range(10):
            begun = time.perf_counter()
            paper.run(problem, Budget(), 10 * seed + again)
            ours.append(time.perf_counter() - begun)
    return record(name, "paper's GA, 40 x 100", "s", ours, theirs, f"same GA, {BASELINE}")


def bench_cost(name: str, seeds: int) -> Record:
    """Mean final cost over seeds: our default in 0.1 s against the paper's GA."""
    problem = read_instance(name)
    default, paper = SOLVERS["anneal"], SOLVERS["paper-ga"]
    ours = [default.run(problem, Budget(seconds=0.1), s).layouts[0].energy for s in range(seeds)]
    theirs = [paper.run(problem, Budget(), s).layouts[0].energy for s in range(seeds)]
    return record(
        name,
        "final cost, default in 0.1 s",
        "cost",
        ours,
        theirs,
        "paper's GA, 40 x 100",
        statistics.fmean,
    )


def bench_home(runs: int = 5, seeds: int = 20) -> list[Record]:
    """Every figure on both instances, warm."""
    for solver in ("anneal", "paper-ga"):
        SOLVERS[solver].run(read_instance("living"), Budget(steps=400), 0)
    return [
        measured
        for name in INSTANCES
        for measured in (
            bench_evaluations(name, runs),
            bench_steps(name, runs),
            bench_genetic(name, runs),
            bench_cost(name, seeds),
        )
    ]


if __name__ == "__main__":
    for row in bench_home():
        print(
            f"{row['case']:7} {row['metric']:30} {row['ours']:12.5g} {row['unit']:5}"
            f" against {row['baseline']:10.4g} ({row['baseline_name']}): {row['ratio']:.0f}x"
        )
