"""Tables of rows compiled to arrays: numbers, and which kinds and groups each row is about."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.arranging.rows import Class, Row, is_lone

Floats = NDArray[np.float64]
Marks = NDArray[np.int8]

RELATION, SIDE, METRES, COST, PER, GRADE, UNSEEN, EACH, WITHIN, WIDE, INSET, START = range(12)
TURNED, FULL, PARTS, AREA, TIGHT, FIXED, JOINED, OF_BELOW, OF_FLOOR = range(12, 21)
TO_BELOW, TO_FLOOR, TO_PIECES, COLUMNS = range(21, 25)
"""The columns of a row."""
ZONE, ANGLE, WALL, FAR, SIDE_BY_SIDE, AWAY = range(6)
"""Relations as the kernel knows them."""
CODES = {"square_to": ANGLE, "against": WALL, "near": FAR, "beside": SIDE_BY_SIDE, "faces": AWAY}
NOT, IS, HUNG = -1, 1, 2
"""What a kind or a group is to a row: left out, meant, or meant at any height."""


class Arrays(NamedTuple):
    """Rows as arrays: ``numbers`` (r, columns), and ``marks`` (r, names, 2) of what each row is of
    and to."""

    numbers: Floats
    marks: Marks


class Table(NamedTuple):
    """Rows with their arrays, and the numbers of the ``kinds`` and ``groups`` they name; that of
    any other kind is 0, of any other group the next after those of kinds."""

    rows: tuple[Row, ...]
    arrays: Arrays
    kinds: Mapping[str, int]
    groups: Mapping[str, int]


def compile_rows(rows: Sequence[Row], costs: Mapping[str, float]) -> Table:
    """A table of rows whose costs are numbers or names of ``costs``; one that is not there is 1."""
    classes = [each for row in rows for each in (row.of, row.to)]
    kinds = _number(k for c in classes for k in (*c.kinds, *(c.but or ()), *c.hung))
    groups = _number((g for c in classes for g in (*c.groups, *c.outside)), len(kinds) + 1)
    numbers = np.zeros((len(rows), COLUMNS))
    marks = np.zeros((len(rows), len(kinds) + len(groups) + 2, 2), np.int8)
    for k, row in enumerate(rows):
        numbers[k] = _read_numbers(row, costs)
        for side, each in enumerate((row.of, row.to)):
            marks[k, :, side] = _mark(each, kinds, groups, marks.shape[1])
    return Table(tuple(rows), Arrays(numbers, marks), kinds, groups)


def _number(names: Iterable[str], first: int = 0) -> dict[str, int]:
    return {name: first + k + 1 for k, name in enumerate(sorted(set(names)))}


def _read_numbers(row: Row, costs: Mapping[str, float]) -> list[float]:
    """The columns of a row."""
    of, to, r = row.of, row.to, row.relation
    cost = costs.get(row.cost, 1.0) if isinstance(row.cost, str) else row.cost
    code, pieces = CODES.get(r.name, ZONE), not is_lone(row)
    return [
        *(code, r.side, row.metres, cost * row.times, r.per, r.grade, r.unseen),
        *(r.each, r.within, r.wide, r.inset, r.start, r.turned, r.full, to.parts, row.area),
        *(row.tight, row.fixed, row.joined, of.below, of.floor, to.below, to.floor, pieces),
    ]


def _mark(
    each: Class, kinds: Mapping[str, int], groups: Mapping[str, int], names: int
) -> NDArray[np.int8]:
    """What each kind and group is to a row (names,)."""
    marks = np.zeros(names, np.int8)
    if each.but is not None:
        marks[: len(kinds) + 1] = IS
    for names_of, number, mark in (
        (each.kinds, kinds, IS),
        (each.but or (), kinds, 0),
        (each.hung, kinds, HUNG),
        (each.groups, groups, IS),
        (each.outside, groups, NOT),
    ):
        marks[[number[name] for name in names_of]] = mark
    return marks
