"""The studio: verbs and their versions, what survives a kill, and who is let in."""

from __future__ import annotations

import hashlib
import io
import json
import os
import re
import signal
import sqlite3
import subprocess
import sys
import time
import zipfile
from collections.abc import Iterator
from contextlib import closing
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

import scenewright as sw
from scenewright.core.errors import InputError

pytest.importorskip("starlette")
from starlette.testclient import TestClient

from scenewright.studio.delta import follow_change
from scenewright.studio.drawable import tell_by_key
from scenewright.studio.guard import Keys, guarded
from scenewright.studio.server import PAGES, Listeners, studio_app
from scenewright.studio.session import Session
from scenewright.studio.verbs import do_verb
from scenewright.workflow import project
from scenewright.workflow.editing import edit_pieces
from scenewright.workflow.judging import MoveJudge

PORT = 8420
HOME = f"http://127.0.0.1:{PORT}"


@pytest.fixture(scope="module")
def furnished() -> str:
    from scenewright.formats import solution_json

    return solution_json.dumps(sw.solve(sw.read("sample:home-room"), steps=300))


@pytest.fixture
def session(furnished: str, tmp_path: Path) -> Iterator[Session]:
    """A session that shows a furnished room."""
    db = project.open_project(tmp_path / "room.studio")
    project.add_version(db, 0, "arranged", furnished)
    yield Session(db, lambda _event: None)
    db.close()


@pytest.fixture
def client(session: Session, tmp_path: Path) -> TestClient:
    """A browser that came by the link."""
    keys, listeners = Keys(PORT), Listeners()
    app = guarded(studio_app(session, listeners, tmp_path), keys)
    client = TestClient(app, base_url=HOME)
    assert client.get(f"/?token={keys.token}").text.startswith("<!doctype html>")
    return client


def ask(session: Session, **keys: object) -> dict[str, Any]:
    return do_verb(session, json.dumps(keys).encode())


def desk_of(session: Session) -> dict[str, Any]:
    return next(one for one in session.state()["pieces"] if one["name"] == "desk")


def test_undo_of_every_verb_is_the_start(session: Session) -> None:
    start = session.state()
    desk = desk_of(session)
    x, y, _, heading = desk["pose"]
    ask(session, verb="move", piece=desk["id"], pose=[x + 0.1, y, heading])
    moved = session.state()
    ask(session, verb="lock", piece="single_bed")
    ask(session, verb="again", space=desk["space"], seed=3)
    for _ in range(3):
        ask(session, verb="undo")
    assert session.state()["pieces"] == start["pieces"] != moved["pieces"]
    with pytest.raises(InputError, match="nothing to undo"):
        ask(session, verb="undo")
    ask(session, verb="redo")
    assert session.state()["pieces"] == moved["pieces"]
    assert [step["what"].split()[0] for step in moved["history"]] == ["arranged", "moved"]


def test_edits_are_one_step_each_and_undone_whole(client: TestClient, session: Session) -> None:
    start = session.state()["pieces"]
    shelf = client.get("/shelf").json()
    chair = next(row["asset"] for row in shelf if row["category"] == "armchair")
    assert client.get(f"/thumb.png?asset={chair}").content[:4] == b"\x89PNG"
    assert client.get("/thumb.png?asset=../x").status_code == 422
    two = {one["id"]: [*one["pose"][:2], one["pose"][3]] for one in start[:2] if not one["hangs"]}
    wardrobe = next(one["id"] for one in start if one["name"] == "wardrobe")
    steps: list[dict[str, object]] = [
        {"verb": "move", "poses": two},
        {"verb": "remove", "pieces": ["dining_table", "desk"]},
        {"verb": "add", "asset": chair, "at": [2.2, 2.0]},
        {"verb": "exchange", "piece": wardrobe, "asset": "wardrobe_boho"},
        {"verb": "lock", "pieces": [wardrobe, "single_bed"]},
    ]
    for step in steps:
        assert ask(session, **step)["changes"] is not None
    names = [one["name"] for one in session.state()["pieces"]]
    assert "armchair" in names
    assert "desk" not in names
    for _ in steps:
        ask(session, verb="undo")
    assert session.state()["pieces"] == start


def test_another_way_on_from_an_undone_step_keeps_the_first(session: Session) -> None:
    ask(session, verb="lock", piece="desk")
    ask(session, verb="undo")
    ask(session, verb="lock", piece="single_bed")
    assert [step["parent"] for step in session.state()["history"]] == [0, 1, 1]
    ask(session, verb="undo")
    ask(session, verb="redo")
    assert session.state()["version"] == 3
    ask(session, verb="go", version=2)
    assert desk_of(session)["locked"]


def test_where_it_collides_is_said_before_it_is_put_there(session: Session) -> None:
    desk = desk_of(session)
    other = next(one for one in session.state()["pieces"] if one["name"] == "wardrobe")
    x, y, _, heading = other["pose"]
    found = session.judge({desk["id"]: (x, y, heading)})
    assert any(one["kind"] == "collision" and desk["id"] in one["pieces"] for one in found)
    assert session.judge({desk["id"]: (*desk["pose"][:2], desk["pose"][3])}) == []
    assert session.state()["version"] == 1


def test_what_lies_on_a_piece_goes_with_it(session: Session) -> None:
    shown = session.shown
    assert shown is not None
    lying = next(one for one in shown.solution.pieces if one.on)
    under = next(one for one in shown.solution.pieces if one.id == lying.on)
    to = (under.pose.x + 1.0, under.pose.y, under.pose.heading)
    there = MoveJudge(shown.solution, shown.plan).carry_to(under.id, to)
    assert there[lying.id].pose.x == pytest.approx(lying.pose.x + 1.0)


@pytest.mark.parametrize(
    ("keys", "fault"),
    [
        ({"verb": "fly"}, "no verb"),
        ({"verb": "open", "source": "/etc/passwd"}, "no sample"),
        ({"verb": "move", "piece": "desk", "pose": [1, 2]}, "no place"),
        ({"verb": "move", "piece": "desk", "pose": [1e400, 2, 0]}, "no place"),
        ({"verb": "move", "piece": "unicorn", "pose": [1, 2, 0]}, "unicorn"),
        ({"verb": "move", "poses": {"desk": [1]}}, "no place"),
        ({"verb": "move", "poses": [1]}, "are no places"),
        ({"verb": "add", "asset": "armchair", "at": "here"}, "no place"),
        ({"verb": "add", "asset": "unicorn", "at": [1, 1]}, "unicorn"),
        ({"verb": "remove", "pieces": ["unicorn"]}, "unicorn"),
        ({"verb": "arrange", "seed": -1}, "whole number"),
        ({"verb": "go", "version": 99}, "no version"),
    ],
)
def test_a_verb_that_cannot_be_done_is_one_line_and_changes_nothing(
    session: Session, keys: dict[str, object], fault: str
) -> None:
    with pytest.raises(InputError, match=fault) as told:
        ask(session, **keys)
    assert "\n" not in str(told.value)
    assert session.state()["version"] == 1


def test_arranging_streams_and_ends_in_a_version(client: TestClient, session: Session) -> None:
    events: list[dict[str, object]] = []
    session.tell = events.append
    assert client.post(
        "/do", json={"verb": "arrange", "seed": 5}, headers={"origin": HOME}
    ).is_success
    for _ in range(600):
        if any("changed" in event for event in events) and not session.running:
            break
        time.sleep(0.1)
    assert session.state()["history"][-1]["what"] == "arranged, seed 5"
    assert any("share" in event for event in events)
    assert any(event.get("space") == "room" and event["boxes"] for event in events)


def test_only_the_link_lets_in_and_only_once(session: Session, tmp_path: Path) -> None:
    keys = Keys(PORT)
    app = guarded(studio_app(session, Listeners(), tmp_path), keys)
    link = f"/?token={keys.token}"
    assert TestClient(app, base_url=HOME).get("/state").status_code == 403
    assert TestClient(app, base_url="http://evil.example").get(link).status_code == 421
    first = TestClient(app, base_url=HOME)
    reply = first.get(link, follow_redirects=False)
    assert reply.status_code == 303
    assert {"HttpOnly", "SameSite=Strict"} <= {*reply.headers["set-cookie"].split("; ")}
    assert first.get("/state").is_success
    assert TestClient(app, base_url=HOME).get(link).status_code == 403


def test_other_sites_and_long_bodies_are_refused(client: TestClient) -> None:
    body = {"verb": "undo"}
    assert client.post("/do", json=body).status_code == 403
    assert (
        client.post("/do", json=body, headers={"origin": "http://evil.example"}).status_code == 403
    )
    huge = {"origin": HOME, "content-length": str(1 << 40)}
    assert client.post("/bring?name=a.json", content=b"{}", headers=huge).status_code == 413
    page = client.get("/")
    assert "default-src 'self'" in page.headers["content-security-policy"]
    assert client.get("/../session.py").status_code == 404


def test_what_is_brought_names_no_other_file(client: TestClient) -> None:
    told = {"origin": HOME}
    brief = {"format": "scenewright/brief", "version": 1, "catalogs": ["/etc"], "rooms": []}
    reply = client.post("/bring?name=a.json", json=brief, headers=told)
    assert "outside the workspace" in reply.json()["fault"]
    assert (
        "no name"
        in client.post("/bring?name=../a.json", content=b"{}", headers=told).json()["fault"]
    )
    reply = client.post("/bring?name=a.txt", content=b"hello", headers=told)
    assert reply.status_code == 200, "refused is an answer: no error of the page"
    assert "\n" not in reply.json()["fault"]


def test_a_brought_plan_is_opened_and_exported(client: TestClient) -> None:
    from scenewright.formats.opening import open_source

    body = open_source("sample:home-room").path.read_bytes()
    assert client.post("/bring?name=room.json", content=body, headers={"origin": HOME}).json() == {}
    assert client.get("/state").json()["history"][-1]["what"] == "opened room.json"
    packed = zipfile.ZipFile(io.BytesIO(client.get("/export.zip?formats=json,svg,nothing").content))
    assert sorted(packed.namelist()) == ["scene.json", "scene.svg"]


def test_the_page_is_whole_and_what_is_not_ours_is_as_listed(client: TestClient) -> None:
    from importlib import resources

    for name in PAGES:
        assert client.get(f"/{name}").is_success
    page = resources.files("scenewright.studio") / "page"
    listed = json.loads((page / "three.json").read_text())
    bundle = (page / "three.js").read_bytes()
    assert hashlib.sha256(bundle).hexdigest() == listed["sha256"]
    assert listed["version"].split(".")[1] in bundle.decode()
    assert listed["licence"] in bundle.decode()
    assert client.get("/scene.glb").content[:4] == b"glTF"


def test_files_that_are_no_project_are_left_alone(tmp_path: Path) -> None:
    text, other = tmp_path / "a.studio", tmp_path / "b.studio"
    text.write_text("no database " * 100)
    with closing(sqlite3.connect(other)) as db:
        db.executescript("CREATE TABLE mine (x); INSERT INTO mine VALUES (1)")
    before = [text.read_bytes(), other.read_bytes()]
    for path in (text, other):
        with pytest.raises(InputError):
            project.open_project(path)
    assert [text.read_bytes(), other.read_bytes()] == before


KILLED = """
import sys
from pathlib import Path
from typing import Any
from scenewright.workflow import project
db = project.open_project(Path(sys.argv[1]))
for number in range(100000):
    print(project.add_version(db, number, "step", "x" * 5000), flush=True)
"""


def test_what_was_acknowledged_survives_a_kill(tmp_path: Path) -> None:
    path = tmp_path / "killed.studio"
    for _ in range(3):
        command = [sys.executable, "-c", KILLED, str(path)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as worker:
            assert worker.stdout is not None
            told = [int(worker.stdout.readline()) for _ in range(20)]
            os.kill(worker.pid, signal.SIGKILL)
            told += [int(line) for line in worker.stdout.read().splitlines() if line]
        db = project.open_project(path)
        assert {row.id for row in project.list_versions(db)} >= {*told}
        shown = project.shown_version(db)
        assert shown is not None
        assert shown.id >= told[-1]
        assert project.solution_text(db, shown.id) == "x" * 5000
        db.close()


class _Words(HTMLParser):
    """All that a page says: its text, and the attributes that are read out or shown."""

    def __init__(self) -> None:
        super().__init__()
        self.found: set[str] = set()

    def handle_starttag(self, _tag: str, attrs: list[tuple[str, str | None]]) -> None:
        shown = ("title", "aria-label", "placeholder", "alt")
        self.found |= {value for name, value in attrs if name in shown and value}

    def handle_data(self, data: str) -> None:
        self.found |= {" ".join(data.split())}


def test_every_word_of_the_page_is_in_the_table_of_words_and_no_other(client: TestClient) -> None:
    said = _Words()
    said.feed(client.get("/").text.split("<body>")[1])
    english = {text for text in said.found if re.search("[A-Za-z]{2}", text)} | {"L"}
    for name in (name for name in PAGES if name.endswith(".js") and name != "three.js"):
        script = client.get(f"/{name}").text
        english |= {*re.findall(r'\bt\("([^"]*)"', script)}
        assert not re.search(r"say\(['\"`]\w|textContent[:=] ?['\"`][A-Za-z]{3}", script), name
    table = client.get("/words.zh.json").json()
    assert english == {*table}
    for text, other in table.items():
        assert {*re.findall(r"{\w+}", text)} == {*re.findall(r"{\w+}", other)}, text


def test_the_page_speaks_the_language_of_the_browser_unless_told(client: TestClient) -> None:
    assert 'lang="zh"' in client.get("/", headers={"accept-language": "zh-CN,en;q=0.7"}).text
    assert 'lang="en"' in client.get("/", headers={"accept-language": "fr;q=x,,;"}).text
    client.cookies.set("scenewright-language", "en")
    assert 'lang="en"' in client.get("/", headers={"accept-language": "zh"}).text


def test_a_page_is_told_what_changed_and_little_more(session: Session) -> None:
    first = session.state_since(0)
    desk = desk_of(session)
    x, y, _, heading = desk["pose"]
    for change in (
        lambda: session.change("moved", {"move": {desk["id"]: (x + 0.1, y, heading)}}),
        lambda: session.change("removed", {"remove": [desk["id"]]}, edit_pieces),
        session.undo,
        session.undo,
        session.redo,
    ):
        change()
        told = session.state_since(first["stamp"])
        assert told["since"] == first["stamp"]
        assert len(json.dumps(told)) < 3000
        now = follow_change(first, told)
        whole = tell_by_key(session.state(), session.shapes)
        assert now == whole | {"stamp": now["stamp"]}
        first = session.state_since(0)
    assert session.state_since(10**9)["stamp"] == first["stamp"]
