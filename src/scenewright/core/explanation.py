"""Why a layout is as it is, in words: what was not placed, what it gives up, and what helps.

The words are rows of tables that each domain states: :class:`Remedy` by the reason something was
left out for, :class:`Compromise` by the term of the energy that is not met.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from scenewright.core.views import describe, show

MOST_REMARKS = 12
"""Compromises that are listed."""


class Remedy(NamedTuple):
    """What helps where a reason matches ``pattern``, a regular expression; ``{0}`` in ``text``
    stands for its first group."""

    pattern: str
    text: str


class Compromise(NamedTuple):
    """What is said where the value of a term reaches ``least``, and what helps; ``{value}`` in
    ``text`` stands for it."""

    least: float
    text: str
    remedy: str


class Advice(NamedTuple):
    """``number`` things alike that were not placed in a space (by name), why, and what helps;
    ``required`` if they were asked for or are essential."""

    space: str
    what: str
    number: int
    reason: str
    remedy: str
    required: bool


class Remark(NamedTuple):
    """Something the layout gives up: where, its ``items``, in words, and what helps; ``cost``
    is its part of the energy."""

    space: str
    items: tuple[str, ...]
    term: str
    text: str
    remedy: str
    cost: float

    def __str__(self) -> str:
        return ": ".join(filter(None, [self.space, ", ".join(self.items), self.text]))


class LedgerRow(NamedTuple):
    """One need of those a scene is for: how much of it, in its ``unit`` (empty: a number), is
    ``owed`` and ``stands``; ``where`` it stands, else where it is owed; ``why`` not all of it
    (empty: it is met)."""

    need: str
    unit: str
    owed: float
    stands: float
    where: str
    why: str

    def tell(self) -> dict[str, str]:
        """The cells of its row, by the heads of the table.

        >>> LedgerRow("clothes", "m of rail", 1.5, 0.8, "Bed", "no wall").tell()["owed"]
        '1.5 m of rail'
        """
        return {
            "need": self.need,
            "owed": f"{self.owed:.3g} {self.unit}".strip(),
            "stands": f"{self.stands:.3g}",
            "where": self.where,
            "why not": self.why,
        }


class Explanation(NamedTuple):
    """What was ``decided`` for the whole, what was not placed (required things first), the
    compromises of the layout, the costliest first, and the ``ledger`` of what is needed."""

    name: str
    decided: str
    left_out: tuple[Advice, ...]
    remarks: tuple[Remark, ...]
    ledger: tuple[LedgerRow, ...] = ()

    def __repr__(self) -> str:
        """One line: how much there is to read."""
        required = sum(advice.number for advice in self.left_out if advice.required)
        counts = {"not_placed": required, "remarks": len(self.remarks)}
        return describe("Explanation", self.name, **counts)

    def __str__(self) -> str:
        """Lines: what was decided, needs that are not met, what was not placed, then compromises
        by what helps."""
        lines = [
            self.decided,
            *map(describe_lack, self.ledger),
            *map(describe_advice, self.left_out),
            *describe_remarks(self.remarks),
        ]
        return "\n".join(filter(None, lines))

    def _repr_html_(self) -> str:
        """In notebooks: tables of what was not placed and of compromises."""
        return str(show("explanation_html", self))


def describe_lack(row: LedgerRow) -> str:
    """A need that is not met in one line; empty for one that is.

    >>> describe_lack(LedgerRow("beds", "", 2.0, 1.0, "Bedroom", "no wall"))
    'beds: 1 of 2 (Bedroom): no wall'
    """
    cells = row.tell()
    place = f" ({row.where})" if row.where else ""
    return f"{row.need}: {cells['stands']} of {cells['owed']}{place}: {row.why}" if row.why else ""


def describe_advice(advice: Advice) -> str:
    """The things not placed, in one line.

    >>> describe_advice(Advice("Bath", "washing machine", 1, "no wall", "free a wall", True))
    'not placed: washing machine (Bath): no wall; what helps: free a wall'
    """
    mark = "not placed" if advice.required else "optional, not placed"
    what = f"{advice.number} × {advice.what}" if advice.number > 1 else advice.what
    place = f" ({advice.space})" if advice.space else ""
    helps = f"; what helps: {advice.remedy}" if advice.remedy else ""
    return f"{mark}: {what}{place}: {advice.reason}{helps}"


def describe_remarks(remarks: Sequence[Remark], most: int = MOST_REMARKS) -> list[str]:
    """Compromises in lines, those with the same remedy together; what exceeds ``most`` is counted.

    >>> dark = Remark("Study", ("desk",), "daylight", "far from the window", "move it", 9.0)
    >>> describe_remarks([dark])
    ['move it:', '  Study: desk: far from the window']
    """
    groups: dict[str, list[Remark]] = {}
    for remark in remarks[:most]:
        groups.setdefault(remark.remedy, []).append(remark)
    lines = []
    for remedy, alike in groups.items():
        lines += [f"{remedy}:", *(f"  {remark}" for remark in alike)]
    spare = len(remarks) - most
    return [*lines, f"and {spare} smaller compromises"] if spare > 0 else lines


def find_remedy(reason: str, rows: Iterable[Remedy]) -> str:
    """The remedy of the first row whose pattern is found in a reason; empty if none is.

    >>> find_remedy("no wall of 1.2 m", [Remedy(r"no wall of ([0-9.]+) m", "free {0} m of wall")])
    'free 1.2 m of wall'
    """
    for row in rows:
        if found := re.search(row.pattern, reason):
            return row.text.format(*found.groups())
    return ""
