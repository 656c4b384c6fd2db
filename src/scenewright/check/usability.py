"""How usable a floor is, on an occupancy grid: the figures that the field compares scenes by.

NAV, WFR, ACC, MCW and E-NAV of ZoneMaestro (arXiv 2605.02537), after SceneEval (Tam et al. 2025)
and PhyScene (Yang et al. 2024), as we read them; :func:`measure_usability` says how.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.check.bodies import Bodies, Rooms, Shape, standing_in
from scenewright.check.occupancy import label_parts, lead_from, measure_widths
from scenewright.check.reach import before_sides, stands_on_stage
from scenewright.check.routes import JoinedFloor, blocking_in
from scenewright.core.report import Finding

Flags = NDArray[np.bool_]
Window = tuple[slice, slice]
CELL = 0.05
"""Side of a cell in metres."""
MOST_CELLS = 4_000_000
"""Cells of one floor; cells of a larger one are twice as large, and so on."""
BEFORE = 0.4
"""Metres before a side that have to be free: the robot's width."""
STANDING = 0.5
"""Metres before a side in which one stands to use it."""
NEAR_DOOR = 0.6
"""Metres from a way in within which ways begin."""
WIDE = 3.0
"""Ways wider than this many metres are given as so wide."""


class FloorGrid(NamedTuple):
    """Cells of a floor joined by doors: the south-west corner, the side of a cell, and which cells
    (rows, columns) are ``floor`` of a room, ``free`` of all that stands there (doorways too) and
    ``open_`` once seats are pushed aside."""

    x: float
    y: float
    cell: float
    floor: Flags
    free: Flags
    open_: Flags


class SideCount(NamedTuple):
    """Sides that pieces are used from: how many, how many are wholly clear, and the sum of the
    shares that are."""

    sides: int
    clear: int
    share: float


def measure_usability(
    bodies: Bodies, rooms: Rooms, grounds: Sequence[JoinedFloor], findings: Sequence[Finding]
) -> dict[str, Any]:
    """The figures of all floors together, on cells of :data:`CELL` metres.

    ``nav``: the largest connected part of the free floor over all of it, of each group of rooms
    that doors join (doorways join, but do not count); ``wfr``: free floor over the whole;
    ``acc``: the share of the sides pieces are used from before which nothing stands over
    :data:`BEFORE` metres, and ``acc_area`` the mean share of the ground there that is clear (seats
    pushed aside); ``mcw``: of the widest ways from the entrances to before every piece that is
    used from a side, and into every room, the width of the narrowest, in metres, at most two
    cells too small (0: no way leads to something); ``e_nav``: NAV · max(0, 1 - share of pieces
    out of bounds). None where there is nothing to count.
    """
    largest, free, floor, cell = 0.0, 0.0, 0.0, CELL
    widths: list[float] = []
    counted = SideCount(0, 0, 0.0)
    for ground in grounds:
        grid = lay_grid(bodies, rooms, ground)
        cell = max(cell, grid.cell)
        parts, area = label_parts(grid.free)[grid.floor], grid.cell**2
        largest += float(np.bincount(parts[parts >= 0], minlength=1).max()) * area
        free += float((parts >= 0).sum()) * area
        floor += float(grid.floor.sum()) * area
        more = _count_sides(bodies, ground, grid)
        counted = SideCount(
            counted.sides + more.sides, counted.clear + more.clear, counted.share + more.share
        )
        widths.append(_find_narrowest(bodies, rooms, ground, grid))
    out = len({found.piece for found in findings if found.kind == "out_of_bounds"})
    nav = largest / free if free else None
    inside = max(0.0, 1.0 - out / max(len(bodies.pieces), 1))
    return {
        "cell": cell,
        "nav": _round(nav),
        "wfr": _round(free / floor if floor else None),
        "acc": _round(counted.clear / counted.sides if counted.sides else None),
        "acc_area": _round(counted.share / counted.sides if counted.sides else None),
        "mcw": _round(min(widths) if widths else None),
        "e_nav": _round(None if nav is None else nav * inside),
    }


def lay_grid(bodies: Bodies, rooms: Rooms, ground: JoinedFloor) -> FloorGrid:
    """The cells of a floor, whole cells from its south-west corner."""
    west, south, east, north = shapely.bounds(ground.floor).tolist()
    cell = CELL
    if not math.isfinite(west):
        west = south = east = north = 0.0
    while (east - west) * (north - south) > MOST_CELLS * cell**2:
        cell *= 2.0
    shape = [max(math.ceil(size / cell - 1e-9), 1) for size in (north - south, east - west)]
    none = FloorGrid(west, south, cell, *(np.zeros(shape, bool) for _ in range(3)))
    floor, free = np.zeros(shape, bool), np.zeros(shape, bool)
    window, inside = mark_cells(none, ground.floor)
    free[window] = inside
    for room in ground.rooms:
        window, inside = mark_cells(none, rooms.shapes[room])
        floor[window] |= inside
    standing = np.flatnonzero(standing_in(bodies, ground.rooms) & bodies.underfoot)
    staying = blocking_in(bodies, ground.rooms)
    open_ = free.copy()
    for rows, cells in ((standing, free), (staying, open_)):
        for footprint in bodies.footprints[rows]:
            window, inside = mark_cells(none, footprint)
            cells[window] &= ~inside
    return FloorGrid(west, south, cell, floor, free, open_)


def mark_cells(grid: FloorGrid, shape: Shape) -> tuple[Window, Flags]:
    """The rows and columns of cells about a shape, and which of those have their middle in it."""
    low, high = np.split(np.nan_to_num(shapely.bounds(shape)), 2)
    corner, most = np.array([grid.x, grid.y]), np.array(grid.floor.shape[::-1])
    first = np.clip(np.floor((low - corner) / grid.cell).astype(int), 0, most)
    last = np.clip(np.ceil((high - corner) / grid.cell).astype(int), first, most)
    x, y = (
        start + (np.arange(a, b) + 0.5) * grid.cell
        for start, a, b in zip(corner, first, last, strict=True)
    )
    shapely.prepare(shape)
    window = slice(first[1], last[1]), slice(first[0], last[0])
    return window, shapely.contains_xy(shape, x[None, :], y[:, None])


def _count_sides(bodies: Bodies, ground: JoinedFloor, grid: FloorGrid) -> SideCount:
    """How clear the sides are that pieces of a floor are used from."""
    sides, clear, share = 0, 0, 0.0
    for row in _find_used(bodies, ground):
        for strip in before_sides(bodies, row, BEFORE):
            window, inside = mark_cells(grid, strip)
            # beyond the raster there is no floor
            asked = max(float(shapely.area(strip)) / grid.cell**2, 1.0)
            got = float((grid.open_[window] & inside).sum())
            sides, share = sides + 1, share + min(got / asked, 1.0)
            clear += not (inside & ~grid.open_[window]).any() and got >= 0.9 * asked
    return SideCount(sides, clear, share)


def _find_narrowest(bodies: Bodies, rooms: Rooms, ground: JoinedFloor, grid: FloorGrid) -> float:
    """How wide, in metres, a way over a floor may be to lead everywhere: into every room, and to
    before every piece that is used from a side; at most :data:`WIDE`."""
    starts = np.zeros(grid.floor.shape, bool)
    for point in ground.ways_in:
        window, inside = mark_cells(grid, shapely.buffer(point, NEAR_DOOR))
        starts[window] |= inside
    if not (starts & grid.open_).any():
        parts = label_parts(grid.open_)
        starts = parts == np.bincount(parts[parts >= 0], minlength=1).argmax()
    goals = [mark_cells(grid, rooms.shapes[room]) for room in ground.rooms]
    for row in _find_used(bodies, ground):
        goals.append(mark_cells(grid, shapely.union_all(before_sides(bodies, row, STANDING))))
    most = round(WIDE / grid.cell)
    widths = measure_widths(grid.open_, most)
    low, high = 0, most
    while low < high:
        width = (low + high + 1) // 2
        led = lead_from(widths >= width, starts)
        if all((led[window] & inside).any() for window, inside in goals):
            low = width
        else:
            high = width - 1
    return low * grid.cell


def _find_used(bodies: Bodies, ground: JoinedFloor) -> list[int]:
    """Rows of the pieces of a floor that are used from a side, without seats, which are pushed to
    where one sits, and pieces on a stage, onto which one steps."""
    here = np.flatnonzero(standing_in(bodies, ground.rooms) & ~bodies.seat)
    used = (row for row in here.tolist() if bodies.kinds[row].access)
    return [row for row in used if not stands_on_stage(bodies, row)]


def _round(value: float | None) -> float | None:
    return None if value is None else round(float(value), 4)
