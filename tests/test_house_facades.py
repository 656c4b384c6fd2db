"""Facades of houses over random footprints, in every style and form: doors, windows and eaves know
each other."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.facades import count_blank_models, count_faults, has_orphan_eave, widest_blank

from scenewright.catalog.assets.buildings.house_fronts import openings
from scenewright.catalog.assets.buildings.house_looks import FORMS, LOOKS
from scenewright.catalog.assets.buildings.house_walls import front_bays
from scenewright.catalog.assets.buildings.rural_houses import build_house
from scenewright.catalog.assets.materials import PANE, RENDER, TILES
from scenewright.core.catalog import Part
from scenewright.core.scene import Size
from scenewright.geometry.solids import block

SOME = 12
"""Footprints of a style here; `bench ground` looks at 200."""


@pytest.mark.parametrize("style", list(LOOKS))
def test_no_facade_of_a_style_has_a_fault(style: str) -> None:
    assert count_faults(style, seed=3, count=SOME) == (0, 0, 0)


@pytest.mark.parametrize("form", [form for form in FORMS if form != "house"])
def test_no_facade_of_a_form_has_a_fault(form: str) -> None:
    style = list(LOOKS)[list(FORMS).index(form) % len(LOOKS)]
    assert count_faults(style, form, seed=5, count=SOME) == (0, 0, 0)


def test_no_model_is_blank_where_it_is_wide() -> None:
    assert count_blank_models()[0] == 0


def test_a_wall_without_windows_is_blank_and_an_eave_before_a_wall_an_orphan() -> None:
    wall = Part(RENDER, *block((-20, 20), (-5, 5), (0, 9)))
    pane = Part(PANE, *block((4, 6), (5, 5.1), (1, 2)))
    assert widest_blank((wall,)) == pytest.approx(40.0, abs=0.3)
    assert widest_blank((wall, pane)) == pytest.approx(24.0, abs=0.5)
    eave = Part(TILES, *block((-20, 20), (5, 5.3), (4, 4.2)))
    outline = ((-20.0, -5.0), (20.0, -5.0), (20.0, 5.0), (-20.0, 5.0))
    assert has_orphan_eave((wall, eave), outline, "rural")
    assert not has_orphan_eave((wall,), outline, "rural")


def test_a_front_has_its_door_in_a_bay_of_its_own() -> None:
    for length in np.arange(3.0, 30.0, 0.7).tolist():
        rows = front_bays(length, 2.7)
        assert len(rows) == 2 or len(rows) % 2 == 1
        assert all(b - a >= 0.6 for a, b in rows)
    box = ((-2.7, -4.5), (2.7, -4.5), (2.7, 4.5), (-2.7, 4.5))
    row = openings(box, 5.4, LOOKS["rural"], FORMS["row"])
    sides = [mesh for mesh in row.panes if np.abs(mesh.vertices[:, 0]).max() > 2.72]
    assert not sides
    assert openings(box, 5.4, LOOKS["rural"]).panes


def test_a_shop_has_its_panes_and_its_sign_on_the_front_alone() -> None:
    box = ((-5.0, -4.5), (5.0, -4.5), (5.0, 4.5), (-5.0, 4.5))
    found = openings(box, 5.4, LOOKS["brick"], FORMS["shop"])
    assert found.shops
    assert all(mesh.vertices[:, 1].min() > 4.4 for mesh in found.shops)
    low = [mesh for mesh in found.panes if mesh.vertices[:, 2].max() < 2.7]
    front = [mesh for mesh in low if mesh.vertices[:, 1].min() > 4.4]
    area = sum(np.ptp(mesh.vertices[:, 0]) * np.ptp(mesh.vertices[:, 2]) for mesh in front)
    assert area > 0.3 * 10.0 * 2.7


@pytest.mark.parametrize("style", list(LOOKS))
def test_the_walls_of_a_row_meet_its_neighbours(style: str) -> None:
    drawn = build_house(Size(5.4, 9.0, 8.4), (), style, "gabled", "row")
    wall = max(drawn, key=lambda part: float(np.ptp(part.vertices[:, 2])))
    assert np.ptp(wall.vertices[:, 0]) == pytest.approx(5.4, abs=0.2)
