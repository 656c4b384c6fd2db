"""Where a unit may stand: the layouts that rows of faults propose, whatever the fault."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import product

import numpy as np

from scenewright.core.layout import corners
from scenewright.domains.hall.patterns import ACROSS, ALONG, CHAIN, GRID
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import count_objects, find_layers, set_rows
from scenewright.domains.hall.terms.state import Kept

ALL_OVER, WALL_STEP, WALL_PLACES, CLOSE = 9, 0.5, 200, 0.02
"""Places along each side of a zone, metres between those along its walls, how many of these at
most, and what is left between a wall and a back at it, in metres."""
EDGES, LEAST_STRIP, WIDEST = (1.0, 0.75, 0.5), 0.3, 2.6
"""Widths of the strips round rows, in those of their gaps, the least of them, and how wide gaps are
made; metres."""
FEWER, MORE = 2, 1
"""How many rows fewer and more are tried."""
NUDGES, TURNS = (0.15, 0.3, 0.5, 0.8, 1.2), 8
"""Metres by which a unit is moved a little, and in how many directions."""
ACROSS_WAY = 0.05
"""Metres by which two things overlap across a way at least for one to bound the other along it."""


def stand_at(kept: Kept, unit: int, poses: Iterable[Sequence[float] | Floats]) -> Iterator[Kept]:
    """Layouts with a unit in its form at each of some poses (k, 2 to 4)."""
    for own in poses:
        pose = kept.pose.copy()
        pose[unit, : len(own)] = own
        yield kept._replace(pose=pose)


def shift(kept: Kept, units: int | list[int], by: Floats) -> Kept:
    """The layout with some units moved by some metres (2,)."""
    pose = kept.pose.copy()
    pose[units, :2] += by
    return kept._replace(pose=pose)


def before(
    frame: Floats, ahead: Iterable[float], aside: Iterable[float], turn: float = 0.0
) -> list[Floats]:
    """Poses (3,) ``ahead`` and ``aside`` (right) metres from a frame (x, y, heading), turned by
    ``turn`` to it.

    >>> [pose.tolist() for pose in before(np.zeros(3), [2.0], [0.0, 1.0])]
    [[2.0, 0.0, 0.0], [2.0, -1.0, 0.0]]
    """
    x, y, heading = frame[:3]
    way = np.array([np.cos(heading), np.sin(heading)])
    right = np.array([way[1], -way[0]])
    return [
        np.array([*(np.array([x, y]) + far * way + beside * right), heading + turn])
        for far, beside in product(ahead, aside)
    ]


def nudge(kept: Kept, unit: int) -> Iterator[Kept]:
    """Layouts with a unit moved a little, ahead, aside and between."""
    turns = float(kept.pose[unit, 2]) + 2.0 * np.pi * np.arange(TURNS) / TURNS
    for way in np.column_stack([np.cos(turns), np.sin(turns)]):
        yield from (shift(kept, unit, step * way) for step in NUDGES)


def all_over(problem: HallProblem, unit: int, heading: float) -> list[Floats]:
    """Poses (3,) all over the zone of a unit, at a heading and turned by quarters from it."""
    low, high = problem.ground.zone_bounds[int(problem.units.zones[unit])].reshape(2, 2)
    parts = (np.arange(ALL_OVER) + 0.5) / ALL_OVER
    spots = (low + np.array(part) * (high - low) for part in product(parts, repeat=2))
    return [np.array([*spot, heading + 0.5 * np.pi * k]) for spot, k in product(spots, range(4))]


def at_walls(problem: HallProblem, unit: int) -> list[Floats]:
    """Poses (4,) of one object with its back at the walls of its zone."""
    wide, deep = problem.units.sizes[problem.units.spans[unit, 0]]
    found = list[Floats]()
    for start, way, left, length in walk_walls(problem, unit):
        for t in np.arange(0.5 * wide + CLOSE, length - 0.5 * wide, WALL_STEP):
            at = start + t * way + (0.5 * deep + CLOSE) * left
            found.append(np.array([*at, np.arctan2(left[1], left[0]), 0.0]))
    return found[:: len(found) // WALL_PLACES + 1]


def walk_walls(problem: HallProblem, unit: int) -> Iterator[tuple[Floats, Floats, Floats, float]]:
    """The walls of the zone of a unit (:func:`walk_edges`)."""
    ground = problem.ground
    return walk_edges(ground.stretches[ground.stretches[:, 4] == problem.units.zones[unit]])


def walk_edges(edges: Floats) -> Iterator[tuple[Floats, Floats, Floats, float]]:
    """Where each of some edges (e, 4 or more) begins, its unit direction and that to its left (2,),
    and its length in metres."""
    for x0, y0, x1, y1 in edges[:, :4]:
        length = max(float(np.hypot(x1 - x0, y1 - y0)), 1e-9)
        way = np.array([x1 - x0, y1 - y0]) / length
        yield np.array([x0, y0]), way, np.array([-way[1], way[0]]), length


def along_walls(problem: HallProblem, unit: int) -> list[Floats]:
    """Poses (2,) of a row at walls all along those of its zone, each at either end or in the
    middle of a wall."""
    total = sum(length for *_, length in walk_walls(problem, unit))
    count = min(int(total / WALL_STEP) + 1, WALL_PLACES)
    starts = np.linspace(0.0, total, count, endpoint=False)
    return [np.array(place) for place in product(starts, (-1.0, 0.0, 1.0))]


def fill_floor(
    problem: HallProblem, kept: Kept, boxes: Floats, unit: int, aside: Sequence[float] = (0.0,)
) -> Iterator[Kept]:
    """Layouts with a unit in the middle of the floor free about it, as it is, and in rows as far
    apart as that floor lets them be, in some more and in fewer of them; ``aside`` of that too."""
    axes = find_axes(float(kept.pose[unit, 2]))
    bounds = _find_free(problem, boxes, unit, axes)
    mine = corners(boxes[slice(*problem.units.spans[unit])]).reshape(-1, 2) @ axes.T
    off = bounds.mean(0) - 0.5 * (mine.min(0) + mine.max(0))
    for part in product((1.0, 0.0), repeat=2):
        yield shift(kept, unit, (off * part) @ axes)
    if int(kept.rows[unit, 0]) not in (CHAIN, GRID):
        return
    (first, most), number = find_layers(problem, unit), int(count_objects(problem)[unit])
    size, used = problem.units.sizes[slice(*problem.units.spans[unit])].max(0), kept.rows[unit, 1]
    loose = kept.layers[first, ALONG] > LEAST_STRIP
    for rows in range(max(int(used) - FEWER, 1), min(int(used) + MORE, most, number) + 1):
        columns = -(-number // rows)
        if -(-number // columns) != rows:
            continue
        many, room = np.array([columns, rows]), np.ptp(bounds, axis=0)
        for edges, by in product(product(EDGES, repeat=2), aside):
            gaps = share_room(room, many, size, np.array(edges))
            gaps[0] = gaps[0] if loose else 0.0
            if gaps.min() >= 0.0:
                at = (bounds.mean(0) + np.array([by, 0.0])) @ axes
                pose = (*at, float(kept.pose[unit, 2]))
                yield set_rows(kept, unit, first, number, many, gaps, pose)


def share_room(room: Floats, many: Floats, size: Floats, edges: Floats) -> Floats:
    """Gaps (2,) between ``many`` (2,) objects in a ``room`` (2,) whose outer strips are ``edges``
    gaps wide, or the least; metres."""
    left = room - many * size
    even = left / (many - 1 + 2.0 * edges)
    tight = (left - 2.0 * LEAST_STRIP) / np.maximum(many - 1, 1)
    gaps: Floats = np.minimum(np.where(even * edges < LEAST_STRIP, tight, even), WIDEST)
    return gaps


def widen(problem: HallProblem, kept: Kept, unit: int, by: Iterable[float]) -> Iterator[Kept]:
    """Layouts with wider gaps between the rows of a unit, and between its objects where they have
    gaps."""
    if int(kept.rows[unit, 0]) not in (CHAIN, GRID):
        return
    first = find_layers(problem, unit)[0]
    mine = slice(first, first + int(kept.rows[unit, 1]))
    for more in by:
        layers = kept.layers.copy()
        layers[mine, ACROSS] += more
        layers[mine, ALONG] += more * (kept.layers[mine, ALONG] > 0.1)
        yield kept._replace(layers=layers)


def find_axes(heading: float) -> Floats:
    """Unit vectors (2, 2) to the right and ahead."""
    c, s = float(np.cos(heading)), float(np.sin(heading))
    return np.array([[s, -c], [c, s]])


def _find_free(problem: HallProblem, boxes: Floats, unit: int, axes: Floats) -> Floats:
    """How far the floor about a unit of boxes (n, 5) is free along ``axes`` (2, 2), to the next
    object or the border of its zone (low and high, 2)."""
    first, last = problem.units.spans[unit]
    zone = int(problem.units.zones[unit])
    edges = problem.ground.zone_edges[slice(*problem.ground.zone_spans[zone].astype(int))]
    ring = edges[:, :2] @ axes.T
    seen = corners(np.concatenate([boxes, problem.ground.obstacles])) @ axes.T
    low, high = seen.min(1), seen.max(1)
    begin, end = low[first:last].min(0), high[first:last].max(0)
    others = np.delete(np.arange(len(seen)), np.arange(first, last))
    bounds = np.array([ring.min(0), ring.max(0)])
    for k in range(2):
        over = low[others, 1 - k] < end[1 - k] - ACROSS_WAY
        across = others[over & (high[others, 1 - k] > begin[1 - k] + ACROSS_WAY)]
        middle = 0.5 * (begin[k] + end[k])
        bounds[0, k] = high[across, k][high[across, k] <= middle].max(initial=bounds[0, k])
        bounds[1, k] = low[across, k][low[across, k] >= middle].min(initial=bounds[1, k])
    return bounds
