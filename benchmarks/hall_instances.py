"""A hall to measure on, built by hand: two zones, a column, a cut corner, five groups.

24 m by 14 m, zones "west" and "east" that meet at x = 12, a door in the west wall. With
``scale`` the hall grows by its square root in both directions and the groups by it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.hall.patterns import PATTERNS
from scenewright.domains.hall.problem import HallGround, HallProblem, Units

Floats = NDArray[np.float64]
PAPER = {"space": 1.0, "fill": 1.0, "access": 1.0, "proportion": 1.0}


def ring(points: Sequence[tuple[float, float]] | Floats) -> Floats:
    """Directed edges (e, 4) of a closed ring of points (e, 2)."""
    corners = np.asarray(points, float)
    return np.hstack([corners, np.roll(corners, -1, axis=0)])


def square(x: float, y: float, side: float) -> list[tuple[float, float]]:
    """The corners of a square hole, clockwise, with its lower left corner at x, y."""
    return [(x, y), (x, y + side), (x + side, y + side), (x + side, y)]


def ground(size: float = 1.0) -> HallGround:
    """The hall and its zones, all lengths times ``size``."""
    column = ring(square(4.0, 7.0, 0.6))
    west = np.vstack([ring([(0, 0), (12, 0), (12, 14), (0, 14)]), column])
    east = ring([(12, 0), (24, 0), (24, 10), (20, 14), (12, 14)])
    hall = np.vstack([ring([(0, 0), (24, 0), (24, 10), (20, 14), (0, 14)]), column])
    walls = [
        (12, 14, 0, 14, 0, 0),
        (0, 4, 0, 0, 0, 0),
        (0, 0, 12, 0, 0, 1),
        (12, 0, 24, 0, 1, 0),
        (24, 0, 24, 10, 1, 1),
        (24, 10, 20, 14, 1, 1),
        (20, 14, 12, 14, 1, 1),
    ]
    scale = np.array([size, size, size, size, 1.0])
    border = np.array([[12.0, 0.0, 12.0, 14.0, 0.0]]) * scale
    columns = np.array([size, size, size, size, 1.0, 1.0])
    return HallGround(
        edges=hall * size,
        obstacles=np.array([[18.0 * size, 12.0 * size, 0.3, 1.0, 1.0]]),
        keep_free=np.array([[0.75, 6.0 * size, 0.0, 2.0, 1.5]]),
        doors=np.array([[-0.1, 6.0 * size, 0.0, 2.0, 0.2]]),
        zone_edges=np.vstack([west, east]) * size,
        zone_spans=np.array([[0, len(west)], [len(west), len(west) + len(east)]]),
        zone_areas=np.array([168.0 - 0.36, 160.0]) * size**2,
        zone_bounds=np.array([[0.0, 0.0, 12.0, 14.0], [12.0, 0.0, 24.0, 14.0]]) * size,
        zone_least=np.zeros(2),
        stretches=np.array(walls, float) * columns,
        borders=border,
        links=np.array([[0.0, 1.0, 1.2]]),
        hosts=np.hstack([border[:, :4], [[0.0, 1.0]]]),
        bounds=np.array([0.0, 0.0, 24.0, 14.0]) * size,
    )


GROUPS: tuple[tuple[str, int, float, float, tuple[float, float, float, float], int], ...] = (
    ("showcases", 9, 1.2, 0.6, (0.9, 0.2, 0.6, 0.2), 0),
    ("wall", 8, 1.0, 0.4, (1.0, 0.0, 0.0, 0.0), 0),
    ("plinths", 8, 0.7, 0.7, (0.7, 0.7, 0.7, 0.7), 1),
    ("tables", 12, 1.4, 0.8, (0.6, 0.3, 0.6, 0.3), 1),
    ("landmark", 1, 1.5, 1.5, (1.0, 1.0, 1.0, 1.0), 1),
)
"""Name, objects, width, depth, clear depths at front, left, back, right, zone."""


def units(counts: Sequence[int]) -> Units:
    """The groups with so many objects each."""
    sizes = [
        (width, depth)
        for (_, _, width, depth, _, _), n in zip(GROUPS, counts, strict=True)
        for _ in range(n)
    ]
    clear = [row[4] for row, n in zip(GROUPS, counts, strict=True) for _ in range(n)]
    ends = np.cumsum(counts)
    choices = np.ones((len(counts), len(PATTERNS)), np.int64)
    codes = {name: code for code, name in enumerate(PATTERNS)}
    choices[:, [codes["single"], codes["wall"]]] = 0
    choices[[1, 4]] = 0
    choices[1, codes["wall"]] = choices[4, codes["single"]] = 1
    return Units(
        np.array(sizes),
        np.array(clear),
        np.tile(np.array([1, 0, 0, 0]), (len(sizes), 1)),
        np.column_stack([ends - counts, ends]),
        np.array([row[5] for row in GROUPS]),
        choices,
        np.arange(len(counts)),
        np.full(len(counts), -1),
    )


def example_hall(scale: float = 1.0) -> HallProblem:
    """The hall with 38 objects, or about ``scale`` times as many in so much more room."""
    counts = [max(round(row[1] * scale), 1) for row in GROUPS]
    counts[4] = 1
    work, names = units(counts), tuple(row[0] for row in GROUPS)
    floor = ground(math.sqrt(scale))
    floor = floor._replace(zone_least=zone_least(work, floor.zone_areas))
    return HallProblem(floor, work, names, ("west", "east"), dict(PAPER), 0.9)


def zone_least(work: Units, zone_areas: Floats) -> Floats:
    """A share of each zone to be in use (z,): 0.8 of what the clearances would cover."""
    areas = (work.sizes[:, 0] + work.clear[:, 1] + work.clear[:, 3]) * (
        work.sizes[:, 1] + work.clear[:, 0] + work.clear[:, 2]
    )
    zones = np.repeat(work.zones, work.spans[:, 1] - work.spans[:, 0])
    asked = np.bincount(zones, areas, len(zone_areas))
    least: Floats = np.minimum(0.8 * asked / zone_areas, 0.9)
    return least
