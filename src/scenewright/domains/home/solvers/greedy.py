"""Greedy placement: the largest item first, each where it costs least beside those that stand.

What a shop assistant does with paper cut-outs: try every corner, along every wall, and where its
partners want it; keep the best; never take back. Tried sizes are the preferred and the least.

One pass is quick, so while the budget lasts more follow with the order shaken, and the best pass
is kept (greedy randomised search, Feo and Resende 1995). How many places a pass looks at follows
the sequence 1, 1, 2, 1, 1, 2, 4, … of Luby, Sinclair and Zuckerman (1993), whatever the budget: a
larger budget goes on where a smaller one ends, so its answer is never worse.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from itertools import count
from typing import NamedTuple

import numpy as np

from scenewright.core.layout import Layout
from scenewright.domains.home.energy import energies_of, prepare, route_grid
from scenewright.domains.home.problem import Items, Problem
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress, distinct
from scenewright.geometry.boxes import Floats

HASTE = 4  # places looked at for one item once the run is cancelled


class Pass(NamedTuple):
    """Boxes (n, 5) of one pass and how many layouts it looked at."""

    boxes: Floats
    looked: int


def select_items(items: Items, order: list[int]) -> Items:
    """Some of the items, in the given order, with the relations among them."""
    place = {item: k for k, item in enumerate(order)}
    kept = [r for r, (i, j) in enumerate(items.pairs) if int(i) in place and int(j) in place]
    whole = ("pairs", "pair_targets", "pair_weights", "placed", "places", "spots")
    arrays = {name: values[order] for name, values in items._asdict().items() if name not in whole}
    pairs = np.array([[place[int(i)], place[int(j)]] for i, j in items.pairs[kept]], np.int64)
    here = [k for k, item in enumerate(items.placed) if int(item) in place]
    return Items(
        **arrays,
        pairs=pairs.reshape(-1, 2),
        pair_targets=items.pair_targets[kept],
        pair_weights=items.pair_weights[kept],
        placed=np.array([place[int(items.placed[k])] for k in here], np.int64),
        places=items.places[here],
        spots=items.spots,
    )


def along_walls(walls: Floats, width: float, depth: float, step: float) -> Floats:
    """Boxes (k, 5) with their back flush to a wall: in both corners and every ``step`` metres
    between."""
    found = [np.empty((0, 5))]
    for x0, y0, x1, y1 in walls:
        length = math.hypot(x1 - x0, y1 - y0)
        if length < 1e-9:
            continue
        low = min(0.5 * width, 0.5 * length)
        count = max(int((length - 2.0 * low) / step), 1)
        along = np.linspace(low, length - low, count + 1) / length
        normal = math.atan2(x1 - x0, y0 - y1)
        x = x0 + along * (x1 - x0) + 0.5 * depth * math.cos(normal)
        y = y0 + along * (y1 - y0) + 0.5 * depth * math.sin(normal)
        same = np.ones(len(along))
        found.append(np.column_stack([x, y, normal * same, width * same, depth * same]))
    return np.concatenate(found)


def on_floor(bounds: Floats, heading: float, width: float, depth: float, apart: float) -> Floats:
    """Boxes (k, 5) on a lattice over the bounds, ``apart`` metres, in four quarter turns."""
    x, y, turn = np.meshgrid(
        np.arange(bounds[0] + 0.5 * apart, bounds[2], apart),
        np.arange(bounds[1] + 0.5 * apart, bounds[3], apart),
        heading + 0.5 * np.pi * np.arange(4),
    )
    same = np.ones(x.size)
    return np.column_stack([x.ravel(), y.ravel(), turn.ravel(), width * same, depth * same])


def with_partners(problem: Problem, i: int, boxes: Floats, standing: list[int]) -> Floats:
    """Boxes (k, 5) of item ``i`` where its relations to standing items want it, unsized."""
    found = []
    for (first, second), (far, angle, bearing) in zip(
        problem.items.pairs, problem.items.pair_targets, strict=True
    ):
        other = int(second) if first == i else int(first)
        if i not in (first, second) or other not in standing or math.isnan(far):
            continue
        far = abs(far)
        box, turn = boxes[other], 0.0 if math.isnan(angle) else angle
        ways = 0.5 * np.pi * np.arange(4) if math.isnan(bearing) else [bearing]
        for way in ways:
            heading = box[2] + turn
            to = heading + way + np.pi if first == i else box[2] + way
            found.append([box[0] + far * math.cos(to), box[1] + far * math.sin(to), heading])
    return np.array(found, np.float64).reshape(-1, 3)


def places(problem: Problem, i: int, boxes: Floats, standing: list[int]) -> Floats:
    """Every box (k, 5) to be tried for an item."""
    items, ground, rule = problem.items, problem.ground, problem.settings.greedy
    low, high, wish = items.low[i], items.high[i], items.wish[i]
    usual = np.clip(np.where(np.isnan(wish), 0.5 * (low + high), wish), low, high)
    heading = 0.0
    if len(ground.walls):
        x0, y0, x1, y1 = ground.walls[0]
        heading = math.atan2(y1 - y0, x1 - x0)
    found = []
    for width, depth in (usual, low):
        found.append(along_walls(ground.walls, width, depth, rule.along))
        if items.back_to_wall[i] < 1.0 or not len(ground.walls):
            found.append(on_floor(ground.bounds, heading, width, depth, rule.apart))
        poses = with_partners(problem, i, boxes, standing)
        found.append(np.column_stack([poses, np.tile([width, depth], (len(poses), 1))]))
    return np.concatenate(found)


def place_all(
    problem: Problem, order: list[int], most: int, rng: np.random.Generator, cancelled: Cancel
) -> Pass:
    """One pass: each item of ``order`` at the best of at most ``most`` places; of few once
    cancelled."""
    boxes, looked, grid = np.zeros((len(order), 5)), 0, route_grid(problem, 0.1)
    for k, i in enumerate(order):
        tried, standing = places(problem, i, boxes, order[:k]), order[: k + 1]
        looks = min(most, HASTE) if cancelled() else most
        if len(tried) > looks:
            tried = tried[np.sort(rng.choice(len(tried), looks, replace=False))]
        part = problem._replace(items=select_items(problem.items, standing), names=())
        layouts = np.repeat(boxes[standing][None], len(tried), axis=0)
        layouts[:, k] = tried
        boxes[i] = tried[int(energies_of(prepare(part), grid, layouts)[0].argmin())]
        looked += len(tried)
    return Pass(boxes, looked)


def looks_in_turn(least: int, most: int) -> Iterator[int]:
    """Places looked at for one item in one pass after the other: ``least`` times the numbers of
    Luby, Sinclair and Zuckerman's sequence, none above ``most``.

    >>> from itertools import islice
    >>> list(islice(looks_in_turn(25, 60), 8))
    [25, 25, 50, 25, 25, 50, 60, 25]
    """
    for k in count(1):
        at = k
        while (at + 1) & at:  # not one less than a power of two: the sequence repeats itself
            at -= (1 << (at.bit_length() - 1)) - 1
        yield min(least * (at + 1) // 2, most)


def greedy(
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Found[Layout]:
    """Solve by greedy placement: one pass without a budget, else the best of as many as fit.

    Steps are tried places: a pass begins if they last for all of it, and the first always.
    """
    rng, watch = np.random.default_rng(seed), BudgetWatch(budget, progress, cancel)
    n, p, grid = len(problem.items.low), prepare(problem), route_grid(problem, 0.1)
    area, done = problem.items.high.prod(axis=1), 0
    rule, bounded = problem.settings.greedy, budget.steps or budget.seconds
    whole = min(rule.one, max(rule.first // n, 1))
    least = min(rule.least, whole, max((budget.steps or rule.first) // n, 1))
    kept: list[Layout] = []
    for looks in looks_in_turn(least if bounded else whole, whole):
        if kept and budget.steps and done + looks * n > budget.steps:
            break
        shake = rule.shake if kept else 0.0
        order = np.argsort(-area * np.exp(shake * rng.normal(size=n)), kind="stable")
        found = place_all(problem, order.tolist(), looks, rng, watch.cancelled)
        energy = float(energies_of(p, grid, found.boxes[None])[0][0])
        kept = sorted([*kept, Layout(found.boxes, energy)], key=lambda a: a.energy)[: rule.kept]
        done += found.looked
        over = watch.over(done, kept[0].energy, partial(min, kept, key=lambda a: a.energy))
        if over or not bounded:
            break
    boxes, energies = zip(*kept, strict=True)
    return Found(distinct(np.stack(boxes), np.array(energies)), done)
