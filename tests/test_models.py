"""Model files: what is read is what was written, set up in our frame; all real files are used."""

from __future__ import annotations

import base64
import json
import struct
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from PIL import Image

from scenewright.catalog import Part
from scenewright.errors import InputError
from scenewright.geometry.mesh import Mesh, merge, volume
from scenewright.models import ROWS, library, load, report
from scenewright.models.as_asset import asset_of
from scenewright.models.facets import quads_cut, triangles
from scenewright.models.gltf import matrix
from scenewright.models.gltf_record import Node
from scenewright.models.model import Model, Options
from scenewright.scene import Size

Floats = NDArray[np.float64]

TETRAHEDRON = np.array([[0.0, 0, 0], [2, 0, 0], [0, 3, 0], [0, 0, 4]])
SIDES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def body(model: Model) -> Mesh:
    """All parts as one mesh."""
    return merge([Mesh(part.vertices, part.faces) for part in model.parts])


def bounds(parts: tuple[Part, ...]) -> tuple[list[float], list[float]]:
    points = np.concatenate([part.vertices for part in parts])
    return points.min(0).tolist(), points.max(0).tolist()


def obj_text(vertices: Floats = TETRAHEDRON, head: str = "") -> str:
    rows = [head, *("v {} {} {}".format(*row) for row in vertices.tolist())]
    return "\n".join([*rows, *("f {} {} {}".format(*(row + 1)) for row in SIDES)]) + "\n"


def gltf_of(vertices: Floats, faces: NDArray[np.int64], **more: Any) -> dict[str, Any]:
    """A glTF document with its numbers inside."""
    points, numbers = vertices.astype("<f4").tobytes(), faces.astype("<u2").tobytes()
    packed = base64.b64encode(points + numbers).decode()
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(vertices), "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": faces.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(points)},
            {"buffer": 0, "byteOffset": len(points), "byteLength": len(numbers)},
        ],
        "buffers": [{"byteLength": len(points + numbers),
                     "uri": "data:application/octet-stream;base64," + packed}],
    } | more  # fmt: skip


def glb_of(document: dict[str, Any], numbers: bytes = b"") -> bytes:
    """The document as a binary glTF file."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    if numbers:
        chunks += struct.pack("<I4s", len(numbers), b"BIN\0") + numbers
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def city_of(geometry: dict[str, Any], vertices: list[list[int]], **more: Any) -> dict[str, Any]:
    return {
        "type": "CityJSON",
        "version": "2.0",
        "transform": {"scale": [0.5, 0.5, 0.5], "translate": [85000.0, 447000.0, 1.0]},
        "CityObjects": {"house": {"type": "Building", "geometry": [geometry]}},
        "vertices": vertices,
    } | more


CUBE = [[x, y, z] for x in (0, 8) for y in (0, 6) for z in (0, 10)]
SHELL = [[[0, 2, 6, 4]], [[1, 5, 7, 3]], [[0, 4, 5, 1]], [[2, 3, 7, 6]], [[0, 1, 3, 2]],
         [[4, 6, 7, 5]]]  # fmt: skip
SOLID = {"type": "Solid", "lod": "2", "boundaries": [SHELL]}


def put(folder: Path, name: str, content: bytes | str | dict[str, Any]) -> Path:
    path = folder / name
    text = json.dumps(content) if isinstance(content, dict) else content
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


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
    model = load(put(tmp_path, "kit.obj", obj_text()), Options(up, front))
    assert model.size == size
    assert model.id == model.name == "kit"
    w, d, h = size
    assert bounds(model.parts) == ([-w / 2, -d / 2, 0], [w / 2, d / 2, h])
    assert volume(body(model)) == pytest.approx(4.0), "faces still look outwards"


def test_the_front_comes_to_plus_y(tmp_path: Path) -> None:
    """The corner furthest along the file's front is the furthest along ours."""
    for front, corner in (("+z", 3), ("-z", 0), ("+x", 1)):
        model = load(put(tmp_path, "kit.obj", obj_text()), Options("", front))
        whole = body(model)
        lengths = sorted(np.linalg.norm(TETRAHEDRON - TETRAHEDRON[corner], axis=1))
        foremost = whole.vertices[np.argmax(whole.vertices[:, 1])]
        if np.sum(whole.vertices[:, 1] > whole.vertices[:, 1].max() - 1e-9) > 1:
            continue
        away = sorted(np.linalg.norm(whole.vertices - foremost, axis=1))
        assert away == pytest.approx(lengths)


def test_an_asset_fills_any_size_and_prefers_its_own(tmp_path: Path) -> None:
    asset = asset_of(load(put(tmp_path, "kit.obj", obj_text()), Options(scale=2.0)))
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
    symbol = asset_of(load(put(tmp_path, "ell.obj", text), Options("+z", "+y"))).symbol
    outline = symbol(Size(3, 2, 1))[0]
    x, y = outline[:-1].T
    area = 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))
    assert area == pytest.approx(4.0, abs=1e-3)


def test_obj_numbers_count_from_both_ends_and_polygons_are_cut(tmp_path: Path) -> None:
    star = [(np.cos(a) * r, np.sin(a) * r) for a, r in
            zip(np.arange(10) * np.pi / 5, [1, 0.4] * 5, strict=True)]  # fmt: skip
    rows = [f"v {x} {y} {z}" for z in (0, 1) for x, y in star]
    sides = [f"f {i + 1} {(i + 1) % 10 + 1} {(i + 1) % 10 + 11} {i + 11}" for i in range(10)]
    caps = ["f " + " ".join(str(-k) for k in range(11, 21)), "f -10 -9 -8 -7 -6 -5 -4 -3 -2 -1"]
    model = load(put(tmp_path, "star.obj", "\n".join([*rows, *sides, *caps])), Options("+z", "+y"))
    assert len(body(model).faces) == 20 + 16
    exact = 0.5 * 10 * 0.4 * np.sin(np.pi / 5)
    assert volume(body(model)) == pytest.approx(exact)


def test_obj_materials_and_textures_colour_the_faces(tmp_path: Path) -> None:
    picture = np.zeros((4, 4, 3), np.uint8)
    picture[:, :2], picture[:, 2:] = (255, 0, 0), (0, 0, 255)
    Image.fromarray(picture).save(tmp_path / "two colours.png")
    mtl = "newmtl skin\nKd 1 1 1\nmap_Kd two colours.png\nnewmtl glass\nKd 0 1 0\nd 0.25\n"
    put(tmp_path, "kit.mtl", mtl)
    rows = ["mtllib kit.mtl", *("v {} {} {}".format(*row) for row in TETRAHEDRON.tolist()),
            "vt 0.2 0.5", "vt 0.8 0.5", "usemtl skin", "f 1/1 3/1 2/1", "f 1/-1 2/-1 4/-1",
            "usemtl glass", "f 1 4 3", "f 2 3 4"]  # fmt: skip
    parts = load(put(tmp_path, "kit.obj", "\n".join(rows))).parts
    told = {(part.material.color, part.material.opacity, len(part.faces)) for part in parts}
    assert told == {((1, 0, 0), 1, 1), ((0, 0, 1), 1, 1), ((0, 1, 0), 0.25, 2)}


@pytest.mark.parametrize("line", ["map_Kd gone.png", "map_Kd C:\\art\\gone.png", "map_Kd /a/b.png"])
def test_a_texture_that_is_not_there_leaves_the_colour(tmp_path: Path, line: str) -> None:
    put(tmp_path, "kit.mtl", f"newmtl skin\nKd 0.25 0.5 0.75\n{line}\n")
    head = "mtllib kit.mtl\nusemtl skin"
    (part,) = load(put(tmp_path, "kit.obj", obj_text(head=head))).parts
    assert part.material.color == (0.25, 0.5, 0.75)


def test_quadrangles_are_cut_inside() -> None:
    rng = np.random.default_rng(3)
    for _ in range(50):
        angle = np.arange(4) * np.pi / 2 + rng.uniform(0, 1.5, 4)
        ring = np.stack([np.cos(angle), np.sin(angle), 0 * angle], 1) * rng.uniform(0.1, 1, (4, 1))
        for faces in (quads_cut(ring, np.array([[0, 1, 2, 3]])), triangles([ring])):
            a, b, c = (ring[faces[:, k]] for k in range(3))
            double = np.cross(b - a, c - a)[:, 2]
            x, y = ring[:, 0], ring[:, 1]
            whole = float(x @ np.roll(y, -1) - y @ np.roll(x, -1))
            assert double.sum() == pytest.approx(whole)
            assert np.abs(double).sum() == pytest.approx(abs(whole)), "nothing twice"


def test_gltf_in_every_wrapping_is_the_same(tmp_path: Path) -> None:
    inside = gltf_of(TETRAHEDRON, SIDES)
    numbers = base64.b64decode(inside["buffers"][0]["uri"].partition(",")[2])
    beside = inside | {"buffers": [{"byteLength": len(numbers), "uri": "sub/raw%20data.bin"}]}
    (tmp_path / "sub").mkdir()
    put(tmp_path, "sub/raw data.bin", numbers)
    put(tmp_path, "a.gltf", inside)
    put(tmp_path, "b.gltf", beside)
    binary = inside | {"buffers": [{"byteLength": len(numbers)}]}
    put(tmp_path, "c.glb", glb_of(binary, numbers))
    models = library(tmp_path)
    assert [model.id for model in models] == ["a", "b", "c"]
    for model in models:
        assert model.size == (2, 4, 3)
        assert volume(body(model)) == pytest.approx(4.0)
        assert np.array_equal(body(model).vertices, body(models[0]).vertices)


def test_gltf_nodes_move_turn_scale_and_mirror(tmp_path: Path) -> None:
    turn = [0.0, float(np.sin(0.3)), 0.0, float(np.cos(0.3))]
    document = gltf_of(
        TETRAHEDRON, SIDES,
        nodes=[{"children": [1, 2], "translation": [5, 6, 7]},
               {"mesh": 0, "rotation": turn, "scale": [1, 1, 3]},
               {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 9, 1]}],
    )  # fmt: skip
    path = put(tmp_path, "kit.gltf", document)
    model = load(path)
    assert volume(body(model)) == pytest.approx(4.0 * 3 + 4.0), "mirrored faces look outwards"
    whole = trimesh.load(path, force="mesh")
    assert np.allclose(sorted(whole.extents), sorted(model.size), atol=1e-6)


def test_gltf_matrices_agree_with_a_reference() -> None:
    rng = np.random.default_rng(5)
    for _ in range(20):
        turn = rng.normal(size=4)
        turn /= np.linalg.norm(turn)
        node = Node(rotation=tuple(turn), translation=(1, 2, 3), scale=(2, 3, 4))
        x, y, z, w = turn
        reference = trimesh.transformations.quaternion_matrix([w, x, y, z]) @ np.diag([2, 3, 4, 1])
        reference[:3, 3] = (1, 2, 3)
        assert np.allclose(matrix(node), reference)


def test_gltf_numbers_may_be_sparse_scaled_and_interleaved(tmp_path: Path) -> None:
    """Corners as normalised bytes, 8 apart, the last one told by exception."""
    rows = np.zeros((4, 8), np.int8)
    rows[:, :3] = [[0, 0, 0], [127, 0, 0], [0, 127, 0], [9, 9, 9]]
    packed = rows.tobytes() + SIDES.astype("<u2").tobytes() + b"\x03\0\0\0" + b"\0\0\x7f\0"
    document = gltf_of(TETRAHEDRON, SIDES)
    document["accessors"][0] |= {
        "componentType": 5120, "normalized": True,
        "sparse": {"count": 1, "indices": {"bufferView": 2, "componentType": 5121},
                   "values": {"bufferView": 3}},
    }  # fmt: skip
    document["bufferViews"] = [
        {"buffer": 0, "byteLength": 32, "byteStride": 8},
        {"buffer": 0, "byteOffset": 32, "byteLength": 24},
        {"buffer": 0, "byteOffset": 56, "byteLength": 4},
        {"buffer": 0, "byteOffset": 60, "byteLength": 4},
    ]
    document["buffers"] = [{"byteLength": len(packed)}]
    model = load(put(tmp_path, "kit.glb", glb_of(document, packed)))
    assert np.allclose(model.size, 1.0)
    assert volume(body(model)) == pytest.approx(1 / 6)


def test_gltf_colours_are_srgb_and_textures_are_looked_up(tmp_path: Path) -> None:
    Image.fromarray(np.full((2, 2, 3), (255, 128, 0), np.uint8)).save(tmp_path / "skin.png")
    spots = np.zeros((4, 2), "<f4").tobytes()
    document = gltf_of(TETRAHEDRON, SIDES)
    document["buffers"].append({
        "byteLength": 32,
        "uri": "data:application/octet-stream;base64," + base64.b64encode(spots).decode(),
    })  # fmt: skip
    document["bufferViews"].append({"buffer": 1, "byteLength": 32})
    document["accessors"].append({"bufferView": 2, "componentType": 5126, "count": 4,
                                  "type": "VEC2"})  # fmt: skip
    look = {"baseColorFactor": [0.2140, 1, 1, 1], "metallicFactor": 0}
    document["materials"] = [{"name": "skin", "pbrMetallicRoughness": look}]
    primitive = document["meshes"][0]["primitives"][0]
    primitive |= {"material": 0}
    (plain,) = load(put(tmp_path, "a.gltf", document)).parts
    assert plain.material.color == (0.5, 1, 1)
    primitive["attributes"]["TEXCOORD_0"] = 2
    look["baseColorTexture"] = {"index": 0}
    document |= {"textures": [{"source": 0}], "images": [{"uri": "skin.png"}]}
    (painted,) = load(put(tmp_path, "b.gltf", document)).parts
    assert painted.material.color == pytest.approx((0.5, 128 / 255, 0.0), abs=3e-3)


def test_cityjson_solids_have_roofs_walls_and_true_sizes(tmp_path: Path) -> None:
    (model,) = library(put(tmp_path, "town.json", city_of(SOLID, CUBE)))
    assert model.id == "town/house"
    assert sorted(model.size) == [3, 4, 5]
    assert volume(body(model)) == pytest.approx(60.0)
    assert {p.material.name: len(p.faces) for p in model.parts} == {
        "ground": 2, "roof": 2, "wall": 8,
    }  # fmt: skip


def test_cityjson_surfaces_keep_their_holes_and_meanings(tmp_path: Path) -> None:
    courtyard = [[2, 2, 10], [2, 4, 10], [6, 4, 10], [6, 2, 10]]
    roof = [[1, 5, 7, 3], [8, 9, 10, 11]]
    geometry = {
        "type": "MultiSurface", "lod": "2", "boundaries": [roof, [[0, 4, 5, 1]]],
        "semantics": {"surfaces": [{"type": "WallSurface"}, {"type": "RoofSurface"}],
                      "values": [1, 0]},
    }  # fmt: skip
    (model,) = library(put(tmp_path, "town.json", city_of(geometry, CUBE + courtyard)))
    areas = {}
    for part in model.parts:
        a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
        areas[part.material.name] = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    assert areas == {"roof": pytest.approx(12 - 2.0), "wall": pytest.approx(20.0)}


def test_cityjson_takes_the_best_detail_and_puts_parts_together(tmp_path: Path) -> None:
    low = {"type": "Solid", "lod": 1, "boundaries": [SHELL[:3]]}
    document = city_of(low, CUBE)
    document["CityObjects"] = {
        "whole": {"type": "Building", "children": ["a", "b"]},
        "a": {"type": "BuildingPart", "parents": ["whole"], "geometry": [SOLID, low]},
        "b": {"type": "BuildingPart", "parents": ["whole"], "geometry": [SOLID]},
        "lost": {"type": "BuildingPart", "parents": ["gone"], "geometry": [low, SOLID]},
        "road": {"type": "Road", "geometry": [SOLID]},
    }
    models = library(put(tmp_path, "town.json", document))
    assert {m.id: len(body(m).faces) for m in models} == {"town/whole": 24, "town/lost": 12}


@pytest.mark.parametrize("degrees", [0, 20, 44, 70, 135])
def test_cityjson_buildings_are_turned_along_their_box(tmp_path: Path, degrees: float) -> None:
    angle = np.deg2rad(degrees)
    turn = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0],
                     [0, 0, 1]])  # fmt: skip
    vertices = np.round(np.array(CUBE) @ turn * 1000).astype(int).tolist()
    frame = {"scale": [0.001] * 3, "translate": [2.6e6, 1.2e6, 400]}
    (model,) = library(put(tmp_path, "t.json", city_of(SOLID, vertices, transform=frame)))
    assert sorted(model.size) == pytest.approx([6, 8, 10], abs=0.01)


@pytest.mark.parametrize("binary", [True, False])
def test_stl_agrees_with_another_writer(tmp_path: Path, binary: bool) -> None:
    kind = "stl" if binary else "stl_ascii"
    mesh = trimesh.Trimesh(TETRAHEDRON, SIDES)
    content = mesh.export(file_type=kind)
    model = load(put(tmp_path, "kit.stl", content))
    assert model.size == (2, 3, 4)
    assert volume(body(model)) == pytest.approx(4.0)


def furniture(folder: Path, catalogue: str, files: dict[str, str | bytes], **more: str) -> Path:
    path = folder / "shop.sh3f"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("PluginFurnitureCatalog.properties", catalogue.encode("latin-1"))
        for language, text in more.items():
            archive.writestr(f"PluginFurnitureCatalog_{language}.properties", text)
        for name, content in files.items():
            archive.writestr(name, content)
    return path


PIECE = """license = Public \\
    domain
name#1=Caf\\u00e9 table
category#1: Kitchen
model#1=/kit/table.obj
width#1=80
depth#1=60
height#1=74
elevation#1=10
creator#1=Jos\xe9
modelRotation#1=1 0 0 0 0 1 0 -1 0
"""


def test_furniture_libraries_give_size_names_and_makers(tmp_path: Path) -> None:
    path = furniture(tmp_path, PIECE, {"kit/table.obj": obj_text()}, de="name#1=Kaffeetisch")
    (model,) = library(path)
    assert model.size == pytest.approx((0.8, 0.6, 0.74))
    assert (model.id, model.name, model.category) == ("shop/table", "Café table", "Kitchen")
    assert (model.author, model.licence, model.elevation) == ("José", "Public domain", 0.1)
    assert library(path, Options(language="de_AT"))[0].name == "Kaffeetisch"
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


def test_rows_name_modules_that_read() -> None:
    from importlib import import_module

    for row in ROWS:
        assert callable(import_module(f"scenewright.models.{row.reader}").read)


REAL = [("kenney_city", 15, 15), ("kaykit_city", 61, 61), ("kaykit_medieval_village", 54, 54),
        ("kenney_furniture_nature", 205, 205), ("citymodels_cityjson", 225, 225),
        ("furniture_sweethome3d", 175, 175), ("meshes_classic", 5, 5)]  # fmt: skip


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


@pytest.mark.realdata
@pytest.mark.parametrize(
    "name",
    ["kaykit_city/obj/building_A.obj", "kenney_city/starter_kit/building-small-a.glb",
     "meshes_classic/spot.obj", "kenney_furniture_nature/loungeSofa.glb"],
)  # fmt: skip
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
