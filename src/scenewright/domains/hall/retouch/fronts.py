"""Stands and panels show who comes in their fronts, not their backs."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.hall.classes import FRONTED
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.patterns import CHAIN, GRID, SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.zoning.assign import Unit
from scenewright.engine.draws import streams


def turn_fronts(
    wishes: list[HallDemand], units: list[Unit], problem: HallProblem, layout: MeasuredLayout
) -> MeasuredLayout:
    """A layout with groups of stands and panels that look at something of their own accord turned
    half round where they look away from the main entrance, unless the route would then miss more,
    a passage be narrower or the energy grow."""
    entrances = problem.visitors.entrances
    for unit, (demand, *_) in enumerate(units if len(entrances) and not layout.loose else []):
        wish, code = wishes[demand], int(layout.kept.rows[unit, 0])
        if wish.category not in FRONTED or wish.facing or code not in (CHAIN, GRID, SINGLE):
            continue
        if _look_towards(layout.boxes[slice(*problem.units.spans[unit])], entrances[0]) < 0.0:
            other = _half_round(problem, layout, unit)
            if _cost(other) <= _cost(layout):
                layout = other
    return layout


def _look_towards(boxes: Floats, point: Floats) -> float:
    """The mean cosine of the angles between fronts of boxes (n, 5) and their ways to a point."""
    way = point - boxes[:, :2]
    way = way / np.maximum(np.hypot(*way.T), 1e-9)[:, None]
    return float((way * np.column_stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])])).sum(1).mean())


def _half_round(problem: HallProblem, layout: MeasuredLayout, unit: int) -> MeasuredLayout:
    pose = layout.kept.pose.copy()
    pose[unit, 2] += math.pi
    return layout_of(begin_chain(problem, layout.kept._replace(pose=pose), streams(0, 1)[0]))


def _cost(layout: MeasuredLayout) -> tuple[float, float, float]:
    return layout.missed, round(layout.lacking, 6), round(layout.energy, 6)
