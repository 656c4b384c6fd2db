"""A studio that is killed while verbs are sent to it: what it has acknowledged is there again."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing, contextmanager
from http.client import HTTPConnection, HTTPException
from pathlib import Path
from threading import Timer
from typing import NamedTuple

import pytest

pytest.importorskip("uvicorn")

import scenewright as sw
from scenewright.formats import solution_json
from scenewright.workflow import project
from thoroughness import few_or_many

PIECES = ("desk", "single_bed", "wardrobe")
LONGEST = 0.4
"""Seconds after which the studio is killed, at most."""
FEW = 4
"""Verbs that are waited for before, at most."""
SERVING = """
import os, socket, sys
from pathlib import Path
from scenewright.studio.running import serve
from scenewright.workflow.project import open_project
for line in sys.stdin:
    if os.fork() == 0:
        listening = socket.socket()
        listening.bind(("127.0.0.1", 0))
        listening.listen(16)
        port = listening.getsockname()[1]
        ready = lambda token: print(os.getpid(), port, token, flush=True)
        serve(open_project(Path(sys.argv[1])), "", Path(sys.argv[2]), listening, "127.0.0.1", ready)
        os._exit(0)
    os.wait()
"""
"""Begins the studio of a project again and again, each time it is told to."""


class Begun(NamedTuple):
    """A studio that runs: its process and how it is asked as its owner."""

    number: int
    port: int
    headers: dict[str, str]

    def do(self, verb: str) -> bool:
        """Whether a verb was acknowledged."""
        link = HTTPConnection("127.0.0.1", self.port, timeout=60)
        try:
            link.request("POST", "/do", verb.encode(), self.headers)
            answer = link.getresponse()
            return answer.status == 200 and b"fault" not in answer.read()
        except (OSError, HTTPException):
            return False
        finally:
            link.close()


@contextmanager
def beginning(path: Path) -> Iterator[subprocess.Popen[str]]:
    command = [sys.executable, "-c", SERVING, str(path), str(path.parent)]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as served:
        yield served
        assert served.stdin is not None
        served.stdin.close()


def begin(served: subprocess.Popen[str]) -> Begun:
    assert served.stdin is not None
    assert served.stdout is not None
    served.stdin.write("\n")
    served.stdin.flush()
    number, port, token = served.stdout.readline().split()
    link = HTTPConnection("127.0.0.1", int(port), timeout=60)
    link.request("GET", f"/?token={token}")
    cookie = link.getresponse().headers["set-cookie"].partition(";")[0]
    link.close()
    return Begun(int(number), int(port), {"Origin": f"http://127.0.0.1:{port}", "Cookie": cookie})


def send_until_killed(studio: Begun, rng: random.Random) -> list[str]:
    """Verbs that were acknowledged before the studio was killed, a random time after the first
    few."""
    ending = Timer(rng.uniform(0, LONGEST), os.kill, (studio.number, signal.SIGKILL))
    kept, few = list[str](), rng.randint(0, FEW)
    while True:
        if len(kept) >= few and ending.ident is None:
            ending.start()
        what = rng.choice(("lock", "unlock", "undo", "redo"))
        verb = f'{{"verb": "{what}", "piece": "{rng.choice(PIECES)}"}}'
        if studio.do(verb):
            kept.append(what)
        elif ending.ident is not None and not ending.is_alive():
            ending.join()
            return kept


def shown_since(path: Path, first: int) -> list[int]:
    """The versions shown one after the other, from an entry on."""
    with closing(project.open_project(path)) as db:
        rows = db.execute("SELECT version FROM shown ORDER BY id").fetchall()[first:]
        versions = {row.id: row for row in project.list_versions(db)}
        assert {row[0] for row in rows} <= {*versions}
        for number in {row[0] for row in rows}:
            solution_json.loads(project.solution_text(db, number))
    return [int(row[0]) for row in rows]


def test_verbs_that_were_acknowledged_are_there_after_a_kill(tmp_path: Path) -> None:
    path, rng, told = tmp_path / "room.studio", random.Random(11), 0
    text = solution_json.dumps(sw.solve(sw.read("sample:home-room"), steps=300))
    with closing(project.open_project(path)) as db:
        project.add_version(db, 0, "arranged", text)
    known = 1
    with beginning(path) as served:
        for _ in range(few_or_many(4, 200)):
            kept = send_until_killed(begin(served), rng)
            entries = shown_since(path, known)
            # One more may have been done whose answer the kill cut off.
            assert len(kept) <= len(entries) <= len(kept) + 1
            known, told = known + len(entries), told + len(kept)
    assert told > 0
