"""People: links and what they let one do, one pool for all who rate, and no mark lost."""

from __future__ import annotations

import json
import random
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import scenewright as sw
from scenewright.core.errors import InputError
from scenewright.core.solution import unfurnished
from scenewright.engine.preference.events import Lock, Pick, Stars
from scenewright.formats import solution_json
from scenewright.workflow.evolution.log import EvolutionLog
from scenewright.workflow.evolution.population import BreedingPlan
from scenewright.workflow.evolution.raters import Mark, RaterPool

pytest.importorskip("starlette")
from starlette.testclient import TestClient

from scenewright.studio.guard import Keys, guarded
from scenewright.studio.people import People
from scenewright.studio.server import Listeners, studio_app
from scenewright.studio.session import Session
from scenewright.workflow import project

HOME = "sample:home-room"
FEW = BreedingPlan(first=6, each=2, rounds=1, brood=4)
PORT = 8420
ADDRESS = f"http://127.0.0.1:{PORT}"


@pytest.fixture(scope="module")
def pool() -> Iterator[tuple[RaterPool, list[Mark]]]:
    """A pool of few layouts, and the marks it kept."""
    kept: list[Mark] = []
    made = RaterPool(
        sw.read(HOME), EvolutionLog(""), lambda *one: kept.append(Mark(*one)), breeding=FEW
    )
    made.prepare()
    yield made, kept
    made.close()


def test_raters_share_a_pool_and_have_a_taste_each(pool: tuple[RaterPool, list[Mark]]) -> None:
    raters, _ = pool
    sheets = {name: raters.ask(name) for name in ("Ada", "Bo")}
    shown = {name: [one.number for one in sheet.candidates] for name, sheet in sheets.items()}
    assert {*shown["Ada"]} == {*shown["Bo"]}
    numbers = tuple(shown["Ada"])
    raters.tell("Ada", Pick(numbers[0], numbers), Stars(numbers[1], 5, 0))
    raters.tell("Bo", Pick(numbers[2], numbers))
    ada, bo = raters.screen("Ada"), raters.screen("Bo")
    assert ada is not None
    assert bo is not None
    assert (ada.champion, bo.champion) == (numbers[0], numbers[2])
    assert ada.candidates[0].predicted != bo.candidates[0].predicted
    assert {one.number for one in raters.liked()} == {*numbers[:3]}
    with pytest.raises(InputError, match="same for all"):
        raters.tell("Bo", Lock("sofa"))
    raters.undo("Bo")
    assert raters.raters()["Bo"] == 0


def test_a_pool_begun_again_knows_all_that_was_marked(pool: tuple[RaterPool, list[Mark]]) -> None:
    raters, kept = pool
    again = RaterPool(sw.read(HOME), raters._log, lambda *_: None, kept, breeding=FEW)
    assert again.raters() == raters.raters()
    assert again.history("Ada") == raters.history("Ada")


def test_no_mark_of_many_at_once_is_lost(tmp_path: Path) -> None:
    db = project.open_project(tmp_path / "a.studio")
    people = People(db)
    number = people.begin_pool("{}")

    def rate(who: int) -> None:
        for k in range(10):
            people.keep(number, str(who), "event", {"event": "undo", "k": k})

    with ThreadPoolExecutor(32) as workers:
        [*workers.map(rate, range(100))]
    fresh = People(project.open_project(tmp_path / "a.studio")).marks(number)
    assert len(fresh) == 1000
    for who in random.Random(1).sample(range(100), 5):
        mine = [mark.body["k"] for mark in fresh if mark.rater == str(who)]
        assert mine == [*range(10)]


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Session, Keys, object]]:
    folder = tmp_path_factory.mktemp("people")
    db = project.open_project(folder / "room.studio")
    project.add_version(db, 0, "opened", solution_json.dumps(unfurnished(sw.read(HOME))))
    session = Session(db, lambda _event: None)
    keys = Keys(PORT, session.people.find)
    yield session, keys, guarded(studio_app(session, Listeners(), folder), keys)
    session.close()
    db.close()


def enter(app: object, token: str) -> TestClient:
    client = TestClient(app, base_url=ADDRESS, headers={"origin": ADDRESS})  # type: ignore[arg-type]
    assert client.get(f"/?token={token}").is_success
    return client


def do(client: TestClient, verb: str, **keys: object) -> dict[str, object]:
    return dict(client.post("/do", content=json.dumps({"verb": verb, **keys})).json())


def test_a_link_lets_in_whom_it_is_for_and_to_what_it_says(
    served: tuple[Session, Keys, object],
) -> None:
    session, keys, app = served
    owner = enter(app, keys.token or "")
    tokens = {
        right: str(do(owner, "invite", name=f"A {right}", right=right)["token"])
        for right in ("view", "rate", "edit")
    }
    viewer, rater, editor = (enter(app, token) for token in tokens.values())
    assert viewer.get("/state").json()["me"] == {"name": "A view", "right": "view"}
    assert "does not let you" in str(do(viewer, "undo")["fault"])
    assert "does not let you" in str(do(rater, "arrange")["fault"])
    assert "does not let you" in str(do(editor, "invite", name="x", right="edit")["fault"])
    assert viewer.post("/bring?name=a.json", content=b"{}").status_code == 403
    assert "only the owner" in editor.get("/ratings").json()["fault"]
    for _ in range(1200):
        if session.raters.pool is not None and session.raters.pool.is_ready():
            break
        time.sleep(0.05)
    assert do(rater, "breed") == {}
    sheet = rater.get("/breeding").json()
    assert do(rater, "say", line="2", sheet=0) == {}
    cards = rater.get(f"/cards?of={sheet['shown'][1]['number']},999").json()["cards"]
    assert len(cards) == 1
    told = owner.get("/ratings").json()
    assert [one["number"] for one in told["liked"]] == [sheet["shown"][1]["number"]]
    assert {one["name"]: one["marks"] for one in told["people"]}["A rate"] == 1
    assert do(owner, "take", number=sheet["shown"][1]["number"]) == {}
    assert do(editor, "lock", piece=session.state()["pieces"][0]["id"])["changes"] is not None
    assert session.state()["history"][-1]["what"].startswith("A edit: locked")
    second = next(one.id for one in session.people.all() if one.right == "rate")
    renewed = str(do(owner, "renew", person=second)["token"])
    assert rater.get("/state").status_code == 403
    assert enter(app, renewed).get("/breeding").json()["champion"] == sheet["shown"][1]["number"]
    do(owner, "drop", person=second)
    assert TestClient(app, base_url=ADDRESS).get(f"/?token={renewed}").status_code == 403  # type: ignore[arg-type]
