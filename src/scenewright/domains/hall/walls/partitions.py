"""Generated walls: where a zone has less wall than its wall objects need.

The demand is 100 (M + 1) + Σ l centimetres for M objects of length l (Cao, Cheng, Zhang 2024,
after George 2015, The Curator's Handbook); ours takes no metre between objects that ask for no
clearance at their sides. Walls go on borders of zones that do not follow each other in the
visiting order first; where the border is a passage, gaps stay at both ends of the wall. Ours may
also stand off a border, and free in a zone whose borders give too little.
"""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

import numpy as np
import shapely
import shapely.ops

from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.hall_layout import Zone, ZoneLink
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.zoning.assign import Unit
from scenewright.domains.hall.zoning.borders import Border

WALL_BETWEEN = 1.0
SHORTEST = 1.2
HOST_ASIDE, ROAM = 3.0, 6.0
"""How far a wall may stand off its border, and one within a zone off the middle, in metres."""
SPARE_WALL = 0.3
"""Metres by which a gap exceeds its passage, and a wall the need of its objects."""


TRIMS, BEYOND_BORDER = (0.0, 0.1, 0.2, 0.3), 1e-4
"""Metres taken off both ends of a wall where a slanting wall of the hall cuts its corner, and
square metres of it that may lie outside."""


class Host(NamedTuple):
    """A border that carries a wall, or may: row of x0, y0, x1, y1, zone left, zone right, the
    wall's start and end along it (equal: none yet), those of the longest it may carry, and how far
    to the right (negative) and left it may stand off the border, in metres. One within a zone
    has that zone on both its sides."""

    row: tuple[float, float, float, float, float, float]
    span: tuple[float, float]
    most: tuple[float, float]
    shift: tuple[float, float] = (0.0, 0.0)


def wall_needed(wish: HallDemand, count: int, printed: bool) -> float:
    """Metres of wall for some objects of a demand."""
    side = wish.clearance[1] + wish.clearance[3]
    between = WALL_BETWEEN if printed or side > 0.0 else 0.0
    return sum(size.width for size in wish.sizes[:count]) + between * (count + 1)


def lacking(units: list[Unit], wishes: list[HallDemand], walls: Floats, printed: bool) -> Floats:
    """Metres of wall (z,) that the zones have less than they need; 0 or less: none."""
    need = -np.array(walls, np.float64)
    for unit in units:
        if wishes[unit.demand].at_wall:
            need[unit.zone] += wall_needed(wishes[unit.demand], unit.last - unit.first, printed)
    return need


def visiting_order(links: tuple[ZoneLink, ...], names: tuple[str, ...], first: int) -> list[int]:
    """Zones as a visitor meets them from the zone of the entrance on: breadth first."""
    order: list[int] = []
    waiting = deque([first])
    while waiting or len(order) < len(names):
        zone = waiting.popleft() if waiting else min(set(range(len(names))) - set(order))
        if zone in order:
            continue
        order.append(zone)
        for link in links:
            pair = (names.index(link.first), names.index(link.second))
            if zone in pair:
                waiting.append(pair[1] if pair[0] == zone else pair[0])
    return order


def hosts(
    borders: tuple[Border, ...],
    links: tuple[ZoneLink, ...],
    names: tuple[str, ...],
    order: list[int],
    lack: Floats,
    spare: bool = False,
) -> tuple[Host, ...]:
    """Walls on borders until no zone lacks any, or borders run out; with ``spare`` also borders
    on which a search may build more.

    ``lack`` (z,) metres of wall that each zone is short of.
    """
    widths = {frozenset((link.first, link.second)): link.width for link in links}
    left = np.array(lack, np.float64)
    found: list[Host] = []
    for border in sorted(borders, key=lambda b: _rank(b, widths, names, order)):
        want = max(left[border.first], left[border.second])
        if want <= 0.0 and not spare:
            continue
        gap = widths.get(frozenset((names[border.first], names[border.second])), 0.0)
        most = _span(border, gap, _length(border))
        span = _span(border, gap, want) if want > 0.0 else (0.0, 0.0)
        span = span if spare else most
        if span is None or most is None:
            continue
        row = (*border.start, *border.end, float(border.first), float(border.second))
        found.append(Host(row, span, most, (0.0, 0.0) if spare else (-HOST_ASIDE, HOST_ASIDE)))
        left[[border.first, border.second]] -= span[1] - span[0]
    return tuple(found)


def standing_hosts(zones: tuple[Zone, ...], lack: Floats, gap: float) -> tuple[Host, ...]:
    """Walls that stand free in zones which borders do not give enough: parallel to the longest
    edge, through the middle, with room to walk round at both ends and along both sides; things
    hang on both. ``lack`` (z,) metres of wall that zones are short of, ``gap`` that room."""
    found = []
    for number, zone in enumerate(zones):
        if lack[number] <= 0.0:
            continue
        shape = shapely.Polygon(zone.outline, zone.holes)
        steps = np.diff(np.vstack([zone.outline, zone.outline[:1]]), axis=0)
        way = steps[int(np.argmax(np.hypot(*steps.T)))]
        way = way / np.hypot(*way)
        middle, far = np.array(shape.centroid.coords[0]), np.hypot(*np.ptp(zone.outline, axis=0))
        line = shapely.LineString([middle - far * way, middle + far * way])
        inner = line.intersection(shape.buffer(-gap - SPARE_WALL))
        pieces = [p for p in shapely.get_parts(inner).tolist() if p.length >= SHORTEST]
        if not pieces:
            continue
        best = max(pieces, key=lambda piece: piece.length)
        (x0, y0), (x1, y1) = best.coords[0], best.coords[-1]
        half = 0.5 * min(max(0.5 * lack[number] + SPARE_WALL, SHORTEST), best.length)
        span = (0.5 * best.length - half, 0.5 * best.length + half)
        row = (x0, y0, x1, y1, float(number), float(number))
        found.append(Host(row, span, (0.0, float(best.length)), (-ROAM, ROAM)))
    return tuple(found)


def stands_free(host: Host) -> bool:
    """Whether a wall stands within a zone, not on a border."""
    return host.row[4] == host.row[5]


def refit_host(
    host: Host, border: Border, gap: float, floor: shapely.Polygon, thickness: float
) -> Host | None:
    """A host whose border has moved, no longer than lies on the ``floor`` of the hall with its
    ``thickness``; None if no wall may stand there any more."""
    most = _span(border, gap, _length(border))
    if most is None:
        return None
    line = shapely.LineString([border.start, border.end])
    for cut in TRIMS:
        low, high = most[0] + cut, most[1] - cut
        if high - low < SHORTEST:
            break
        wall = shapely.ops.substring(line, low, high).buffer(0.5 * thickness, cap_style="flat")
        if wall.difference(floor).area < BEYOND_BORDER:
            span = min(max(host.span[0], low), high), min(max(host.span[1], low), high)
            row = (*border.start, *border.end, *host.row[4:])
            return host._replace(row=row, span=span, most=(low, high))
    return None


def short_of(hosts: tuple[Host, ...], lack: Floats) -> Floats:
    """Metres of wall (z,) that zones still lack with the walls of some hosts at their longest."""
    left = np.array(lack, np.float64)
    for host in hosts:
        first, second = int(host.row[4]), int(host.row[5])
        np.subtract.at(left, [first, second], host.most[1] - host.most[0])
    return left


def _length(border: Border) -> float:
    return float(np.hypot(border.end[0] - border.start[0], border.end[1] - border.start[1]))


def _rank(
    border: Border, widths: dict[frozenset[str], float], names: tuple[str, ...], order: list[int]
) -> tuple[bool, bool, float]:
    linked = frozenset((names[border.first], names[border.second])) in widths
    apart = abs(order.index(border.first) - order.index(border.second))
    return linked, apart == 1, -_length(border)


def _span(border: Border, gap: float, want: float) -> tuple[float, float] | None:
    """Where a wall may stand on a border: all of it, or its middle between two gaps, or beside
    one gap; as long as it needs to be."""
    length = _length(border)
    need = want + SPARE_WALL
    if gap == 0.0:
        return (0.0, min(need, length)) if length >= SHORTEST else None
    room = length - 2 * (gap + SPARE_WALL)
    if room >= max(SHORTEST, min(need, 0.6 * length)):
        half = 0.5 * min(need, room)
        return (0.5 * length - half, 0.5 * length + half)
    room = length - gap - SPARE_WALL
    return (0.0, min(need, room)) if room >= SHORTEST else None
