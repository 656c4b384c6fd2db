"""The measure of likeness: a metric on the line, blind to where and which way, sharp to change."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from benchmarks.extend_data import cut_compounds
from scipy.stats import wasserstein_distance

import scenewright as sw
from scenewright import cli
from scenewright.ground.buildings.built import BuiltBuilding, BuiltRoad, BuiltScene
from scenewright.ground.likeness.excess import find_excess, wasserstein
from scenewright.ground.likeness.features import measure_scene
from scenewright.ground.likeness.places import compare_places, share_copied, split_halves


def rows(pitch: float = 14.0, between: float = 22.0, count: int = 8, **more: float) -> BuiltScene:
    """Rows of like houses, a little uneven."""
    rng = np.random.default_rng(5)
    found = []
    for k in range(count):
        for j in range(3):
            x, y = pitch * k + rng.normal(0, 0.3), between * j + rng.normal(0, 0.3)
            w, d = more.get("wide", 9.0) + rng.normal(0, 0.2), 7.0 + rng.normal(0, 0.2)
            ring = np.array([[x, y], [x + w, y], [x + w, y + d], [x, y + d]])
            found.append(BuiltBuilding(f"{k}-{j}", "", ring, more.get("height", 7.0)))
    return BuiltScene("rows", tuple(found))


def turned(scene: BuiltScene, angle: float) -> BuiltScene:
    cos, sin = np.cos(angle), np.sin(angle)
    turn = np.array([[cos, sin], [-sin, cos]])
    made = tuple(one._replace(outline=one.outline @ turn + (300, -70)) for one in scene.buildings)
    return scene._replace(buildings=made)


def test_w1_is_that_of_scipy() -> None:
    rng = np.random.default_rng(0)
    for n, m in ((1, 1), (5, 9), (40, 3)):
        a, b = rng.normal(size=n), rng.exponential(size=m)
        assert float(wasserstein(a, b)) == pytest.approx(wasserstein_distance(a, b))


def test_features_do_not_depend_on_where_a_place_lies_nor_on_its_turn() -> None:
    here = measure_scene(rows())
    there = measure_scene(turned(rows(), 0.4))
    for name in here:
        if name not in ("north", "east", "front_gap", "side_gap", "offset"):
            assert np.sort(there[name]) == pytest.approx(np.sort(here[name]), abs=2e-4), name


def test_gaps_are_those_that_were_built() -> None:
    found = measure_scene(rows(count=12))
    assert np.median(found["side_gap"]) == pytest.approx(5.0, abs=0.5)
    assert np.median(found["front_gap"]) == pytest.approx(15.0, abs=0.5)
    assert np.median(found["length"]) == pytest.approx(9.0, abs=0.3)


@pytest.mark.parametrize(
    ("changed", "side", "words"),
    [
        (rows(pitch=20.0), "how", "side gaps"),
        (rows(between=34.0), "how", "front gaps"),
        (rows(height=14.0), "what", "heights 7.0 m more"),
        (rows(wide=6.0), "what", "lengths"),
    ],
)
def test_what_changes_is_told(changed: BuiltScene, side: str, words: str) -> None:
    same = compare_places(rows(count=9), rows(count=8))
    found = compare_places(rows(), changed)
    assert getattr(found.excess, side) > getattr(same.excess, side) + 0.1
    assert any(words in line for line in found.words), found.words
    assert same.verdict == "as alike as two halves of one place"


def test_excess_is_about_nothing_between_random_halves() -> None:
    scene = rows(count=20)
    measured = measure_scene(scene)
    rng = np.random.default_rng(1)
    found = []
    for _ in range(12):
        order = rng.permutation(len(scene.buildings))
        a, b = ({k: v[part] for k, v in measured.items()} for part in np.array_split(order, 2))
        found.append(find_excess(a, b).whole)
    assert abs(np.mean(found)) < 0.05


def test_copies_are_found_turned_and_mirrored() -> None:
    ell = np.array([[0, 0], [9, 0], [9, 4], [5, 4], [5, 8], [0, 8.0]])
    one = BuiltBuilding("a", "", ell, 6.0)
    turned_ = BuiltBuilding("b", "", ell[:, ::-1][::-1] * (1, -1) + 50, 6.0)
    other = BuiltBuilding("c", "", ell * (1.3, 1.0), 6.0)
    taller = BuiltBuilding("d", "", ell + 5, 9.0)
    assert share_copied([one], [turned_, other, taller]) == pytest.approx(1 / 3)


def test_street_distances_count_where_there_are_streets() -> None:
    road = BuiltRoad(np.array([[0.0, -5.0], [120.0, -5.0]]), 6.0)
    found = measure_scene(rows()._replace(roads=(road,)))
    assert np.nanmin(found["street"]) == pytest.approx(5.0, abs=1.0)
    assert "street" not in measure_scene(rows())


def test_only_the_front_row_has_a_street() -> None:
    road = BuiltRoad(np.array([[0.0, -5.0], [120.0, -5.0]]), 6.0)
    scene = rows()._replace(roads=(road,))
    front = np.array([one.id.endswith("-0") for one in scene.buildings])
    assert (np.isfinite(measure_scene(scene)["street"]) == front).all()
    wider = rows()._replace(roads=(road._replace(line=road.line - (0.0, 6.0)),))
    shifts = {f.name: f.shift for f in find_excess(*map(measure_scene, (scene, wider))).features}
    assert shifts["street"] == pytest.approx(6.0, abs=0.01)


def test_compare_from_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    solution = sw.solve(sw.read("sample:extend-terrace"), steps=1)
    sw.write(solution, tmp_path / "a.json")
    assert cli.run(["compare", str(tmp_path / "a.json"), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["copied"] > 0.95, "all but the variants of what stands once"
    assert found["whole"] < 0.3
    assert found["buildings"][0] == 66
    assert cli.run(["compare", str(tmp_path / "a.json"), str(tmp_path / "b.json")]) == 2
    assert "there is no such file" in capsys.readouterr().err


@pytest.mark.realdata(quick=True)
def test_the_measure_knows_real_places() -> None:
    places = [p for p in cut_compounds() if not p.held]
    measured = [(measure_scene(p.one), measure_scene(p.other)) for p in places]
    same = [find_excess(a, b).whole for a, b in measured]
    count = len(measured)
    other = [
        find_excess(measured[k][0], measured[(k + s) % count][1]).whole
        for k in range(count)
        for s in (1, 5)
    ]
    area = (np.array(same)[:, None] < np.array(other)[None]).mean()
    assert area > 0.85
    for place in places[:3]:
        a, b = split_halves([*place.one.buildings, *place.other.buildings])
        assert abs(len(a) - len(b)) <= 1
