"""Photographs from where one stands, another style and materials, places that fit."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import pytest
from PIL import Image

import scenewright as sw
from scenewright import domains
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.formats import solution_json
from scenewright.workflow.dressing import change_look, list_looks
from scenewright.workflow.fitting import find_nearest_fit
from scenewright.workflow.judging import MoveJudge

pytest.importorskip("starlette")
from scenewright.studio.photos import Photos, View
from scenewright.studio.session import Session
from scenewright.studio.shapes import Json
from scenewright.workflow import project
from studio_asking import ask


@pytest.fixture(scope="module")
def room() -> Solution:
    return sw.solve(sw.read("sample:home-room"), steps=200)


@pytest.fixture
def session(tmp_path: Path, room: Solution) -> Iterator[Session]:
    db = project.open_project(tmp_path / "room.studio")
    made = Session(db, lambda _event: None)
    project.add_version(db, 0, "arranged", solution_json.dumps(room))
    made = Session(db, lambda _event: None)
    yield made
    made.close()
    db.close()


def test_a_photograph_is_taken_from_where_one_stands_and_tells_how_far_it_is(
    room: Solution,
) -> None:
    told: list[Json] = []
    photos = Photos(told.append)
    with pytest.raises(InputError, match="no photograph was taken yet"):
        photos.last()
    plan = domains.plan_of(room.brief)
    photos.begin(room, plan, View((1.0, 1.0, 1.6), 0.8, size=(48, 32), samples=2))
    assert photos.worker is not None
    photos.worker.join()
    assert Image.open(io.BytesIO(photos.last())).size == (48, 32)
    shares = [event["photo"] for event in told if "photo" in event]
    assert shares[0] == 0.0
    assert shares[-1] == 1.0
    assert shares == sorted(shares)


def test_a_photograph_is_given_up_or_refused_in_words(room: Solution) -> None:
    told: list[Json] = []
    photos = Photos(told.append)
    plan = domains.plan_of(room.brief)
    photos.tell = lambda event: (told.append(event), photos.stop())  # type: ignore[assignment,func-returns-value]
    photos.begin(room, plan, View((1.0, 1.0, 1.6), 0.8, size=(64, 64)))
    assert photos.worker is not None
    photos.worker.join()
    assert told[-1]["photo"] is None
    assert "stopped" in told[-1]["notice"]
    photos.tell = told.append
    photos.begin(room, plan, View((99.0, 99.0, 1.6), 0.0, size=(32, 32)))
    photos.worker.join()
    assert "no room is at" in told[-1]["fault"]
    with pytest.raises(InputError, match="hour"):
        photos.begin(room, plan, View((1.0, 1.0, 1.6), 0.8, hour="tea"))
    village = sw.read("sample:village-hamlet")
    with pytest.raises(InputError, match="cameras stand in rooms"):
        photos.begin(room, domains.plan_of(village), View((1.0, 1.0, 1.6), 0.8))


def test_another_look_moves_nothing_and_leaves_what_is_locked(room: Solution) -> None:
    first = room.pieces[0].id
    locked = domains.adjust(room, lock=[first]).solution
    for style, palettes in list_looks("home").items():
        other, changes = change_look(locked, style, [*palettes][-1])
        assert [piece.pose for piece in other.pieces] == [piece.pose for piece in locked.pieces]
        assert other.pieces[0].asset == locked.pieces[0].asset
        assert changes
        assert {one["piece"] for one in changes} == {
            piece.id
            for piece, was in zip(other.pieces, locked.pieces, strict=True)
            if piece.asset != was.asset
        }
        plan = domains.plan_of(other.brief)
        assert domains.scene_of(other, plan).palette == f"{style}/{[*palettes][-1]}"
    with pytest.raises(InputError, match="no palette of retro"):
        change_look(locked, "retro", "fjord")
    with pytest.raises(InputError, match="no style of this"):
        change_look(locked, "rococo")


def test_a_style_for_all_is_one_step_that_is_undone(session: Session) -> None:
    before = session.state()
    said = ask(session, verb="restyle", style="retro", palette="teal")
    assert said["changes"]
    assert session.state()["history"][-1]["what"] == "restyled, retro teal"
    ask(session, verb="undo")
    assert session.state()["pieces"] == before["pieces"]


def test_where_a_piece_does_not_fit_the_nearest_place_is_told(
    session: Session, room: Solution
) -> None:
    judge = MoveJudge(room)
    for piece in (one for one in room.pieces if one.on is None and one.pose.z == 0):
        for wanted in ((-5.0, -5.0), (piece.pose.x, piece.pose.y)):
            place = find_nearest_fit(judge, piece.id, (*wanted, piece.pose.heading))
            assert place is not None
            assert judge.find_new({piece.id: place}) == ()
    desk = next(piece for piece in room.pieces if piece.category == "desk")
    said = ask(session, verb="fit", piece=desk.id, pose=[-5.0, -5.0, 0.0])
    assert session.judge({desk.id: said["pose"]}) == []
    with pytest.raises(InputError, match="there is no piece"):
        ask(session, verb="fit", piece="nothing", pose=[0, 0, 0])
