"""A few damaged files of the stored formats read soonest, broken plug-ins, a few kills."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from benchmarks.damaged import FORMATS, KINDS, MOST_MEMORY, run_format
from benchmarks.damaged_plugins import list_plugins, run_plugin
from benchmarks.killed import kill_often

from scenewright import formats
from scenewright.catalog import models

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="watches processes as Linux does")
SOON = ("ledgers", "trainings", "groups", "corrections", "blocks to learn", "IMDF", "SVG plans")
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


def test_every_suffix_that_is_read_is_damaged() -> None:
    damaged = {row.suffix for row in FORMATS}
    read = {row.suffix for row in formats.formats() if row.reader}
    assert read | {row.suffix for row in models.ROWS} <= damaged
    assert len({row.name for row in FORMATS}) == len(FORMATS)


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
