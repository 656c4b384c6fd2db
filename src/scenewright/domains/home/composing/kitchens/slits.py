"""Slits between the end of a run and a wall or a neighbour, closed by a wider cabinet.

Places along walls are looked for in steps, so a run may end 5 to 25 cm before its corner: floor
that nobody can clean. The cabinet nearest to that end is widened by the gap, and the units
between it and the end move along.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, sin
from typing import NamedTuple

import numpy as np

from scenewright.catalog.classes import PLAIN_CABINETS, RUN
from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomAnswer,
    RoomTask,
    bars_no_more,
)
from scenewright.domains.home.composing.case_faults import find_neighbour
from scenewright.domains.home.composing.places.moving import dress_group, with_margin
from scenewright.domains.home.composing.places.wall_stretch import find_stretch, list_taken
from scenewright.domains.home.composing.spacing.rules import measure_closeness
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.groups.kitchen import UNIT_DEPTH, WORKTOP_HEIGHT
from scenewright.domains.home.measures import HAIR, RAISED

SLIT = (0.03, 0.25)  # between these a gap is a slit, metres
WIDEST = 1.0  # greatest width of a cabinet that grows, metres
AT = 0.02  # what hangs nearer to the middle of a unit hangs above it, metres


class Slit(NamedTuple):
    """The unit of a case at which a run ends, the side (+1 to its right), and the gap, metres."""

    unit: Member
    side: int
    gap: float


def close_slits(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer with the slits at the ends of its kitchen closed where that bars no way and brings
    it no nearer to what keeps off; as it was where something was taken off the kitchen: laid out
    anew it would be back."""
    run = next((p for p in answer.placed if p.wish.group in RUNS and p.pieces), None)
    if run is None or not may_grow(task, run):
        return answer
    for side in (-1, 1):
        for _ in range(2):  # a kitchen round a corner has two ends to either side at most
            ends = (e for e in list_ends(task, answer, run) if e.side == side)
            slit = next((e for e in ends if SLIT[0] < e.gap < SLIT[1]), None)
            closed = _close(task, answer, run, slit) if slit else None
            if closed is None:
                break
            at = answer.placed.index(run)
            placed = (*answer.placed[:at], closed, *answer.placed[at + 1 :])
            rooms = (placed, answer.placed)
            near, before = (measure_closeness(r, task.fixed, task.ground) for r in rooms)
            if near > before + HAIR or not bars_no_more(with_margin(task), placed, barred):
                break
            answer, run = answer._replace(placed=placed), closed
    return answer


def may_grow(task: RoomTask, run: FurnishedGroup) -> bool:
    """Whether a kitchen may be longer, and nothing was taken off it."""
    whole = len(run.pieces) == sum(run.dressed.stands)
    return whole and run.wish.most is None and not task.library.own


def list_ends(task: RoomTask, answer: RoomAnswer, run: FurnishedGroup) -> Iterator[Slit]:
    """The units of a kitchen that nothing of it follows, with what is free beside them."""
    held = zip(run.dressed.case.members, run.dressed.stands, strict=True)
    pairs = zip((m for m, there in held if there), run.pieces, strict=True)
    low = [(m, p) for m, p in pairs if is_unit(m)]
    units = [m for m, _ in low]
    for unit, piece in low:
        for side in (-1, 1):
            if find_neighbour(unit, units, side) is None:
                yield Slit(unit, side, _measure_gap(task, answer, piece, side))


def is_unit(member: Member) -> bool:
    """Whether a member of a kitchen stands on the floor as one of its units."""
    return member.category in RUN and member.z < RAISED


def _measure_gap(task: RoomTask, answer: RoomAnswer, piece: Piece, side: int) -> float:
    """Metres from a side of a unit to its neighbour along the wall; 0 away from walls."""
    others = (q for p in answer.placed for q in p.pieces if q is not piece)
    standing = standing_of((*task.fixed, *task.beside, *others), flat_kinds(task.catalog))
    taken = list_taken(task.ground, standing, np.empty((0, 5)), WORKTOP_HEIGHT)
    pose, size = piece.pose, piece.size
    box = np.array([pose.x, pose.y, pose.heading, size.width, size.depth])
    stretch = find_stretch(task.ground, box, UNIT_DEPTH, taken)
    if stretch is None:
        return 0.0
    far = stretch.length - stretch.at if side > 0 else stretch.at
    return far - size.width / 2


def _close(
    task: RoomTask, answer: RoomAnswer, run: FurnishedGroup, slit: Slit
) -> FurnishedGroup | None:
    """The kitchen with a slit closed; None where no cabinet may grow or it stands not free so."""
    case = widen_end(run.dressed.case, slit)
    if case is None:
        return None
    others = (q for p in answer.placed if p is not run for q in p.pieces)
    standing = standing_of((*task.fixed, *task.beside, *others), flat_kinds(task.catalog))
    return dress_group(task, run, case, run.dressed.box, standing)


def widen_end(case: Group, slit: Slit) -> Group | None:
    """A case with the cabinet nearest to a slit widened to close it, all beyond it moved;
    None where none may grow."""
    units = [m for m in case.members if is_unit(m)]
    moved, at = list[Member](), slit.unit
    while at.category not in PLAIN_CABINETS or at.size.width + slit.gap > WIDEST:
        moved.append(at)
        following = find_neighbour(at, units, -slit.side)
        if following is None or following.category == "corner_cabinet":
            return None
        at = following
    c, s = cos(slit.unit.heading) * slit.side, sin(slit.unit.heading) * slit.side

    def shift(member: Member, of: Member, share: float) -> Member:
        wide = member.size.width + (slit.gap if of is at else 0.0)
        by = slit.gap * share
        size = member.size._replace(width=wide)
        return member._replace(x=member.x + c * by, y=member.y + s * by, size=size)

    def change(member: Member) -> Member:
        own = next((u for u in (at, *moved) if belongs(member, u)), None)
        return member if own is None else shift(member, own, 0.5 if own is at else 1.0)

    return case._replace(members=tuple(change(m) for m in case.members))


def belongs(member: Member, unit: Member) -> bool:
    """Whether a member is a unit or hangs above it."""
    c, s = cos(unit.heading), sin(unit.heading)
    aside = c * (member.x - unit.x) + s * (member.y - unit.y)
    alike = abs(member.heading - unit.heading) < AT
    ahead = abs(c * (member.y - unit.y) - s * (member.x - unit.x))
    return member is unit or (
        member.z >= RAISED and alike and abs(aside) < AT and ahead < UNIT_DEPTH
    )
