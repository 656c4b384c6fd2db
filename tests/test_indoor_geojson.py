"""Indoor maps: a small shopping street of our own, hostile files, and the real buildings."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from scenewright import formats
from scenewright.assets import shipped
from scenewright.brief import Brief, Room
from scenewright.domains.hall.programme import (
    PROGRAMMES,
    SMALLEST_SHOP,
    UTILISATION,
    shop_kind,
    shop_programme,
)
from scenewright.errors import InputError
from scenewright.formats.indoor_features import collection
from scenewright.formats.indoor_geojson import IndoorReport, read_report, report
from scenewright.formats.indoor_projection import metres, projection
from scenewright.plan import spaces
from scenewright.scene import Size

LON, LAT = 5.72, 45.18
Json = dict[str, Any]


PHI = math.radians(LAT)
PER_DEGREE = (
    111_412.84 * math.cos(PHI) - 93.5 * math.cos(3 * PHI) + 0.118 * math.cos(5 * PHI),
    111_132.92 - 559.82 * math.cos(2 * PHI) + 1.175 * math.cos(4 * PHI),
)
"""Metres of a degree of longitude and latitude in Grenoble, by the usual series."""


def degrees(x: float, y: float) -> list[float]:
    """Metres about a place in Grenoble as longitude and latitude."""
    return [LON + x / PER_DEGREE[0], LAT + y / PER_DEGREE[1]]


def box(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [degrees(*p) for p in ((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0))]


def area(name: str, ring: Any, /, **tags: str) -> Json:
    rings = ring if isinstance(ring[0][0], list) else [ring]
    geometry = {"type": "Polygon", "coordinates": rings}
    return {"type": "Feature", "id": name, "properties": tags, "geometry": geometry}


def node(name: str, x: float, y: float, /, **tags: str) -> Json:
    geometry = {"type": "Point", "coordinates": degrees(x, y)}
    return {"type": "Feature", "id": name, "properties": tags, "geometry": geometry}


def document(*features: Any, **more: Any) -> Json:
    return {"type": "FeatureCollection", "features": list(features), **more}


def read(*features: Any, **more: Any) -> IndoorReport:
    found = report(collection(document(*features, **more)), "mall")
    assert len(spaces(found.brief)) == len(found.brief.rooms)
    return found


def room(brief: Brief, name: str) -> Room:
    return next(r for r in brief.rooms if r.id == name)


def floor(r: Room) -> shapely.Polygon:
    return shapely.Polygon(r.outline, r.holes)


SHOES = area("way/1", box(0, 0, 10, 8), indoor="room", shop="shoes", name="Pied", level="0")
BOOKS = area("way/2", box(10, 0, 20, 8), indoor="room", shop="books", level="0")
OFFICE = area("way/3", box(20, 0, 24, 8), indoor="room", room="office", ref="12", level="0")
STREET = area("way/4", box(0, 8, 24, 12), indoor="corridor", level="0")
DOOR = node("node/9", 4, 8.02, door="hinged", width="1.0", level="0")


def test_shops_become_halls_and_the_rest_what_their_doors_lead_to() -> None:
    found = read(SHOES, BOOKS, OFFICE, STREET, DOOR)
    brief = found.brief
    assert (brief.domain, brief.outlines, brief.name) == ("hall", "centre", "mall")
    assert [r.id for r in brief.rooms] == ["way-3", "way-1", "way-2", "way-4"]
    assert [r.name for r in brief.rooms] == ["Office 12", "Pied", "Books", "Corridor"]
    assert [bool(r.demands) for r in brief.rooms] == [False, True, True, False]
    assert (found.units, found.filled, found.doors, found.assumed) == (2, 2, 1, 1)
    assert {d.category for d in room(brief, "way-2").demands} >= {"book_stack", "checkout"}
    assert {d.category for d in room(brief, "way-1").demands} >= {"clothes_rail", "fitting_room"}
    assert floor(room(brief, "way-1")).area == pytest.approx(80, rel=1e-4)
    assert not found.skipped
    assert not found.changed


def test_a_door_is_put_in_the_unit_and_joins_it_to_the_way() -> None:
    brief = read(SHOES, BOOKS, OFFICE, STREET, DOOR).brief
    (door,) = room(brief, "way-1").doors
    assert (door.width, door.swing, door.id) == (1.0, "in", "node-9")
    shop = next(s for s in spaces(brief) if s.id == "way-1")
    assert [o.spaces for o in shop.openings] == [("way-1", "way-4")]
    assert not room(brief, "way-4").doors


def test_a_unit_without_a_door_gets_an_open_front_on_the_way() -> None:
    brief = read(SHOES, BOOKS, OFFICE, STREET, DOOR).brief
    (door,) = room(brief, "way-2").doors
    assert door.swing == "none"
    assert door.id.startswith("assumed-way-2")
    assert door.width == pytest.approx(3.0)
    shop = next(s for s in spaces(brief) if s.id == "way-2")
    assert shop.openings[0].spaces == ("way-2", "way-4")
    assert not room(brief, "way-3").doors  # an office is no unit


def test_a_narrow_front_is_open_by_six_tenths() -> None:
    brief = read(area("a", box(0, 0, 4, 8), indoor="room", shop="toys", level="0"), STREET).brief
    (door,) = room(brief, "a").doors
    assert door.width == pytest.approx(0.6 * 3.9, abs=0.05)


@pytest.mark.parametrize(
    ("tags", "width", "swing", "use"),
    [
        ({"door": "hinged", "width": "0.95"}, 0.95, "in", "both"),
        ({"door": "hinged"}, 1.8, "slide", "both"),  # shops: two leaves
        ({"door": "no", "door:width": "2,5"}, 2.5, "none", "both"),
        ({"door": "sliding", "width": "160"}, 1.6, "slide", "both"),
        ({"door": "hinged", "width": "wide", "automatic_door": "yes"}, 1.8, "slide", "both"),
        ({"entrance": "exit"}, 1.8, "none", "exit"),
        ({"entrance": "emergency", "door": "yes", "width": "1"}, 1.0, "in", "exit"),
    ],
)
def test_tags_of_doors(tags: Json, width: float, swing: str, use: str) -> None:
    (door,) = room(read(SHOES, STREET, node("d", 5, 8, level="0", **tags)).brief, "way-1").doors
    assert door.width == pytest.approx(width)
    assert [door.swing, door.use] == [swing, use]


def test_a_door_of_a_plain_room_is_narrow() -> None:
    (door,) = room(read(OFFICE, node("d", 22, 8, door="hinged", level="0")).brief, "way-3").doors
    assert (door.width, door.swing) == (0.9, "in")


def test_doors_that_fit_nowhere_are_told() -> None:
    found = read(
        SHOES, STREET, DOOR,
        node("far", 5, 30, door="yes", level="0"),
        node("twin", 4.2, 8, door="yes", level="0"),
        node("above", 6, 8, door="yes", level="1"),
        node("odd", 6, 8, door="yes", level="EG"),
    )  # fmt: skip
    assert [(s.feature, s.reason.split()[2]) for s in found.skipped] == [
        ("odd", "on"), ("far", "more"), ("twin", "on"),
    ]  # fmt: skip
    assert found.doors == 1


def test_a_door_in_a_corner_is_moved_onto_the_wall() -> None:
    brief = read(SHOES, STREET, node("d", 0.1, 8, door="hinged", width="0.9", level="0")).brief
    (door,) = room(brief, "way-1").doors
    x0 = min(x for x, _ in room(brief, "way-1").outline)
    assert door.width == 0.9
    assert door.at[0] - x0 == pytest.approx(0.05 + 0.45 + 0.02, abs=0.01)


def test_every_level_has_its_copy_and_its_doors() -> None:
    shop = area("s", box(0, 0, 10, 8), indoor="room", shop="toys", level="0;1")
    lift = area("l", box(10, 0, 12, 2), indoor="room", highway="elevator", level="-1-1")
    office = area("o", box(12, 0, 16, 8), indoor="room", level="0", repeat_on="2")
    found = read(shop, lift, office, node("d", 3, 8, door="yes", level="0", repeat_on="1"))
    assert [(r.id, r.level) for r in found.brief.rooms] == [
        ("l-level--1", "-1"), ("l-level-0", "0"), ("o-level-0", "0"), ("s-level-0", "0"),
        ("l-level-1", "1"), ("s-level-1", "1"), ("o-level-2", "2"),
    ]  # fmt: skip
    assert [lv.elevation for lv in found.brief.levels] == [-4.0, 0.0, 4.0, 8.0]
    assert [d.id for r in found.brief.rooms for d in r.doors] == ["d-level-0", "d-level-1"]
    assert room(found.brief, "l-level-0").name == "Lift"
    assert found.units == 2


def test_an_upper_floor_that_nothing_leads_to_is_told() -> None:
    found = read(area("s", box(0, 0, 10, 8), indoor="room", shop="toys", level="0;1"))
    assert found.assumed == 1
    assert found.doorless == ("s-level-1",)


def test_holes_columns_and_kiosks_are_cut_out() -> None:
    hall = area(
        "h", [box(0, 0, 40, 30), box(5, 5, 10, 10)], indoor="area", level="0", name="Hall C"
    )
    kiosk = area("k", box(20, 10, 26, 16), indoor="room", shop="kiosk", level="0")
    column = area("c", box(30, 20, 31, 21), indoor="column", level="0")
    found = read(hall, kiosk, column)
    main = room(found.brief, "h")
    assert len(main.holes) == 3
    assert main.name == "Hall C"
    assert floor(main).area == pytest.approx(1200 - 25 - 36 - 1, rel=1e-4)
    assert [c.reason for c in found.changed] == ["was cut where it overlaps k"]
    assert next(s for s in spaces(found.brief) if s.id == "k").openings[0].spaces == ("k", "h")


def test_of_two_units_the_smaller_keeps_its_shape() -> None:
    large = area("a", box(0, 0, 20, 10), indoor="room", shop="toys", level="0")
    small = area("b", box(15, 0, 25, 10), indoor="room", shop="toys", level="0")
    for features in ((large, small), (small, large)):
        brief = read(*features).brief
        assert floor(room(brief, "b")).area == pytest.approx(100, rel=1e-4)
        assert floor(room(brief, "a")).area == pytest.approx(150, rel=1e-4)


def test_a_unit_drawn_twice_is_read_once() -> None:
    found = read(SHOES, SHOES, STREET)
    assert [r.id for r in found.brief.rooms] == ["way-1", "way-4"]
    assert found.skipped == (("way-1-2", "others cover all of it"),)


def test_parts_of_a_multipolygon_are_rooms() -> None:
    parts = [[box(0, 0, 10, 8)], [box(20, 0, 30, 8)]]
    shop = area("m", box(0, 0, 1, 1), indoor="room", shop="toys", level="0")
    shop["geometry"] = {"type": "MultiPolygon", "coordinates": parts}
    found = read(shop, area("z", [[box(0, 8, 30, 12)]][0], indoor="corridor", level="0"))
    assert [r.id for r in found.brief.rooms] == ["m", "m-part", "z"]
    assert found.assumed == 2


def test_ways_that_touch_are_open_to_each_other_unless_a_door_joins_them() -> None:
    other = area("x", box(24, 8, 34, 12), indoor="area", level="0")
    found = read(STREET, other)
    assert found.open_borders == 1
    (passage,) = room(found.brief, "x").doors
    assert passage.swing == "none"
    assert passage.width == pytest.approx(3.9 - 0.3, abs=0.02)
    long = [
        area(n, box(0, y, 40, y + 4), indoor="area", level="0") for n, y in (("a", 0), ("b", 4))
    ]
    assert read(*long).open_borders == 1
    closed = read(*long, node("d", 1, 4, door="hinged", level="0"))
    assert (closed.doors, closed.open_borders) == (1, 0)


def test_a_point_tells_what_a_bare_room_sells() -> None:
    bare = area("r", box(0, 0, 10, 8), indoor="room", level="0")
    point = node("p", 5, 5, shop="books", name="Lire", level="0")
    found = read(bare, point)
    assert (found.units, found.brief.rooms[0].name) == (1, "Lire")
    assert read(bare, point, node("q", 6, 5, shop="toys", level="0")).units == 0
    assert read(bare, node("p", 5, 5, shop="books", level="1")).units == 0


def test_what_is_no_floor_is_left_alone() -> None:
    found = read(
        SHOES,
        area("b", box(-50, -50, 50, 50), building="retail"),
        area("m", box(-50, -50, 50, 50), shop="mall"),
        area("p", box(-50, -50, 50, 50), amenity="parking", level="-1"),
    )
    assert [r.id for r in found.brief.rooms] == ["way-1"]
    assert not found.skipped


def test_broken_features_are_left_out_and_told() -> None:
    line = area("line", box(0, 0, 1, 1), indoor="room", level="0")
    line["geometry"] = {"type": "LineString", "coordinates": [degrees(0, 0), degrees(5, 5)]}
    bow = [degrees(*p) for p in ((30, 0), (40, 8), (40, 0), (30, 8), (30, 0))]
    nothing: Json = {"type": "Feature", "id": "none", "properties": None, "geometry": None}
    text = area("text", [[["a", "b"]] * 4], indoor="room")
    found = read(
        SHOES, line, nothing, text, 7, ["x"],
        area("bow", bow, indoor="room", shop="toys", level="0"),
        area("level", box(50, 0, 60, 8), indoor="room", level="first"),
        area("far", [[120.0, 10.0], [120.1, 10.0], [120.1, 10.1], [120.0, 10.0]], indoor="room"),
        area("tiny", box(70, 0, 70.1, 0.1), indoor="room", level="0"),
        area("thin", box(70, 0, 90, 0.08), indoor="room", level="0"),
        area("two", [degrees(0, 0), degrees(1, 1)], indoor="room"),
        area("nan", [degrees(0, 0), [math.nan, 0], degrees(1, 1), degrees(0, 0)], indoor="room"),
    )  # fmt: skip
    assert [r.id for r in found.brief.rooms] == ["way-1"]
    told = {row.feature: row.reason for row in found.skipped}
    assert told.keys() == {"line", "none", "text", "feature-5", "feature-6", "bow", "level", "far",
                           "tiny", "thin", "two", "nan"}  # fmt: skip
    assert "crosses" in told["bow"]
    assert "'first' is not a number" in told["level"]
    assert "km from the rest" in told["far"]
    assert "not closed" in told["line"]


def test_a_sliver_at_a_crossing_is_mended() -> None:
    points = ((0, 0), (10, 0), (10, 8), (5.01, 8), (5, 8.02), (5.02, 8.02), (5, 8), (0, 8), (0, 0))
    found = read(area("s", [degrees(*p) for p in points], indoor="room", shop="toys", level="0"))
    assert "slivers" in found.changed[0].reason
    assert floor(found.brief.rooms[0]).area == pytest.approx(80, rel=1e-3)


def test_single_features_nested_tags_and_hostile_names() -> None:
    shop = area("node/../../x y", box(0, 0, 10, 8))
    shop["properties"] = {"tags": {"indoor": "room", "shop": "toys", "name": "A\nB\x00" * 500}}
    brief = report(collection(shop), "").brief
    assert brief.rooms[0].id == "node-..-..-x-y"
    assert len(brief.rooms[0].name) <= 120
    assert "\n" not in brief.rooms[0].name
    assert brief.name == "hall"


# Projection


def tangent_plane(rings: np.ndarray[Any, Any], about: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """East and north on the plane that touches WGS 84 at ``about``, by way of space."""

    def in_space(lon_lat: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        lam, phi = np.deg2rad(lon_lat).T
        b_over_a = 6_356_752.314245 / 6_378_137.0
        n = 6_378_137.0**2 / np.hypot(6_378_137.0 * np.cos(phi), 6_356_752.314245 * np.sin(phi))
        return np.column_stack([n * np.cos(phi) * np.cos(lam), n * np.cos(phi) * np.sin(lam),
                                b_over_a**2 * n * np.sin(phi)])  # fmt: skip

    lam, phi = np.deg2rad(about)
    east = np.array([-np.sin(lam), np.cos(lam), 0.0])
    north = np.array([-np.sin(phi) * np.cos(lam), -np.sin(phi) * np.sin(lam), np.cos(phi)])
    away = in_space(np.atleast_2d(rings)) - in_space(about[None])
    return np.column_stack([away @ east, away @ north])


@given(st.floats(-179, 179), st.floats(-80, 80), st.floats(-300, 300), st.floats(-300, 300))
def test_lengths_agree_with_the_tangent_plane(lon: float, lat: float, x: float, y: float) -> None:
    """To a thousandth within 300 m, at every latitude up to 80 degrees."""
    about = np.array([lon, lat])
    there = about + np.array([x / (111_320 * math.cos(math.radians(lat))), y / 111_132])
    ours = metres(projection(about[None]), there[None])[0]
    exact = tangent_plane(there[None], about)[0]
    assert np.hypot(*(ours - exact)) <= 1e-3 * max(np.hypot(*exact), 1.0)


def test_nothing_is_torn_where_longitudes_begin_anew() -> None:
    corners = np.array([[179.9999, 0.0], [-179.9999, 0.0], [-179.9999, 0.0001]])
    flat = metres(projection(corners), corners)
    assert np.hypot(*(flat[1] - flat[0])) == pytest.approx(22.26, abs=0.01)


def plain_metres(*features: Json, at: tuple[float, float] = (0.0, 0.0)) -> Json:
    """The same features in metres."""

    def turned(value: Any) -> Any:
        if isinstance(value[0], list):
            return [turned(part) for part in value]
        return [(value[0] - LON) * PER_DEGREE[0] + at[0], (value[1] - LAT) * PER_DEGREE[1] + at[1]]

    found = json.loads(json.dumps(features))
    for feature in found:
        feature["geometry"]["coordinates"] = turned(feature["geometry"]["coordinates"])
    return document(*found)


@pytest.mark.parametrize("at", [(0.0, 0.0), (450_000.0, 5_400_000.0)])
def test_maps_in_metres_are_read_as_they_are(at: tuple[float, float]) -> None:
    brief = report(collection(plain_metres(SHOES, BOOKS, STREET, at=at)), "m").brief
    assert floor(room(brief, "way-1")).area == pytest.approx(80, abs=0.02)
    assert len(spaces(brief)) == 3


def crs(name: str) -> Json:
    return {"crs": {"type": "name", "properties": {"name": name}}}


def test_a_named_reference_system_counts() -> None:
    assert read(SHOES, **crs("urn:ogc:def:crs:OGC:1.3:CRS84")).units == 1
    assert read(SHOES, **crs("EPSG:4326")).units == 1
    utm = plain_metres(SHOES) | crs("urn:ogc:def:crs:EPSG::32631")
    assert floor(report(collection(utm), "m").brief.rooms[0]).area == pytest.approx(80, abs=0.02)


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
        "features no list": (b'{"type": "FeatureCollection", "features": 3}', "its type is"),
        "no features": (dumped(), "holds no features"),
        "no rooms": (dumped(DOOR), "holds no room: none of its 1 features"),
        "only broken": (dumped(area("b", bow, indoor="room")), "none of its 1 rooms can be used"),
        "mercator": (dumped(SHOES, **crs("EPSG:3857")), "'EPSG:3857' is not known"),
        "says degrees": (dumped(wide, **crs("EPSG:4326")), "no longitude and latitude"),
        "no metres": (dumped(wide), "neither longitude and latitude nor metres"),
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
    monkeypatch.setattr("scenewright.formats.indoor_features.GREATEST_FILE", 100)
    with pytest.raises(InputError, match="is larger than"):
        formats.read(path)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda f: f["geometry"].update(coordinates=[[[1e308, 0]] * 4]), "out of range"),
        (lambda f: f["geometry"].update(coordinates={"x": 1}), "no list"),
        (lambda f: f["geometry"].update(coordinates=[[[True, 1]] * 4]), "no pair"),
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
        st.tuples(st.integers(0, 30), st.integers(0, 30), st.integers(1, 15), st.integers(1, 15),
                  st.sampled_from(["room", "corridor", "area", "column"]), st.booleans()),
        min_size=1, max_size=12,
    ),
    st.lists(st.tuples(st.integers(0, 40), st.integers(0, 40)), max_size=12),
)  # fmt: skip
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


# Programmes


def used(kind: str, floor_area: float, perimeter: float) -> float:
    total = 0.0
    for demand in shop_programme(kind, floor_area, perimeter):
        assert demand.size
        assert demand.count
        assert isinstance(demand.clearance, tuple)
        front, left, back, right = demand.clearance
        total += demand.count * (demand.size[0] + left + right) * (demand.size[1] + front + back)
    return total / floor_area


@pytest.mark.parametrize("kind", PROGRAMMES)
@pytest.mark.parametrize("floor_area", [30, 47, 80, 150, 600, 3000])
def test_half_of_the_floor_is_used(kind: str, floor_area: float) -> None:
    share = used(kind, floor_area, 4.4 * math.sqrt(floor_area))
    assert (0.45 if floor_area >= 60 else 0.395) <= share <= UTILISATION + 1e-9
    ids = [d.id for d in shop_programme(kind, floor_area, 4.4 * math.sqrt(floor_area))]
    assert len(ids) == len(set(ids))


def test_everything_is_in_the_catalog_at_its_size() -> None:
    for row in (row for rows in PROGRAMMES.values() for row in rows):
        asset = shipped().choose(row.category, Size(*row.size))
        assert asset is not None, row.category
        sizes = zip(asset.smallest, row.size, asset.largest, strict=True)
        assert all(low <= size <= high for low, size, high in sizes), row.category


def test_no_programme_is_too_large_to_lay_out() -> None:
    for kind in PROGRAMMES:
        assert sum(demand.count or 0 for demand in shop_programme(kind, 90_000, 1_200)) < 10_000


def test_walls_hold_what_stands_at_them() -> None:
    for kind in PROGRAMMES:
        wall = sum((d.count or 0) * d.size[0] for d in shop_programme(kind, 400, 80)
                   if d.place == "wall" and d.size)  # fmt: skip
        assert wall <= 0.45 * 80 + 1e-9


def test_small_and_unknown_units_hold_nothing() -> None:
    assert shop_programme("clothes", SMALLEST_SHOP - 0.01, 22) == []
    assert shop_programme("", 100, 40) == []
    assert shop_programme("castle", 100, 40) == []


@pytest.mark.parametrize(
    ("tags", "kind"),
    [
        ({"shop": "supermarket"}, "grocery"),
        ({"shop": "bakery", "amenity": "cafe"}, "food"),
        ({"room": "shop"}, "generic"),
        ({"room": "shop", "shop": "vacant"}, ""),
        ({"room": "disused", "shop": "toys"}, ""),
        ({"amenity": "toilets"}, ""),
        ({"amenity": "library"}, "library"),
        ({"shop": " Books ; toys"}, "books"),
    ],
)
def test_kinds_by_tags(tags: dict[str, str], kind: str) -> None:
    assert shop_kind(tags) == kind


# Real buildings


FIGURES = {
    # levels, rooms, units, filled, doors, assumed, open borders, skipped
    "caserne": (3, 74, 38, 38, 5, 36, 4, 6),
    "gare-de-l-est": (2, 115, 62, 53, 16, 61, 33, 1),
    "apb": (5, 476, 1, 1, 526, 0, 1, 6),
}


@pytest.mark.realdata
@pytest.mark.parametrize("name", FIGURES)
def test_real_buildings(name: str, real_data: Path) -> None:
    path = real_data / "indoor_osm" / f"{name}.geojson"
    found = read_report(path)
    brief = formats.read(path)
    assert brief == found.brief
    assert (len(brief.levels), len(brief.rooms), found.units, found.filled, found.doors,
            found.assumed, found.open_borders, len(found.skipped)) == FIGURES[name]  # fmt: skip
    listed = [d.id for r in brief.rooms for d in r.doors]
    assert len(listed) == found.doors + found.assumed + found.open_borders
    joined = {s.id for s in spaces(brief) if s.openings}
    units = {r.id for r in brief.rooms if r.demands}
    assert units - joined <= set(found.doorless)


@pytest.mark.realdata
@pytest.mark.parametrize("name", FIGURES)
def test_areas_of_real_rooms(name: str, real_data: Path) -> None:
    """Within a thousandth of those on the plane touching the earth at each room."""
    path = real_data / "indoor_osm" / f"{name}.geojson"
    found = read_report(path)
    changed = {row.feature for row in found.changed if "level" not in row.reason}
    compared = 0
    by_id = {r.id: r for r in found.brief.rooms}
    for feature in json.loads(path.read_text())["features"]:
        own = by_id.get(feature["id"].replace("/", "-").replace("--", "-"))
        geometry = feature["geometry"]
        if own is None or own.id in changed or geometry["type"] != "Polygon":
            continue
        rings = [np.array(ring)[:, :2] for ring in geometry["coordinates"]]
        flat = [tangent_plane(ring, rings[0][0]) for ring in rings]
        exact = shapely.Polygon(flat[0], flat[1:]).area
        assert floor(own).area == pytest.approx(exact, rel=1e-3, abs=0.01)
        compared += 1
    assert compared >= 0.75 * len(found.brief.rooms)
