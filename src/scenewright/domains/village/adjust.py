"""A saved village changed by hand and filled again, only where that is needed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.arranging.hand_rules import HandRules
from scenewright.core.edits import Adjusted, Cancel, Edits
from scenewright.core.piece_edits import find_piece
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.village.lanes import VillageLane
from scenewright.domains.village.locks import HOUSES, lock_village
from scenewright.domains.village.plan import plan_village
from scenewright.domains.village.solvers import VILLAGE_SOLVERS
from scenewright.domains.village.solving import solve
from scenewright.engine.rows import solver_again
from scenewright.ground.edits.adjusting import GroundRules, adjust_ground, find_overlapped
from scenewright.ground.edits.by_hand import ground_rules
from scenewright.ground.edits.locks import check_lockable, lock_and_count
from scenewright.ground.ways.inner_lanes import LaidLane, area_of

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

    Houses that a moved one stands on find another place; in blocks named in ``again`` all that is
    not locked does. All other houses stay; trees follow.
    """
    made = plan or plan_village(solution.brief)
    return adjust_ground(solution, made, edits, _rules(solution), steps, seed)


def _fill_again(standing: Solution, steps: int | None, seed: int, cancel: Cancel) -> Solution:
    """Blocks with as many houses as they had; those that are not locked find a place."""
    brief = lock_and_count(standing, HOUSES)
    solver = solver_again(VILLAGE_SOLVERS, standing.solver)
    return solve(
        brief,
        preset=standing.preset,
        solver=solver,
        steps=steps,
        seed=seed,
        cancel=cancel,
        lanes=_free_lanes(standing),
    )


def _free_lanes(standing: Solution) -> tuple[VillageLane, ...] | None:
    """The lanes that were laid into a village; none where a house that stays stands on one, as
    they are laid anew then."""
    lanes: tuple[VillageLane, ...] = standing.detail or ()
    houses = [p for p in standing.pieces if p.category == "building" and p.fixed]
    grounds = [area_of(LaidLane(lane.line, lane.width, lane.head)) for lane in lanes]
    met = shapely.intersects(polygons_of(houses)[:, None], np.array(grounds, object)[None])
    return None if met.any() else lanes


def _find_house(pieces: Sequence[Piece], name: str) -> tuple[Piece, ...]:
    """The house a name means, if it may be moved and locked."""
    found = find_piece(pieces, name, lambda _piece: False)
    check_lockable(found, HOUSES.dressing, HOUSES.what)
    return (found,)


def rules_of(solution: Solution, plan: Plan) -> HandRules:
    """How buildings are put in, taken away and exchanged by hand."""
    return ground_rules(solution, plan, _rules(solution))


def _rules(_solution: Solution) -> GroundRules:
    return GroundRules(_find_house, lock_village, find_overlapped, _fill_again, APART, "houses")
