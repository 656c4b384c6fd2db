"""What solvers of halls find: layouts of patterns, or of objects as they stand, measured."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from scenewright.arranging.verdict import Verdict
from scenewright.domains.hall.energy import make_state, parts_of, prepare, route_grid
from scenewright.domains.hall.patterns import SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.solvers.guided_metropolis import bring_back, count_missed
from scenewright.domains.hall.solvers.start import copy_frames, write_boxes
from scenewright.domains.hall.terms.place import build
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State, make_scratch
from scenewright.domains.hall.terms.table import ACCESS
from scenewright.domains.hall.terms.whole import measure_all, measure_frames
from scenewright.engine.solve import Budget, Cancel, Found, Progress, Report


class MeasuredLayout(NamedTuple):
    """A layout: what makes it, its boxes (n, 5), its energy, what the route misses and how many
    metres passages lack. The boxes of a ``loose`` one stand where no pattern puts them."""

    kept: Kept
    boxes: Floats
    energy: float
    missed: float
    lacking: float
    loose: bool = False


ENERGY, PASSAGE = "energy", "passage"
"""Rows of a verdict: the energy, and metres that passages lack."""


def verdict_on(layout: MeasuredLayout, **cost: float) -> Verdict:
    """What a measured layout amounts to: what the route misses is lost, metres that passages lack
    are a finding; it costs its energy, or what is given by name."""
    return Verdict(layout.missed, 0, {PASSAGE: layout.lacking}, cost or {ENERGY: layout.energy})


class StartedHall(NamedTuple):
    """What solvers of halls are given: a problem, and a layout of it in which every unit has a
    place."""

    problem: HallProblem
    start: Kept


HallFound = Found[MeasuredLayout]
HallRun = Callable[[HallProblem, Kept, Budget, int, Progress | None, Cancel | None], HallFound]
"""A solver over patterns."""
ObjectRun = Callable[[HallProblem, Budget, int, Progress | None, Cancel | None, Floats | None], Any]
"""A solver of single objects; it answers with ``boxes`` (n, 5) and ``evaluations``, and its reports
make such boxes."""


def measure_layout(
    problem: HallProblem, layout: MeasuredLayout
) -> tuple[PreparedHall, State, float]:
    """A measured state of a layout, and what the route misses there."""
    p, kept = prepare(problem), layout.kept
    s, work, grid = make_state(p), make_scratch(p), route_grid(problem, p)
    s.code[:], s.used[:] = kept.rows[:, 0], kept.rows[:, 1]
    s.pose[:], s.layers[:], s.partitions[:] = kept.pose, kept.layers, kept.walls
    s.offsets[:] = kept.offsets
    for host in range(len(kept.walls)):
        build(p, s, host)
    if layout.loose:
        write_boxes(p, s, np.ascontiguousarray(layout.boxes))
        measure_frames(p, s, work, False)
    else:
        measure_all(p, s, work)
    bits = np.zeros((3, *grid.free.shape), np.uint64)
    inset = np.zeros((len(p.sizes), 4))
    return p, s, count_missed(p, s, grid, bits[0], bits[1], bits[2], inset)


def measure_among(
    problem: HallProblem, layout: MeasuredLayout, solid: Floats
) -> tuple[PreparedHall, State, float]:
    """As :func:`measure_layout` with more that stands there, boxes ``solid`` (n, 5), which may lie
    on floor that objects of the layout have for it: no hard rule is looked at."""
    ground = problem.ground
    standing = np.concatenate([ground.obstacles.reshape(-1, 5), solid.reshape(-1, 5)])
    among = problem._replace(ground=ground._replace(obstacles=standing))
    return measure_layout(among, layout._replace(loose=True))


def by_patterns(
    solve: HallRun,
    given: StartedHall,
    budget: Budget,
    seed: int,
    progress: Progress | None,
    cancel: Cancel | None,
) -> HallFound:
    """The adapter of solvers over patterns."""
    return solve(given.problem, given.start, budget, seed, progress, cancel)


def by_objects(
    solve: ObjectRun,
    given: StartedHall,
    budget: Budget,
    seed: int,
    progress: Progress | None,
    cancel: Cancel | None,
) -> HallFound:
    """The adapter of solvers that place objects one by one, from the same first layout: the answer
    as a layout of single objects."""
    p = prepare(given.problem)
    s, work = make_state(p), make_scratch(p)
    bring_back(p, s, work, given.start)
    boxes = np.zeros((len(p.sizes), 5))
    copy_frames(s, boxes)

    on_progress = None if progress is None else _hear_boxes(given, progress)
    found = solve(given.problem, budget, seed, on_progress, cancel, boxes)
    return Found((measure_objects(given, found.boxes),), found.evaluations)


def _hear_boxes(given: StartedHall, progress: Progress) -> Progress:
    """A listener to reports that make boxes, which passes them on as layouts."""

    def pass_on(report: Report) -> None:
        progress(report._replace(best=lambda: measure_objects(given, report.best())))

    return pass_on


def measure_objects(given: StartedHall, boxes: Floats) -> MeasuredLayout:
    """Objects as they stand on boxes (n, 5), measured as a layout of single objects."""
    problem, start = given
    rows = np.stack([np.full(len(start.rows), SINGLE), start.rows[:, 1]], 1).astype(np.float64)
    layout = MeasuredLayout(start._replace(rows=rows), boxes, 0.0, 0.0, 0.0, True)
    p, s, lost = measure_layout(problem, layout)
    energy = sum(part.cost for part in parts_of(problem, p, s, lost))
    return layout._replace(energy=energy, missed=lost, lacking=lacking(p, s))


def lacking(p: PreparedHall, s: State) -> float:
    """Metres that the passages of a measured state lack, rounding aside."""
    return float(np.round(np.log1p(s.costs[ACCESS, : len(p.links)]).sum(), 6))
