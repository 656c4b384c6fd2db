"""Fixed pieces, as the brief states them, never as the solution that is judged does.

Whether a piece is given, and where it then stands, follows from the brief alone, by id. A piece is
not given because a solution marks it as fixed: what a person locked there is judged as any other
piece, and findings say so.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog, asset_of, footprint_of
from scenewright.core.report import Finding
from scenewright.core.scene import Piece

MOVED = 0.01
"""Tolerance for a fixed piece that was moved, turned (at its corners) or resized, in metres."""


class Restored(NamedTuple):
    """The pieces to judge: each that is given as the brief has it, all others as they are; what
    was changed of what is given; and the ids of what a person ``locked``."""

    pieces: tuple[Piece, ...]
    findings: tuple[Finding, ...]
    locked: frozenset[str]


def restore_given(
    pieces: Sequence[Piece], given: Sequence[Piece], locked: Collection[str]
) -> Restored:
    """Pieces with all that is ``given`` by the brief put where it stands, and a finding for each
    that is missing, renamed to another kind or space, moved, turned or of another size.

    Just what is given is ``fixed`` among the answers, but for the ids ``locked`` by a person.
    """
    waiting = {piece.id: piece for piece in given}
    judged, findings = [], []
    by_hand = {piece.id for piece in pieces if piece.fixed} - waiting.keys() | {*locked}
    for piece in pieces:
        stands = waiting.pop(piece.id, None)
        if stands is not None:
            findings += list(_find_change(piece, stands))
        judged.append(replace(stands or piece, fixed=stands is not None and piece.id not in locked))
    for stands in waiting.values():
        findings.append(_state(stands, f"{stands.id} is given by the brief and missing"))
        judged.append(replace(stands, fixed=stands.id not in locked))
    return Restored(tuple(judged), tuple(findings), frozenset(by_hand))


def restore_footprints(pieces: Sequence[Piece], catalog: Catalog) -> tuple[Piece, ...]:
    """Pieces that say they cover less than their box, each with what its model covers; what no
    model of the catalog draws is taken at its word."""
    models = (asset_of(piece, catalog) if piece.footprint else None for piece in pieces)
    return tuple(
        replace(piece, footprint=footprint_of(model, piece.size)) if model else piece
        for piece, model in zip(pieces, models, strict=True)
    )


def _find_change(piece: Piece, stands: Piece) -> Iterator[Finding]:
    """A finding if a piece is not as the brief has it."""
    if (piece.category, piece.space) != (stands.category, stands.space):
        text = f"{piece.id} is given as {stands.category} of {stands.space}, "
        yield _state(stands, text + f"not as {piece.category} of {piece.space}")
        return
    moved = float(np.abs(np.subtract(piece.pose[:3], stands.pose[:3])).max())
    resized = float(np.abs(np.subtract(piece.size, stands.size)).max())
    turn = abs(float(np.angle(np.exp(1j * (piece.pose.heading - stands.pose.heading)))))
    amount = max(moved, resized, turn * max(stands.size[:2]) / 2)
    if not amount <= MOVED:  # what is no number has changed, too
        text = f"{piece.id} is given by the brief and was changed: moved {moved:.2f} m, turned "
        text += f"{np.rad2deg(turn):.1f} degrees, size off by {resized:.2f} m"
        yield _state(stands, text, amount)


def _state(stands: Piece, text: str, amount: float = 0.0) -> Finding:
    return Finding("changed_given", "", stands.space, stands.id, "", text, round(amount, 4))


def mark_locked(findings: Sequence[Finding], locked: Collection[str]) -> tuple[Finding, ...]:
    """Findings with those marked that concern something a person locked.

    >>> found = Finding("collision", "0", "a", "a/bed", "a/desk", "they overlap")
    >>> [one.locked for one in mark_locked([found], {"a/desk"})]
    [True]
    """
    return tuple(
        replace(found, locked=True)
        if not {found.piece, *found.other.split(",")}.isdisjoint(locked)
        else found
        for found in findings
    )


def locked_ids(brief: Brief) -> frozenset[str]:
    """The ids of what a person locked in a saved solution, of all that a brief keeps in place."""
    part = (rows for _, rows in brief.part or () if isinstance(rows, list))
    areas = (*brief.rooms, *(area for rows in part for area in rows))
    kept = (item for area in areas for item in getattr(area, "fixed", ()))
    return frozenset(item.id for item in kept if getattr(item, "locked", False))
