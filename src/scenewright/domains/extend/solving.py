"""Extensions: a small neighbourhood grown into an area, so that nobody can tell where it ends.

After Zhang and Fei (2017), who breed layouts with a person; ours continues rows and neighbours of
the sources themselves and measures whether it is still the same place.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

from scenewright._version import __version__
from scenewright.core.brief import Brief
from scenewright.core.layout import FIT, ROUTES, SETTLED, NamedBox, Watch
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Solution, TermValue
from scenewright.domains.extend.areas import ExtendPlan
from scenewright.domains.extend.fronting import front_pieces
from scenewright.domains.extend.furnish import new_pieces
from scenewright.domains.extend.given import standing_pieces
from scenewright.domains.extend.plan import plan_extend
from scenewright.domains.extend.planting import plant_extension
from scenewright.domains.extend.presets import PRESETS
from scenewright.domains.extend.problem import ExtendProblem, GrownLayout
from scenewright.domains.extend.reasons import reasons
from scenewright.domains.extend.solvers import EXTEND_SOLVERS
from scenewright.domains.extend.staging import StagedArea, StagedExtension, stage_extension
from scenewright.domains.extend.uses import dress_extension
from scenewright.engine.rows import preset_named
from scenewright.engine.solve import Budget, Report
from scenewright.engine.trace import Hear, hear_in
from scenewright.engine.watched import add_watch, show
from scenewright.text import quantity

COMPOSED = ("grow",)
"""Solvers whose buildings get fronts to their street and the form of their use."""
SAME = 1e-6
"""Metres by which sizes of one model may differ."""
Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]


class FilledArea(NamedTuple):
    """One area as filled."""

    area: str
    pieces: tuple[Piece, ...]
    terms: tuple[TermValue, ...]
    left_out: tuple[LeftOut, ...]
    evaluations: int


def solve(
    brief: Brief,
    *,
    plan: Plan | None = None,
    preset: str = "default",
    solver: str | None = None,
    seconds: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    watch: Watch | None = None,
    hear: Hear | None = None,
) -> Solution:
    """Fill every area of a brief.

    ``steps`` are layouts of each area, ``seconds`` are for each; the same seed and steps give the
    same answer. ``plan`` is that of the brief (made unless given). ``watch`` gets the best
    layout of each area, as boxes by the names of kinds; ``hear`` the steps of a traced solver.
    """
    started = time.perf_counter()
    chosen = preset_named(PRESETS, preset)
    stage, found = stage_extension(brief, plan or plan_extend(brief), chosen.settings), []
    named = solver or chosen.solver
    given = chosen.steps if steps is None and seconds is None else steps
    for k, one in enumerate(stage.areas):
        area, problem = one.area, one.problem
        count = len(stage.areas)
        on_progress = None if progress is None else _share(progress, k, count, area.name)
        on_progress = add_watch(on_progress, watch, area.id, partial(_boxes, problem))
        budget = Budget(seconds, given, threads=threads, hear=hear_in(hear, area.id))
        answer = EXTEND_SOLVERS[named].run(problem, budget, seed + 7919 * k, on_progress, cancel)
        layout, tried = answer.layouts[0], answer.evaluations
        stopped = cancel is not None and cancel()
        found.append(furnish_area(one, layout, tried, stopped=stopped))
    spent = time.perf_counter() - started
    return assemble_solution(stage, found, preset, named, seed, spent, watch)


def _boxes(problem: ExtendProblem, layout: GrownLayout) -> tuple[NamedBox, ...]:
    """A layout as boxes by the names of kinds, as ``solution_of`` takes them."""
    kinds = [problem.pattern.kinds[k] for k in problem.pattern.kind[layout.origin].tolist()]
    return tuple(
        NamedBox(kind.name, (*pose, *kind.size[:2]))
        for kind, pose in zip(kinds, layout.poses.tolist(), strict=True)
    )


def problems(
    brief: Brief, preset: str = "default", *, plan: Plan | None = None
) -> tuple[ExtendProblem, ...]:
    """The problem of each area as solvers take it."""
    settings = preset_named(PRESETS, preset).settings
    stage = stage_extension(brief, plan or plan_extend(brief), settings)
    return tuple(one.problem for one in stage.areas)


STOPPED = "stopped before they were placed"


def furnish_area(
    staged: StagedArea, layout: GrownLayout, evaluations: int, *, stopped: bool = False
) -> FilledArea:
    """A layout as pieces, with its figures and what it lacks, be it because the run was
    ``stopped``."""
    area, problem = staged.area, staged.problem
    new = new_pieces(area, problem.pattern, layout, staged.look)
    pieces = (*standing_pieces(area), *new)
    missing = layout.asked - len(layout.poses)
    left_out = []
    short = 0.0 if layout.asked else layout.score.get("coverage", 0.0)
    if stopped and short > problem.settings.slack:
        what = f"the buildings of {short:.0%} of the ground to be covered"
        left_out.append(LeftOut(area.id, what, STOPPED, True))
    elif not layout.asked and not len(layout.poses) and not area.fixed:
        reason = f"none fits on {area.outline.area:.0f} m² at the distances of the source"
        left_out.append(LeftOut(area.id, "all buildings", reason, False))
    if missing > 0:
        what = f"{missing} of {quantity(layout.asked, 'building')}"
        full = f"no place left on {area.outline.area:.0f} m² at the distances of the source"
        reason = STOPPED if stopped else full
        left_out.append(LeftOut(area.id, what, reason, True))
    rows = reasons(problem, layout)
    return FilledArea(area.id, pieces, rows, tuple(left_out), evaluations)


def assemble_solution(
    stage: StagedExtension,
    found: Sequence[FilledArea],
    preset: str,
    solver: str,
    seed: int,
    seconds: float,
    watch: Watch | None = None,
) -> Solution:
    """The solution of all areas of a brief, with the old buildings; ``watch`` gets what changes
    and what stays."""
    plan = stage.plan
    first = plan.areas[0].id
    skipped = tuple(
        LeftOut(first, line.partition(": ")[2], "of the source, not followed", False)
        for line in plan.left_out
    )
    new = tuple(piece for one in found for piece in one.pieces)
    pieces = (*new, *stage.old)
    lacking: list[LeftOut] = []
    if solver in COMPOSED:
        counted = {area.id for area in plan.areas if area.row.count is not None}
        fronted = front_pieces(plan.ground, pieces, counted)
        show_changes(watch, plan, pieces, fronted, ROUTES, "fronts look at ways that lead to them")
        dressed, lacking = dress_extension(plan, fronted)
        told = "buildings are drawn by their uses and their neighbours"
        show_changes(watch, plan, fronted, dressed, FIT, told)
        pieces = (*dressed, *plant_extension(plan, dressed, stage.catalog, seed))
    show_changes(watch, plan, (), pieces, SETTLED)
    return Solution(
        brief=stage.brief,
        pieces=pieces,
        patches=(),
        terms=tuple(term for one in found for term in one.terms),
        left_out=(*(out for one in found for out in one.left_out), *lacking, *skipped),
        energies={one.area: math.fsum(term.cost for term in one.terms) for one in found},
        preset=preset,
        solver=solver,
        seed=seed,
        version=__version__,
        brief_hash=stage.brief_hash,
        seconds=seconds,
        evaluations=sum(one.evaluations for one in found),
        detail=tuple(road for area in plan.areas for road in area.continued),
    )


def show_changes(
    watch: Watch | None,
    plan: ExtendPlan,
    before: Sequence[Piece],
    after: Sequence[Piece],
    stage: str,
    reason: str = "",
) -> None:
    """Show the new buildings of each area with others than before to who watches."""
    for area in plan.areas if watch else ():
        old, new = ([p for p in every if p.space == area.id] for every in (before, after))
        if old != new:
            lost = len(old) - len(new)
            told = f"{reason}, {lost} of them left out" if reason and lost else reason
            show(watch, area.id, partial(_boxes_of_pieces, plan, new), stage, told)


def _boxes_of_pieces(plan: ExtendPlan, pieces: Sequence[Piece]) -> tuple[NamedBox, ...]:
    """New buildings as boxes of their kinds, whichever of their sides the front is on."""
    sizes, found = {kind.name: kind.size for kind in plan.pattern.kinds}, list[NamedBox]()
    for piece in (p for p in pieces if not p.fixed and p.function in sizes):
        wide, deep = sizes[piece.function][:2]
        turned = abs(piece.size.width - wide) > SAME
        heading = piece.pose.heading - math.pi / 2 * turned
        found.append(NamedBox(piece.function, (*piece.pose[:2], heading, wide, deep)))
    return tuple(found)


def _share(progress: Progress, number: int, count: int, name: str) -> Callable[[Report], None]:
    return lambda report: progress((number + report.share) / count, name)
