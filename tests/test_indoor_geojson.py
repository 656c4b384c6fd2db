"""Indoor maps: rooms, doors and levels of a small shopping street, and the real buildings."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import shapely

from indoor_maps import (
    BOOKS,
    DOOR,
    SHOES,
    STREET,
    Json,
    area,
    box,
    floor,
    node,
    read,
    room,
    tangent_plane,
)
from scenewright import formats
from scenewright.building.plan import spaces
from scenewright.domains.hall.indoor.geojson import read_report
from thoroughness import only_thorough

OFFICE = area("way/3", box(20, 0, 24, 8), indoor="room", room="office", ref="12", level="0")


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
        SHOES,
        STREET,
        DOOR,
        node("far", 5, 30, door="yes", level="0"),
        node("twin", 4.2, 8, door="yes", level="0"),
        node("above", 6, 8, door="yes", level="1"),
        node("odd", 6, 8, door="yes", level="somewhere"),
    )
    assert [(s.feature, s.reason.split()[2]) for s in found.skipped] == [
        ("odd", "on"),
        ("far", "more"),
        ("twin", "on"),
    ]
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
        ("l-level--1", "-1"),
        ("l-level-0", "0"),
        ("o-level-0", "0"),
        ("s-level-0", "0"),
        ("l-level-1", "1"),
        ("s-level-1", "1"),
        ("o-level-2", "2"),
    ]
    assert [lv.elevation for lv in found.brief.levels] == [-4.0, 0.0, 4.0, 8.0]
    assert [d.id for r in found.brief.rooms for d in r.doors] == ["d-level-0", "d-level-1"]
    assert room(found.brief, "l-level-0").name == "Lift"
    assert found.units == 2


def test_an_upper_floor_that_nothing_leads_to_is_told() -> None:
    found = read(area("s", box(0, 0, 10, 8), indoor="room", shop="toys", level="0;1"))
    assert found.assumed == 1
    assert found.doorless == ("s-level-1",)


# Real buildings


FIGURES = {
    # levels, rooms, units, filled, doors, assumed, open borders, skipped
    "caserne": (3, 74, 38, 38, 5, 36, 4, 6),
    "gare-de-l-est": (2, 115, 62, 53, 16, 61, 33, 1),
    "apb": (5, 476, 1, 1, 526, 0, 1, 6),
}
SMALL = "caserne"
NAMES = [SMALL, *(pytest.param(n, marks=only_thorough) for n in FIGURES if n != SMALL)]

_report = cache(read_report)
"""What a file of a real building holds, read once."""


@pytest.mark.realdata(quick=True)
@pytest.mark.parametrize("name", NAMES)
def test_real_buildings(name: str, real_data: Path) -> None:
    path = real_data / "indoor_osm" / f"{name}.geojson"
    found = _report(path)
    brief = formats.read(path)
    assert brief == found.brief
    assert (
        len(brief.levels),
        len(brief.rooms),
        found.units,
        found.filled,
        found.doors,
        found.assumed,
        found.open_borders,
        len(found.skipped),
    ) == FIGURES[name]
    listed = [d.id for r in brief.rooms for d in r.doors]
    assert len(listed) == found.doors + found.assumed + found.open_borders
    joined = {s.id for s in spaces(brief) if s.openings}
    units = {r.id for r in brief.rooms if r.demands}
    assert units - joined <= set(found.doorless)


@pytest.mark.realdata(quick=True)
@pytest.mark.parametrize("name", NAMES)
def test_areas_of_real_rooms(name: str, real_data: Path) -> None:
    """Within a thousandth of those on the plane touching the earth at each room."""
    path = real_data / "indoor_osm" / f"{name}.geojson"
    found = _report(path)
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
