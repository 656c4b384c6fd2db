"""Hostile OBJ, material and STL files: one line each."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from hostile_models import SECRET, fault_of
from model_files import TETRAHEDRON, obj_text, put
from scenewright.catalog.models import report

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
    "colour not a number": ("newmtl a\nKd nan 0 0", "kit.mtl: line 2: 'nan' is not a number"),
    "colour a word": ("newmtl a\nKd red 0 0", "'red' is not a number"),
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


STL = {
    "neither": (b"hello" * 50, "is not STL"),
    "count beyond": (b"\0" * 80 + struct.pack("<I", 2**32 - 1) + b"\0" * 50, "is not STL"),
    "two corners": (b"solid\nvertex 0 0 0\nvertex 1 0 0\n", "three corners"),
    "words": (b"solid\nvertex a b c\nvertex 1 0 0\nvertex 1 1 1\n", "not a number"),
    "nothing": (b"solid x\nendsolid x\n", "no triangles"),
    "not a number": (b"solid\nvertex nan 0 0\nvertex 1 0 0\nvertex 1 1 1\n", "finite place"),
}


@pytest.mark.parametrize("case", STL)
def test_stl_faults(tmp_path: Path, case: str) -> None:
    content, told = STL[case]
    assert told in fault_of(put(tmp_path, "kit.stl", content))
