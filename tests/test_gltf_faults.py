"""Hostile glTF files: one line each."""

from __future__ import annotations

import copy
import struct
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from hostile_models import SECRET, SOUND, Json, fault_of
from model_files import SIDES, TETRAHEDRON, glb_of, gltf_of, put


def changed(change: Callable[[Json], object]) -> Json:
    document = copy.deepcopy(gltf_of(TETRAHEDRON, SIDES))
    change(document)
    return document


def chain(document: Json) -> None:
    document["nodes"] = [{"children": [k + 1]} for k in range(3000)] + [{"children": [0]}]


GLTF: dict[str, tuple[Callable[[Json], object], str]] = {
    "no version": (lambda d: d.pop("asset"), "states no version"),
    "glTF 1": (lambda d: d["asset"].update(version="1.0"), "is glTF 1.0"),
    "meshopt": (
        lambda d: d.update(extensionsRequired=["EXT_meshopt_compression"]),
        "is compressed (EXT_meshopt_compression); unpack it: npx @gltf-transform/cli copy",
    ),
    "unknown extension": (lambda d: d.update(extensionsRequired=["ACME_\x1bmagic"]), "ACME_magic"),
    "count beyond bytes": (lambda d: d["accessors"][0].update(count=5), "more than its bytes"),
    "huge count": (lambda d: d["accessors"][0].update(count=2**39), "numbers in a row"),
    "huge count of nothing": (
        lambda d: d["accessors"][0].update(count=2**39, bufferView=None),
        "numbers in a row",
    ),
    "count beyond any": (lambda d: d["accessors"][0].update(count=2**80), "not possible"),
    "negative count": (lambda d: d["accessors"][0].update(count=-1), "is not possible"),
    "negative offset": (lambda d: d["accessors"][0].update(byteOffset=-8), "is not possible"),
    "offset beyond": (lambda d: d["accessors"][0].update(byteOffset=40), "more than its bytes"),
    "unknown numbers": (lambda d: d["accessors"][0].update(componentType=5130), "unknown type"),
    "wrong vectors": (lambda d: d["accessors"][0].update(type="VEC2"), "not vectors of 3"),
    "indices as fractions": (
        lambda d: d["accessors"][1].update(componentType=5126, count=6),
        "not whole numbers",
    ),
    "view beyond buffer": (lambda d: d["bufferViews"][0].update(byteLength=10**6), "beyond its"),
    "view of no buffer": (lambda d: d["bufferViews"][0].update(buffer=7), "buffers[7]"),
    "no such view": (lambda d: d["accessors"][0].update(bufferView=9), "bufferViews[9]"),
    "no such accessor": (
        lambda d: d["meshes"][0]["primitives"][0].update(indices=8),
        "accessors[8]",
    ),
    "no such mesh": (lambda d: d["nodes"][0].update(mesh=3), "meshes[3] is not there"),
    "no such node": (lambda d: d["scenes"][0].update(nodes=[4]), "nodes[4] is not there"),
    "no such scene": (lambda d: d.update(scene=4), "scenes[4] is not there"),
    "no such material": (
        lambda d: d["meshes"][0]["primitives"][0].update(material=2),
        "materials[2]",
    ),
    "nothing": (lambda d: d.update(nodes=[], scenes=[]), "no triangles"),
    "no nodes": (lambda d: d["scenes"][0].update(nodes=[]), "no triangles"),
    "points only": (lambda d: d["meshes"][0]["primitives"][0].update(mode=0), "no triangles"),
    "a ring of nodes": (lambda d: d["nodes"][0].update(children=[0]), "are no tree"),
    "a node twice": (lambda d: d.update(nodes=[{"children": [1, 1]}, {"mesh": 0}]), "are no tree"),
    "a long ring": (chain, "are no tree"),
    "matrix too short": (lambda d: d["nodes"][0].update(matrix=[1, 0]), "at least 16"),
    "matrix not finite": (lambda d: d["nodes"][0].update(translation=[1e30, 0, 0]), "possible"),
    "scale nothing": (lambda d: d["nodes"][0].update(scale=[0, 0, 0]), "single point"),
    "scale flat": (lambda d: d["nodes"][0].update(scale=[1, 0, 1]), "is flat"),
    "grows without end": (
        lambda d: d.update(
            nodes=[*({"children": [k + 1], "scale": [1e9] * 3} for k in range(60)), {"mesh": 0}]
        ),
        "finite",
    ),
    "buffer outside": (lambda d: d["buffers"][0].update(uri="../raw.bin"), "outside its folder"),
    "buffer outside, hidden": (lambda d: d["buffers"][0].update(uri="%2e%2e/raw.bin"), "outside"),
    "buffer absolute": (lambda d: d["buffers"][0].update(uri="/etc/passwd"), "outside its folder"),
    "buffer by scheme": (lambda d: d["buffers"][0].update(uri="file:///etc/passwd"), "outside"),
    "buffer from the net": (lambda d: d["buffers"][0].update(uri="https://x.y/a.bin"), "outside"),
    "buffer missing": (lambda d: d["buffers"][0].update(uri="raw.bin"), "'raw.bin' is missing"),
    "buffer a folder": (lambda d: d["buffers"][0].update(uri="sub"), "'sub' is missing"),
    "buffer of nothing": (lambda d: d["buffers"][0].pop("uri"), "has no bytes"),
    "buffer too short": (lambda d: d["buffers"][0].update(byteLength=10**6), "bytes long but"),
    "buffer too long": (lambda d: d["buffers"][0].update(byteLength=2**35), "more than 256 MiB"),
    "not base64": (lambda d: d["buffers"][0].update(uri="data:x;base64,%%%"), "not base64"),
    "data as text": (lambda d: d["buffers"][0].update(uri="data:text/plain,abc"), "not base64"),
    "image outside": (
        lambda d: d.update(
            images=[{"uri": "../a.png"}],
            textures=[{"source": 0}],
            materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        ),
        "outside",
    ),
    "a list for an object": (lambda d: d.update(nodes={}), "give a list"),
    "sparse beyond": (
        lambda d: d["accessors"][0].update(
            sparse={
                "count": 4,
                "indices": {"bufferView": 1, "componentType": 5123, "byteOffset": 12},
                "values": {"bufferView": 1},
            }
        ),
        "more than its bytes",
    ),
    "sparse without end": (
        lambda d: d["accessors"][0].update(
            sparse={
                "count": 2**30,
                "indices": {"bufferView": 1, "componentType": 5123},
                "values": {"bufferView": 0},
            }
        ),
        "exceptions than numbers",
    ),
}


@pytest.mark.parametrize("case", GLTF)
def test_gltf_faults(tmp_path: Path, case: str) -> None:
    change, told = GLTF[case]
    put(tmp_path, "raw.bin", SECRET)
    (tmp_path / "in" / "sub").mkdir(parents=True)
    path = put(tmp_path, "in/kit.gltf", changed(change))
    assert told in fault_of(path)


NAN = np.array([[np.nan, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])


BYTES = {
    "empty": (b"", "is empty"),
    "header only": (b"glTF\2\0\0\0", "ends within its header"),
    "version 1": (SOUND[:4] + struct.pack("<I", 1) + SOUND[8:], "is version 1"),
    "cut off": (SOUND[:-40], "is cut off"),
    "chunk too long": (SOUND[:12] + struct.pack("<I", 2**31) + SOUND[16:], "beyond the file"),
    "no JSON first": (SOUND[:16] + b"BIN\0" + SOUND[20:], "begin with a JSON chunk"),
    "not a number": (glb_of(gltf_of(NAN, SIDES)), "finite place"),
    "corner beyond": (glb_of(gltf_of(TETRAHEDRON, SIDES + 1)), "corner that is not there"),
    "JSON of nothing": (glb_of([]), "holds no object"),  # type: ignore[arg-type]
    "no JSON": (SOUND.replace(b'{"asset"', b'"asset"}'), "is not glTF"),
    "not text": (SOUND.replace(b"version", b"versi\xff\xfe"), "is not glTF"),
    "NaN in JSON": (SOUND.replace(b'"scene": 0', b'"x": NaN  '), "NaN"),
    "long numbers": (b'{"asset": {"version": "2.0"}, "x": ' + b"9" * 5000 + b"}", "is not glTF"),
    "deep": (b'{"asset": ' + b"[" * 100_000, "nested too deeply"),
    "very many values": (b'{"asset": [' + b"0," * 7_000_000, "values"),
}


@pytest.mark.parametrize("case", BYTES)
def test_binary_gltf_faults(tmp_path: Path, case: str) -> None:
    content, told = BYTES[case]
    assert told in fault_of(put(tmp_path, "kit.glb", content))
