"""Furniture put in, taken away, doubled and exchanged by hand."""

from __future__ import annotations

from pathlib import Path

import pytest

import scenewright as sw
from scenewright.cli import run
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece
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
        {"add": [sw.Addition("double_bed", 2.0, 2.0)] * 6},
    ],
)
def test_what_cannot_be_done_is_one_line(room: Solution, edits: dict[str, object]) -> None:
    with pytest.raises(InputError) as told:
        sw.edit_pieces(room, **edits)
    assert "\n" not in str(told.value)


OTHERS = {
    "hall-shop": ("gondola", 1500),
    "site-square": ("villa", 2),
    "village-hamlet": ("cottage", 1),
    "extend-village": ("C", 1),
}


@pytest.fixture(scope="module", params=OTHERS)
def scene(request: pytest.FixtureRequest) -> Solution:
    preset = "quick" if request.param.startswith("extend") else "default"
    brief = sw.read(f"sample:{request.param}")
    return sw.solve(brief, steps=OTHERS[request.param][1], preset=preset)


def moved_ids(before: Solution, after: Solution) -> set[str]:
    """What there was before and stands elsewhere now, but for trees and lamps."""
    now = {p.id: p for p in after.pieces}
    kept = [p for p in before.pieces if not p.group.endswith("/green")]
    return {p.id for p in kept if p.id in now and now[p.id].pose != p.pose}


def movable(solution: Solution) -> list[Piece]:
    """Buildings, or objects of a hall."""
    built = [p for p in solution.pieces if p.category == "building"]
    pieces = built or [p for p in solution.pieces if p.function == "shelving"]
    return [p for p in pieces if not p.fixed and p.function != "landmark"]


def test_other_scenes_take_pieces_by_hand_and_little_else_changes(scene: Solution) -> None:
    first, *others = movable(scene)
    twin = next(p for p in others if p.function == first.function)
    bare = sw.edit_pieces(scene, remove=[twin.id]).solution
    assert len(moved_ids(scene, bare)) <= 5
    wide = (first.size.width * 0.98, *first.size[1:])
    other = others[-1].function if first.category == "building" else others[-1].asset
    for edits, more in (
        ({"duplicate": [first.id]}, 1),
        ({"resize": {first.id: wide}}, 0),
        ({"exchange": {first.id: other}}, 0),
        ({"add": [sw.Addition(first.asset, *twin.pose[:2], twin.pose.heading, twin.space)]}, 1),
    ):
        after = sw.edit_pieces(bare, **edits).solution
        assert len(moved_ids(bare, after) - {first.id}) <= 5, edits
        assert after.brief == scene.brief
        there = [sum(p.category == first.category for p in s.pieces) for s in (bare, after)]
        assert there[1] == there[0] + more, edits
        text = solution_json.dumps(after)
        assert solution_json.dumps(solution_json.loads(text)) == text
        found = [f for f in sw.check(after).findings if f.is_blamed]
        more_than_asked = [f.amount for f in found if f.kind == "surplus"]
        assert sum(more_than_asked) <= 1, "what was put is told, for a person to accept"
        never = {"missing", "malformed", "collision", "changed_given"}
        assert not {f.kind for f in found} & never, edits


def test_what_is_given_another_size_stays_and_what_it_runs_into_gives_way(room: Solution) -> None:
    desk = next(p for p in room.pieces if p.category == "desk")
    after = sw.edit_pieces(room, resize={desk.id: (desk.size.width + 0.1, *desk.size[1:])})
    now = next(p for p in after.solution.pieces if p.id == desk.id)
    assert now.size.width == pytest.approx(desk.size.width + 0.1)
    with pytest.raises(InputError, match="does not come in that size; the nearest is"):
        sw.edit_pieces(room, resize={desk.id: (9.0, 9.0, 9.0)})


def test_a_room_is_restyled_by_models_of_a_style(room: Solution) -> None:
    after = sw.edit_pieces(room, restyle={"room": "retro"}).solution
    assert [p.pose for p in after.pieces] == [p.pose for p in room.pieces]
    changed = {b.asset for a, b in zip(room.pieces, after.pieces, strict=True) if a != b}
    assert changed
    assert all(asset.endswith("_retro") for asset in changed)
    with pytest.raises(InputError, match="is made in 'gothic'"):
        sw.edit_pieces(room, restyle={"room": "gothic"})


def test_what_stands_on_a_piece_stands_on_the_one_in_its_place(room: Solution) -> None:
    on_top = [p for p in room.pieces if p.on]
    under = next(p for p in room.pieces if p.id == on_top[0].on)
    edited = sw.edit_pieces(room, exchange={under.id: "wardrobe"}).solution
    other = next(p for p in edited.pieces if p.id == under.id)
    assert other.size.height > under.size.height + 0.1
    lying = next(p for p in edited.pieces if p.id == on_top[0].id)
    assert lying.pose.z == pytest.approx(other.size.height)


def test_pieces_are_edited_from_the_command_line(room: Solution, tmp_path: Path) -> None:
    saved, out = tmp_path / "room.json", tmp_path / "edited.json"
    sw.write(room, saved)
    desk = next(p for p in room.pieces if p.category == "desk")
    verbs = ["--restyle", "room=vintage", "--remove", desk.id, "--add", "armchair=2.5,2.5"]
    assert run(["adjust", str(saved), "-o", str(out), "-q", *verbs]) in (0, 1)
    after = solution_json.read(out)
    assert desk.id not in {p.id for p in after.pieces}
    assert any(p.category == "armchair" and p.fixed for p in after.pieces)
    assert any(p.asset.endswith("_retro") for p in after.pieces)
    for wrong in ("--resize=desk=1", "--exchange=desk", "--add=armchair"):
        assert run(["adjust", str(saved), "-o", str(out), wrong]) == 2


def test_what_a_person_means_is_accepted_with_the_reason(room: Solution, tmp_path: Path) -> None:
    saved, out = tmp_path / "room.json", tmp_path / "meant.json"
    tree = next(p for p in room.pieces if p.category == "potted_tree")
    x, y = room.brief.rooms[0].doors[0].at
    sw.write(adjust(room, move={tree.id: (x, y + 0.5)}).solution, saved)
    kinds = {f.kind for f in sw.check(solution_json.read(saved)).findings}
    assert kinds, "the tree stands before the door"
    verbs = [f"--accept={kind}=a show" for kind in sorted(kinds)]
    assert run(["adjust", str(saved), "-o", str(out), "-q", *verbs]) == 0
    report = sw.check(solution_json.read(out))
    assert report.valid
    assert {f.accepted for f in report.findings} == {"a show"}
    for wrong in ("--accept=collision", "--accept=nonsense=why", "--accept=blocked_stairs=why"):
        assert run(["adjust", str(saved), "-o", str(out), wrong]) == 2
