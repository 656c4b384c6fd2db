"""Plans that were brought and are drawn over: what was taken into the drawing means the same."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

import scenewright as sw
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.domains import plan_of

pytest.importorskip("starlette")
from scenewright.studio.draft_faults import read_draft
from scenewright.studio.draft_taken import draft_of
from scenewright.studio.drafting import draw_act
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.workflow import project
from studio_asking import ask, box


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    db = project.open_project(tmp_path / "new.studio")
    yield Session(db, lambda _event: None)
    db.close()


def outlines_of(plan: Plan) -> dict[str, list[list[float]]]:
    return {space.id: space.outline.round(3).tolist() for space in plan.spaces}


@pytest.mark.parametrize("sample", ["home-flat", "home-house", "hall-shop"])
def test_a_plan_that_was_brought_is_the_same_when_it_is_taken_over(sample: str) -> None:
    brief = sw.read(f"sample:{sample}")
    was, draft = plan_of(brief), draft_of(brief)
    assert draft["lost"] == []
    read = read_draft(json.loads(json.dumps(draft)))
    assert [fault for fault in read.faults if not fault.warns] == []
    assert read.plan is not None
    assert outlines_of(read.plan) == outlines_of(was)
    assert read.plan.levels == was.levels or len(was.levels) == 1
    for old, new in zip(was.spaces, read.plan.spaces, strict=True):
        assert new.functions == old.functions
        assert len(new.openings) == len(old.openings)
        assert len(new.holes) == len(old.holes)


def test_a_wall_of_a_plan_that_was_brought_moves_with_both_its_faces() -> None:
    rooms = [
        {"name": "Kitchen", "outline": box(0, 0, 3, 3), "doors": [{"at": [3, 1.5]}]},
        {"name": "Study", "outline": box(3.1, 0, 6, 3)},
        {"name": "Bath", "outline": box(0, 3.1, 3, 5), "holes": [[[1, 4], [2, 4], [1.5, 4.5]]]},
    ]
    walls = [{"start": [0, -0.1], "end": [6, -0.1]}]
    document = {"name": "Flat", "rooms": rooms, "walls": walls, "residents": 2}
    draft = draft_of(sw.Brief.model_validate(document))
    assert [text.split(":")[0] for text in draft["lost"]] == [
        "walls that are drawn for themselves",
        "a column of Bath that is no square along the axes",
    ]
    moved, _ = draw_act(draft, {"act": "move", "points": [[3, 0], [3, 3]], "by": [0.5, 0]})
    brief, plan, _ = read_draft(moved)
    assert brief is not None
    assert plan is not None
    kitchen, study, bath = (space.outline for space in plan.spaces)
    assert (kitchen[:, 0].max(), study[:, 0].min(), bath[:, 0].max()) == (3.5, 3.6, 3.0)
    assert moved["openings"][0]["at"] == [3.5, 1.5]
    assert len(plan.spaces[2].holes) == 1
    assert brief.residents == 2


def test_a_sample_is_drawn_over_furnished_and_undone(session: Session) -> None:
    ask(session, verb="open", source="sample:home-room")
    with pytest.raises(InputError, match="redraw"):
        ask(session, verb="draw", act="room", outline=box(0, 0, 4, 3))
    assert ask(session, verb="redraw") == {"lost": []}
    wall = session.state()["draft"]["rooms"][0]["outline"][:2]
    ask(session, verb="draw", act="move", points=wall, by=[0, -0.2])
    state = session.state()
    assert state["faults"] == []
    assert state["levels"], "it can be furnished"
    for _ in range(2):
        ask(session, verb="undo")
    assert "draft" not in session.state()


def test_an_extension_of_several_sources_is_not_drawn_over() -> None:
    kept = sw.read("sample:extend-court")
    document = json.loads(kept.model_dump_json())
    document["sources"] *= 2
    with pytest.raises(InputError, match="several sources"):
        draft_of(sw.Brief.model_validate(document))


@pytest.mark.parametrize(
    "sample",
    ["site-courtyards", "site-landmarks", "village-dense", "extend-court", "extend-village"],
)
def test_ground_that_was_brought_means_the_same_when_it_is_taken_over(sample: str) -> None:
    brief = sw.read(f"sample:{sample}")
    draft = draft_of(brief)
    read = read_draft(json.loads(json.dumps(draft)))
    assert (draft["lost"], read.faults) == ([], [])
    assert read.brief is not None
    assert document_of(read.brief) == document_of(brief)


def document_of(brief: sw.Brief) -> Json:
    """All that a brief says; a place without a name is named by its id in a drawing, and streets
    and buildings are given ids."""
    document: Json = json.loads(brief.model_dump_json())
    for place in (*document.get("sites", ()), *document.get("blocks", ())):
        place["name"] = place["name"] or place["id"]
    for place in (
        *document.get("sources", ()),
        *document.get("areas", ()),
        *document.get("sites", ()),
    ):
        for row in (*place["roads"], *place.get("buildings", ())):
            row["id"] = ""
    return document


def two_sites() -> sw.Brief:
    """Two sites side by side; the street of the first is farther than streets are taken for its,
    that of the second near both."""
    far = {"id": "far", "line": [[0, -30], [60, -30]], "width": 6}
    near = {"id": "near", "line": [[70, -5], [130, -5]], "width": 6}
    sites = [
        {"id": "west", "outline": box(0, 0, 60, 50), "verge": 40, "roads": [far]},
        {"id": "east", "outline": box(70, 0, 130, 50), "roads": [near]},
    ]
    return sw.Brief.model_validate({"name": "Two", "domain": "site", "sites": sites})


def test_streets_stay_those_of_their_sites() -> None:
    read = read_draft(json.loads(json.dumps(draft_of(two_sites()))))
    assert read.faults == []
    assert read.brief is not None
    assert document_of(read.brief)["sites"] == document_of(two_sites())["sites"]


def test_streets_of_a_site_that_is_removed_go_to_what_is_near() -> None:
    draft, _ = draw_act(draft_of(two_sites()), {"act": "remove", "id": "east"})
    read = read_draft(draft)
    assert read.brief is not None
    (west,) = document_of(read.brief)["sites"]
    assert [road["line"][0] for road in west["roads"]] == [[0.0, -30.0], [70.0, -5.0]]


def test_sides_of_a_block_are_streets_still_when_it_is_turned_round() -> None:
    ring = [[0, 0], [0, 40], [60, 40], [60, 0]]
    block = {"id": "b", "outline": ring, "streets": [1], "count": 3}
    lane = {"line": [[0, 45], [60, 45]], "width": 4}
    document = {"name": "V", "domain": "village", "blocks": [block], "lanes": [lane]}
    draft = draft_of(sw.Brief.model_validate(document))
    taken = draft["rooms"][0]
    side = taken["streets"][0]
    ends = {tuple(taken["outline"][side]), tuple(taken["outline"][(side + 1) % 4])}
    assert ends == {(0, 40), (60, 40)}
    assert taken["asked"] == {"count": 3}
    assert draft["streets"][0]["width"] == 4


def test_a_site_that_was_brought_is_drawn_over_and_undone(session: Session) -> None:
    ask(session, verb="open", source="sample:site-courtyards")
    assert session.state()["redraws"]
    assert ask(session, verb="redraw") == {"lost": []}
    corner = session.state()["draft"]["rooms"][0]["outline"][0]
    ask(session, verb="draw", act="move", points=[corner], by=[2, 1])
    state = session.state()
    assert state["faults"] == []
    assert state["draft"]["rooms"][0]["outline"][0] == [corner[0] + 2, corner[1] + 1]
    for _ in range(2):
        ask(session, verb="undo")
    assert "draft" not in session.state()
