"""Wardrobes in proportion to who sleeps in the room: none fills the wall of a studio for one.

Wardrobes follow the floor of their room, and a room that is also cooked or lived in has more of it
than its beds ask for. Housing handbooks plan a metre of hanging space and half as much of shelves a
person (Neufert, Architects' Data, 4th ed., bedrooms), so what is far beyond that is cut.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, judge_of
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.composing.places.moving import dress_group
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.measures import HAIR

Floats = NDArray[np.float64]

METRES = {"sleeping": 2.4, "single": 1.6, "bunk": 2.4}
"""Metres of wardrobe that are enough beside a bed, by its group."""
MORE = 0.45  # what is beyond that by no more is left, metres
SPARE = 0.2  # what is cut keeps this much more than the least, metres


def trim_wardrobe(task: RoomTask, best: JudgedRoom) -> JudgedRoom:
    """The groups with a wardrobe far too wide for the beds of its room cut at the end where the
    room then costs less, unless it was asked for."""
    enough = sum(METRES.get(p.wish.group, 0.0) for p in best.placed)
    at = next((i for i, p in enumerate(best.placed) if p.wish.group == "wardrobe"), None)
    if at is None or enough == 0.0 or "wardrobe" in task.library.own:
        return best
    group = best.placed[at]
    asked = group.wish.required or group.wish.most is not None
    if asked or group.dressed.case.width <= enough + MORE:
        return best
    judge = judge_of(task, best.placed)
    cut = (judge.cost_of(p) for p in _list_cut(task, best.placed, at, enough + SPARE))
    return min(cut, key=lambda judged: judged.cost, default=best)


def _list_cut(task: RoomTask, placed: Placed, at: int, most: float) -> Iterator[Placed]:
    """The groups with one of them in its widest form of at most ``most`` metres and no more depth,
    at either end of where it stands."""
    group, rest = placed[at], (p for i, p in enumerate(placed) if i != at)
    pieces = (*task.fixed, *task.beside, *(p for other in rest for p in other.pieces))
    standing, old = standing_of(pieces, flat_kinds(task.catalog)), group.dressed.case
    forms = [f for f in list_forms(task, group) if f.width <= most + HAIR]
    forms = [f for f in forms if f.depth <= old.depth + HAIR]
    if not forms:
        return
    case = max(forms, key=lambda form: (form.width, form.depth))
    for box in _shift(group, case.width, case.depth):
        cut = dress_group(task, group, case, box, standing)
        if cut is not None:
            yield (*placed[:at], cut, *placed[at + 1 :])


def _shift(group: FurnishedGroup, width: float, depth: float) -> Iterator[Floats]:
    """The boxes of a narrower form with its back where the group's is, at either end of it."""
    x, y, heading, wide, deep = group.dressed.box.tolist()
    c, s = np.cos(heading), np.sin(heading)
    back = (depth - deep) / 2
    for side in (-1, 1):
        along = side * (wide - width) / 2
        yield np.array([x + back * c + along * s, y + back * s - along * c, heading, width, depth])
