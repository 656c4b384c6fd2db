"""Model files: what is read is what was written, set up in our frame; all real files are used."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh

from model_files import SIDES, TETRAHEDRON, body, obj_text, put
from scenewright.catalog.models import ROWS, library, load, report
from scenewright.catalog.models.as_asset import asset_of
from scenewright.catalog.models.model import ImportOptions
from scenewright.core.catalog import Part
from scenewright.core.scene import Size
from scenewright.geometry.mesh import volume


def bounds(parts: tuple[Part, ...]) -> tuple[list[float], list[float]]:
    points = np.concatenate([part.vertices for part in parts])
    return points.min(0).tolist(), points.max(0).tolist()


@pytest.mark.parametrize(
    ("up", "front", "size"),
    [
        ("", "", (2, 4, 3)),
        ("+z", "-y", (2, 3, 4)),
        ("+y", "+x", (4, 2, 3)),
        ("-x", "+z", (3, 4, 2)),
    ],
)
def test_a_model_stands_upright_on_the_middle_of_its_footprint(
    tmp_path: Path, up: str, front: str, size: tuple[float, ...]
) -> None:
    model = load(put(tmp_path, "kit.obj", obj_text()), ImportOptions(up, front))
    assert model.size == size
    assert model.id == model.name == "kit"
    w, d, h = size
    assert bounds(model.parts) == ([-w / 2, -d / 2, 0], [w / 2, d / 2, h])
    assert volume(body(model)) == pytest.approx(4.0), "faces still look outwards"


def test_the_front_comes_to_plus_y(tmp_path: Path) -> None:
    """The corner furthest along the file's front is the furthest along ours; where that front is
    the other way, the furthest back."""
    for front, corner in (("+z", 3), ("-z", 3), ("+x", 1), ("-x", 1)):
        model = load(put(tmp_path, "kit.obj", obj_text()), ImportOptions("", front))
        whole = body(model)
        lengths = sorted(np.linalg.norm(TETRAHEDRON - TETRAHEDRON[corner], axis=1))
        ahead = whole.vertices[:, 1] if front[0] == "+" else -whole.vertices[:, 1]
        assert np.sum(ahead > ahead.max() - 1e-9) == 1
        away = sorted(np.linalg.norm(whole.vertices - whole.vertices[np.argmax(ahead)], axis=1))
        assert away == pytest.approx(lengths)


def test_an_asset_fills_any_size_and_prefers_its_own(tmp_path: Path) -> None:
    asset = asset_of(load(put(tmp_path, "kit.obj", obj_text()), ImportOptions(scale=2.0)))
    assert asset.id == "model:kit"
    assert asset.category == "building"
    assert asset.usual == (4, 8, 6)
    for size in (Size(4, 8, 6), Size(1.3, 2.7, 0.9)):
        w, d, h = size
        assert np.allclose(
            bounds(asset.mesh(size)), ([-w / 2, -d / 2, 0], [w / 2, d / 2, h]), 0, 1e-12
        )
        lines = asset.symbol(size)
        assert len(lines) == 1
        assert np.array_equal(lines[0][0], lines[0][-1]), "outlines are closed"
        assert np.allclose([lines[0].min(0), lines[0].max(0)], [[-w / 2, -d / 2], [w / 2, d / 2]])


def test_an_outline_follows_the_body_not_its_hull(tmp_path: Path) -> None:
    ell = np.array([[0, 0], [3, 0], [3, 1], [1, 1], [1, 2], [0, 2]])
    rows = [f"v {x} {y} {z}" for z in (0, 1) for x, y in ell]
    text = "\n".join([*rows, "f 6 5 4 3 2 1", "f 7 8 9 10 11 12"])
    symbol = asset_of(load(put(tmp_path, "ell.obj", text), ImportOptions("+z", "+y"))).symbol
    outline = symbol(Size(3, 2, 1))[0]
    x, y = outline[:-1].T
    area = 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))
    assert area == pytest.approx(4.0, abs=1e-3)


@pytest.mark.parametrize("binary", [True, False])
def test_stl_agrees_with_another_writer(tmp_path: Path, binary: bool) -> None:
    kind = "stl" if binary else "stl_ascii"
    mesh = trimesh.Trimesh(TETRAHEDRON, SIDES)
    content = mesh.export(file_type=kind)
    model = load(put(tmp_path, "kit.stl", content))
    assert model.size == (2, 3, 4)
    assert volume(body(model)) == pytest.approx(4.0)


def test_rows_name_modules_that_read() -> None:
    from importlib import import_module

    for row in ROWS:
        assert callable(import_module(f"scenewright.catalog.models.{row.reader}").read)


REAL = [
    ("kenney_city", 15, 15),
    ("kaykit_city", 61, 61),
    ("kaykit_medieval_village", 54, 54),
    ("kenney_furniture_nature", 205, 205),
    ("citymodels_cityjson", 225, 225),
    ("furniture_sweethome3d", 175, 175),
    ("meshes_classic", 5, 5),
]


@pytest.mark.realdata
@pytest.mark.parametrize(("folder", "least", "all_of"), REAL)
def test_real_models_are_read(real_data: Path, folder: str, least: int, all_of: int) -> None:
    found = report(real_data / folder)
    assert len(found.models) >= least
    assert len(found.models) + len(found.skipped) == all_of
    for model in found.models:
        low, high = bounds(model.parts)
        w, d, h = model.size
        assert np.allclose(low, [-w / 2, -d / 2, 0], atol=1e-6 * max(model.size))
        assert np.allclose(high, [w / 2, d / 2, h], atol=1e-6 * max(model.size))


@pytest.mark.realdata(quick=True)
@pytest.mark.parametrize(
    "name",
    [
        "kaykit_city/obj/building_A.obj",
        "kenney_city/starter_kit/building-small-a.glb",
        "meshes_classic/spot.obj",
        "kenney_furniture_nature/loungeSofa.glb",
    ],
)
def test_real_models_agree_with_another_reader(real_data: Path, name: str) -> None:
    model, other = load(real_data / name), trimesh.load(real_data / name, force="mesh")
    width, height, depth = other.extents
    assert model.size == pytest.approx((width, depth, height), rel=1e-6)
    whole = body(model)
    mine = trimesh.Trimesh(whole.vertices, whole.faces, process=False)
    assert mine.area == pytest.approx(other.area, rel=1e-6)
    assert mine.volume == pytest.approx(other.volume, rel=1e-4)


@pytest.mark.realdata
def test_real_atlases_give_few_colours(real_data: Path) -> None:
    for model in library(real_data / "kaykit_city" / "obj" / "building_A.obj"):
        colours = np.array([part.material.color for part in model.parts])
        assert 3 <= len(colours) <= 16
        assert np.ptp(colours, axis=0).max() > 0.2, "not all alike"
