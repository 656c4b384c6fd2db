"""The least a hall's energy could be: most of the number is constant, and what lies above counts.

The barrier φ of Cao, Cheng and Zhang (2024, eq. 2) is 20 at 0 and a half at 1, so that groups and
neighbours cost something wherever they stand: 186 of 194 in the sample shop. The paper prints no
such floor; it is ours, and so is the excess over it.
"""

from __future__ import annotations

import math

from scenewright.core.solution import Solution, TermValue
from scenewright.domains.hall.hall_layout import HallLayout, PlacedGroup
from scenewright.domains.hall.terms.table import barrier, space_cost

LOOSE = ("single", "wall")
"""Patterns whose objects are no neighbours to the term ``proportion``."""


def floors_of(solution: Solution) -> dict[str, float]:
    """The floors that a solution of halls tells, by space; none in files of earlier versions."""
    return {} if solution.detail is None else dict(solution.detail.floors)


def least_energies(
    terms: tuple[TermValue, ...], layout: HallLayout, printed: bool
) -> dict[str, float]:
    """The floor of the energy of every hall that has terms, by its space.

    A lower bound, Σ weight times the least of each term: 20 a group for ``space``, φ(1) for each
    pair of neighbours for ``proportion`` and each zone that holds something for ``fill`` (as
    ``printed``, all of it: nothing changes it), the fewest lines on which n objects can stand for
    ``alignment``, 0 for the rest. The energy is never below it.

    >>> term = TermValue("hall", "busts", "space", 21.0, 3.0, 63.0)
    >>> round(least_energies((term,), HallLayout((), (), ()), False)["hall"], 6)
    60.0
    """
    groups = {group.id: group for group in layout.groups}
    found: dict[str, float] = {}
    for term in terms:
        least = term.weight * _least(term, groups, printed)
        found[term.space] = found.get(term.space, 0.0) + least
    return found


def _least(term: TermValue, groups: dict[str, PlacedGroup], printed: bool) -> float:
    """The least value of one part of an energy."""
    if term.term == "space":
        return space_cost(0.0, 1.0)
    if term.term == "fill":
        return term.value if printed else min(term.value, barrier(1.0))
    if term.term == "proportion" and term.item in groups:
        group = groups[term.item]
        pairs = 0 if group.pattern in LOOSE else len(group.objects) - 1
        return min(term.value, pairs * barrier(1.0))
    if term.term == "alignment":
        mine = [group for group in groups.values() if group.space == term.space]
        return min(term.value, float(fewest_lines(sum(len(group.objects) for group in mine))))
    return 0.0


def fewest_lines(count: int) -> int:
    """The least a + b with a b at least ``count``: lines along and across whose crossings hold
    ``count`` objects.

    >>> [fewest_lines(count) for count in (0, 1, 2, 4, 5, 9, 10)]
    [0, 2, 3, 4, 5, 6, 7]
    """
    return math.isqrt(4 * count - 1) + 1 if count else 0
