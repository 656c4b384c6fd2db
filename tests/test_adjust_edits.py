"""Whatever is changed by hand, what is saved can be read, judged and solved again."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from benchmarks.adjust_edits import HOMES, QUICK, SEQUENCES, faults_of, furnished, sequence

from scenewright import cli
from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains import adjust, check
from scenewright.domains.home.attempts.attempt import FurnishedGroup, Missing, RoomAnswer, RoomTask
from scenewright.domains.home.cases.own_library import libraries_of, taste_of
from scenewright.domains.home.changes.belonging import consistent
from scenewright.domains.home.changes.least_change import Rest
from scenewright.domains.home.changes.needless import take_back
from scenewright.domains.home.changes.regroup import regroup_pieces
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.tasks import task_of, wishes_of
from scenewright.engine.rows import preset_named
from scenewright.formats import solution_json
from thoroughness import few_or_many

flat = partial(furnished, "sample:home-flat")


def piece(solution: Solution, name: str) -> Piece:
    return next(p for p in solution.pieces if p.id == name)


def left_out(solution: Solution, space: str) -> dict[str, bool]:
    return {out.what: out.required for out in solution.left_out if out.space == space}


@pytest.mark.parametrize("seed", range(few_or_many(1, QUICK)))
def test_random_sequences_of_edits(seed: int) -> None:
    outcome = sequence(seed)
    assert outcome.faults == ()
    assert outcome.bare == 0


@pytest.mark.slow
@pytest.mark.skipif("not config.getoption('-m')", reason="200 sequences: pytest -m slow")
def test_many_random_sequences_of_edits() -> None:
    assert [seed for seed in range(QUICK, SEQUENCES) if sequence(seed).faults] == []


def test_chairs_swapped_between_rooms_have_ids_of_their_own() -> None:
    pair = ("living/dining/dining_chair", "study/desk/office_chair")
    after, changes = adjust(flat(), swap=[pair])
    assert faults_of(after) == []
    assert piece(after, "study/dining_chair").space == "study"
    assert piece(after, "living/office_chair").space == "living"
    assert piece(after, "living/office_chair").function == "fixed"
    by_hand = {c.piece: c.was for c in changes if c.reason == "moved by hand"}
    assert by_hand == {"study/dining_chair": pair[0], "living/office_chair": pair[1]}
    assert all(change.reason for change in changes)


def test_lamps_and_curtains_belong_to_their_room() -> None:
    with pytest.raises(InputError, match="'hall/ceiling_lamp' belongs to 'hall' and cannot"):
        adjust(flat(), move={"hall/ceiling_lamp": (2.0, 2.0)})
    lamp = piece(flat(), "hall/ceiling_lamp")
    after = adjust(flat(), move={lamp.id: (lamp.pose.x + 0.1, lamp.pose.y)}).solution
    assert faults_of(after) == []
    assert sum(p.category == "ceiling_lamp" and p.space == "hall" for p in after.pieces) == 1


def test_a_group_moved_into_another_room_belongs_there() -> None:
    after, changes = adjust(flat(), move={"bedroom/bed": (2.0, 2.5)})
    assert faults_of(after) == []
    bed = piece(after, "living/sleeping/double_bed")
    assert (bed.space, bed.group, bed.function) == ("living", "living/sleeping", "sleeping")
    company = [p for p in after.pieces if p.group == "living/sleeping"]
    assert {p.space for p in company} == {"living"}
    assert all(p.on is None or p.on.startswith("living/sleeping/") for p in company)
    assert not any(p.function == "sleeping" and p.space == "bedroom" for p in after.pieces)
    assert left_out(after, "bedroom")["sleeping"]
    back = adjust(
        after, move={"living/sleeping": piece(flat(), "bedroom/sleeping/double_bed").pose[:2]}
    )
    assert piece(back.solution, "bedroom/sleeping/double_bed").space == "bedroom"
    assert "sleeping" not in left_out(back.solution, "bedroom")
    assert all(change.reason for change in (*changes, *back.changes))


def test_what_is_moved_off_what_it_stood_on_is_put_down() -> None:
    """On the floor, or on what is below it now."""
    lamp = "bedroom/sleeping/table_lamp"
    there = piece(flat(), "bedroom/chest/chest_of_drawers")
    before = replace(flat(), pieces=tuple(p for p in flat().pieces if p.on != there.id))
    after = adjust(before, move={lamp: there.pose[:2]}).solution
    put = piece(after, lamp)
    assert (put.on, put.pose.z) == (there.id, pytest.approx(there.size.height))
    assert not [f.message for f in check(after).findings if lamp in f.message]
    floor = piece(adjust(before, move={lamp: (11.0, 0.9)}).solution, lamp)
    assert (floor.on, floor.pose.z) == (None, 0.0)


@pytest.mark.parametrize("home", HOMES[1:])
def test_nothing_that_could_stay_is_changed(home: str) -> None:
    """Each group that moved out of the way would collide where it was, or bars a way there."""
    before = furnished(home)
    main = next(p for p in before.pieces if p.function == "shelf")
    other = next(
        p
        for p in before.pieces
        if p.space == main.space
        and p.function != "light"
        and p.group != main.group
        and p.on is None
        and p.pose.z == 0
    )
    outline = next(r for r in spaces(before.brief) if r.id == main.space).outline
    off = float(np.hypot(*main.size[:2])) / 2
    middle = np.array([main.pose.x + other.pose.x, main.pose.y + other.pose.y]) / 2
    x, y = np.clip(middle, outline.min(0) + off, outline.max(0) - off).tolist()
    after, changes = adjust(before, move={main.id: (x, y)})
    own = {p.id for p in after.pieces if p.group == main.group}
    moved = {c.piece for c in changes if c.change == "moved"} - own
    for change in changes:
        assert change.reason
    for name in {piece(after, i).group for i in moved if piece(after, i).function != "light"}:
        assert any(name == p.group for p in before.pieces)
        assert all(
            "where it stood" in c.reason
            for c in changes
            if c.piece in moved and piece(after, c.piece).group == name
        )
    again = adjust(after, lock=[main.id])
    assert again.changes == ()


def test_lamps_stay_as_they_hung_where_nothing_changed_below() -> None:
    lamp = next(p for p in flat().pieces if p.id == "study/ceiling_lamp")
    hung = replace(lamp, pose=lamp.pose._replace(x=lamp.pose.x + 0.2))
    before = replace(flat(), pieces=tuple(hung if p is lamp else p for p in flat().pieces))
    plant = next(p for p in flat().pieces if p.function == "plant" and p.space == "study")
    after, changes = adjust(before, move={plant.id: tuple(plant.pose[:2])})
    assert piece(after, lamp.id) == hung
    assert changes == ()


def test_ids_are_made_unique_and_nothing_stands_on_what_is_gone() -> None:
    def made(name: str, on: str | None = None, fixed: bool = False) -> Piece:
        return Piece(name, "vase", "", "r", Pose(0, 0, 0, 0), Size(1, 1, 1), "r/g", "g", on, fixed)

    twice = consistent(
        [
            made("r/a"),
            made("r/a", fixed=True),
            made("r/b", "r/gone"),
            made("r/c", "r/b"),
            made("r/d", "r/gone", True),
        ]
    )
    assert [(p.id, p.on) for p in twice] == [("r/a_2", None), ("r/a", None), ("r/d", None)]


def test_a_change_that_nobody_needs_is_taken_back() -> None:
    """A group that was shifted for nothing is put back; one that must stay away has its reason."""
    task, groups = room_of(flat(), "bedroom")
    chest = next(g for g in groups if g.wish.group == "chest")
    shifted = _shifted(chest, 0.05)
    rest = Rest(tuple(g for g in groups if g is not chest), _answer((shifted,)))
    kept, reasons = take_back(task, (), groups, rest)
    assert {p for g in kept.stay for p in g.pieces} == {p for g in groups for p in g.pieces}
    assert (kept.answer.placed, reasons) == ((), {})
    gone = Rest(rest.stay, _answer((), Missing(chest.wish, "no room")))
    assert take_back(task, (), groups, gone)[0].answer.missing == ()
    bed = next(g for g in groups if g.wish.group == "sleeping")
    firm = task._replace(fixed=(*task.fixed, replace(bed.pieces[0], id="other", fixed=True)))
    held, why = take_back(firm, (), [bed], Rest((), _answer((_shifted(bed, 0.3),))))
    assert held.stay == ()
    assert "would run into" in why["bedroom/sleeping"]


def room_of(home: Solution, name: str) -> tuple[RoomTask, tuple[FurnishedGroup, ...]]:
    """A room as a task, and the groups in it as they stand."""
    rooms = spaces(home.brief)
    number = next(i for i, room in enumerate(rooms) if room.id == name)
    catalog = catalog_of(())
    library = libraries_of(home.brief, catalog)[taste_of(home.brief, home.brief.rooms[number])]
    task = task_of(
        home.brief,
        home.brief.rooms[number],
        rooms[number],
        (),
        catalog,
        library,
        preset_named(PRESETS, home.preset),
        home.solver,
        0,
    )
    here = [p for p in home.pieces if p.space == name]
    boxes = {patch.id: np.array(patch.box) for patch in home.patches}
    return task, regroup_pieces(here, boxes, wishes_of(task.asked, task, rooms, ()))


def _shifted(group: FurnishedGroup, metres: float) -> FurnishedGroup:
    box = group.dressed.box + np.array([metres, 0, 0, 0, 0])
    pieces = tuple(replace(p, pose=p.pose._replace(x=p.pose.x + metres)) for p in group.pieces)
    return group._replace(dressed=group.dressed._replace(box=box), pieces=pieces)


def _answer(placed: tuple[FurnishedGroup, ...], *missing: Missing) -> RoomAnswer:
    return RoomAnswer(0.0, placed, missing, (), None, 0.0, 0)


def test_reasons_are_told_on_the_command_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    saved = tmp_path / "home.json"
    solution_json.write(flat(), saved)
    line = ["adjust", str(saved), "-o", str(saved), "--move", "bedroom/bed=2,2.5"]
    assert cli.run([*line, "--json"]) == 1
    document = json.loads(capsys.readouterr().out)
    bed = next(c for c in document["changes"] if c["piece"] == "living/sleeping/double_bed")
    assert bed["was"] == "bedroom/sleeping/double_bed"
    assert bed["reason"] == "moved by hand"
    assert all(change["reason"] for change in document["changes"])
    assert solution_json.read(saved) != flat()
    assert cli.run([*line[:-1], "bedroom/wardrobe=2,2.5"]) in (0, 1)
    assert "(moved by hand)" in capsys.readouterr().out.replace("\n", " ")


def test_what_a_piece_takes_along_stays_in_the_room_or_the_move_is_refused() -> None:
    """The main cabinet of a worktop, whose row would stick out of a small bathroom."""
    house = furnished("sample:home-house")
    at = (7.516215006098576, 4.354479093765376, 0.0)
    with pytest.raises(InputError, match=r"takes the base_cabinet along, which would stick"):
        adjust(house, move={"kitchen/counter/drawer_cabinet": at})
