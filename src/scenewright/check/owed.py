"""What a brief asks for against the solution: too few, unless left out with a reason, and too many.

How much is owed follows from the brief. A solution may say that it left something out, and why: it
is then not complete, but breaks no rule. What is neither there nor so accounted for is missing.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from scenewright.core.report import Finding
from scenewright.core.solution import LeftOut

ALL = 1 << 30
"""As many as anybody may ask for."""
_SHARE = re.compile(r"(\d+) of (\d+) ")


class Owed(NamedTuple):
    """Something a brief asks for in a space: its ``name``, how many are ``there``, how many at
    ``least`` and at ``most``, and the ``words`` by any of which a solution may name it as left out
    (none: whatever it says of the space)."""

    space: str
    name: str
    there: int
    least: int
    most: int = ALL
    words: tuple[str, ...] = ()


def find_owed(owed: Sequence[Owed], left_out: Sequence[LeftOut]) -> list[Finding]:
    """A finding for each demand with fewer pieces than asked for, less those left out with a
    reason, or with more.

    >>> desks = Owed("hall", "desks", there=3, least=5, most=5, words=("desks",))
    >>> find_owed([desks], [LeftOut("hall", "2 of 5 desks", "too narrow", True)])
    []
    >>> find_owed([desks], [LeftOut("hall", "1 of 5 desks", "too narrow", True)])[0].message
    '3 of 5 desks stand in hall, 1 said to be left out'
    """
    found = []
    for row in owed:
        if row.there > row.most:
            text = f"{row.there} {row.name} stand in {row.space}, {row.most} were asked for"
            found.append(Finding("surplus", "", row.space, "", "", text, row.there - row.most))
        told = sum(_count(out.what, row.least) for out in left_out if _tells(out, row))
        if row.there + told < row.least:
            text = f"{row.there} of {row.least} {row.name} stand in {row.space}"
            text += ", and nothing says why" if not told else f", {told} said to be left out"
            missing = row.least - row.there - told
            found.append(Finding("missing", "", row.space, "", "", text, missing))
    return found


def _tells(out: LeftOut, row: Owed) -> bool:
    """Whether something is said of a demand, with a reason."""
    named = not row.words or any(word and word in out.what for word in row.words)
    return out.space == row.space and bool(out.reason.strip()) and named


def _count(what: str, asked: int) -> int:
    """How many of those ``asked`` are left out as ``what``: 3 of "3 of 24 desks"; all where it
    states no number, or counts something else."""
    share = _SHARE.match(what)
    return int(share[1]) if share and int(share[2]) == asked else asked
