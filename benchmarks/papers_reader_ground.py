"""Rows of sites (Zhang, Yang 2023), extensions (Zhang, Fei 2017) and villages (Zhu, Jiang, Li 2022)
by hand."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

import numpy as np
import shapely

from benchmarks.papers_reader_rows import Dice, Pair, by_row, told
from scenewright.domains.extend.printed import PlotGrid
from scenewright.domains.extend.solvers.ants import BestAnt
from scenewright.domains.extend.solvers.colony import ColonySettings
from scenewright.domains.village.paper.retrieval import RetrievedHouse
from scenewright.engine.preference.alleles.art1 import Art1Settings, begin_network
from scenewright.engine.preference.alleles.preference import AlleleRecord
from scenewright.engine.trace import Step


def _rated(dice: Dice) -> tuple[list[int], list[float]]:
    """Alleles of one gene in nine layouts, 1 among them, and their ratings."""
    return [1, *dice.integers(0, 3, 8).tolist()], dice.uniform(1, 5, 9).tolist()


def _grid() -> PlotGrid:
    """Two rows of four plots, all free; 1,000 m² of houses of 100 m² are wanted."""
    x, y = np.meshgrid(np.arange(4.0) * 20, np.arange(2.0) * 20)
    return PlotGrid(np.stack([x, y], -1), np.ones((2, 4), bool), np.array([100.0]), 1000.0)


def _mean(values: list[float]) -> float:
    return sum(values) / len(values)


@by_row("sites", "formula", "(1), Fit")
def _(fit: Any, dice: Dice) -> Pair:
    sizes = dice.uniform(4, 9, (3, 3))
    hand = sum((a + 2) * (b + 3) * h for a, b, h in sizes.tolist()) / (40 * 50 * 10)
    return hand, fit(sizes, (2, 3), (40, 50, 10))


@by_row("sites", "formula", "(7), F(x)")
def _(fitness: Any, dice: Dice) -> Pair:
    rows = dice.uniform(0.1, 1, (4, 3)).tolist()
    hand = sum(p * (tau + p) * f / tau for p, tau, f in rows)
    return hand, fitness([AlleleRecord(*row) for row in rows], 3.0, "printed")


@by_row("sites", "formula", "(9), p(X)")
def _(prefer: Any, dice: Dice) -> Pair:
    genes, stars = _rated(dice)
    hand = _mean([s for g, s in zip(genes, stars, strict=True) if g == 1]) - _mean(stars)
    return hand, prefer(np.array(genes)[:, None], np.array(stars), 0, 1, "printed")


@by_row("sites", "formula", "(10), λ(X)")
def _(observe: Any, dice: Dice) -> Pair:
    genes, _ = _rated(dice)
    whole = np.array([genes, genes]).T
    return genes.count(1) / 9 / (1 / 3**2), observe(whole, 0, 1, 3, "printed")


@by_row("sites", "formula", "(12), ρ")
def _(differ: Any, dice: Dice) -> Pair:
    _, stars = _rated(dice)
    hand = sum(abs(s - max(stars)) for s in stars) / 8 - 0.2
    return hand, differ(np.array(stars), max(stars), 0.2)


@by_row("sites", "formula", "(20), distances")
def _(distances: Any, dice: Dice) -> Pair:
    point, others = dice.random(3), dice.random((5, 3))
    hand = [math.dist(point, other) for other in others]
    return min(hand) + _mean(hand), sum(distances(point, others))


@by_row("sites", "formula", "(23)")
def _(from_best: Any, dice: Dice) -> Pair:
    genes, stars = _rated(dice)
    hand = _mean([s for g, s in zip(genes, stars, strict=True) if g == 1])
    return hand, from_best(np.array(genes)[:, None], np.array(stars), 0, 1)


@by_row("sites", "formula", "(24)")
def _(rmse: Any, dice: Dice) -> Pair:
    a, b = dice.uniform(1, 5, (2, 6))
    return math.sqrt(_mean([(x - y) ** 2 for x, y in zip(a, b, strict=True)])), rmse(a, b)


@by_row("sites", "step", "(13)")
def _(members: Any, dice: Dice) -> Pair:
    parts = dice.integers(0, 4, 20).tolist()
    return Counter(parts)[2], members(np.array(parts), 4)[2]


@by_row("sites", "step", "λ > 1")
def _(accept: Any, dice: Dice) -> Pair:
    p, seen, tau, usual, draw = dice.uniform(0, 2, 5).tolist()
    return (p if seen > 1 or (tau > usual and draw < 0.325) else 0.0), accept(
        p, seen, tau, usual, draw
    )


@by_row("sites", "step", "ART1")
def _(present: Any, dice: Dice) -> Pair:
    x = (dice.random(8) < 0.6).astype(float)
    x[0] = 1.0
    network, _ = present(begin_network(8), x, 3.0, Art1Settings())
    return 1 / (1 + sum(x.tolist())), float(network.upward[0].max())


@by_row("sites", "step", "symmetric Latin")
def _(draw: Any, dice: Dice) -> Pair:
    points = draw(6, 2, dice).tolist()
    return 6.0, sum(a + b for (a, _), (b, _) in zip(points, points[::-1], strict=True))


@by_row("sites", "step", "tournament")
def _(_solver: Any, _dice: Dice) -> Pair:
    return 10, _mean([step.facts["population"] for step in told("sites", "generation")])


@by_row("sites", "step", "(22)")
def _(_value: Any, _dice: Dice) -> Pair:
    best = max(max(step.facts["values"]) for step in told("sites", "generation"))
    return best, told("sites", "stop")[0].facts["best"]


@by_row("extensions", "formula", "(14)")
def _(attract: Any, dice: Dice) -> Pair:
    point, spots = dice.random(3), dice.random((2, 3))
    mix, pulls = (0.5, 0.3, 0.2), (0.3, 0.7)
    hand = sum(
        w * sum(m * abs(a - b) for m, a, b in zip(mix, point, spot, strict=True))
        for w, spot in zip(pulls, spots, strict=True)
    )
    return hand, attract(point[None], spots, np.array(pulls), np.array(mix))[0]


@by_row("extensions", "formula", "(16)")
def _(evaporate: Any, dice: Dice) -> Pair:
    rho, a, b, t = dice.uniform(0.1, 0.9), dice.uniform(0.3, 1), dice.uniform(1, 2), 3
    c = 2 * a / (1 + math.exp(-b * t)) - a
    return max(rho**2 / c, 0.1), evaporate(rho, t, a, b, 0.1)


@by_row("extensions", "formula", "(21)")
def _(fitness: Any, dice: Dice) -> Pair:
    worth, weights, genes = dice.random((2, 2, 3)), dice.random((2, 2)), dice.integers(0, 3, (2, 2))
    cells = [(i, j) for i in (0, 1) for j in (0, 1)]
    return sum(weights[c] * worth[c][genes[c]] for c in cells), fitness(genes, worth, weights)


@by_row("extensions", "formula", "(22)")
def _(fitness: Any, dice: Dice) -> Pair:
    golden, ratio, weights = (1 + 5**0.5) / 2, 80 / 40, dice.dirichlet(np.ones(4))
    aims = (1 - abs(800 - 1000) / 1000, 1.0, 1 - abs(ratio - golden) / golden, 1.0)
    hand = sum(w * aim for w, aim in zip(weights.tolist(), aims, strict=True))
    return hand, fitness(_grid(), np.ones((2, 4), int), weights)


@by_row("extensions", "formula", "(23)")
def _(values: Any, dice: Dice) -> Pair:
    genes, stars = _rated(dice)
    hand = _mean([s for g, s in zip(genes, stars, strict=True) if g != 1] or [0.0])
    return hand, values(np.array(genes)[:, None, None], np.array(stars), 2, True)[0, 0, 1]


@by_row("extensions", "step", "(15)")
def _(update: Any, dice: Dice) -> Pair:
    good, bad, rho = dice.uniform(0.6, 1), dice.uniform(0.1, 0.4), dice.uniform(0.1, 0.9)
    ways = (np.array([0, 1]), np.array([1, 2]))
    best, flat = BestAnt(ways[0], good), np.full((3, 3), 0.05)
    after, _ = update(flat, ways, np.array([good, bad]), best, rho, ColonySettings())
    return (1 - rho) * 0.05 + rho * good, after[1, 2]


@by_row("extensions", "step", "section 3")
def _(fold: Any, dice: Dice) -> Pair:
    many = int(dice.integers(2, 7))
    return many, fold(["A", "B"] * many)[0].times


@by_row("extensions", "step", "section 2")
def _(sort: Any, dice: Dice) -> Pair:
    apart = np.array([[0.0, 0.0], [1.0, 1.0]])[np.arange(8) % 2] + 0.01 * dice.random((8, 2))
    return 2, len(set(sort(apart).tolist()))


@by_row("extensions", "step", "(13), (18)")
def _(run: Any, dice: Dice) -> Pair:
    heard = list[Step]()
    run(_grid(), np.full(4, 0.25), None, dice, hear=heard.append)
    return 300 * 20, heard[-1].facts["evaluations"]


@by_row("extensions", "step", "section 5")
def _(breed: Any, dice: Dice) -> Pair:
    heard = list[Step]()
    breed(_grid(), np.full(4, 0.25), None, dice, hear=heard.append)
    return 8 * 30, heard[-1].facts["evaluations"]


@by_row("extensions", "formula", "section 1, k-entropy")
def _(entropy: Any, dice: Dice) -> Pair:
    points, classes = dice.random(9).tolist(), dice.integers(0, 3, 9).tolist()
    hand = 0.0
    for k, x in enumerate(points):
        near = sorted((abs(x - y), classes[n]) for n, y in enumerate(points) if n != k)[:4]
        shares = [count / 4 for count in Counter(one for _, one in near).values()]
        hand -= sum(share * math.log2(share) for share in shares) / len(points)
    return hand, entropy(np.array(points)[:, None], np.array(classes))


@by_row("villages", "formula", "category")
def _(retrieve: Any, _dice: Dice) -> Pair:
    ring = np.array([[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]])
    floor = shapely.box(0, 0, 60, 60)
    library = [RetrievedHouse(ring, np.array([3.0, 0.0]), (0, 0, 1))]
    found = retrieve(
        library, (1, 0, 1), np.array([20.0, 3.0]), 0.0, floor, floor, np.empty(0, object)
    )
    step = found.placed.door - found.placed.ring.mean(0)
    side = min(range(2), key=lambda k: min(found.placed.door[1 - k], 60 - found.placed.door[1 - k]))
    angle = math.degrees(math.asin(min(abs(step[1 - side]) / math.hypot(*step), 1.0)))
    return 0.8 * 2 / 2 + angle / 100, found.score


@by_row("villages", "step", "*continue*")
def _(_fill: Any, _dice: Dice) -> Pair:
    odds = [step.facts["odds"] for step in told("villages", "house")]
    return 1.0, _mean([float(one >= 0.5) for one in odds])


@by_row("villages", "step", "views")
def _(_nets: Any, _dice: Dice) -> Pair:
    return 64, told("villages", "begin")[0].facts["pixels"]
