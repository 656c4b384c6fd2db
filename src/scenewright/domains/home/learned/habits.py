"""How people furnish: what learned rooms tell of distances, free floor and furnished share.

Few rooms tell little. So a learned value counts by the number n of times it was seen, beside the
usual one as if that had been seen k = 5 times,

    (n · learned + k · usual) / (n + k),

the posterior mean of a normal value whose prior has the variance of one observation over k
(shrinkage; Efron and Morris 1975). One sight moves a sixth of the way, fifteen three quarters.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from math import exp, isnan, log, pi
from typing import NamedTuple

from scenewright.domains.home.groups import Sides
from scenewright.domains.home.groups.classes import SLEPT_IN
from scenewright.domains.home.learned.rows import SIDES, Clearance, Distance, Share, Targets

TRUST = 5.0
"""k: how many sights the usual value is worth."""
LIKE = 0.3
"""Rooms that differ in area by this much, as a logarithm, are alike."""
WALKED_WIDTH = 0.6
"""Floor the referee's walking route needs, metres: learned clearances do not go below."""
WISHED_MOST = 1.5
"""Free floor that one can wish for, metres; more is only a large room."""


class Habits(NamedTuple):
    """Statistics of rooms, for looking up: distances by the two functions, clearances by function
    and side, shares by the room's function."""

    distances: dict[tuple[str, str], tuple[Distance, ...]]
    clearances: dict[tuple[str, str], tuple[Clearance, ...]]
    shares: dict[str, tuple[Share, ...]]


NONE = Habits({}, {}, {})


def habits_of(seen: Iterable[Targets]) -> Habits:
    """The habits that several files tell together."""
    distances: dict[tuple[str, str], list[Distance]] = defaultdict(list)
    clearances: dict[tuple[str, str], list[Clearance]] = defaultdict(list)
    shares: dict[str, list[Share]] = defaultdict(list)
    for targets in seen:
        for distance in targets.distances:
            distances[distance.first, distance.second].append(distance)
        for clearance in targets.clearances:
            clearances[clearance.function, clearance.side].append(clearance)
        for share in targets.shares:
            shares[_use(share.function)].append(share)
    return Habits(
        {key: tuple(rows) for key, rows in distances.items()},
        {key: tuple(rows) for key, rows in clearances.items()},
        {key: tuple(rows) for key, rows in shares.items()},
    )


def _use(function: str) -> str:
    return "bedroom" if function in SLEPT_IN else function


def shrunk(learned: float, usual: float, seen: float) -> float:
    """(n · learned + k · usual) / (n + k).

    >>> shrunk(3.0, 2.0, 0), shrunk(3.0, 2.0, 5), round(shrunk(3.0, 2.0, 1e9), 6)
    (2.0, 2.5, 3.0)
    """
    return (seen * learned + TRUST * usual) / (seen + TRUST)


def distance(habits: Habits, pair: tuple[str, str], usual: float) -> float:
    """The distance between the middles of two groups, metres; NaN stays NaN (any)."""
    for row in () if isnan(usual) else habits.distances.get(pair, ()):
        usual = shrunk(row.median, usual, row.seen)
    return usual


def angle(habits: Habits, pair: tuple[str, str], usual: float) -> float:
    """The angle between the headings of two groups: the quarter turn seen most often, the usual
    one counting as k sights; NaN stays NaN (any)."""
    rows = habits.distances.get(pair, ())
    if isnan(usual) or not rows:
        return usual
    votes = [float(sum(row.turns[quarter] for row in rows)) for quarter in range(3)]
    mine = min(round(abs(usual) / (pi / 2)), 2)
    votes[mine] += TRUST
    best = max(range(3), key=votes.__getitem__)
    return usual if best == mine else best * pi / 2


def clear(habits: Habits, function: str, usual: Sides) -> Sides:
    """Free floor wished for at each side of a group, metres: what three of four groups had, but
    no less than a walking route needs where the usual is more than that."""
    front, left, back, right = (
        _clear(habits, function, side, depth) for side, depth in zip(SIDES, usual, strict=True)
    )
    return front, left, back, right


def _clear(habits: Habits, function: str, side: str, usual: float) -> float:
    depth = usual
    for row in habits.clearances.get((function, side), ()):
        depth = shrunk(min(row.low, WISHED_MOST), depth, row.seen)
    return max(depth, min(usual, WALKED_WIDTH))


def share(habits: Habits, function: str, area: float, usual: float) -> float:
    """The share of the floor furnished in rooms of a function of about an area."""
    rooms = list(_alike(habits, function, area))
    seen = sum(weight for weight, _ in rooms)
    summed = sum(weight * row.share for weight, row in rooms)
    return shrunk(summed / seen, usual, seen) if seen > 0.0 else usual


def common(habits: Habits, function: str, area: float, usual: Iterable[str]) -> dict[str, float]:
    """How common groups are in rooms of a function of about an area: the share of the rooms that
    have them, shrunk to 1 for those that are ``usual`` and to 0 for all others."""
    rooms = list(_alike(habits, function, area))
    seen = sum(weight for weight, _ in rooms)
    had = dict.fromkeys(usual, TRUST)
    for weight, row in rooms:
        for group in row.groups:
            had[group] = had.get(group, 0.0) + weight
    return {group: count / (seen + TRUST) for group, count in had.items()}


def _alike(habits: Habits, function: str, area: float) -> Iterator[tuple[float, Share]]:
    """The rooms of a function, each counting by how alike it is in area,
    exp(-(ln A/Aᵢ)² / 2 · 0.3²)."""
    for row in habits.shares.get(_use(function), ()):
        yield exp(-0.5 * (log(area / row.area) / LIKE) ** 2), row
