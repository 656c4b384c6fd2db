"""Villages as CityJSON: what is written is read back by our own reader of city models."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import shapely

from scenewright.core.piece_outlines import outline_of
from scenewright.domains import plan_of, solve
from scenewright.formats import read, write
from scenewright.ground.reading.city import city_scene


def test_houses_are_read_back_where_they_stand(tmp_path: Path) -> None:
    brief = read("sample:village-hamlet")
    solution = solve(brief, plan=plan_of(brief), steps=1)
    path = tmp_path / "hamlet.city.json"
    write(solution, path)
    document = json.loads(path.read_text(encoding="utf-8"))
    kinds = [row["type"] for row in document["CityObjects"].values()]
    houses = [piece for piece in solution.pieces if piece.category == "building"]
    assert kinds.count("Building") == len(houses)
    assert {"LandUse", "Road"} <= set(kinds)
    found = city_scene(document, path)
    areas = sorted(shapely.Polygon(outline_of(piece)).area for piece in houses)
    assert len(found.buildings) == len(houses)
    again = sorted(shapely.Polygon(row.outline).area for row in found.buildings)
    assert np.array(again) == pytest.approx(np.array(areas), rel=0.02)


def test_every_solid_is_closed(tmp_path: Path) -> None:
    brief = read("sample:village-street")
    solution = solve(brief, plan=plan_of(brief), steps=1)
    path = tmp_path / "street.city.json"
    write(solution, path)
    document = json.loads(path.read_text(encoding="utf-8"))
    for row in document["CityObjects"].values():
        for geometry in row["geometry"]:
            if geometry["type"] == "Solid":
                (shell,) = geometry["boundaries"]
                edges = [
                    (ring[k - 1], ring[k])
                    for surface in shell
                    for ring in surface
                    for k in range(len(ring))
                ]
                assert sorted(edges) == sorted((b, a) for a, b in edges)
