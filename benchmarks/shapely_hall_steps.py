"""Graph-driven Metropolis-Hastings in plain Python, the layout judged whole on shapely each step.

The baseline of the steps a second: the moves of Cao, Cheng, Zhang 2024, 3.3, as one would first
write them down: change the pattern of a group, expand it, look at everything again.
"""

from __future__ import annotations

import math
import time
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.hall_instances import example_hall
from benchmarks.shapely_hall import Laid, ShapelyHall
from benchmarks.shapely_home import BASELINE, Record, rate, record, rectangle
from scenewright.domains.hall.energy import prepare
from scenewright.domains.hall.patterns import NUMBER, PATTERNS
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.chains import begin_chain, first_layout, gd_mh, layout_of
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget

Floats = NDArray[np.float64]
RATE, ITERATIONS = 0.1, 1000
RULES, SLACK = ("outside", "overlap", "blocked"), 1e-4
NAMES = tuple(PATTERNS)


class Group(NamedTuple):
    """A group as it stands: its pattern, middle and heading, and the gaps along and across its
    layers. A wall row stands ``x`` metres along the walls of its zone."""

    pattern: str
    x: float
    y: float
    heading: float
    layers: tuple[int, ...]
    along: float
    across: float


class Hall(NamedTuple):
    """All groups, and the generated walls (h, 5)."""

    groups: tuple[Group, ...]
    partitions: Floats


def local_places(group: Group, sizes: Floats) -> Floats:
    """x to the right, y ahead and turn (n, 3) of a group's objects."""
    wide, deep = sizes.max(axis=0)
    rows = []
    for k, number in enumerate(group.layers):
        for j in range(number):
            if group.pattern in ("radiation", "circulation", "fan"):
                sector = 2 * math.pi if group.pattern != "fan" else math.pi / 2
                radius = number * (wide + group.along) / sector + k * (deep + group.across)
                turn = sector * (j / number - 0.5)
                if group.pattern == "fan":
                    rows.append((radius * math.sin(turn), -radius * math.cos(turn), turn))
                else:
                    rows.append((-radius * math.sin(turn), radius * math.cos(turn), turn))
            else:
                x = (j - (number - 1) / 2) * (wide + group.along)
                y = ((len(group.layers) - 1) / 2 - k) * (deep + group.across)
                rows.append((x, y, 0.0))
    return np.array(rows)


def place(problem: HallProblem, unit: int, group: Group) -> Floats:
    """The boxes (n, 5) of a group's objects."""
    first, last = problem.units.spans[unit]
    sizes = problem.units.sizes[first:last]
    if group.pattern == "wall":
        return place_row(problem, unit, group, sizes)
    cos, sin = math.cos(group.heading), math.sin(group.heading)
    return np.array(
        [
            (group.x + sin * x + cos * y, group.y - cos * x + sin * y, group.heading + turn, w, d)
            for (x, y, turn), (w, d) in zip(local_places(group, sizes), sizes, strict=True)
        ]
    )


def place_row(problem: HallProblem, unit: int, group: Group, sizes: Floats) -> Floats:
    """A wall row, object by object along the zone's walls; around corners it goes on."""
    zone, rows = problem.units.zones[unit], []
    walls = [wall for wall in problem.ground.stretches if int(wall[4]) == zone]
    lengths = [math.hypot(wall[2] - wall[0], wall[3] - wall[1]) for wall in walls]
    t, k = group.x % sum(lengths), 0
    for width, depth in sizes:
        while t + width > lengths[k]:
            t, k = max(t - lengths[k], 0.0), (k + 1) % len(walls)
        x0, y0, x1, y1 = walls[k][:4]
        ux, uy = (x1 - x0) / lengths[k], (y1 - y0) / lengths[k]
        along, off = t + width / 2, depth / 2 + 0.003
        rows.append(
            (
                x0 + ux * along - uy * off,
                y0 + uy * along + ux * off,
                math.atan2(ux, -uy),
                width,
                depth,
            )
        )
        t += width + group.along
    return np.array(rows)


def boxes_of(problem: HallProblem, hall: Hall) -> Floats:
    """The boxes (n, 5) of all objects."""
    return np.vstack([place(problem, u, group) for u, group in enumerate(hall.groups)])


def judge(shapely_hall: ShapelyHall, problem: HallProblem, hall: Hall) -> dict[str, float]:
    """The hard rules, and every part of the energy if none is broken."""
    boxes, laid = (
        boxes_of(problem, hall),
        [Laid(g.pattern, g.heading, g.layers) for g in hall.groups],
    )
    shapes = [rectangle(box) for box in boxes]
    solids = [*shapely_hall.obstacles, *shapely_hall.keep_free, *map(rectangle, hall.partitions)]
    found = shapely_hall.violations(shapes, solids)
    if max(found[rule] for rule in RULES) > SLACK:
        return found
    return found | shapely_hall.energies(boxes, laid, hall.partitions, judged=False)


def layers_for(number: int, rows: int) -> tuple[int, ...]:
    """Rows that share so many objects."""
    rows = min(rows, number)
    return tuple(number // rows + (k < number % rows) for k in range(rows))


def draw_group(problem: HallProblem, unit: int, rng: np.random.Generator) -> Group:
    """A pattern the group may take, anywhere in its zone."""
    units, zone = problem.units, problem.units.zones[unit]
    pattern = NAMES[rng.choice(units.choices[unit].nonzero()[0])]
    first, last = units.spans[unit]
    rows = int(rng.integers(1, 4)) if pattern not in ("radiation", "circulation", "wall") else 1
    x0, y0, x1, y1 = problem.ground.zone_bounds[zone]
    turn = math.pi / 2 * int(rng.integers(4))
    x, y, layers = rng.uniform(x0, x1), rng.uniform(y0, y1), layers_for(int(last - first), rows)
    return Group(pattern, x, y, turn, layers, rng.uniform(0, 1), rng.uniform(0.5, 1.5))


def draw_hall(problem: HallProblem, shapely_hall: ShapelyHall, seed: int) -> Hall:
    """Groups at random, the largest first, each until it breaks no rule (or 500 times)."""
    rng, groups = np.random.default_rng(seed), {}
    areas = problem.units.sizes.prod(axis=1)
    order = sorted(
        range(len(problem.units.spans)), key=lambda u: -areas[slice(*problem.units.spans[u])].sum()
    )
    solids = shapely_hall.obstacles + shapely_hall.keep_free
    standing = list(solids)
    for unit in order:
        zone = shapely_hall.zones[problem.units.zones[unit]]
        for _ in range(500):
            groups[unit] = draw_group(problem, unit, rng)
            shapes = [rectangle(box) for box in place(problem, unit, groups[unit])]
            if all(zone.covers(s) or s.difference(zone).area < SLACK for s in shapes) and not any(
                s.intersection(o).area > SLACK
                for k, s in enumerate(shapes)
                for o in standing + shapes[:k]
            ):
                break
        standing += shapes
    return Hall(tuple(groups[u] for u in range(len(order))), np.zeros((0, 5)))


def move(
    problem: HallProblem, hall: Hall, parts: dict[str, float], size: float, rng: np.random.Generator
) -> Hall:
    """One of the paper's moves, chosen by which part of the energy is high."""
    if len(problem.ground.hosts) and (parts["access"] > 1.0 or rng.random() < 0.03):
        return hall._replace(partitions=move_partition(problem, hall.partitions, parts, rng))
    groups, count = list(hall.groups), len(hall.groups)
    name = max(("space", "fill", "proportion"), key=lambda row: parts[row] * rng.random())
    unit = int(rng.integers(count))
    if name != "fill":
        unit = max(range(count), key=lambda u: parts[f"{name}/{u}"] * rng.random())
    group, step = groups[unit], rng.random() * size * (-1.0 if name == "proportion" else 1.0)
    kind = rng.random()
    if kind < 0.05:
        groups[unit] = draw_group(problem, unit, rng)
    elif name != "space" or kind < 0.4:
        groups[unit] = group._replace(
            along=max(group.along + step, 0.0), across=max(group.across + step, 0.0)
        )
    elif kind < 0.8:
        groups[unit] = group._replace(
            x=group.x + rng.normal(0, size), y=group.y + rng.normal(0, size)
        )
    else:
        groups[unit] = group._replace(heading=group.heading + math.pi / 2)
    return hall._replace(groups=tuple(groups))


def move_partition(
    problem: HallProblem, partitions: Floats, parts: dict[str, float], rng: np.random.Generator
) -> Floats:
    """Take one wall away if passages are narrow, else build one on a border that may hold it."""
    if parts["access"] > 0.0 or len(partitions):
        return partitions[1:]
    x0, y0, x1, y1 = problem.ground.hosts[rng.integers(len(problem.ground.hosts)), :4]
    length = math.hypot(x1 - x0, y1 - y0)
    low, high = np.sort(rng.uniform(0.0, 1.0, 2))
    middle = (low + high) / 2
    return np.array(
        [
            [
                x0 + (x1 - x0) * middle,
                y0 + (y1 - y0) * middle,
                math.atan2(x1 - x0, y0 - y1),
                (high - low) * length,
                problem.ground.thickness,
            ]
        ]
    )


def metropolis(
    problem: HallProblem, seed: int, iterations: int = ITERATIONS
) -> tuple[Hall, float, float]:
    """The paper's loop: the best layout, its energy, and the steps a second."""
    rng, shapely_hall = np.random.default_rng(seed), ShapelyHall(problem)
    hall = best = draw_hall(problem, shapely_hall, seed)
    parts = judge(shapely_hall, problem, hall)
    if "total" not in parts:
        raise ValueError(f"no valid first layout with seed {seed}")
    least, begun = parts["total"], time.perf_counter()
    for i in range(iterations):
        size = max((iterations - i) / iterations, 0.5)
        tried = move(problem, hall, parts, size, rng)
        after = judge(shapely_hall, problem, tried)
        if "total" not in after:
            continue
        if rng.random() < math.exp(min(RATE * (parts["total"] - after["total"]), 0.0)):
            hall, parts = tried, after
        if parts["total"] < least:
            best, least = hall, parts["total"]
    return best, least, iterations / (time.perf_counter() - begun)


def bench_steps(scale: float, runs: int = 3) -> Record:
    """GD-MH steps a second, one chain on one thread, against the same moves on shapely."""
    problem = example_hall(scale)
    start, _ = first_layout(problem, np.zeros((len(problem.ground.hosts), 2)), 0)
    steps = 20_000
    gd_mh(problem, start, Budget(steps=100), 0)
    ours = [
        rate(lambda: gd_mh(problem, start, Budget(steps=steps), 0), steps, 1) for _ in range(runs)
    ]
    theirs = [metropolis(problem, 1, 100)[2] for _ in range(runs)]
    case = f"hall of {len(problem.units.sizes)} objects"
    return record(case, "GD-MH steps, one thread", "1/s", ours, theirs, BASELINE)


def bench_evaluations(scale: float, runs: int = 3) -> Record:
    """Whole energies a second, hard rules included, against shapely."""
    problem = example_hall(scale)
    start, _ = first_layout(problem, np.zeros((len(problem.ground.hosts), 2)), 0)
    chain, slow = begin_chain(problem, start, streams(0, 1)[0]), ShapelyHall(problem)
    boxes, laid = layout_of(chain).boxes, laid_of(problem, start)
    slow_parts = slow.energies(boxes, laid, np.zeros((0, 5)))
    assert np.isclose(slow_parts["total"], chain.tally[0])
    measure = partial(measure_all, chain.p, chain.s, chain.work)
    ours = [rate(measure, 1, 2000) for _ in range(runs)]
    theirs = [
        rate(partial(slow.energies, boxes, laid, np.zeros((0, 5))), 1, 3) for _ in range(runs)
    ]
    case = f"hall of {len(problem.units.sizes)} objects"
    return record(case, "whole energies, one thread", "1/s", ours, theirs, BASELINE)


def laid_of(problem: HallProblem, kept: Kept) -> list[Laid]:
    """How the units of a layout are laid out, for the slow reference."""
    spans, laid = prepare(problem).layer_spans, []
    for u, (row, _) in enumerate(spans):
        code, used = (int(v) for v in kept.rows[u])
        numbers = kept.layers[row : row + used, NUMBER]
        laid.append(Laid(NAMES[code], float(kept.pose[u, 2]), tuple(int(v) for v in numbers)))
    return laid


if __name__ == "__main__":
    for scale in (1.0, 4.0):
        for row in (bench_evaluations(scale), bench_steps(scale)):
            print(
                f"{row['case']:20} {row['metric']:28} {row['ours']:12.5g} {row['unit']}"
                f" against {row['baseline']:8.4g} ({row['baseline_name']}): {row['ratio']:.0f}x"
            )
