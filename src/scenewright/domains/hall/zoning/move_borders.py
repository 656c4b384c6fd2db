"""Borders of zones searched together with the objects in them: ours.

A line of borders moves where the zones beside it are used unevenly (eq. 8 of Cao, Cheng and Zhang
2024): the fuller side expands. The layout stays; what it costs with the new zones decides, and
what was gained is then annealed on. Zones that are drawn keep their outlines unless their brief
gives them ``slack``.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.arranging.verdict import better
from scenewright.core.brief import Room
from scenewright.core.layout import FIT
from scenewright.domains.hall.build_problem import (
    HallContext,
    build_problem,
    hall_of,
    taken_floor,
    zone_areas,
)
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.problem import Floats, Ints
from scenewright.domains.hall.search import (
    Cancel,
    HallSearch,
    Progress,
    may_retry,
    show_found,
    take_share,
)
from scenewright.domains.hall.solvers.chains import begin_chain, cooled_hall, layout_of
from scenewright.domains.hall.solvers.outcome import HallFound, verdict_on
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.walls.clear_of_openings import clear_hosts
from scenewright.domains.hall.walls.partitions import Host, refit_host, stands_free
from scenewright.domains.hall.zoning.borders import Border, floor_of, shared_borders
from scenewright.domains.hall.zoning.shifted_zones import BorderLine, border_lines, shift_zones
from scenewright.domains.hall.zoning.zones import HallPlan
from scenewright.engine.draws import streams

BORDER_SLACK = 1.5
"""How far the borders of a proposed zone may move, in metres, unless its brief says otherwise."""


class ShiftedHall(NamedTuple):
    """A hall with its zones as they lie now, what was found there, and how far each line of borders
    has moved, by the names of the zones on both its sides."""

    hall: HallContext
    fitted: Fitted
    found: HallFound
    shifts: tuple[tuple[str, float], ...] = ()


def read_slack(room: Room, hall: HallContext) -> Floats:
    """Metres (z,) by which borders of each zone may move."""
    asked = {zone.id: zone for zone in room.zones}
    found = []
    for name in hall.names:
        zone = asked.get(name)
        usual = 0.0 if zone is not None and zone.outline is not None else BORDER_SLACK
        found.append(usual if zone is None or zone.slack is None else zone.slack)
    return np.array(found, np.float64)


def may_move(search: HallSearch, slack: Floats) -> bool:
    """Whether any border may move: not by the presets as printed, nor by other solvers."""
    lines = search.preset.settings.borders.lines
    return may_retry(search) and lines > 0 and int((slack > 0.0).sum()) > 1


def search_with_borders(search: HallSearch, slack: Floats) -> HallSearch:
    """The search with what is left of its budget where a part is kept for moving borders."""
    rule = search.preset.settings.borders
    left = 1.0 - rule.lines * rule.share
    if not may_move(search, slack):
        return search
    return search._replace(budget=take_share(search.budget, left))


def move_borders(
    search: HallSearch,
    fitted: Fitted,
    found: HallFound,
    slack: Floats,
    progress: Progress | None,
    cancel: Cancel | None,
) -> ShiftedHall:
    """Borders moved while that lowers the energy, in turn with annealing the objects.

    ``slack`` (z,) metres each zone allows. Only a layout in which nothing is wrong is touched.
    """
    now, best = ShiftedHall(search.hall, fitted, found), found.layouts[0]
    if best.missed or best.lacking or not may_move(search, slack):
        return now
    rule, lines = search.preset.settings.borders, border_lines(now.hall.borders)
    uneven = sorted(lines, key=lambda line: -abs(_fuller(now, line)))
    for turn, line in enumerate(uneven[: rule.lines]):
        if cancel is not None and cancel():
            break
        moved = _shift(search, now, line, slack)
        moved = moved and _anneal(search, moved, search.seed + turn, cancel)
        if moved is not None and _gains(moved, now, rule.gain):
            show_found(search, moved.fitted, now.found, moved.found, FIT, "a border of zones moved")
            now = moved
            if progress is not None:
                name, metres = now.shifts[-1]
                progress(1.0, f"energy {_energy(now):.1f}, border {name} moved {metres:+.2f} m")
    return now


def _shift(
    search: HallSearch, now: ShiftedHall, line: BorderLine, slack: Floats
) -> ShiftedHall | None:
    """A line moved into its emptier side, as far as it can be of a few steps; None if it cannot."""
    most = min(slack[k] for k in line.zones)
    side = 1.0 if _fuller(now, line) < 0.0 else -1.0
    for share in search.preset.settings.borders.steps if most > 0.0 else ():
        tried = _shift_line(search, now, line, side * share * most)
        if tried:
            return min(tried, key=_energy)
    return None


def _gains(moved: ShiftedHall, now: ShiftedHall, least: float) -> bool:
    """Whether a line moved is better by ``least`` energy."""
    after, before = (verdict_on(one.found.layouts[0]) for one in (moved, now))
    return better(after, before, least)


def _energy(moved: ShiftedHall) -> float:
    return moved.found.layouts[0].energy


def _fuller(now: ShiftedHall, line: BorderLine) -> float:
    """By how much the share of floor taken is greater left of a line than right of it."""
    units, areas = now.fitted.problem.units, now.fitted.problem.ground.zone_areas
    zone_of = np.repeat(units.zones, np.diff(units.spans)[:, 0])
    taken = np.bincount(zone_of, units.sizes.prod(1), len(areas))
    shares = [taken[list(side)].sum() / areas[list(side)].sum() for side in (line.left, line.right)]
    return float(shares[0] - shares[1])


def _name(now: ShiftedHall, line: BorderLine) -> str:
    sides = (", ".join(now.hall.names[k] for k in sorted(side)) for side in (line.left, line.right))
    return " | ".join(sides)


def _shift_line(
    search: HallSearch, now: ShiftedHall, line: BorderLine, metres: float
) -> list[ShiftedHall]:
    """The same layout where a line lies ``metres`` to its left, and with the groups on the side
    that it moves into carried along; without what cannot be."""
    hall = now.hall
    zones = shift_zones(hall.plan.zones, line, metres, hall.space)
    borders = shared_borders(zones or ())
    thickness = now.fitted.problem.ground.thickness
    hosts = _follow(now.fitted.hosts, hall, borders, thickness) if zones is not None else None
    if zones is None or hosts is None:
        return []
    plan = HallPlan(zones, hall.plan.links)
    there = hall_of(
        hall.space, plan, borders, hall.fixed, hall.route, hall.beside, hall.passage
    )._replace(settings=hall.settings)
    if (zone_areas(there) <= 0.0).any():
        return []
    units, kept = now.fitted.units, now.found.layouts[0].kept
    weights = search.preset.weights
    problem = build_problem(there, search.wishes, units, hosts, weights, search.catalog)
    start = kept._replace(walls=_within(kept.walls, hosts))
    starts = (start, _carry(start, problem.units.zones, line, metres))
    fitted = (Fitted(units, hosts, problem, one) for one in starts)
    measured = (_measure_shifted(there, one, now, _name(now, line), metres) for one in fitted)
    return [one for one in measured if one is not None]


def _carry(start: Kept, zones: Ints, line: BorderLine, metres: float) -> Kept:
    """A layout whose free groups on the side that a line moves into move with it."""
    side = line.left if metres > 0.0 else line.right
    moving = np.isin(zones, list(side)) & (start.rows[:, 0] != WALL)
    pose = start.pose.copy()
    pose[moving, :2] += metres * np.array([-line.way[1], line.way[0]])
    return start._replace(pose=pose)


def _measure_shifted(
    hall: HallContext, fitted: Fitted, now: ShiftedHall, name: str, metres: float
) -> ShiftedHall | None:
    """A shifted hall with its layout measured; None where it breaks a rule."""
    chain = begin_chain(fitted.problem, fitted.start, streams(0, 1)[0])
    if not np.isfinite(chain.tally[0]):
        return None
    layout = layout_of(chain)
    if layout.missed or layout.lacking:
        return None
    found = now.found._replace(layouts=(layout,), evaluations=now.found.evaluations + 1)
    before = dict(now.shifts)
    shifts = {**before, name: float(before.get(name, 0.0) + metres)}
    return ShiftedHall(hall, fitted, found, tuple(shifts.items()))


def _follow(
    hosts: tuple[Host, ...], hall: HallContext, borders: tuple[Border, ...], thickness: float
) -> tuple[Host, ...] | None:
    """The hosts of walls on the borders as they lie now; None if one has lost its border."""
    widths = {frozenset((k.first, k.second)): k.width for k in hall.plan.links}
    found: list[Host] = []
    for host in hosts:
        if stands_free(host):
            found.append(host)
            continue
        pair = int(host.row[4]), int(host.row[5])
        near = [border for border in borders if (border.first, border.second) == pair]
        middle = 0.5 * (np.array(host.row[:2]) + np.array(host.row[2:4]))
        gap = widths.get(frozenset(hall.names[k] for k in pair), 0.0)
        if not near:
            return None
        border = min(near, key=lambda b: _far(b, middle))
        moved = refit_host(host, border, gap, floor_of(hall.space), thickness)
        if moved is None:
            return None
        found.append(moved)
    kept = clear_hosts(tuple(found), taken_floor(hall), thickness)
    return kept if len(kept) == len(hosts) else None


def _far(border: Border, point: Floats) -> float:
    middle = 0.5 * (np.array(border.start) + np.array(border.end))
    return float(np.hypot(*(middle - point)))


def _within(walls: Floats, hosts: tuple[Host, ...]) -> Floats:
    """Walls (p, 2) no longer than their hosts let them be."""
    most = np.array([host.most for host in hosts], np.float64).reshape(-1, 2)
    found: Floats = np.where(
        walls[:, :1] < walls[:, 1:], np.clip(walls, most[:, :1], most[:, 1:]), walls
    )
    return found


def _anneal(
    search: HallSearch, moved: ShiftedHall, seed: int, cancel: Cancel | None
) -> ShiftedHall:
    """What was gained, cooled again with a share of the budget; never worse."""
    budget = take_share(search.budget, search.preset.settings.borders.share)
    start: Kept = moved.found.layouts[0].kept
    more = cooled_hall(moved.fitted.problem, start, budget, seed, None, cancel)
    layouts = (*moved.found.layouts, *more.layouts)
    ranked = sorted(layouts, key=lambda one: (one.missed + one.lacking, one.energy))
    seen = moved.found.evaluations + more.evaluations
    return moved._replace(found=moved.found._replace(layouts=tuple(ranked), evaluations=seen))
