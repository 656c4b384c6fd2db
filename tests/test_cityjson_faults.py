"""Hostile CityJSON files: one line each."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from hostile_models import Json, fault_of
from model_files import CUBE, SHELL, SOLID, city_of, put
from scenewright.catalog.models import library


def surface(rings: Any, **more: Any) -> Json:
    return city_of({"type": "MultiSurface", "lod": "1", "boundaries": rings, **more}, CUBE)


CITY = {
    "another type": ({"type": "FeatureCollection"}, "is not CityJSON"),
    "another version": (city_of(SOLID, CUBE, version="3.0"), "is CityJSON 3.0"),
    "version no text": (city_of(SOLID, CUBE, version=2), "is CityJSON unknown"),
    "no objects": (city_of(SOLID, CUBE, CityObjects=[]), "CityObjects are no objects"),
    "objects of nothing": (city_of(SOLID, CUBE, CityObjects={"a": 1}), "are no objects"),
    "no buildings": (city_of(SOLID, CUBE, CityObjects={"a": {"type": "Road"}}), "no buildings"),
    "no geometry": (city_of(SOLID, CUBE, CityObjects={"a": {"type": "Building"}}), "no geometry"),
    "only instances": (city_of({"type": "GeometryInstance"}, CUBE), "template that is not there"),
    "vertices missing": (city_of(SOLID, []), "corner that is not there"),
    "vertices of words": (city_of(SOLID, [["a", "b", "c"]]), "rows of three numbers"),
    "vertices of pairs": (city_of(SOLID, [[0, 0], [1, 1]]), "rows of three numbers"),
    "vertices uneven": (city_of(SOLID, [[0, 0, 0], [1, 1]]), "rows of three numbers"),
    "vertices far away": (city_of(SOLID, [[10**300, 0, 0]] * 8), "finite place"),
    "vertices beyond all": (city_of(SOLID, [[10**400, 0, 0]] * 8), "rows of three numbers"),
    "transform of words": (city_of(SOLID, CUBE, transform={"scale": "x"}), "transform"),
    "transform of nothing": (city_of(SOLID, CUBE, transform={"scale": [0, 0, 0]}), "area"),
    "corner beyond": (surface([[[0, 1, 99]]]), "corner that is not there"),
    "corner negative": (surface([[[0, 1, -1]]]), "corner that is not there"),
    "corner a fraction": (surface([[[0, 1, 1.5]]]), "corner that is not there"),
    "corner a switch": (surface([[[0, 1, True]]]), "corner that is not there"),
    "corner a list": (surface([[[0, 1, [2]]]]), "corner that is not there"),
    "surface a number": (surface([7]), "not a list of rings"),
    "no list": (surface("roof"), "boundaries are no list"),
    "too shallow": (city_of(SOLID | {"boundaries": [[0, 1, 2]]}, CUBE), "not a list of rings"),
    "too deep": (surface([[[[0, 1, 2]]]]), "corner that is not there"),
    "two corners": (surface([[[0, 1]]]), "no surface with an area"),
    "one place": (surface([[[1, 1, 1, 1]]]), "no surface with an area"),
    "long ring": (surface([[[0, 2, 6] * 7000]]), "more than 20,000 corners"),
    "flat": (surface(SHELL[:1]), "is flat"),
    "in itself": (
        city_of(
            SOLID,
            CUBE,
            CityObjects={"a": {"type": "BuildingPart", "parents": ["a"], "children": ["a"]}},
        ),
        "no buildings",
    ),
}


@pytest.mark.parametrize("case", CITY)
def test_cityjson_faults(tmp_path: Path, case: str) -> None:
    document, told = CITY[case]
    assert told in fault_of(put(tmp_path, "town.json", document))


def test_wrong_meanings_of_surfaces_do_no_harm(tmp_path: Path) -> None:
    for semantics in (
        None,
        7,
        {"surfaces": 7},
        {"surfaces": [7], "values": "x"},
        {"surfaces": [{"type": []}], "values": [[0, -1, 9, None, "a", [0]]]},
    ):
        path = put(tmp_path, "t.json", city_of(SOLID | {"semantics": semantics}, CUBE))
        assert len(library(path)) == 1
