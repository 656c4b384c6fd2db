"""Furniture as people leave it: chairs pulled out and turned, small objects moved on what they
stand on. Whatever breaks a rule of the referee goes back to where it stood."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from scenewright import domains
from scenewright.catalog.classes import TABLE_SEATS
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution

LOOSE = TABLE_SEATS | {"office_chair", "bar_stool", "pouf", "reading_chair"}
"""What stands free on the floor and is moved with one hand."""
PUSHED, TURNED = 0.06, 0.2
"""How far loose things are moved, in metres, and turned, in radians, at most."""
SLID, SPUN = 0.12, 0.35
"""The same of things that stand on others, within the top of these."""
SMALL = 0.5
"""Things on others wider than this, in metres, are turned a tenth as far: a screen is looked at."""
TRIES = 4
"""How often what breaks a rule is put back before all is."""


class Disturbed(NamedTuple):
    """A solution with what was moved in it, and the referee's report on it."""

    solution: Solution
    report: Report
    moved: tuple[str, ...]


def disturb(solution: Solution, plan: Plan, rng: np.random.Generator) -> Disturbed:
    """Move what is loose by a little; the answer breaks no rule that it did not break before.

    >>> from scenewright.formats import read_planned
    >>> brief, plan = read_planned("sample:home-room")
    >>> before = domains.solve(brief, plan=plan, steps=200)
    >>> after = disturb(before, plan, np.random.default_rng(1))
    >>> len(after.moved) > 0, after.report.valid
    (True, True)
    """
    known = {piece.id: piece for piece in solution.pieces}
    bearing = {piece.on for piece in solution.pieces}
    moved = {
        piece.id: _moved(piece, known.get(piece.on or ""), rng)
        for piece in solution.pieces
        if not piece.fixed and piece.id not in bearing and (piece.on or piece.category in LOOSE)
    }
    before = domains.check(solution, plan=plan)
    accepted = {_key(found) for found in before.findings}
    for _ in range(TRIES):
        changed = replace(solution, pieces=tuple(moved.get(p.id, p) for p in solution.pieces))
        report = domains.check(changed, plan=plan)
        new = [found for found in report.findings if _key(found) not in accepted]
        if not new:
            return Disturbed(changed, report, tuple(moved))
        blamed = {name for found in new for name in (found.piece, *found.other.split(","))}
        kept = {name: piece for name, piece in moved.items() if name not in blamed}
        moved = kept if len(kept) < len(moved) else {}
    return Disturbed(solution, before, ())


def _key(found: object) -> tuple[object, ...]:
    """What makes a finding the same one, whatever its amount."""
    return tuple(getattr(found, name) for name in ("kind", "space", "piece", "other"))


def _moved(piece: Piece, support: Piece | None, rng: np.random.Generator) -> Piece:
    """A piece a little beside where it stood; on a support it stays within its top."""
    along, across, turn = rng.uniform(-1.0, 1.0, 3).tolist()
    if support is None:
        return _at(piece, PUSHED * along, PUSHED * across, TURNED * turn)
    heading = SPUN * turn * (0.1 if piece.size.width > SMALL else 1.0)
    x, y = _within(piece, support, heading, np.array([SLID * along, SLID * across]))
    return _at(piece, x, y, heading)


def _at(piece: Piece, x: float, y: float, turn: float) -> Piece:
    """A piece moved by ``x`` and ``y`` in plan and turned."""
    pose = piece.pose
    x, y, heading = (round(pose.x + x, 4), round(pose.y + y, 4), round(pose.heading + turn, 4))
    return replace(piece, pose=pose._replace(x=x, y=y, heading=heading))


def _within(
    piece: Piece,
    support: Piece,
    turn: float,
    shift: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
) -> tuple[float, float]:
    """As much of a shift as keeps the box of a piece, turned so, within the top of its support."""
    heading = support.pose.heading
    axes = np.array([[np.sin(heading), -np.cos(heading)], [np.cos(heading), np.sin(heading)]])
    beside = np.array([piece.pose.x - support.pose.x, piece.pose.y - support.pose.y])
    at, wanted = axes @ beside, axes @ (beside + shift)
    lean = piece.pose.heading + turn - heading
    cos, sin = abs(np.cos(lean)), abs(np.sin(lean))
    w, d = piece.size.width, piece.size.depth
    half = np.array([w * cos + d * sin, w * sin + d * cos]) / 2
    room = np.maximum(np.array([support.size.width, support.size.depth]) / 2 - half, 0.0)
    room = np.maximum(room, np.abs(at))  # what stood over the edge stands no farther over it
    x, y = ((np.clip(wanted, -room, room) - at) @ axes).tolist()
    return x, y
