"""Rows of halls keep what they say: data of each row make the cases it is tried in."""

from __future__ import annotations

from collections import Counter
from math import inf, radians

import numpy as np
import pytest

from every import every
from scenewright.arranging.degrees import THINGS, RoomParts
from scenewright.arranging.row_arrays import compile_rows
from scenewright.arranging.rows import COLUMNS, DOORS, ENTRANCES, EXITS, WAY_IN, Place, Row, say
from scenewright.arranging.verdict import Verdict, better
from scenewright.arranging.weighing import weigh
from scenewright.domains.hall.retouch.row_groups import GROUPS
from scenewright.domains.hall.rules import ROWS

FLOOR = np.array([[0.0, 0, 5, 0], [5, 0, 5, 4], [5, 4, 0, 4], [0, 4, 0, 0]])
PARTS = np.array(
    [
        [2.5, 0.0, 0.0, 0.0, 0.0, ENTRANCES],
        [2.5, 0.0, 0.0, 0.0, 0.0, EXITS],
        [2.5, 0.0, 0.0, 0.0, 0.0, DOORS],
        [4.0, 2.0, 0.0, 0.5, 0.5, COLUMNS],
        [2.5, 1.0, radians(90.0), 1.0, 2.0, WAY_IN],
    ]
)
ROOM = RoomParts(FLOOR, np.zeros((0, 4)), FLOOR, PARTS, 20.0)
"""The room of the examples, with a column and its door as a way in and out."""


def judge(row: Row, places: tuple[Place, ...]) -> Verdict:
    """The verdict of one row on some groups of one object each."""
    table = compile_rows((row,), {})
    things = np.zeros((2 * len(places), THINGS))
    for k, place in enumerate(places):
        box = (place.x, place.y, radians(place.turn), place.width, place.depth)
        kind = table.kinds.get(place.kind, 0)
        for floor in (0, 1):
            things[2 * k + floor] = (*box, 0.0, kind, len(table.kinds) + 1, k, floor)
    return Verdict(cost={row.id: sum(broken.cost for broken in weigh(table, things, ROOM))})


@every(ROWS, lambda row: row.id)
def test_a_row_is_broken_held_and_mended_as_its_example_says(row: Row) -> None:
    assert row.example is not None
    broken, held, mended = (judge(row, places) for places in row.example)
    assert broken.total > 0.0 == held.total == mended.total
    assert better(mended, broken)
    assert not better(broken, mended)
    kinds = (Counter(p.kind for p in places) for places in (row.example.broken, row.example.mended))
    assert len({tuple(sorted(each.items())) for each in kinds}) == 1


def test_rows_have_names_of_their_own_sources_and_sentences() -> None:
    assert [name for name, n in Counter(row.id for row in ROWS).items() if n > 1] == []
    for row in ROWS:
        said = say(row, "one", "two")
        assert said, row.id
        assert not {"{", "}"} & set(said), row.id
        assert row.source, row.id
        assert row.cost, row.id
        assert row.metres < inf, row.id


@pytest.mark.parametrize("side", ["of", "to"])
def test_rows_are_about_groups_that_are_known(side: str) -> None:
    for row in ROWS:
        each = row.of if side == "of" else row.to
        assert {*each.kinds, *(each.but or ())} <= set(GROUPS), row.id
