"""Plans drawn on the page: what an act does to shared walls, faults where they lie, and undo."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from scenewright.core.errors import InputError

pytest.importorskip("starlette")
from scenewright.studio.draft_faults import read_draft
from scenewright.studio.drafting import draw_act, new_draft
from scenewright.studio.drawable import Json
from scenewright.studio.session import Session
from scenewright.studio.verbs import do_verb
from scenewright.workflow import project

LEFT = {"act": "room", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "name": "Living room"}
RIGHT = {"act": "room", "outline": [[4, 0], [7, 0], [7, 3], [4, 3]], "name": "Bedroom"}
DOORS = [
    {"act": "opening", "kind": "door", "at": [1, 0.1]},
    {"act": "opening", "kind": "door", "at": [4, 2]},
    {"act": "opening", "kind": "window", "at": [7, 1.5]},
]


def drawn(*acts: Json) -> Json:
    draft = new_draft()
    for act in acts:
        draft, _ = draw_act(draft, act)
    return draft


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    db = project.open_project(tmp_path / "new.studio")
    yield Session(db, lambda _event: None)
    db.close()


def ask(session: Session, **keys: object) -> Json:
    return do_verb(session, json.dumps(keys).encode())


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
