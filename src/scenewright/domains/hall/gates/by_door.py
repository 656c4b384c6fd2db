"""Gates shared out among the doors they control: a row before each door people come in by."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from scenewright.building.door_approach import gates
from scenewright.catalog.kinds import KINDS
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.measures import DOOR_OUTSIDE
from scenewright.domains.hall.visit.doors import ways_in
from scenewright.domains.hall.visit.roles import is_first
from scenewright.domains.hall.zoning.assign import Unit


def share_among_doors(hall: HallContext, wishes: list[HallDemand], units: list[Unit]) -> list[Unit]:
    """Units with those of gates in one for each door of their zone people come in by, as even as
    they go; those of fewer gates than doors as they are."""
    beside, found = {wish.category for wish in wishes}, list[Unit]()
    for unit in units:
        doors = _count_doors(hall, unit.zone) if _passes(wishes[unit.demand], beside) else 1
        count = unit.last - unit.first
        rows = doors if 1 < doors <= count else 1
        ends = [unit.first + round(k * count / rows) for k in range(rows + 1)]
        found += [unit._replace(first=first, last=last) for first, last in pairwise(ends)]
    return found


def _passes(wish: HallDemand, beside: set[str]) -> bool:
    """Whether a demand is of what people pass through on their way in."""
    kind = KINDS.get(wish.category)
    through = kind is not None and {"front", "back"} <= set(kind.access)
    return through and is_first(wish.category, beside)


def _count_doors(hall: HallContext, zone: int) -> int:
    """How many doors people come in by a zone has."""
    faces = {gate.opening.id: gate.face for gate in gates(hall.space)}
    points = np.array([faces[door.id] for door in ways_in(hall.space)]).reshape(-1, 2)
    outline = hall.plan.zones[zone].outline
    inside = (points >= outline.min(0) - DOOR_OUTSIDE) & (points <= outline.max(0) + DOOR_OUTSIDE)
    return int(inside.all(1).sum())
