"""What a hostile client sends to a running studio: refused, and the rest goes on unharmed."""

from __future__ import annotations

import json
import resource
import socket
import time
from collections.abc import Iterator
from contextlib import suppress
from http.client import HTTPConnection
from threading import Thread
from typing import NamedTuple

import pytest

pytest.importorskip("uvicorn")

import scenewright as sw
from hostile_verbs import list_hostile, write
from scenewright.core.solution import unfurnished
from scenewright.formats import solution_json
from scenewright.studio import guard, limits
from scenewright.studio.guard import Keys, guarded
from scenewright.studio.running import make_server
from scenewright.studio.server import Listeners, studio_app
from scenewright.studio.session import Session
from scenewright.studio.verbs import VERBS
from scenewright.workflow import project
from thoroughness import spread

MANY = 10_000
MOST_MEMORY = 250_000
"""Kilobytes that a hostile client may make this process take, on top of what it had at most."""


class Served(NamedTuple):
    """A studio that runs: its port, what names its owner, and its session."""

    port: int
    cookie: str
    session: Session

    def ask(self, method: str, path: str, body: bytes = b"", **more: str) -> tuple[int, bytes]:
        """Status and answer of a request by the owner, unless headers say otherwise."""
        connection = HTTPConnection("127.0.0.1", self.port, timeout=60)
        own = {"cookie": self.cookie, "origin": f"http://127.0.0.1:{self.port}"}
        connection.request(method, path, body, {**own, **more})
        reply = connection.getresponse()
        answer = reply.status, reply.read()
        connection.close()
        return answer


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    folder = tmp_path_factory.mktemp("served")
    db = project.open_project(folder / "a.studio")
    text = solution_json.dumps(unfurnished(sw.read("sample:home-room")))
    project.add_version(db, 0, "opened", text)
    session = Session(db, lambda _event: None)
    with socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        port = listening.getsockname()[1]
        keys = Keys(port, session.people.find)
        server = make_server(guarded(studio_app(session, Listeners(), folder), keys))
        thread = Thread(target=server.run, kwargs={"sockets": [listening]})
        thread.start()
        while not server.started:
            time.sleep(0.01)
        yield Served(port, f"{keys.name}={keys.cookie}", session)
        server.should_exit = True
        thread.join()
    session.close()
    db.close()


@pytest.mark.parametrize(
    ("method", "path", "headers", "status"),
    [
        ("GET", "/state", {"host": "evil.example"}, 421),
        ("POST", "/do", {"origin": "http://evil.example"}, 403),
        ("POST", "/do", {"origin": ""}, 403),
        ("GET", "/state", {"cookie": ""}, 403),
        ("GET", "/?token=" + "a" * 5000, {"cookie": ""}, 403),
        ("POST", "/?token=x", {"cookie": ""}, 403),
        ("GET", "/../../etc/passwd", {}, 404),
        ("GET", "/%2e%2e/%2e%2e/etc/passwd", {}, 404),
        ("GET", "/page/..%2fguard.py", {}, 404),
        ("GET", "/thumb.png?asset=../../../etc/passwd", {}, 422),
        ("DELETE", "/do", {}, 405),
        ("POST", "/bring?name=a.json", {"content-length": str(1 << 30)}, 413),
        ("POST", "/do", {"content-length": str(2 << 20)}, 413),
        ("POST", "/do", {"content-length": "9" * 400}, 400),
    ],
)
def test_hostile_requests_are_refused(
    served: Served, method: str, path: str, headers: dict[str, str], status: int
) -> None:
    told, answer = served.ask(method, path, **headers)
    assert told == status
    assert b"root:" not in answer
    assert b"Traceback" not in answer


HUGE = b'{"verb": "fit", "piece": "desk", "pose": [1' + b"0" * 400 + b", 0, 0]}"
NO_NUMBER = b'{"verb": "move", "piece": "desk", "pose": [NaN, 0, 0]}'
NOTHINGS = [b"", b"[" * 200_000, b'{"verb": 1e999}', b"\xff\xfe", b"null", HUGE, NO_NUMBER]


@pytest.mark.parametrize("body", NOTHINGS)
def test_bodies_that_mean_nothing_are_one_line(served: Served, body: bytes) -> None:
    status, answer = served.ask("POST", "/do", body)
    assert status == 200, "refused is an answer: no error of the page"
    assert b"fault" in answer


def test_whatever_a_verb_is_asked_with_is_an_answer_in_a_line(served: Served) -> None:
    rows = [one for verb, row in VERBS.items() for one in list_hostile(verb, row.keys)]
    for name, asked in spread(rows, 80):
        status, answer = served.ask("POST", "/do", write(asked))
        assert status == 200, name
        fault = json.loads(answer).get("fault", "")
        assert len(fault.splitlines()) <= 1, name
        assert len(fault) < 2000, name
        served.ask("POST", "/do", b'{"verb": "stop"}')
        served.session.wait()
    assert served.ask("GET", "/state")[0] == 200


def test_who_sends_letter_by_letter_is_left(
    served: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(limits, "SILENT_SECONDS", 0.5)
    monkeypatch.setattr(guard, "BODY_SECONDS", 0.5)
    head = f"POST /do HTTP/1.1\r\nHost: 127.0.0.1:{served.port}\r\n"
    own = f"Origin: http://127.0.0.1:{served.port}\r\nCookie: {served.cookie}\r\n"
    links = [socket.create_connection(("127.0.0.1", served.port), timeout=60) for _ in range(40)]
    for number, link in enumerate(links):
        started = own + "Content-Length: 90\r\n\r\n{" if number % 2 else ""
        link.sendall((head + started).encode())
    assert served.ask("GET", "/samples")[0] == 200
    answers = []
    for link in links:
        with suppress(ConnectionResetError):
            answers.append(link.recv(100))
        link.close()
    assert sum(b" 408 " in answer for answer in answers) == len(links) // 2
    assert served.ask("GET", "/samples")[0] == 200


def test_few_files_are_taken_at_a_time(served: Served) -> None:
    head = (
        f"POST /bring?name=a.json HTTP/1.1\r\nHost: 127.0.0.1:{served.port}\r\n"
        f"Origin: http://127.0.0.1:{served.port}\r\nCookie: {served.cookie}\r\n"
        "Content-Length: 2\r\n\r\n"
    )
    links = [socket.create_connection(("127.0.0.1", served.port)) for _ in range(limits.MOST_FILES)]
    for link in links:
        link.sendall(head.encode() + b"{")
    assert served.ask("GET", "/samples")[0] == 200
    with socket.create_connection(("127.0.0.1", served.port), timeout=0.3) as waiting:
        waiting.sendall(head.encode() + b"{}")
        with pytest.raises(TimeoutError):
            waiting.recv(100)
        for link in links:
            link.close()
        waiting.settimeout(60)
        assert b" 200 " in waiting.recv(100)


def test_a_gigabyte_that_is_streamed_is_cut_off(served: Served) -> None:
    head = (
        f"POST /bring?name=a.json HTTP/1.1\r\nHost: 127.0.0.1:{served.port}\r\n"
        f"Origin: http://127.0.0.1:{served.port}\r\nCookie: {served.cookie}\r\n"
        "Transfer-Encoding: chunked\r\n\r\n"
    )
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    part = b"%x\r\n" % (1 << 20) + b"x" * (1 << 20) + b"\r\n"
    sent = 0
    with socket.create_connection(("127.0.0.1", served.port), timeout=60) as link:
        link.sendall(head.encode())
        with suppress(OSError):
            while sent < 1024:
                link.sendall(part)
                sent += 1
        with suppress(OSError):
            assert b"413" in link.recv(100)
    assert sent < 200
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < MOST_MEMORY
    assert served.ask("GET", "/samples")[0] == 200


@pytest.mark.slow
def test_ten_thousand_connections_leave_room_for_who_asks(served: Served) -> None:
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if hard < MANY + 2000:
        pytest.skip("this machine opens fewer files")
    resource.setrlimit(resource.RLIMIT_NOFILE, (max(soft, MANY + 2000), hard))
    held: list[socket.socket] = []
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    try:
        for k in range(MANY):
            with suppress(OSError):
                held.append(socket.create_connection(("127.0.0.1", served.port), timeout=10))
            if k % 2000 == 1999:
                assert served.ask("GET", "/state")[0] == 200
        assert len(held) > MANY // 2
        assert served.ask("POST", "/do", b'{"verb": "begin"}')[0] == 200
    finally:
        for one in held:
            one.close()
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
    assert served.ask("GET", "/samples")[0] == 200
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < MOST_MEMORY
    assert soft > limits.MOST_CONNECTIONS
