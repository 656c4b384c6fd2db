"""Rows of homes keep what they say: data of each row make the cases it is tried in."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from math import inf, radians

import pytest
from benchmarks.composition_rows import count_rows

from every import every
from scenewright.arranging.rows import (
    BACK,
    FRONT,
    LEFT,
    RIGHT,
    ROUND,
    Class,
    Place,
    Row,
    is_lone,
    say,
)
from scenewright.arranging.verdict import Verdict, better
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.weigh_home import ROWS, compile_table, list_faults

ROOM = {
    "id": "room",
    "function": "living",
    "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
    "doors": [{"at": [2.5, 0.0], "width": 0.9, "swing": "in"}],
    "windows": [{"at": [2.5, 4.0], "width": 1.6, "sill": 0.9}],
}
WITH_EXAMPLE = [row for row in ROWS if row.example]
BETWEEN = [
    row
    for row in ROWS
    if row.relation.name in ("clear", "apart") and not is_lone(row) and not row.joined
]
"""Rows of two pieces and the floor between them: their cases follow from their numbers."""
AWAY = {FRONT: (0.0, 1.0), BACK: (180.0, 1.0), LEFT: (90.0, 0.0), RIGHT: (-90.0, 0.0)}


def ground():
    (space,) = spaces(Brief.model_validate({"rooms": [ROOM]}))
    return ground_of(space, (), 20.0)


def stand(number: int, place: Place, function: str = "any") -> FurnishedGroup:
    """A group of one piece."""
    pose = Pose(place.x, place.y, place.above, radians(place.turn))
    size = Size(place.width, place.depth, 1.0)
    piece = Piece(f"p{number}", place.kind, "", "room", pose, size)
    return FurnishedGroup(Wish(function, 0), f"g{number}", None, (piece,))


def judge(row: Row, places) -> Verdict:
    """The verdict of one row on some pieces in the room of the examples."""
    groups = [stand(number, place) for number, place in enumerate(places)]
    faults = list_faults(compile_table((row,)), groups, (), ground())
    return Verdict(cost={fault.row.id: fault.cost for fault in faults})


@every(WITH_EXAMPLE, lambda row: row.id)
def test_a_row_is_broken_held_and_mended_as_its_example_says(row: Row) -> None:
    broken, held, mended = (judge(row, places) for places in row.example)
    assert broken.total > 0.0 == held.total == mended.total
    assert better(mended, broken)
    assert not better(broken, mended)
    assert Counter(p.kind for p in row.example.broken) == Counter(
        p.kind for p in row.example.mended
    )


def name_kind(each: Class) -> str:
    return min(each.kinds) if each.kinds else "crate"


def put(row: Row, gap: float) -> list[Place]:
    """A piece far from all walls and one of the others so far beyond the side of the row."""
    side = FRONT if row.relation.side == ROUND else row.relation.side
    turn, way = AWAY[side][0], 1.0
    start = min(1.0, row.relation.start) - 0.5
    x = 50.0 + way * (start if side == FRONT else 0.5) + gap + 0.5
    first = Place(name_kind(row.of), 50.0, 50.0, turn, 1.0, 1.0)
    return [first, Place(name_kind(row.to), x, 50.0, 0.0, 1.0, 1.0)]


@every(BETWEEN, lambda row: row.id)
def test_floor_between_two_pieces_is_kept_as_wide_as_the_row_says(row: Row) -> None:
    found = {}
    for gap in (0.0, row.metres / 2, row.metres + 0.01):
        groups = [stand(number, place) for number, place in enumerate(put(row, gap))]
        faults = list_faults(compile_table((row,)), groups)
        found[gap] = sum(f.cost for f in faults if (f.group, f.other) != ("g1", "g0"))
    hard, half, free = found.values()
    assert hard >= half > 0.0 == free


def test_rows_have_names_of_their_own_sources_and_sentences() -> None:
    assert [name for name, n in Counter(row.id for row in ROWS).items() if n > 1] == []
    for row in ROWS:
        said = say(row, "one", "two")
        assert said, row.id
        assert not {"{", "}"} & set(said), row.id
        assert row.source, row.id
        assert row.cost, row.id
        assert row.metres < inf, row.id


def test_what_stands_already_breaks_no_row_but_one_it_is_held_to() -> None:
    (row,) = (row for row in ROWS if row.id == "doors")
    wardrobe, chest = (stand(0, p).pieces for p in put(row, 0.1))
    for each, faults in ((row, 1), (row._replace(fixed=False), 0)):
        found = list_faults(compile_table((each,)), [stand(1, put(row, 0.1)[1])], wardrobe)
        assert len(found) == faults
    assert not list_faults(compile_table((row,)), [stand(0, put(row, 0.1)[0])])
    assert list_faults(compile_table((row,)), [stand(0, put(row, 0.1)[0])], chest)


@pytest.mark.parametrize(("area", "share"), [(12.0, 1.0), (6.0, 0.4)])
def test_in_small_rooms_a_row_counts_less(area, share) -> None:
    (row,) = (row for row in ROWS if row.id == "shelf_at_hob")
    row = row._replace(area=9.0, tight=0.4)
    groups = [stand(number, place) for number, place in enumerate(row.example.broken)]
    (small,) = list_faults(compile_table((row,)), groups, (), ground()._replace(area=area))
    (large,) = list_faults(compile_table((row,)), groups, (), ground()._replace(area=20.0))
    assert small.cost == pytest.approx(share * large.cost)


def test_the_benchmark_counts_rooms_that_break_a_row() -> None:
    (space,) = spaces(Brief.model_validate({"rooms": [ROOM]}))
    (row,) = (row for row in ROWS if row.id == "shelf_at_hob")
    for places, faulty in ((row.example.broken, 1), (row.example.held, 0)):
        pieces = [replace(stand(n, p).pieces[0], group=f"g{n}") for n, p in enumerate(places)]
        pieces = [replace(piece, space="room") for piece in pieces]
        assert count_rows([space], pieces)["row shelf_at_hob"] == (faulty, 1)
