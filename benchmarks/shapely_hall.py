"""The hall's energies the way they are usually written: one shapely object a box.

The reference the compiled kernels are held against, and the baseline of their speed. Energies of
Cao, Cheng, Zhang 2024, eqs. 1-5, repaired as in the documents of this project.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import shapely
import shapely.affinity
from numpy.typing import NDArray

from benchmarks.shapely_home import rectangle
from scenewright.domains.hall.problem import HallProblem

Floats = NDArray[np.float64]
TAU, EPSILON, NEAR, CELL = 0.05, 1.5, 1.0, 0.05
LOOSE = ("single", "wall")
"""Patterns without rows: their extent is their clearances, and they have no neighbours."""


class Laid(NamedTuple):
    """How a unit is laid out: its pattern by name, its heading, the objects of each layer."""

    pattern: str
    heading: float
    layers: tuple[int, ...]


def barrier(x: float) -> float:
    """φ(x) = 1 / (x + √(x² + τ²)), for x < 0 in the form that does not cancel."""
    root = math.hypot(x, TAU)
    return 1.0 / (x + root) if x > 0 else (root - x) / TAU**2


def grown(box: Floats, clear: Floats) -> Floats:
    """A footprint (5,) with its clear depths at front, left, back and right."""
    x, y, heading, width, depth = box
    front, left, back, right = clear
    ahead, aside = (front - back) / 2, (left - right) / 2
    cos, sin = math.cos(heading), math.sin(heading)
    return np.array(
        [
            x + cos * ahead - sin * aside,
            y + sin * ahead + cos * aside,
            heading,
            width + left + right,
            depth + front + back,
        ]
    )


def polygon(edges: Floats) -> Any:
    """The polygon of directed edges (e, 4): rings counter-clockwise, holes clockwise."""
    starts = [
        0,
        *(k + 1 for k in range(len(edges) - 1) if np.any(edges[k, 2:] != edges[k + 1, :2])),
    ]
    rings = [edges[a:b, :2] for a, b in pairwise([*starts, len(edges)])]
    shells = [ring for ring in rings if shapely.LinearRing(ring).is_ccw]
    holes = [ring for ring in rings if not shapely.LinearRing(ring).is_ccw]
    return shapely.union_all([shapely.Polygon(ring) for ring in shells]).difference(
        shapely.union_all([shapely.Polygon(ring) for ring in holes])
    )


def edge_gap(a: Floats, b: Floats) -> float:
    """μ: distance of two boxes along the line of their centres, edge to edge."""
    step = b[:2] - a[:2]
    far = math.hypot(*step)
    if far < 1e-9:
        return 0.0
    along = step / far
    for box in (a, b):
        front = np.array([math.cos(box[2]), math.sin(box[2])])
        right = np.array([front[1], -front[0]])
        far -= abs(along @ right) * box[3] / 2 + abs(along @ front) * box[4] / 2
    return float(far)


def neighbours(layers: Sequence[int], first: int) -> Iterator[tuple[int, int]]:
    """Pairs of consecutive objects in each layer, and the first ones of layers in turn."""
    starts = [first + sum(layers[:k]) for k in range(len(layers))]
    for start, number in zip(starts, layers, strict=True):
        yield from pairwise(range(start, start + number))
    yield from pairwise(starts)


class ShapelyHall:
    """A hall with one shapely object for each box and zone."""

    def __init__(self, problem: HallProblem) -> None:
        ground, self.units = problem.ground, problem.units
        self.weights, self.least = problem.weights, ground.zone_least
        self.floor = polygon(ground.edges)
        self.zones = [polygon(ground.zone_edges[a:b]) for a, b in ground.zone_spans]
        self.obstacles = [rectangle(box) for box in ground.obstacles]
        self.keep_free = [rectangle(box) for box in ground.keep_free]
        self.borders, self.links = ground.borders, ground.links
        self.owner = np.repeat(np.arange(len(self.units.spans)), np.diff(self.units.spans).ravel())

    def depths(self, laid: Sequence[Laid]) -> Floats:
        """Clear depths (n, 4) with a way round the ends of rows that stand side by side."""
        depths = np.array(self.units.clear, np.float64)
        for (first, _), unit in zip(self.units.spans, laid, strict=True):
            start = int(first)
            for number in unit.layers if unit.pattern == "chain" else ():
                for end, side in ((start, 1), (start + number - 1, 3)):
                    if number > 1 and depths[end, side] == 0.0:
                        depths[end, side] = self.units.clear[end].max()
                start += number
        return depths

    def space(self, clears: list[Any], boxes: Floats, solids: list[Any]) -> list[float]:
        """E_s of each unit."""
        covered = np.zeros(len(self.units.spans))
        for i, clear in enumerate(clears):
            covered[self.owner[i]] += clear.area - clear.intersection(self.floor).area
            covered[self.owner[i]] += sum(clear.intersection(solid).area for solid in solids)
            for j in range(i):
                shared = clear.intersection(clears[j]).area
                covered[self.owner[i]] += shared
                if self.owner[j] != self.owner[i]:
                    covered[self.owner[j]] += shared
        spare = [
            rectangle(grown(box, depth)).area - box[3] * box[4]
            for box, depth in zip(boxes, self.units.clear, strict=True)
        ]
        wished = np.maximum(np.bincount(self.owner, spare, len(covered)), 1e-9)
        with np.errstate(over="ignore"):
            shares = 1.0 / (1.0 + np.exp(-covered / wished))
        return [barrier(float(EPSILON - 2.0 * EPSILON * share)) for share in shares]

    def extent(self, clears: list[Any], heading: float) -> Any:
        """X_u: the box with a heading that bounds all clearances."""
        turned = shapely.affinity.rotate(
            shapely.MultiPolygon(clears), -heading, (0, 0), use_radians=True
        )
        return shapely.affinity.rotate(
            shapely.box(*turned.bounds), heading, (0, 0), use_radians=True
        )

    def fill(self, clears: list[Any], laid: Sequence[Laid]) -> dict[int, float]:
        """E_u of each zone that holds units."""
        used: dict[int, float] = {}
        for (first, last), zone, unit in zip(self.units.spans, self.units.zones, laid, strict=True):
            shapes = clears[first:last]
            if unit.pattern not in LOOSE:
                shapes = [self.extent(shapes, unit.heading)]
            area = sum(shape.intersection(self.zones[zone]).area for shape in shapes)
            used[int(zone)] = used.get(int(zone), 0.0) + area / self.zones[zone].area
        return {z: barrier(1.0 - float(self.least[z]) / max(used[z], 1e-6)) for z in sorted(used)}

    def free_run(self, border: Floats, width: float, shapes: list[Any]) -> float:
        """The longest free stretch of a border in whole cells of 0.05 m: floor to ``width`` metres
        on both sides, and nothing on it."""
        start, step = border[:2], border[2:4] - border[:2]
        length = math.hypot(*step)
        along = step / length
        left = np.array([-along[1], along[0]]) * width
        near = [
            s for s in shapes if s.distance(shapely.LineString(border[:4].reshape(2, 2))) <= width
        ]
        run = best = 0
        for k in range(math.floor(length / CELL)):
            a, b = start + along * k * CELL, start + along * (k + 1) * CELL
            cell = shapely.Polygon([a - left, b - left, b + left, a + left])
            taken = cell.difference(self.floor).area > 1e-9 or any(
                cell.intersection(shape).area > 1e-9 for shape in near
            )
            run = 0 if taken else run + 1
            best = max(best, run)
        return best * CELL

    def access(self, shapes: list[Any]) -> list[float]:
        """E_a of each link."""
        costs = []
        for number, (_, _, width) in enumerate(self.links):
            borders = [border for border in self.borders if int(border[4]) == number]
            widest = max((self.free_run(b, width, shapes) for b in borders), default=0.0)
            costs.append(math.exp(max(width - widest, 0.0)) - 1.0)
        return costs

    def proportion(self, boxes: Floats, laid: Sequence[Laid]) -> list[float]:
        """E_p of each unit."""
        reach = self.units.clear.max(axis=1)
        costs = []
        for (first, _), unit in zip(self.units.spans, laid, strict=True):
            total = 0.0
            for i, j in neighbours(unit.layers, int(first)) if unit.pattern not in LOOSE else ():
                most = float(reach[i] + reach[j]) + NEAR
                total += barrier(1.0 - max(edge_gap(boxes[i], boxes[j]) - most, 0.0) / most)
            costs.append(total)
        return costs

    def violations(self, shapes: list[Any], solids: list[Any]) -> dict[str, float]:
        """Greatest area in square metres by which one footprint leaves its zone, two overlap,
        and one meets a solid. A move that makes any of them positive is refused."""
        zones = [self.zones[self.units.zones[unit]] for unit in self.owner]
        return {
            "outside": max(
                (s.difference(z).area for s, z in zip(shapes, zones, strict=True)), default=0.0
            ),
            "overlap": max(
                (a.intersection(b).area for k, a in enumerate(shapes) for b in shapes[:k]),
                default=0.0,
            ),
            "blocked": max((a.intersection(b).area for a in shapes for b in solids), default=0.0),
        }

    def energies(
        self, boxes: Floats, laid: Sequence[Laid], partitions: Floats, judged: bool = True
    ) -> dict[str, float]:
        """Every part by name; see :func:`energies`. Without ``judged`` the hard rules are left
        out."""
        shapes = [rectangle(box) for box in boxes]
        clears = [rectangle(grown(b, c)) for b, c in zip(boxes, self.depths(laid), strict=True)]
        standing = self.obstacles + [rectangle(box) for box in partitions]
        solids = standing + self.keep_free
        rows = {
            "space": dict(enumerate(self.space(clears, boxes, solids))),
            "fill": self.fill(clears, laid),
            "access": dict(enumerate(self.access(shapes + standing))),
            "proportion": dict(enumerate(self.proportion(boxes, laid))),
        }
        parts = {f"{name}/{k}": cost for name, row in rows.items() for k, cost in row.items()}
        sums = {name: float(sum(row.values())) for name, row in rows.items()}
        total = sum(self.weights.get(name, 0.0) * cost for name, cost in sums.items())
        rules = self.violations(shapes, solids) if judged else {}
        return parts | sums | {"total": total} | rules


def energies(
    problem: HallProblem, boxes: Floats, laid: Sequence[Laid], partitions: Floats
) -> dict[str, float]:
    """Every part of the energy of one layout.

    ``boxes`` (n, 5) footprints, ``laid`` one row a unit, ``partitions`` (h, 5) boxes of generated
    walls. Keys: ``space/u`` and ``proportion/u`` by unit, ``fill/z`` by zone, ``access/l`` by
    link; their sums ``space``, ``fill``, ``access``, ``proportion``; the weighted ``total``; and
    ``outside``, ``overlap``, ``blocked``, the greatest areas in square metres by which a hard
    rule is broken.
    """
    return ShapelyHall(problem).energies(boxes, laid, partitions)
