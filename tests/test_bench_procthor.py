"""The benchmarks of ProcTHOR houses: what is moved or missing shows; a peer that is not there is
named."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from benchmarks.procthor import LOST, compare_shells
from benchmarks.procthor_peer import broken_rules, placed_home, records

from flat import flat_solution
from scenewright.core.errors import InputError
from scenewright.domains import scene_of
from test_procthor import two_rooms


def test_a_moved_opening_and_a_lost_room_are_seen() -> None:
    scene = scene_of(flat_solution())
    assert compare_shells(scene, scene) == (0.0, 0.0)
    first, *rest = scene.openings
    moved = replace(scene, openings=(replace(first, x=first.x + 0.02), *rest))
    assert compare_shells(scene, moved)[1] == pytest.approx(0.02)
    assert compare_shells(scene, replace(scene, spaces=scene.spaces[1:]))[0] == LOST


def test_objects_of_theirs_are_judged_as_placed(tmp_path: Path) -> None:
    house = two_rooms()
    (bed,) = house["objects"]
    bed["scenewright"] = {"size": [1.6, 2.0, 0.9]}
    bed["children"] = []
    path = tmp_path / "0.procthor.json"
    path.write_text(json.dumps(house))
    assert broken_rules(placed_home(path)) == 0
    second = bed | {"id": "Bed|2|1", "position": bed["position"] | {"x": 1.2}}
    path.write_text(json.dumps(house | {"objects": [bed, second]}))
    assert broken_rules(placed_home(path)) > 0


def test_a_generator_that_is_not_there_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTHOR_PYTHON", sys.executable)
    monkeypatch.setenv("PYTHONPATH", "")
    if "procthor" in sys.modules:
        pytest.skip("it is there")
    with pytest.raises(InputError, match=r"ProcTHOR cannot be run.*pip install procthor"):
        next(records(count=1))
