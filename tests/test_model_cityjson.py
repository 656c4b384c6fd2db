"""Models from CityJSON."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from model_files import CUBE, SHELL, SOLID, body, city_of, put
from scenewright.catalog.models import library
from scenewright.geometry.mesh import volume


def test_cityjson_solids_have_roofs_walls_and_true_sizes(tmp_path: Path) -> None:
    (model,) = library(put(tmp_path, "town.json", city_of(SOLID, CUBE)))
    assert model.id == "town/house"
    assert sorted(model.size) == [3, 4, 5]
    assert volume(body(model)) == pytest.approx(60.0)
    assert {p.material.name: len(p.faces) for p in model.parts} == {
        "ground": 2,
        "roof": 2,
        "wall": 8,
    }


def test_cityjson_surfaces_keep_their_holes_and_meanings(tmp_path: Path) -> None:
    courtyard = [[2, 2, 10], [2, 4, 10], [6, 4, 10], [6, 2, 10]]
    roof = [[1, 5, 7, 3], [8, 9, 10, 11]]
    geometry = {
        "type": "MultiSurface",
        "lod": "2",
        "boundaries": [roof, [[0, 4, 5, 1]]],
        "semantics": {
            "surfaces": [{"type": "WallSurface"}, {"type": "RoofSurface"}],
            "values": [1, 0],
        },
    }
    (model,) = library(put(tmp_path, "town.json", city_of(geometry, CUBE + courtyard)))
    areas = {}
    for part in model.parts:
        a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
        areas[part.material.name] = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    assert areas == {"roof": pytest.approx(12 - 2.0), "wall": pytest.approx(20.0)}


def test_cityjson_takes_the_best_detail_and_puts_parts_together(tmp_path: Path) -> None:
    low = {"type": "Solid", "lod": 1, "boundaries": [SHELL[:3]]}
    document = city_of(low, CUBE)
    document["CityObjects"] = {
        "whole": {"type": "Building", "children": ["a", "b"]},
        "a": {"type": "BuildingPart", "parents": ["whole"], "geometry": [SOLID, low]},
        "b": {"type": "BuildingPart", "parents": ["whole"], "geometry": [SOLID]},
        "lost": {"type": "BuildingPart", "parents": ["gone"], "geometry": [low, SOLID]},
        "road": {"type": "Road", "geometry": [SOLID]},
    }
    models = library(put(tmp_path, "town.json", document))
    assert {m.id: len(body(m).faces) for m in models} == {"town/whole": 24, "town/lost": 12}


@pytest.mark.parametrize("degrees", [0, 20, 44, 70, 135])
def test_cityjson_buildings_are_turned_along_their_box(tmp_path: Path, degrees: float) -> None:
    angle = np.deg2rad(degrees)
    turn = np.array(
        [[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    vertices = np.round(np.array(CUBE) @ turn * 1000).astype(int).tolist()
    frame = {"scale": [0.001] * 3, "translate": [2.6e6, 1.2e6, 400]}
    (model,) = library(put(tmp_path, "t.json", city_of(SOLID, vertices, transform=frame)))
    assert sorted(model.size) == pytest.approx([6, 8, 10], abs=0.01)
