"""A saved extension changed by hand and grown again, only where that is needed."""

from __future__ import annotations

from collections import Counter
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
from scenewright.domains.extend.locks import check_lockable, lock_extension
from scenewright.domains.extend.plan import plan_extend
from scenewright.domains.extend.solving import solve
from scenewright.ground.names import assign_ids

OVERLAP = 0.01
"""Square metres shared with a building moved by hand that make another give way."""


def adjust(
    solution: Solution,
    edits: Edits,
    *,
    plan: Plan | None = None,
    steps: int | None = None,
    seed: int | None = None,
) -> Adjusted:
    """Make ``edits`` and place again what they touch.

    Buildings that a moved one stands on find another place; in areas named in ``again`` all that
    is not locked does. All other buildings stay, and so does what stood before.
    """
    plan = plan or plan_extend(solution.brief)
    edited = apply_edits(solution.pieces, plan, edits, _find_building, _alone)
    locked = {p.id for p in edited.pieces if p.fixed}
    free = _find_overlapped(edited, locked)
    free |= {p.id for p in edited.pieces if p.space in edited.again} - locked
    chosen = solution.seed if seed is None else seed
    if not free and not edited.moved:
        after = replace(solution, pieces=edited.pieces)
    else:
        after = _solve_again(solution, edited, free, locked, steps, chosen)
    after = replace(after, brief=lock_extension(after), seed=chosen)
    return list_adjusted(solution, after, edited, skip="/green")


def _solve_again(
    solution: Solution,
    edited: Edited,
    free: set[str],
    locked: set[str],
    steps: int | None,
    seed: int,
) -> Solution:
    """Areas with as many buildings as they had; those that are not free stand."""
    held = {p.id for p in edited.pieces if p.category == "building"} - free
    pieces = with_locks(edited.pieces, held)
    brief = lock_extension(replace(solution, pieces=pieces))
    names = assign_ids(brief.part.areas, "area", "areas")
    counts = Counter(p.space for p in pieces if p.category == "building")
    areas = [
        area.model_copy(update={"count": counts[name], "coverage": None})
        for area, name in zip(brief.part.areas, names, strict=True)
    ]
    counted = brief.model_copy(update={"part": brief.part.model_copy(update={"areas": areas})})
    found = solve(counted, preset=solution.preset, solver=solution.solver, steps=steps, seed=seed)
    pieces = with_locks(found.pieces, locked)
    return replace(found, brief=brief, pieces=pieces, brief_hash=solution.brief_hash)


def _find_building(pieces: Sequence[Piece], name: str) -> tuple[Piece, ...]:
    """The building a name means, if it may be moved and locked."""
    found = find_piece(pieces, name, lambda _piece: False)
    check_lockable(found)
    return (found,)


def _alone(piece: Piece, _pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    return (piece,)


def _find_overlapped(edited: Edited, locked: set[str]) -> set[str]:
    """Ids of buildings that a moved one stands on."""
    houses = [p for p in edited.pieces if p.category == "building"]
    moved = [p for p in houses if p.id in edited.moved]
    others = [p for p in houses if p.id not in locked]
    if not moved or not others:
        return set()
    shapes, theirs = polygons_of(moved), polygons_of(others)
    shared = shapely.area(shapely.intersection(shapes[:, None], theirs[None]))
    return {others[k].id for k in np.flatnonzero((shared > OVERLAP).any(0))}
