"""What belongs together: pieces that go with others, and what a group is no use without.

A kitchen run with its hob gone is no kitchen, and a hood does not hang over nothing. So when a
piece gives way, whatever is on it or hangs above it goes along, and where the rest would be no use
the whole group goes instead, for another place or a smaller form.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import EATING_TABLES
from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Piece
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.measures import RAISED

Floats = NDArray[np.float64]
Need = tuple[frozenset[str], int]

_CHAIR = frozenset(("dining_chair", "stool", "bench"))


class Gone(NamedTuple):
    """A piece taken out of a group that stands without it, and why."""

    category: str
    reason: str


def _each(*names: str) -> tuple[Need, ...]:
    return tuple((frozenset((name,)), 1) for name in names)


TOGETHER: dict[str, tuple[Need, ...]] = {
    "kitchen": _each("sink_cabinet", "hob_cabinet", "fridge"),
    "kitchenette": _each("sink_cabinet", "hob_cabinet"),
    "seating": (
        (frozenset(("sofa", "loveseat", "corner_sofa")), 1),
        (frozenset(("coffee_table", "side_table")), 1),
    ),
    "media": _each("tv_stand", "tv"),
    "dining": ((EATING_TABLES, 1), (_CHAIR, 2)),
    "dining_wall": ((EATING_TABLES, 1), (_CHAIR, 2)),
    "desk": _each("desk", "office_chair"),
    "corner_desk": _each("corner_desk", "office_chair"),
    "kids_desk": _each("kids_desk", "dining_chair"),
    "terrace": _each("outdoor_table", "outdoor_chair"),
}
"""What a group is no use without, and how many; of the others what makes them."""


def is_whole(function: str, before: Sequence[str], after: Sequence[str]) -> bool:
    """Whether a group that held categories ``before`` is still of use with those ``after``: of all
    it needs there are enough, or as many as there were.

    >>> is_whole("kitchen", ["sink_cabinet", "hob_cabinet", "dishwasher"], ["sink_cabinet"])
    False
    >>> is_whole("kitchen", ["sink_cabinet", "hob_cabinet", "dishwasher"],
    ...          ["sink_cabinet", "hob_cabinet"])
    True
    """
    needs = TOGETHER.get(function) or ((frozenset(GROUPS[function].essential), 1),)
    return all(_count(after, names) >= min(least, _count(before, names)) for names, least in needs)


def _count(categories: Sequence[str], names: frozenset[str]) -> int:
    return sum(category in names for category in categories)


def without(pieces: Sequence[Piece], gone: str) -> tuple[Piece, ...]:
    """The pieces of a group less one, all that stands on it and all that hangs above it."""
    away = {gone}
    lower = next(piece for piece in pieces if piece.id == gone)
    for piece in pieces:
        if piece.on in away or _hangs_over(piece, lower):
            away.add(piece.id)
    return tuple(piece for piece in pieces if piece.id not in away)


def _hangs_over(piece: Piece, lower: Piece) -> bool:
    if piece.on is not None or piece.pose.z < RAISED or lower.pose.z >= RAISED:
        return False
    at, size = lower.pose, lower.size
    return _within((piece.pose.x, piece.pose.y), (at.x, at.y, at.heading, size.width, size.depth))


@lru_cache(maxsize=4096)
def list_grounded(case: Group) -> tuple[int, ...]:
    """The numbers of the members of a case that stand on the floor."""
    return tuple(i for i, m in enumerate(case.members) if m.on < 0 and m.z < RAISED)


def below(members: Sequence[Member]) -> tuple[int, ...]:
    """For each member the number of the one it hangs above (its middle over it), else -1.

    >>> from scenewright.domains.home.cases.library import cases
    >>> members = cases("kitchen").groups[0].members
    >>> [members[b].category for m, b in zip(members, below(members)) if m.category == "hood"]
    ['hob_cabinet']
    """
    floor = [i for i, m in enumerate(members) if m.on < 0 and m.z < RAISED and m.size.height > 0.05]
    found = []
    for member in members:
        hangs = member.on < 0 and member.z >= RAISED
        under = [i for i in floor if hangs and _within((member.x, member.y), _box(members[i]))]
        found.append(under[0] if under else -1)
    return tuple(found)


def _box(member: Member) -> tuple[float, float, float, float, float]:
    size = member.size
    return member.x, member.y, member.heading + np.pi / 2, size.width, size.depth


def _within(point: tuple[float, float], box: tuple[float, float, float, float, float]) -> bool:
    """Whether a point lies over a box, its front along its heading."""
    x, y, heading, width, depth = box
    dx, dy, cos, sin = point[0] - x, point[1] - y, np.cos(heading), np.sin(heading)
    return bool(abs(dx * sin - dy * cos) <= width / 2 and abs(dx * cos + dy * sin) <= depth / 2)
