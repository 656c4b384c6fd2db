"""Libraries of furniture."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from model_files import PIECE, TETRAHEDRON, body, furniture, obj_text, put
from scenewright.catalog.models import library, report
from scenewright.catalog.models.model import ImportOptions
from scenewright.core.errors import InputError


def test_furniture_libraries_give_size_names_and_makers(tmp_path: Path) -> None:
    path = furniture(tmp_path, PIECE, {"kit/table.obj": obj_text()}, de="name#1=Kaffeetisch")
    (model,) = library(path)
    assert model.size == pytest.approx((0.8, 0.6, 0.74))
    assert (model.id, model.name, model.category) == ("shop/table", "Café table", "Kitchen")
    assert (model.author, model.licence, model.elevation) == ("José", "Public domain", 0.1)
    assert library(path, ImportOptions(language="de_AT"))[0].name == "Kaffeetisch"
    corners = np.unique(body(model).vertices.round(9), axis=0)
    turned = TETRAHEDRON @ np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]).T  # the file's rows
    ours = np.stack([-turned[:, 0], turned[:, 2], turned[:, 1]], 1)
    ours = (ours - ours.min(0)) / np.ptp(ours, axis=0) * model.size
    ours -= [model.size.width / 2, model.size.depth / 2, 0]
    assert np.allclose(corners, np.unique(ours.round(9), axis=0))


def test_a_library_keeps_what_is_sound_and_tells_the_rest(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    put(tmp_path, "b.obj", obj_text())
    put(tmp_path, "a/b.obj", obj_text())
    put(tmp_path, "broken.obj", "v 1 2\n")
    put(tmp_path, "notes.txt", "no model")
    put(tmp_path, "brief.json", {"rooms": []})
    found = report(tmp_path)
    assert [model.id for model in found.models] == ["b", "b-2"]
    assert {one.name for one in found.skipped} == {"broken.obj", "brief.json"}
    assert all(len(one.reason.splitlines()) == 1 for one in found.skipped)
    with pytest.raises(InputError, match="holds no usable model"):
        library(tmp_path / "brief.json")
