"""Rows of halls (Cao, Cheng, Zhang 2024) and homes (Liu, Jiang, Mao, Wang 2017) by hand."""

from __future__ import annotations

import math
from itertools import combinations
from types import SimpleNamespace
from typing import Any

import numpy as np
import shapely

from benchmarks.papers_reader_rows import Dice, Pair, by_row, told
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.energy import explain
from scenewright.domains.home.presets import PAPER
from scenewright.domains.home.problem import Ground, Problem, empty_items
from scenewright.engine.genetic import Generation, PaperGenetic


def phi(x: float) -> float:
    """Eq. 2 of halls."""
    return 1.0 / (x + math.sqrt(x * x + 0.05**2))


@by_row("halls", "formula", "eq. 1, E_s")
def _(cost: Any, dice: Dice) -> Pair:
    covered, demanded = dice.uniform(0, 4), dice.uniform(1, 5)
    sigma = 1.0 / (1.0 + math.exp(-covered / demanded))
    return phi(1.5 - 2 * 1.5 * sigma), cost(covered, demanded)


@by_row("halls", "formula", "eq. 2")
def _(barrier: Any, dice: Dice) -> Pair:
    x = dice.uniform(-1, 2)
    return phi(x), barrier(x)


@by_row("halls", "formula", "eq. 3, E_u")
def _(cost: Any, dice: Dice) -> Pair:
    least, used = dice.uniform(0.1, 0.8, 2)
    return phi(1 - least / used), cost(least, used)


@by_row("halls", "formula", "eq. 4")
def _(cost: Any, dice: Dice) -> Pair:
    least, width = dice.uniform(0.5, 3, 2)
    return math.exp(max(0.0, least - width)) - 1, cost(least, width)


@by_row("halls", "formula", "eq. 5")
def _(cost: Any, dice: Dice) -> Pair:
    gap, iota, other = dice.uniform(0.2, 4), *dice.uniform(0.3, 1, 2)
    most = iota + other + 1.0
    return phi(1 - max(0.0, gap - most) / most), cost(gap, most)


def _boxes(dice: Dice) -> list[tuple[float, float, float, float]]:
    low = dice.integers(0, 12, (7, 2)).tolist()
    return [(x / 2, y / 2, x / 2 + 0.4, y / 2 + 0.4) for x, y in {tuple(one) for one in low}]


@by_row("halls", "formula", "eq. 7")
def _(aesthetic: Any, dice: Dice) -> Pair:
    boxes = _boxes(dice)
    lines = len({x for x, *_ in boxes}) + len({y for _, y, *_ in boxes})
    corners = [[(a, b), (c, b), (c, d), (a, d)] for a, b, c, d in boxes]
    return 3 / (lines + len(boxes)), aesthetic(np.array(corners), 0.0)[0]


@by_row("halls", "formula", "eq. 9")
def _(circulation: Any, dice: Dice) -> Pair:
    boxes = _boxes(dice)
    hand = 0.0
    for a, b in combinations(boxes, 2):
        dx = max(a[0] - b[2], b[0] - a[2], 0.0)
        dy = max(a[1] - b[3], b[1] - a[3], 0.0)
        hand += max(0.0, 0.6 - math.hypot(dx, dy))
    return hand, circulation(np.array([shapely.box(*one) for one in boxes]))[1]


def _block(dice: Dice) -> Any:
    """What is told of one block of iterations."""
    blocks = told("halls", "iterations")
    return blocks[int(dice.integers(len(blocks)))].facts


@by_row("halls", "step", "eq. 6")
def _(_measure: Any, dice: Dice) -> Pair:
    facts = _block(dice)
    parts = [facts[name] for name in ("space", "fill", "access", "proportion")]
    return sum(parts), facts["energy"]


@by_row("halls", "step", "3.3, 1000")
def _(_solver: Any, _dice: Dice) -> Pair:
    return 1000, told("halls", "stop")[0].facts["iterations"]


@by_row("halls", "step", "3.3, step")
def _(_run: Any, dice: Dice) -> Pair:
    facts = _block(dice)
    return max((1000 - (facts["iterations"] - 1)) / 1000, 0.5), facts["step"]


@by_row("halls", "step", "3.3, f =")
def _(_run: Any, _dice: Dice) -> Pair:
    return 0.1, told("halls", "begin")[0].facts["settings"]["rate"]


@by_row("halls", "step", "3.3, wall demand")
def _(needed: Any, dice: Dice) -> Pair:
    widths = dice.uniform(0.5, 2, 6).tolist()
    sizes = [SimpleNamespace(width=width) for width in widths]
    wish, count = SimpleNamespace(clearance=(0.5, 0.0, 0.0, 0.0), sizes=sizes), 4
    return (100 * (count + 1) + sum(100 * w for w in widths[:count])) / 100, needed(wish, 4, True)


def _room(dice: Dice, **more: Any) -> tuple[Problem, Any]:
    """Two patches in a room of 5 by 5 m, the main wall below; their boxes at random."""
    wall = np.array([[0, 0, 5, 0], [5, 0, 5, 5], [5, 5, 0, 5], [0, 5, 0, 0]], float)
    none = np.zeros((0, 5))
    ground = Ground(
        edges=wall,
        walls=wall,
        keep_free=none,
        use_space=none,
        obstacles=none,
        windows=np.zeros((0, 6)),
        doors=none,
        main_wall=wall[:1],
        bounds=np.array([0.0, 0.0, 5.0, 5.0]),
        area=25.0,
    )._replace(**more)
    items = empty_items(2)._replace(
        back_to_wall=np.ones(2),
        main_wall=np.array([1.0, -1.0]),
        pairs=np.array([[0, 1]]),
        pair_targets=np.array([[2.5, math.pi, 0.0]]),
        pair_weights=np.ones(1),
    )
    boxes = np.column_stack(
        [dice.uniform(0.2, 4.8, (2, 2)), np.full(2, math.pi / 2), np.ones((2, 2))]
    )
    return Problem(ground, items, ("a", "b"), PAPER, True, flush=0.1), boxes


def _cost(problem: Problem, boxes: Any, term: str) -> float:
    return float(sum(part.cost for part in explain(problem, boxes) if part.term == term))


def _shared(a: Any, b: Any) -> float:
    """Floor that two boxes of 1 by 1 m share, or one with a room given by its middle and sides."""
    across = [
        min(p + u / 2, q + v / 2) - max(p - u / 2, q - v / 2)
        for p, u, q, v in zip(*a, *b, strict=True)
    ]
    return max(across[0], 0.0) * max(across[1], 0.0)


ONE = (1.0, 1.0)


@by_row("homes", "formula", "C1")
def _(_outside: Any, dice: Dice) -> Pair:
    problem, boxes = _room(dice)
    out = sum(1 - _shared((box[:2], ONE), ((2.5, 2.5), (5, 5))) for box in boxes)
    return 5000 * out / 2, _cost(problem, boxes, "boundary")


@by_row("homes", "formula", "C2")
def _(_overlap: Any, dice: Dice) -> Pair:
    problem, boxes = _room(dice)
    boxes[1, :2] = boxes[0, :2] + dice.uniform(-0.8, 0.8, 2)
    return 600 * _shared((boxes[0, :2], ONE), (boxes[1, :2], ONE)) / 2, _cost(
        problem, boxes, "overlap"
    )


@by_row("homes", "formula", "C4")
def _(_turn: Any, dice: Dice) -> Pair:
    problem, boxes = _room(dice)
    boxes[:, 2] = dice.uniform(0, 2 * math.pi, 2)
    turns = [(heading - math.pi / 2) % (2 * math.pi) for heading in boxes[:, 2]]
    hand = 1 * (turns[0] - 2 * math.pi / 2) - 1 * (turns[1] - 0)
    return 1500 * abs(hand), _cost(problem, boxes, "main_wall")


@by_row("homes", "formula", "C5")
def _(_gap: Any, dice: Dice) -> Pair:
    problem, boxes = _room(dice)
    boxes[:, :2] = dice.uniform(0.6, 4.4, (2, 2))
    hand = 0.0
    for x, y, *_ in boxes.tolist():
        back = y - 0.5  # fronts look up, so backs are below
        away = min(back, x, 5 - x, 5 - back)
        hand += 0.0 if away <= 0.1 else 1 - (0.1 / away) ** 2
    return 1000 * hand, _cost(problem, boxes, "against_wall")


@by_row("homes", "formula", "C6")
def _(_pair: Any, dice: Dice) -> Pair:
    problem, boxes = _room(dice)
    away = math.hypot(*(boxes[0, :2] - boxes[1, :2]))
    boxes[1, 2] += (turn := dice.uniform(0, math.pi))
    return 110 * (abs(away - 2.5) + abs(turn - math.pi)), _cost(problem, boxes, "pairs")


@by_row("homes", "formula", "C7")
def _(size: Any, dice: Dice) -> Pair:
    share = dice.uniform(0.1, 0.9)
    low, high = 1 - (share / 0.4) ** 2, 1 - (0.55 / share) ** 2
    return low if share < 0.4 else high if share > 0.55 else 0.0, size(25 * share, 25.0)


def _twice(dice: Dice) -> tuple[Dice, Dice]:
    """Two dice that fall alike."""
    seed = int(dice.integers(2**31))
    return np.random.default_rng(seed), np.random.default_rng(seed)


@by_row("homes", "step", "F = C_max")
def _(roulette: Any, dice: Dice) -> Pair:
    costs, (one, other) = dice.uniform(0, 100, 9).tolist(), _twice(dice)
    left, drawn = one.random() * sum(max(costs) - c for c in costs), 0
    for k, cost in enumerate(costs):
        left -= max(costs) - cost
        if left < 0:
            drawn = k
            break
    return drawn, int(roulette(np.array(costs), 1, other)[0])


@by_row("homes", "step", "crossover")
def _(cross: Any, dice: Dice) -> Pair:
    (a, b), (one, other) = dice.uniform(0, 5, 2).tolist(), _twice(dice)
    share = one.random()
    return share * a + (1 - share) * b, cross(np.array([[a], [b]]), np.array([True]), other)[0, 0]


def _mutated(mutate: Any, dice: Dice, age: int) -> tuple[float, Dice, float, float]:
    """A gene at 2 between 1 and 9 mutated in a generation; and dice that fall alike for it."""
    one, other = _twice(dice)
    low, high, none = np.array([1.0]), np.array([9.0]), np.empty(0)
    state = Generation(none, none, low, high, age, None, none)  # type: ignore[arg-type]
    found = mutate(PaperGenetic(), np.array([[2.0]]), np.array([True]), state, other)
    one.integers(0, 1, 1)
    return float(found[0, 0]), one, 1.0, 9.0


@by_row("homes", "step", "uniform mutation")
def _(mutate: Any, dice: Dice) -> Pair:
    ours, one, low, high = _mutated(mutate, dice, 10)
    return low + one.random() * (high - low), ours


@by_row("homes", "step", "later x")
def _(mutate: Any, dice: Dice) -> Pair:
    ours, one, low, high = _mutated(mutate, dice, 90)
    return min(max(2.0 + one.normal(0, 0.3), low), high), ours


@by_row("homes", "step", "40 layouts")
def _(_solver: Any, _dice: Dice) -> Pair:
    return 40 * 100, sum(step.facts["population"] for step in told("homes", "generation"))


@by_row("homes", "step", "nearest case")
def _(nearest: Any, dice: Dice) -> Pair:
    width, depth = dice.uniform(0.5, 4, 2).tolist()
    far = {
        group.name: math.hypot(w - width, d - depth)
        for group, (w, d) in zip(
            cases("seating").groups, cases("seating").sizes.tolist(), strict=True
        )
    }
    return min(far.values()), far[nearest("seating", width, depth).name]
