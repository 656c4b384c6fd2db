"""City models continued: what is placed covers what its piece covers, and roads are read."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import shapely

import scenewright as sw
from catalogs import city, flat, saved
from scenewright.core.piece_outlines import polygons_of
from scenewright.ground.reading import read_built
from thoroughness import only_thorough

WING = [(0, 0), (14, 0), (14, 6), (6, 6), (6, 16), (0, 16)]
"""An L: its box covers far more than it does."""


def town(path: Path, angle: float = 0.0) -> Path:
    """Eight L-shaped houses set into each other in pairs, a street before them."""
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    houses = {}
    for k in range(4):
        here = np.array(WING, float) + np.array((26.0 * k, 0.0))
        facing = (22.0 + 26 * k, 18.0) - np.array(WING, float)
        houses |= {f"a{k}": here @ turn, f"b{k}": facing @ turn}
    document = city(houses)
    street = np.array([(-20, -14), (110, -14), (110, -7), (-20, -7)], float) @ turn
    flat(document, "street", "Road", street)
    return saved(path / "town.city.json", document)


def continued(path: Path, **area) -> sw.Solution:
    scene = read_built(path)
    low, high = (f([b.outline for b in scene.buildings]) for f in (_low, _high))
    west, south, north = high[0] + 4.0, low[1] - 20.0, high[1] + 20.0
    outline = [(west, south), (west + 90, south), (west + 90, north), (west, north)]
    outline = [(float(x), float(y)) for x, y in outline]
    document = {
        "domain": "extend",
        "sources": [{"path": str(path)}],
        "areas": [{"outline": outline} | area],
    }
    return sw.solve(sw.Brief.model_validate(document), preset="quick", seed=0)


def _low(rings):
    return np.concatenate(rings).min(0)


def _high(rings):
    return np.concatenate(rings).max(0)


@pytest.mark.parametrize("angle", [0.0, 0.35])
def test_grown_buildings_never_overlap(tmp_path, angle):
    solution = continued(town(tmp_path, angle))
    new = [p for p in solution.pieces if p.category == "building" and p.space != "source"]
    assert len(new) >= 4
    assert [f.message for f in sw.check(solution).findings] == []
    shapes = polygons_of(new)
    assert shapely.area(shapes).sum() - shapely.union_all(shapes).area < 0.05


def test_pieces_cover_the_cleaned_footprints_of_the_source(tmp_path):
    path = town(tmp_path)
    solution = continued(path)
    old = [p for p in solution.pieces if p.space == "source" and p.category == "building"]
    truth = [shapely.Polygon(b.outline) for b in read_built(path).buildings]
    for shape, meant in zip(polygons_of(old), truth, strict=True):
        assert shape.symmetric_difference(meant).area < 0.05
    assert {round(p.size.width * p.size.depth) for p in old} == {14 * 16}


def test_roads_of_a_city_model_are_read_and_continued(tmp_path):
    path = town(tmp_path)
    (road,) = read_built(path).roads
    assert road.width == pytest.approx(7.0, abs=0.01)
    assert road.kind == "road"
    assert np.ptp(road.line, axis=0).tolist() == pytest.approx([130.0, 0.0], abs=0.01)
    solution = continued(path)
    assert sw.check(solution).figures["areas"]["area-1"]["streets_continued"] >= 1


@only_thorough
@pytest.mark.realdata
def test_delft_continued_is_valid(real_data):
    """160 real buildings, many wall to wall, with 143 roads."""
    path = real_data / "citymodels_cityjson" / "delft.json"
    assert len(read_built(path).roads) >= 143
    solution = continued(path, count=40)
    assert [f.message for f in sw.check(solution).findings if f.is_blamed] == []
