"""One verdict on an arrangement, and the one answer to "is it better?"."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

LEAST = 1e-6
"""What two costs differ by and still are one."""


class Verdict(NamedTuple):
    """What an arrangement amounts to.

    ``lost`` is what is asked for and missing, each by its weight; ``broken`` the number of hard
    rows that do not hold, barred ways and overlaps among them; ``findings`` the faults by row that
    no cost makes up for, as numbers or degrees; ``cost`` what each soft row comes to.
    """

    lost: float = 0.0
    broken: int = 0
    findings: Mapping[str, float] = {}
    cost: Mapping[str, float] = {}

    @property
    def total(self) -> float:
        """Σ of the costs of all soft rows."""
        return sum(self.cost.values())


def better(a: Verdict, b: Verdict, least: float = LEAST) -> bool:
    """Whether arrangement ``a`` is better than ``b``.

    It breaks no more hard rows, loses no more and has no more of any finding; and it has less of
    one of these, or costs less by more than ``least``. So a cost never buys a finding, and two
    arrangements may each be no better than the other.

    >>> dark, bright = Verdict(findings={"window": 1.0}), Verdict(cost={"axis": 9.0})
    >>> better(bright, dark), better(dark, bright)
    (True, False)
    >>> better(Verdict(cost={"axis": 2.0}), Verdict(cost={"axis": 3.0}))
    True
    """
    if a.broken > b.broken or a.lost > b.lost + LEAST:
        return False
    if any(found > b.findings.get(row, 0.0) + LEAST for row, found in a.findings.items()):
        return False
    fewer = any(a.findings.get(row, 0.0) < found - LEAST for row, found in b.findings.items())
    won = a.broken < b.broken or a.lost < b.lost - LEAST or fewer
    return won or a.total < b.total - least


def list_worst(verdict: Verdict) -> list[str]:
    """The rows that do not hold: findings first, then costs, the largest first of each.

    >>> list_worst(Verdict(findings={"window": 1.0}, cost={"axis": 2.0, "near": 5.0, "far": 0.0}))
    ['window', 'near', 'axis']
    """
    both = (verdict.findings, verdict.cost)
    return [
        row
        for group in both
        for row in sorted(group, key=lambda row: (-group[row], row))
        if group[row] > LEAST
    ]
