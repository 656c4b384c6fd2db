"""The main exhibit: in the middle of its zone, on the entrance axis where that passes near."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.hall.patterns import RADIATION, SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.banquets import FEWEST as BANQUET
from scenewright.domains.hall.retouch.lines import count_objects
from scenewright.domains.hall.retouch.places import stand_at
from scenewright.domains.hall.retouch.rings import FEWEST, propose_rings
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.domains.hall.terms.visitors import MAIN, RAYS, STAGE, TABLE
from scenewright.geometry.inside import lie_inside

PER_OFF, MOST_OFF_PLACE, IN_PLACE, PER_HIDDEN = 1.0, 10.0, 1.5, 60.0
"""What a metre off the place of the main exhibit counts, metres beyond which more count no more
and within which it has its place, and what more the energy counts where it is hidden."""
PER_ALONG, ACROSS = 0.15, 2.0
"""Costs of a metre along the axis of the entrance, and of one off it."""
AXIS_BESIDE, RIM = 0.5, 0.8
"""How far off the middle of a zone the axis of the entrance may pass for its main exhibit to stand
on it, as a share of the root of its floor, and metres between that and its edge."""
SLIDES = (0.0, -0.8, 0.8, -1.6, 1.6, -2.4, 2.4, -3.2, 3.2, -4.0, 4.0)
"""Metres along the axis from where it passes nearest to the middle that are tried for room."""
SHIFTS = (-2.4, -1.2, -0.5, 0.0, 0.5, 1.2, 2.4)
PARTS = (0.3, 0.5, 0.7, 0.85)
"""Metres beside the place, and parts of the way there, that are tried."""


class MainExhibit(NamedTuple):
    """The unit of a main exhibit that stands free, the ``place`` (2,) where it belongs, the
    direction (2,) of the ``axis`` of the entrance if that is on it (else 0), and its problem."""

    unit: int
    place: Floats
    axis: Floats
    problem: HallProblem


def find_exhibit(problem: HallProblem) -> MainExhibit | None:
    """The main exhibit of a hall and its place; None without one, where seats look at it, and where
    it is the stage of a band."""
    roles, targets = problem.visitors.roles.astype(int), problem.units.targets
    mains = [unit for unit in range(len(roles)) if roles[unit] & MAIN and unit not in targets]
    if not mains or _is_of_band(problem, mains[0]):
        return None
    first, last = problem.ground.zone_spans[int(problem.units.zones[mains[0]])].astype(int)
    edges = problem.ground.zone_edges[first:last]
    (area, middle), axis = find_middle(edges), np.zeros(2)
    for door, inward in zip(problem.visitors.entrances[:1], problem.visitors.inward, strict=True):
        on_axis = door + float((middle - door) @ inward) * inward
        near = float(np.hypot(*(on_axis - middle))) <= AXIS_BESIDE * np.sqrt(area)
        spots = (on_axis + along * inward for along in SLIDES) if near else ()
        for spot in (spot for spot in spots if _has_room(problem, mains[0], edges, spot)):
            middle, axis = spot, inward
            break
    inside = lie_inside(edges, middle[:1], middle[1:])[0]
    return MainExhibit(mains[0], middle, axis, problem) if inside else None


def _is_of_band(problem: HallProblem, unit: int) -> bool:
    """Whether a unit is a stage before which no banquet sits: it stands at a wall."""
    roles, zones = problem.visitors.roles.astype(int), problem.units.zones
    tables = count_objects(problem)[(roles & TABLE > 0) & (zones == zones[unit])].max(initial=0)
    return bool(roles[unit] & STAGE) and tables < BANQUET


def _has_room(problem: HallProblem, unit: int, edges: Floats, point: Floats) -> bool:
    """Whether a unit of one object has room about a point (2,) of a zone by its edges (e, 4)."""
    size = problem.units.sizes[int(problem.units.spans[unit, 0])]
    lines = shapely.multilinestrings(shapely.linestrings(edges.reshape(-1, 2, 2)))
    far = float(shapely.distance(shapely.points(point), lines))
    return bool(lie_inside(edges, point[:1], point[1:])[0]) and far >= 0.5 * max(size) + RIM


def find_middle(edges: Floats) -> tuple[float, Floats]:
    """The area and the centre of gravity (2,) of a zone by its directed edges (e, 4), the zone on
    their left.

    >>> square = np.array([[0.0, 0, 4, 0], [4, 0, 4, 2], [4, 2, 0, 2], [0, 2, 0, 0]])
    >>> find_middle(square)[1].tolist()
    [2.0, 1.0]
    """
    x0, y0, x1, y1 = edges.T
    cross = x0 * y1 - x1 * y0
    area = 0.5 * float(cross.sum())
    middle: Floats = np.array([((x0 + x1) * cross).sum(), ((y0 + y1) * cross).sum()]) / (6.0 * area)
    return area, middle


def stand_aside(
    exhibit: MainExhibit | None,
    kept: Kept,
    boxes: Floats,  # noqa: ARG001
) -> float:
    """Metres from the main exhibit of a layout to its place; 0 without one."""
    if exhibit is None or int(kept.rows[exhibit.unit, 0]) != SINGLE:
        return 0.0
    return PER_OFF * min(_measure_way(exhibit, kept), MOST_OFF_PLACE)


def charge_hiding(
    exhibit: MainExhibit | None,
    kept: Kept,  # noqa: ARG001
    boxes: Floats,  # noqa: ARG001
    p: PreparedHall,
    s: State,
) -> float:
    """What the energy of a measured state would be less if it counted lines of sight to the main
    exhibit by more than it does: nothing, or less than that where something hides it."""
    if exhibit is None or p.main < 0 or not len(s.shade):
        return 0.0
    hidden = int(np.bitwise_or.reduce(s.shade.astype(np.int64)))
    return -PER_HIDDEN * hidden.bit_count() / RAYS


def _measure_way(exhibit: MainExhibit, kept: Kept) -> float:
    """Metres from the main exhibit to its place; those along the axis count less than those off
    it."""
    off = kept.pose[exhibit.unit, :2] - exhibit.place
    if not exhibit.axis.any():
        return float(np.hypot(*off))
    along, across = off @ exhibit.axis, off @ (exhibit.axis[1], -exhibit.axis[0])
    return float(np.hypot(PER_ALONG * along, ACROSS * across))


def find_placed(exhibit: MainExhibit | None, kept: Kept) -> list[int]:
    """The main exhibit where it has its place."""
    near = exhibit is not None and _measure_way(exhibit, kept) <= IN_PLACE
    return [exhibit.unit] if exhibit is not None and near else []


def propose_places(exhibit: MainExhibit | None, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the main exhibit at its place, about it, and on the way there, as it looks and
    turned by a right angle."""
    if exhibit is None or int(kept.rows[exhibit.unit, 0]) != SINGLE:
        return
    here = kept.pose[exhibit.unit, :2]
    spots = [exhibit.place + np.array([dx, dy]) for dx in SHIFTS for dy in SHIFTS]
    spots += [here + part * (exhibit.place - here) for part in PARTS]
    turns = kept.pose[exhibit.unit, 2] + np.array([0.0, 0.5 * np.pi])
    places = (np.append(spot, turn) for spot in spots for turn in turns)
    yield from stand_at(kept, exhibit.unit, places)
    ringed = _set_in_rings(exhibit, kept)
    yield from propose_rings(exhibit.problem, ringed, boxes) if ringed is not kept else ()


def _set_in_rings(exhibit: MainExhibit, kept: Kept) -> Kept:
    """The layout with the largest unit that may stand in rings in the zone of the main exhibit set
    so, the exhibit at its place."""
    units = exhibit.problem.units
    sizes, zone = count_objects(exhibit.problem), units.zones[exhibit.unit]
    free = units.choices[:, RADIATION].astype(bool) & (units.zones == zone) & (sizes >= FEWEST)
    if not free.any():
        return kept
    ring = int(np.argmax(np.where(free, sizes, 0)))
    pose, rows = kept.pose.copy(), kept.rows.copy()
    pose[exhibit.unit, :2], rows[ring] = exhibit.place, (RADIATION, 1)
    return kept._replace(pose=pose, rows=rows)
