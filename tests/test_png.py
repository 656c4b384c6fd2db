"""Pictures: the caster against a slow exact one, light that behaves, cameras that see it all."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from PIL import Image

from flat import flat_solution
from scenewright.catalog.assets import shipped
from scenewright.core.catalog import Material
from scenewright.domains import scene_of
from scenewright.formats.png import frame_points, picture, write
from scenewright.geometry import rays
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.prisms import box, corner_normals
from scenewright.render import light
from scenewright.render.picture import Camera, develop_image, render, view_of
from scenewright.render.stage import PartTriangles, stage_of

WHITE = Material("white", (0.9, 0.9, 0.9))
RED = Material("red", (0.8, 0.1, 0.1))
PANE = Material("pane", (0.2, 0.4, 0.9), opacity=0.5)
Floats = NDArray[np.float64]


def block(material: Material, mesh: Mesh) -> PartTriangles:
    return PartTriangles(material, mesh.vertices, mesh.faces, corner_normals(*mesh[:2]))


def taken(*blocks: PartTriangles, width: int = 160, height: int = 120) -> NDArray[np.int64]:
    """A picture straight down on ``blocks`` from 20 m, 8 m wide."""
    bounds = np.vstack([b.vertices for b in blocks])
    camera = Camera((0, -0.01, 20.0), (0, 0, 0), float(2 * np.arctan(4 / 20)))
    return render(stage_of(blocks, bounds), camera, width, height).astype(np.int64)


def met_slowly(triangles: Floats, start: Floats, way: Floats) -> tuple[float, int]:
    """Distance and index of the first triangle met: T. Moeller and B. Trumbore (1997)."""
    best, which = np.inf, -1
    for index, (a, b, c) in enumerate(triangles):
        matrix = np.stack([b - a, c - a, -way], 1)
        if abs(np.linalg.det(matrix)) < 1e-9:
            continue
        u, v, t = np.linalg.solve(matrix, start - a)
        if u >= 0 and v >= 0 and u + v <= 1 and 1e-9 < t < best:
            best, which = t, index
    return best, which


def test_rays_meet_what_a_slow_search_finds() -> None:
    rng = np.random.default_rng(7)
    triangles = rng.uniform(-1, 1, (40, 3, 3))
    starts, ways = rng.uniform(-2, 2, (200, 3)), rng.normal(size=(200, 3))
    caster = rays.build(triangles.reshape(-1, 3), np.arange(120).reshape(-1, 3))
    distance, face, normal = rays.hits(caster, starts, ways)
    slow = [met_slowly(triangles, s, w) for s, w in zip(starts, ways, strict=True)]
    assert face.tolist() == [which for _, which in slow]
    assert np.allclose(distance, [t for t, _ in slow], rtol=1e-3)
    assert np.allclose(np.linalg.norm(normal[face >= 0], axis=1), 1, atol=1e-5)
    assert rays.is_occluded(caster, starts, ways).tolist() == [which >= 0 for _, which in slow]
    near = [t < 0.8 for t, _ in slow]
    assert rays.is_occluded(caster, starts, ways, 0.8).tolist() == near
    assert 10 < sum(near) < sum(which >= 0 for _, which in slow)


def test_nothing_is_met_where_there_is_nothing() -> None:
    caster = rays.build(np.zeros((0, 3)), np.zeros((0, 3)))
    assert rays.first(caster, [[0, 0, 0]], [[0, 0, 1]]).tolist() == [-1]
    assert rays.is_occluded(caster, [[0, 0, 0]], [[0, 0, 1]]).tolist() == [False]


def test_samples_are_stratified_in_every_quarter_of_a_tile() -> None:
    points = light.samples().reshape(8, 8, 5)
    assert np.allclose(np.linalg.norm(points[..., 2:], axis=-1), 1)
    assert points[..., 4].mean() == pytest.approx(2 / 3, abs=0.01)
    for axis in range(2):
        assert sorted((points[..., axis].ravel() * 64).astype(int).tolist()) == list(range(64))
    for part in (points[:4, :4], points[4:, :4], points[:4, 4:], points[4:, 4:]):
        assert np.bincount((part[..., 0].ravel() * 4).astype(int)).tolist() == [4, 4, 4, 4]


def test_averaging_keeps_to_one_surface_and_one_row() -> None:
    keys = np.array([1] * 10 + [2] * 10 + [1] * 20, np.int32)
    values = np.column_stack([keys == 2, np.arange(40)]).astype(np.float32)
    out = np.zeros_like(values)
    light.average(keys, 20, 1, values, out)
    assert out[:, 0].tolist() == (keys == 2).tolist()
    assert out[19, 1] == np.mean([15, 16, 17, 18, 19])
    assert out[20, 1] == np.mean([20, 21, 22, 23])
    light.average(keys, 20, 20, values, out)
    assert out[0, 1] == np.mean([0, 20])
    assert out[10, 1] == 10


def test_a_block_is_where_the_camera_says_and_casts_its_shadow_away_from_the_sun() -> None:
    shown = taken(block(RED, box((-1, -1, -0.2), (1, 1, 2))))
    middle = shown[60, 80]
    assert middle[0] > 2 * middle[1]
    page = shown[5, 5]
    assert (page > 225).all()
    assert np.abs(shown[:, 80 + 60] - page).max() < 6
    left, right = shown[60, 80 - 32], shown[60, 80 + 32]
    assert right.sum() < left.sum() - 60


def test_shade_gathers_in_a_corner() -> None:
    floor = block(WHITE, box((-3, -3, -0.2), (3, 3, 0)))
    wall = block(RED, box((2.4, -3, 0), (2.8, 3, 1.5)))
    shown = taken(floor, wall, width=320, height=240)
    lit = shown[120, 60].sum()
    near, far = shown[120, 160 + 88].sum(), shown[120, 160 + 50].sum()
    assert near < far < lit + 3


def test_glass_tints_what_is_behind_it_and_lets_the_sun_through() -> None:
    floor = block(WHITE, box((-3, -3, -0.2), (3, 3, 0)))
    pane = block(PANE, box((-1, -1, 1.0), (1, 1, 1.02)))
    plain, glazed = taken(floor), taken(floor, pane)
    assert glazed[60, 80, 2] - glazed[60, 80, 0] > 20 > plain[60, 80, 2] - plain[60, 80, 0]
    beside = (slice(40, 80), slice(80 + 24, 80 + 40))
    assert np.abs(glazed[beside] - plain[beside]).max() <= 2


def test_light_becomes_srgb() -> None:
    ramp = np.linspace(0, 4, 200, dtype=np.float32)[:, None].repeat(3, 1)
    coded = develop_image(ramp)[:, 0].astype(int)
    assert (np.diff(coded) >= 0).all()
    assert develop_image(np.full((1, 3), 0.2140, np.float32))[0, 0] == pytest.approx(128, abs=1)
    assert coded[0] == 0
    assert coded[-1] == 255


@given(st.tuples(*[st.floats(0.5, 30.0)] * 3), st.tuples(*[st.floats(-50, 50)] * 3))
def test_the_camera_sees_the_whole_home(
    size: tuple[float, float, float], at: tuple[float, float, float]
) -> None:
    points = np.array(at) + np.array(size) * np.array(list(np.ndindex(2, 2, 2)), float)
    camera, shape = frame_points(points)
    view = view_of(camera, 1600, 1600)
    away = (points - np.array(camera.eye)) @ view.axes.T.astype(float)
    x, y = away[:, 0] / away[:, 2] / view.across, away[:, 1] / away[:, 2] / view.across
    assert away[:, 2].min() > 0
    assert np.abs(x).max() < 1
    assert np.abs(y).max() < max(shape, 0.0)
    assert max(np.abs(x).max(), np.abs(y).max() / (1140 / 1600)) > 0.85


def test_the_picture_of_a_flat_shows_rooms_and_is_the_same_each_time(tmp_path: Path) -> None:
    scene = scene_of(flat_solution())
    first = picture(scene, shipped(), 320)
    assert (picture(scene, shipped(), 320) == first).all()
    assert first.std() > 20
    corner = first[:8, :8].reshape(-1, 3).astype(int)
    assert corner.min() > 225
    write(flat_solution(), tmp_path / "flat.png")
    with Image.open(tmp_path / "flat.png") as image:
        assert image.size[0] == 1440
    assert [path.name for path in tmp_path.iterdir()] == ["flat.png"]
