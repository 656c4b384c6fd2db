"""Photographs: light against closed formulas, upright verticals, less noise, same seed the same."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import scenewright as sw
from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Material, Part
from scenewright.core.errors import InputError
from scenewright.domains import scene_of
from scenewright.geometry.prisms import box
from scenewright.render.items import things
from scenewright.render.lamps import lamps_of
from scenewright.render.observations.world import VisibleWorld, build_world
from scenewright.render.photo.denoising import smooth_film
from scenewright.render.photo.developing import develop
from scenewright.render.photo.following import Exposure, expose
from scenewright.render.photo.panes import pass_panes
from scenewright.render.photo.photograph import views_of
from scenewright.render.photo.sources import Sources, find_sources
from scenewright.render.photo.standpoints import EYE, frame_of, stand_in_rooms
from scenewright.render.picture import PAGE, build_casters
from scenewright.render.stage import PartTriangles, stage_of
from scenewright.render.textures.table import bake, texture_of
from scenewright.render.textures.worn import wear_textures
from scenewright.workflow.cycles import job_of

GREY = Material("grey", (0.5, 0.5, 0.5), roughness=1.0)
ALBEDO = float(((0.5 + 0.055) / 1.055) ** 2.4)
SUN = np.array([[0, 0, 0], [0, 0, 0], [0, 0.6, 0.8], [9, 9, 9]], np.float32)
NO_SUN = np.vstack([SUN[:3], np.zeros((1, 3))]).astype(np.float32)
SKY = np.full((3, 3), 2.0, np.float32)


@pytest.fixture(scope="module")
def floor_world() -> VisibleWorld:
    """Nothing but a wide grey floor at 0."""
    solid = box((-40, -40, -0.1), (40, 40, 0.0))
    normals = np.repeat(np.cross(*_edges(solid.vertices[solid.faces]))[:, None], 3, 1)
    normals /= np.linalg.norm(normals, axis=2, keepdims=True)
    block = PartTriangles(GREY, solid.vertices, solid.faces, normals)
    stage = stage_of([block], np.array([[-40.0, -40, -1], [40, 40, 3]]), PAGE)
    return VisibleWorld(None, stage, build_casters(stage), stage, None, ())  # type: ignore[arg-type]


def _edges(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]


def _sources(world: VisibleWorld, sun: np.ndarray, rows: list[list[float]], room: int) -> Sources:
    """One raster cell of 80 m, in a room or in the open."""
    return Sources(
        sun,
        SKY,
        np.array(rows, np.float32).reshape(-1, 11),
        np.ones((1, 1), np.float32),
        np.full((1, 1), room, np.int32),
        np.array([-40, -40, 80], np.float32),
        world.stage.table,
    )


def _light_below(world: VisibleWorld, sources: Sources, samples: int = 64) -> float:
    """The light of the floor right before the camera's foot."""
    camera = frame_of((0.0, -1.0, 1.0), np.pi / 2, (9, 9))
    camera = camera._replace(frame=np.array([-0.01, -0.99, 0.0022], np.float32))
    return float(expose(world, sources, camera, samples).light[..., 1].mean())


def test_sun_and_sky_light_open_ground_as_by_the_cosine(floor_world: VisibleWorld) -> None:
    sources = _sources(floor_world, SUN, [], -1)
    expected = ALBEDO * (9.0 * 0.8 / np.pi + 2.0)
    assert _light_below(floor_world, sources) == pytest.approx(expected, rel=0.02)


@pytest.mark.parametrize("name", ["oak", "tile floor"])
def test_the_eye_sees_the_texture_of_a_floor_at_its_place(
    floor_world: VisibleWorld, name: str
) -> None:
    part = Part(Material(name, GREY.color), *box((-40, -40, -0.1), (40, 40, 0.0)))
    worn = wear_textures([part], len(floor_world.stage.corners))
    sources = _sources(floor_world, SUN, [], -1)
    camera = frame_of((0.0, -1.0, 1.0), np.pi / 2, (9, 9))
    near = camera._replace(frame=np.array([-0.01, -0.99, 0.0022], np.float32))
    seen = expose(floor_world, sources, near, 32, worn).body[..., 1].mean() / ALBEDO
    tone = bake(worn_name(name)).tone[..., 1]
    top = np.flatnonzero((part.vertices[part.faces][:, :, 2] == 0).all(1))[0]
    corner, place = part.vertices[part.faces[top]], worn.places[top].astype(float)
    frame = np.linalg.solve(np.column_stack([corner[:, :2], np.ones(3)]), place)
    y = 1 / np.linspace(0.99, 0.99 + 9 * 0.0022, 40) - 1
    grid = np.stack(np.meshgrid(np.linspace(-0.01, 0.0098, 40), y), -1).reshape(-1, 2)
    spots = np.column_stack([grid, np.ones(len(grid))]) @ frame % 1.0
    high, wide = tone.shape
    expected = tone[(spots[:, 1] * high).astype(int), (spots[:, 0] * wide).astype(int)].mean()
    assert seen == pytest.approx(expected, rel=0.02)
    far = camera._replace(frame=np.array([-0.5, -0.03, 0.1], np.float32), width=9, height=1)
    assert expose(floor_world, sources, far, 8, worn).body[..., 1].mean() == pytest.approx(
        ALBEDO, rel=0.03
    ), "from afar the mean"


def worn_name(material: str) -> str:
    row = texture_of(material)
    assert row is not None
    return row.name


def test_a_lamp_lights_by_the_inverse_square(floor_world: VisibleWorld) -> None:
    for height in (1.0, 2.0, 4.0):
        lamp = [0, 1, 0, 0, height, 0.01, 5, 5, 5, 0, 0]
        sources = _sources(floor_world, NO_SUN, [lamp], 0)
        expected = ALBEDO / np.pi * 5.0 / height**2
        assert _light_below(floor_world, sources) == pytest.approx(expected, rel=0.03)


def test_a_window_lights_the_floor_as_its_integral_says(floor_world: VisibleWorld) -> None:
    window = [0, 1, 0, 3, 1.5, 0, 0, 1, 2.0, 1.2, 0.8]
    sources = _sources(floor_world, NO_SUN, [window], 0)
    x, z = np.meshgrid((np.arange(200) + 0.5) / 100 - 1, 0.9 + (np.arange(120) + 0.5) / 100)
    square = x**2 + 9.0 + z**2
    falling = float((z * 3.0 / square**2).sum() * 1e-4)
    expected = ALBEDO / np.pi * 0.8 * 2.0 * falling
    assert _light_below(floor_world, sources, 256) == pytest.approx(expected, rel=0.03)


def test_a_pane_mirrors_by_fresnel_and_tints_the_rest(floor_world: VisibleWorld) -> None:
    pane = np.array([[[-9, -9, 1], [9, -9, 1], [0, 15, 1]]], np.float32)
    tints = np.array([[0.5, 0.5, 0.5, 0.4]], np.float32)
    stage = floor_world.stage._replace(glass=pane, tints=tints)
    world = floor_world._replace(stage=stage, casters=build_casters(stage))
    count = 4000
    starts = np.tile(np.array([0, 0, 2], np.float32), (count, 1))
    ways = np.tile(np.array([0, 0, -1], np.float32), (count, 1))
    through = np.ones((count, 3), np.float32)
    pass_panes(world, 0, 0, starts, ways, through)
    mirrored = ways[:, 2] > 0
    assert mirrored.mean() == pytest.approx(0.08, abs=0.015)
    assert (starts[mirrored, 2] > 1).all()
    assert np.allclose(through[~mirrored], 1 - 0.4 * 0.5)
    assert (through[mirrored] == 1).all()
    below = np.tile(np.array([0, 0, -5], np.float32), (count, 1))
    ways[:] = (0, 0, -1)
    pass_panes(world, 0, 0, below, ways, through)
    assert (ways[:, 2] == -1).all(), "nothing is beyond the floor"


def test_twice_the_light_is_twice_the_film(floor_world: VisibleWorld) -> None:
    lamp = [0, 1, 0, 0, 2.0, 0.01, 5, 5, 5, 0, 0]
    one = _sources(floor_world, SUN, [lamp], 0)
    sun, rows = SUN.copy(), one.sources.copy()
    sun[3] *= 2
    rows[:, 6:9] *= 2
    two = one._replace(sun=sun, sources=rows, sky=2 * one.sky)
    assert _light_below(floor_world, two) == pytest.approx(2 * _light_below(floor_world, one))


def test_verticals_stay_upright() -> None:
    camera = frame_of((1.0, 2.0, EYE), 0.7, (64, 40))
    foot = np.array([3.0, 3.1, 0.0]) - camera.eye
    columns = [(camera.axes @ (foot + np.array([0.0, 0.0, z])))[[0, 2]] for z in (0.0, 1.0, 2.5)]
    assert np.ptp([right / ahead for right, ahead in columns]) < 1e-6


def _film(seed: int, noise: float) -> Exposure:
    rng = np.random.default_rng(seed)
    light = np.ones((32, 32, 3), np.float32)
    light[:, 16:] = 0.25
    light *= rng.lognormal(0.0, noise, (32, 32, 1)).astype(np.float32)
    facing = np.zeros((32, 32, 3), np.float32)
    facing[:, :16, 2] = facing[:, 16:, 0] = 1.0
    return Exposure(light, np.full((32, 32, 3), 0.5, np.float32), facing)


def test_noise_goes_and_edges_stay() -> None:
    film = _film(1, 0.4)
    out = smooth_film(film)
    left, right = out[4:-4, 2:14], out[4:-4, 18:30]
    assert left.std() < 0.25 * film.light[4:-4, 2:14].std()
    assert left[:, -1].mean() / right[:, 0].mean() == pytest.approx(4.0, rel=0.25)


def test_even_light_stays_as_it_is() -> None:
    film = _film(0, 0.0)
    assert np.allclose(smooth_film(film), film.light, atol=0.03)


def test_a_picture_is_exposed_for_its_light() -> None:
    light = np.random.default_rng(0).lognormal(0, 0.6, (20, 30, 3)).astype(np.float32)
    dark, bright = develop(0.01 * light), develop(100 * light)
    assert np.abs(dark.astype(int) - bright).max() <= 1


@pytest.fixture(scope="module")
def room() -> sw.Solution:
    return sw.solve(sw.read("sample:home-room"), seed=0, steps=200)


def test_more_samples_come_nearer_and_the_same_are_the_same(room: sw.Solution) -> None:
    catalog = catalog_of(room.brief.catalogs)
    world = build_world(scene_of(room), catalog)
    ((space, floor, camera),) = stand_in_rooms(world, frozenset(), (48, 30))
    lit = [*lamps_of(things(world.scene, catalog), catalog)]
    sources = find_sources(world, floor, lit, "day", space.id)
    best = expose(world, sources, camera, 256).light
    few, more = (expose(world, sources, camera, n).light for n in (2, 32))
    errors = [float(np.abs(np.log((f + 0.01) / (best + 0.01))).mean()) for f in (few, more)]
    assert errors[1] < 0.6 * errors[0]
    assert np.array_equal(few, expose(world, sources, camera, 2).light)
    dusk = find_sources(world, floor, lit, "dusk", space.id)
    assert expose(world, dusk, camera, 4).light.mean() < 0.3 * best.mean()


def test_rooms_are_written_and_what_cannot_be_is_refused(room: sw.Solution, tmp_path: Path) -> None:
    (path,), _ = sw.photograph(room, tmp_path / "a.png", size=(40, 24), samples=1)
    with Image.open(path) as image:
        assert image.size == (40, 24)
    again = sw.photograph(room, tmp_path / "all", size=(40, 24), samples=1)
    assert again.written[0].read_bytes() == path.read_bytes()
    for fault, options in (
        ("--size", {"size": (4, 4)}),
        ("--samples", {"samples": 0}),
        ("hour", {"hour": "teatime"}),
        ("renderer", {"renderer": "crayons"}),
        ("no room", {"rooms": ["cellar"]}),
    ):
        with pytest.raises(InputError, match=fault):
            sw.photograph(room, tmp_path / "b.png", **options)
    with pytest.raises(InputError, match="rooms"):
        sw.photograph("sample:site-120", tmp_path / "c.png")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.png", "all"]


def test_blender_is_named_where_it_is_missing(
    room: sw.Solution, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(InputError, match="Blender") as fault:
        sw.photograph(room, tmp_path / "a.png", renderer="cycles")
    assert "apt-get install blender" in str(fault.value.remedy)


def test_blender_is_asked_for_the_same_picture(room: sw.Solution, tmp_path: Path) -> None:
    """Its camera sees a point where ours does, by the rule of its manual: the shift is a share of
    the wider side."""
    catalog = catalog_of(room.brief.catalogs)
    world = build_world(scene_of(room), catalog)
    (view,) = views_of(world, catalog, size=(64, 40))
    (asked,) = job_of([view], tmp_path / "a.glb", 4, 0)["views"]
    eye, axes = np.array(asked["eye"]), np.array(asked["axes"])
    right, up, ahead = axes @ (eye + 3 * axes[2] + 0.4 * axes[0] - 0.6 * axes[1] - eye)
    tangent = 2 * np.tan(asked["wide"] / 2)
    column = 64 * (0.5 + right / ahead / tangent)
    row = 20 - 64 * (up / ahead / tangent - asked["shift"])
    left, top, step = view.camera.frame
    assert (column, row) == pytest.approx(
        ((right / ahead - left) / step, (top - up / ahead) / step), abs=0.01
    )
    lit = len(asked["lamps"]) + len(asked["portals"])
    assert lit == len(view.sources.sources)
    assert asked["portals"], "the room has a window"
