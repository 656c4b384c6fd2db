"""A screen for those who sit in a home without one: on the axis of a seat, at a wall before it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import SOFAS
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.composing.filling.bare_floor import pieces_of
from scenewright.domains.home.composing.homewide.settling import (
    HomeState,
    list_sound,
    may_take_in,
    try_in_home,
)
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.placed_faults import cost_of_screen
from scenewright.domains.home.composing.places.moving import dress_group, find_places, make_unplaced
from scenewright.domains.home.composing.views import ASTRAY, WATCHED_FROM, WATCHED_TO, is_unseen
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.groups.living import hung_screens, media
from scenewright.domains.home.measures import ALIKE
from scenewright.domains.home.needs.searching import may_settle
from scenewright.domains.home.programme import Wish

Floats = NDArray[np.float64]

SEATS = (SOFAS, frozenset(("armchair",)), frozenset(("double_bed",)))
"""What one watches a screen from, what it is set before first."""
STANDS, PLACES, OF_FORM = 4, 4, 2
"""Stands that are tried, the narrowest, before screens on the wall; places before a seat that are
walked past, and those of one form."""
STEP = 0.1
"""Metres between places along a wall."""


def add_screen(home: HomeState, answers: list[RoomAnswer]) -> list[RoomAnswer]:
    """The answers with a screen on the axis of a sofa, an armchair or a bed for two in a home
    without one."""
    there = [pieces_of(t, a.placed) for t, a in zip(home.tasks, answers, strict=True)]
    shown = any(p.category in ("tv", "fireplace") for pieces in there for p in pieces)
    if shown or home.timed or home.household is None or not may_settle(home):
        return answers
    for kinds in SEATS:
        for room, (task, answer) in enumerate(zip(home.tasks, answers, strict=True)):
            for placed in islice(_list_shown(task, answer.placed, kinds), PLACES):
                missing = tuple(m for m in answer.missing if m.wish.group != "media")
                trial = answer._replace(placed=placed, missing=missing)
                found = try_in_home(room, trial, answers, home.opened)
                if found is not None:
                    return found
    return answers


def _list_shown(task: RoomTask, placed: Placed, kinds: frozenset[str]) -> Iterator[Placed]:
    """The groups of a room with a screen before one of its seats, where nothing is worse for it."""
    if not may_take_in(task, "media") or task.forbidden & {"tv", "tv_stand"}:
        return
    seats = [p for group in placed for p in group.pieces if p.category in kinds]
    for seat in sorted(seats, key=lambda p: -p.size.width):
        for found in list_sound(task, placed, placed, _list_before(task, placed, seat)):
            small = cost_of_screen(found, task.ground, 1.0) > 0.0
            if not small and not is_unseen(found, task.ground.edges):
                yield found


def _list_before(task: RoomTask, placed: Placed, seat: Piece) -> Iterator[FurnishedGroup]:
    """Screens at a wall before a seat, those nearest to its axis first."""
    standing = standing_of(pieces_of(task, placed), flat_kinds(task.catalog))
    for case in (*islice(media(), STANDS), *hung_screens()):
        group = make_unplaced(task, placed, Wish("media", 1), case)
        for _, boxes in find_places(task, (case,), standing, group, STEP):
            dressed = (
                dress_group(task, group, case, box, standing)
                for box in _order_before(boxes, seat)[:OF_FORM]
            )
            yield from (each for each in dressed if each is not None)


def _order_before(boxes: Floats, seat: Piece) -> Floats:
    """Of boxes (n, 5) those on the axis of a seat that look at it, the nearest to it first."""
    x, y, _, turn = seat.pose
    dx, dy = boxes[:, 0] - x, boxes[:, 1] - y
    ahead = dx * np.cos(turn) + dy * np.sin(turn)
    aside = np.abs(dx * np.sin(turn) - dy * np.cos(turn))
    fit = (aside <= ASTRAY) & (np.cos(boxes[:, 2] - turn) < -ALIKE)
    at = np.flatnonzero(fit & (ahead >= WATCHED_FROM) & (ahead <= WATCHED_TO))
    return boxes[at[np.argsort(aside[at], kind="stable")]]
