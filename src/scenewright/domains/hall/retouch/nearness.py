"""Nearness: exhibits, tables and seats keep clear of columns, and lounge seats of other groups.

Nobody sets up a showcase against a column, nor a panel at the back of somebody's armchair: both
look like a mistake, although nothing runs into anything.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.layout import corners
from scenewright.domains.hall.patterns import CHAIN, GRID, WALL
from scenewright.domains.hall.problem import Floats, HallProblem, Ints
from scenewright.domains.hall.retouch.columns import CLEAR, Columns, find_columns, propose_rows
from scenewright.domains.hall.retouch.places import nudge, shift
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import ALOOF, LOUNGE, LOW

Bools = NDArray[np.bool_]
WEIGHT = 8.0
"""What a metre lacking counts: as a fault it is seen at first glance."""
ALONG_WALL = np.array([(along, 0.0) for along in (-1.5, -0.8, -0.4, 0.4, 0.8, 1.5)])
"""By how much a row at walls is moved along them, in metres."""


class Near(NamedTuple):
    """Two units nearer to each other than they should be (-1: a column), and the metres lacking."""

    first: int
    second: int
    lacking: float


class Company(NamedTuple):
    """The columns of a problem, also as ``shapes``, the unit (n,) of each object, and which units
    (g,) keep off columns (``aloof``), seat people in company (``lounge``), or stand before such
    seats (``low``)."""

    columns: Columns
    shapes: tuple[shapely.Polygon, ...]
    unit_of: Ints
    aloof: Bools
    lounge: Bools
    low: Bools


def find_company(problem: HallProblem) -> Company:
    """What has to keep its distance in a problem."""
    columns = find_columns(problem)
    counts = np.diff(problem.units.spans, axis=1)[:, 0]
    roles = problem.visitors.roles.astype(int)
    roles = roles if len(roles) else np.zeros(len(counts), int)
    flags = ((roles & bit) > 0 for bit in (ALOOF, LOUNGE, LOW))
    shapes = tuple(shapely.Polygon(ring) for ring in columns.rings)
    return Company(columns, shapes, np.repeat(np.arange(len(counts)), counts), *flags)


def measure_nearness(company: Company, kept: Kept, boxes: Floats) -> float:
    """Metres that lack between columns and those ``boxes`` (n, 5) that keep off them, and between
    lounge seats and objects of other groups, weighted."""
    return WEIGHT * sum(pair.lacking for pair in find_near(company, kept, boxes))


def find_near(company: Company, kept: Kept, boxes: Floats) -> list[Near]:
    """All that stands nearer than it should in boxes (n, 5)."""
    free = kept.rows[:, 0] != WALL
    aloof = np.flatnonzero((company.aloof & free)[company.unit_of])
    found = _near_columns(company, boxes, aloof) if company.shapes else []
    seats = np.flatnonzero(company.lounge[company.unit_of])
    return found + (_near_seats(company, boxes, seats) if len(seats) else [])


def _near_columns(company: Company, boxes: Floats, aloof: Ints) -> list[Near]:
    shapes = shapely.polygons(corners(boxes[aloof]))
    far = shapely.distance(shapes[:, None], np.array(company.shapes)[None, :])
    return [
        Near(int(company.unit_of[aloof[i]]), -1, CLEAR - float(far[i, c]))
        for i, c in np.argwhere(far < CLEAR)
    ]


def _near_seats(company: Company, boxes: Floats, seats: Ints) -> list[Near]:
    """Pairs of a lounge seat and an object of another unit, each pair of seats once."""
    unit, half = company.unit_of, 0.5 * np.hypot(boxes[:, 3], boxes[:, 4])
    off = boxes[seats, None, :2] - boxes[None, :, :2]
    near = np.hypot(off[..., 0], off[..., 1]) < half[seats, None] + half + CLEAR
    near &= (unit[seats, None] != unit) & ~company.low[unit]
    near &= ~company.lounge[unit] | (unit[seats, None] < unit)
    first, second = np.nonzero(near)
    shapes = shapely.polygons(corners(boxes))
    far = shapely.distance(shapes[seats[first]], shapes[second])
    return [
        Near(int(unit[seats[i]]), int(unit[j]), CLEAR - float(d))
        for i, j, d in zip(first, second, far, strict=True)
        if d < CLEAR
    ]


def propose_distances(company: Company, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one of the groups of ``boxes`` (n, 5) that stand too near to something moved a
    little, or in rows among the columns."""
    near = find_near(company, kept, boxes)
    for unit in sorted({u for pair in near for u in pair[:2] if u >= 0}):
        if kept.rows[unit, 0] == WALL:
            yield from (shift(kept, unit, by) for by in ALONG_WALL)
        else:
            yield from nudge(kept, unit)
    for unit in sorted({pair.first for pair in near if pair.second < 0}):
        if company.columns.problem.units.choices[unit, [CHAIN, GRID]].any():
            yield from propose_rows(company.columns, kept, unit)
