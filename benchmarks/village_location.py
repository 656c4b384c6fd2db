"""Where the next house stands: how well a method foretells the middle of the real one.

Blocks are taken as they are filled, the largest house first. A method's answer is the density it
draws poses from: legal proposals with its weights. Told are *nats over even ground*, the log of
that density at the real middle against an even one over the free ground (no house on it), and the
distance from the real middle to the nearest of the *five highest peaks* 3 m apart on a grid of 1 m.

The density at the real middle is estimated from 30,000 proposals: those within 4 m of it are all
weighed, of the others a random share that stands for all. It is blurred by 1 m, and a tenth is
spread evenly over the free ground.
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

PROPOSED, FAR, NEAR, EVEN, BLUR = 30_000, 2500, 4.0, 0.1, 1.0
"""Proposals of a house, those far from the real middle that are looked at, what is near in metres,
the share spread evenly, metres of blur."""
APART, PEAKS = 3.0, 5

Scoring = Callable[[Turn, PoseTokens], Floats]
"""Log weights (k,) of legal poses."""


class Foretold(NamedTuple):
    """Nats over even ground and the distance in metres to the nearest of the best peaks."""

    nats: float
    distance: float


class Sampled(NamedTuple):
    """Legal poses (k, 3) of a house, footprints (k,), and how many proposals each stands for."""

    poses: Floats
    shapes: Shapes
    share: Floats


def sample_legal(problem: VillageProblem, turn: Turn, rng: np.random.Generator) -> Sampled:
    """Legal poses: all of those near the real middle, some of the others."""
    poses = propose(problem, turn.seen.standing, turn.house, rng)
    near = np.hypot(*(poses[:, :2] - turn.pose[:2]).T) <= NEAR
    far = rng.permutation(np.flatnonzero(~near))
    kept = np.concatenate([np.flatnonzero(near), far[:FAR]])
    share = np.concatenate(
        [np.ones(int(near.sum())), np.full(len(far[:FAR]), len(far) / max(len(far[:FAR]), 1))]
    )
    shapes, rings = shapes_at(turn.house, poses[kept])
    good = shapely.contains_xy(problem.floor, rings[..., 0], rings[..., 1]).all(1)
    good[good] = shapely.covers(problem.floor, shapes[good])
    if len(turn.taken):
        hit = shapely.STRtree(turn.taken).query(shapes, predicate="intersects")[0]
        good[hit] = False
    return Sampled(poses[kept][good], shapes[good], share[good])


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
    odds = found.share * np.exp(weights - weights.max())
    odds /= odds.sum()
    away = np.hypot(*(found.poses[:, :2] - real).T)
    there = odds @ np.exp(-0.5 * (away / BLUR) ** 2) / (2 * np.pi * BLUR**2)
    nats = float(np.log((1 - EVEN) * there * len(free) + EVEN))
    return Foretold(nats, float(np.hypot(*(_peaks(found, odds) - real).T).min()))


def _peaks(found: Sampled, odds: Floats) -> Floats:
    """The middles (PEAKS, 2) of the highest cells of 1 m, blurred, that lie apart."""
    low = np.floor(found.poses[:, :2].min(0)) - 3
    cells = (found.poses[:, :2] - low).astype(int)
    held = np.zeros(cells.max(0) + 4)
    np.add.at(held, (cells[:, 0], cells[:, 1]), odds)
    kernel = np.exp(-0.5 * (np.arange(-3, 4) / BLUR) ** 2)
    for axis in (0, 1):
        held = np.apply_along_axis(np.convolve, axis, held, kernel, "same")
    x, y = np.mgrid[: held.shape[0], : held.shape[1]]
    spots = []
    for _ in range(PEAKS):
        row, column = np.unravel_index(int(held.argmax()), held.shape)
        spots.append((low[0] + row + 0.5, low[1] + column + 0.5))
        held[(x - row) ** 2 + (y - column) ** 2 < APART**2] = 0.0
    return np.array(spots)


def foretell_blocks(
    blocks: Sequence[RealBlock],
    style: VillageStyle,
    methods: Sequence[Scoring],
    houses: int,
    seed: int = 3,
) -> list[list[Foretold]]:
    """Of each method what it foretells of so many houses of some blocks, the same for all."""
    wide = VillageSettings(GrowSettings(proposed=PROPOSED))
    rng = np.random.default_rng(seed)
    turns = [(b, turn) for b in blocks for turn in turns_of(b, rng)]
    found: list[list[Foretold]] = [[] for _ in methods]
    for k in rng.permutation(len(turns))[:houses].tolist():
        block, turn = turns[k]
        legal = sample_legal(problem_of_block(block, (), style, wide), turn, rng)
        free = free_middles(block.floor, turn.seen.standing.shapes)
        tokens = tokens_of(turn.seen, turn.house, legal.poses, legal.shapes)
        for method, row in zip(methods, found, strict=True):
            weights = method(turn, tokens) if len(legal.poses) else np.zeros(0)
            row.append(foretell(legal, weights, free, turn.pose[:2]))
    return found
