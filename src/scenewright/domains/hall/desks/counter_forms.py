"""Forms in which several counters of a demand stand where its brief leaves that open.

One line at a wall, with its staff before the wall; one free-standing line; two lines back to back,
their staff between them; two lines at walls. Each is one object until it is furnished.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from scenewright.catalog.kinds import KINDS
from scenewright.core.scene import Size
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.zoning.borders import WallStretch

COUNTER = "counter"
"""Of what several stand in a line unless the brief says otherwise."""
RACKS = ("coat_rack",)
ROUND = 2.4
"""Metres by which a zone is longer than its free-standing line, for the way round both ends."""


def leaves_line_open(wish: HallDemand) -> bool:
    """Whether a demand is of several like counters whose place nothing says."""
    alike = len({size[:2] for size in wish.sizes}) == 1
    free = wish.unplaced and not wish.facing and not any(wish.clearance[1::2])
    return wish.category == COUNTER and len(wish.sizes) > 1 and alike and free and not wish.least


def list_forms(
    hall: HallContext, wish: HallDemand, small: Sequence[HallDemand]
) -> Iterator[HallDemand]:
    """The forms of a demand for which its zones are long enough, the best first; none of what does
    not leave its place open, and none at walls where racks for coats are to stand at these, of the
    ``small`` objects that are set last."""
    if not leaves_line_open(wish):
        return
    number, wide = len(wish.sizes), wish.sizes[0].width
    walls, longest = _measure_zones(hall, wish)
    free = not _shares_walls(wish, small)
    if free and (walls // (number * wide)).any():
        yield _line_at_wall(wish, 1)
    if number * wide + ROUND <= longest:
        yield _line_free(wish)
    if not wish.before and number % 2 == 0 and 0.5 * number * wide + ROUND <= longest:
        yield _stand_back_to_back(wish)
    if free and number % 2 == 0 and number > 2 and (walls // (0.5 * number * wide)).sum() > 1:
        yield _line_at_wall(wish, 2)


def _shares_walls(wish: HallDemand, small: Sequence[HallDemand]) -> bool:
    """Whether racks for coats stand at the walls of the zones of a demand."""
    racks = (other.zones for other in small if other.category in RACKS)
    return any(set(zones) & set(wish.zones) for zones in racks)


def _measure_zones(hall: HallContext, wish: HallDemand) -> tuple[np.ndarray, float]:
    """Metres of each piece of wall (w,) of the zones of a demand, and how far the longest of these
    reaches."""
    mine = [k for k, name in enumerate(hall.names) if not wish.zones or name in wish.zones]
    walls = [_length(wall) for k in mine for wall in hall.walls[k]]
    reach = [float(np.ptp(hall.plan.zones[k].outline, axis=0).max()) for k in mine]
    return np.array(walls, np.float64), max(reach, default=0.0)


def _length(wall: WallStretch) -> float:
    return float(np.hypot(wall.x1 - wall.x0, wall.y1 - wall.y0))


def _line_at_wall(wish: HallDemand, lines: int) -> HallDemand:
    """So many lines at walls, with the room of the staff behind them."""
    front, left, _, right = wish.clearance
    staff = KINDS[wish.category].staff
    mine = tuple(size._replace(depth=size.depth + staff) for size in wish.sizes)
    row = mine[: len(mine) // lines]
    sizes = (_join(row, row[0].depth),) * lines
    free = (front, left, 0.0, right)
    return wish._replace(sizes=sizes, row=row, staff=staff, patterns=("wall",), clearance=free)


def _line_free(wish: HallDemand) -> HallDemand:
    """One free-standing line."""
    whole = _join(wish.sizes, wish.sizes[0].depth)
    return wish._replace(sizes=(whole,), row=wish.sizes, patterns=("single",))


def _stand_back_to_back(wish: HallDemand) -> HallDemand:
    """Two lines back to back, served from between them."""
    row, (front, left, _, right) = wish.sizes[: len(wish.sizes) // 2], wish.clearance
    whole = _join(row, 2.0 * row[0].depth + KINDS[wish.category].staff)
    free = (front, left, front, right)
    return wish._replace(sizes=(whole,), row=row, double=True, patterns=("single",), clearance=free)


def _join(row: tuple[Size, ...], depth: float) -> Size:
    """The size of a row of objects, of a depth of its own."""
    return Size(sum(size.width for size in row), depth, max(size.height for size in row))
