"""Scenes to simulate: what is free to move, how heavy it is."""

from __future__ import annotations

import pytest

from flat import flat_solution
from scenewright.catalog.assets import shipped
from scenewright.catalog.classes import LIGHT_FURNITURE
from scenewright.catalog.kinds import KINDS
from scenewright.domains import scene_of
from scenewright.formats.simulation.masses import is_free, mass_of, substance_of
from scenewright.render.items import things

WEIGHED = {
    "dining_chair": (2.5, 12),
    "double_bed": (30, 220),
    "fridge": (40, 110),
    "sofa": (20, 110),
    "vase": (0.2, 4),
    "wardrobe": (80, 350),
}
"""Kilograms such things weigh in shops, least and most."""


@pytest.mark.parametrize("category", WEIGHED)
def test_things_are_as_heavy_as_in_shops(category: str) -> None:
    least, most = WEIGHED[category]
    for asset in shipped().of(category):
        assert least <= mass_of(asset.mesh(asset.usual)) <= most, asset.id


def test_light_furniture_and_what_stands_on_others_is_free() -> None:
    items = things(scene_of(flat_solution()), shipped())
    free = {str(item.extras["category"]) for item in items if is_free(item, shipped())}
    assert "sofa" not in free
    assert free <= LIGHT_FURNITURE | {name for name, kind in KINDS.items() if kind.support == "top"}
    assert not any(is_free(item, shipped()) for item in items if item.kind != "piece")


def test_every_material_of_a_palette_is_its_own_substance() -> None:
    assert substance_of("wall plaster, industrial steel") == substance_of("plaster")
    assert substance_of("white lacquer") != substance_of("white ceramic")
