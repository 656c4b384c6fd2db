"""What the groups of a room cost as they stand, beside what is missing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely import Polygon

from scenewright.catalog.classes import BEDS
from scenewright.core.same import Same, once
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomTask,
    build_task_problem,
    floor_of,
)
from scenewright.domains.home.composing.bed_ways import cost_of_bed_ways
from scenewright.domains.home.composing.kitchen_faults import cost_of_places
from scenewright.domains.home.composing.placed_faults import (
    cost_of_group,
    cost_of_hearth,
    cost_of_screen,
    cost_of_shelves,
)
from scenewright.domains.home.composing.places.forms import is_mere_kitchen
from scenewright.domains.home.composing.views import cost_of_view
from scenewright.domains.home.energy import energies_of, prepare, route_grid
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.learned.density import footing
from scenewright.domains.home.learned.habits import clear
from scenewright.domains.home.learned.rows import SIDES
from scenewright.domains.home.learned.space import footprint, measure_coverage
from scenewright.domains.home.learned.targets import free_before, side_of, stands_on_floor
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.weigh_home import compile_table, list_faults, list_together
from scenewright.domains.home.terms.assemble import PreparedHome
from scenewright.domains.home.wished.unmet import count_unmet_wishes
from scenewright.geometry.paths import RouteGrid

Floats = NDArray[np.float64]
Placed = tuple[FurnishedGroup, ...]

REWEIGHED = {"route": 0.0, "wish": 0.0, "daylight_kept": 3.0, "openings_kept": 2.0}
"""By how much more terms count while composing. Two do not: ways are walked, and sizes are what is
looked for."""
REACHED_IN = 1.5
"""A room of less floor, square metres, is used through its door: nobody stands before what is in
it."""

WALL_BEHIND_FROM, AMID = 16.0, 0.4
"""Area in m² from which a wall behind the sofa counts less, and the share that it then
counts."""


class JudgedRoom(NamedTuple):
    """Groups as they stand and what they cost."""

    placed: Placed
    cost: float


class RoomJudge(NamedTuple):
    """What the groups of one room are judged by, wherever they stand and in whichever form."""

    task: RoomTask
    prepared: PreparedHome
    grid: RouteGrid

    def energies_of(self, layouts: Floats) -> Floats:
        """Energies ``(P,)`` of boxes ``(P, n, 5)`` of the groups in their order."""
        return energies_of(self.prepared, self.grid, layouts)[0]

    def cost_of(self, placed: Placed, energy: float | None = None) -> JudgedRoom:
        """The groups with what they cost: energy (that of the layout, if it is known), lost pieces,
        and faults of composition."""
        task, rule = self.task, self.task.preset.settings.composing
        if energy is None:
            energy = float(self.energies_of(np.array([[p.dressed.box for p in placed]]))[0])
        lost = task.costs.piece * sum(p.dressed.lost for p in placed)
        room = lost + sum_faults(task, placed) + task.costs.unmet * count_unmet(task, placed)
        if task.share is not None:
            room += rule.costs.share * abs(share_of(task, placed) - task.share)
        if task.library.habits.clearances:
            room += rule.costs.floor * short_of_floor(task, placed)
        return JudgedRoom(placed, task.costs.energy * energy + room)

    def cost_each(self, rooms: Sequence[Placed]) -> list[JudgedRoom]:
        """:meth:`cost_of` of several rooms of these groups, their energies measured at once."""
        if not rooms:
            return []
        layouts = np.array([[p.dressed.box for p in placed] for placed in rooms])
        energies = self.energies_of(layouts).tolist()
        return [self.cost_of(each, e) for each, e in zip(rooms, energies, strict=True)]


def find_run(placed: Placed) -> Placed:
    """The group one cooks at, if there is one."""
    return tuple(p for p in placed if p.wish.group in RUNS)[:1]


def sum_faults(task: RoomTask, placed: Placed) -> float:
    """What the faults of composition cost of groups as they stand."""
    return sum(cost_by_row(task, placed).values())


@once(512)
def cost_by_row(task: RoomTask, placed: Placed) -> Mapping[str, float]:
    """What each fault of composition costs: of groups by themselves, of groups beside one another
    by the ids of their rows; only what kinds of pieces there are can bring about is looked at. Of
    the same groups found once."""
    rule, ground = task.preset.settings.composing, task.ground
    kinds, costs = {p.category for g in placed for p in g.pieces}, rule.costs
    rows = {"groups": sum(cost_of_group(p, ground, rule) for p in placed)}
    if is_mere_kitchen(task):
        rows["places"] = cost_of_places(placed, ground, costs.few_places)
    rows["shelves"] = cost_of_shelves(placed, ground, costs.shelves)
    table = compile_table(list_together(task.space.functions), costs)
    for fault in list_faults(table, placed, task.fixed, ground):
        rows[fault.row.id] = rows.get(fault.row.id, 0.0) + fault.cost
    if not kinds.isdisjoint(BEDS):
        rows["bed ways"] = cost_of_bed_ways(placed, ground, costs.bed_way)
    if len(ground.hearths):
        rows["hearth"] = cost_of_hearth(placed, ground, costs.screen)
    elif "tv" in kinds:
        rows["screen"] = cost_of_screen(placed, ground, costs.screen)
        rows["view"] = cost_of_view(placed, costs, ground.edges)
    return rows


def share_of(task: RoomTask, placed: Placed) -> float:
    """The share of the floor under fixed pieces and the groups placed."""
    taken = measure_coverage(task.fixed) + sum(footing(p.dressed.case) for p in placed)
    return float(taken / floor_of(task.ground))


def short_of_floor(task: RoomTask, placed: Placed) -> float:
    """Σ 1 - f/d over the sides of groups whose free floor was learned: f metres are free along
    the whole side, d are wished for."""
    learned, total = task.library.habits, 0.0
    pieces = (*task.fixed, *(q for g in placed for q in g.pieces))
    standing = [p for p in pieces if stands_on_floor(p, task.catalog)]
    floor = Polygon(task.space.outline, list(task.space.holes))
    for group in placed:
        function, (x, y, heading, _, _) = group.wish.group, group.dressed.box.tolist()
        others = [footprint(p) for p in standing if p not in group.pieces]
        wanted = clear(learned, function, GROUPS[function].clear)
        for number, depth in enumerate(wanted):
            if depth > 0.0 and (function, SIDES[number]) in learned.clearances:
                side = side_of(x, y, heading, group.dressed.case, number)
                total += max(0.0, 1.0 - free_before(side, others, floor) / depth)
    return total


def count_unmet(task: RoomTask, placed: Placed) -> int:
    """The wishes for places, and the outlets, that groups as they stand do not meet."""
    if not task.space.outlets and not (task.asked and task.asked.wishes):
        return 0
    standing = (*task.fixed, *(p for item in placed for p in item.pieces))
    return count_unmet_wishes(task.asked, task.space, standing, task.catalog)


def judge_of(task: RoomTask, placed: Placed) -> RoomJudge:
    """The judge of groups of these wishes, in this order; of the same task made once."""
    return _judge(Same(task), tuple(p.wish for p in placed))


@lru_cache(maxsize=64)
def _judge(same: Same[RoomTask], wishes: tuple[Wish, ...]) -> RoomJudge:
    task = same.value
    problem = build_task_problem(task, wishes, task.ground)
    counts = REWEIGHED | ({"clear_room": 0.0} if task.ground.area < REACHED_IN else {})
    weights = {name: w * counts.get(name, 1.0) for name, w in problem.weights.items()}
    items = problem.items
    if task.ground.area >= WALL_BEHIND_FROM:
        seats = np.array([wish.group == "seating" for wish in wishes])
        items = items._replace(back_to_wall=np.where(seats, AMID, 1.0) * items.back_to_wall)
    problem = problem._replace(weights=weights, items=items)
    return RoomJudge(task, prepare(problem), route_grid(problem, 0.1))
