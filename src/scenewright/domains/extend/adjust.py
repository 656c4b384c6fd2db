"""A saved extension changed by hand and grown again, only where that is needed."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.arranging.hand_rules import HandRules
from scenewright.core.edits import Adjusted, Cancel, Edits
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import find_piece
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD
from scenewright.domains.extend.locks import GROWTH, lock_extension
from scenewright.domains.extend.plan import plan_extend
from scenewright.domains.extend.solvers import EXTEND_SOLVERS
from scenewright.domains.extend.solving import solve
from scenewright.engine.rows import solver_again
from scenewright.ground.edits.adjusting import GroundRules, adjust_ground, find_overlapped
from scenewright.ground.edits.by_hand import ground_rules
from scenewright.ground.edits.locks import check_lockable, lock_and_count

APART = 2.0
"""Metres kept between buildings where one is put in by hand."""


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
    is not locked does. All other buildings stay, old ones too.
    """
    made = plan or plan_extend(solution.brief)
    return adjust_ground(solution, made, edits, _rules(solution), steps, seed)


def _grow_again(standing: Solution, steps: int | None, seed: int, cancel: Cancel) -> Solution:
    """Areas with as many buildings as they had; those that are not locked find a place."""
    brief = lock_and_count(standing, GROWTH)
    solver = solver_again(EXTEND_SOLVERS, standing.solver)
    return solve(
        brief, preset=standing.preset, solver=solver, steps=steps, seed=seed, cancel=cancel
    )


def _find_building(pieces: Sequence[Piece], name: str) -> tuple[Piece, ...]:
    """The building a name means, if it may be moved and locked."""
    found = find_piece(pieces, name, lambda _piece: False)
    if found.space == OLD:
        raise InputError(f"'{found.id}' stood before", 'change it in the brief, under "sources"')
    check_lockable(found, GROWTH.dressing, GROWTH.what)
    return (found,)


def rules_of(solution: Solution, plan: Plan) -> HandRules:
    """How buildings are put in, taken away and exchanged by hand."""
    return ground_rules(solution, plan, _rules(solution))


def _rules(_solution: Solution) -> GroundRules:
    return GroundRules(_find_building, lock_extension, find_overlapped, _grow_again, APART)
