"""A saved site changed by hand and built on again, only where that is needed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import shapely

from scenewright.core.edits import Adjusted, Edits
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import Edited, apply_edits, find_piece, list_adjusted, with_locks
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.site.locks import LANDMARK, WORDS, lock_sites
from scenewright.domains.site.plan import plan_sites
from scenewright.domains.site.solving import solve
from scenewright.ground.locks import check_lockable


def adjust(
    solution: Solution,
    edits: Edits,
    *,
    plan: Plan | None = None,
    steps: int | None = None,
    seed: int | None = None,
) -> Adjusted:
    """Make ``edits`` and place again what they touch.

    Buildings nearer to a moved one than the site's spacing find another place; on sites named in
    ``again`` all that is not locked does. All other buildings stay; trees and lamps follow.
    """
    plan = plan or plan_sites(solution.brief)
    edited = apply_edits(solution.pieces, plan, edits, _find_building, _alone)
    locked = {p.id for p in edited.pieces if p.fixed}
    free = _find_crowded(solution, edited, locked)
    free |= {p.id for p in edited.pieces if p.space in edited.again} - locked
    chosen = solution.seed if seed is None else seed
    if not free and not edited.moved:
        after = replace(solution, pieces=edited.pieces)
    else:
        held = {p.id for p in edited.pieces if p.category == "building"} - free
        brief = lock_sites(replace(solution, pieces=with_locks(edited.pieces, held)))
        found = solve(
            brief, preset=solution.preset, solver=solution.solver, steps=steps, seed=chosen
        )
        pieces = with_locks(found.pieces, locked)
        after = replace(found, pieces=pieces, brief_hash=solution.brief_hash)
    after = replace(after, brief=lock_sites(after), seed=chosen)
    return list_adjusted(solution, after, edited, skip="/green")


def _find_building(pieces: Sequence[Piece], name: str) -> tuple[Piece, ...]:
    """The building a name means, if it may be moved and locked."""
    found = find_piece(pieces, name, lambda _piece: False)
    check_lockable(found, *WORDS)
    if found.function == LANDMARK:
        raise InputError(f"'{found.id}' is a landmark", 'change it in the brief, under "landmarks"')
    return (found,)


def _alone(piece: Piece, _pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    return (piece,)


def _find_crowded(solution: Solution, edited: Edited, locked: set[str]) -> set[str]:
    """Ids of buildings that stand nearer to a moved one than their site's spacing."""
    found: set[str] = set()
    for plan, site in zip(
        plan_sites(solution.brief).spaces, solution.brief.part.sites, strict=True
    ):
        here = [p for p in edited.pieces if p.space == plan.id and p.category == "building"]
        moved = [p for p in here if p.id in edited.moved]
        others = [p for p in here if p.id not in locked]
        if not moved or not others:
            continue
        tree = shapely.STRtree(polygons_of(others))
        near = tree.query(polygons_of(moved), predicate="dwithin", distance=site.spacing - 1e-6)
        found |= {others[k].id for k in near[1].tolist()}
    return found
