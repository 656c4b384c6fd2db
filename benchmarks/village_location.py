"""Where the next house stands: how well a method foretells the middle of the real one.

Blocks are taken as they are filled, the largest house first. A method's answer is the density it
draws poses from: legal proposals with its weights. Told are, for houses drawn from all held-out
blocks alike,

* *nats over even ground*: the log of that density at the real middle against an even one over the
  free ground (no house on it);
* *nearest of 5 places*: the five best places are those with most of the density within 3 m, one
  after the other, 3 m apart or more, each moved to the middle of what it holds; told is the
  distance from the nearest of them to the middle of the very house (``strict``), and to the nearest
  of all houses that the block still lacks (``any``: which is placed next is but our order).

The density is estimated from 6,000 proposals, all of them weighed; near the real middle, where it
is read off, from ten times as many. It is blurred by 1 m, and a tenth is spread evenly over the
free ground.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.village.learned.style import VillageStyle
from scenewright.domains.village.learned.tokens import PoseTokens, tokens_of
from scenewright.domains.village.learning.examples import Turn, problem_of_block, turns_of
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.problem import VillageProblem
from scenewright.domains.village.proposals import propose, shapes_at
from scenewright.domains.village.settings import GrowSettings, VillageSettings
from scenewright.domains.village.standing import Floats, Shapes

PROPOSED, EVEN, BLUR = 6000, 0.1, 1.0
"""Proposals of a house, the share spread evenly, metres of blur."""
DENSER, CLOSE = 10, 4.0
"""How many times as many are proposed within so many metres of the real middle."""
REACH, APART, PEAKS, SHIFTS = 3.0, 3.0, 5, 4
"""Metres of a place, metres between places, how many are named, and how often each is moved to
the middle of what it holds (mean shift; Fukunaga and Hostetler 1975)."""

_DISC = [(a, b) for a in range(-3, 4) for b in range(-3, 4) if a * a + b * b <= REACH**2]

Scoring = Callable[[Turn, PoseTokens], Floats]
"""Log weights (k,) of legal poses."""


class Foretold(NamedTuple):
    """Nats over even ground; metres from the nearest of the five best places to the house
    (``strict``) and to ``any`` house that is missing."""

    nats: float
    strict: float
    any: float


class Foretelling(NamedTuple):
    """A method that needs no proposals: what it foretells of a turn of a block whose free middles
    are given."""

    tell: Callable[[RealBlock, Turn, Floats], Foretold]


class Sampled(NamedTuple):
    """Legal poses (k, 3) of a house, what is told of them, and how many proposals each stands for
    (k,): those near the real middle are denser."""

    poses: Floats
    tokens: PoseTokens
    share: Floats


def sample_legal(problem: VillageProblem, turn: Turn, rng: np.random.Generator) -> Sampled:
    """Legal poses of a house as they are proposed, and more of them near its real middle."""
    poses, shapes = _propose_legal(problem, turn, PROPOSED, rng, np.inf)
    more, others = _propose_legal(problem, turn, DENSER * PROPOSED, rng, CLOSE)
    near = np.hypot(*(poses[:, :2] - turn.pose[:2]).T) <= CLOSE
    share = np.concatenate([np.where(near, 0.0, 1.0), np.full(len(more), 1.0 / DENSER)])
    poses, shapes = np.concatenate([poses, more]), np.concatenate([shapes, others])
    return Sampled(poses, tokens_of(turn.seen, turn.house, poses, shapes), share)


def _propose_legal(
    problem: VillageProblem, turn: Turn, count: int, rng: np.random.Generator, within: float
) -> tuple[Floats, Shapes]:
    """The legal ones of so many proposals whose middles are within so many metres of the real."""
    wide = problem._replace(settings=VillageSettings(GrowSettings(proposed=count)))
    poses = propose(wide, turn.seen.standing, turn.house, rng)
    poses = poses[np.hypot(*(poses[:, :2] - turn.pose[:2]).T) <= within]
    shapes, rings = shapes_at(turn.house, poses)
    good = shapely.contains_xy(problem.floor, rings[..., 0], rings[..., 1]).all(1)
    good[good] = shapely.covers(problem.floor, shapes[good])
    if len(turn.taken):
        hit = shapely.STRtree(turn.taken).query(shapes, predicate="intersects")[0]
        good[hit] = False
    return poses[good], shapes[good]


def free_middles(floor: shapely.Polygon, houses: Shapes) -> Floats:
    """The middles (k, 2) of the cells of 1 m that no house covers."""
    west, south, east, north = (float(np.floor(v)) for v in floor.bounds)
    x, y = np.arange(west + 0.5, east + 1), np.arange(south + 0.5, north + 1)
    grid = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    grid = grid[shapely.contains_xy(floor, grid[:, 0], grid[:, 1])]
    if len(houses):
        taken = shapely.union_all(houses)
        shapely.prepare(taken)
        grid = grid[~shapely.contains_xy(taken, grid[:, 0], grid[:, 1])]
    return grid


def missing_houses(block: RealBlock, turn: Turn) -> list[int]:
    """The numbers of the houses of a block that do not stand yet, the next one first."""
    middles, here = block.standing.frames[:, :2], turn.seen.standing.frames[:, :2]
    away = np.hypot(*(middles[:, None] - here[None]).transpose(2, 0, 1)).min(1, initial=1.0)
    rest = np.flatnonzero(away > 1e-9)
    order = np.argsort(np.hypot(*(middles[rest] - turn.pose[:2]).T), kind="stable")
    return [int(k) for k in rest[order]]


def foretell(found: Sampled, weights: Floats, free: Floats, missing: Floats) -> Foretold:
    """What weighed poses say of the middles of missing houses (m, 2), the next one first;
    ``free`` (k, 2) is where one may be."""
    if not len(weights) or not len(free):
        return Foretold(float(np.log(EVEN)) if len(free) else 0.0, np.inf, np.inf)
    odds = np.exp(weights - weights.max()) * found.share
    odds /= odds.sum()
    away = np.hypot(*(found.poses[:, :2] - missing[0]).T)
    there = odds @ np.exp(-0.5 * (away / BLUR) ** 2) / (2 * np.pi * BLUR**2)
    nats = float(np.log((1 - EVEN) * there * len(free) + EVEN))
    return Foretold(nats, *nearest_of(best_places(found.poses[:, :2], odds), missing))


def nearest_of(places: Floats, missing: Floats) -> tuple[float, float]:
    """Metres from the nearest of some places to the first of the missing houses, and to any."""
    away = np.hypot(*(places[:, None] - missing[None]).transpose(2, 0, 1))
    return float(away[:, 0].min()), float(away.min())


def best_places(points: Floats, odds: Floats) -> Floats:
    """The places (PEAKS, 2) that have most of what points (k, 2) weigh within REACH, one after the
    other: what a place has is not counted again. Each is the middle of what it has, looked for
    on a grid of 1 m.

    >>> found = best_places(np.array([[20.0, 5], [5, 5.2], [5.2, 5]]), np.ones(3) / 3)
    >>> found[:2].round(3).tolist()
    [[5.1, 5.1], [20.0, 5.0]]
    """
    low = np.floor(points.min(0)) - 4
    cells = (points - low).astype(int)
    x, y = np.mgrid[: cells[:, 0].max() + 5, : cells[:, 1].max() + 5]
    left, spots = odds.copy(), np.zeros((0, 2))
    for _ in range(PEAKS):
        held = np.zeros(x.shape)
        np.add.at(held, (cells[:, 0], cells[:, 1]), left)
        mass = np.sum([np.roll(held, shift, (0, 1)) for shift in _DISC], axis=0)
        for row, column in spots - low:
            mass[(x + 0.5 - row) ** 2 + (y + 0.5 - column) ** 2 < APART**2] = -1.0
        row, column = np.unravel_index(int(mass.argmax()), mass.shape)
        middle = low + np.array([row + 0.5, column + 0.5])
        for _ in range(SHIFTS):
            near = np.hypot(*(points - middle).T) <= REACH
            if left[near].sum() > 0:
                middle = left[near] @ points[near] / left[near].sum()
        spots = np.concatenate([spots, middle[None]])
        left = np.where(np.hypot(*(points - middle).T) <= REACH, 0.0, left)
    return spots


def foretell_house(
    block: RealBlock,
    turn: Turn,
    style: VillageStyle,
    methods: Mapping[str, Scoring | Foretelling],
    rng: np.random.Generator,
) -> dict[str, Foretold]:
    """What each method foretells of the next house of a block, by its name; those that judge poses
    judge the same ones."""
    legal = sample_legal(problem_of_block(block, (), style, VillageSettings()), turn, rng)
    free = free_middles(block.floor, turn.seen.standing.shapes)
    missing = block.standing.frames[missing_houses(block, turn), :2]
    found = {}
    for name, method in methods.items():
        if isinstance(method, Foretelling):
            found[name] = method.tell(block, turn, free)
            continue
        weights = method(turn, legal.tokens) if len(legal.poses) else np.zeros(0)
        found[name] = foretell(legal, weights, free, missing)
    return found


def turns_drawn(
    blocks: Sequence[RealBlock], houses: int, seed: int
) -> list[tuple[RealBlock, Turn]]:
    """So many houses of some blocks that are about to be placed, each as likely."""
    rng = np.random.default_rng(seed)
    turns = [(b, turn) for b in blocks for turn in turns_of(b, rng)]
    return [turns[k] for k in rng.permutation(len(turns))[:houses].tolist()]
