"""Indoor maps: shapes of rooms, what is cut out of them, and what is no floor."""

from __future__ import annotations

import math

import pytest

from indoor_maps import SHOES, STREET, Json, area, box, degrees, floor, node, read, room
from scenewright.building.plan import spaces
from scenewright.domains.hall.indoor.geojson import report
from scenewright.ground.maps.features import collection


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
        SHOES,
        line,
        nothing,
        text,
        7,
        ["x"],
        area("bow", bow, indoor="room", shop="toys", level="0"),
        area("level", box(50, 0, 60, 8), indoor="room", level="first"),
        area("far", [[120.0, 10.0], [120.1, 10.0], [120.1, 10.1], [120.0, 10.0]], indoor="room"),
        area("tiny", box(70, 0, 70.1, 0.1), indoor="room", level="0"),
        area("thin", box(70, 0, 90, 0.08), indoor="room", level="0"),
        area("two", [degrees(0, 0), degrees(1, 1)], indoor="room"),
        area("nan", [degrees(0, 0), [math.nan, 0], degrees(1, 1), degrees(0, 0)], indoor="room"),
    )
    assert [r.id for r in found.brief.rooms] == ["way-1"]
    told = {row.feature: row.reason for row in found.skipped}
    assert told.keys() == {
        "line",
        "none",
        "text",
        "feature-5",
        "feature-6",
        "bow",
        "level",
        "far",
        "tiny",
        "thin",
        "two",
        "nan",
    }
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
