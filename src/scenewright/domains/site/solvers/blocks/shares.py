"""What each block of a site gets: its turn, its share of the buildings, its ground."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.domains.site.solvers.blocks.distances import list_reserved_edges


def order_blocks(problem: SiteProblem) -> list[int]:
    """Blocks in the order in which buildings, the lowest first, are given to them: the farthest
    from a square or landmark first, so that the skyline steps up to it; without one from the side
    the fronts look to. Those whose courts are to close come before all."""
    front = np.array([math.cos(problem.facing), math.sin(problem.facing)])
    places = [list_edges(problem, b)[:, :2].mean(0) for b in range(len(_areas(problem)))]
    focus = problem.ground.focus
    middles = [float(place @ front) for place in places]
    if len(focus):
        middles = [float(np.hypot(*(focus - place).T).min()) for place in places]
    closing = [problem.court_gap > 0.0 and form == "peripheral" for form in problem.block_forms]
    closing += [False] * (len(middles) - len(closing))
    return sorted(range(len(middles)), key=lambda b: (not closing[b], -middles[b]))


def list_low_first(problem: SiteProblem) -> list[int]:
    """Buildings by model, the lowest models first: like ones together, tall ones where their
    shadow falls on few."""
    sizes, models = problem.buildings.sizes, problem.buildings.models
    tall = {m: float(sizes[models == m, 2].max()) for m in np.unique(models).tolist()}
    return sorted(range(len(sizes)), key=lambda i: (tall[int(models[i])], int(models[i]), i))


def _areas(problem: SiteProblem) -> Floats:
    """The ground of each block, more of it on the side that buildings are drawn to."""
    areas = np.asarray(problem.ground.block_areas, np.float64)
    if not any(problem.drawn_to) or len(areas) < 2:
        return areas
    middles = np.array([list_edges(problem, b)[:, :2].mean(0) for b in range(len(areas))])
    off = (middles - middles.mean(0)) @ np.array(problem.drawn_to)
    drawn = problem.settings.fill.drawn
    return areas * np.exp(drawn * off / max(float(np.abs(off).max()), 1e-9))


def share_out(problem: SiteProblem, left: list[int], blocks: list[int]) -> list[int]:
    """The buildings the first of some blocks takes of those that are left: the next ones, up to
    its share of the ground."""
    areas, sizes = _areas(problem), problem.buildings.sizes
    share = float(areas[blocks[0]] / areas[blocks].sum())
    floor = np.array([_ground_of(problem, sizes[i]) for i in left])
    if not len(floor):
        return []
    count = int(np.searchsorted(np.cumsum(floor) - 0.5 * floor, share * floor.sum()))
    return left[:count]


def _ground_of(problem: SiteProblem, size: Floats) -> float:
    """Ground a building needs with its distances."""
    behind = max(problem.spacing, problem.sun_spacing * float(size[2]))
    return float((size[0] + problem.spacing) * (size[1] + behind))


def list_edges(problem: SiteProblem, b: int) -> Floats:
    """The directed edges (e, 4) of block ``b``, in metres."""
    first, last = problem.ground.block_spans[b]
    return problem.ground.block_edges[first:last]


def list_ground(
    problem: SiteProblem, b: int, boxes: Floats, present: Flags, waiting: list[int]
) -> Floats:
    """Edges of a block, cut back to keep distance from fixed buildings."""
    edges, sizes = list_edges(problem, b), problem.buildings.sizes
    low, high = edges.reshape(-1, 2).min(0), edges.reshape(-1, 2).max(0)
    standing = np.concatenate([boxes[present], problem.ground.landmarks])
    heights = np.concatenate([sizes[present, 2], problem.ground.landmark_heights])
    ahead = float(sizes[waiting, 2].max()) if waiting else 0.0
    far = (
        problem.spacing
        + problem.sun_spacing * np.maximum(heights, ahead)
        + standing[:, 3:].max(1, initial=0.0)
    )
    near = ((standing[:, :2] + far[:, None] > low) & (standing[:, :2] - far[:, None] < high)).all(1)
    if not near.any():
        return edges
    return np.concatenate(
        [edges, list_reserved_edges(problem, standing[near], heights[near], ahead)]
    )
