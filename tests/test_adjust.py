"""Homes changed by hand: what was moved stays there, what it does not touch stays as it is."""

from __future__ import annotations

import json
from dataclasses import replace
from math import cos, degrees, pi, sin
from pathlib import Path

import numpy as np
import pytest

from scenewright import cli
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import STAIRS, Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains import check, resolve
from scenewright.domains.home import solving as home
from scenewright.formats import read, solution_json


@pytest.fixture(scope="module")
def house() -> Solution:
    return home.solve(read("sample:home-house"), seed=0, steps=6000)


def piece(solution: Solution, end: str) -> Piece:
    return next(p for p in solution.pieces if p.id.endswith(end))


def ahead(moved: Piece) -> tuple[float, float]:
    """A little before where a piece stands, off its wall."""
    return moved.pose.x + 0.05 * cos(moved.pose.heading), moved.pose.y + 0.05 * sin(
        moved.pose.heading
    )


def furniture(solution: Solution, *, outside: str = "") -> dict[str, tuple[float, ...]]:
    return {p.id: p.pose for p in solution.pieces if p.function != "light" and p.space != outside}


def test_other_rooms_stay_and_the_moved_piece_stands_where_it_was_put(house: Solution) -> None:
    bed = piece(house, "bedroom/sleeping/double_bed")
    x, y = ahead(bed)
    after = resolve(house, move={bed.id: (x, y, bed.pose.heading)})
    moved = piece(after, bed.id)
    assert moved.pose[:2] == pytest.approx((x, y), abs=1e-12)
    assert moved.fixed
    assert furniture(after, outside="bedroom") == furniture(house, outside="bedroom")
    lamp, was = (piece(s, "bedroom/sleeping/table_lamp") for s in (after, house))
    shift = (lamp.pose.x - was.pose.x, lamp.pose.y - was.pose.y)
    assert shift == pytest.approx((x - bed.pose.x, y - bed.pose.y))


def test_what_stands_in_the_way_makes_way(house: Solution) -> None:
    before = check(house)
    assert before.valid
    plant = piece(house, "bedroom/plant/potted_tree")
    chest = piece(house, "bedroom/chest/chest_of_drawers")
    to = (chest.pose.x, chest.pose.y)
    after = resolve(house, move={plant.id: to})
    assert piece(after, plant.id).pose[:2] == pytest.approx(to)
    told = [(f.kind, f.piece, f.given, f.locked) for f in check(after).findings]
    assert told == [("out_of_bounds", plant.id, False, True)]  # 2 cm into the wall, by hand
    assert piece(after, "bedroom/chest/chest_of_drawers").pose != chest.pose
    others = {i for i in furniture(house) if not i.startswith(("bedroom/chest", "bedroom/plant"))}
    now, was = furniture(after), furniture(house)
    assert {i: now[i] for i in others} == {i: was[i] for i in others}


def test_nothing_changes_without_edits_or_need(house: Solution) -> None:
    chest = piece(house, "bedroom/chest/chest_of_drawers")
    after = resolve(house, move={chest.id: tuple(chest.pose[:2])})
    assert list(furniture(after)) == list(furniture(house))
    assert np.allclose([*furniture(after).values()], [*furniture(house).values()])
    assert after.energies == pytest.approx(house.energies)
    locked = resolve(house, lock=[chest.id])
    assert piece(locked, chest.id).fixed
    free = [p if p.function == STAIRS else replace(p, fixed=False) for p in locked.pieces]
    assert free == list(house.pieces)


def test_swapped_groups_exchange_places(house: Solution) -> None:
    after = resolve(house, swap=[("child-2/kids_desk", "child-2/wardrobe")])
    desk, robe = ("child-2/kids_desk/kids_desk", "child-2/wardrobe/wardrobe")
    for one, other in ((desk, robe), (robe, desk)):
        now, was = piece(after, one), piece(house, other)
        assert np.cos(now.pose.heading - was.pose.heading) == pytest.approx(1.0)
        assert np.hypot(now.pose.x - was.pose.x, now.pose.y - was.pose.y) < 1.0
    assert check(after).valid, [f.message for f in check(after).findings]


def test_unlike_groups_are_swapped_so_that_both_fit() -> None:
    """A desk wider than the bunk whose corner it takes moves along, and the bunk makes room."""
    outline = [(0, 0), (4, 0), (4, 3.4), (0, 3.4)]
    room = {
        "id": "r",
        "function": "child_bedroom",
        "outline": outline,
        "doors": [{"at": (3.4, 3.4), "width": 0.8}],
    }
    empty = home.solve(Brief.model_validate({"rooms": [room | {"ask": []}]}), steps=100)
    bunk = Piece(
        "r/bunk/bunk_bed",
        "bunk_bed",
        "",
        "r",
        Pose(0.5, 1.03, 0, pi / 2),
        Size(1.0, 2.05, 1.65),
        "r/bunk",
        "bunk",
    )
    desk = Piece(
        "r/kids_desk/kids_desk",
        "kids_desk",
        "",
        "r",
        Pose(1.61, 0.28, 0, pi / 2),
        Size(1.2, 0.55, 0.74),
        "r/kids_desk",
        "kids_desk",
    )
    after = resolve(replace(empty, pieces=(bunk, desk)), swap=[("bunk", "kids_desk")])
    assert not [f.message for f in check(after).findings]
    assert piece(after, desk.id).pose.x == pytest.approx(0.6, abs=0.06)
    assert piece(after, bunk.id).pose.x > piece(after, desk.id).pose.x


def test_a_room_again_keeps_what_is_locked(house: Solution) -> None:
    after = resolve(house, lock=["bedroom/bed"], again=["Main bedroom"], seed=7)
    bed = "bedroom/sleeping/double_bed"
    assert piece(after, bed) == replace(piece(house, bed), fixed=True)
    assert sum(p.category == "double_bed" for p in after.pieces) == 1
    assert furniture(after, outside="bedroom") == furniture(house, outside="bedroom")
    assert furniture(after) != furniture(house)
    assert check(after).valid
    free = resolve(after, unlock=["bedroom/bed"], again=["bedroom"], seed=8)
    assert not any(p.fixed for p in free.pieces if p.space == "bedroom")
    assert free == replace(
        resolve(after, unlock=["bedroom/bed"], again=["bedroom"], seed=8), seconds=free.seconds
    )


@pytest.mark.parametrize("room", ["living", "landing", "bedroom", "bathroom"])
def test_a_room_again_from_the_same_seed_is_furnished_as_at_first(
    house: Solution, room: str
) -> None:
    """Composed like the whole home, and without the pieces of another of its rooms."""
    after = resolve(house, again=[room], steps=6000)
    assert furniture(after) == furniture(house)
    assert after.energies[room] == pytest.approx(house.energies[room])


def test_a_piece_may_change_rooms_but_not_leave_the_home(house: Solution) -> None:
    chair = piece(house, "study/reading/armchair")
    after = resolve(house, move={chair.id: (4.5, 2.0)})
    assert piece(after, "living/reading/armchair").space == "living"
    with pytest.raises(InputError, match=r"cannot stand at \(40, 2\).*'study' lies within"):
        resolve(house, move={chair.id: (40.0, 2.0)})
    bed = next(p for p in house.pieces if p.category == "double_bed")
    x0, y0 = next(r for r in spaces(house.brief) if r.id == bed.space).outline.min(0)
    with pytest.raises(InputError, match=r"would stick 0\.\d\d m out of its room"):
        resolve(house, move={bed.id: (x0 + 0.5, y0 + 0.5, 0.0)})
    hall = next(r for r in spaces(house.brief) if r.stair_parts)
    shelf = next(p for p in house.pieces if p.space == hall.id and p.function == "shoes")
    with pytest.raises(InputError, match="would stand in the stairs"):
        resolve(house, move={shelf.id: hall.stair_parts[0].box[:2]})


@pytest.mark.parametrize(
    ("edits", "told"),
    [
        ({"move": {"sofaa": (1.0, 1.0)}}, r"unknown piece 'sofaa'.*living/seating/\w*sofa"),
        ({"lock": ["study/sofaa"]}, "unknown piece 'study/sofaa'; use one of: study/"),
        ({"lock": ["bed"]}, "'bed' may be any of 3 pieces; say which: .*double_bed"),
        ({"again": ["kitchn"]}, "unknown space 'kitchn'; use one of: kitchen"),
        ({"swap": [("living/sofa", "living/coffee_table")]}, "are of one group"),
        ({"move": {"bedroom/bed": (1.0, 1.0, 90.0)}}, "90 is no heading; headings are radians"),
        ({"move": {"bedroom/bed": (1.0,)}}, r"give \(x, y\) or \(x, y, heading\)"),
        ({"unlock": ["stairs"]}, "is of the building; move the stairs in the brief"),
    ],
)
def test_what_cannot_be_meant_is_told(house: Solution, edits: dict, told: str) -> None:  # type: ignore[type-arg]
    with pytest.raises(InputError, match=told):
        resolve(house, **edits)


def test_a_fixed_item_is_moved_in_the_brief_too() -> None:
    outline = [(0, 0), (4, 0), (4, 4), (0, 4)]
    stove = {
        "id": "stove",
        "category": "fireplace",
        "at": (0.4, 3.0),
        "size": (1.0, 0.5, 1.0),
        "name": "the stove",
    }
    room = {
        "id": "r",
        "function": "living",
        "outline": outline,
        "fixed": [stove],
        "doors": [{"at": (3.2, 0), "width": 0.8}],
    }
    before = home.solve(Brief.model_validate({"rooms": [room]}), steps=1000)
    after = resolve(before, move={"stove": (0.4, 1.0)}, steps=1000)
    assert after.brief.rooms[0].fixed[0].at == (0.4, 1.0)
    assert after.brief.rooms[0].fixed[0].name == "the stove"
    again = home.solve(solution_json.brief_of(solution_json.to_document(after)), steps=1000)
    assert [p.pose[:2] for p in again.pieces if p.id == "stove"] == [(0.4, 1.0)]


def test_a_locked_group_is_not_placed_twice() -> None:
    outline = [(0, 0), (5, 0), (5, 4), (0, 4)]
    room = {
        "id": "r",
        "function": "study",
        "outline": outline,
        "ask": [{"group": "shelf"}],
        "doors": [{"at": (4.2, 0), "width": 0.8}],
    }
    before = home.solve(Brief.model_validate({"rooms": [room]}), steps=1000)
    locked = resolve(before, lock=["shelf"])
    again = home.solve(solution_json.brief_of(solution_json.to_document(locked)), steps=1000)
    assert len({p.group for p in again.pieces if p.function == "shelf"}) == 1


def test_adjust_on_the_command_line(
    house: Solution, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = tmp_path / "home.json", tmp_path / "out.json"
    solution_json.write(house, source)
    bed = piece(house, "bedroom/sleeping/double_bed")
    x, y = ahead(bed)
    told = f"bedroom/bed={x:.3f},{y:.3f},{degrees(bed.pose.heading):.3f}"
    assert cli.run(["adjust", str(source), "-o", str(out), "--move", told, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert bed.id in document["changed"]["moved"]
    assert piece(solution_json.read(out), bed.id).pose.y == pytest.approx(y, abs=1e-3)
    out.unlink()
    for fault in (
        "--move bed",
        "--move bedroom/bed=1,1,400",
        "--move bed=1",
        "--move bed=1,x",
        "--swap sofa",
    ):
        assert cli.run(["adjust", str(source), "-o", str(out), *fault.split(" ")]) == 2
        assert not out.exists()


@pytest.mark.parametrize(
    ("heading", "meant"), [("1.5708", "90"), ("3.14", "180"), ("-0.785", "-45")]
)
def test_headings_in_radians_are_refused_on_the_command_line(
    heading: str, meant: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.run(["adjust", "home.json", "-o", "o.json", "--move", f"bed=1,2,{heading}"]) == 2
    assert f"seems to be in radians; give degrees: {meant}\n" in capsys.readouterr().err


def test_a_room_again_from_its_own_seed_says_that_nothing_changed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = tmp_path / "room.json", tmp_path / "room.svg"
    assert cli.run(["arrange", "sample:home-room", "-o", str(source), "-q"]) == 0
    room = solution_json.read(source).pieces[0].space
    again = ["adjust", str(source), "-o", str(out), "--again", room]
    assert cli.run(again) == 0
    assert "nothing changed; try --seed 1" in capsys.readouterr().out
    assert cli.run([*again, "--seed", "1"]) == 0
    assert "nothing changed" not in capsys.readouterr().out
