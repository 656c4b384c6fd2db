"""A worker of a batch: takes one file at a time as a line of JSON, answers with its row.

A process of its own, started by :mod:`scenewright.batch.worker_pool`. It ends when its
parent does, and takes no more memory than it may.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import time
from errno import ENOMEM
from pathlib import Path
from threading import Thread
from typing import Any, NamedTuple, TextIO

from scenewright.batch.jobs import BatchOptions
from scenewright.batch.table import COMPLETE, LEFT_OUT, NOT_VALID, ResultRow, make_failed_row
from scenewright.core.atomic_file import recorded_run
from scenewright.core.errors import InputError
from scenewright.core.garbage import collect_rarely
from scenewright.core.map_options import restore_options
from scenewright.core.plugins import REMEDY, blame_plugin

PATIENCE = 0.5
"""Seconds between looks at whether the parent is still there."""
READY = "ready"


class Order(NamedTuple):
    """What a worker is asked to do: a file, where its results go, the seed and the look."""

    source: str
    outputs: tuple[str, ...]
    seed: int = 0
    look: int = 0


def main() -> None:
    """Answer every line that comes in with one line, until no more come."""
    answers = os.fdopen(os.dup(1), "w", encoding="ascii")
    os.dup2(2, 1)  # whatever a library prints is no answer
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    collect_rarely()
    Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()
    first = json.loads(sys.stdin.readline())
    given: dict[str, Any] = first["options"]
    given |= {key: tuple(given[key]) for key in ("formats", "catalogs", "groups", "vary")}
    given["map_options"] = restore_options(given["map_options"])
    options = BatchOptions(**given)
    _bound(first["memory"])
    _answer(answers, READY)
    with recorded_run((device, number) for device, number in first["protected"]):
        for line in sys.stdin:
            asked = json.loads(line)
            order = Order(asked["source"], tuple(asked["outputs"]), asked["seed"], asked["look"])
            _answer(answers, do_order(order, options, first["memory"], Path(first["parts"])))


def _answer(answers: TextIO, value: Any) -> None:
    answers.write(json.dumps(value) + "\n")
    answers.flush()


def _end_with(parent: int) -> None:
    """Leave at once when the parent is gone: nobody would hear the answer."""
    while os.getppid() == parent:
        time.sleep(PATIENCE)
    os._exit(1)


def _bound(memory: float) -> None:
    """Take no more than ``memory`` GiB, where the system can hold a process to that."""
    try:
        import resource
    except ImportError:
        return
    most = int(memory * 2**30)
    before = resource.getrlimit(resource.RLIMIT_DATA)[1]
    if before == resource.RLIM_INFINITY or most < before:
        resource.setrlimit(resource.RLIMIT_DATA, (most, before))


def do_order(order: Order, options: BatchOptions, memory: float, parts: Path) -> ResultRow:
    """Do one order, wherever: the one function of a batch. Whatever goes wrong becomes its row."""
    begun, source = time.perf_counter(), order.source
    try:
        row = _done(order, options, parts)
        return row._replace(seconds=round(time.perf_counter() - begun, 3))
    except InputError as error:
        text = str(error.located(file=source))
    except Exception as error:
        text = f"internal error, please report: {type(error).__name__}: {error}"
        if plugin := blame_plugin(error.__traceback__):
            text = f"a plug-in failed: {plugin}: {type(error).__name__}: {error}; {REMEDY}"
        if _is_out_of_memory(error):
            text = f"takes more than {memory:g} GiB of memory; allow more with --memory"
        text = f"{source}: {text}"
    return make_failed_row(source, time.perf_counter() - begun, text)


def _is_out_of_memory(error: Exception) -> bool:
    """Whether an error comes of having too little memory: threads need some too, and the
    interpreter may fail without saying why."""
    number = getattr(error, "errno", None)
    unsaid = any(phrase in str(error) for phrase in ("new thread", "without exception set"))
    return isinstance(error, MemoryError) or number == ENOMEM or unsaid


def _done(order: Order, options: BatchOptions, parts: Path) -> ResultRow:
    """Arrange one file; its results appear when all are written."""
    from scenewright.batch.manifest import describe_scene
    from scenewright.workflow.arrange import arrange_file
    from scenewright.workflow.events import run_to_end
    from scenewright.workflow.looks import Look
    from scenewright.workflow.request import ArrangeRequest

    given = options._asdict()
    given.pop("formats")
    look = Look(order.seed, order.look, given.pop("vary"))
    given |= {"seed": order.seed, "look": look if look.vary else None}
    source, outputs = order.source, tuple(map(Path, order.outputs))
    request = ArrangeRequest(source, outputs, **given)
    solution, _, report = run_to_end(arrange_file(request, threads=1, parts=parts))
    missing = [out for out in solution.left_out if out.required]
    broken = sum(found.is_blamed for found in report.findings)
    read = solution.brief.input_report
    unread = list(read.warnings) if read else []
    status = NOT_VALID if not report.valid else LEFT_OUT if missing or unread else COMPLETE
    first = next((f.message for f in report.findings if f.is_blamed), "")
    reason = first or "; ".join(
        [*unread, *(f"{out.space}: {out.what}: {out.reason}" for out in missing)]
    )
    reason = reason or "; ".join(note.message for note in report.notes if note.function == "plan")
    names, facts = order.outputs, describe_scene(solution, report, look)
    count = len(solution.pieces)
    return ResultRow(source, status, 0.0, count, len(missing), broken, reason, names, facts)
