"""Models from glTF, in every wrapping."""

from __future__ import annotations

import base64
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

from model_files import SIDES, TETRAHEDRON, body, glb_of, gltf_of, put
from scenewright.catalog.models import library, load
from scenewright.catalog.models.gltf import matrix
from scenewright.catalog.models.gltf_record import GltfNode
from scenewright.geometry.mesh import volume


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
        TETRAHEDRON,
        SIDES,
        nodes=[
            {"children": [1, 2], "translation": [5, 6, 7]},
            {"mesh": 0, "rotation": turn, "scale": [1, 1, 3]},
            {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 9, 1]},
        ],
    )
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
        node = GltfNode(rotation=tuple(turn), translation=(1, 2, 3), scale=(2, 3, 4))
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
        "componentType": 5120,
        "normalized": True,
        "sparse": {
            "count": 1,
            "indices": {"bufferView": 2, "componentType": 5121},
            "values": {"bufferView": 3},
        },
    }
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
    document["buffers"].append(
        {
            "byteLength": 32,
            "uri": "data:application/octet-stream;base64," + base64.b64encode(spots).decode(),
        }
    )
    document["bufferViews"].append({"buffer": 1, "byteLength": 32})
    document["accessors"].append(
        {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"}
    )
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
