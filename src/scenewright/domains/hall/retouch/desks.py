"""Desks at which visitors arrive or pay: at a wall near the entrance, beside the way in, not across
it; counters of one group side by side."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.patterns import CHAIN
from scenewright.domains.hall.problem import Floats, HallProblem, Ints
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.retouch.desk_groups import Desks, find_desks, is_at_door
from scenewright.domains.hall.retouch.lines import line_up
from scenewright.domains.hall.retouch.places import all_over, walk_edges
from scenewright.domains.hall.retouch.weigh_rows import list_faults, look_rows, measure_places
from scenewright.domains.hall.rules.serving import SERVING
from scenewright.domains.hall.terms.state import Kept

WALL_PITCH, PROPOSED, APART = 0.4, 120, 0.9
"""Metres between two places that are tried along a wall, how many of the best of them, and the
least distance of as many others."""
DESK_ROWS = tuple(row.id for row in SERVING if row.id != "tills_far")
"""The rows of desks."""
TURNED = ("desk_back", "seats_behind_desk")
"""Those for which a desk is turned half round."""
LOOSE_BACK, STAFF_DEPTH = 0.3, 0.9
"""Metres that a back or side may be farther from a wall than staff needs, and what they need
at least."""
FROM_CORNER = 0.05
"""Metres from the end of a wall at which a row begins at least."""
MOST_OFF_WALL, LINES, SHORT_ROW = 4.0, 24, 6.5
"""Metres off a wall beyond which more count no more, how many lines through other objects are
tried, and the longest row that may stand with its side at a wall, in metres."""
AMID = 0.7
"""The most that metres off a wall count of a desk to ask at where no desk stands in the zone of the
entrance, and metres between the free-standing places tried."""
PER_ROW_OF_DESKS = 2.0
"""Metres that each further row of a group counts."""
ROUND_DESKS = 4.0
"""Metres ahead of and behind where they stand that are tried with such desks turned half round."""


def desks_adrift(desks: Desks, kept: Kept, boxes: Floats) -> float:
    """The faults of all desks, in metres, of boxes (n, 5); of several rows of one group, each but
    the first counts as well."""
    units = find_desks(desks, kept)
    return sum(_fault(desks, kept, boxes, unit) for unit in units)


def _fault(desks: Desks, kept: Kept, boxes: Floats, unit: int) -> float:
    """The fault of the desks of one unit among boxes (n, 5), in metres."""
    rows, box = int(kept.rows[unit, 1]), box_round(boxes[slice(*desks.problem.units.spans[unit])])
    parted = PER_ROW_OF_DESKS * (rows - 1) if int(kept.rows[unit, 0]) == CHAIN else 0.0
    return float(_measure_places(desks, kept, boxes, unit, box[None])[0]) + parted


def _measure_places(desks: Desks, kept: Kept, boxes: Floats, unit: int, places: Floats) -> Floats:
    """The faults (k,) of the desks of a unit at places (k, 5) among boxes (n, 5), in metres."""
    first = not desks.first or is_at_door(desks.problem, unit)
    off = measure_off_wall(desks.problem, places, unit, MOST_OFF_WALL if first else AMID)
    seen = look_rows(DESK_ROWS, desks.problem)
    return off + measure_places(seen, kept, boxes, unit, places)


def measure_off_wall(problem: HallProblem, boxes: Floats, unit: int, most: float) -> Floats:
    """Metres (n,) that the backs of desks (n, 5) of a unit, or the sides of short ones, are off a
    wall beyond what staff needs; more than the ``most`` count no more."""
    middles, (width, depth) = boxes[:, :2], boxes[:, 3:, None].swapaxes(0, 1)
    front = np.stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])], axis=1)
    row = int(problem.units.spans[unit, 0])
    staff = max(float(problem.units.clear[row, 2]), STAFF_DEPTH)
    side = 0.5 * width * np.stack([front[:, 1], -front[:, 0]], axis=1)
    edges = _find_edges(problem, row, float(boxes[:, 3].max(initial=0.0)))
    adrift = far_from(edges, middles - 0.5 * depth * front) - staff
    aside = np.minimum(far_from(edges, middles - side), far_from(edges, middles + side))
    adrift = np.where(boxes[:, 3] <= SHORT_ROW, np.minimum(adrift, aside), adrift)
    found: Floats = np.minimum(np.maximum(adrift - LOOSE_BACK, 0.0), most)
    return found


def _find_edges(problem: HallProblem, row: int, wide: float) -> Floats:
    """The edges (e, 4) at which desks may have their backs, ``row`` being the first: the walls of
    the hall; the edges of their zone where no wall of that is as long as they are wide."""
    ground, units = problem.ground, problem.units
    zone = int(units.zones[np.searchsorted(units.spans[:, 1], row, side="right")])
    walls = ground.stretches[ground.stretches[:, 4] == zone, :4]
    if (_lengths(walls) > wide + FROM_CORNER).any():
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
        places = _places(problem, boxes, unit)
        box = box_round(boxes[slice(*problem.units.spans[unit])])
        broken = {
            b.row.id for k, b in list_faults(look_rows(TURNED, problem), kept, boxes) if k == unit
        }
        if desks.first and ("desk_back" in broken or not is_at_door(problem, unit)):
            places = np.concatenate([places, _spread(problem, unit)])
        if broken:
            sat = "seats_behind_desk" in broken
            places = np.concatenate([places, _turn_round(box, ROUND_DESKS if sat else 0.0)])
        faults = _measure_places(desks, kept, boxes, unit, places)
        better = np.flatnonzero(faults < _fault(desks, kept, boxes, unit))
        for number in _spaced(places, better[np.argsort(faults[better], kind="stable")]):
            yield line_up(problem, kept, unit, places[number])


def _turn_round(box: Floats, most: float) -> Floats:
    """Boxes (n, 5) of desks turned half round, where they stand and up to ``most`` metres ahead
    or behind."""
    steps = WALL_PITCH * np.arange(-int(most / WALL_PITCH), int(most / WALL_PITCH) + 1)
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
    staff = max(float(problem.units.clear[first, 2]), STAFF_DEPTH)
    box = np.array([0.0, 0.0, 0.0, sizes[:, 0].sum(), sizes[:, 1].max()])
    others = np.delete(boxes[:, :2], np.arange(first, last), axis=0)
    behind, found = problem.ground.stretches, [np.zeros((0, 5))]
    behind = behind[behind[:, 4] == zone, :4]
    if not (_lengths(behind) > box[3] + FROM_CORNER).any():
        behind = _find_edges(problem, first, float(box[3]))
    for start, way, left, length in walk_edges(behind):
        heading = float(np.arctan2(left[1], left[0]))
        aside = ((0.5 * np.pi, 0.05), (-0.5 * np.pi, 0.05)) if box[3] <= SHORT_ROW else ()
        for turn, off in ((0.0, staff), *aside):
            wide, deep = (box[3], box[4]) if turn == 0.0 else (box[4], box[3])
            near, far = 0.5 * wide + FROM_CORNER, length - 0.5 * wide
            along = np.arange(near, far, WALL_PITCH)
            along = np.append(along, _lines((others - start) @ way, near, far))
            first = off + 0.5 * deep
            offs = np.append(first, _lines((others - start) @ left, first, first + LOOSE_BACK))
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
