"""The GLB file: a named node for everything, in the right place, meshes shared, bytes in order."""

from __future__ import annotations

import io
import json
import struct
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image

from flat import flat_brief, flat_solution
from scenewright import read
from scenewright.catalog.assets import shipped
from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Material, Part
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.domains import scene_of, solve
from scenewright.formats.glb import document_of, encode_scene, write
from scenewright.formats.gltf.surfaces import surface
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.prisms import box, corner_normals, prism
from scenewright.render.colour import linear_of
from scenewright.render.items import things
from scenewright.render.textures.projection import coordinates_of
from scenewright.render.textures.table import texture_of

GREY = Material("grey", (0.5, 0.5, 0.5))
COMPONENTS = {5120: np.int8, 5126: np.float32, 5123: np.uint16, 5125: np.uint32}


@pytest.fixture(scope="module")
def scene() -> Scene:
    return scene_of(flat_solution())


@pytest.fixture(scope="module")
def document(scene: Scene) -> dict[str, Any]:
    return document_of(scene, shipped())[0]


def chunks(data: bytes) -> tuple[dict[str, Any], bytes]:
    """The two chunks of a GLB file, read by the letter of the specification."""
    magic, version, total = struct.unpack_from("<4sII", data)
    assert (magic, version, total) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON"
    assert size % 4 == 0
    after = 20 + size
    rest, binary = struct.unpack_from("<I4s", data, after)
    assert binary == b"BIN\0"
    assert after + 8 + rest == total
    return json.loads(data[20:after]), data[after + 8 :]


def node_id(node: dict[str, Any]) -> str:
    """The id of what a node stands for: its name, unless that has signs that viewers drop."""
    return str(node.get("extras", {}).get("id", node["name"]))


def numbers(document: dict[str, Any], buffer: bytes, index: int) -> Any:
    row = document["accessors"][index]
    view = document["bufferViews"][row["bufferView"]]
    wide = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[row["type"]]
    start, kind = view["byteOffset"] + row["byteOffset"], np.dtype(COMPONENTS[row["componentType"]])
    stride = view.get("byteStride", wide * kind.itemsize) // kind.itemsize
    found = np.frombuffer(buffer, kind, row["count"] * stride, start)
    assert start + found.nbytes <= view["byteOffset"] + view["byteLength"]
    return found.reshape(-1, stride)[:, :wide]


def test_everything_has_a_node_of_its_name(scene: Scene, document: dict[str, Any]) -> None:
    names = [node["name"] for node in document["nodes"]]
    assert len(names) == len(set(names))
    assert not [name for name in names if set(name) & set("[].:/") or len(name.encode()) > 63]
    ids = {node_id(node) for node in document["nodes"]}
    wanted = [
        thing.id
        for group in (scene.spaces, scene.walls, scene.openings, scene.pieces)
        for thing in group
    ]
    assert set(wanted) <= ids
    assert {level.name for level in scene.levels} <= set(names)


def test_pieces_hang_below_their_rooms_and_rooms_below_their_level(
    scene: Scene, document: dict[str, Any]
) -> None:
    nodes = document["nodes"]
    parent = {child: i for i, node in enumerate(nodes) for child in node.get("children", ())}
    index = {node_id(node): i for i, node in enumerate(nodes)}
    for piece in scene.pieces:
        room = nodes[parent[index[piece.id]]]
        assert room["name"] == piece.space
        assert nodes[parent[index[piece.space]]]["name"] == "Ground floor"
    assert set(parent) == set(range(1, len(nodes)))


def test_extras_tell_what_a_piece_is(document: dict[str, Any]) -> None:
    extras = next(node for node in document["nodes"] if node["name"] == "sofa")["extras"]
    assert extras["category"] == "sofa"
    assert extras["space"] == "living"
    assert extras["group"] == "living/seating"
    assert extras["licence"] == "Apache-2.0"
    assert {"asset", "author", "function"} <= set(extras)


@pytest.mark.parametrize("batched", [True, False])
def test_the_bytes_follow_the_specification(scene: Scene, batched: bool) -> None:
    document, buffer = chunks(encode_scene(scene, shipped(), batched=batched))
    assert document["asset"]["generator"].startswith("Scenewright ")
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            place = primitive["attributes"]["POSITION"]
            points = numbers(document, buffer, place)
            normals = numbers(document, buffer, primitive["attributes"]["NORMAL"])
            indices = numbers(document, buffer, primitive["indices"])
            long = np.linalg.norm(normals / (127 if batched else 1), axis=1)
            assert np.allclose(long, 1, atol=0.01 if batched else 1e-4)
            bounds = [np.float32(document["accessors"][place][end]) for end in ("min", "max")]
            assert np.array_equal(bounds, [points.min(0), points.max(0)])
            assert indices.max() == len(points) - 1
            assert primitive["material"] < len(document["materials"])


def test_lamps_give_the_light_of_their_kind() -> None:
    size, place = Size(0.4, 0.4, 0.2), Pose(1.0, 2.0, 2.4, 0.0)
    lamp = Piece("a/lamp", "ceiling_lamp", "ceiling_lamp", "living", place, size)
    scene = scene_of(replace(flat_solution(), pieces=(lamp, replace(lamp, id="b/lamp"))))
    document, _ = document_of(scene, shipped())
    (light,) = document["extensions"]["KHR_lights_punctual"]["lights"]
    red, green, blue = light["color"]
    luminance = 0.2126 * red + 0.7152 * green + 0.0722 * blue
    assert luminance * light["intensity"] * 4 * np.pi == pytest.approx(1521, rel=0.01)
    assert red == 1.0 > green > blue, "warm light"
    nodes = {node["name"]: node for node in document["nodes"]}
    held = nodes["a-lamp light"]
    assert document["nodes"].index(held) in nodes["a-lamp"]["children"]
    assert 0 <= held["translation"][1] <= 0.2


def test_names_stay_unique_and_short_without_signs_that_viewers_drop() -> None:
    size = Size(0.5, 0.5, 0.9)
    ids = ("x/y", "x-y", "x:y", "é" * 50, "é" * 51)
    pieces = tuple(
        Piece(name, "dining_chair", "", "living", Pose(1.0 + k, 2, 0, 0), size)
        for k, name in enumerate(ids)
    )
    scene = scene_of(replace(flat_solution(), pieces=pieces))
    nodes = document_of(scene, shipped())[0]["nodes"]
    names = [node["name"] for node in nodes]
    assert len(set(names)) == len(names)
    assert max(len(name.encode()) for name in names) <= 63
    assert set(ids) <= {node_id(node) for node in nodes}


def test_materials_are_listed_once_and_glass_blends(document: dict[str, Any]) -> None:
    listed = [json.dumps(material, sort_keys=True) for material in document["materials"]]
    assert len(listed) == len(set(listed))
    glass = next(m for m in document["materials"] if m["name"] == "window glass")
    assert glass["alphaMode"] == "BLEND"
    assert glass["pbrMetallicRoughness"]["baseColorFactor"][3] < 1


def test_textures_are_repeated_in_metres_and_wood_keeps_its_colour(scene: Scene) -> None:
    document, buffer = chunks(encode_scene(scene, shipped()))
    floor = next(m for m in document["materials"] if m["name"].startswith("oak floor"))
    look = floor["pbrMetallicRoughness"]
    image = document["images"][document["textures"][look["baseColorTexture"]["index"]]["source"]]
    view = document["bufferViews"][image["bufferView"]]
    content = buffer[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    pixels = np.asarray(Image.open(io.BytesIO(content)), float) / 255
    mean = (np.where(pixels <= 0.04045, pixels / 12.92, ((pixels + 0.055) / 1.055) ** 2.4)).mean(
        (0, 1)
    ) * look["baseColorFactor"][:3]
    named = next(part.material for t in things(scene, shipped()) for part in t.parts
                 if part.material.name == floor["name"])  # fmt: skip
    assert np.allclose(mean, linear_of(np.array(named.color)), atol=0.02)
    living = next(n for n in document["nodes"] if node_id(n) == "living")
    primitive = document["meshes"][living["mesh"]]["primitives"][0]
    assert document["materials"][primitive["material"]]["name"] == floor["name"]
    points = numbers(document, buffer, primitive["attributes"]["POSITION"])
    places = numbers(document, buffer, primitive["attributes"]["TEXCOORD_0"])
    row = texture_of(floor["name"])
    assert row is not None
    longer = max(np.ptp(points[:, 0]), np.ptp(points[:, 2]))
    assert np.ptp(places[:, 0]) * row.metres[1] == pytest.approx(longer, rel=1e-3)


def test_what_has_a_normal_map_has_tangents_along_its_texture() -> None:
    wall = Part(GREY, *box((0, 0, 0), (3, 0.2, 2)))
    places = coordinates_of(wall, "upright") * (1.0, -1.0)
    found = surface(wall, corner_normals(wall.vertices, wall.faces), places, relief=True)
    assert found.tangents is not None
    assert found.places is not None
    assert np.allclose(np.linalg.norm(found.tangents[:, :3], axis=1), 1, atol=1e-6)
    assert np.abs((found.tangents[:, :3] * found.normals).sum(1)).max() < 1e-6
    up = np.cross(found.normals, found.tangents[:, :3]) * found.tangents[:, 3:]
    for a, b, c in found.indices.reshape(-1, 3):
        for one in (b, c):
            step, moved = (rows[one] - rows[a] for rows in (found.positions, found.places))
            assert step @ found.tangents[a, :3] == pytest.approx(moved[0], abs=1e-6)
            assert step @ up[a] == pytest.approx(-moved[1], abs=1e-6)


def test_a_piece_lies_where_the_plan_says_with_y_up() -> None:
    pose, size = Pose(1.7, 2.2, 0.25, 0.7), Size(1.4, 0.6, 0.8)
    solution = replace(
        flat_solution(), pieces=(Piece("crate", "no_such_kind", "", "living", pose, size),)
    )
    loaded = trimesh.load(
        trimesh.util.wrap_as_stream(encode_scene(scene_of(solution), shipped())), file_type="glb"
    )
    turn, geometry = loaded.graph["crate"]
    points = trimesh.transform_points(loaded.geometry[geometry].vertices, turn)
    ours = np.column_stack([points[:, 0], -points[:, 2], points[:, 1]])
    expected = corners(np.array([pose.x, pose.y, pose.heading, size.width, size.depth]))
    for corner in expected:
        assert np.abs(ours[:, :2] - corner).sum(1).min() < 1e-5
    assert ours[:, 2].min() == pytest.approx(0.25, abs=1e-6)
    assert ours[:, 2].max() == pytest.approx(1.05, abs=1e-6)


def test_levels_are_raised_and_equal_pieces_share_a_mesh() -> None:
    brief = flat_brief().model_dump()
    brief["levels"].append({"id": "up", "name": "Upstairs", "elevation": 2.9})
    brief["rooms"].append(
        {"id": "loft", "outline": [[0, 0], [4, 0], [4, 4], [0, 4]], "level": "up"}
    )
    size = Size(0.5, 0.5, 0.9)
    pieces = tuple(
        Piece(f"chair-{k}", "dining_chair", "", "loft", Pose(1.0 + k, 2, 0, k), size)
        for k in range(3)
    )
    base = flat_solution()
    made = replace(base, brief=type(base.brief).model_validate(brief), pieces=pieces)
    document = document_of(scene_of(made), shipped())[0]
    nodes = {node["name"]: node for node in document["nodes"]}
    assert nodes["Upstairs"]["translation"] == [0, 2.9, 0]
    assert {piece.id for piece in pieces} <= set(nodes), "each is found by its name"
    (shared,) = (node for node in nodes.values() if node.get("extras", {}).get("instances"))
    assert shared["extras"]["instances"] == 3
    assert "mesh" in shared


def test_every_node_is_named_in_trimesh_and_the_home_has_its_size(scene: Scene) -> None:
    loaded = trimesh.load(
        trimesh.util.wrap_as_stream(encode_scene(scene, shipped())), file_type="glb"
    )
    assert all(name and not name.startswith("geometry") for name in loaded.graph.nodes_geometry)
    low, high = loaded.bounds
    assert high[1] == pytest.approx(2.6, abs=1e-5)
    assert high[0] - low[0] == pytest.approx(8.2 + 0.5, abs=0.01)
    assert high[2] - low[2] == pytest.approx(4.5, abs=0.03)


def test_faces_look_outwards(scene: Scene) -> None:
    for part in (
        Part(GREY, *box((0, 0, 0), (1, 2, 3))),
        Part(GREY, *prism(np.array([[0.0, 0], [2, 0], [0, 2]]), 0, 1)),
    ):
        found = surface(part, corner_normals(part.vertices, part.faces))
        solid = trimesh.Trimesh(found.positions, found.indices.reshape(-1, 3), process=False)
        assert solid.volume > 0
        rows = found.indices.reshape(-1, 3)
        across = np.cross(
            found.positions[rows[:, 1]] - found.positions[rows[:, 0]],
            found.positions[rows[:, 2]] - found.positions[rows[:, 0]],
        )
        assert (np.einsum("ij,ikj->ik", across, found.normals[rows]) > 0).all()


def test_faces_without_area_are_left_out() -> None:
    square = box((0, 0, 0), (1, 1, 1))
    spoilt = Mesh(square.vertices, np.vstack([square.faces, [[0, 0, 1]]]))
    assert len(surface(Part(GREY, *spoilt), corner_normals(*spoilt[:2])).indices) == 36


def test_the_file_is_the_same_each_time_and_leaves_nothing_beside_it(tmp_path: Path) -> None:
    first, second = tmp_path / "a.glb", tmp_path / "b.glb"
    write(flat_solution(), first)
    write(flat_solution(), second)
    assert first.read_bytes() == second.read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.glb", "b.glb"]


@pytest.mark.parametrize("sample", ["home-house", "home-attic", "hall-shop", "site-courtyards"])
def test_everything_of_a_scene_is_in_the_file(sample: str) -> None:
    solution = solve(read(f"sample:{sample}"), steps=50)
    scene, catalog = scene_of(solution), catalog_of(solution.brief.catalogs)
    found = things(scene, catalog)
    for batched in (True, False):
        document = document_of(scene, catalog, batched=batched)[0]
        nodes = {node_id(node): node for node in document["nodes"]}
        assert {thing.name for thing in found} <= set(nodes)
    still = [thing for thing in found if any(part.joint is None for part in thing.parts)]
    assert all("mesh" in nodes[thing.name] for thing in still)
    if sample == "home-house":
        assert {"stairs", "stairs railing"} <= {thing.name for thing in found}


def test_a_leaf_is_a_node_that_shuts_its_opening_when_it_is_turned_back(scene: Scene) -> None:
    """By what its ``extras`` say alone: about its own origin and axis, from where it is to 0."""
    document, buffer = document_of(scene, shipped())
    leaves = [n for n in document["nodes"] if node_id(n).endswith(" leaf")]
    wide = {opening.id: opening.width for opening in scene.openings}
    assert leaves
    for node in leaves:
        joint = node["extras"]["joint"]
        assert joint["type"] == "hinge"
        angle = -joint["at"] * joint["axis"][1]
        turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
        rows = document["meshes"][node["mesh"]]["primitives"]
        points = np.vstack([numbers(document, buffer, r["attributes"]["POSITION"]) for r in rows])
        x, z = (points[:, [0, 2]] @ turn.T + np.array(node["translation"])[[0, 2]]).T
        width = wide[node_id(node).removesuffix(" leaf")]
        assert x.min() == pytest.approx(-width / 2, abs=0.04)
        assert x.max() == pytest.approx(width / 2, abs=0.04)
        assert np.abs(z).max() < 0.25
