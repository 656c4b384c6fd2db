"""A saved village changed by hand and filled again, only where that is needed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely

from scenewright.core.edits import Adjusted, Edits
from scenewright.core.piece_edits import Edited, apply_edits, find_piece, list_adjusted, with_locks
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.village.locks import WORDS, lock_village
from scenewright.domains.village.plan import plan_village
from scenewright.domains.village.solving import solve
from scenewright.ground.locks import check_lockable

OVERLAP = 0.01
"""Square metres shared with a house moved by hand that make another give way."""


def adjust(
    solution: Solution,
    edits: Edits,
    *,
    plan: Plan | None = None,
    steps: int | None = None,
    seed: int | None = None,
) -> Adjusted:
    """Make ``edits`` and place again what they touch.

    Houses that a moved one stands on find another place; in blocks named in ``again`` all that is
    not locked does. All other houses stay; trees follow.
    """
    plan = plan or plan_village(solution.brief)
    edited = apply_edits(solution.pieces, plan, edits, _find_house, _alone)
    locked = {p.id for p in edited.pieces if p.fixed}
    free = _find_overlapped(edited, locked)
    free |= {p.id for p in edited.pieces if p.space in edited.again} - locked
    chosen = solution.seed if seed is None else seed
    if not free and not edited.moved:
        after = replace(solution, pieces=edited.pieces)
    else:
        after = _solve_again(solution, edited, free, locked, steps, chosen)
    after = replace(after, brief=lock_village(after), seed=chosen)
    return list_adjusted(solution, after, edited, skip="/green")


def _solve_again(
    solution: Solution,
    edited: Edited,
    free: set[str],
    locked: set[str],
    steps: int | None,
    seed: int,
) -> Solution:
    """Blocks with as many houses as they had; those that are not free stand."""
    held = {p.id for p in edited.pieces if p.category == "building"} - free
    pieces = with_locks(edited.pieces, held)
    counts = {
        space: sum(p.space == space and p.category == "building" for p in pieces)
        for space in {p.space for p in pieces}
    }
    brief = lock_village(replace(solution, pieces=pieces))
    names = [space.id for space in plan_village(solution.brief).spaces]
    blocks = [
        block.model_copy(update={"count": counts.get(name, 0), "coverage": None})
        for block, name in zip(brief.part.blocks, names, strict=True)
    ]
    counted = brief.model_copy(update={"part": brief.part.model_copy(update={"blocks": blocks})})
    found = solve(counted, preset=solution.preset, solver=solution.solver, steps=steps, seed=seed)
    return replace(
        found, brief=brief, pieces=with_locks(found.pieces, locked), brief_hash=solution.brief_hash
    )


def _find_house(pieces: Sequence[Piece], name: str) -> tuple[Piece, ...]:
    """The house a name means, if it may be moved and locked."""
    found = find_piece(pieces, name, lambda _piece: False)
    check_lockable(found, *WORDS)
    return (found,)


def _alone(piece: Piece, _pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    return (piece,)


def _find_overlapped(edited: Edited, locked: set[str]) -> set[str]:
    """Ids of houses that a moved one stands on."""
    houses = [p for p in edited.pieces if p.category == "building"]
    moved = [p for p in houses if p.id in edited.moved]
    others = [p for p in houses if p.id not in locked]
    if not moved or not others:
        return set()
    shapes, theirs = polygons_of(moved), polygons_of(others)
    shared = shapely.area(shapely.intersection(shapes[:, None], theirs[None]))
    return {others[k].id for k in np.flatnonzero((shared > OVERLAP).any(0))}
