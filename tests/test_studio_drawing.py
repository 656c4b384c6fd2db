"""Plans drawn on the page: what an act does to shared walls, faults where they lie, and undo."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from scenewright.core.errors import InputError

pytest.importorskip("starlette")
from scenewright.studio.draft_faults import read_draft
from scenewright.studio.drafting import complete_draft, draw_act, new_draft
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.studio.wishing import FORMS, ask_schema, list_wishes
from scenewright.workflow import project
from studio_asking import ask, box

LEFT = {"act": "room", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "name": "Living room"}
RIGHT = {"act": "room", "outline": [[4, 0], [7, 0], [7, 3], [4, 3]], "name": "Bedroom"}
DOORS = [
    {"act": "opening", "kind": "door", "at": [1, 0.1]},
    {"act": "opening", "kind": "door", "at": [4, 2]},
    {"act": "opening", "kind": "window", "at": [7, 1.5]},
]


def drawn(*acts: Json, domain: str = "home") -> Json:
    draft = new_draft(domain)
    for act in acts:
        draft, _ = draw_act(draft, act)
    return draft


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    db = project.open_project(tmp_path / "new.studio")
    yield Session(db, lambda _event: None)
    db.close()


def test_a_wall_that_is_moved_takes_along_what_is_joined_to_it() -> None:
    moved = drawn(LEFT, RIGHT, *DOORS, {"act": "move", "points": [[4, 0], [4, 3]], "by": [0.5, 0]})
    assert moved["rooms"][0]["outline"][1] == moved["rooms"][1]["outline"][0] == [4.5, 0.0]
    assert moved["openings"][1]["at"] == [4.5, 2.0]
    longer = drawn(LEFT, RIGHT, *DOORS, {"act": "length", "id": "room-2", "edge": 1, "metres": 4.2})
    heights = {y for room in longer["rooms"] for _, y in room["outline"]}
    assert heights == {0.0, 4.2}
    assert longer["openings"][2]["at"] == [7.0, 2.1]


def test_a_drawing_is_a_home_with_shared_walls_and_its_doors() -> None:
    plan = read_draft(drawn(LEFT, RIGHT, *DOORS, {"act": "column", "at": [2, 1.5]})).plan
    assert plan is not None
    living, bedroom = plan.spaces
    assert living.outline[:, 0].max() == pytest.approx(3.94)
    assert bedroom.outline[:, 0].min() == pytest.approx(4.06)
    assert {one.id for one in bedroom.openings} == {"door-2", "window-1"}
    assert len(living.holes) == 1


@pytest.mark.parametrize(
    ("act", "message", "place"),
    [
        (RIGHT | {"outline": [[3, 0], [7, 0], [7, 3], [3, 3]]}, "overlap by 3.00", [3.0, 3.0]),
        (RIGHT | {"outline": [[4, 0], [7, 3], [7, 0], [4, 3]]}, "cross each other", [4.0, 0.0]),
        ({"act": "opening", "kind": "window", "at": [0.2, 0]}, "its wall ends before", [0.2, 0.0]),
        ({"act": "opening", "kind": "passage", "at": [1.4, 0]}, "over one another", [1.4, 0.0]),
        ({"act": "column", "at": [9, 9]}, "stands in no room", [9.0, 9.0]),
    ],
)
def test_faults_are_told_where_they_lie_and_hinder(
    act: Json, message: str, place: list[float]
) -> None:
    read = read_draft(drawn(LEFT, DOORS[0], act))
    found = [one for one in read.faults if message in one.message]
    assert place in found[0].points
    assert not found[0].warns
    assert read.plan is None


HALL = [
    {"act": "room", "outline": box(0, 0, 20, 12), "name": "Shop"},
    {"act": "opening", "kind": "door", "at": [5, 0]},
    {"act": "zone", "outline": box(0, 0, 10, 12), "name": "Tills"},
    {"act": "zone", "outline": box(10, 0, 20, 12), "name": "Goods"},
]


def test_a_hall_is_drawn_with_zones_that_follow_its_walls_and_what_it_is_asked_for() -> None:
    demands = [{"category": "gondola", "count": 6, "zone": "zone-2"}]
    asked = {"act": "ask", "id": "hall-1", "asked": {"theme": "grocery", "demands": demands}}
    wider = {"act": "length", "id": "hall-1", "edge": 0, "metres": 23}
    draft = drawn(*HALL, asked, wider, domain="hall")
    assert draft["zones"][1]["outline"] == box(10, 0, 23, 12)
    brief = read_draft(draft).brief
    assert brief is not None
    assert [zone.id for zone in brief.rooms[0].zones] == ["zone-1", "zone-2"]
    assert brief.rooms[0].demands[0].zone == "zone-2"
    assert list_wishes(brief)["hall-1"] == asked["asked"]


@pytest.mark.parametrize(
    ("act", "message"),
    [
        ({"act": "zone", "outline": box(15, 1, 25, 11)}, "reaches out of the hall"),
        ({"act": "zone", "outline": box(8, 1, 9, 11)}, "Tills and Zone 3 overlap by 10.00"),
        ({"act": "ask", "id": "hall-1", "asked": {"theme": "gems"}}, "Shop: 'gems' is not a theme"),
        (
            {"act": "ask", "id": "hall-1", "asked": {"demands": [{"category": "sofax"}]}},
            "Shop: 'sofax' is not a kind",
        ),
    ],
)
def test_faults_of_a_hall_are_told_where_they_lie(act: Json, message: str) -> None:
    read = read_draft(drawn(*HALL, act, domain="hall"))
    assert read.plan is None
    found = next(one for one in read.faults if message in one.message)
    assert found.points
    assert {*found.ids} & {"hall-1", "zone-3"}


def test_a_site_is_drawn_with_the_streets_about_it() -> None:
    street = {"act": "street", "line": [[-5, 40], [105, 40]]}
    away = {"act": "street", "line": [[0, 300], [90, 300]], "kind": "path"}
    asked = {"act": "ask", "id": "site-1", "asked": {"floor_area_ratio": 0.8}}
    outline = {"act": "room", "outline": box(0, 0, 100, 80)}
    long = {"act": "length", "id": "street-1", "edge": 0, "metres": 120}
    draft = drawn(outline, street, away, asked, long, domain="site")
    assert draft["streets"][0]["line"] == [[-5, 40], [115, 40]]
    brief, plan, faults = read_draft(draft)
    assert brief is not None
    assert plan is not None
    site = brief.part.sites[0]
    assert [road.id for road in site.roads] == ["street-1"]
    assert site.floor_area_ratio == 0.8
    assert [fault.message for fault in faults] == ["a street is 220 m away from all that is drawn"]


def test_a_village_is_drawn_by_its_blocks_and_lanes() -> None:
    lane = {"act": "street", "line": [[-5, -4], [105, -4]]}
    asked = {"act": "ask", "id": "block-1", "asked": {"count": 7}}
    brief = read_draft(
        drawn({"act": "room", "outline": box(0, 0, 60, 50)}, lane, asked, domain="village")
    ).brief
    assert brief is not None
    assert (brief.part.blocks[0].count, brief.part.lanes[0].width) == (7, 6.0)
    wrong = {**asked, "asked": {"count": -1}}
    read = read_draft(drawn({"act": "room", "outline": box(0, 0, 60, 50)}, wrong, domain="village"))
    assert [fault.ids for fault in read.faults] == [("block-1",)]


def test_an_extension_is_drawn_by_what_stands_and_where_to_grow() -> None:
    """A house is doubled wall to wall; what is moved alone takes nothing along."""
    house = {"act": "building", "outline": box(0, 10, 8, 20)}
    again = {"act": "shift", "copy": True, "by": [8, 0]}
    bare = drawn({"act": "room", "outline": box(40, 0, 100, 60)}, domain="extend")
    assert [fault.message for fault in read_draft(bare).faults] == ["no buildings are drawn yet"]
    row = [house, *({**again, "id": f"building-{k}"} for k in (1, 2, 3))]
    streets = [{"act": "street", "line": line} for line in ([[-5, 4], [40, 4]], [[45, 4], [90, 4]])]
    acts = [{"act": "room", "outline": box(40, 0, 100, 60), "name": "East"}, *row, *streets]
    use = {"act": "set", "id": "building-2", "key": "use", "value": "shop"}
    draft = drawn(*acts, use, domain="extend")
    made = read_draft(draft)
    assert made.faults == []
    assert made.brief is not None
    source, area = made.brief.part.sources[0], made.brief.part.areas[0]
    assert [one.use for one in source.buildings] == [None, "shop", None, None]
    assert (len(source.roads), len(area.roads), area.name) == (1, 1, "East")
    apart, _ = draw_act(draft, {"act": "shift", "id": "building-4", "by": [2, 0]})
    assert [one["outline"][0] for one in apart["buildings"]] == [
        [0, 10],
        [8, 10],
        [16, 10],
        [26, 10],
    ]
    over, _ = draw_act(draft, {"act": "shift", "id": "building-4", "by": [-2, 0]})
    assert [one.ids for one in read_draft(over).faults] == [("building-3", "building-4")]


def test_storeys_are_drawn_one_over_the_other_and_stairs_lead_up() -> None:
    stairs = {"act": "stairs", "at": [0.8, 2.4], "heading": 0.0}
    wide = {**LEFT, "outline": box(0, 0, 8, 3)}
    acts = [wide, {**RIGHT, "outline": box(8, 0, 11, 3)}, {**DOORS[1], "at": [8, 1]}, stairs]
    below = read_draft(drawn(*acts))
    assert [one.message for one in below.faults] == ["the stairs lead to no storey"]
    draft = drawn(*acts, {"act": "storey", "copy": True})
    up = draft["levels"][1]["id"]
    taller = drawn(
        *acts,
        {"act": "storey", "copy": True},
        {"act": "set", "id": up, "key": "height", "value": 2.4},
    )
    assert taller["levels"][1]["height"] == 2.4
    moved, _ = draw_act(
        draft, {"act": "move", "points": [[8, 0], [8, 3]], "by": [0.5, 0], "level": up}
    )
    assert moved["rooms"][0] == draft["rooms"][0]
    assert moved["rooms"][2]["outline"][1] == [8.5, 0.0]
    brief, plan, faults = read_draft(draft)
    assert brief is not None
    assert plan is not None
    assert [(level.elevation, level.height) for level in brief.levels] == [(0.0, 2.6), (2.85, 2.6)]
    assert [fault.message for fault in faults] == ["no door leads into Bedroom"]
    assert {fault.level for fault in faults} == {up}
    fewer, _ = draw_act(draft, {"act": "remove", "id": up})
    assert fewer["rooms"] == draft["rooms"][:2]


def test_what_was_drawn_before_there_were_storeys_is_read(session: Session) -> None:
    draft = drawn(LEFT, RIGHT, *DOORS)
    older = {
        key: draft[key]
        for key in draft
        if key not in ("domain", "style", "levels", "zones", "streets", "stairs")
    }
    for group in ("rooms", "openings"):
        older[group] = [{k: v for k, v in row.items() if k != "level"} for row in older[group]]
    assert read_draft(complete_draft(older)).plan is not None
    assert complete_draft(older) == draft


def test_wishes_of_a_drawn_room_stay_when_it_is_drawn_on(session: Session) -> None:
    ask(session, verb="begin")
    for act in (LEFT, *DOORS[:1]):
        ask(session, verb="draw", **act)
    wish = {"what": "tv", "forbid": True}
    ask(session, verb="wish", space="room-1", wishes=[wish])
    ask(session, verb="draw", act="set", key="name", value="Flat")
    assert session.state()["wishes"] == {"room-1": {"wishes": [wish]}}
    assert session.state()["draft"]["rooms"][0]["asked"] == {"wishes": [wish]}


@pytest.mark.parametrize("domain", FORMS)
def test_forms_are_made_from_the_schema_of_the_brief(domain: str) -> None:
    schema = ask_schema(domain)
    assert [*schema["keys"]["properties"]] == [*FORMS[domain].keys]
    assert bool(schema["row"]) == bool(FORMS[domain].rows)
    text = json.dumps(schema)
    named = {*re.findall(r"#/\$defs/(\w+)", text)}
    kept = {**schema["keys"]["$defs"], **(schema["row"] or {}).get("$defs", {})}
    assert named == {*kept}


@pytest.mark.parametrize(
    "act",
    [
        {"act": "fly"},
        {"act": "room", "outline": [[0, 0], [1, 1]]},
        {"act": "room", "outline": [[0, 0], [1e400, 1], [3, 3]]},
        {"act": "opening", "kind": "door", "at": [50, 50]},
        {"act": "opening", "kind": "hatch", "at": [0, 0]},
        {"act": "move", "points": [], "by": [1, 0]},
        {"act": "length", "id": "room-1", "edge": 9, "metres": 3},
        {"act": "length", "id": "room-1", "edge": 0, "metres": -3},
        {"act": "set", "id": "room-1", "key": "outline", "value": []},
        {"act": "set", "id": "door-1", "key": "hinge", "value": "top"},
        {"act": "remove", "id": "room-7"},
        {"act": "remove", "id": "level-1"},
        {"act": "street", "line": [[0, 0]]},
        {"act": "stairs", "at": [1, 1], "heading": "up"},
        {"act": "room", "outline": [[0, 0], [1, 1], [0, 1]], "level": "attic"},
        {"act": "ask", "id": "room-1", "asked": {"outline": []}},
        {"act": "ask", "id": "door-1", "asked": {}},
    ],
)
def test_an_act_that_cannot_be_done_changes_nothing(session: Session, act: Json) -> None:
    ask(session, verb="begin")
    for each in (LEFT, DOORS[0]):
        ask(session, verb="draw", **each)
    before = session.state()
    with pytest.raises(InputError) as told:
        ask(session, verb="draw", **act)
    assert "\n" not in str(told.value)
    assert session.state() == before


def test_drawn_undone_furnished_and_drawn_on(session: Session) -> None:
    ask(session, verb="begin")
    acts: list[Json] = [
        LEFT,
        RIGHT,
        *DOORS,
        {"act": "set", "id": "room-2", "key": "name", "value": "Study"},
    ]
    for act in acts:
        ask(session, verb="draw", **act)
    last = session.state()["draft"]
    for _ in acts:
        ask(session, verb="undo")
    assert session.state()["draft"] == new_draft()
    with pytest.raises(InputError, match="nothing is drawn"):
        ask(session, verb="arrange")
    for _ in acts:
        ask(session, verb="redo")
    assert session.state()["draft"] == last
    again = Session(session.db, lambda _event: None)
    assert again.state() == session.state()
    assert [space["name"] for space in again.state()["levels"][0]["spaces"]] == [
        "Living room",
        "Study",
    ]
