"""The annealing that Zhu, Jiang and Li (2022) compare with: houses moved and turned at random.

As in the paper its objective knows the real block's density (the mean distance of each house to
its nearest) and near-road value (the mean distance of the houses to the street): it is told what
ours must guess. Overlaps and what lies outside cost 10 a square metre.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.domains.village.house import House
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.standing import StandingHouses, place, stand

STEPS = 40_000
HOT, COLD, FAULT = 20.0, 0.05, 10.0
MOVE, TURN = 12.0, 0.6
"""Greatest move in metres and turn in radians, while hot."""


def anneal_block(
    block: RealBlock, houses: list[House], seed: int, steps: int = STEPS
) -> StandingHouses:
    """Some houses on the ground of a block after so many moves."""
    rng = np.random.default_rng(seed)
    west, south, east, north = block.floor.bounds
    count = len(houses)
    poses = rng.uniform((west, south, 0), (east, north, np.pi), (count, 3))
    goal = _goal(block)
    shapely.prepare(block.floor)
    lines = shapely.union_all(shapely.linestrings(block.streets))
    shapes = np.empty(count, object)
    shapes[:] = [
        shapely.Polygon(place(h.outline, p[None])[0]) for h, p in zip(houses, poses, strict=True)
    ]
    fault = np.array([_fault(block, shapes, k) for k in range(count)])
    near = shapely.distance(shapes, lines)
    cost = _cost(poses, near, goal)
    for step in range(steps):
        heat = HOT * (COLD / HOT) ** (step / steps)
        k, reach = int(rng.integers(count)), max(heat / HOT, 0.05) ** 0.5
        pose = poses[k] + rng.uniform(-1, 1, 3) * (MOVE * reach, MOVE * reach, TURN * reach)
        before, old_pose, old_near = shapes[k], poses[k].copy(), near[k]
        shapes[k] = shapely.Polygon(place(houses[k].outline, pose[None])[0])
        poses[k], near[k] = pose, shapely.distance(shapes[k], lines)
        mine, now = _fault(block, shapes, k), _cost(poses, near, goal)
        change = FAULT * (mine - fault[k]) + now - cost
        if change <= 0 or rng.random() < np.exp(-change / heat):
            fault[k], cost = mine, now
        else:
            shapes[k], poses[k], near[k] = before, old_pose, old_near
    rings = [shapely.get_coordinates(shape.exterior)[:-1] for shape in shapes]
    return stand(rings, [house.size for house in houses])


def _goal(block: RealBlock) -> tuple[float, float]:
    standing = block.standing
    lines = shapely.union_all(shapely.linestrings(block.streets))
    near = float(shapely.distance(standing.shapes, lines).mean())
    return _density(standing.frames[:, :2]), near


def _density(centres: np.ndarray) -> float:
    away = np.hypot(*(centres[:, None] - centres[None]).transpose(2, 0, 1))
    np.fill_diagonal(away, np.inf)
    return float(away.min(1).mean()) if len(centres) > 1 else 0.0


def _cost(poses: np.ndarray, near: np.ndarray, goal: tuple[float, float]) -> float:
    return len(poses) * (abs(_density(poses[:, :2]) - goal[0]) + abs(float(near.mean()) - goal[1]))


def _fault(block: RealBlock, shapes: np.ndarray, k: int) -> float:
    """Square metres that a house shares with others or has outside."""
    shape = shapes[k]
    others = np.delete(shapes, k)
    hit = others[shapely.intersects(others, shape)]
    shared = float(shapely.area(shapely.intersection(hit, shape)).sum()) if len(hit) else 0.0
    if block.floor.covers(shape):
        return shared
    return shared + float(shapely.difference(shape, block.floor).area)
