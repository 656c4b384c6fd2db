"""The search for a good division of a floor: annealing over trees of cuts.

What counts: links and neighbours that share a border long enough to pass, zones at their doors,
no cut through a door, compact zones without narrow ends.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.hall.settings import USUAL_ZONING, ZoningSettings
from scenewright.domains.hall.zoning.trees import (
    Cuts,
    FloorPart,
    Forest,
    divide,
    every_tree,
    mutate_tree,
    placed_tree,
)

SHARED_BORDER = 0.02


class ZoningGround(NamedTuple):
    """What is divided, in the hall's frame: the free ``parts`` of the floor among the zones
    ``free``, beside those ``fixed``. ``areas`` of all zones; ``pairs`` (zone, zone, least border,
    weight) that wish to meet; ``doors`` (d, 2, 2) their ends; ``at_door`` which zone wishes to
    lie at which door. ``rule`` steers the search."""

    parts: tuple[shapely.Polygon, ...]
    free: tuple[int, ...]
    fixed: Mapping[int, shapely.Polygon]
    areas: tuple[float, ...]
    pairs: tuple[tuple[int, int, float, float], ...]
    doors: Points
    at_door: Mapping[int, int]
    rule: ZoningSettings = USUAL_ZONING


Found = dict[Forest, tuple[float, dict[int, FloorPart]]]


class Memory(NamedTuple):
    """What one search has found out: cuts made, flaws of pieces by number, divisions tried."""

    cuts: Cuts
    flaws: dict[int, float]
    found: Found


def rank_divisions(
    ground: ZoningGround, rng: np.random.Generator
) -> list[dict[int, shapely.Polygon]]:
    """The divisions found, best first: the polygon of every free zone."""
    found = _search_divisions(ground, rng)
    rows: dict[tuple[int, ...], dict[int, shapely.Polygon]] = {}
    for _, pieces in sorted(found.values(), key=lambda row: row[0]):
        key = tuple(piece.number for _, piece in sorted(pieces.items()))
        rows.setdefault(key, {zone: piece.shape for zone, piece in pieces.items()})
    return list(rows.values())


def _search_divisions(ground: ZoningGround, rng: np.random.Generator) -> Found:
    """Every division tried, by its forest: rounds of many starts, the best
    improved, until one is good enough."""
    memory, rule = Memory({}, {}, {}), ground.rule
    if len(ground.parts) == 1 and len(ground.free) <= rule.exhaustive:
        for tree in every_tree(ground.free):
            _evaluate_forest((tree,), ground, memory)
    else:
        corners = sum(len(part.exterior.coords) for part in ground.parts)
        effort = min(1.0, rule.large / (len(ground.free) * max(corners, 100) / 100))
        for _ in range(rule.rounds if effort == 1.0 else 1):
            starts = [_start(ground, rng) for _ in range(math.ceil(effort * rule.starts))]
            costs = [
                (_evaluate_forest(forest, ground, memory), k) for k, forest in enumerate(starts)
            ]
            best = min(
                _anneal_division(starts[k], ground, memory, rng, math.ceil(effort * rule.steps))
                for _, k in sorted(costs)[: rule.kept]
            )
            if best < rule.good * len(ground.free):
                break
    return {forest: row for forest, row in memory.found.items() if np.isfinite(row[0])}


def _anneal_division(
    forest: Forest, ground: ZoningGround, memory: Memory, rng: np.random.Generator, steps: int
) -> float:
    """The cost of a division after annealing it."""
    cost = _evaluate_forest(forest, ground, memory)
    for heat in np.geomspace(*ground.rule.heat, steps):
        which = int(rng.integers(len(forest)))
        trial = (*forest[:which], mutate_tree(forest[which], rng), *forest[which + 1 :])
        new = _evaluate_forest(trial, ground, memory)
        if new <= cost or rng.random() < math.exp((cost - new) / heat):
            forest, cost = trial, new
    return cost


def _start(ground: ZoningGround, rng: np.random.Generator) -> Forest:
    """Zones dealt out over the parts of the floor, each part cut by where zones wish to be."""
    left = np.array([part.area for part in ground.parts])
    scale = left.sum() / sum(ground.areas[zone] for zone in ground.free)
    dealt: list[list[int]] = [[] for _ in ground.parts]
    keys = {zone: ground.areas[zone] * rng.uniform(0.7, 1.4) for zone in ground.free}
    for zone in sorted(ground.free, key=lambda zone: -keys[zone]):
        part = int(np.argmax(left))
        dealt[part].append(zone)
        left[part] -= scale * ground.areas[zone]
    at = _wished_places(ground, rng)
    return tuple(
        placed_tree(zones, at, ground.areas, part.bounds, rng)
        for zones, part in zip(dealt, ground.parts, strict=True)
        if zones
    )


def _wished_places(ground: ZoningGround, rng: np.random.Generator) -> Points:
    """Where zones would like to be (n, 2): at their door, at random, then drawn to those they
    wish to meet (barycentric placement, Tutte 1963)."""
    bounds = np.array([part.bounds for part in ground.parts])
    low, high = bounds[:, :2].min(0), bounds[:, 2:].max(0)
    at = rng.uniform(low, high, (len(ground.areas), 2))
    held = {zone: ground.doors[door].mean(0) for zone, door in ground.at_door.items()}
    held |= {zone: np.array(shape.centroid.coords[0]) for zone, shape in ground.fixed.items()}
    for zone, point in held.items():
        at[zone] = point
    for _ in range(3):
        for i, j, _, _ in ground.pairs:
            middle = (at[i] + at[j]) / 2
            for zone in (i, j):
                if zone not in held:
                    at[zone] += 0.3 * (middle - at[zone])
    return at


def _evaluate_forest(forest: Forest, ground: ZoningGround, memory: Memory) -> float:
    """The cost of a division, looked up or found and kept."""
    if forest not in memory.found:
        pieces: dict[int, FloorPart] | None = {}
        for number, (tree, part) in enumerate(zip(forest, ground.parts, strict=False)):
            made = divide(FloorPart(number, part), tree, ground.areas, memory.cuts)
            pieces = None if made is None or pieces is None else pieces | made
        cost = math.inf if pieces is None else round(_cost(pieces, ground, memory.flaws), 6)
        memory.found[forest] = (cost, pieces or {})
    return memory.found[forest][0]


def flaw(shape: shapely.Polygon, narrow_weight: float = USUAL_ZONING.narrow) -> float:
    """How far a zone is from a good shape, 0 for a square: ``(2 - 32 A / P²)³`` where it is
    longer than a square (area A, outer perimeter P), the share by which its convex hull is
    larger, and ``narrow_weight`` times the square metres in ends too narrow for a box of 0.3 of its
    mean side (2 m at most)."""
    area = shape.area
    long = max(2.0 - 32.0 * area / shapely.length(shape.exterior) ** 2, 0.0)
    hollow = shapely.convex_hull(shape).area / area - 1.0
    if hollow < 0.01:
        return min(long**3, 3.0) + hollow
    outer, radius = shapely.Polygon(shape.exterior), min(0.3 * math.sqrt(area), 2.0) / 2
    core = outer.buffer(-radius, join_style="mitre")
    narrow = outer.area - core.buffer(radius, join_style="mitre").area
    return float(min(long**3, 3.0) + hollow + narrow_weight * min(narrow, 1.0))


def _cost(pieces: dict[int, FloorPart], ground: ZoningGround, flaws: dict[int, float]) -> float:
    shapes = {zone: piece.shape for zone, piece in pieces.items()} | dict(ground.fixed)
    cost, rule = 0.0, ground.rule
    for piece in pieces.values():
        if piece.number not in flaws:
            flaws[piece.number] = flaw(piece.shape, rule.narrow)
        cost += flaws[piece.number]
    cost += sum(
        rule.pair * weight * _apart(shapes[i], shapes[j], width)
        for i, j, width, weight in ground.pairs
        if i in pieces or j in pieces
    )
    cost += sum(
        rule.door * _away(shapes[zone], ground.doors[door]) for zone, door in ground.at_door.items()
    )
    if len(ground.parts) > 1:
        whole = sum(part.area for part in ground.parts)
        all_areas = sum(ground.areas[zone] for zone in ground.free)
        wished = {zone: ground.areas[zone] * whole / all_areas for zone in pieces}
        cost += rule.area * sum(abs(pieces[z].shape.area / wished[z] - 1.0) for z in pieces)
    return cost + rule.cut_door * _cut_doors(list(shapes.values()), ground.doors)


def _apart(one: shapely.Polygon, two: shapely.Polygon, width: float) -> float:
    """0 for two zones that share a border of ``width``, 1 where they just touch, more beyond."""
    x0, y0, x1, y1 = one.bounds
    u0, v0, u1, v1 = two.bounds
    gap = math.hypot(max(u0 - x1, x0 - u1, 0.0), max(v0 - y1, y0 - v1, 0.0))
    if gap > SHARED_BORDER:
        return 1.0 + min(gap / 10.0, 1.0)
    border = one.intersection(two).length
    if border == 0.0:  # beside a zone with an outline, which is kept a millimetre away
        border = one.buffer(SHARED_BORDER, quad_segs=1).intersection(two).length / 2
    return max(1.0 - border / (width + SHARED_BORDER), 0.0)


def _away(shape: shapely.Polygon, door: Points) -> float:
    (ax, ay), (bx, by) = door.tolist()
    gap = shape.distance(shapely.Point((ax + bx) / 2, (ay + by) / 2))
    return 0.0 if gap < 0.15 else 1.0 + min(gap / 10.0, 1.0)


def _cut_doors(shapes: list[shapely.Polygon], doors: Points) -> int:
    """How many doors have their two ends in different zones."""
    if len(doors) == 0:
        return 0
    within = shapely.intersects_xy(np.array(shapes)[:, None, None], doors[..., 0], doors[..., 1])
    holder = np.where(within.any(0), within.argmax(0), -1)
    return int((holder[:, 0] != holder[:, 1]).sum())
