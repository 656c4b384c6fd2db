"""Zones, links, borders and walls of halls, and every way a hall's brief can be wrong."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

import scenewright
from scenewright.building.outlines import ring
from scenewright.building.plan import plan_rooms, spaces
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.space import Space
from scenewright.domains.hall.demands.checked import floor_needed, ids_of, sizes_of
from scenewright.domains.hall.hall_layout import Zone
from scenewright.domains.hall.zoning.borders import border_lengths
from scenewright.domains.hall.zoning.zones import HallPlan, borders_of, wall_stretches, zones_of
from scenewright.domains.home.wished.requests import check_plain


def box(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def hall(**room: Any) -> dict[str, Any]:
    """A hall of 12 by 8 metres with an entrance in the south."""
    doors = [{"id": "main", "at": [6, 0], "width": 1.6, "use": "entrance"}]
    return {"name": "Hall", "outline": box(0, 0, 12, 8), "doors": doors} | room


def brief(room: dict[str, Any], **more: Any) -> Brief:
    return Brief.model_validate({"domain": "hall", "rooms": [room]} | more)


def planned(room: dict[str, Any], **more: Any) -> tuple[HallPlan, Space]:
    document = brief(room, **more)
    space = spaces(document)[0]
    return zones_of(document, 0, space), space


def zone(name: str, outline: Any, **more: Any) -> dict[str, Any]:
    return {"id": name, "outline": outline} | more


def area(found: Zone) -> float:
    return float(shapely.Polygon(found.outline, found.holes).area)


THREE = [
    zone("west", box(0, 0, 6, 8)),
    zone("south", box(6, 0, 12, 3)),
    zone("north", box(6, 3, 12, 8)),
]


def test_zones_are_cut_to_the_floor() -> None:
    column = box(3, 3, 3.5, 3.5)
    zones = [zone("a", box(-0.02, 0, 6, 8)), zone("b", box(5.999, 0, 12, 8.01))]
    plan, space = planned(hall(zones=zones, holes=[column]))
    floor = shapely.Polygon(space.outline, space.holes)
    shapes = [shapely.Polygon(z.outline, z.holes) for z in plan.zones]
    assert len(plan.zones[0].holes) == 1
    assert sum(shape.area for shape in shapes) == pytest.approx(96 - 0.25, abs=1e-6)
    assert shapes[0].intersection(shapes[1]).area < 1e-9
    assert all(shape.difference(floor).area < 1e-9 for shape in shapes)


def test_a_column_between_zones_is_cut_off_both() -> None:
    zones = [zone("a", box(0, 0, 6, 8)), zone("b", box(6, 0, 12, 8))]
    plan, space = planned(hall(zones=zones, holes=[box(5.8, 3, 6.2, 3.4)]))
    assert [area(z) for z in plan.zones] == pytest.approx([48 - 0.08] * 2)
    lengths = [np.hypot(*np.subtract(b.end, b.start)) for b in borders_of(plan, space)]
    assert sorted(lengths) == pytest.approx([3.0, 4.6])


def test_outlines_on_the_middle_lines_of_walls_may_name_zones_there() -> None:
    zones = [zone("a", box(0, 0, 6, 8)), zone("b", box(6, 0, 12, 8))]
    plan, _ = planned(hall(zones=zones), outlines="centre", wall_thickness=0.3)
    assert [area(z) for z in plan.zones] == pytest.approx([5.85 * 7.7] * 2)


def test_links_that_are_not_given_span_the_hall() -> None:
    plan, _ = planned(hall(zones=THREE))
    assert [(k.first, k.second) for k in plan.links] == [("west", "north"), ("south", "north")]
    assert {k.width for k in plan.links} == {1.2}


def test_zones_are_not_linked_through_a_gap_too_narrow_to_pass() -> None:
    plan, _ = planned(hall(zones=THREE), passage_width=3.5)
    assert [(k.first, k.second) for k in plan.links] == [("west", "north"), ("south", "north")]
    plan, _ = planned(hall(zones=THREE), passage_width=5.5)
    assert [(k.first, k.second) for k in plan.links] == [("south", "north")]


def test_links_that_are_given_stay() -> None:
    links = [{"between": ["north", "west"]}, {"between": ["west", "north"], "width": 2.0}]
    plan, _ = planned(hall(zones=THREE, links=links))
    assert [tuple(link) for link in plan.links] == [("hall", "west", "north", 2.0)]


def test_borders_have_the_first_zone_on_their_left() -> None:
    plan, space = planned(hall(zones=THREE))
    borders = borders_of(plan, space)
    assert {(b.first, b.second) for b in borders} == {(0, 1), (0, 2), (1, 2)}
    for border in borders:
        start, end = np.array(border.start), np.array(border.end)
        left = np.array([-(end - start)[1], (end - start)[0]])
        beside = (start + end) / 2 + 0.1 * left / np.linalg.norm(left)
        assert shapely.Polygon(plan.zones[border.first].outline).covers(shapely.Point(beside))
    assert border_lengths(borders) == pytest.approx({(0, 1): 3.0, (0, 2): 5.0, (1, 2): 6.0})


@given(
    st.lists(st.floats(0.5, 7.5), max_size=6),
    st.lists(st.floats(0.5, 7.5), max_size=6),
    st.lists(st.floats(-0.009, 0.009), min_size=14, max_size=14),
)
def test_borders_are_found_when_corners_differ(
    first: list[float], second: list[float], off: list[float]
) -> None:
    """Two sides drawn with different corners, each up to 9 mm off the line between."""
    left = [
        [0, 0],
        [6 + off[0], 0],
        *[[6 + off[k + 1], y] for k, y in enumerate(sorted(first))],
        [6 + off[7], 8],
        [0, 8],
    ]
    right = [
        [12, 8],
        *[[6 + off[k + 8], y] for k, y in enumerate(sorted(second, reverse=True))],
        [6, 0],
        [12, 0],
    ]
    right.insert(1, [6, 8])
    zones = [Zone("a", "", "h", ring(left)), Zone("b", "", "h", ring(right))]
    space = Space("h", "h", (), "0", np.array(box(0, 0, 12, 8), float))
    borders = borders_of(HallPlan(tuple(zones), ()), space)
    assert sum(np.hypot(*np.subtract(b.end, b.start)) for b in borders) == pytest.approx(8, abs=0.1)
    assert border_lengths(borders)[0, 1] > 7.5


def test_a_curved_border_is_a_passage() -> None:
    angle = np.linspace(0, np.pi, 40)
    arc = np.column_stack([6 + 3 * np.cos(angle), 3 * np.sin(angle)]).tolist()
    around = [[0, 0], *arc[::-1], [12, 0], [12, 8], [0, 8]]
    links = [{"between": ["apse", "nave"]}]
    plan, space = planned(hall(zones=[zone("apse", arc), zone("nave", around)], links=links))
    borders = borders_of(plan, space)
    assert border_lengths(borders)[0, 1] == pytest.approx(3 * np.pi, rel=0.02)
    assert max(np.hypot(*np.subtract(b.end, b.start)) for b in borders) > 1.2


def test_walls_have_no_doors_and_know_their_windows() -> None:
    windows = [{"at": [3, 8], "width": 2.0, "sill": 1.1}]
    plan, space = planned(hall(zones=THREE, windows=windows))
    west = {stretch[:4]: stretch.windows for stretch in wall_stretches(plan.zones[0], space)}
    assert set(west) == {(0, 0, 5.1, 0), (6, 8, 0, 8), (0, 8, 0, 0)}
    assert west[6, 8, 0, 8] == ((2.0, 4.0, 1.1),)
    south = [stretch[:4] for stretch in wall_stretches(plan.zones[1], space)]
    assert south == [(6.9, 0, 12, 0), (12, 0, 12, 3)]


def test_columns_have_walls_if_they_are_large() -> None:
    holes = [box(2, 2, 3, 3), box(8, 2, 8.2, 2.2)]
    plan, space = planned(hall(holes=holes))
    stretches = wall_stretches(plan.zones[0], space)
    inner = [s for s in stretches if 0.5 < s.x0 < 11.5 and 0.5 < s.y0 < 7.5]
    assert len(inner) == 4
    for s in inner:
        beside = (s.x0 + s.x1) / 2 - (s.y1 - s.y0) * 0.1, (s.y0 + s.y1) / 2 + (s.x1 - s.x0) * 0.1
        assert shapely.Polygon(space.outline, space.holes).contains(shapely.Point(beside))


@pytest.mark.parametrize("bulge", [1, -1])
def test_curved_walls_are_straightened_inside_the_hall(bulge: int) -> None:
    angle = np.linspace(-1.2, 1.2, 120)
    x = 12 + bulge * 8 * (np.cos(angle) - np.cos(1.2))
    bow = np.column_stack([x, 8 + 8 * np.sin(angle)]).tolist()
    plan, space = planned({"outline": [[0, 0], [12, 0], *bow, [12, 16], [0, 16]]})
    floor = shapely.Polygon(space.outline)
    curved = [s for s in wall_stretches(plan.zones[0], space) if min(s.x0, s.x1) > 6.5]
    assert 5 < len(curved) < 40
    for s in curved:
        line = shapely.LineString([(s.x0, s.y0), (s.x1, s.y1)])
        assert line.difference(floor.buffer(1e-6)).length < 0.1
        assert line.hausdorff_distance(floor.exterior.intersection(line.buffer(0.05))) < 0.1


def test_zones_named_by_demands_are_made() -> None:
    demands = [
        {"category": "bookcase", "length": 40, "zone": "stacks"},
        {"category": "desk", "count": 6, "zone": ["reading", "stacks"]},
    ]
    plan, _ = planned(hall(demands=demands, links=[{"between": ["stacks", "reading"]}]))
    assert [z.id for z in plan.zones] == ["stacks", "reading"]
    assert sum(map(area, plan.zones)) == pytest.approx(96, rel=1e-6)
    assert area(plan.zones[0]) > area(plan.zones[1])
    assert len(plan.links) == 1


def test_a_hall_without_zones_is_one() -> None:
    plan, space = planned(hall())
    assert [(z.id, z.name) for z in plan.zones] == [("hall", "Hall")]
    assert plan.links == ()
    assert np.array_equal(plan.zones[0].outline, space.outline)


def test_zones_without_outline_share_the_rest() -> None:
    zones = [zone("stage", box(0, 0, 3, 8)), {"id": "a", "area": 24.0}, {"id": "b"}]
    plan, _ = planned(hall(zones=zones))
    assert [area(z) for z in plan.zones] == pytest.approx([24, 24, 48], rel=1e-3)


def test_variants_differ_and_are_counted_round() -> None:
    document = brief(hall(zones=[{"id": "a"}, {"id": "b"}, {"id": "c"}]))
    space = spaces(document)[0]
    one, two, again = (zones_of(document, 0, space, variant=k) for k in (0, 1, 0))
    same = sum(
        shapely.Polygon(a.outline).intersection(shapely.Polygon(b.outline)).area
        for a, b in zip(one.zones, two.zones, strict=True)
    )
    assert same < 0.85 * 96
    assert [z.outline.tolist() for z in one.zones] == [z.outline.tolist() for z in again.zones]


def test_demands_are_counted() -> None:
    room = brief(
        hall(
            demands=[
                {
                    "category": "bookcase",
                    "length": 10,
                    "size": [0.9, 0.3, 2],
                    "clearance": [1, 0, 0, 0],
                },
                {"category": "bench", "sizes": [[1, 0.5, 0.4], [2, 0.5, 0.4]], "count": 2},
                {"category": "bench"},
            ]
        )
    ).rooms[0]
    assert [len(sizes_of(demand)) for demand in room.demands] == [11, 2, 1]
    assert ids_of(room.demands) == ("bookcase", "bench", "bench-2")
    assert floor_needed(room.demands[0]) == pytest.approx(11 * 0.9 * 1.3)


BOW = [[0, 0], [5, 5], [5, 0], [0, 5]]
TWO = [zone("a", box(0, 0, 6, 8)), zone("b", box(6, 0, 12, 8))]
CORNERS = [zone("a", box(0, 0, 6, 4)), zone("b", box(6, 4, 12, 8)), zone("c", box(6, 0, 12, 4))]


def demand(**more: Any) -> dict[str, Any]:
    return hall(demands=[{"category": "bench"} | more])


FAULTS: list[tuple[dict[str, Any], str]] = [
    (
        hall(zones=[zone("a", BOW)]),
        "rooms[0] 'Hall' zones[0] 'a': the outline crosses or touches "
        "itself at (2.50, 2.50); list the corners in order, once around",
    ),
    (
        hall(zones=[zone("a", box(0, 0, 6, 8.5))]),
        "zones[0] 'a': reaches 0.50 m out of the hall at "
        "(0.00, 8.50); keep its corners inside the hall's outline",
    ),
    (
        hall(zones=[TWO[0], zone("b", box(5, 2, 12, 8))]),
        "zones[1] 'b': overlaps zone 'a' by 6.00 m² near (5.50, 5.00); move their common border",
    ),
    (hall(zones=[TWO[0], zone("a", box(6, 0, 12, 8))]), "zones[1] 'a': the id is used twice; "),
    (hall(zones=[zone("a", box(0, 0, 0.9, 1))]), "zones[0] 'a': holds only 0.90 m² of floor; "),
    (
        hall(zones=[zone("a", box(0, 0, 12, 4))], holes=[box(5, -1, 7, 5)], doors=[]),
        "zones[0] 'a': is cut into 2 pieces by walls, columns or other zones, the second of "
        "20.00 m²; make each piece a zone of its own",
    ),
    (hall(zones=TWO, links=[{"between": ["a", "bb"]}]), "links[0]: 'bb' is not a zone; use one of"),
    (hall(zones=TWO, links=[{"between": ["a", "a"]}]), "links[0]: links 'a' with itself; "),
    (
        hall(zones=CORNERS, links=[{"between": ["a", "b"]}]),
        "links[0]: the zones 'a' and 'b' share no border; ",
    ),
    (
        hall(zones=CORNERS, links=[{"between": ["a", "c"], "width": 4.5}]),
        "links[0]: the border of "
        "the zones 'a' and 'c' is only 4.00 m long, the passage is to be 4.5 m wide; ",
    ),
    (hall(zones=[*TWO, {"id": "c"}]), "zones: only 0.0 m² of floor are left for 'c'; make"),
    (hall(zones=[{"id": "a", "beside": ["b"]}]), "zones[0] 'a' beside: 'b' is not a zone; "),
    (hall(zones=[{"id": "a", "beside": ["a"]}]), "zones[0] 'a': is to lie beside itself; "),
    (
        hall(zones=[{"id": "a", "door": "mian"}]),
        "zones[0] 'a' door: 'mian' is not a door of the hall; use one of: main",
    ),
    (hall(zones=[{"id": "a", "door": "x"}], doors=[]), "'x' is not a door of the hall; there"),
    (
        hall(zones=[{"id": "a", "area": 90}, {"id": "b", "area": 9}]),
        "zones: the zones ask for 99.0 m², but only 96.0 m² of floor are free; give smaller areas",
    ),
    (
        hall(zones=[{"id": "a", "area": 95.5}, {"id": "b"}]),
        "zones: only 0.5 m² of floor are left "
        "for 'b'; make the other zones smaller, or leave out some",
    ),
    (hall(zones=[{"id": "a", "area": 0.5}, {"id": "b"}]), "zones[0] 'a': is to have only 0.5 m²; "),
    (
        hall(zones=TWO, demands=[{"category": "bench", "zone": ["a", "B"]}]),
        "demands[0] 'bench' zone: 'B' is not a zone; ",
    ),
    (
        hall(ask=[{"group": "desk"}]),
        "rooms[0] 'Hall': asks for groups of furniture, but is a hall; "
        "say what it is to hold in demands",
    ),
    (
        demand(category="bech"),
        "demands[0] 'bech': 'bech' is not a kind of the catalog; use one of: bench",
    ),
    (demand(category="chandelier of gold"), "is not a kind of the catalog; "),
    (demand(category="pendant_lamp"), "a pendant lamp does not stand on the floor; "),
    (demand(count=3, length=9), "demands[0] 'bench': has both count and length; "),
    (demand(size=[1, 1, 1], sizes=[[1, 1, 1]]), "has both size and sizes; "),
    (demand(length=5, sizes=[[1, 1, 1]]), "has both sizes and length; "),
    (demand(count=5, sizes=[[1, 1, 1]]), "count is 5, but 1 sizes are listed; "),
    (
        demand(length=0.5, size=[1.2, 0.5, 0.4]),
        "one bench is 1.2 m wide, more than the length of 0.5 m; ",
    ),
    (demand(length=100_000, size=[0.01, 0.5, 0.4]), "100000 m are 10000000 objects of 0.01 m; "),
    (
        hall(demands=[{"category": "bench", "count": 15_000}] * 2),
        "demands[1] 'bench': brings the objects of this hall to 30000; ",
    ),
    (hall(demands=[{"id": "x", "category": "bench"}] * 2), "demands[1] 'x': the id is used twice"),
    (demand(clearance=15), "asks for 15 m free, but the hall is only 12.00 m long; "),
    (demand(size=[0, 1, 1]), "rooms[0].demands[0].size[0]: 0 is not possible; it should"),
    (
        hall(doors=[{"at": [6, 4]}]),
        "rooms[0] 'Hall' doors[0]: is off the wall: (6, 4) is 4.00 m "
        "from the nearest wall of the room, at (6.00, 0.00); ",
    ),
]


@pytest.mark.parametrize(("room", "told"), FAULTS, ids=[told[:50] for _, told in FAULTS])
def test_what_is_wrong_is_told_in_one_line(room: dict[str, Any], told: str, tmp_path: Path) -> None:
    file = tmp_path / "hall.json"
    file.write_text(json.dumps({"domain": "hall", "rooms": [room]}))
    with pytest.raises(InputError) as caught:
        scenewright.read(file)
    assert told in str(caught.value)
    assert str(caught.value).startswith(f"{file}: rooms[0]")
    assert "\n" not in str(caught.value)
    assert caught.value.remedy


@pytest.mark.parametrize("key", ["zones", "links", "demands"])
def test_homes_have_no_zones(key: str) -> None:
    extra = {"zones": TWO, "links": [{"between": ["a", "b"]}], "demands": [{"category": "bench"}]}
    document = brief(hall(**{key: extra[key]}), domain="home")
    with pytest.raises(InputError, match=rf"rooms\[0\] 'Hall': has {key}, which only halls have; "):
        check_plain(document, plan_rooms(document))
