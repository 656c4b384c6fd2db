"""The benchmark of sets: what it calls lost, and its table."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from benchmarks.sets import lost, make_plans, markdown_lines, record

from scenewright.workflow.manifest import plan_hash


def written(folder: Path, scenes: dict[str, str]) -> Path:
    """A set with a file of some digest a scene."""
    folder.mkdir()
    lines: list[dict[str, Any]] = []
    for name, digest in scenes.items():
        (folder / f"{name}.json").write_text("{}")
        lines.append({"scene": name, "files": [{"file": f"{name}.json", "blake2b": digest}]})
    (folder / "manifest.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))
    return folder


@pytest.mark.parametrize(
    ("scenes", "count"), [({"a": "1", "b": "2"}, 0), ({"a": "1"}, 1), ({"a": "1", "b": "3"}, 1)]
)
def test_what_is_missing_or_other_is_lost(
    scenes: dict[str, str], count: int, tmp_path: Path
) -> None:
    whole = written(tmp_path / "whole", {"a": "1", "b": "2"})
    assert lost("killed", 2, whole, written(tmp_path / "made", scenes))["ours"] == count
    (tmp_path / "made" / "a.json").unlink()
    assert lost("killed", 2, whole, tmp_path / "made")["ours"] == count + 1


@pytest.mark.realdata(quick=True)
def test_plans_are_valid_and_differ() -> None:
    made, rows = make_plans(4)
    found = {row["metric"]: row["ours"] for row in rows[:3]}
    assert (found["valid"], found["alike"]) == (100.0, 0.0)
    assert len({plan_hash(brief) for brief in made}) == 4


def test_the_table_keeps_what_was_asked_apart_from_real_flats() -> None:
    rows = [record("homes", "rate", "a minute", 61.24, 60.0, 9)]
    rows += [rows[0] | {"baseline_name": "real flats", "baseline": 5.0}]
    assert [*markdown_lines(rows)][2:] == [
        "| homes | rate, a minute | 9 | 61.24 | 60 |  |",
        "| homes | rate, a minute | 9 | 61.24 |  | 5 |",
    ]
