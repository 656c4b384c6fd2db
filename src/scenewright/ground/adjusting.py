"""Buildings on open ground changed by hand, and placed again only where that is needed.

Sites, villages and extensions differ in what a name means, in which buildings must give way and in
how ground is built on again; the order of these steps is written here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.brief import Brief
from scenewright.core.edits import Adjusted, Cancel, Edits
from scenewright.core.piece_edits import Edited, apply_edits, list_adjusted, with_locks
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution

OVERLAP = 0.01
"""Square metres shared with a building moved by hand that make another give way."""


class GroundRules(NamedTuple):
    """How a domain is changed by hand: the building that a name means (its errors say why it may
    not be moved), the brief with what is locked in a solution, the ids of buildings that must give
    way (those locked never do), and a solution with its locked pieces built on again."""

    find: Callable[[Sequence[Piece], str], tuple[Piece, ...]]
    lock: Callable[[Solution], Brief]
    give_way: Callable[[Solution, Edited, set[str]], set[str]]
    build: Callable[[Solution, int | None, int, Cancel], Solution]


def adjust_ground(
    solution: Solution,
    plan: Plan,
    edits: Edits,
    rules: GroundRules,
    steps: int | None,
    seed: int | None,
) -> Adjusted:
    """Make ``edits`` and place again what they touch, with the solution's seed unless given one.

    All buildings that need not give way stay; in spaces named in ``again`` only those locked do.
    """
    edited = apply_edits(solution.pieces, plan, edits, rules.find, _alone)
    locked = {p.id for p in edited.pieces if p.fixed}
    free = rules.give_way(solution, edited, locked)
    free |= {p.id for p in edited.pieces if p.space in edited.again} - locked
    chosen = solution.seed if seed is None else seed
    if not free and not edited.moved:
        after = replace(solution, pieces=edited.pieces)
    else:
        held = {p.id for p in edited.pieces if p.category == "building"} - free
        standing = replace(solution, pieces=with_locks(edited.pieces, held))
        found = rules.build(standing, steps, chosen, edits.cancel)
        after = replace(
            found,
            brief=rules.lock(standing),
            pieces=with_locks(found.pieces, locked),
            brief_hash=solution.brief_hash,
        )
    after = replace(after, brief=rules.lock(after), seed=chosen)
    return list_adjusted(solution, after, edited, skip="/green")


def find_overlapped(_solution: Solution, edited: Edited, locked: set[str]) -> set[str]:
    """Ids of buildings that a moved one stands on, by more than :data:`OVERLAP`."""
    houses = [p for p in edited.pieces if p.category == "building"]
    moved = [p for p in houses if p.id in edited.moved]
    others = [p for p in houses if p.id not in locked]
    if not moved or not others:
        return set()
    shapes, theirs = polygons_of(moved), polygons_of(others)
    shared = shapely.area(shapely.intersection(shapes[:, None], theirs[None]))
    return {others[k].id for k in np.flatnonzero((shared > OVERLAP).any(0))}


def _alone(piece: Piece, _pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    return (piece,)
