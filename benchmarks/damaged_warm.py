"""Parsers of damaged files kept warm: a process a parser, that forks for each file.

A reader starts its parser in a new interpreter, which takes longer to start than most files take
to be read. Here that interpreter reads a sound file first and is then forked for each damaged one,
under the same limits of memory and time. A parser that starts threads cannot be forked: each of
its files is read in a new interpreter, as ever.
"""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

from scenewright.core import isolated_reading

PROGRAM = "from benchmarks.damaged_warm import serve; serve()"


class Spent(NamedTuple):
    """Seconds of the processor that the parsers took, and the most mebibytes one of them held."""

    seconds: float = 0.0
    memory: float = 0.0


class WarmParsers:
    """Runs orders of :func:`~scenewright.core.isolated_reading.read_apart` in warm forks."""

    def __init__(self) -> None:
        self.spent = Spent()
        self._fresh = isolated_reading.run_child
        self._servers: dict[str, subprocess.Popen[bytes] | None] = {}

    def run(self, order: bytes, seconds: float) -> isolated_reading.Ended:
        """What a parser answers to an order."""
        module = json.loads(order)["module"]
        if module not in self._servers:
            self._servers[module] = _start(order)
        server = self._servers[module]
        if server is None:
            return self._fresh(order, seconds)
        answer = _ask(server, order)
        spent = Spent(*answer["spent"])
        self.spent = Spent(self.spent.seconds + spent.seconds, max(self.spent.memory, spent.memory))
        return isolated_reading.Ended(answer["said"].encode(), answer["code"])


def _start(order: bytes) -> subprocess.Popen[bytes] | None:
    """A process that has carried out an order, and can be forked; ``None`` if it cannot."""
    server = subprocess.Popen(
        [sys.executable, "-c", PROGRAM],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        cwd=Path(__file__).parent.parent,
        env=isolated_reading.surroundings(),
    )
    if _ask(server, order)["threads"] == 1:
        return server
    server.kill()
    server.wait()
    return None


def _ask(server: subprocess.Popen[bytes], order: bytes) -> dict[str, Any]:
    assert server.stdin is not None
    assert server.stdout is not None
    server.stdin.write(order + b"\n")
    server.stdin.flush()
    answer: dict[str, Any] = json.loads(server.stdout.readline())
    return answer


def serve() -> None:
    """Carry out the first order here, as a warm-up, and each one after it in a fork."""
    orders, answers = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    warmth = io.StringIO()
    isolated_reading.carry_out(json.loads(orders.readline()), warmth)
    _say(answers, {"threads": len(os.listdir("/proc/self/task"))})
    for order in orders:
        with tempfile.TemporaryFile() as said:
            _say(answers, _fork(order, said))


def _say(stream: Any, answer: dict[str, Any]) -> None:
    stream.write(json.dumps(answer).encode() + b"\n")
    stream.flush()


def _fork(order: bytes, said: Any) -> dict[str, Any]:
    """What a fork of this process prints, how it ends and what it takes."""
    child = os.fork()
    if child == 0:
        code = 1
        try:
            os.dup2(said.fileno(), 1)
            with os.fdopen(1, "w", closefd=False) as out:
                wanted = json.loads(order)
                isolated_reading.limit(
                    wanted["memory"] * isolated_reading.MEBIBYTE, wanted["seconds"]
                )
                isolated_reading.carry_out(wanted, out)
            code = 0
        finally:
            os._exit(code)  # nothing of the parent's is cleaned up here
    _, status, used = os.wait4(child, 0)
    said.seek(0)
    text = said.read().decode("utf-8", "replace")
    spent = Spent(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)
    return {"said": text, "code": os.waitstatus_to_exitcode(status), "spent": spent}
