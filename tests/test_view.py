"""Sheets of best views: cameras that see it all, colours that follow saliency, clear faults."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from PIL import Image

from model_files import obj_text, put
from scenewright.cli import run
from scenewright.core.catalog import Material, Part
from scenewright.core.errors import InputError
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.prisms import box
from scenewright.render.picture import view_of
from scenewright.render.portrait import HOTTEST, RAMP, Portrait, facing, heat, portrait, sun_of
from scenewright.render.portrait_sheet import MOST, columns_of, sheet, side_of
from thoroughness import only_thorough

Floats = NDArray[np.float64]
WOOD = Material("wood", (0.6, 0.4, 0.2))
LINE = "v 0 0 0\nv 1 1 1\nf 1 2 1\n"
"""A model with a box round it, but no area."""


def finer(mesh: Mesh) -> Mesh:
    """Every triangle cut into four."""
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    corners = np.stack([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca], 1).reshape(-1, 3)
    return Mesh(corners, np.arange(len(corners)).reshape(-1, 3))


def block(times: int = 0, size: tuple[float, float, float] = (2.0, 1.0, 1.5)) -> Part:
    mesh = box((-size[0] / 2, -size[1] / 2, 0), (size[0] / 2, size[1] / 2, size[2]))
    for _ in range(times):
        mesh = finer(mesh)
    return Part(WOOD, mesh.vertices, mesh.faces)


def warmth(pixels: NDArray[np.uint8]) -> Floats:
    """How much redder than blue each pixel is."""
    return pixels[..., 0].astype(float) - pixels[..., 2]


@given(
    st.integers(0, 2**32 - 1),
    st.floats(0.0, 2 * np.pi),
    st.floats(-0.2, 1.2),
    st.floats(0.01, 100.0),
)
def test_the_camera_sees_every_point_and_no_more_than_it_must(
    seed: int, turn: float, rise: float, size: float
) -> None:
    points = np.random.default_rng(seed).normal(size=(40, 3)) * [1.0, 0.3, 2.0] * size
    way = np.array([np.cos(turn) * np.cos(rise), np.sin(turn) * np.cos(rise), np.sin(rise)])
    camera = facing(points, way)
    view = view_of(camera, 100, 100)
    local = (points - np.array(camera.eye)) @ view.axes.T.astype(float)
    seen = local[:, :2] / local[:, 2:] / view.across
    assert np.all(local[:, 2] > 0)
    assert np.abs(seen).max() < 1.0
    assert np.abs(seen).max() > 0.8
    middle = (seen.min(0) + seen.max(0)) / 2
    assert np.abs(middle).max() < 0.02


def test_the_sun_is_over_the_left_shoulder() -> None:
    for turn in np.linspace(0, 6, 9):
        way = np.array([np.cos(turn), np.sin(turn), 0.2])
        sun = np.array(sun_of(way))
        right = np.cross([0.0, 0.0, 1.0], way)
        assert sun @ way > 0
        assert sun @ right < 0
        assert sun[2] > 0


def test_heat_rises_from_pale_to_red() -> None:
    shades = heat(np.linspace(-1.0, 3 * HOTTEST, 60))
    assert np.all(np.diff(shades[:, 0] - shades[:, 2])[:15] >= 0)
    assert np.allclose(shades[0], heat(np.array([0.0]))[0])
    assert np.allclose(shades[-1], heat(np.array([HOTTEST]))[0])
    assert len(RAMP) == 4


def test_edges_are_warm_and_faces_pale_however_they_are_cut() -> None:
    coarse, fine = (portrait("block", [block(times)], 96) for times in (0, 3))
    assert coarse.faces == 12
    assert fine.faces == 12 * 64
    assert coarse.quality == pytest.approx(fine.quality, rel=0.1)
    warm = warmth(coarse.salient)
    assert np.percentile(warm, 97) > 60
    assert np.abs(np.median(warm)) < 12
    alike = np.abs(warm - warmth(fine.salient))
    assert np.percentile(alike, 90) < 25, "colours do not follow the triangles"


def test_plain_pictures_have_the_model_s_colour_and_size_does_not_matter() -> None:
    small, large = (portrait("b", [block(0, (2 * k, k, 1.5 * k))], 64) for k in (0.01, 50.0))
    assert warmth(small.plain).max() > 40
    alike = np.abs(small.plain.astype(float) - large.plain).mean()
    assert alike < 3.0
    assert np.allclose(small.way, large.way, atol=0.3)


def test_what_is_all_glass_still_has_a_form() -> None:
    glass = Part(Material("glass", (0.5, 0.7, 0.9), opacity=0.2), block().vertices, block().faces)
    shades = portrait("pane", [glass], 64).plain[20:44, 20:44].reshape(-1, 3)
    assert np.ptp(shades.sum(1).astype(float)) > 60


def test_what_has_no_area_is_told_by_name() -> None:
    part = Part(WOOD, np.zeros((3, 3)), np.array([[0, 1, 2]]))
    with pytest.raises(InputError, match=r"nothing.*no face with an area"):
        portrait("nothing", [part], 64)


def test_sheets_hold_every_portrait_where_it_belongs() -> None:
    for count in (1, 7, MOST):
        side = side_of(count)
        shots = [
            Portrait(
                f"{k} " + "long name " * 20,
                np.full((side, side, 3), k, np.uint8),
                np.full((side, side, 3), 100 + k, np.uint8),
                0.5,
                np.array([0, 1.0, 0]),
                1,
                9,
            )
            for k in range(count)
        ]
        page = sheet(shots, "picture", 99)
        grey = np.ptp(page, axis=2) == 0
        held = np.bincount(page[grey][:, 0], minlength=256)
        assert np.all(held[:count] >= side * side), "whole, nothing drawn over it"
        assert np.all(held[100 : 100 + count] >= side * side)
        assert 0.5 < page.shape[1] / page.shape[0] < 2.6
        assert max(page.shape) <= 2500


@given(st.integers(1, MOST))
def test_columns_never_leave_a_row_empty(count: int) -> None:
    columns = columns_of(count)
    assert 1 <= columns <= count


def test_view_draws_files_folders_and_shipped_assets(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    put(tmp_path, "kit.obj", obj_text())
    put(tmp_path, "line.obj", LINE)
    put(tmp_path, "broken.stl", "no model")
    out = tmp_path / "new" / "sheet.png"
    code = run(["view", str(tmp_path), "stool", "-o", str(out), "--json"])
    told = json.loads(capsys.readouterr().out)
    assert code == 1, "something was left out"
    assert [row["name"] for row in told["models"]] == ["kit", "Stool"]
    assert max(row["share"] for row in told["models"]) == 1
    assert {Path(one["name"]).name for one in told["skipped"]} == {"broken.stl", "line.obj"}
    with Image.open(out) as image:
        assert image.format == "PNG"
    assert [file.name for file in out.parent.iterdir()] == ["sheet.png"]


def test_view_tells_people_what_it_drew(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "sheet.png"
    assert run(["view", "stool", "-o", str(out), "--measure", "entropy"]) == 0
    told = capsys.readouterr().out
    assert "Stool" in told
    assert "sheet.png" in told.replace("\n", "")


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["sofa", "-o", "sheet.jpg"], "sheet.jpg: sheets are .png files"),
        (["sofa"], "-o"),
        (["throne", "-o", "a.png"], "no file, folder or asset 'throne'"),
        (["sofa", "-o", "a.png", "--measure", "beauty"], "unknown measure 'beauty'"),
        (["line.obj", "-o", "a.png"], "line.obj: the mesh has no face with an area"),
        (["notes.txt", "-o", "a.png"], "notes.txt: '.txt' models are not read"),
        (["empty", "-o", "a.png"], "empty: holds no model files"),
        (["kit.obj", "-o", "a.png", "--up", "y"], "'y' is not a direction"),
        (["kit.obj", "-o", "file/a.png"], "cannot be written"),
    ],
)
def test_view_faults_are_one_line_and_write_nothing(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    told: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    put(tmp_path, "kit.obj", obj_text())
    put(tmp_path, "line.obj", LINE)
    put(tmp_path, "notes.txt", "no model")
    put(tmp_path, "file", "in the way")
    (tmp_path / "empty").mkdir()
    before = sorted(tmp_path.rglob("*"))
    assert run(["view", *arguments]) == 2
    error = capsys.readouterr().err
    assert told in error
    assert len(error.splitlines()) == 1
    assert sorted(tmp_path.rglob("*")) == before


@only_thorough
@pytest.mark.realdata
def test_the_best_view_of_a_bunny_shows_its_ears_warm(real_data: Path) -> None:
    from scenewright.catalog.models import load

    model = load(real_data / "meshes_classic" / "stanford-bunny.obj")
    shot = portrait(model.name, model.parts, 128)
    top, bottom = warmth(shot.salient)[10:50].max(), np.median(warmth(shot.salient)[100:])
    assert top > bottom + 40
