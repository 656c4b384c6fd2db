"""Models as they come: set upright, turned to their front, unpacked, or with what unpacks them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from scenewright.catalog.assets import shipped
from scenewright.catalog.loading import read_entry
from scenewright.catalog.models import load, report
from scenewright.catalog.models.furniture import library_turn, understood
from scenewright.catalog.models.likeness import TURNS, UPS, turn_matrix
from scenewright.catalog.models.listing import list_models
from scenewright.catalog.models.model import Model
from scenewright.catalog.models.orientation import turn_model
from scenewright.core.brief.catalog import entry_of
from scenewright.core.errors import InputError

FILES = Path(__file__).parent / "data" / "models"
KIT = ("sofa", "armchair", "desk", "double_bed", "bookcase", "toilet")


def own(kind: str, **told: bool) -> Model:
    """A model like our own drawing of a kind, a little larger."""
    asset = shipped().assets[kind]
    size = type(asset.usual)(*(1.03 * side for side in asset.usual))
    return Model(kind, kind.replace("_", " "), asset.mesh(size), size, "", "", "x.glb", **told)


@pytest.mark.parametrize("kind", ["sofa", "armchair", "double_bed", "desk"])
def test_a_model_in_each_of_24_turns_is_set_upright(kind: str) -> None:
    for turn in TURNS:
        found = understood(turn_model(own(kind), turn))
        assert found.category == kind
        set_up = turn_matrix(UPS.index(found.up), found.turn) @ turn
        assert set_up[2].tolist() == [0, 0, 1]
        if kind != "desk":
            assert np.array_equal(set_up, np.eye(3)), "its front is where it was"


@pytest.mark.parametrize("number", [4, 9, 14, 23])
def test_a_library_whose_models_share_other_axes_is_turned_as_one(number: int) -> None:
    models = [turn_model(own(kind), TURNS[number]) for kind in KIT]
    found = library_turn(models, 1.0)
    assert np.array_equal(TURNS[found] @ TURNS[number], np.eye(3))
    assert library_turn([own(kind) for kind in KIT], 1.0) == 0


def test_what_states_its_size_or_what_a_person_states_stays_as_it_is() -> None:
    lying = turn_model(own("sofa"), TURNS[4])
    assert understood(lying._replace(sized=True)).up == "top"
    assert list_models([lying], {}, fixed=True)[0].model.size == lying.size
    stated = list_models([own("sofa")], {"sofa": {"id": "sofa", "up": "back"}})[0]
    assert stated.model.size.height == pytest.approx(own("sofa").size.depth)


def test_a_sofa_a_quarter_turned_has_its_front_found_by_its_back() -> None:
    found = read_entry(entry_of(str(FILES / "sofa_quarter_turned.glb"))).models[0]
    assert found.category == "sofa"
    assert found.model.size[:2] == pytest.approx((2.0, 0.9), abs=0.01)
    points = np.concatenate([part.vertices for part in found.model.parts])
    high = points[points[:, 2] > 0.9 * found.model.size.height]
    assert high[:, 1].max() < 0, "its back is behind"


def test_a_compressed_model_is_read_with_its_colours() -> None:
    pytest.importorskip("DracoPy")
    found = load(FILES / "chair_draco.glb")
    assert found.size == pytest.approx((0.2, 0.2, 0.47), abs=1e-3)
    assert sum(len(part.faces) for part in found.parts) == 170
    assert found.parts[0].material.color == pytest.approx((0.95, 0.8, 0.66), abs=0.02)


def test_what_is_not_read_is_told_with_the_command_that_makes_it_readable(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"meshopt.*npx @gltf-transform/cli copy"):
        load(FILES / "chair_meshopt.glb")
    (tmp_path / "lamp.fbx").write_bytes(b"Kaydara FBX Binary")
    (found,) = report(tmp_path).skipped
    assert "assimp export IN.fbx OUT.glb" in found.reason


def test_a_missing_extra_is_told_with_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "DracoPy", None)
    with pytest.raises(InputError, match=r"pip install 'scenewright\[draco\]'"):
        load(FILES / "chair_draco.glb")


def test_damaged_compressed_models_are_refused(tmp_path: Path) -> None:
    pytest.importorskip("DracoPy")
    sound, rng = (FILES / "chair_draco.glb").read_bytes(), np.random.default_rng(0)
    for _ in range(150):
        broken = np.frombuffer(sound, np.uint8).copy()
        broken[rng.integers(20, len(sound), 4)] = rng.integers(0, 256, 4)
        (tmp_path / "a.glb").write_bytes(broken.tobytes())
        for one in report(tmp_path).skipped:
            assert len(one.reason.splitlines()) == 1


def test_every_model_of_a_folder_is_used_changed_or_left_out_with_its_reason(
    tmp_path: Path,
) -> None:
    for file in ("sofa_quarter_turned.glb", "chair_meshopt.glb"):
        (tmp_path / file).write_bytes((FILES / file).read_bytes())
    (tmp_path / "lamp.fbx").write_bytes(b"Kaydara FBX Binary")
    (tmp_path / "notes.txt").write_text("no model")
    found = read_entry(entry_of(str(tmp_path))).report
    rows = {row.examples[0]: (row.outcome, row.reason) for row in found.rows}
    assert found.features == 3
    assert rows["sofa_quarter_turned"] == ("changed", "turned to its front")
    assert "unpack it: npx" in rows["chair_meshopt.glb"][1]
    assert rows["lamp.fbx"][0] == "left out"
