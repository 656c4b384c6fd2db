"""Model files are hostile: every fault is one line, nothing outside a folder is read, memory is
bounded."""

from __future__ import annotations

import copy
import io
import json
import os
import struct
import tracemalloc
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from scenewright.errors import InputError
from scenewright.models import library, load, report
from scenewright.models.as_asset import asset_of
from scenewright.models.model import Options
from test_models import (
    CUBE,
    PIECE,
    SHELL,
    SIDES,
    SOLID,
    TETRAHEDRON,
    city_of,
    furniture,
    glb_of,
    gltf_of,
    obj_text,
    put,
)

Json = dict[str, Any]
SECRET = "the secret of another folder"


def fault_of(path: Path) -> str:
    """The one line that reading a file leads to; what several models of a file say counts."""
    found = report(path)
    assert not found.models, "it was read"
    assert found.skipped
    for one in found.skipped:
        assert len(one.reason.splitlines()) == 1
        assert len(one.reason) < 400
        assert one.reason.isprintable()
        assert SECRET not in one.reason
    with pytest.raises(InputError) as caught:
        library(path)
    assert len(str(caught.value).splitlines()) == 1
    return found.skipped[0].reason


OBJ = {
    "empty": (b"", "is empty"),
    "binary": (bytes(range(256)) * 40, "holds no faces"),
    "no faces": (b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "holds no faces"),
    "only lines": (b"v 0 0 0\nv 1 0 0\nl 1 2\nf 1 2\n", "holds no faces"),
    "not a number": (b"v nan 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n", "finite place"),
    "infinite": (b"v inf 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n", "finite place"),
    "too far": (b"v 1e300 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n", "finite place"),
    "words for numbers": (b"v one 0 0\n", "line 1: 'v one 0 0' cannot be read"),
    "short vertex": (b"\nv 1 2\n", "line 2: 'v 1 2' cannot be read"),
    "corner zero": (b"v 0 0 0\nv 1 0 0\nv 0 1 1\nf 0 1 2\n", "line 4: there is no corner 0"),
    "corner beyond": (b"v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 9\n", "corner that is not there"),
    "negative beyond": (b"v 0 0 0\nv 1 0 0\nv 0 1 1\nf -1 -2 -4\n", "line 4: there is no corner"),
    "huge corner": (b"v 0 0 0\nf 1 2 99999999999999999999\n", "there is no corner"),
    "texture corner beyond": (obj_text().replace("f 1 3 2", "f 1/5 3/5 2/5").encode(), "corner"),
    "broken corner": (b"v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 x\n", "line 4"),
    "long polygon": (b"v 0 0 0\nf " + b"1 " * 5001, "more than 5000 corners"),
    "flat": (b"v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n", "is flat"),
    "a point": (b"v 1 1 1\nf 1 1 1\n", "is a single point"),
    "a line": (b"v 0 0 0\nv 1 1 1\nf 1 2 1\nv 0 0 0\n", None),
    "too large": (obj_text(TETRAHEDRON * 1e7).encode(), "m large"),
    "many materials": (b"".join(b"usemtl m%d\n" % i for i in range(10_002)), "materials"),
    "many libraries": (b"mtllib a.mtl\n" * 60, "material libraries"),
    "library outside": (obj_text(head="mtllib ../out.mtl").encode(), "outside its folder"),
    "library absolute": (obj_text(head="mtllib /etc/passwd").encode(), "outside its folder"),
    "library by scheme": (obj_text(head="mtllib http://x/a.mtl").encode(), "outside its folder"),
    "library on a drive": (obj_text(head="mtllib C:\\a.mtl").encode(), "outside its folder"),
    "escape signs": (b"v \x1b[31m\x07 0 0\n", "cannot be read"),
}


@pytest.mark.parametrize("case", OBJ)
def test_obj_faults(tmp_path: Path, case: str) -> None:
    content, told = OBJ[case]
    path = put(tmp_path, "kit.obj", content)
    if told is not None:
        assert told in fault_of(path)
    else:
        report(path)


MTL = {
    "texture outside": ("newmtl a\nmap_Kd ../secret.png", "outside its folder"),
    "texture outside, deeper": ("newmtl a\nmap_Kd x/../../secret.png", "outside its folder"),
    "texture by scheme": ("newmtl a\nmap_Kd file:///etc/passwd", "outside its folder"),
    "texture with a zero": ("newmtl a\nmap_Kd a\0b.png", "outside its folder"),
    "colour not a number": ("newmtl a\nKd nan 0 0", "kit.mtl: line 2: 'nan' is no number"),
    "colour a word": ("newmtl a\nKd red 0 0", "'red' is no number"),
    "many materials": ("newmtl x\n" + "".join(f"newmtl {i}\n" for i in range(10_001)), "more than"),
}


@pytest.mark.parametrize("case", MTL)
def test_material_faults(tmp_path: Path, case: str) -> None:
    content, told = MTL[case]
    put(tmp_path, "secret.png", SECRET)
    (tmp_path / "in").mkdir()
    put(tmp_path, "in/kit.mtl", content)
    text = obj_text(head="mtllib kit.mtl\nvt 0 0\nusemtl a")
    assert told in fault_of(put(tmp_path, "in/kit.obj", text))


def changed(change: Callable[[Json], object]) -> Json:
    document = copy.deepcopy(gltf_of(TETRAHEDRON, SIDES))
    change(document)
    return document


def chain(document: Json) -> None:
    document["nodes"] = [{"children": [k + 1]} for k in range(3000)] + [{"children": [0]}]


GLTF: dict[str, tuple[Callable[[Json], object], str]] = {
    "no version": (lambda d: d.pop("asset"), "tells no version"),
    "glTF 1": (lambda d: d["asset"].update(version="1.0"), "is glTF 1.0"),
    "draco": (lambda d: d.update(extensionsRequired=["KHR_draco_mesh_compression"]),
              "is compressed (KHR_draco_mesh_compression); export it without"),
    "meshopt": (lambda d: d.update(extensionsRequired=["EXT_meshopt_compression"]),
                "is compressed (EXT_meshopt_compression)"),
    "unknown extension": (lambda d: d.update(extensionsRequired=["ACME_\x1bmagic"]), "ACME_magic"),
    "count beyond bytes": (lambda d: d["accessors"][0].update(count=5), "more than its bytes"),
    "huge count": (lambda d: d["accessors"][0].update(count=2**39), "numbers in a row"),
    "huge count of nothing": (lambda d: d["accessors"][0].update(count=2**39, bufferView=None),
                              "numbers in a row"),
    "count beyond any": (lambda d: d["accessors"][0].update(count=2**80), "not possible"),
    "negative count": (lambda d: d["accessors"][0].update(count=-1), "is not possible"),
    "negative offset": (lambda d: d["accessors"][0].update(byteOffset=-8), "is not possible"),
    "offset beyond": (lambda d: d["accessors"][0].update(byteOffset=40), "more than its bytes"),
    "unknown numbers": (lambda d: d["accessors"][0].update(componentType=5130), "unknown type"),
    "wrong vectors": (lambda d: d["accessors"][0].update(type="VEC2"), "not vectors of 3"),
    "indices as fractions": (lambda d: d["accessors"][1].update(componentType=5126, count=6),
                             "not whole numbers"),
    "view beyond buffer": (lambda d: d["bufferViews"][0].update(byteLength=10**6), "beyond its"),
    "view of no buffer": (lambda d: d["bufferViews"][0].update(buffer=7), "buffers[7]"),
    "no such view": (lambda d: d["accessors"][0].update(bufferView=9), "bufferViews[9]"),
    "no such accessor": (lambda d: d["meshes"][0]["primitives"][0].update(indices=8),
                         "accessors[8]"),
    "no such mesh": (lambda d: d["nodes"][0].update(mesh=3), "meshes[3] is not there"),
    "no such node": (lambda d: d["scenes"][0].update(nodes=[4]), "nodes[4] is not there"),
    "no such scene": (lambda d: d.update(scene=4), "scenes[4] is not there"),
    "no such material": (lambda d: d["meshes"][0]["primitives"][0].update(material=2),
                         "materials[2]"),
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
    "grows without end": (lambda d: d.update(nodes=[
        *({"children": [k + 1], "scale": [1e9] * 3} for k in range(60)), {"mesh": 0}]), "finite"),
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
    "image outside": (lambda d: d.update(
        images=[{"uri": "../a.png"}], textures=[{"source": 0}],
        materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]), "outside"),
    "a list for an object": (lambda d: d.update(nodes={}), "give a list"),
    "sparse beyond": (lambda d: d["accessors"][0].update(sparse={
        "count": 4, "indices": {"bufferView": 1, "componentType": 5123, "byteOffset": 12},
        "values": {"bufferView": 1}}), "more than its bytes"),
    "sparse without end": (lambda d: d["accessors"][0].update(sparse={
        "count": 2**30, "indices": {"bufferView": 1, "componentType": 5123},
        "values": {"bufferView": 0}}), "exceptions than numbers"),
}  # fmt: skip


@pytest.mark.parametrize("case", GLTF)
def test_gltf_faults(tmp_path: Path, case: str) -> None:
    change, told = GLTF[case]
    put(tmp_path, "raw.bin", SECRET)
    (tmp_path / "in" / "sub").mkdir(parents=True)
    path = put(tmp_path, "in/kit.gltf", changed(change))
    assert told in fault_of(path)


NAN = np.array([[np.nan, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
SOUND = glb_of(gltf_of(TETRAHEDRON, SIDES))
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
}  # fmt: skip


@pytest.mark.parametrize("case", BYTES)
def test_binary_gltf_faults(tmp_path: Path, case: str) -> None:
    content, told = BYTES[case]
    assert told in fault_of(put(tmp_path, "kit.glb", content))


def surface(rings: Any, **more: Any) -> Json:
    return city_of({"type": "MultiSurface", "lod": "1", "boundaries": rings, **more}, CUBE)


CITY = {
    "another type": ({"type": "FeatureCollection"}, "is no CityJSON"),
    "another version": (city_of(SOLID, CUBE, version="3.0"), "is CityJSON 3.0"),
    "version no text": (city_of(SOLID, CUBE, version=2), "is CityJSON unknown"),
    "no objects": (city_of(SOLID, CUBE, CityObjects=[]), "CityObjects are no objects"),
    "objects of nothing": (city_of(SOLID, CUBE, CityObjects={"a": 1}), "are no objects"),
    "no buildings": (city_of(SOLID, CUBE, CityObjects={"a": {"type": "Road"}}), "no buildings"),
    "no geometry": (city_of(SOLID, CUBE, CityObjects={"a": {"type": "Building"}}), "no geometry"),
    "only instances": (city_of({"type": "GeometryInstance"}, CUBE), "no geometry"),
    "vertices missing": (city_of(SOLID, []), "corner that is not there"),
    "vertices of words": (city_of(SOLID, [["a", "b", "c"]]), "rows of three numbers"),
    "vertices of pairs": (city_of(SOLID, [[0, 0], [1, 1]]), "rows of three numbers"),
    "vertices uneven": (city_of(SOLID, [[0, 0, 0], [1, 1]]), "rows of three numbers"),
    "vertices far away": (city_of(SOLID, [[10**300, 0, 0]] * 8), "finite place"),
    "vertices beyond all": (city_of(SOLID, [[10**400, 0, 0]] * 8), "rows of three numbers"),
    "transform of words": (city_of(SOLID, CUBE, transform={"scale": "x"}), "transform"),
    "transform of nothing": (city_of(SOLID, CUBE, transform={"scale": [0, 0, 0]}), "area"),
    "corner beyond": (surface([[[0, 1, 99]]]), "corner that is not there"),
    "corner negative": (surface([[[0, 1, -1]]]), "corner that is not there"),
    "corner a fraction": (surface([[[0, 1, 1.5]]]), "corner that is not there"),
    "corner a switch": (surface([[[0, 1, True]]]), "corner that is not there"),
    "corner a list": (surface([[[0, 1, [2]]]]), "corner that is not there"),
    "surface a number": (surface([7]), "no list of rings"),
    "no list": (surface("roof"), "boundaries are no list"),
    "too shallow": (city_of(SOLID | {"boundaries": [[0, 1, 2]]}, CUBE), "no list of rings"),
    "too deep": (surface([[[[0, 1, 2]]]]), "corner that is not there"),
    "two corners": (surface([[[0, 1]]]), "no surface with an area"),
    "one place": (surface([[[1, 1, 1, 1]]]), "no surface with an area"),
    "long ring": (surface([[[0, 2, 6] * 7000]]), "more than 20,000 corners"),
    "flat": (surface(SHELL[:1]), "is flat"),
    "in itself": (city_of(SOLID, CUBE, CityObjects={
        "a": {"type": "BuildingPart", "parents": ["a"], "children": ["a"]}}), "no buildings"),
}  # fmt: skip


@pytest.mark.parametrize("case", CITY)
def test_cityjson_faults(tmp_path: Path, case: str) -> None:
    document, told = CITY[case]
    assert told in fault_of(put(tmp_path, "town.json", document))


def test_wrong_meanings_of_surfaces_do_no_harm(tmp_path: Path) -> None:
    for semantics in (
        None,
        7,
        {"surfaces": 7},
        {"surfaces": [7], "values": "x"},
        {"surfaces": [{"type": []}], "values": [[0, -1, 9, None, "a", [0]]]},
    ):
        path = put(tmp_path, "t.json", city_of(SOLID | {"semantics": semantics}, CUBE))
        assert len(library(path)) == 1


LIBRARY = {
    "no model line": ("name#1=x", "lists no models"),
    "model outside": (PIECE.replace("/kit/table.obj", "../../table.obj"), "outside its folder"),
    "model on a drive": (PIECE.replace("/kit/table.obj", "C:/table.obj"), "outside its folder"),
    "model missing": (PIECE.replace("table.obj", "chair.obj"), "is missing"),
    "kind not read": (PIECE.replace("table.obj", "table.dae"), "'.dae' models are not read"),
    "no size": (PIECE.replace("width#1", "wide#1"), "its size is not possible"),
    "no width": (PIECE.replace("width#1=80", "width#1=0"), "its size is not possible"),
    "endless width": (PIECE.replace("width#1=80", "width#1=inf"), "is no length"),
    "width a word": (PIECE.replace("width#1=80", "width#1=wide"), "is no length"),
    "rotation short": (PIECE.replace("0 -1 0", "0"), "not nine numbers"),
    "rotation of words": (PIECE.replace("0 -1 0", "0 -1 x"), "not nine numbers"),
    "rotation that bends": (PIECE.replace("0 -1 0", "0 -9 0"), "is no rotation"),
    "rotation not finite": (PIECE.replace("0 -1 0", "0 nan 0"), "is no rotation"),
    "long line": ("model#1=" + "x" * 30_000, "a line is longer"),
}


@pytest.mark.parametrize("case", LIBRARY)
def test_library_faults(tmp_path: Path, case: str) -> None:
    catalogue, told = LIBRARY[case]
    assert told in fault_of(furniture(tmp_path, catalogue, {"kit/table.obj": obj_text()}))


def zipped(entries: dict[str, bytes]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries.items():
            archive.writestr(name, content)
    return stream.getvalue()


WHOLE = zipped({"PluginFurnitureCatalog.properties": PIECE.encode("latin-1"),
                "kit/table.obj": obj_text().encode()})  # fmt: skip
LIED = zipped({"PluginFurnitureCatalog.properties": b"#" * 100 + b" " * 9_000_000})
PACKED = {
    "no zip": (b"hello", "whole zip archive"),
    "cut off": (WHOLE[: len(WHOLE) // 2], "whole zip archive"),
    "no catalogue": (zipped({"a.txt": b"a"}), "holds no PluginFurnitureCatalog.properties"),
    "catalogue swells": (LIED, "is larger than 8 MiB"),
    "model swells": (zipped({"PluginFurnitureCatalog.properties": PIECE.encode("latin-1"),
                             "kit/table.obj": b"\n" * 30_000_000}), "packed more than 200 times"),
    "model too large": (zipped({"PluginFurnitureCatalog.properties": PIECE.encode("latin-1"),
                                "kit/table.obj": b"\n" * 70_000_000}), "larger than 64 MiB"),
    "damaged": (WHOLE.replace(b"PluginF", b"PluginG", 1), "cannot be unpacked"),
    "many entries": (zipped({f"{k}": b"" for k in range(50_001)}), "holds 50,001 entries"),
}  # fmt: skip


@pytest.mark.parametrize("case", PACKED)
def test_archive_faults(tmp_path: Path, case: str) -> None:
    content, told = PACKED[case]
    assert told in fault_of(put(tmp_path, "shop.sh3f", content))


def test_an_archive_that_lies_about_sizes_is_not_believed(tmp_path: Path) -> None:
    """The size in the directory of the archive says 100 bytes, the entry has 9 MB."""
    true = struct.pack("<I", 9_000_100)
    assert LIED.count(true) == 2
    path = put(tmp_path, "shop.sh3f", LIED.replace(true, struct.pack("<I", 100)))
    assert "cannot be unpacked" in fault_of(path) or "lists no models" in fault_of(path)


STL = {
    "neither": (b"hello" * 50, "is not STL"),
    "count beyond": (b"\0" * 80 + struct.pack("<I", 2**32 - 1) + b"\0" * 50, "is not STL"),
    "two corners": (b"solid\nvertex 0 0 0\nvertex 1 0 0\n", "three corners"),
    "words": (b"solid\nvertex a b c\nvertex 1 0 0\nvertex 1 1 1\n", "no number"),
    "nothing": (b"solid x\nendsolid x\n", "no triangles"),
    "not a number": (b"solid\nvertex nan 0 0\nvertex 1 0 0\nvertex 1 1 1\n", "finite place"),
}


@pytest.mark.parametrize("case", STL)
def test_stl_faults(tmp_path: Path, case: str) -> None:
    content, told = STL[case]
    assert told in fault_of(put(tmp_path, "kit.stl", content))


def test_links_are_not_followed(tmp_path: Path) -> None:
    """Neither to models in a folder nor to files that models name."""
    (tmp_path / "out").mkdir()
    put(tmp_path, "out/real.obj", obj_text())
    put(tmp_path, "out/kit.mtl", f"newmtl a\n# {SECRET}")
    inside = tmp_path / "in"
    inside.mkdir()
    os.symlink(tmp_path / "out" / "real.obj", inside / "link.obj")
    os.symlink(tmp_path / "out", inside / "folder")
    os.symlink(inside, inside / "ring")
    os.symlink(tmp_path / "out" / "kit.mtl", inside / "kit.mtl")
    put(inside, "kit.obj", obj_text(head="mtllib kit.mtl"))
    found = report(inside)
    assert not found.models
    reasons = {one.name: one.reason for one in found.skipped}
    assert set(reasons) == {"kit.obj", "link.obj"}
    assert "a link out of the model's folder" in reasons["kit.obj"]
    assert "is a link" in reasons["link.obj"]


def test_what_is_no_plain_file_is_not_opened(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.obj")
    (tmp_path / "folder.glb").mkdir()
    os.mkfifo(tmp_path / "kit.mtl")
    put(tmp_path, "kit.obj", obj_text(head="mtllib kit.mtl"))
    found = report(tmp_path)
    assert [model.id for model in found.models] == ["kit"]
    assert [one.name for one in found.skipped] == ["pipe.obj"]
    with pytest.raises(InputError, match="is not a plain file"):
        load(tmp_path / "pipe.obj")


def test_names_cannot_harm_a_screen(tmp_path: Path) -> None:
    document = city_of(SOLID, CUBE, CityObjects={
        "a\x1b[2J\n" + "b" * 500: {"type": "Building", "geometry": [SOLID]}})  # fmt: skip
    (model,) = library(put(tmp_path, "t.json", document))
    assert model.id.isprintable()
    assert model.name.isprintable()
    assert len(model.name) <= 80
    assert asset_of(model).id == f"model:{model.id}"


@pytest.mark.parametrize(
    ("options", "told"),
    [(Options(up="y"), "no direction"), (Options(front="+w"), "no direction"),
     (Options(up="+z", front="-z"), "cannot be -z"), (Options(scale=0.0), "single point"),
     (Options(scale=float("nan")), "m large"), (Options(scale=1e9), "m large")],
)  # fmt: skip
def test_options_that_make_no_sense(tmp_path: Path, options: Options, told: str) -> None:
    with pytest.raises(InputError, match=told):
        load(put(tmp_path, "kit.obj", obj_text()), options)


@pytest.mark.parametrize("language", ["../de", "de.properties", "d" * 99])
def test_languages_cannot_name_other_entries(tmp_path: Path, language: str) -> None:
    path = furniture(tmp_path, PIECE, {"kit/table.obj": obj_text()})
    with pytest.raises(InputError, match="is no language"):
        library(path, Options(language=language))


def test_pictures_that_swell_are_refused_before_they_are_unpacked(tmp_path: Path) -> None:
    head = b"IHDR" + struct.pack(">IIBBBBB", 10_000, 10_000, 8, 2, 0, 0, 0)
    size = struct.pack(">I", len(head) - 4)
    check = struct.pack(">I", zlib.crc32(head))
    put(
        tmp_path,
        "big.png",
        b"\x89PNG\r\n\x1a\n" + size + head + check + struct.pack(">I4s", 100, b"IDAT") + bytes(104),
    )
    put(tmp_path, "kit.mtl", "newmtl a\nmap_Kd big.png")
    text = obj_text(head="mtllib kit.mtl\nvt 0 0\nusemtl a").replace("f 1 3 2", "f 1/1 3/1 2/1")
    path = put(tmp_path, "kit.obj", text)
    tracemalloc.start()
    assert "a texture has" in fault_of(path)
    assert tracemalloc.get_traced_memory()[1] < 20 * 2**20
    tracemalloc.stop()


@pytest.mark.parametrize("content", [b"", b"no picture", b"\x89PNG\r\n\x1a\n" + bytes(60)])
def test_broken_pictures_leave_the_plain_colour(tmp_path: Path, content: bytes) -> None:
    put(tmp_path, "a.png", content)
    put(tmp_path, "kit.mtl", "newmtl a\nKd 1 0 0\nmap_Kd a.png")
    path = put(tmp_path, "kit.obj", obj_text(head="mtllib kit.mtl\nusemtl a"))
    if content:
        assert load(path).parts[0].material.color == (1, 0, 0)
    else:
        assert "is empty" in fault_of(path)


def test_few_bytes_do_not_become_much_memory(tmp_path: Path) -> None:
    """Accessors without bytes, drawn again by each of many nodes."""
    document = gltf_of(TETRAHEDRON, SIDES)
    document["accessors"] = [
        {"componentType": 5126, "count": 900_000, "type": "VEC3"},
        {"componentType": 5125, "count": 900_000, "type": "SCALAR"},
    ]
    document["nodes"] = [{"mesh": 0} for _ in range(5000)]
    document["scenes"] = [{"nodes": list(range(5000))}]
    path = put(tmp_path, "kit.gltf", document)
    tracemalloc.start()
    assert "more than" in fault_of(path)
    assert tracemalloc.get_traced_memory()[1] < 400 * 2**20
    tracemalloc.stop()


def test_any_bytes_give_a_model_or_one_line(tmp_path: Path) -> None:
    """Sound files with bytes changed at random, a few hundred times."""
    rng = np.random.default_rng(11)
    sound = {
        "a.obj": obj_text(head="mtllib a.mtl\nusemtl a").encode(),
        "b.glb": SOUND,
        "c.json": json.dumps(city_of(SOLID, CUBE)).encode(),
        "d.sh3f": WHOLE,
        "e.gltf": json.dumps(gltf_of(TETRAHEDRON, SIDES)).encode(),
    }
    for name, content in sound.items():
        for _ in range(60):
            broken = np.frombuffer(content, np.uint8).copy()
            places = rng.integers(0, len(broken), rng.integers(1, 6))
            broken[places] = rng.integers(0, 256, len(places))
            found = report(put(tmp_path, name, broken.tobytes()))
            assert all(len(one.reason.splitlines()) == 1 for one in found.skipped)
