"""Models declared as parts: rows, words, repeats, plans, and what is refused."""

from __future__ import annotations

from importlib import resources

import numpy as np
import pytest

from scenewright.catalog.assets.declared import read_blocks, read_family
from scenewright.catalog.assets.joinery import four_legs
from scenewright.catalog.assets.materials import BLACK, NAVY, OAK, RED
from scenewright.catalog.assets.model import parts
from scenewright.core.scene import Size
from scenewright.geometry.solids import slab

SIZE = Size(1.2, 0.6, 0.75)
TABLE = """
LOW = 0.02

form feet(inset)
  four_legs(0.6, 0.3, (0, 0.7), LOW, 0.01, inset)

desk(id="desk_plain", name="Plain desk")
  # A top on four legs.
  top = h - 0.05
  OAK: slab((-w, w), (-d, d),
    (top, h))
  BLACK: feet(0.01)
  plan: rectangle(size)
  plan: path((x, -d), (x, d)) for x in (-0.1, 0.1)
"""


def test_a_row_is_what_a_function_would_draw() -> None:
    [desk] = read_family(TABLE, "")
    assert (desk.category, desk.id, desk.name) == ("desk", "desk_plain", "Plain desk")
    top = slab((-0.6, 0.6), (-0.3, 0.3), (0.7, 0.75))
    expected = parts(SIZE, {OAK: [top], BLACK: four_legs(0.6, 0.3, (0, 0.7), 0.02, 0.01, 0.01)})
    for one, other in zip(desk.mesh(SIZE), expected, strict=True):
        assert one.material == other.material
        np.testing.assert_array_equal(one.vertices, other.vertices)
        np.testing.assert_array_equal(one.faces, other.faces)
    assert [len(line) for line in desk.symbol(SIZE)] == [5, 2, 2]


def test_colours_and_a_mirror_image_are_models_of_their_own() -> None:
    text = "stool(colours=(NAVY, RED))\n  colour: disc(w, (0, h))\n"
    assert [(row.id, row.mesh(SIZE)[0].material) for row in read_family(text, "")] == [
        ("", NAVY),
        ("stool_1", RED),
    ]
    text = "chaise(mirrored=True)\n  OAK: block((-w, w), (-d, d), (0, h))\n"
    assert [row.id for row in read_family(text, "")] == ["", "chaise_right"]


def test_parts_of_several_materials_stand_in_one_row() -> None:
    text = "crate\n  *: (one, block((-w, w), (-d, d), (0, h))) for one in (OAK, RED)\n"
    [crate] = read_family(text, "")
    assert [part.material for part in crate.mesh(SIZE)] == [OAK, RED]


@pytest.mark.parametrize(
    "formula", ["(lambda: 1)()", "().__class__", "open('a')", "(x := 2)", "__import__('os')"]
)
def test_a_formula_reaches_nothing_but_its_words(formula: str) -> None:
    [model] = read_family(f"stool\n  OAK: {formula}\n", "")
    with pytest.raises((SyntaxError, NameError)):
        model.mesh(SIZE)


def test_every_row_of_the_catalogue_fits_its_line_and_no_block_is_said_twice() -> None:
    folder = resources.files("scenewright.catalog.assets")
    texts = [file for part in folder.iterdir() if part.is_dir() for file in part.iterdir()]
    families = [file for file in texts if file.name.endswith(".parts")]
    assert len(families) > 30
    for file in families:
        text = file.read_text("utf-8")
        assert max(map(len, text.splitlines())) <= 100, file.name
        assert len(text.splitlines()) <= 400, file.name
        heads = [block.head for block in read_blocks(text)]
        assert len(heads) == len({*heads}), file.name
