"""Who visits a hall and how: the doors they use, what hides what, and the part each group plays."""

from __future__ import annotations

import numpy as np

from scenewright.building.door_approach import gates
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.core.space import Opening, Space
from scenewright.domains.hall.classes import (
    FRONTED,
    LOUNGE_SEATS,
    MAIN_EXHIBITS,
    ON_SHOW,
    SERVING,
    SITTING_TABLES,
    TABLE_CHAIRS,
)
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.problem import Floats, VisitorPlan
from scenewright.domains.hall.terms.visitors import (
    ALOOF,
    FIRST,
    GUIDE,
    LANE,
    LOUNGE,
    LOW,
    MACHINE,
    MAIN,
    RECEPTION,
    SPEAKER,
    STAGE,
    TABLE,
    TILL,
    WAITING,
)
from scenewright.domains.hall.visit.doors import visitor_exits, ways_in, ways_out
from scenewright.domains.hall.visit.roles import FRONT, MACHINES, is_first, is_till
from scenewright.domains.hall.zoning.assign import Unit

EYES = 1.6
"""Height in metres above which an object hides those behind it."""
INSIDE = 0.5
"""How far inside a door a visitor looks round, in metres."""
ROPES = ("rope_barrier",)
LANES = ("checkout",)
"""Tills that stand side by side with lanes between them, where there are several."""
BELT = 0.78
"""Depth in metres of a till with a belt, at least; lesser ones have no lanes."""
WAITS = ("wait", "warte", "attente", "espera", "等候", "待合")
"""Parts of the names of seats to wait on."""
LOW_TABLES = frozenset(("coffee_table",))
RECEPTIONS = frozenset(("info_desk",))
SHOWN = ((STAGE, frozenset(("stage",))), (TABLE, SITTING_TABLES))
STANDING = (
    (ALOOF, LOUNGE_SEATS | SITTING_TABLES | LOW_TABLES | ON_SHOW),
    (LOUNGE, LOUNGE_SEATS),
    (LOW, LOW_TABLES),
    *SHOWN,
    (RECEPTION, RECEPTIONS),
    (MACHINE, frozenset(MACHINES)),
    (FRONT, frozenset(FRONTED)),
)
"""Roles that depend on nothing but the category."""


def plan_visitors(
    space: Space, fixed: tuple[Piece, ...], wishes: list[HallDemand], units: list[Unit]
) -> VisitorPlan:
    """What the terms about visitors read of a hall and its units.

    The main exhibit is the largest of those that stand alone: a demand of one exhibit, a stage or
    a screen.
    """
    sizes = [size for u in units for size in wishes[u.demand].sizes[u.first : u.last]]
    hides = [piece for piece in fixed if piece.pose.z + piece.size.height > EYES]
    return VisitorPlan(
        entrances=_points(space, ways_in(space)),
        exits=_points(space, visitor_exits(space)),
        ways_out=_points(space, ways_out(space)),
        hiding=np.array([box for piece in hides for box in boxes_of(piece)]).reshape(-1, 5),
        tall=np.array([float(size.height > EYES) for size in sizes]),
        roles=_roles(wishes, units),
        inward=_inward(space),
        served=np.array(
            [box for piece in fixed if piece.category in SERVING for box in boxes_of(piece)]
        ).reshape(-1, 5),
    )


def _inward(space: Space) -> Floats:
    """The unit direction (1, 2) in at the main entrance; none without doors."""
    ways = {gate.opening.id: gate.inward for gate in gates(space)}
    found = [ways[door.id] for door in ways_in(space)[:1]]
    return np.array(found, np.float64).reshape(-1, 2)


def _points(space: Space, doors: list[Opening]) -> Floats:
    """Points (k, 2) just inside some doors."""
    seen = {gate.opening.id: gate.face + INSIDE * gate.inward for gate in gates(space)}
    return np.array([seen[door.id] for door in doors], np.float64).reshape(-1, 2)


def _roles(wishes: list[HallDemand], units: list[Unit]) -> Floats:
    beside = {wish.category for wish in wishes}
    roles = np.zeros(len(units))
    for k, unit in enumerate(units):
        category = wishes[unit.demand].category
        if wishes[unit.demand].double:
            continue  # as good from both sides
        if is_till(category, beside):
            belts = min(size.depth for size in wishes[unit.demand].sizes) > BELT
            lanes = category in LANES and unit.last - unit.first > 1 and belts
            roles[k] = TILL + (LANE if lanes else 0)
        elif is_first(category, beside):
            roles[k] = FIRST
        elif category in ROPES:
            roles[k] = GUIDE
        elif category == "lectern":
            roles[k] = SPEAKER
    alone = [
        (size.width * size.depth, -k)
        for k, unit in enumerate(units)
        if len(wishes[unit.demand].sizes) == 1 and wishes[unit.demand].category in MAIN_EXHIBITS
        for size in wishes[unit.demand].sizes
    ]
    if alone:
        roles[-max(alone)[1]] += MAIN
    return roles + _standing(wishes, units)


def _standing(wishes: list[HallDemand], units: list[Unit]) -> Floats:
    """The roles (g,) of units that follow from what they are made of, and of seats to wait on."""
    kinds = [wishes[unit.demand].category for unit in units]
    roles = [sum(bit for bit, of in STANDING if kind in of) for kind in kinds]
    waits = [WAITING * is_to_wait_on(wishes[unit.demand]) for unit in units]
    return np.array(roles, np.float64) + np.array(waits, np.float64)


def is_to_wait_on(wish: HallDemand) -> bool:
    """Whether a demand is seats on which people wait to be served, as its name says, or chairs at
    a wall."""
    seats = wish.category in (*LOUNGE_SEATS, *TABLE_CHAIRS, "bench")
    chairs = wish.category in TABLE_CHAIRS and wish.at_wall
    return chairs or (seats and any(word in wish.name.casefold() for word in WAITS))
