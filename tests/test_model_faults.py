"""Model files are hostile: nothing outside a folder is read, memory is bounded."""

from __future__ import annotations

import json
import os
import struct
import tracemalloc
import zlib
from pathlib import Path

import numpy as np
import pytest

from hostile_models import SECRET, SOUND, WHOLE, fault_of
from model_files import (
    CUBE,
    PIECE,
    SIDES,
    SOLID,
    TETRAHEDRON,
    city_of,
    furniture,
    gltf_of,
    obj_text,
    put,
)
from scenewright.catalog.models import library, load, report
from scenewright.catalog.models.as_asset import asset_of
from scenewright.catalog.models.model import ImportOptions
from scenewright.core.errors import InputError


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
    document = city_of(
        SOLID,
        CUBE,
        CityObjects={"a\x1b[2J\n" + "b" * 500: {"type": "Building", "geometry": [SOLID]}},
    )
    (model,) = library(put(tmp_path, "t.json", document))
    assert model.id.isprintable()
    assert model.name.isprintable()
    assert len(model.name) <= 80
    assert asset_of(model).id == f"model:{model.id}"


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (ImportOptions(up="y"), "not a direction"),
        (ImportOptions(front="+w"), "not a direction"),
        (ImportOptions(up="+z", front="-z"), "cannot be -z"),
        (ImportOptions(scale=0.0), "single point"),
        (ImportOptions(scale=float("nan")), "m large"),
        (ImportOptions(scale=1e9), "m large"),
    ],
)
def test_options_that_make_no_sense(tmp_path: Path, options: ImportOptions, told: str) -> None:
    with pytest.raises(InputError, match=told):
        load(put(tmp_path, "kit.obj", obj_text()), options)


@pytest.mark.parametrize("language", ["../de", "de.properties", "d" * 99])
def test_languages_cannot_name_other_entries(tmp_path: Path, language: str) -> None:
    path = furniture(tmp_path, PIECE, {"kit/table.obj": obj_text()})
    with pytest.raises(InputError, match="is not a language"):
        library(path, ImportOptions(language=language))


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
