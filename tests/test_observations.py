"""Observations: against a slow caster on the GLB, poses, clearance, the same bytes, bad input."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest
from benchmarks.slow_rays import meet_slowly, triangles_of_glb
from numpy.typing import NDArray
from PIL import Image

import scenewright as sw
from flat import flat_solution
from scenewright import cli
from scenewright.catalog.assets import shipped
from scenewright.core.solution import unfurnished
from scenewright.domains import scene_of
from scenewright.formats.glb import encode_scene
from scenewright.geometry import rays
from scenewright.geometry.distance_raster import walls_between
from scenewright.render.observations.ceilings import ceilings
from scenewright.render.observations.views import KINDS, Observation, pose_of
from scenewright.workflow.observe import Observations, named_rooms, observe

SIZE, FOV = (64, 48), float(np.deg2rad(75))
LIVING, BEDROOM = (3.0, 1.2, 1.5, 2.2, -0.2), (7.2, 1.0, 1.5, 1.9, 0.1)
Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def flat() -> Observations:
    return observe(flat_solution(), size=SIZE, poses=[LIVING, BEDROOM], cameras=2, seed=5)


@pytest.fixture(scope="module")
def views(flat: Observations) -> list[Observation]:
    return list(flat.views())


def ways_of(view: Observation, size: tuple[int, int] = SIZE, fov: float = FOV) -> Floats:
    """Directions through the middles of all pixels by the written pose and intrinsics."""
    focal = size[0] / 2 / np.tan(fov / 2)
    u, v = np.meshgrid(np.arange(size[0]) + 0.5, np.arange(size[1]) + 0.5)
    local = np.stack([(u - size[0] / 2) / focal, (v - size[1] / 2) / focal, np.ones(u.shape)], -1)
    return local.reshape(-1, 3) @ pose_of(view.viewpoint)[:3, :3].T


def test_depth_and_masks_are_those_of_a_slow_caster_on_the_glb(
    flat: Observations, views: list[Observation]
) -> None:
    scene = scene_of(flat_solution())
    triangles, names = triangles_of_glb(encode_scene(scene, shipped(), batched=False))
    above = [(one.name, p.vertices[p.faces]) for one in ceilings(scene) for p in one.parts]
    ground = np.array([[-99, -99, 0], [99, -99, 0], [0, 199, 0]]) - [0, 0, 0.222]
    every = np.concatenate([triangles, *(corners for _, corners in above), ground[None]])
    names += [name for name, corners in above for _ in corners]
    names += ["ground", ""]
    wrong, pixels = 0, 0
    for view in views[:3]:
        away, which = meet_slowly(every, np.array(view.viewpoint.eye), ways_of(view))
        depth = np.where(np.isfinite(away), away, 0.0)
        assert view.depth is not None
        assert view.instance is not None
        ids = ["", *(one.id for one in flat.world.instances)]
        same = [ids[k] == names[w] for k, w in zip(view.instance.ravel(), which, strict=True)]
        wrong += int((~np.array(same) | (np.abs(view.depth.ravel() - depth) > 1e-3)).sum())
        pixels += len(away)
    assert wrong <= 0.001 * pixels


def test_a_corner_of_a_room_is_where_pose_and_intrinsics_put_it(flat: Observations) -> None:
    seen = observe(flat_solution(), size=(640, 480), poses=[BEDROOM], kinds=["normals", "depth"])
    (view,) = seen.views()
    pose = pose_of(view.viewpoint)
    corner = np.array([8.2, 4.0, 2.6])
    x, y, z = pose[:3, :3].T @ (corner - pose[:3, 3])
    focal = seen.taken.lens.focal
    u, v = focal * x / z + 320, focal * y / z + 240
    assert 10 < u < 630
    assert 10 < v < 470
    assert view.normals is not None
    assert view.depth is not None
    near = view.normals[int(v) - 3 : int(v) + 4, int(u) - 3 : int(u) + 4].reshape(-1, 3)
    assert {tuple(row) for row in near.round().tolist()} == {(-1, 0, 0), (0, -1, 0), (0, 0, -1)}
    assert view.depth[int(v), int(u)] == pytest.approx(z, abs=0.03)


def test_normals_are_unit_and_face_the_camera(views: list[Observation]) -> None:
    for view in views:
        assert view.normals is not None
        assert view.instance is not None
        normals = view.normals.reshape(-1, 3)[view.instance.ravel() > 0]
        ways = ways_of(view)[view.instance.ravel() > 0]
        assert np.allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)
        assert (np.einsum("ij,ij->i", normals, ways) < 1e-4).all()


def test_classes_are_those_of_the_instances(flat: Observations, views: list[Observation]) -> None:
    table = {one.instance: one for one in flat.world.instances}
    assert {"sofa", "floor", "ceiling", "wall", "door", "window", "ground"} <= {
        one.category for one in table.values()
    }
    for view in views:
        assert view.instance is not None
        assert view.semantic is not None
        for number in set(view.instance.ravel().tolist()) - {0}:
            here = view.semantic[view.instance == number]
            assert set(here.tolist()) == {table[number].semantic}
    assert len({one.id for one in flat.world.instances}) == len(flat.world.instances)


def test_cameras_stand_free_and_see_more_than_a_wall() -> None:
    seen = observe(flat_solution(), size=SIZE, cameras=6, seed=1, kinds=["depth", "instance"])
    assert {one.room for one in seen.viewpoints} == {"living", "bedroom"}
    for view in seen.views():
        assert view.depth is not None
        assert view.viewpoint.clearance is not None
        assert view.viewpoint.clearance >= 0.2
        assert nearest(seen, view.viewpoint.eye) >= 0.2
        assert (view.depth[view.depth > 0] < 0.5).mean() < 0.15


def nearest(seen: Observations, eye: tuple[float, float, float]) -> float:
    """How near anything is at the height of an eye or lower, by rays around it."""
    turns = np.linspace(0, 2 * np.pi, 360, endpoint=False)
    ways = np.column_stack([np.cos(turns), np.sin(turns), np.zeros(360)])
    found = []
    for z in np.arange(eye[2], eye[2] - 1.3, -0.1):
        start = np.broadcast_to(np.array([*eye[:2], z]), ways.shape)
        found.append(float(rays.hits(seen.world.every, start, ways)[0].min()))
    return min(found) + 1e-4


@pytest.mark.parametrize("clearance", [0.15, 0.25])
def test_a_trajectory_keeps_its_clearance_through_the_door(clearance: float) -> None:
    seen = observe(flat_solution(), trajectory=80, clearance=clearance, seed=2)
    assert len(seen.viewpoints) == 80
    assert {one.room for one in seen.viewpoints} == {"living", "bedroom", ""}
    eyes = np.array([one.eye for one in seen.viewpoints])
    steps = np.diff(eyes, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    assert lengths.max() < 1.2 * np.median(lengths)
    assert not rays.is_occluded(seen.world.every, eyes[:-1], steps, 1.0).any()
    for one in seen.viewpoints:
        assert one.clearance is not None
        assert min(one.clearance, nearest(seen, one.eye)) >= clearance
    turns = np.abs(np.diff([one.yaw for one in seen.viewpoints]))
    assert turns.max() < np.pi * lengths.max(), "turns by less than half a circle a metre"


def test_a_wall_with_many_doors_is_cut_at_each() -> None:
    wall = np.array([[0.0, 0.0, 90.0, 0.0], [0.0, 9.0, 90.0, 9.0]])
    doors = np.array([[3.0 * k + 1.5, 0.0, np.pi / 2, 1.0, 0.2] for k in range(30)])
    assert len(walls_between(wall, doors)) == 32


def test_the_same_seed_gives_the_same_bytes(tmp_path: Path) -> None:
    for name in ("a", "b"):
        observe(flat_solution(), tmp_path / name, size=(32, 24), cameras=2, trajectory=2, seed=9)
    files = sorted(path.name for path in (tmp_path / "a").iterdir())
    assert len(files) == 4 * 6 + 1
    for name in files:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
    more = observe(flat_solution(), size=(32, 24), cameras=3, seed=9)
    less = observe(flat_solution(), size=(32, 24), cameras=2, seed=9)
    assert more.viewpoints[:2] == less.viewpoints


def test_files_hold_what_was_seen(tmp_path: Path) -> None:
    sw.write(flat_solution(), tmp_path / "flat.json")
    folder = tmp_path / "seen"
    arguments = ["render", str(tmp_path / "flat.json"), "-o", str(folder), "--size", "64x48"]
    assert cli.run([*arguments, "--cameras", "1", "--seed", "4", "--room", "Bedroom", "-q"]) == 0
    document = json.loads((folder / "observations.json").read_text())
    (camera,) = document["cameras"]
    assert camera["room"] == "bedroom"
    assert document["scene"]["brief_hash"] == flat_solution().brief_hash
    (view,) = observe(flat_solution(), size=SIZE, cameras=1, seed=4, rooms=["bedroom"]).views()
    with np.load(folder / camera["files"]["arrays"]) as arrays:
        for kind in KINDS[1:]:
            assert np.array_equal(arrays[kind], getattr(view, kind))
    assert np.allclose(camera["pose"], pose_of(view.viewpoint))
    with Image.open(folder / camera["files"]["depth"]) as picture:
        assert np.abs(np.array(picture) / 1000 - view.depth).max() <= 0.00051
    with Image.open(folder / camera["files"]["rgb"]) as picture:
        assert np.array_equal(np.array(picture), view.rgb)
    assert cli.run([*arguments, "--cameras", "2", "-q"]) == 0, "replaces its own files"


def test_under_a_roof_no_ray_is_lost_and_its_windows_are_seen() -> None:
    attic = unfurnished(sw.read("sample:home-attic"))
    scene = scene_of(attic)
    room, pane = next((s, o) for s in scene.spaces for o in s.openings if o.roof)
    (x, y), z = room.outline.mean(0), scene.levels[0].elevation + 1.5
    pose = (x, y, z, float(np.arctan2(pane.y - y, pane.x - x)), 0.3)
    seen = observe(attic, size=(96, 96), poses=[pose], fov=1.6)
    (view,) = seen.views()
    assert view.instance is not None
    kinds = {one.instance: one.kind for one in seen.world.instances} | {0: "nothing"}
    met = {kinds[number] for number in view.instance.ravel().tolist()}
    assert {"ceiling", "window"} <= met
    assert "nothing" not in met


def test_a_room_is_called_by_a_word_of_its_name() -> None:
    scene = scene_of(unfurnished(sw.read("sample:home-flat")))
    dining = {space.id for space in scene.spaces if "dining" in space.name.lower()}
    assert named_rooms(scene, ["Dining"]) == dining != frozenset()


HOSTILE = [
    (["--cameras", "0"], "--cameras 0 cannot be used"),
    (["--cameras", "-3"], "--cameras -3"),
    (["--cameras", "1000000"], "give 10,000"),
    (["--trajectory", "-1"], "--trajectory -1"),
    (["--size", "1000000x1000000"], "--size 1000000x1000000"),
    (["--size", "0x0"], "--size 0x0"),
    (["--size", "big"], "is no size"),
    (["--fov", "0"], "--fov 0"),
    (["--fov", "nan"], "--fov nan"),
    (["--clearance", "1.3", "--room", "Bedroom"], "no floor is free"),
    (["--trajectory", "5", "--clearance", "1.3", "--room", "Bedroom"], "no way is free"),
    (["--eye", "nan"], "--eye nan"),
    (["--eye", "2.58"], "no floor is free"),
    (["--room", "Ballroom"], "there is no room 'Ballroom'"),
    (["--camera", "1,2"], "is no pose"),
    (["--camera", "nan,1,1,0,0"], "plain numbers"),
    (["--camera", "1e300,1,1,0,0"], "plain numbers"),
    (["--camera", "2,1,1,0,120"], "a pitch of -90 to 90"),
    (["--camera", "0.5,2.4,0.25,0,0"], "is inside sofa"),
    (["--camera", "5.06,1,1,0,0"], "is inside "),
    (["--camera", "2,2,-0.1,0,0"], "is inside "),
    (["--seed", "-1"], "--seed -1"),
    (["--steps", "0"], "--steps"),
]


@pytest.mark.parametrize(("options", "words"), HOSTILE, ids=[" ".join(o) for o, _ in HOSTILE])
def test_bad_input_is_one_line(
    options: list[str], words: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    sw.write(flat_solution(), tmp_path / "flat.json")
    folder = tmp_path / "seen"
    assert cli.run(["render", str(tmp_path / "flat.json"), "-o", str(folder), *options]) == 2
    said = capfd.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    assert words in said.err
    assert not folder.exists()


def test_folders_are_not_taken_from_others(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    sw.write(flat_solution(), tmp_path / "flat.json")
    (tmp_path / "file").write_text("mine")
    line = ["render", str(tmp_path / "flat.json"), "--size", "8x8", "--cameras", "1", "-o"]
    assert cli.run(["render", str(tmp_path), "-o", str(tmp_path / "x")]) == 2
    assert "is a folder; give a saved solution" in capfd.readouterr().err
    for folder, words in ((tmp_path / "file", "is not a folder"), (tmp_path, "holds other files")):
        assert cli.run([*line, str(folder)]) == 2
        assert words in capfd.readouterr().err
    assert (tmp_path / "file").read_text() == "mine"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "flat.json"]
    site = ["render", "sample:site-30", "-o", str(tmp_path / "site")]
    assert cli.run(site) == 2
    assert "the brief is of a site" in capfd.readouterr().err


def test_a_disk_that_fills_leaves_nothing(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("needs Linux")
    sw.write(flat_solution(), tmp_path / "flat.json")
    import resource

    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, before[1]))
    try:
        code = cli.run(["render", str(tmp_path / "flat.json"), "-o", str(tmp_path / "seen"), "-q"])
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert code == 2
    assert "cannot be written" in capfd.readouterr().err
    assert os.listdir(tmp_path) == ["flat.json"]
