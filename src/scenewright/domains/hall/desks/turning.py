"""Desks at which visitors are served look into their zone and to the entrance."""

from __future__ import annotations

import math

import numpy as np
import shapely

from scenewright.arranging.verdict import Verdict, better
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.classes import SERVING
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.energy import parts_of
from scenewright.domains.hall.patterns import SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.solvers.outcome import ENERGY, MeasuredLayout, measure_layout
from scenewright.domains.hall.visit.doors import ways_in
from scenewright.domains.hall.zoning.assign import Unit

FACING = 0.7
"""The cosine of the angle up to which a desk looks to the entrance."""


SLIGHT = 1e-5
"""Cost of a desk that looks away, besides the energy: a tie is turned."""


def turn_desks(
    hall: HallContext,
    wishes: list[HallDemand],
    units: list[Unit],
    problem: HallProblem,
    layout: MeasuredLayout,
) -> MeasuredLayout:
    """A layout with desks that stand by themselves turned half round where their front looks away
    from visitors, unless the route would then miss more or the energy grow. Their footprints
    stay."""
    desks = [
        number
        for number, unit in enumerate(units)
        if wishes[unit.demand].category in SERVING
        and not wishes[unit.demand].facing
        and int(layout.kept.rows[number, 0]) == SINGLE
        and unit.last - unit.first == 1
    ]
    for number in desks if not layout.loose else []:
        row = int(problem.units.spans[number, 0])
        box = layout.boxes[row]
        if _welcome(hall, units[number].zone, box) < 0.0 and not _faces_door(hall, box):
            other = _half_round(layout, number, row)
            if better(_judge(problem, other), _judge(problem, layout, away=SLIGHT)):
                layout = other
    return layout


def _faces_door(hall: HallContext, box: Floats) -> bool:
    """Whether a desk looks to where people come in: it may then have the middle of its zone behind
    it."""
    front = math.cos(box[2]), math.sin(box[2])
    ways = [(door.x - box[0], door.y - box[1]) for door in ways_in(hall.space)[:1]]
    return any(x * front[0] + y * front[1] > FACING * math.hypot(x, y) for x, y in ways)


def _welcome(hall: HallContext, zone: int, box: Floats) -> float:
    """Cosines of the angles between a front and the ways to the middle of its zone and to the
    entrance, summed: -2 to 2."""
    middle = shapely.Polygon(hall.plan.zones[zone].outline).centroid
    points = [(middle.x, middle.y), *((door.x, door.y) for door in ways_in(hall.space)[:1])]
    way = np.array(points) - box[:2]
    way = way / np.maximum(np.hypot(*way.T), 1e-9)[:, None]
    return float((way @ (math.cos(box[2]), math.sin(box[2]))).sum())


def _judge(problem: HallProblem, layout: MeasuredLayout, away: float = 0.0) -> Verdict:
    """The verdict on a layout whose desk looks ``away``: it is not turned into what others need."""
    p, s, missed = measure_layout(problem, layout)
    energy = sum(part.cost for part in parts_of(problem, p, s, missed))
    return Verdict(missed, cost={ENERGY: energy, "away": away})


def _half_round(layout: MeasuredLayout, unit: int, row: int) -> MeasuredLayout:
    pose, boxes = layout.kept.pose.copy(), layout.boxes.copy()
    pose[unit, 2] += math.pi
    boxes[row, 2] += math.pi
    return layout._replace(kept=layout.kept._replace(pose=pose), boxes=boxes)
