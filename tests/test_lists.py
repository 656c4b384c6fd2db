"""What ``list`` names: for people each kind once and in words, for machines every row."""

from __future__ import annotations

import json

import pytest

from scenewright import cli
from scenewright.workflow import lists

Captured = pytest.CaptureFixture[str]


@pytest.mark.parametrize(
    "what",
    ["solvers", "terms", "patterns", "presets", "formats", "groups", "styles", "assets", "samples"],
)
def test_lists(what: str, capsys: Captured) -> None:
    assert cli.run(["list", what, "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert rows
    assert cli.run(["list", what]) == 0
    first = next(iter(rows[0].values()))
    assert str(first) in capsys.readouterr().out


def test_every_kind_of_furniture_is_listed_once(capsys: Captured) -> None:
    rows = lists.rows("assets")
    shown = lists.select_columns("assets", rows)
    assert [row["category"] for row in shown] == list(dict.fromkeys(r["category"] for r in rows))
    assert sum(row["models"] for row in shown) == len(rows)
    checkout = next(row for row in shown if row["category"] == "checkout")
    assert checkout["usual"] == ["1.6–2.2", "0.7–1.2", "1.2–1.3"]


def test_samples_tell_what_they_hold() -> None:
    holds = {row["name"]: row["holds"] for row in lists.rows("samples")}
    assert holds["sample:village-street"] == "2 blocks, 1 lane"
    assert holds["sample:home-studio"] == "2 rooms, 1 level"
    assert not [name for name, text in holds.items() if text.startswith("0")]
