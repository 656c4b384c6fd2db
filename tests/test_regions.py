"""Finishes of homes by region: asked for by a word of the style, worn with its palette."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.building.finishes import PLASTER, WOOD_FLOOR
from scenewright.building.palettes import answers, paint
from scenewright.building.regions import REGIONS, region_of
from scenewright.catalog.assets.materials import OAK
from scenewright.core.catalog import Part
from scenewright.render.textures.table import texture_of

NONE = np.zeros((0, 3))


def names(palette: str) -> list[str]:
    parts = tuple(Part(m, NONE, NONE.astype(int)) for m in (WOOD_FLOOR, PLASTER, OAK))
    return [part.material.name for part in paint(parts, palette)]


@pytest.mark.parametrize("region", REGIONS)
def test_a_region_changes_floors_and_keeps_the_colours_of_its_palette(region: str) -> None:
    plain, own = names("boho/sea"), names(f"boho/sea {region}")
    assert own[0] == REGIONS[region].rooms.name != plain[0]
    assert own[2] == plain[2] == "oak, boho sea"
    assert answers(region)
    for word in REGIONS[region].words.split():
        assert region_of(f"retro {word}") == region
    assert all(texture_of(material.name) for material in REGIONS[region][1:])


def test_no_two_regions_are_floored_alike_and_no_word_asks_for_two() -> None:
    assert len({row.rooms for row in REGIONS.values()}) == len(REGIONS)
    words = [word for name, row in REGIONS.items() for word in (name, *row.words.split())]
    assert len(words) == len({*words})
