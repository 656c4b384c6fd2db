"""Uses damaged files one after another in a fork of this process, watched from outside.

Of each file it is told whether it was accepted or refused or led to an internal error, the seconds
of the processor and the most memory, of the process beyond what it held before or of one that it
started. A fork that is stuck, or takes too much of the processor, is ended; the rest goes on in
another.
"""

from __future__ import annotations

import json
import os
import resource
import select
import shutil
import signal
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.damaged_warm import Spent, WarmParsers
from scenewright.core import isolated_reading

MEBIBYTE = 2**20
GUARD = 3072 * MEBIBYTE
"""Bytes of address space that a run may take beyond what the process held before."""
LONGEST = 120.0
"""Seconds of the processor after which a run counts as endless."""
STUCK = 20.0
"""Seconds without work of the processor after which a run counts as stuck."""
LOOK = 0.5

Use = Callable[[Path, Path], int]


class DamagedRun(NamedTuple):
    """What a file led to: ``accepted``, ``refused``, ``error`` or ``hang``, and why."""

    outcome: str
    seconds: float
    memory: float
    said: str


def run_all(paths: Sequence[Path], use: Use, spare: Path) -> Iterator[tuple[Path, DamagedRun]]:
    """Every file with what it led to, in order. The first is a sound one: it warms each fork."""
    sound, left = paths[0], list(paths)
    while left:
        reader, writer = os.pipe()
        child = os.fork()
        if child == 0:
            try:
                os.close(reader)
                _work(left, use, spare, writer, sound)
            finally:
                os._exit(1)  # nothing of the parent's is cleaned up here
        os.close(writer)
        with os.fdopen(reader, "rb") as answers:
            for run in _hear(child, answers):
                yield left.pop(0), run
        os.waitpid(child, 0)


def _work(paths: Sequence[Path], use: Use, spare: Path, writer: int, sound: Path) -> None:
    """Use the files and write a line for each; never returns."""
    again = sound if sound not in paths else None
    held = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (held + GUARD, held + GUARD))
    parsers = WarmParsers()
    isolated_reading.run_child = parsers.run
    if again is not None:
        (spare / f"warm-{os.getpid()}").mkdir()
        measure_run(again, use, spare / f"warm-{os.getpid()}", parsers)
    for number, path in enumerate(paths):
        folder = spare / f"run-{os.getpid()}-{number}"
        folder.mkdir()
        run = measure_run(path, use, folder, parsers)
        shutil.rmtree(folder, ignore_errors=True)
        os.write(writer, json.dumps(run).encode() + b"\n")
    os._exit(0)


def measure_run(path: Path, use: Use, folder: Path, parsers: WarmParsers) -> DamagedRun:
    """Use a file in this process, and what it is parsed by in another."""
    from scenewright.core.errors import CancelledError, InputError

    Path("/proc/self/clear_refs").write_text("5")
    parsers.spent = Spent()
    before, begun = _memory("VmRSS"), _seconds()
    outcome, said = "accepted", ""
    try:
        if use(path, folder) == 2:
            outcome = "refused"
    except (InputError, CancelledError) as error:
        outcome, said = "refused", str(error)[:300]
        if "\n" in str(error):
            outcome = "error"
    except BaseException as error:  # whatever ends a run that way is what is looked for
        outcome, said = "error", f"{type(error).__name__}: {error}"[:300]
    started = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    most = max(_memory("VmHWM") - before, started, parsers.spent.memory)
    return DamagedRun(outcome, _seconds() + parsers.spent.seconds - begun, most, said)


def _seconds() -> float:
    """Seconds of the processor of this process and of those it started that have ended."""
    taken = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in taken)


def _memory(name: str) -> float:
    """Mebibytes of memory as the system states them of this process."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith(name)) / 1024


def _hear(child: int, answers: Any) -> Iterator[DamagedRun]:
    """What a fork says, until it is done, dies or has to be ended."""
    begun = seen = _work_of(child)
    idle, text = time.monotonic(), b""
    while True:
        if select.select([answers], [], [], LOOK)[0]:
            more = os.read(answers.fileno(), 65536)
            if not more:
                yield from _report_death(child)
                return
            *lines, text = (text + more).split(b"\n")
            yield from (DamagedRun(*json.loads(line)) for line in lines)
            begun = seen = _work_of(child)
            idle = time.monotonic()
            continue
        now = _work_of(child)
        if now - seen > 0.05 or not _is_asleep(child):
            seen, idle = now, time.monotonic()
        stuck = time.monotonic() - idle > STUCK
        if now - begun > LONGEST or stuck:
            os.kill(child, signal.SIGKILL)
            yield DamagedRun("hang", now - begun, 0.0, "stuck" if stuck else "endless")
            return


def _report_death(child: int) -> Iterator[DamagedRun]:
    """A fork that ended before it had said all leaves one file to blame."""
    status = os.waitid(os.P_PID, child, os.WEXITED | os.WNOWAIT)
    if status is not None and status.si_status != 0:
        yield DamagedRun("error", 0.0, 0.0, f"ended by {status.si_status}")


def _work_of(process: int) -> float:
    """Seconds of the processor a process has taken, with all that it started."""
    try:
        told = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
        below = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    except OSError:
        return 0.0
    own = sum(int(told[k]) for k in (11, 12, 13, 14)) / os.sysconf("SC_CLK_TCK")
    return own + sum(_work_of(int(one)) for one in below)


def _is_asleep(child: int) -> bool:
    try:
        return Path(f"/proc/{child}/stat").read_text().rpartition(")")[2].split()[0] in "SD"
    except OSError:
        return False
