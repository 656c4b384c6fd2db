"""Textures: without a seam, in metres, along the grain; each material that wears one exists."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from scenewright.building.finishes import FLOORS, SURFACES, WOOD_FLOOR, floor_of
from scenewright.building.palettes import PALETTES, list_coats
from scenewright.building.regions import REGIONS
from scenewright.catalog.assets import materials
from scenewright.core.catalog import Material, Part
from scenewright.core.space import Space
from scenewright.geometry.mesh import merge
from scenewright.geometry.prisms import box
from scenewright.render.textures.pictures import color_picture, normal_picture
from scenewright.render.textures.projection import boards_of, coordinates_of
from scenewright.render.textures.table import TEXTURES, WORN, bake, texture_of

OAK = Material("oak", (0.78, 0.66, 0.50))


@pytest.mark.parametrize("name", TEXTURES)
def test_a_texture_goes_on_beyond_its_edges_as_inside(name: str) -> None:
    tone = bake(name).tone
    assert tone.shape == (*TEXTURES[name].pixels, 3)
    assert tone.min() > 0
    assert np.allclose(tone.mean((0, 1), np.float64), 1.0, atol=3e-4)
    for axis in (0, 1):
        steps = np.abs(np.diff(tone, axis=axis)).mean((1 - axis, 2))
        seam = np.abs(tone.take(0, axis) - tone.take(-1, axis)).mean()
        assert seam <= max(steps.max() * 1.25, 0.004), "the seam is no edge that is not inside too"


@pytest.mark.parametrize("name", TEXTURES)
def test_a_texture_repeats_on_a_power_of_two_and_holds_whole_courses(name: str) -> None:
    row = TEXTURES[name]
    assert all(side & (side - 1) == 0 for side in row.pixels)
    for setting, length in zip(("wide", "long"), row.metres, strict=True):
        if setting in row.settings:
            count = length / row.settings[setting]
            assert count == pytest.approx(round(count)), f"{setting} of {name}"


def test_every_material_that_wears_a_texture_exists() -> None:
    values = [value for value in vars(materials).values() if isinstance(value, Material)]
    known = {
        one.name
        for one in (*values, *materials.PAINTINGS, *SURFACES.values(), *FLOORS.values(), WOOD_FLOOR)
    }
    known |= {one.name for row in REGIONS.values() for one in row[1:]}
    worn = {name.partition("/")[0] for name in WORN}
    built = {"door oak", "threshold", "slab concrete", "wall plaster", "meadow"}
    trees = {"crown", "light crown", "needles"}
    assert worn <= known | built | trees
    assert set(WORN.values()) <= set(TEXTURES)


def test_all_palettes_dress_wood_cloth_and_floors() -> None:
    for palette in PALETTES.values():
        coats = list_coats(palette)
        for plain in (materials.OAK, materials.FABRIC, WOOD_FLOOR):
            assert texture_of(coats[plain].name) is not None
    assert texture_of(list_coats(PALETTES["classic/pearl"])[WOOD_FLOOR].name) != texture_of(
        list_coats(PALETTES["nordic/fjord"])[WOOD_FLOOR].name
    ), "floors differ by style"


def test_the_grain_runs_along_each_board_in_metres() -> None:
    lying, standing = box((0, 0, 0), (2.0, 0.3, 0.02)), box((5, 0, 0), (5.3, 0.02, 1.8))
    part = Part(OAK, *merge([lying, standing]))
    places = coordinates_of(part, "grain")
    for rows, long, wide in ((slice(0, 12), 2.0, 0.3), (slice(12, 24), 1.8, 0.3)):
        spans = np.ptp(places[rows], axis=1)
        assert spans[:, 0].max() == pytest.approx(long)
        assert spans[:, 1].max() == pytest.approx(wide)
    assert len(set(boards_of(part.faces, len(part.vertices)).tolist())) == 2
    assert not np.allclose(places[0, 0] % 0.5, places[12, 0] % 0.5), "cut from other places"


def test_courses_lie_level_on_walls_and_slopes_of_any_direction() -> None:
    turn = 0.7
    level = np.array([np.cos(turn), np.sin(turn), 0.0])
    up = np.array([-np.sin(turn) * 0.6, np.cos(turn) * 0.6, 0.8])
    corners = np.array([0 * level, 3 * level, 3 * level + 2 * up, 2 * up])
    part = Part(OAK, corners, np.array([[0, 1, 2], [0, 2, 3]]))
    places = coordinates_of(part, "upright")
    assert np.ptp(places[0, :2, 0]) == pytest.approx(3.0)
    assert np.ptp(places[0, :2, 1]) == pytest.approx(0.0, abs=1e-9)
    assert np.ptp(places[0, 1:, 1]) == pytest.approx(2.0)


def test_pictures_give_the_tones_back_and_relief_has_unit_normals() -> None:
    picture = color_picture("bricks")
    pixels = np.asarray(Image.open(io.BytesIO(picture.content)), float) / 255
    light = np.where(pixels <= 0.04045, pixels / 12.92, ((pixels + 0.055) / 1.055) ** 2.4)
    assert np.abs((light * picture.factor).mean((0, 1)) - 1.0).max() < 0.03
    normals = np.asarray(Image.open(io.BytesIO(normal_picture("bricks"))), float) / 127.5 - 1
    assert np.abs(np.linalg.norm(normals, axis=-1) - 1).mean() < 0.05
    assert normals[..., 2].min() > 0
    assert normals[..., 0].std() > 0.05


def test_a_supermarket_and_a_church_stand_on_other_floors_than_a_home() -> None:
    area = np.array([[0.0, 0], [20, 0], [20, 15], [0, 15]])
    floors = {
        use: floor_of(Space("a", "", (use,), "0", area)).name
        for use in ("supermarket", "worship", "museum", "other")
    }
    assert len({texture_of(name) for name in floors.values()}) == 4, floors


def test_a_texture_is_kept_and_made_again_where_what_is_kept_is_damaged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SCENEWRIGHT_CACHE", str(tmp_path))
    made = bake.__wrapped__("mosaic")
    (file,) = (tmp_path / "textures").iterdir()
    written = file.stat().st_mtime_ns
    again = bake.__wrapped__("mosaic")
    assert file.stat().st_mtime_ns == written
    file.write_bytes(b"PK damaged")
    mended = bake.__wrapped__("mosaic")
    for tone, height in (again, mended):
        assert np.array_equal(tone, made.tone)
        assert np.array_equal(height, made.height)
    monkeypatch.setenv("SCENEWRIGHT_CACHE", str(file))
    assert np.array_equal(bake.__wrapped__("mosaic").tone, made.tone), "nowhere to keep it"
