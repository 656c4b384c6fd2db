"""Buildings on open ground changed by hand, and placed again only where that is needed.

Sites, villages and extensions differ in what a name means, in which buildings must give way and in
how ground is built on again; the order of these steps is written here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.core.brief import Brief
from scenewright.core.edits import Adjusted, Cancel, Edits
from scenewright.core.piece_edits import Edited, apply_edits, list_adjusted, with_locks
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution

FEW = 2
"""Layouts tried for what gives way, where nobody says how many."""
OVERLAP = 0.01
"""Square metres shared with a building moved by hand that make another give way."""


class GroundRules(NamedTuple):
    """How a domain is changed by hand: the building that a name means (its errors say why it may
    not be moved), the brief with what is locked in a solution, the ids of buildings that must give
    way (those locked never do), a solution with its locked pieces built on again, the
    metres kept ``apart``, and what they are called."""

    find: Callable[[Sequence[Piece], str], tuple[Piece, ...]]
    lock: Callable[[Solution], Brief]
    give_way: Callable[[Solution, Edited, set[str]], set[str]]
    build: Callable[[Solution, int | None, int, Cancel], Solution]
    apart: float = 0.0
    noun: str = "buildings"


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
    edited = apply_edits(solution.pieces, plan, edits, rules.find, _alone, aligned=0.5)
    chosen = solution.seed if seed is None else seed
    after = build_around(solution, edited, rules, steps, chosen, edits.cancel)
    return list_adjusted(solution, after, edited, skip="/green")


def build_around(
    solution: Solution,
    edited: Edited,
    rules: GroundRules,
    steps: int | None,
    seed: int,
    cancel: Cancel = None,
) -> Solution:
    """A solution with its pieces ``edited``: what must give way to them placed again, ways and
    trees laid out anew. The brief stays as it is, but where buildings that it has stand."""
    locked = {p.id for p in edited.pieces if p.fixed}
    free = rules.give_way(solution, edited, locked)
    few = FEW if free else 1
    again = {p.id for p in edited.pieces if p.space in edited.again} - locked
    free |= again
    brief = _follow_fixed(solution, edited, rules)
    same = {p.id for p in solution.pieces} == {p.id for p in edited.pieces}
    if not free and not edited.moved and same:
        return replace(solution, pieces=edited.pieces, brief=brief, seed=seed)
    held = {p.id for p in edited.pieces if p.category == "building"} - free
    standing = replace(solution, pieces=with_locks(edited.pieces, held))
    found = rules.build(standing, steps or (None if again else few), seed, cancel)
    told = () if again else solution.left_out
    return replace(
        found,
        brief=brief,
        pieces=with_locks(found.pieces, locked),
        left_out=tuple(dict.fromkeys((*told, *found.left_out))),
        brief_hash=solution.brief_hash,
    )


def _follow_fixed(solution: Solution, edited: Edited, rules: GroundRules) -> Brief:
    """The brief with the buildings it has standing where they were moved to; itself if none
    was."""
    part = solution.brief.part
    rows = {name: list(areas) for name, areas in part if isinstance(areas, list)}
    kept = {row.id for areas in rows.values() for area in areas for row in _fixed(area)}
    if kept.isdisjoint(edited.moved):
        return solution.brief
    locked = rules.lock(replace(solution, pieces=edited.pieces)).part
    updated = {
        name: [
            area.model_copy(update={"fixed": [row for row in _fixed(area) if row.id in kept]})
            if _fixed(area)
            else area
            for area in getattr(locked, name)
        ]
        for name in rows
    }
    return solution.brief.model_copy(update={"part": part.model_copy(update=updated)})


def _fixed(area: Any) -> list[Any]:
    found: list[Any] = getattr(area, "fixed", [])
    return found


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
