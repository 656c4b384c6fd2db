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
from tempfile import TemporaryDirectory
from threading import Thread
from typing import Any, NamedTuple, TextIO

from scenewright.batch.jobs import BatchOptions
from scenewright.batch.store import put_results
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
    """What a worker is asked to do: a file, the name and the files of its results, the seed and
    the look; the ``content`` of the file for workers that may not see it."""

    source: str
    name: str
    outputs: tuple[str, ...]
    seed: int = 0
    look: int = 0
    content: bytes | None = None


class Place(NamedTuple):
    """Where results are before they are whole, and the address they are put at then (empty: they
    get the names their order says)."""

    parts: str
    address: str = ""


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
            order = Order(**asked | {"outputs": tuple(asked["outputs"])})
            _answer(answers, do_order(order, options, first["memory"], Place(*first["place"])))


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


def do_order(order: Order, options: BatchOptions, memory: float, place: Place) -> ResultRow:
    """Do one order, wherever: the one function of a batch. Whatever goes wrong becomes its row."""
    begun, source = time.perf_counter(), order.source
    try:
        row = _done(order, options, place)
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


def _done(order: Order, options: BatchOptions, place: Place) -> ResultRow:
    """Arrange one file where it is, or a copy of it; its results appear when all are written."""
    if not place.address and _is_at_hand(order):
        return _arrange(order, options, Path(place.parts))
    with TemporaryDirectory(prefix="scenewright-") as folder:
        source, parts = order.source, Path(place.parts)
        if not _is_at_hand(order):
            source = str(Path(folder, Path(order.source).name))
            Path(source).write_bytes(order.content or b"")
        outputs = order.outputs
        if place.address:
            parts = Path(folder, "made")
            outputs = tuple(str(parts / Path(path).name) for path in order.outputs)
            parts.mkdir()
        try:
            row = _arrange(order._replace(source=source, outputs=outputs), options, parts)
        except InputError as error:
            raise error.located(file=order.source) from None
        if place.address:
            outputs = put_results(place.address, order.name, map(Path, outputs))
        return row._replace(file=order.source, outputs=outputs)


def _is_at_hand(order: Order) -> bool:
    """Whether the file of an order is here as it was where the batch was started."""
    path = Path(order.source)
    return order.content is None or (path.is_file() and path.read_bytes() == order.content)


def _arrange(order: Order, options: BatchOptions, parts: Path) -> ResultRow:
    """Arrange one file of this machine into files of it."""
    from scenewright.batch.manifest import describe_scene, list_files
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
    facts["files"] = list_files(order.name, outputs)
    count = len(solution.pieces)
    return ResultRow(source, status, 0.0, count, len(missing), broken, reason, names, facts)
