"""The solution file: exact round trip, locked pieces, and one clear line for anything hostile."""

from __future__ import annotations

import copy
import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flat import flat_solution
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import LeftOut, Patch, Solution, TermValue
from scenewright.formats import solution_json

NUMBERS = st.floats(-1e6, 1e6, allow_nan=False)
NAMES = st.text(st.characters(exclude_categories=["Cs"]), max_size=12)
PLACES = st.floats(-1e4, 1e4)
LENGTHS = st.floats(1e-6, 30)
ANGLES = st.floats(-6.28, 6.28)
POSES = st.builds(Pose, PLACES, PLACES, st.floats(0, 100), ANGLES)
SIZES = st.builds(Size, LENGTHS, LENGTHS, LENGTHS)
PIECES = st.builds(
    Piece,
    NAMES,
    NAMES,
    NAMES,
    st.sampled_from(["living", "bedroom"]),
    POSES,
    SIZES,
    NAMES,
    NAMES,
    st.none(),
    st.booleans(),
)
BOXES = st.tuples(PLACES, PLACES, ANGLES, LENGTHS, LENGTHS)
SOLUTIONS = st.builds(
    dataclasses.replace,
    st.just(flat_solution()),
    pieces=st.lists(PIECES, max_size=4, unique_by=lambda p: p.id).map(tuple),
    patches=st.lists(st.builds(Patch, NAMES, NAMES, NAMES, BOXES), max_size=3).map(tuple),
    terms=st.lists(
        st.builds(TermValue, NAMES, NAMES, NAMES, NUMBERS, NUMBERS, NUMBERS), max_size=3
    ).map(tuple),
    left_out=st.lists(st.builds(LeftOut, NAMES, NAMES, NAMES, st.booleans()), max_size=3).map(
        tuple
    ),
    energies=st.dictionaries(NAMES, NUMBERS, max_size=3),
    preset=NAMES,
    seed=st.integers(-(2**63), 2**63),
    seconds=st.floats(0, 1e9),
)


@given(SOLUTIONS)
def test_round_trip_is_exact(solution: Solution) -> None:
    assert solution_json.loads(solution_json.dumps(solution)) == solution


def test_file_round_trip_and_nothing_else_left_behind(solution: Solution, tmp_path: Path) -> None:
    solution_json.write(solution, tmp_path / "flat.json")
    assert solution_json.read(tmp_path / "flat.json") == solution
    assert [p.name for p in tmp_path.iterdir()] == ["flat.json"]


def test_a_failed_write_leaves_the_old_file(solution: Solution, tmp_path: Path) -> None:
    path = tmp_path / "flat.json"
    path.write_text("old")
    with pytest.raises(ValueError, match="JSON"):
        solution_json.write(dataclasses.replace(solution, energies={"a": float("nan")}), path)
    assert path.read_text() == "old"


def test_numpy_numbers_are_written_as_numbers(solution: Solution) -> None:
    counted = dataclasses.replace(
        solution, evaluations=np.int64(3), energies={"a": np.float32(0.5)}
    )
    again = solution_json.loads(solution_json.dumps(counted))
    assert (again.evaluations, again.energies) == (3, {"a": 0.5})


def test_time_is_not_saved_but_read_from_older_files(solution: Solution) -> None:
    slower = dataclasses.replace(solution, seconds=solution.seconds + 1.0)
    assert slower == solution
    assert solution_json.dumps(slower) == solution_json.dumps(solution)
    document = solution_json.to_document(solution)
    assert "seconds" not in document
    assert solution_json.of_document(document | {"seconds": 2.5}).seconds == 2.5


def test_one_piece_a_line(solution: Solution) -> None:
    lines = solution_json.dumps(solution).splitlines()
    assert sum('"category"' in line and '"pose"' in line for line in lines) == 6


def test_locked_pieces_become_fixed_items(solution: Solution) -> None:
    document = solution_json.to_document(solution)
    document["pieces"][0]["fixed"] = document["pieces"][5]["fixed"] = True
    living, bedroom = solution_json.brief_of(document).rooms
    sofa, *companions = living.fixed
    assert (sofa.id, sofa.category, sofa.asset) == ("sofa", "sofa", "sofa")
    assert [*sofa.at, sofa.z, sofa.heading] == document["pieces"][0]["pose"]
    assert list(sofa.size) == document["pieces"][0]["size"]
    assert {item.group for item in companions} == {sofa.group}
    chest, lamp = bedroom.fixed
    assert (lamp.id, lamp.z) == ("lamp", 0.8)
    assert (chest.id, chest.name) == ("old-chest", "Grandmother's chest")


def test_unlocking_a_fixed_item_frees_it(solution: Solution) -> None:
    document = solution_json.to_document(solution)
    document["pieces"][4]["fixed"] = False
    assert [list(room.fixed) for room in solution_json.brief_of(document).rooms] == [[], []]


def test_a_fixed_item_missing_from_the_pieces_stays(solution: Solution) -> None:
    document = solution_json.to_document(solution)
    del document["pieces"][4:]
    assert [item.id for item in solution_json.brief_of(document).rooms[1].fixed] == ["old-chest"]


def spoil(*steps: Any, value: Any) -> Any:
    """A change to a document: the value at the end of ``steps`` becomes ``value``."""

    def change(document: Any) -> Any:
        document = copy.deepcopy(document)
        inside = document
        for step in steps[:-1]:
            inside = inside[step]
        inside[steps[-1]] = value
        return document

    return change


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (spoil("format", value="scenewright/brief"), "is not a solution"),
        (spoil("version", value=2), "version '2'"),
        (spoil("version", value=["x" * 9999]), "version"),
        (spoil("pieces", 0, "size", 1, value=-1), r"pieces\[0\].size\[1\]"),
        (spoil("pieces", 0, "size", value=[1, 2]), r"pieces\[0\].size"),
        (spoil("pieces", 0, "pose", 0, value="here"), r"pieces\[0\].pose\[0\]"),
        (spoil("pieces", 0, "pose", 3, value=90), r"pieces\[0\].pose\[3\]: 90 is not .* radians"),
        (spoil("pieces", 0, "fixed", value="yes"), r'pieces\[0\].fixed: "yes" .*; give true or'),
        (spoil("pieces", 1, "id", value="sofa"), "several pieces have the id 'sofa'"),
        (spoil("pieces", 0, "space", value="attic\n\nrm"), r"no room with the id 'attic"),
        (spoil("pieces", 5, "on", value="nothing"), r"pieces\[5\].on: unknown piece"),
        (spoil("pieces", 0, "colour", value="red"), r"pieces\[0\].colour"),
        (spoil("evaluations", value=-3), "evaluations"),
        (spoil("seed", value=[]), "seed"),
        (spoil("brief", "rooms", value=[]), "brief.rooms"),
        (spoil("brief", value=None), "brief"),
        (lambda document: [document], "is not a solution"),
        (lambda _: None, "is not a solution"),
    ],
)
def test_a_bad_document_is_one_line(change: Any, told: str) -> None:
    text = json.dumps(change(solution_json.to_document(flat_solution())))
    with pytest.raises(InputError, match=told) as caught:
        solution_json.loads(text)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 300


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"{",
        b"\xff\xfe\x00",
        b"[" * 100_000,
        b'{"format": NaN}',
        b'{"format": "scenewright/solution", "version": 1, "seed": ' + b"9" * 5000 + b"}",
        b'{"format": "scenewright/solution", "version": 1, "brief": '
        + b"[" * 900
        + b"]" * 900
        + b"}",
    ],
)
def test_broken_bytes_are_one_line(data: bytes, tmp_path: Path) -> None:
    path = tmp_path / "broken.json"
    path.write_bytes(data)
    with pytest.raises(InputError, match=r"broken\.json: ") as caught:
        solution_json.read(path)
    assert "\n" not in str(caught.value)


def test_only_files_are_read(tmp_path: Path) -> None:
    (tmp_path / "folder.json").mkdir()
    (tmp_path / "device.json").symlink_to("/dev/null")
    for name, told in (("folder", "is a folder"), ("device", "is not a file")):
        with pytest.raises(InputError, match=f"{name}.json: {told}; give the file itself"):
            solution_json.read(tmp_path / f"{name}.json")


def test_missing_file_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no such file; check the path"):
        solution_json.read(tmp_path / "none.json")
