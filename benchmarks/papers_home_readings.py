"""Which reading of Liu et al. (2017) gives the figures they print: ``scenewright bench
papers_home_readings``.

Their algorithm leaves things open: what the first layouts are made of, whether headings are any
angle or quarter turns, what σ = 0.3 is a share of, how many genes a mutation changes, what C_max
is, whether parents survive, from where to where the distance of C5 goes. Here each is read
otherwise, alone and together, in their four living rooms. Annealing with the same first layouts,
headings and costs stands beside, as a reading is only right if it gives 52.74 for the genetic
algorithm (4000 layouts) *and* 1047.3 for annealing (one move in each of 500 iterations).
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from benchmarks.papers_home_rooms import ROOMS, case_of
from benchmarks.spread import Progress, SpreadTable, spread_tables
from scenewright.core.layout import corners
from scenewright.domains.home.encodings.boxes import gene_bounds, to_boxes
from scenewright.domains.home.energy import energies_of, prepare, route_grid
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers.paper_annealing import (
    DECAY,
    ITERATIONS,
    START,
    propose_layout,
)
from scenewright.domains.home.terms.orientation import NEAR, inward
from scenewright.engine.genetic import cross, roulette

Floats = NDArray[np.float64]
Row = dict[str, Any]
LIVING = ROOMS[:4]
RUNS, QUICK = 10, 1
AGAINST = "against_wall"
PRINTED = {"GA": (52.74, 43.2, 75.9), "annealing": (1047.3, 840.8, 1384.2)}
"""Mean, least and most of the paper's table 2."""


class Reading(NamedTuple):
    """One way to read what is not printed.

    ``start``: first layouts drawn at ``random``, with backs at ``walls``, or changed from ``one``
    of those, a gene in each. ``quarters``: headings are quarter turns. ``step`` is σ, of each
    gene's range if ``ranged``. ``every``: a mutation changes every gene with the printed
    probability, not one. ``late``: from which share of the generations steps are normal. ``limit``:
    the quantile of a generation's costs that is C_max. ``survive``: parents are drawn from too.
    ``back``: the distance of C5 is that of the ``middle`` of the back edge, of the nearest point of
    the ``edge`` or of the ``patch``; ``none``: there is no C5.
    """

    name: str
    start: str = "random"
    quarters: bool = False
    step: float = 0.3
    ranged: bool = False
    every: bool = False
    late: float = 0.5
    limit: float = 1.0
    survive: bool = False
    back: str = "middle"


AS_RUN = Reading("as we run it")
CHOSEN = AS_RUN._replace(limit=0.5, survive=True)
READINGS = (
    AS_RUN,
    AS_RUN._replace(name="quarter turns", quarters=True),
    AS_RUN._replace(name="σ a share of the range", ranged=True),
    AS_RUN._replace(name="σ = 0.03", step=0.03),
    AS_RUN._replace(name="every gene mutates", every=True),
    AS_RUN._replace(name="normal steps from the first", late=0.0),
    AS_RUN._replace(name="C_max the median", limit=0.5),
    AS_RUN._replace(name="parents survive", survive=True),
    CHOSEN._replace(name="both of these"),
    CHOSEN._replace(name="both, quarter turns", quarters=True),
    AS_RUN._replace(name="first layouts: changes of one", start="one"),
    AS_RUN._replace(name="first layouts: backs at walls", start="walls"),
    CHOSEN._replace(name="both, backs at walls", start="walls"),
    AS_RUN._replace(name="C5 of the back edge", back="edge"),
    AS_RUN._replace(name="C5 of the patch", back="patch"),
    CHOSEN._replace(name="both, backs at walls, C5 of the back edge", start="walls", back="edge"),
    AS_RUN._replace(name="without C5", back="none"),
)


Cost = Callable[[Floats], Floats]


def make_cost(problem: Problem, reading: Reading) -> Cost:
    """The printed cost (P,) of genes (P, n, 5), headings and C5 as they are read."""
    apart = reading.back != "middle"
    weights = {k: w for k, w in problem.weights.items() if not (apart and k == AGAINST)}
    prepared = prepare(problem._replace(weights=weights))
    grid, walls = route_grid(problem, 0.1), np.asarray(problem.ground.walls, np.float64)

    def cost(genes: Floats) -> Floats:
        boxes = to_boxes(turned(problem, reading, genes))
        rest: Floats = energies_of(prepared, grid, boxes)[0]
        if reading.back in ("middle", "none"):
            return rest
        gaps = wall_gaps(boxes, walls, reading.back)
        return rest + problem.weights[AGAINST] * gaps.sum(axis=-1)

    return cost


def wall_gaps(boxes: Floats, walls: Floats, back: str) -> Floats:
    """dis(P) of C5 of boxes (P, n, 5), the distance to walls (w, 4) being that of the nearest
    point of the back edge, or of the patch."""
    rings = corners(boxes).reshape(-1, 4, 2)
    edges = rings[:, [0, 3]] if back == "edge" else rings[:, [0, 1, 2, 3, 0]]
    lines = shapely.linestrings(walls.reshape(-1, 2, 2))
    far = shapely.distance(shapely.linestrings(edges)[:, None], lines).min(axis=1)
    found: Floats = np.where(far <= NEAR, 0.0, 1.0 - (NEAR / np.maximum(far, NEAR)) ** 2)
    return found.reshape(boxes.shape[:-1])


def turned(problem: Problem, reading: Reading, genes: Floats) -> Floats:
    """Genes whose headings are quarter turns from the main wall, if so read."""
    if not reading.quarters:
        return genes
    normal, quarter = float(inward(np.asarray(problem.ground.main_wall)[0])), 0.5 * math.pi
    found = genes.copy()
    found[..., 2] = normal + quarter * np.round((genes[..., 2] - normal) / quarter)
    return found


def first_layouts(problem: Problem, reading: Reading, count: int, rng: Any) -> Floats:
    """Genes (count, n, 5) to begin with."""
    low, high = gene_bounds(problem)
    drawn: Floats = rng.uniform(low, high, (count, *low.shape))
    if reading.start == "random":
        return drawn
    if reading.start == "walls":
        return np.stack([along_walls(problem, one, rng) for one in drawn])
    found = np.repeat(along_walls(problem, drawn[0], rng)[None], count, axis=0)
    item, gene = rng.integers(low.shape[0], size=count), rng.integers(5, size=count)
    rows = np.arange(count)
    found[rows, item, gene] = drawn[rows, item, gene]
    return found


def along_walls(problem: Problem, genes: Floats, rng: Any) -> Floats:
    """The patches of genes (n, 5) with their backs at walls drawn by length."""
    walls = np.asarray(problem.ground.walls, np.float64)
    along = walls[:, 2:] - walls[:, :2]
    length = np.hypot(*along.T)
    chosen = rng.choice(len(walls), len(genes), p=length / length.sum())
    found = genes.copy()
    headings = np.array([float(inward(walls[k])) for k in chosen])
    found[:, 2] = np.mod(headings - 0.5 * math.pi, 2.0 * math.pi)
    middle = walls[chosen, :2] + rng.random((len(genes), 1)) * along[chosen]
    back = np.column_stack([np.cos(found[:, 2]), np.sin(found[:, 2])])
    found[:, :2] = middle - 0.5 * genes[:, 3:4] * back
    return found


def genetic(problem: Problem, reading: Reading, seed: int) -> float:
    """The least cost the genetic algorithm finds: 40 layouts, 100 generations."""
    rng, (low, high) = np.random.default_rng(seed), gene_bounds(problem)
    cost = make_cost(problem, reading)
    genes = first_layouts(problem, reading, 40, rng)
    costs = cost(genes)
    for age in range(1, 100):
        parents = genes[draw(costs, reading, 40, rng)]
        children = cross(parents.reshape(40, -1), rng.random(20) < 0.9, rng).reshape(parents.shape)
        children = mutate(children, reading, age, low, high, rng)
        children[0] = genes[costs.argmin()]
        rated = cost(children)
        if reading.survive:
            children, rated = np.concatenate([children, genes]), np.concatenate([rated, costs])
            kept = np.append(rated.argmin(), draw(rated, reading, 39, rng))
            children, rated = children[kept], rated[kept]
        genes, costs = children, rated
    return float(costs.min())


def draw(costs: Floats, reading: Reading, count: int, rng: Any) -> NDArray[np.int64]:
    """Roulette on C_max - C, C_max being the quantile that is read; not below zero."""
    return roulette(np.minimum(costs, np.quantile(costs, reading.limit)), count, rng)


def mutate(
    genes: Floats, reading: Reading, age: int, low: Floats, high: Floats, rng: Any
) -> Floats:
    """One gene, or every, of a layout mutates with probability 0.85."""
    chosen = rng.random(genes.shape) < 0.85
    if not reading.every:
        one = rng.integers(low.size, size=len(genes))
        single = np.arange(low.size) == one[:, None]
        chosen = (single & (rng.random((len(genes), 1)) < 0.85)).reshape(genes.shape)
    fresh = rng.uniform(low, high, genes.shape)
    if age > reading.late * 100:
        scale = reading.step * (high - low) if reading.ranged else reading.step
        fresh = np.clip(genes + rng.normal(0.0, 1.0, genes.shape) * scale, low, high)
    found: Floats = np.where(chosen, fresh, genes)
    return found


def annealing(problem: Problem, reading: Reading, seed: int) -> float:
    """The least cost annealing finds from one first layout: 500 iterations of one move."""
    rng, (low, high) = np.random.default_rng(seed), gene_bounds(problem)
    cost = make_cost(problem, reading)
    now = first_layouts(problem, reading, 1, rng)[0]
    energy = least = float(cost(now[None])[0])
    for done in range(ITERATIONS):
        tried = propose_layout(now, low, high, rng)
        after = float(cost(tried[None])[0])
        heat = START * DECAY**done
        if after <= energy or rng.uniform() < math.exp((energy - after) / heat):
            now, energy = tried, after
        least = min(least, energy)
    return least


METHODS: dict[str, Callable[[Problem, Reading, int], float]] = {
    "GA": genetic,
    "annealing": annealing,
}


def run(reading: Reading, method: str, room: int, runs: int) -> list[float]:
    """The costs of one method in one living room."""
    problem = case_of(LIVING[room]).problem
    return [METHODS[method](problem, reading, seed) for seed in range(runs)]


def table(reading: Reading, method: str, rooms: int, runs: int) -> SpreadTable:
    """One reading by one method over the rooms."""
    jobs = [partial(run, reading, method, room, runs) for room in range(rooms)]
    return SpreadTable(reading.name, jobs, partial(_records, reading.name, method))


def _records(reading: str, method: str, found: list[list[float]]) -> Iterator[Row]:
    """The mean over the rooms, least and most, beside the paper's."""
    printed = PRINTED[method.partition(",")[0]]
    mean = statistics.fmean(statistics.fmean(costs) for costs in found)
    yield {
        "case": reading,
        "metric": f"{method}, printed cost",
        "unit": "cost",
        "ours": round(mean, 1),
        "baseline": printed[0],
        "baseline_name": "the paper's mean",
        "ratio": round(mean / printed[0], 3),
        "runs": sum(map(len, found)),
        "least": round(min(map(min, found)), 1),
        "most": round(max(map(max, found)), 1),
        "rooms": [round(statistics.fmean(costs), 1) for costs in found],
    }


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Row]:
    """Every reading by the three methods; ``quick`` takes one room, two readings and one run."""
    readings, rooms = (READINGS[:2], 1) if quick else (READINGS, len(LIVING))
    tables = [
        table(reading, method, rooms, QUICK if quick else RUNS)
        for reading in readings
        for method in METHODS
    ]
    yield from spread_tables(tables, progress, 1 if quick else None)


def markdown_lines(told: list[Row]) -> Iterator[str]:
    """A line for each reading: the mean of each method over the rooms, and by room."""
    yield "| reading | " + " | ".join(METHODS) + " | GA by room |"
    yield "|---" * (len(METHODS) + 2) + "|"
    for reading in dict.fromkeys(row["case"] for row in told):
        mine = [row for row in told if row["case"] == reading]
        cells = [f"{row['ours']:.0f} ({row['least']:.3g}–{row['most']:.4g})" for row in mine]
        rooms = ", ".join(f"{mean:.0f}" for mean in mine[0]["rooms"])
        yield f"| {reading} | {' | '.join(cells)} | {rooms} |"
