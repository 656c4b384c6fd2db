"""Passes as rows: the loop, what it hears, and ``explain --passes``."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from scenewright.cli.commands import app
from scenewright.core.errors import InputError
from scenewright.core.passes import Pass, PassChange, PassOptions, PassRun, run_passes, tally_passes
from scenewright.core.registry import domain_of
from scenewright.domains.hall.retouch import LEFT, RETOUCHES
from scenewright.domains.hall.solving import solve as solve_hall
from scenewright.domains.home.passes import PASSES
from scenewright.domains.home.solving import solve
from scenewright.formats import read, solution_json

ROWS = (Pass("add", "sums", 1, "one more"), Pass("double", "products", 2, "twice"))


def run(options: PassOptions) -> int:
    def apply(by: int, now: int) -> int:
        return now + 1 if by == 1 else now * by

    def compare(before: int, after: int) -> Iterator[PassChange]:
        yield PassChange("room", float(after - before), 0.0, 1)

    return run_passes(ROWS, 3, options, apply, compare)


@pytest.mark.parametrize(
    ("off", "after"),
    [((), 8), (("add",), 6), (("products",), 4), (("add", "double"), 3), (("other",), 8)],
)
def test_passes_and_groups_are_switched_off_by_name(off: tuple[str, ...], after: int) -> None:
    assert run(PassOptions(frozenset(off))) == after


def test_every_run_is_heard_and_tallied_in_the_order_of_the_table() -> None:
    heard: list[PassRun] = []
    assert run(PassOptions(hear=heard.append)) == 8
    tallies = tally_passes(ROWS, [*reversed(heard)])
    assert [(t.name, t.runs, t.spaces, t.gain) for t in tallies] == [
        ("add", 1, ("room",), 1.0),
        ("double", 1, ("room",), 4.0),
    ]


@pytest.mark.parametrize("passes", [PASSES, RETOUCHES])
def test_names_of_passes_are_unique_and_differ_from_groups(passes: Sequence[Pass[Any]]) -> None:
    names = [each.name for each in passes]
    assert len(set(names)) == len(names)
    assert not {each.group for each in passes} & set(names)


def test_a_home_without_passes_is_another_and_hearing_changes_nothing() -> None:
    brief, heard = read("sample:home-studio"), list[PassRun]()
    usual = solve(brief, steps=200, threads=1)
    followed = solve(brief, steps=200, threads=1, passes=PassOptions(hear=heard.append))
    off = frozenset(each.group for each in PASSES)
    bare = solve(brief, steps=200, threads=1, passes=PassOptions(off))
    assert followed == usual
    assert bare.pieces != usual.pieces
    assert {run.name for run in heard} <= {each.name for each in PASSES}
    assert any(run.changes for run in heard)


def test_explain_tells_what_each_pass_changed(tmp_path: Path) -> None:
    file = tmp_path / "room.json"
    solution_json.write(solve(read("sample:home-room"), threads=1), file)
    result = CliRunner().invoke(app, ["explain", str(file), "--passes", "--json"])
    assert result.exit_code == 0, result.output
    document = json.loads(result.stdout)
    assert document["same"] is True
    assert [row["name"] for row in document["passes"]] == [each.name for each in PASSES]
    shown = CliRunner().invoke(app, ["explain", str(file), "--passes"])
    assert all(each.purpose in shown.stdout for each in PASSES)


def test_retouches_are_switched_off_and_heard_and_tell_what_is_left() -> None:
    brief = read("sample:hall-reading-room")

    def run_without(*off: str) -> list[PassRun]:
        heard = list[PassRun]()
        options = PassOptions(frozenset(off), heard.append)
        solve_hall(brief, steps=300, threads=1, passes=options)
        return heard

    heard, bare = run_without(), run_without("spread")
    assert {run.name for run in heard} == {LEFT, *(each.name for each in RETOUCHES)}
    assert max(c.faults for run in heard if run.name == "spread" for c in run.changes) > 1.0
    assert "spread" not in {run.name for run in bare}
    left = [
        min(-run.changes[0].faults for run in runs if run.name == LEFT) for runs in (heard, bare)
    ]
    assert left[1] > left[0] + 1.0


def test_a_domain_without_passes_says_so() -> None:
    with pytest.raises(InputError, match="'site' do not support 'passes'"):
        domain_of("site").verb("passes")
