"""Indoor maps are hostile: one line each, and sound parts are kept."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from indoor_maps import (
    BOOKS,
    DOOR,
    SHOES,
    Json,
    area,
    box,
    crs,
    degrees,
    document,
    floor,
    node,
    read,
)
from scenewright import formats
from scenewright.core.errors import InputError

# Hostile files


def hostile() -> dict[str, tuple[bytes, str]]:
    def dumped(*features: Any, **more: Any) -> bytes:
        return json.dumps(document(*features, **more)).encode()

    wide = area("w", [[500.0, 0.0], [9e7, 0.0], [9e7, 9e7], [500.0, 0.0]], indoor="room")
    polar = area("p", [[0, 89.9], [0.001, 89.9], [0.001, 89.9001], [0, 89.9]], indoor="room")
    bow = [degrees(*p) for p in ((30, 0), (40, 8), (40, 0), (30, 8), (30, 0))]
    room_ = area("a", box(0, 0, 10, 8), indoor="room", level="0-150")
    return {
        "empty": (b"", "is empty"),
        "text": (b"hello", "broken JSON"),
        "cut off": (dumped(SHOES)[:-30], "broken JSON"),
        "not utf-8": (b"\xff\xfe{}", "not UTF-8"),
        "deep": (b"[" * 200_000, "nested too deeply"),
        "long number": (b'{"type":' + b"9" * 10_000 + b"}", "broken JSON"),
        "list": (b"[1, 2]", "holds no GeoJSON features"),
        "geometry only": (b'{"type": "Point", "coordinates": [0, 0]}', 'its type is "Point"'),
        "features no list": (
            b'{"type": "FeatureCollection", "features": 3}',
            "holds no list of features",
        ),
        "no features": (dumped(), "holds no features"),
        "no rooms": (dumped(DOOR), "holds no room: none of its 1 features"),
        "only broken": (dumped(area("b", bow, indoor="room")), "none of its 1 rooms can be used"),
        "mercator": (dumped(SHOES, **crs("EPSG:3857")), "are degrees, not of 'EPSG:3857"),
        "says degrees": (dumped(wide, **crs("EPSG:4326")), "no longitude and latitude"),
        "no metres": (dumped(wide), '"origin"'),
        "pole": (dumped(polar), "too near a pole"),
        "many levels": (dumped(*[room_] * 40), "more than 5000 rooms"),
        "many doors": (dumped(SHOES, *[DOOR] * 5001), "holds 5001 doors"),
    }


@pytest.mark.parametrize("name", hostile())
def test_hostile_files_give_one_line(name: str, tmp_path: Path) -> None:
    data, told = hostile()[name]
    path = tmp_path / "map.geojson"
    path.write_bytes(data)
    with pytest.raises(InputError) as caught:
        formats.read(path)
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)
    assert str(caught.value).startswith(str(path))


def test_too_large_files_are_not_opened(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "map.geojson"
    path.write_bytes(json.dumps(document(SHOES)).encode())
    monkeypatch.setattr("scenewright.ground.maps.features.GREATEST_FILE", 100)
    with pytest.raises(InputError, match="is larger than"):
        formats.read(path)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda f: f["geometry"].update(coordinates=[[[1e308, 0]] * 4]), "out of range"),
        (lambda f: f["geometry"].update(coordinates={"x": 1}), "no list"),
        (lambda f: f["geometry"].update(coordinates=[[[True, 1]] * 4]), "not a pair"),
        (lambda f: f["geometry"].update(type="Curve"), 'of type "Curve"'),
        (lambda f: f["properties"].update(level="0-999"), "more than 200 levels"),
        (lambda f: f["geometry"]["coordinates"].extend([box(1, 1, 2, 2)] * 201), "200 holes"),
    ],
)
def test_one_hostile_feature_does_not_spoil_the_rest(
    change: Callable[[Json], None], told: str
) -> None:
    bad = json.loads(json.dumps(BOOKS))
    change(bad)
    found = read(SHOES, bad)
    assert len(found.brief.rooms) == 1
    assert told in found.skipped[0].reason


@given(
    st.lists(
        st.tuples(
            st.integers(0, 30),
            st.integers(0, 30),
            st.integers(1, 15),
            st.integers(1, 15),
            st.sampled_from(["room", "corridor", "area", "column"]),
            st.booleans(),
        ),
        min_size=1,
        max_size=12,
    ),
    st.lists(st.tuples(st.integers(0, 40), st.integers(0, 40)), max_size=12),
)
def test_whatever_overlaps_the_plan_accepts(boxes: list[Any], doors: list[Any]) -> None:
    features = [
        area(
            f"b{i}",
            box(x, y, x + w, y + d),
            indoor=kind,
            level="0",
            **({"shop": "toys"} if s else {}),
        )
        for i, (x, y, w, d, kind, s) in enumerate(boxes)
    ]
    features += [node(f"d{i}", x, y, door="yes", level="0") for i, (x, y) in enumerate(doors)]
    solids = [shapely.box(x, y, x + w, y + d) for x, y, w, d, *_ in boxes]
    features.append(area("last", box(60, 60, 70, 70), indoor="room", level="0"))
    found = read(*features)
    whole = shapely.union_all(solids).area + 100
    assert sum(floor(r).area for r in found.brief.rooms) <= whole * 1.001 + 0.01
