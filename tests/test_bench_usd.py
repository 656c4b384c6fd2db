"""The benchmark of USD counts what it says, and a scene that is not whole shows."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("pxr")

from benchmarks.usd import count_scene, count_stage, measure
from pxr import Usd

from flat import flat_solution
from scenewright.formats import write


def test_a_scene_is_whole() -> None:
    found = measure(flat_solution())
    assert found.faults == 0
    assert found.found == found.wanted
    assert min(found.wanted.values()) > 0


def test_what_is_missing_is_seen(tmp_path: Path) -> None:
    path = tmp_path / "flat.usda"
    write(flat_solution(), path)
    stage = Usd.Stage.Open(str(path))
    light = next(prim for prim in stage.Traverse() if prim.GetName() == "Light")
    stage.RemovePrim(light.GetPath())
    lacking = count_scene(flat_solution()) - count_stage(stage)
    assert lacking == {"lamps": 1}
