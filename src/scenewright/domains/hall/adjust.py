"""A saved hall changed by hand and laid out again around what is locked."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Protocol, TypeVar

from scenewright.building.plan import plan_rooms
from scenewright.building.standing import move_items
from scenewright.catalog.loading import catalog_of
from scenewright.core.edits import Adjusted, Edits
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import apply_edits, find_piece, list_adjusted, with_locks
from scenewright.core.plan import Plan
from scenewright.core.scene import STAIRS, Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall.by_hand import PARTITION, goes_with, make_way, with_groups
from scenewright.domains.hall.hall_layout import HallDetail, HallLayout
from scenewright.domains.hall.record import lock_halls
from scenewright.domains.hall.seats.chairs import CHAIRS
from scenewright.domains.hall.solvers import HALL_SOLVERS
from scenewright.domains.hall.solving import solve
from scenewright.engine.rows import solver_again


class _Placed(Protocol):
    """What lies in one hall."""

    @property
    def space(self) -> str:
        """The id of the hall."""


Row = TypeVar("Row", bound=_Placed)


def adjust(
    solution: Solution,
    edits: Edits,
    *,
    plan: Plan | None = None,
    steps: int | None = None,
    seed: int | None = None,
) -> Adjusted:
    """Make ``edits``. What something moved runs into goes to the nearest free place, and nothing
    else changes; halls named in ``again`` are laid out again around what is locked. A group is
    named by its id and moved as one, an object by its own; locks are of whole groups. Terms and
    energies stay those of the layout as it was solved last."""
    plan = plan or plan_rooms(solution.brief)
    edited = apply_edits(solution.pieces, plan, edits, find_together, _group_of)
    edited = make_way(solution, edited, plan)
    after = replace(solution, pieces=edited.pieces)
    locked = {p.id for p in edited.pieces if p.fixed}
    chosen = solution.seed if seed is None else seed
    if edited.again:
        held = {p.id for p in edited.pieces if p.fixed or p.space not in edited.again}
        brief = lock_halls(replace(solution, pieces=with_locks(edited.pieces, held)))
        solver = solver_again(HALL_SOLVERS, solution.solver)
        again = partial(solve, brief, preset=solution.preset, solver=solver)
        found = again(steps=steps, seed=chosen, cancel=edits.cancel)
        after = _merge_halls(
            after, replace(found, pieces=with_locks(found.pieces, locked)), edited.again
        )
    brief = move_items(solution.brief, solution.pieces, after.pieces)
    after = replace(
        with_groups(solution, after, catalog_of(brief.catalogs)), brief=brief, seed=chosen
    )
    return list_adjusted(solution, after, edited)


def find_together(pieces: Sequence[Piece], name: str) -> tuple[Piece, ...]:
    """What a name means: all of a group, or an object with its chairs."""
    leaders = {p.group: p.id for p in reversed(pieces) if p.group}
    found = find_piece(pieces, name, lambda piece: leaders.get(piece.group) == piece.id)
    _check_movable(found)
    if found.id != name and (found.group == name or found.group.endswith(f"/{name}")):
        return (found, *(p for p in _group_of(found, pieces) if p.id != found.id))
    return (found, *(p for p in pieces if goes_with(p, found)))


def _group_of(piece: Piece, pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """The group of a piece; the piece alone if the brief fixed it alone."""
    if piece.function in ("", "fixed"):
        return (piece,)
    return tuple(p for p in pieces if p.group == piece.group)


def _check_movable(piece: Piece) -> None:
    """InputError for what follows from the rest: walls between zones, stairs, chairs."""
    if piece.function == PARTITION:
        raise InputError(
            f"'{piece.id}' is a wall between zones and follows the layout",
            "lock or move the groups beside it",
        )
    if piece.function == STAIRS:
        raise InputError(f"'{piece.id}' is of the building", "move the stairs in the brief")
    if piece.function.endswith(CHAIRS):
        raise InputError(f"'{piece.id}' goes with its table", "move or lock the table")


def _merge_halls(before: Solution, found: Solution, touched: frozenset[str]) -> Solution:
    """``found`` for the halls ``touched``, all others as they were; of groups that a file lacks
    none."""
    if before.detail is None:
        before = replace(before, detail=HallDetail(HallLayout((), (), ())))

    def join(old: Sequence[Row], new: Sequence[Row]) -> tuple[Row, ...]:
        stay = (row for row in old if row.space not in touched)
        return (*stay, *(row for row in new if row.space in touched))

    old, new = before.detail.layout, found.detail.layout
    pieces = join(before.pieces, found.pieces)
    layout = HallLayout(
        join(old.zones, new.zones),
        join(old.links, new.links),
        join(old.groups, new.groups),
        tuple(p.id for p in pieces if p.function == PARTITION),
    )
    floors = dict(before.detail.floors) | {k: v for k, v in found.detail.floors if k in touched}
    return replace(
        found,
        pieces=pieces,
        terms=join(before.terms, found.terms),
        left_out=join(before.left_out, found.left_out),
        energies=before.energies | {k: v for k, v in found.energies.items() if k in touched},
        brief_hash=before.brief_hash,
        detail=HallDetail(
            layout, join(before.detail.tours, found.detail.tours), tuple(floors.items())
        ),
    )
