"""A few damaged files of the stored formats read soonest, broken plug-ins, a few kills."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from benchmarks.damaged import FORMATS, KINDS, MOST_MEMORY, run_format
from benchmarks.damaged_plugins import list_plugins, run_plugin
from benchmarks.killed import kill_often

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="watches processes as Linux does")
SOON = ("ledgers", "trainings", "groups", "corrections", "blocks to learn")
SOME = 8
MET = ("scenewright.kinds exits", "scenewright.domains raises", "format without dot", "kinds odd")


@pytest.mark.parametrize("name", SOON)
def test_damaged_files_are_used_or_refused(name: str, tmp_path: Path) -> None:
    one = next(row for row in FORMATS if row.name == name)
    runs = list(run_format(one, len(KINDS) + SOME, tmp_path, seed=1))
    assert len(runs) == len(KINDS) + SOME
    for run in runs:
        assert run.outcome in ("accepted", "refused"), run
        assert run.memory <= MOST_MEMORY, run


@pytest.mark.parametrize("name", MET)
def test_a_broken_plugin_is_named_and_left_out(name: str, tmp_path: Path) -> None:
    one = next(row for row in list_plugins() if row.name == name)
    run = run_plugin(one, tmp_path / "plugin")
    assert run.outcome == "accepted", run


@pytest.mark.parametrize("name", ["compile", "evolve"])
def test_a_run_killed_at_some_moments_loses_nothing(name: str, tmp_path: Path) -> None:
    found = kill_often(name, tmp_path, 3)
    assert found.alive
    assert (found.lost, found.half, found.foreign) == (0, 0, 0)
