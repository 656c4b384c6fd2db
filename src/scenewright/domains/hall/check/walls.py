"""Does what a brief wants at a wall stand at one? A painting in mid-room hangs on air."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.catalog.kinds import KINDS, hall_use
from scenewright.check.bodies import Bodies
from scenewright.core.brief import Room
from scenewright.core.brief.zones import Demand
from scenewright.core.report import Finding
from scenewright.domains.hall.check.halls import JudgedHall
from scenewright.domains.hall.check.measures import wall_gaps, walls_of
from scenewright.domains.hall.demands.checked import ids_of

WITHIN = 0.05
"""How far from a wall the middle of a back edge may be, in metres."""
STAFF, SLACK = (0.8, 1.2), 1e-3
"""How deep the room may be, in metres, that lies between a wall and what is served from behind,
and how much of it rounding takes."""


def find_no_wall(bodies: Bodies, hall: JudgedHall, wish: Room | None) -> list[Finding]:
    """A finding for each object that its demand wants at a wall and that has neither a wall nor a
    partition within 5 cm behind it, nor one behind the room of its staff."""
    if wish is None or not len(hall.objects):
        return []
    pairs = zip(ids_of(wish.demands), wish.demands, strict=True)
    wanted = {name for name, demand in pairs if wants_wall(demand)}
    mine = np.array([bodies.pieces[row].function in wanted for row in hall.objects])
    gaps = wall_gaps(bodies, hall)
    return [
        _finding(bodies, hall, int(hall.objects[k]), float(gaps[k]))
        for k in np.flatnonzero(mine & (gaps > WITHIN))
        if not _leaves_staff_room(bodies, hall, int(hall.objects[k]))
    ]


def _leaves_staff_room(bodies: Bodies, hall: JudgedHall, row: int) -> bool:
    """Whether an object served from behind has a wall straight behind it, with room for its staff
    between."""
    kind = KINDS.get(bodies.pieces[row].category)
    if kind is None or not kind.staff:
        return False
    back, heading = bodies.corners[row][[0, 3]].mean(0), bodies.pieces[row].pose.heading
    away = np.array([np.cos(heading), np.sin(heading)])
    least, most = STAFF[0] - SLACK, STAFF[1] + SLACK
    behind = shapely.linestrings([back, back - most * away])
    wall = shapely.intersection(walls_of(bodies, hall), behind)
    return bool(not wall.is_empty and shapely.distance(shapely.Point(back), wall) >= least)


def wants_wall(demand: Demand) -> bool:
    """Whether a demand is to stand at walls and nowhere else: said so, or usual and nothing said.

    >>> wants_wall(Demand(category="wall_exhibit")), wants_wall(Demand(category="showcase"))
    (True, False)
    """
    if demand.place is not None or demand.patterns:
        return demand.place == "wall" or demand.patterns == ["wall"]
    return hall_use(demand.category).place == "wall"


def _finding(bodies: Bodies, hall: JudgedHall, row: int, gap: float) -> Finding:
    piece = bodies.pieces[row]
    message = f"{piece.id} is to stand at a wall, but the nearest is {gap:.2f} m behind it"
    place = hall.space.level, hall.space.id, piece.id, ""
    return Finding("no_wall", *place, message, round(gap, 4), 0.0, piece.fixed)
