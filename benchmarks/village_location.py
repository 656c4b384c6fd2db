"""Where the next house stands: how well a method foretells the middle of the real one.

Blocks are taken as they are filled, the largest house first. A method's answer is the density it
draws poses from: legal proposals with its weights. Told are *nats over even ground*, the log of
that density at the real middle against an even one over the free ground (no house on it), and the
distance from the real middle to the nearest of the *five best places*: those with most of the
density within 3 m, one after the other, 3 m apart or more.

The density is estimated from 20,000 proposals, all of them weighed. (Weighing all near the real
middle but only a share of the others made false peaks of the others: each stood for many, and a
lucky one was higher than what the middle had.) At the real middle it is blurred by 1 m, and a tenth
is spread evenly over the free ground.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
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

PROPOSED, EVEN, BLUR = 20_000, 0.1, 1.0
"""Proposals of a house, the share spread evenly, metres of blur."""
REACH, APART, PEAKS = 3.0, 3.0, 5
"""Metres within which a place is right, metres between places, and how many are named."""

Scoring = Callable[[Turn, PoseTokens], Floats]
"""Log weights (k,) of legal poses."""


class Foretold(NamedTuple):
    """Nats over even ground and the distance in metres to the nearest of the best peaks."""

    nats: float
    distance: float


Foretelling = Callable[[RealBlock, Turn, Floats], Foretold]
"""What is foretold of a turn of a block whose free middles are given."""


class Sampled(NamedTuple):
    """Legal poses (k, 3) of a house and their footprints (k,)."""

    poses: Floats
    shapes: Shapes


def sample_legal(problem: VillageProblem, turn: Turn, rng: np.random.Generator) -> Sampled:
    """Legal poses of a house, as they are proposed."""
    poses = propose(problem, turn.seen.standing, turn.house, rng)
    shapes, rings = shapes_at(turn.house, poses)
    good = shapely.contains_xy(problem.floor, rings[..., 0], rings[..., 1]).all(1)
    good[good] = shapely.covers(problem.floor, shapes[good])
    if len(turn.taken):
        hit = shapely.STRtree(turn.taken).query(shapes, predicate="intersects")[0]
        good[hit] = False
    return Sampled(poses[good], shapes[good])


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


def foretell(found: Sampled, weights: Floats, free: Floats, real: Floats) -> Foretold:
    """What weighed poses say of the real middle (2,), ``free`` (k, 2) being where one may be."""
    if not len(weights) or not len(free):
        return Foretold(float(np.log(EVEN)) if len(free) else 0.0, np.inf)
    odds = np.exp(weights - weights.max())
    odds /= odds.sum()
    away = np.hypot(*(found.poses[:, :2] - real).T)
    there = odds @ np.exp(-0.5 * (away / BLUR) ** 2) / (2 * np.pi * BLUR**2)
    nats = float(np.log((1 - EVEN) * there * len(free) + EVEN))
    return Foretold(nats, float(np.hypot(*(best_places(found.poses[:, :2], odds) - real).T).min()))


def best_places(points: Floats, odds: Floats) -> Floats:
    """The places (PEAKS, 2), on a grid of 1 m, that have most of what points (k, 2) weigh within
    REACH, one after the other: what a place has is not counted again.

    >>> found = best_places(np.array([[20.0, 5], [5, 5.2], [5.2, 5]]), np.ones(3) / 3)
    >>> bool((np.hypot(*(found[:2] - [[5, 5], [20, 5]]).T) <= REACH + 1).all())
    True
    """
    low = np.floor(points.min(0)) - 4
    cells = (points - low).astype(int)
    held = np.zeros(cells.max(0) + 5)
    np.add.at(held, (cells[:, 0], cells[:, 1]), odds)
    steps = np.arange(-int(REACH), int(REACH) + 1)
    disc = [(a, b) for a in steps for b in steps if a * a + b * b <= REACH**2]
    x, y = np.mgrid[: held.shape[0], : held.shape[1]]
    spots: list[tuple[int, int]] = []
    for _ in range(PEAKS):
        mass = np.sum([np.roll(held, shift, (0, 1)) for shift in disc], axis=0)
        for row, column in spots:
            mass[(x - row) ** 2 + (y - column) ** 2 < APART**2] = -1.0
        row, column = (int(v) for v in np.unravel_index(int(mass.argmax()), mass.shape))
        spots.append((row, column))
        held[(x - row) ** 2 + (y - column) ** 2 <= REACH**2] = 0.0
    return low + np.array(spots) + 0.5


def foretell_blocks(
    blocks: Sequence[RealBlock],
    style: VillageStyle,
    methods: Sequence[Scoring],
    houses: int,
    seed: int = 3,
    direct: Sequence[Foretelling] = (),
) -> list[list[Foretold]]:
    """Of each method what it foretells of so many houses of some blocks, the same for all;
    ``direct`` are methods that need no proposals, last."""
    wide = VillageSettings(GrowSettings(proposed=PROPOSED))
    rng = np.random.default_rng(seed)
    turns = [(b, turn) for b in blocks for turn in turns_of(b, rng)]
    found: list[list[Foretold]] = [[] for _ in (*methods, *direct)]
    for k in rng.permutation(len(turns))[:houses].tolist():
        block, turn = turns[k]
        legal = sample_legal(problem_of_block(block, (), style, wide), turn, rng)
        free = free_middles(block.floor, turn.seen.standing.shapes)
        tokens = tokens_of(turn.seen, turn.house, legal.poses, legal.shapes)
        for tell, row in zip(direct, found[len(methods) :], strict=True):
            row.append(tell(block, turn, free))
        for method, row in zip(methods, found, strict=False):
            weights = method(turn, tokens) if len(legal.poses) else np.zeros(0)
            row.append(foretell(legal, weights, free, turn.pose[:2]))
    return found
