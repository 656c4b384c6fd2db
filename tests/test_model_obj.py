"""Models from OBJ files and their materials."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from model_files import TETRAHEDRON, body, obj_text, put
from scenewright.catalog.models import load
from scenewright.catalog.models.facets import quads_cut, triangles
from scenewright.catalog.models.model import ImportOptions
from scenewright.geometry.mesh import volume


def test_obj_numbers_count_from_both_ends_and_polygons_are_cut(tmp_path: Path) -> None:
    star = [
        (np.cos(a) * r, np.sin(a) * r)
        for a, r in zip(np.arange(10) * np.pi / 5, [1, 0.4] * 5, strict=True)
    ]
    rows = [f"v {x} {y} {z}" for z in (0, 1) for x, y in star]
    sides = [f"f {i + 1} {(i + 1) % 10 + 1} {(i + 1) % 10 + 11} {i + 11}" for i in range(10)]
    caps = ["f " + " ".join(str(-k) for k in range(11, 21)), "f -10 -9 -8 -7 -6 -5 -4 -3 -2 -1"]
    model = load(
        put(tmp_path, "star.obj", "\n".join([*rows, *sides, *caps])), ImportOptions("+z", "+y")
    )
    assert len(body(model).faces) == 20 + 16
    exact = 0.5 * 10 * 0.4 * np.sin(np.pi / 5)
    assert volume(body(model)) == pytest.approx(exact)


def test_obj_materials_and_textures_colour_the_faces(tmp_path: Path) -> None:
    picture = np.zeros((4, 4, 3), np.uint8)
    picture[:, :2], picture[:, 2:] = (255, 0, 0), (0, 0, 255)
    Image.fromarray(picture).save(tmp_path / "two colours.png")
    mtl = "newmtl skin\nKd 1 1 1\nmap_Kd two colours.png\nnewmtl glass\nKd 0 1 0\nd 0.25\n"
    put(tmp_path, "kit.mtl", mtl)
    rows = [
        "mtllib kit.mtl",
        *("v {} {} {}".format(*row) for row in TETRAHEDRON.tolist()),
        "vt 0.2 0.5",
        "vt 0.8 0.5",
        "usemtl skin",
        "f 1/1 3/1 2/1",
        "f 1/-1 2/-1 4/-1",
        "usemtl glass",
        "f 1 4 3",
        "f 2 3 4",
    ]
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
