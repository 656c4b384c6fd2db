"""Scenes to simulate: what is free to move, how heavy it is."""

from __future__ import annotations

import pytest

from flat import flat_solution
from scenewright.catalog.assets import shipped
from scenewright.catalog.kinds import KINDS
from scenewright.domains import scene_of
from scenewright.formats.simulation.masses import is_free, mass_of, substance_of
from scenewright.render.items import RenderItem, things

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


def test_what_nothing_but_its_weight_holds_is_free() -> None:
    items = things(scene_of(flat_solution()), shipped())
    free = {str(item.extras["category"]) for item in items if is_free(item, shipped())}
    assert free
    for name in free:
        kind = KINDS[name]
        assert kind.support in ("floor", "top"), name
        assert not any(service.outlet == "water" for service in kind.services), name
    assert not any(is_free(item, shipped()) for item in items if item.kind != "piece")


@pytest.mark.parametrize(("category", "free"), [("dining_chair", True), ("wardrobe", False)])
def test_chairs_are_moved_and_wardrobes_are_screwed_to_the_wall(category: str, free: bool) -> None:
    asset = shipped().of(category)[0]
    parts = asset.mesh(asset.usual)
    extras = {"category": category}
    item = RenderItem("a", "piece", "0", "room", "a", parts, (0.0, 0.0, 0.0), 0.0, extras)
    assert is_free(item, shipped()) is free


def test_every_material_of_a_palette_is_its_own_substance() -> None:
    assert substance_of("wall plaster, industrial steel") == substance_of("plaster")
    assert substance_of("white lacquer") != substance_of("white ceramic")
