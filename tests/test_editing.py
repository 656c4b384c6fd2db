"""Furniture put in, taken away, doubled and exchanged by hand."""

from __future__ import annotations

import pytest

import scenewright as sw
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.domains import adjust
from scenewright.formats import solution_json


@pytest.fixture(scope="module")
def room() -> Solution:
    return sw.solve(sw.read("sample:home-room"), steps=300)


def ids(solution: Solution) -> set[str]:
    return {piece.id for piece in solution.pieces}


def test_what_is_taken_away_goes_with_all_on_it_and_stays_away(room: Solution) -> None:
    under = next(p for p in room.pieces if any(q.on == p.id for q in room.pieces))
    lying = {p.id for p in room.pieces if p.on == under.id}
    edited = sw.edit_pieces(room, remove=[under.id])
    assert ids(room) - ids(edited.solution) == {under.id, *lying}
    assert {c.change for c in edited.changes} == {"gone"}
    assert sw.check(edited.solution).valid
    saved = solution_json.loads(solution_json.dumps(edited.solution))
    assert saved == edited.solution
    bed = next(p for p in room.pieces if p.category == "single_bed")
    moved = adjust(saved, move={bed.id: (bed.pose.x, bed.pose.y)}).solution
    assert under.id not in ids(moved)


def test_what_is_put_in_stands_free_and_is_kept_when_arranged_again(room: Solution) -> None:
    edited = sw.edit_pieces(room, remove=["dining_table"], add=[sw.Addition("armchair", 2.3, 1.9)])
    chair = next(p for p in edited.solution.pieces if p.category == "armchair")
    assert chair.fixed
    assert not [
        f for f in sw.check(edited.solution).of("collision") if chair.id in f.piece + f.other
    ]
    again = adjust(edited.solution, again=["room"], seed=2).solution
    kept = [p for p in again.pieces if p.category == "armchair"]
    assert [p.pose for p in kept] == [chair.pose]


def test_a_double_has_what_lies_on_the_first(room: Solution) -> None:
    stand = next(p for p in room.pieces if any(q.on == p.id for q in room.pieces))
    edited = sw.edit_pieces(room, duplicate=[stand.id]).solution
    new = ids(edited) - ids(room)
    assert len(new) == 1 + sum(p.on == stand.id for p in room.pieces)
    assert len(ids(edited)) == len(edited.pieces)


def test_another_model_takes_the_place(room: Solution) -> None:
    other = sw.edit_pieces(room, exchange={"wardrobe": "wardrobe_nordic"}).solution
    one, now = (next(p for p in s.pieces if p.category == "wardrobe") for s in (room, other))
    assert (now.asset, now.pose, now.fixed) == ("wardrobe_nordic", one.pose, True)
    assert now.size == pytest.approx(one.size, abs=0.35)


@pytest.mark.parametrize(
    "edits",
    [
        {"remove": ["unicorn"]},
        {"add": [sw.Addition("armchair", 40.0, 1.0)]},
        {"add": [sw.Addition("unicorn", 2.0, 1.0)]},
        {"exchange": {"wardrobe": "unicorn"}},
        {"add": [sw.Addition("armchair", 2.0, 2.0)] * 12},
    ],
)
def test_what_cannot_be_done_is_one_line(room: Solution, edits: dict[str, object]) -> None:
    with pytest.raises(InputError) as told:
        sw.edit_pieces(room, **edits)
    assert "\n" not in str(told.value)


def test_only_homes_are_edited_so() -> None:
    with pytest.raises(InputError, match="only homes"):
        sw.edit_pieces(sw.solve(sw.read("sample:site-square"), steps=100), remove=["x"])


def test_what_stands_on_a_piece_stands_on_the_one_in_its_place(room: Solution) -> None:
    on_top = [p for p in room.pieces if p.on]
    under = next(p for p in room.pieces if p.id == on_top[0].on)
    edited = sw.edit_pieces(room, exchange={under.id: "wardrobe"}).solution
    other = next(p for p in edited.pieces if p.id == under.id)
    assert other.size.height > under.size.height + 0.1
    lying = next(p for p in edited.pieces if p.id == on_top[0].id)
    assert lying.pose.z == pytest.approx(other.size.height)
