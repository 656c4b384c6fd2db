"""Reading and splitting real blocks; what is no such data is refused in one line."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest
import shapely

from scenewright.cli.commands import run
from scenewright.core.errors import InputError
from scenewright.domains.village.learning.learn import split_by_place
from scenewright.domains.village.learning.real_blocks import clean_blocks, read_blocks
from scenewright.domains.village.learning.tables import RealBlock

SQUARE = [[0, 0], [40, 0], [40, 30], [0, 30]]


def row(**more: object) -> dict[str, object]:
    houses = [
        {"polygon": [[x, 5], [x + 8, 5], [x + 8, 12], [x, 12]]} for x in (2.0, 12.0, 22.0, 31.0)
    ]
    flags = [True, True, False, False]
    return {"id": "b", "place": "p", "outline": SQUARE, "outline_on_street": flags} | {
        "houses": houses,
        **more,
    }


def block(number: int, place: str) -> RealBlock:
    floor = shapely.box(0, 0, 40, 30)
    return RealBlock(f"b{number}", place, floor, np.array([[[0.0, 0], [40, 0]]]), ())


def test_sides_without_a_street_grow_and_streets_stay() -> None:
    (found,) = clean_blocks([row()])
    assert found.floor.exterior.distance(shapely.Point(20, 0)) < 0.1
    assert found.floor.exterior.distance(shapely.Point(20, 30)) > 2.0
    assert found.floor.covers(shapely.box(0.1, 0.1, 39.9, 29.9))
    assert len(found.houses) == 4


def test_houses_too_small_or_crossing_are_dropped_and_thin_blocks_with_them() -> None:
    small = {"polygon": [[1, 20], [2, 20], [2, 21], [1, 21]]}
    bow = {"polygon": [[5, 15], [20, 25], [20, 15], [5, 25]]}
    houses = row()["houses"]
    assert isinstance(houses, list)
    (found,) = clean_blocks([row(houses=[*houses, small, bow])])
    assert len(found.houses) == 4
    assert clean_blocks([row(houses=houses[:2])]) == ()


@pytest.mark.parametrize(
    "text", ["", "{", "[1]", '[{"id": 1}]', "{}", '[{"outline": "x"}]', "[" * 100_000, "\x00"]
)
def test_what_is_no_list_of_blocks_is_one_line(text: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.json"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_blocks(path)
    assert "bad.json" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_broken_rows_are_named(tmp_path: Path) -> None:
    path = tmp_path / "bad.json"
    path.write_text(json.dumps([row(), row(outline=[[0, 0], ["a", 1]])]))
    with pytest.raises(InputError, match=r"\[1\]"):
        read_blocks(path)


def test_no_place_is_on_both_sides() -> None:
    made = [block(k, f"p{k % 7}") for k in range(60)]
    train, test = split_by_place(made, (), 3)
    assert not {b.place for b in train} & {b.place for b in test}
    assert 0 < len(test) <= 12
    train, test = split_by_place(made, ("p1", "p2"), 3)
    assert {b.place for b in test} == {"p1", "p2"}


def test_unknown_places_and_too_little_data_are_told() -> None:
    made = [block(k, f"p{k % 7}") for k in range(60)]
    with pytest.raises(InputError, match="Atlantis"):
        split_by_place(made, ("Atlantis",), 0)
    with pytest.raises(InputError, match="12 are needed"):
        split_by_place(made[:10], (), 0)


def test_doors_and_materials_are_kept_where_all_are_known() -> None:
    houses = [
        {**told, "door": told["polygon"][0], "material": word}
        for told, word in zip(row()["houses"], ("brick", "other", "mixed", "brick"), strict=True)  # type: ignore[call-overload]
    ]
    (found,) = clean_blocks([row(houses=houses)])
    assert found.materials == (0, 1, 2, 0)
    assert np.array(found.doors).tolist() == [[2, 5], [12, 5], [22, 5], [31, 5]]
    del houses[2]["door"]
    (found,) = clean_blocks([row(houses=houses)])
    assert (found.doors, len(found.materials)) == ((), 4)


@pytest.mark.parametrize(
    "more", [{"door": [1, None]}, {"door": [1, float("nan")]}, {"material": "tin"}]
)
def test_a_door_or_material_that_is_none_is_one_line(more: dict[str, object]) -> None:
    told = [{"polygon": [[x, 5], [x + 8, 5], [x + 8, 12], [x, 12]], **more} for x in (2, 12, 22)]
    with pytest.raises(InputError, match="is no block"):
        clean_blocks([row(houses=told)])


@pytest.mark.parametrize("more", [[], ["--paper"], ["--paper", "--size", "small"]])
def test_without_torch_learning_is_refused_in_one_line(
    more: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    assert run(["learn", "village", "some.json", "-o", "out.npz", *more]) == 2
    said = capsys.readouterr().err
    assert "pip install 'scenewright[learn]'" in said
    assert said.count("\n") == 1
