"""Building styles: the table against the catalog, tone and symmetry against models known."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.catalog.assets import shipped
from scenewright.catalog.assets.buildings.building_styles import (
    STYLES,
    facade,
    facade_of_style,
    floors_of,
    lightness,
)
from scenewright.catalog.assets.buildings.roofs import gable
from scenewright.catalog.kinds import SIZES
from scenewright.core.catalog import Material, Part
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.solids import block

WHITE = Material("white", (1.0, 1.0, 1.0))
BLACK = Material("black", (0.0, 0.0, 0.0))


def _part(material: Material, *boxes: Mesh) -> Part:
    mesh = merge(list(boxes))
    return Part(material, mesh.vertices, mesh.faces)


def test_every_style_is_a_building_and_every_building_a_style() -> None:
    assert {asset.id for asset in shipped().of("building")} == set(STYLES)
    assert sum(style.named for style in STYLES.values()) == 19
    low, _, high = (np.array(size) for size in SIZES["building"])
    for style in STYLES.values():
        asset = shipped().assets[style.id]
        assert style.floors * style.storey <= 1.1 * asset.usual.height
        assert np.all(low <= np.array(asset.smallest)), style.id
        assert np.all(np.array(asset.largest) <= high), style.id


def test_buildings_are_larger_than_any_fixed_item_may_be() -> None:
    slab = shipped().assets["modern_residential"]
    points = np.concatenate([part.vertices for part in slab.mesh(Size(90.0, 20.0, 54.0))])
    assert np.ptp(points, axis=0) == pytest.approx([90.0, 20.0, 54.0])


def test_a_plain_box_is_as_light_as_its_paint_and_wholly_symmetric() -> None:
    grey = Material("grey", (0.5, 0.5, 0.5))
    tone, symmetry = facade([_part(grey, block((3, 9), (0, 4), (0, 5)))])
    assert tone == pytest.approx(lightness(grey.color))
    assert symmetry == 1.0


def test_tone_is_the_share_of_black_and_white_that_is_seen() -> None:
    wall = _part(WHITE, block((0, 8), (0, 4), (0, 4)))
    front = _part(BLACK, block((0, 8), (4, 4.5), (0, 1)))
    behind = _part(BLACK, block((0, 8), (-9, 0), (0, 4)))
    roof = _part(BLACK, gable((0, 8), (0, 4), (4, 5)))
    assert facade([wall]).tone == pytest.approx(1.0)
    assert facade([wall, front]).tone == pytest.approx(0.75, abs=0.02)
    assert facade([wall, behind, roof]).tone == pytest.approx(1.0, abs=0.02)


def test_symmetry_sees_outline_depth_and_colour() -> None:
    whole = block((-4, 4), (0, 4), (0, 4))
    tower = block((2, 4), (0, 4), (4, 8))
    assert facade([_part(WHITE, whole, tower)]).symmetry == pytest.approx(2 / 3, abs=0.02)
    forward = block((0, 4), (4, 6), (0, 4))
    assert facade([_part(WHITE, whole, forward)]).symmetry == pytest.approx(0.0, abs=0.02)
    pane = _part(BLACK, block((-3, -1), (4, 4.05), (1, 3)))
    assert facade([_part(WHITE, whole), pane]).symmetry == pytest.approx(0.75, abs=0.03)
    both = _part(BLACK, block((1, 3), (4, 4.05), (1, 3)))
    assert facade([_part(WHITE, whole), pane, both]).symmetry == pytest.approx(1.0, abs=0.03)


def test_churches_are_symmetric_and_the_villa_is_not() -> None:
    found = {style: facade_of_style(style) for style in STYLES}
    for style in ("gothic_church", "baroque_church", "mosque", "museum", "palace"):
        assert found[style].symmetry > 0.95, style
    for style in ("villa", "gallery", "japanese_house", "steampunk_works"):
        assert found[style].symmetry < 0.5, style
    assert found["classical_residence"].tone > found["pagoda"].tone + 0.2
    assert all(0.0 <= value <= 1.0 for row in found.values() for value in row)


def test_floors_follow_the_height() -> None:
    tower = STYLES["point_tower"]
    assert floors_of(tower, shipped().assets["point_tower"].usual.height) == tower.floors
    assert floors_of(tower, 1.0) == 1
    assert floors_of(STYLES["pavilion"], 30.0) == 0
