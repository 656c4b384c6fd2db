"""Sets of generated plans: a range of seeds, the manifest, and splits that share no plan."""

from __future__ import annotations

import json

import pytest

from scenewright.cli import run
from scenewright.formats import read
from scenewright.workflow.generate import generate
from scenewright.workflow.manifest import plan_hash, split_of


def test_a_range_of_seeds_is_written_with_its_manifest(tmp_path):
    folder = tmp_path / "plans"
    assert run(["generate", "home", "--rooms", "3", "--seeds", "3:6", "-o", str(folder), "-q"]) == 0
    lines = [json.loads(line) for line in (folder / "manifest.jsonl").read_text().splitlines()]
    assert [line["seed"] for line in lines] == [3, 4, 5]
    for line in lines:
        assert plan_hash(read(folder / line["file"])) == line["plan"]
        assert line["split"] == split_of(line["plan"])
        assert line["asked"] == {"rooms": 3}


def test_equal_plans_share_a_hash_whatever_their_name():
    brief = generate("home", seed=1)
    assert plan_hash(brief.model_copy(update={"name": "another"})) == plan_hash(brief)
    assert plan_hash(generate("home", seed=2)) != plan_hash(brief)


def test_splits_are_of_the_shares_they_say():
    found = [split_of(f"{n * 2**32 // 1000:08x}") for n in range(1000)]
    assert {name: found.count(name) for name in ("train", "val", "test")} == pytest.approx(
        {"train": 800, "val": 100, "test": 100}, abs=1
    )


@pytest.mark.parametrize(
    ("seeds", "said"),
    [
        (["9:3"], "holds no seed"),
        (["3:3"], "holds no seed"),
        (["0:" + 20 * "9"], "is no range"),
        (["0:" + 5000 * "9"], "is no range"),
        (["-1:3"], "is no range"),
        (["many"], "is no range"),
        (["0:100001"], "is 100001 plans"),
        (["0:3", "--count", "4"], "--seeds says which seeds"),
    ],
)
def test_a_range_that_cannot_be_used_is_one_line(seeds, said, tmp_path, capsys):
    words = ["generate", "home", f"--seeds={seeds[0]}", *seeds[1:], "-o", str(tmp_path / "plans")]
    assert run(words) == 2
    fault = capsys.readouterr().err
    assert said in fault
    assert fault.count("\n") == 1
    assert not list(tmp_path.iterdir())
