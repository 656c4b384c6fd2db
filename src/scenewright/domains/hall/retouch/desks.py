"""Desks at which visitors arrive or pay: at a wall near the entrance, beside the way in, not across
it; counters of one group side by side."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.layout import corners
from scenewright.domains.hall.desks.unserved import find_staff_floor
from scenewright.domains.hall.measures import DOOR_OUTSIDE
from scenewright.domains.hall.patterns import CHAIN, SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem, Ints
from scenewright.domains.hall.retouch.arrivals import box_round, find_met
from scenewright.domains.hall.retouch.lines import line_up
from scenewright.domains.hall.retouch.places import all_over, walk_edges
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import FIRST, LANE, LOUNGE, MACHINE, RECEPTION, TILL

STEP, PROPOSED, APART = 0.4, 120, 0.9
"""Metres between two places that are tried along a wall, how many of the best of them, and the
least distance of as many others."""
BEHIND, STAFF = 0.3, 0.9
"""Metres that a back or side may be farther from a wall than staff needs, and what they need
at least."""
FAR, TOO_FAR, PAYING, LITTLE = 3.0, 0.4, 0.2, 0.05
"""Metres from the entrance that are near enough, and what each beyond counts: of a desk one comes
to first, of one at which one pays, and of others."""
NEXT = 0.05
"""Metres from the end of a wall at which a row begins at least."""
WAY, WIDE, QUEUE_TRIED = 6.0, 1.2, 1.5
"""Length and half width of the way in that stays free, and depth of the queue, in metres."""
WAITING = 0.3
"""What a square metre of queue on the way in counts, of desk one metre."""
BACK_TO = 6.0
"""What a back turned to the entrance counts, in metres."""
CRAMPED = 2.0
"""What a desk counts behind which a wall leaves nobody room to stand, in metres."""
LONGEST, LINES, SHORT = 4.0, 24, 6.5
"""Metres off a wall beyond which more count no more, how many lines through other objects are
tried, and the longest row that may stand with its side at a wall, in metres."""
AMID = 0.7
"""The most that metres off a wall count of a desk to ask at where no desk stands in the zone of the
entrance, and metres between the free-standing places tried."""
MOST, PARTED = 6, 2.0
"""Desks that one row holds at most, and metres that each further row of a group counts."""
SIDE_OF_STAFF, SAT, MOST_SAT = 3.0, 1.0, 4.0
"""Metres behind a desk where no visitor sits, what each seat there counts, and the most that
they count; metres."""
ROUND = 4.0
"""Metres ahead of and behind where they stand that are tried with such desks turned half round."""
BACK = 2
"""The column of ``access`` that says whether one comes up to a back."""


class Rates(NamedTuple):
    """What each metre too far from the entrance counts, and the most that metres off a wall do."""

    too_far: float
    off_wall: float


class Desks(NamedTuple):
    """Which desks of a problem are seen to: those ``first`` of all, one each in the zone of the
    entrance, or to ask at where none is there, or all others."""

    problem: HallProblem
    first: bool


def first_desks(problem: HallProblem) -> Desks:
    """The desks visitors come to first."""
    return Desks(problem, first=True)


def other_desks(problem: HallProblem) -> Desks:
    """Counters and tills in rows or away from the entrance."""
    return Desks(problem, first=False)


def find_desks(desks: Desks, kept: Kept) -> list[int]:
    """The units served from behind that visitors come to first or last, one desk each or a few in
    a row, but for tills in lanes; none without an entrance."""
    problem, units = desks.problem, desks.problem.units
    roles, firsts = problem.visitors.roles, problem.units.spans[:, 0]
    return [
        unit
        for unit in find_met(problem, kept, FIRST | TILL, MOST, (SINGLE, CHAIN))
        if not int(roles[unit]) & (LANE | MACHINE)
        and units.targets[unit] < 0
        and not units.access[firsts[unit], BACK]
        and desks.first == (int(np.ptp(units.spans[unit])) == 1 and _is_first(problem, unit))
    ]


def _is_first(problem: HallProblem, unit: int) -> bool:
    """Whether a desk stands in the zone of the entrance, or one asks at it and no desk does."""
    if _is_at_door(problem, unit):
        return True
    asks = bool(int(problem.visitors.roles[unit]) & RECEPTION)
    return asks and not any(_is_at_door(problem, k) for k in range(len(problem.units.zones)))


def _is_at_door(problem: HallProblem, unit: int) -> bool:
    """Whether a unit visitors come to first stands in the zone of the entrance."""
    x0, y0, x1, y1 = problem.ground.zone_bounds[problem.units.zones[unit]]
    x, y = problem.visitors.entrances[0]
    inside = (
        x0 - DOOR_OUTSIDE <= x <= x1 + DOOR_OUTSIDE and y0 - DOOR_OUTSIDE <= y <= y1 + DOOR_OUTSIDE
    )
    return bool(inside and int(problem.visitors.roles[unit]) & FIRST)


def desks_adrift(desks: Desks, kept: Kept, boxes: Floats) -> float:
    """The faults of all desks, in metres, of boxes (n, 5); of several rows of one group, each but
    the first counts as well."""
    whole = (
        (unit, box_round(boxes[slice(*desks.problem.units.spans[unit])]))
        for unit in find_desks(desks, kept)
    )
    seats = find_seats(desks.problem, boxes)
    return sum(_fault(desks, kept, unit, box, seats) for unit, box in whole)


def _fault(desks: Desks, kept: Kept, unit: int, box: Floats, seats: Floats) -> float:
    """The fault of the desks of one unit in a ``box`` (5,) round them among ``seats`` (n, 5), in
    metres."""
    row, rows = int(desks.problem.units.spans[unit, 0]), int(kept.rows[unit, 1])
    parted = PARTED * (rows - 1) if int(kept.rows[unit, 0]) == CHAIN else 0.0
    fault = measure_desks(desks.problem, box[None], row, _rate(desks, unit))[0]
    return float(fault) + parted + float(count_behind(box[None], seats)[0])


def find_seats(problem: HallProblem, boxes: Floats) -> Floats:
    """Those of boxes (n, 5) on which visitors sit in a lounge (m, 5)."""
    lounge = problem.visitors.roles.astype(int) & LOUNGE > 0
    return boxes[np.repeat(lounge, np.diff(problem.units.spans, axis=1)[:, 0])]


def count_behind(desks: Floats, seats: Floats) -> Floats:
    """What ``seats`` (m, 5) count that lie on the side of those who serve at desks (n, 5), (n,).

    >>> desk = np.array([[0.0, 0.0, np.pi / 2, 3.0, 0.8]])
    >>> seats = np.array([[0.0, -2.0, 0.0, 0.8, 0.8], [0.0, 2.0, 0.0, 0.8, 0.8]])
    >>> count_behind(desk, seats).tolist()
    [1.0]
    """
    front = np.stack([np.cos(desks[:, 2]), np.sin(desks[:, 2])], axis=1)
    strips = desks.copy()
    strips[:, :2] -= 0.5 * (desks[:, 4:] + SIDE_OF_STAFF) * front
    strips[:, 4] = SIDE_OF_STAFF
    tree = shapely.STRtree(shapely.points(seats[:, :2]))
    hit = tree.query(shapely.polygons(corners(strips)), "intersects")[0]
    found: Floats = np.minimum(SAT * np.bincount(hit, minlength=len(desks)), MOST_SAT)
    return found


def _rate(desks: Desks, unit: int) -> Rates:
    """What counts for the desk of a unit."""
    if not desks.first:
        pays = int(desks.problem.visitors.roles[unit]) & TILL
        return Rates(PAYING if pays else LITTLE, LONGEST)
    return Rates(TOO_FAR, LONGEST if _is_at_door(desks.problem, unit) else AMID)


def measure_desks(problem: HallProblem, boxes: Floats, row: int, rates: Rates) -> Floats:
    """How far desks (n, 5) are from where one looks for them (n,): metres their back is off a wall
    beyond what staff needs, how far they are from the entrance, how much of them and their
    queue lies on the way in, whether they turn their back to the entrance, and whether a wall
    behind them leaves nobody room to serve."""
    door, inward = problem.visitors.entrances[0], problem.visitors.inward[0]
    middles, (width, depth) = boxes[:, :2], boxes[:, 3:, None].swapaxes(0, 1)
    front = np.stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])], axis=1)
    staff = max(float(problem.units.clear[row, 2]), STAFF)
    side = 0.5 * width * np.stack([front[:, 1], -front[:, 0]], axis=1)
    edges = _find_edges(problem, row, float(boxes[:, 3].max(initial=0.0)))
    adrift = far_from(edges, middles - 0.5 * depth * front) - staff
    aside = np.minimum(far_from(edges, middles - side), far_from(edges, middles + side))
    adrift = np.where(boxes[:, 3] <= SHORT, np.minimum(adrift, aside), adrift)
    far = np.hypot(*(middles - door).T)
    turned = BACK_TO * _turn_back(problem, boxes)
    adrift = np.minimum(np.maximum(adrift - BEHIND, 0.0), rates.off_wall)
    before = middles + 0.5 * (depth + QUEUE_TRIED) * front
    queues = np.column_stack([before, boxes[:, 2:4], np.full(len(boxes), QUEUE_TRIED)])
    middle, ahead = door + 0.5 * WAY * inward, np.arctan2(inward[1], inward[0])
    free = shapely.polygons(corners(np.array([[*middle, ahead, 2 * WIDE, WAY]])))[0]
    across = _share(boxes, free) + WAITING * _share(queues, free)
    cramped = CRAMPED * _is_cramped(problem, boxes)
    return adrift + rates.too_far * np.maximum(far - FAR, 0.0) + across + turned + cramped


def _turn_back(problem: HallProblem, boxes: Floats) -> NDArray[np.bool_]:
    """Which of some desks (n, 5) turn their back to the entrance."""
    off = problem.visitors.entrances[0] - boxes[:, :2]
    front = np.stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])], axis=1)
    return np.asarray((off * front).sum(1) < -0.3 * np.hypot(*off.T), bool)


def _is_cramped(problem: HallProblem, boxes: Floats) -> NDArray[np.bool_]:
    """Which of some desks (n, 5) have a wall too near behind for anybody to stand there."""
    strips = find_staff_floor(boxes)
    walls = shapely.linestrings(problem.ground.edges[:, :4].reshape(-1, 2, 2))
    cramped = np.zeros(len(boxes), np.bool_)
    cramped[shapely.STRtree(walls).query(shapely.polygons(corners(strips)), "intersects")[0]] = True
    return cramped


def _share(boxes: Floats, free: shapely.Polygon) -> Floats:
    """Square metres (n,) of boxes (n, 5) on some floor."""
    return shapely.area(shapely.intersection(shapely.polygons(corners(boxes)), free))


def _find_edges(problem: HallProblem, row: int, wide: float) -> Floats:
    """The edges (e, 4) at which desks may have their backs, ``row`` being the first: the walls of
    the hall; the edges of their zone where no wall of that is as long as they are wide."""
    ground, units = problem.ground, problem.units
    zone = int(units.zones[np.searchsorted(units.spans[:, 1], row, side="right")])
    walls = ground.stretches[ground.stretches[:, 4] == zone, :4]
    if (_lengths(walls) > wide + NEXT).any():
        return ground.edges
    return ground.zone_edges[slice(*ground.zone_spans[zone])]


def _lengths(edges: Floats) -> Floats:
    return np.hypot(edges[:, 2] - edges[:, 0], edges[:, 3] - edges[:, 1])


def far_from(edges: Floats, points: Floats) -> Floats:
    """Metres (n,) from points (n, 2) to the nearest of some edges (e, 4)."""
    start, way = edges[:, :2], edges[:, 2:4] - edges[:, :2]
    off = points[:, None] - start
    along = (off * way).sum(2) / np.maximum((way**2).sum(1), 1e-12)
    off = off - np.clip(along, 0.0, 1.0)[..., None] * way
    return np.hypot(off[..., 0], off[..., 1]).min(1)


def propose_desks(desks: Desks, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the desks of one group in a row at a wall of its zone, the best places first."""
    problem = desks.problem
    for unit in find_desks(desks, kept):
        row = int(problem.units.spans[unit, 0])
        places = _places(problem, boxes, unit)
        box = box_round(boxes[slice(*problem.units.spans[unit])])
        back = bool(_turn_back(problem, box[None])[0])
        if desks.first and (back or not _is_at_door(problem, unit)):
            places = np.concatenate([places, _spread(problem, unit)])
        seats = find_seats(problem, boxes)
        sat = count_behind(box[None], seats)[0] > 0.0
        if back or sat:
            places = np.concatenate([places, _turn_round(box, ROUND if sat else 0.0)])
        faults = measure_desks(problem, places, row, _rate(desks, unit))
        faults = faults + count_behind(places, seats)
        now = _fault(desks, kept, unit, box, seats)
        better = np.flatnonzero(faults < now)
        for number in _spaced(places, better[np.argsort(faults[better], kind="stable")]):
            yield line_up(problem, kept, unit, places[number])


def _turn_round(box: Floats, most: float) -> Floats:
    """Boxes (n, 5) of desks turned half round, where they stand and up to ``most`` metres ahead
    or behind."""
    steps = STEP * np.arange(-int(most / STEP), int(most / STEP) + 1)
    places = np.tile(box, (len(steps), 1))
    places[:, :2] += steps[:, None] * np.array([np.cos(box[2]), np.sin(box[2])])
    places[:, 2] += np.pi
    return places


def _spread(problem: HallProblem, unit: int) -> Floats:
    """Boxes (n, 5) of the desk of a unit all over its zone, looking along its sides."""
    size = problem.units.sizes[int(problem.units.spans[unit, 0])]
    return np.array([np.append(pose, size) for pose in all_over(problem, unit, 0.0)])


def _spaced(places: Floats, order: Ints) -> list[int]:
    """The first ``PROPOSED`` of some places (n, 5) in an order, and as many more, none
    near another."""
    apart: list[int] = []
    for number in order[PROPOSED:]:
        if len(apart) == PROPOSED:
            break
        off = np.abs(places[apart, :3] - places[number, :3])
        if not len(apart) or (off.max(1) > APART).all():
            apart.append(int(number))
    return [*order[:PROPOSED].tolist(), *apart]


def _places(problem: HallProblem, boxes: Floats, unit: int) -> Floats:
    """Boxes (n, 5) of the desks of a unit in a row along the walls of their zone, its borders where
    they are too long for these, with room behind them to serve, and with their side there: at even
    steps, and in line with the middles of
    other ``boxes`` (n, 5)."""
    first, last = (int(row) for row in problem.units.spans[unit])
    zone, sizes = int(problem.units.zones[unit]), problem.units.sizes[first:last]
    staff = max(float(problem.units.clear[first, 2]), STAFF)
    box = np.array([0.0, 0.0, 0.0, sizes[:, 0].sum(), sizes[:, 1].max()])
    others = np.delete(boxes[:, :2], np.arange(first, last), axis=0)
    behind, found = problem.ground.stretches, [np.zeros((0, 5))]
    behind = behind[behind[:, 4] == zone, :4]
    if not (_lengths(behind) > box[3] + NEXT).any():
        behind = _find_edges(problem, first, float(box[3]))
    for start, way, left, length in walk_edges(behind):
        heading = float(np.arctan2(left[1], left[0]))
        aside = ((0.5 * np.pi, 0.05), (-0.5 * np.pi, 0.05)) if box[3] <= SHORT else ()
        for turn, off in ((0.0, staff), *aside):
            wide, deep = (box[3], box[4]) if turn == 0.0 else (box[4], box[3])
            near, far = 0.5 * wide + NEXT, length - 0.5 * wide
            along = np.arange(near, far, STEP)
            along = np.append(along, _lines((others - start) @ way, near, far))
            first = off + 0.5 * deep
            offs = np.append(first, _lines((others - start) @ left, first, first + BEHIND))
            t, d = (grid.ravel() for grid in np.meshgrid(along, offs))
            places = np.zeros((len(t), 5))
            places[:, :2] = start + t[:, None] * way + d[:, None] * left
            places[:, 2], places[:, 3:] = heading + turn, box[3:]
            found.append(places)
    return np.concatenate(found)


def _lines(values: Floats, low: float, high: float) -> Floats:
    """The distinct values between two, to the millimetre, thinned out to a maximum."""
    within = np.unique(np.round(values[(values > low) & (values < high)], 3))
    return within[:: max(len(within) // LINES, 1)]
