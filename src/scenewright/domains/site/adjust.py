"""A saved site changed by hand and built on again, only where that is needed."""

from __future__ import annotations

from collections.abc import Sequence

import shapely

from scenewright.arranging.hand_rules import HandRules
from scenewright.core.edits import Adjusted, Cancel, Edits
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import Edited, find_piece
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.site.locks import BUILDINGS, LANDMARK, ask_for_standing, lock_sites
from scenewright.domains.site.plan import plan_sites
from scenewright.domains.site.solvers import SITE_SOLVERS
from scenewright.domains.site.solving import solve
from scenewright.engine.rows import solver_again
from scenewright.ground.edits.adjusting import GroundRules, adjust_ground
from scenewright.ground.edits.by_hand import ground_rules
from scenewright.ground.edits.locks import check_lockable
from scenewright.ground.names import assign_ids


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
    made = plan or plan_sites(solution.brief)
    return adjust_ground(solution, made, edits, _rules(solution), steps, seed)


def _build_again(standing: Solution, steps: int | None, seed: int, cancel: Cancel) -> Solution:
    brief = ask_for_standing(lock_sites(standing), standing)
    solver = solver_again(SITE_SOLVERS, standing.solver)
    return solve(
        brief, preset=standing.preset, solver=solver, steps=steps, seed=seed, cancel=cancel
    )


def _find_building(pieces: Sequence[Piece], name: str) -> tuple[Piece, ...]:
    """The building a name means, if it may be moved and locked."""
    found = find_piece(pieces, name, lambda _piece: False)
    check_lockable(found, BUILDINGS.dressing, BUILDINGS.what)
    if found.function == LANDMARK:
        raise InputError(f"'{found.id}' is a landmark", 'change it in the brief, under "landmarks"')
    return (found,)


def _find_crowded(solution: Solution, edited: Edited, locked: set[str]) -> set[str]:
    """Ids of buildings that stand nearer to a moved one than their site's spacing."""
    found: set[str] = set()
    sites = solution.brief.part.sites
    for name, site in zip(assign_ids(sites, "site", "sites"), sites, strict=True):
        here = [p for p in edited.pieces if p.space == name and p.category == "building"]
        moved = [p for p in here if p.id in edited.moved]
        others = [p for p in here if p.id not in locked]
        if not moved or not others:
            continue
        tree = shapely.STRtree(polygons_of(others))
        near = tree.query(polygons_of(moved), predicate="dwithin", distance=site.spacing - 1e-6)
        found |= {others[k].id for k in near[1].tolist()}
    return found


def rules_of(solution: Solution, plan: Plan) -> HandRules:
    """How buildings are put in, taken away and exchanged by hand."""
    return ground_rules(solution, plan, _rules(solution))


def _rules(solution: Solution) -> GroundRules:
    apart = min(site.spacing for site in solution.brief.part.sites)
    return GroundRules(_find_building, lock_sites, _find_crowded, _build_again, apart)
