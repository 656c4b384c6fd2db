"""Villages: blocks filled with real houses, each standing as houses of the region stand.

After Zhu, Jiang and Li (2022), who ask four networks house by house: another? which? where? which
way? Ours asks how many first, then takes the largest first, and needs no pixels.
"""

from __future__ import annotations

import hashlib
import math
import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
import shapely

from scenewright._version import __version__
from scenewright.core.brief import Brief
from scenewright.core.layout import FIT, SETTLED, NamedBox, Watch
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Patch, Solution, TermValue
from scenewright.domains.village.blocks import BlockPlan, VillagePlan
from scenewright.domains.village.brief import VillageBlock
from scenewright.domains.village.build_problem import build_problem, find_square
from scenewright.domains.village.furnish import pieces_of, square_patch
from scenewright.domains.village.given import standing_pieces
from scenewright.domains.village.house import House
from scenewright.domains.village.lanes import VillageLane, lay_village_lanes, with_lanes
from scenewright.domains.village.plan import plan_village
from scenewright.domains.village.planting import plant
from scenewright.domains.village.presets import PRESETS
from scenewright.domains.village.problem import VillageLayout, VillageProblem
from scenewright.domains.village.reasons import reasons
from scenewright.domains.village.solvers import VILLAGE_SOLVERS
from scenewright.domains.village.solvers.growing import standing_of
from scenewright.domains.village.uses import dress_block
from scenewright.engine.rows import preset_named
from scenewright.engine.solve import Budget, Report
from scenewright.engine.trace import Hear, hear_in
from scenewright.engine.watched import add_watch, show
from scenewright.text import quantity

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]


class FilledBlock(NamedTuple):
    """One block as filled."""

    block: str
    pieces: tuple[Piece, ...]
    patches: tuple[Patch, ...]
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
    lanes: tuple[VillageLane, ...] | None = None,
) -> Solution:
    """Fill every block of a brief.

    ``steps`` are layouts of each block, ``seconds`` are for each; the same seed and steps give the
    same answer. ``plan`` is that of the brief (made unless given). ``watch`` gets the best
    layout of each block, as boxes by the names of houses; ``hear`` the steps of a traced solver.
    ``lanes`` are those laid into the blocks before, if they are to stay.
    """
    started = time.perf_counter()
    chosen, village = preset_named(PRESETS, preset), (plan or plan_village(brief)).detail
    if lanes is None:
        lanes = lay_village_lanes(village) if chosen.settings.composed else ()
    village = with_lanes(village, lanes)
    named = solver or chosen.solver
    given = chosen.steps if steps is None and seconds is None else steps
    found = []
    for k, (block, one) in enumerate(zip(brief.part.blocks, village.blocks, strict=True)):
        problem = build_problem(block, one, village, chosen.settings)
        on_progress = (
            None if progress is None else _share(progress, k, len(village.blocks), one.name)
        )
        on_progress = add_watch(on_progress, watch, one.id, partial(_boxes, one, village.houses))
        budget = Budget(seconds, given, threads=threads, hear=hear_in(hear, one.id))
        answer = VILLAGE_SOLVERS[named].run(problem, budget, seed + 7919 * k, on_progress, cancel)
        layout = answer.layouts[0]
        rows = partial(_boxes, one, village.houses, layout)
        filled = furnish_block(
            block,
            one,
            village,
            problem,
            layout,
            answer.evaluations,
            seed + 7919 * k,
            stopped=cancel is not None and cancel(),
        )
        if chosen.settings.composed:
            show(watch, one.id, rows, FIT, "houses are drawn by their uses and their neighbours")
        show(watch, one.id, rows, SETTLED)
        found.append(filled)
    spent = time.perf_counter() - started
    return assemble_solution(brief, found, preset, named, seed, spent, lanes)


def _boxes(plan: BlockPlan, houses: Sequence[House], layout: VillageLayout) -> tuple[NamedBox, ...]:
    """A layout as boxes by the names of houses, as ``solution_of`` takes them."""
    return tuple(
        NamedBox(piece.function, (*piece.pose[:2], piece.pose.heading, *piece.size[:2]))
        for piece in pieces_of(plan, houses, layout)
    )


def problems(
    brief: Brief, preset: str = "default", *, plan: Plan | None = None
) -> tuple[VillageProblem, ...]:
    """The problem of each block as solvers take it."""
    village = (plan or plan_village(brief)).detail
    settings = preset_named(PRESETS, preset).settings
    village = with_lanes(village, lay_village_lanes(village) if settings.composed else ())
    return tuple(
        build_problem(block, one, village, settings)
        for block, one in zip(brief.part.blocks, village.blocks, strict=True)
    )


def furnish_block(
    block: VillageBlock,
    plan: BlockPlan,
    village: VillagePlan,
    problem: VillageProblem,
    layout: VillageLayout,
    evaluations: int,
    seed: int,
    *,
    stopped: bool = False,
) -> FilledBlock:
    """A layout as pieces, with trees by ``seed``, its figures and what it lacks, be it because the
    run was ``stopped``."""
    houses = (*standing_pieces(plan), *pieces_of(plan, village.houses, layout))
    square = find_square(block, plan)
    patches = () if square is None else (square_patch(plan, square),)
    lacking: list[LeftOut] = []
    if problem.settings.composed:
        ground = shapely.Polygon() if square is None else shapely.Polygon(square)
        dressed, lacking = dress_block(block, plan, village.houses, houses, ground)
        houses = tuple(dressed)
    trees = plant(plan, houses, patches, np.random.default_rng([seed, 1]))
    missing = layout.asked - len(layout.houses)
    return FilledBlock(
        plan.id,
        (*houses, *trees),
        patches,
        reasons(problem, standing_of(problem, layout), missing),
        (*_left_out(block, plan, layout, square is None, stopped), *lacking),
        evaluations,
    )


def assemble_solution(
    brief: Brief,
    found: list[FilledBlock],
    preset: str,
    solver: str,
    seed: int,
    seconds: float,
    lanes: tuple[VillageLane, ...] = (),
) -> Solution:
    """The solution of all blocks of a brief, with the lanes that were laid into them."""
    return Solution(
        brief=brief,
        pieces=tuple(piece for one in found for piece in one.pieces),
        patches=tuple(patch for one in found for patch in one.patches),
        terms=tuple(term for one in found for term in one.terms),
        left_out=tuple(out for one in found for out in one.left_out),
        energies={one.block: math.fsum(term.cost for term in one.terms) for one in found},
        preset=preset,
        solver=solver,
        seed=seed,
        version=__version__,
        brief_hash=hashlib.sha256(brief.model_dump_json().encode()).hexdigest(),
        seconds=seconds,
        evaluations=sum(one.evaluations for one in found),
        detail=lanes or None,
    )


def _left_out(
    block: VillageBlock, plan: BlockPlan, layout: VillageLayout, no_square: bool, stopped: bool
) -> list[LeftOut]:
    """Houses and squares without a place."""
    found = []
    missing = layout.asked - len(layout.houses)
    if missing > 0:
        what = f"{missing} of {quantity(layout.asked, 'house')}"
        full = f"no place left on {plan.area:.0f} m² that a way from the street leads to"
        reason = "stopped before they were placed" if stopped else full
        found.append(LeftOut(plan.id, what, reason, stopped or block.count is not None))
    if block.square is not None and no_square:
        side = math.sqrt(block.square)
        reason = f"no street side has {side:.1f} x {side:.1f} m free behind it"
        found.append(LeftOut(plan.id, f"free square of {block.square:g} m²", reason, True))
    return found


def _share(progress: Progress, number: int, count: int, name: str) -> Callable[[Report], None]:
    return lambda report: progress((number + report.share) / count, name)
