"""From the plan of an area to the problem of filling it."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.domains.extend.areas import AreaPlan, ExtendPlan, StandingLock
from scenewright.domains.extend.pattern import SourcePattern
from scenewright.domains.extend.problem import ExtendProblem, StandingGround
from scenewright.domains.extend.settings import GrowthSettings
from scenewright.domains.extend.solvers.laid_rows import read_row


def build_problem(plan: ExtendPlan, area: AreaPlan, settings: GrowthSettings) -> ExtendProblem:
    """The problem of filling one area."""
    old = tuple(
        road
        for scene, there in zip(plan.sources, plan.stands, strict=True)
        if there
        for road in scene.roads
    )
    coverage = area.row.coverage or plan.pattern.coverage
    return ExtendProblem(
        area.id,
        area.floor,
        area.outline,
        plan.pattern,
        _standing(plan, area),
        (*old, *area.roads),
        area.row.count,
        coverage,
        tuple(scene.roads for scene in plan.sources),
        settings,
        tuple(
            read_row(row, plan.pattern, f"{area.id} rows[{k}]")
            for k, row in enumerate(area.row.rows)
        ),
        tuple(
            None if scene.outline is None else shapely.Polygon(scene.outline)
            for scene in plan.sources
        ),
    )


def _standing(plan: ExtendPlan, area: AreaPlan) -> StandingGround:
    """The sources that stand, then what stays in the area."""
    pattern = plan.pattern
    there = np.array(plan.stands)[pattern.source]
    rows = np.flatnonzero(there)
    locks = area.fixed
    shapes = np.empty(len(rows) + len(locks), object)
    shapes[: len(rows)] = pattern.shapes[rows]
    shapes[len(rows) :] = [shapely.Polygon(one.outline) for one in locks]
    boxes = np.array([one.box for one in locks], float).reshape(-1, 5)
    return StandingGround(
        np.concatenate([pattern.boxes[rows], boxes]),
        shapes,
        np.concatenate([rows, np.array([find_like(pattern, one) for one in locks], np.int64)]),
        np.concatenate([np.zeros(len(rows), np.bool_), np.ones(len(locks), np.bool_)]),
    )


def find_like(pattern: SourcePattern, lock: StandingLock) -> int:
    """The building of the sources that one which stays is like: of its kind, else of its size."""
    for k, kind in enumerate(pattern.kinds):
        if kind.name == lock.kind:
            return int(np.flatnonzero(pattern.kind == k)[0])
    sides = np.log(pattern.boxes[:, 3:]) - np.log(np.array(lock.box[3:]))
    return int(np.abs(sides).sum(1).argmin())
