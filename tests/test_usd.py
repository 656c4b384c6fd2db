"""USD files: valid by OpenUSD's own validators, and what is read back is what the scene holds."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("pxr")

from pxr import Usd, UsdGeom, UsdLux, UsdShade, UsdValidation

from flat import flat_brief, flat_solution
from scenewright import cli
from scenewright.catalog.assets import shipped
from scenewright.core.scene import Scene
from scenewright.core.solution import unfurnished
from scenewright.domains import scene_of
from scenewright.formats import write
from scenewright.formats.usd.names import prim_name
from scenewright.render.items import RenderItem, things, to_level_coordinates
from scenewright.render.lamps import lamps_of
from scenewright.render.observations.ceilings import ceilings
from scenewright.render.observations.world import build_world
from scenewright.render.photo.standpoints import stand_in_rooms

EVERYTHING = Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate)


@pytest.fixture(scope="module")
def scene() -> Scene:
    return scene_of(flat_solution())


@pytest.fixture(scope="module")
def items(scene: Scene) -> tuple[RenderItem, ...]:
    return (*things(scene, shipped()), *ceilings(scene))


@pytest.fixture(scope="module")
def stage(tmp_path_factory: pytest.TempPathFactory) -> Usd.Stage:
    path = tmp_path_factory.mktemp("usd") / "flat.usdc"
    write(flat_solution(), path)
    return Usd.Stage.Open(str(path))


def faults(stage: Usd.Stage) -> list[str]:
    """What the validators of OpenUSD find."""
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    return [error.GetErrorAsString() for error in context.Validate(stage)]


def prims(stage: Usd.Stage, kind: type) -> list[Usd.Prim]:
    """All prims of a kind, those of instances with them."""
    return [prim for prim in Usd.PrimRange(stage.GetPseudoRoot(), EVERYTHING) if prim.IsA(kind)]


def by_id(stage: Usd.Stage) -> dict[str, Usd.Prim]:
    """The prims that stand for things, by the ids these have in the scene."""
    facts = ((prim, prim.GetCustomDataByKey("scenewright")) for prim in stage.Traverse())
    return {str(known["id"]): prim for prim, known in facts if known}


@pytest.mark.parametrize("suffix", [".usda", ".usdc", ".usdz"])
def test_every_form_is_valid_and_the_same_bytes_twice(tmp_path: Path, suffix: str) -> None:
    one, two = tmp_path / f"one{suffix}", tmp_path / f"two{suffix}"
    for path in (one, two):
        write(flat_solution(), path)
    assert one.read_bytes() == two.read_bytes()
    opened = Usd.Stage.Open(str(one))
    assert faults(opened) == []
    assert UsdGeom.GetStageUpAxis(opened) == "Z"
    assert UsdGeom.GetStageMetersPerUnit(opened) == 1.0
    assert opened.GetDefaultPrim().GetPath() == "/Scene"


def test_a_fault_is_found() -> None:
    broken = Usd.Stage.CreateInMemory()
    UsdShade.Shader.Define(broken, "/Shader")
    assert any("defaultPrim" in fault for fault in faults(broken))


def test_everything_stands_where_it_stands_in_the_scene(
    stage: Usd.Stage, scene: Scene, items: tuple[RenderItem, ...]
) -> None:
    heights = {level.id: level.elevation for level in scene.levels}
    found = by_id(stage)
    cache = UsdGeom.BBoxCache(0.0, [UsdGeom.Tokens.default_])
    assert found.keys() == {item.name for item in items if item.parts}
    for item in (item for item in items if item.parts):
        points = np.vstack([to_level_coordinates(item, part.vertices) for part in item.parts])
        points[:, 2] += heights[item.level]
        meshes = [
            UsdGeom.Mesh(prim)
            for prim in Usd.PrimRange(found[item.name], EVERYTHING)
            if prim.IsA(UsdGeom.Mesh)
        ]
        assert len(meshes) == len(item.parts)
        moved = np.vstack([_world_points(mesh) for mesh in meshes])
        assert np.abs(moved.min(0) - points.min(0)).max() < 1e-4
        assert np.abs(moved.max(0) - points.max(0)).max() < 1e-4
        assert not cache.ComputeWorldBound(found[item.name]).ComputeAlignedRange().IsEmpty()


def _world_points(mesh: UsdGeom.Mesh) -> np.ndarray:
    rows = np.array(mesh.GetPointsAttr().Get(), float)
    turn = np.array(UsdGeom.XformCache().GetLocalToWorldTransform(mesh.GetPrim()))
    return np.asarray(rows @ turn[:3, :3] + turn[3, :3])


def test_triangles_look_outwards(stage: Usd.Stage) -> None:
    """The volume that closed meshes enclose is positive, and normals go with the faces."""
    for prim in prims(stage, UsdGeom.Mesh):
        mesh = UsdGeom.Mesh(prim)
        points = np.array(mesh.GetPointsAttr().Get(), float)
        ways = np.array(mesh.GetNormalsAttr().Get(), float)
        faces = np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
        a, b, c = (points[faces[:, k]] for k in range(3))
        across = np.cross(b - a, c - a)
        with_faces = np.einsum("ij,ij->i", across, ways[faces].sum(1)) > -1e-9
        assert with_faces.all(), prim.GetPath()


def test_materials_lights_and_labels_are_those_of_the_scene(
    stage: Usd.Stage, items: tuple[RenderItem, ...]
) -> None:
    drawn = {part.material for item in items for part in item.parts}
    assert len(prims(stage, UsdShade.Material)) == len(drawn)
    for prim in prims(stage, UsdGeom.Mesh):
        bound, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        assert bound, prim.GetPath()
    lamps = {lamp.item.name: lamp for lamp in lamps_of(items, shipped())}
    lights = prims(stage, UsdLux.SphereLight)
    assert len(lights) == len(lamps) > 0
    for prim in lights:
        name = str(prim.GetParent().GetCustomDataByKey("scenewright")["id"])
        flux = np.pi * UsdLux.SphereLight(prim).GetIntensityAttr().Get()
        assert flux == pytest.approx(lamps[name].lumens, rel=1e-3)
    assert len(prims(stage, UsdLux.DistantLight)) == len(prims(stage, UsdLux.DomeLight)) == 1
    found = by_id(stage)
    said = {
        name: [*prim.GetAttribute("semantics:labels:class").Get()] for name, prim in found.items()
    }
    assert said["sofa"] == ["sofa"]
    assert said["living"] == ["floor"]
    assert Counter(label for labels in said.values() for label in labels)["wall"] >= 4


def test_packages_hold_textures_and_files_alone_do_not(tmp_path: Path, stage: Usd.Stage) -> None:
    path = tmp_path / "flat.usdz"
    write(flat_solution(), path)
    packed = Usd.Stage.Open(str(path))
    shaders = [UsdShade.Shader(prim) for prim in prims(packed, UsdShade.Shader)]
    worn = [one for one in shaders if one.GetIdAttr().Get() == "UsdUVTexture"]
    files = [one.GetInput("file").Get().resolvedPath for one in worn]
    assert len(files) >= 3
    assert all(file.startswith(str(path)) for file in files)
    ids = {UsdShade.Shader(prim).GetIdAttr().Get() for prim in prims(stage, UsdShade.Shader)}
    assert ids == {"UsdPreviewSurface"}
    for prim in prims(packed, UsdGeom.Mesh):
        bound, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        places = UsdGeom.PrimvarsAPI(prim).GetPrimvar("st")
        textured = any(child.GetName() == "Color" for child in bound.GetPrim().GetChildren())
        assert textured == places.HasValue()
        if textured:
            assert len(places.Get()) == len(UsdGeom.Mesh(prim).GetPointsAttr().Get())


def test_pieces_alike_are_instances_of_one_prototype(
    stage: Usd.Stage, items: tuple[RenderItem, ...]
) -> None:
    drawn = Counter(item.key for item in items if item.parts)
    shared = [item for item in items if drawn[item.key] > 1]
    instances = [prim for prim in stage.Traverse() if prim.IsInstance()]
    assert len(instances) == len(shared)
    assert len(stage.GetPrototypes()) == len({item.key for item in shared})


def test_cameras_see_their_rooms(stage: Usd.Stage, scene: Scene) -> None:
    """The upper left corner of the picture lies in the direction in which our own camera has it."""
    world = build_world(scene, shipped())
    frames = [*stand_in_rooms(world, frozenset(), (960, 600), tried=6)]
    cameras = prims(stage, UsdGeom.Camera)
    assert [prim.GetDisplayName() for prim in cameras] == [space.name for space, *_ in frames]
    for prim, (_, _, frame) in zip(cameras, frames, strict=True):
        frustum = UsdGeom.Camera(prim).GetCamera().frustum
        corner = np.array(frustum.ComputeCorners()[2]) - np.array(frustum.GetPosition())
        left, top, _ = (float(value) for value in frame.frame)
        way = np.array([left, top, 1.0]) @ frame.axes.astype(float)
        assert np.allclose(corner / np.linalg.norm(corner), way / np.linalg.norm(way), atol=1e-4)


def test_names_of_prims_are_plain_and_unique(stage: Usd.Stage) -> None:
    assert prim_name("ein Bücherregal, links") == "ein_Bucherregal_links"
    assert all(prim.GetName().isidentifier() for prim in stage.TraverseAll())


def test_an_empty_home_is_written(tmp_path: Path) -> None:
    write(unfurnished(flat_brief()), tmp_path / "empty.usda")
    assert faults(Usd.Stage.Open(str(tmp_path / "empty.usda"))) == []


def test_the_missing_library_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in [name for name in sys.modules if name.startswith("scenewright.formats.usd")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setattr("scenewright.core.extras.find_spec", lambda _: None)
    assert cli.run(["arrange", "sample:home-room", "-o", str(tmp_path / "a.usda")]) == 2
    assert "needs the package 'pxr'; pip install 'scenewright[usd]'" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
