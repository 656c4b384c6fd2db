"""The workers of a batch and the threads that feed them: one file at a time, none lost.

A pool of the standard library loses what its dead workers held. Here every worker is a process
of its own with one thread of the parent that hands it a file and waits. A worker that dies is
replaced and its file tried once more; the second time the file is to blame.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Generator, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import suppress
from itertools import islice
from pathlib import Path
from queue import SimpleQueue
from threading import TIMEOUT_MAX, Event, Timer
from types import TracebackType
from typing import Any

from scenewright.batch.jobs import BatchOptions, Job, Limits
from scenewright.batch.table import ResultRow, make_failed_row
from scenewright.batch.worker import READY, Order, Place
from scenewright.core.atomic_file import Identity

START = (
    "import _signal; _signal.signal(_signal.SIGINT, _signal.SIG_IGN); "
    "from scenewright.batch.worker import main; main()"
)
"""The first thing a worker does is not to hear Ctrl-C, which the terminal sends to it as well."""
LIVES = 2
"""How many workers a file may kill before it is called failed."""
STARTS = 3
"""How often a worker is started before it is said that it cannot be."""
LOOK = 0.2
"""Seconds between looks at whether to stop."""
AHEAD = 4
"""Orders waiting for every worker, so that a long list takes no memory."""


class Stopped(Exception):  # noqa: N818 - it is no error
    """The batch was cancelled while a file was being done."""


class Worker:
    """One worker process, started when first needed."""

    def __init__(self, setting: dict[str, Any], stopping: Event) -> None:
        self.setting, self.stopping = setting, stopping
        self._process: subprocess.Popen[bytes] | None = None
        self.at_work: subprocess.Popen[bytes] | None = None

    def ask(self, order: Job, seconds: float) -> tuple[ResultRow | None, str]:
        """The row of an order; without one, why: it took too long, or the worker died."""
        process = self._live_process()
        late = Event()

        def stop() -> None:
            late.set()
            process.kill()

        timer = Timer(min(seconds, TIMEOUT_MAX), stop)
        timer.start()
        self.at_work = process
        try:
            answer = _said(process, order_of(order)._asdict())
        finally:
            self.at_work = None
            timer.cancel()
        if answer is not None:
            row = ResultRow(*answer)
            return row._replace(outputs=tuple(row.outputs)), ""
        code = process.wait()
        self.end()
        return None, "" if late.is_set() else f"signal {-code}" if code < 0 else f"code {code}"

    def end(self) -> None:
        """Stop the process, whatever it is doing."""
        if self._process is not None:
            process, self._process = self._process, None
            process.kill()
            process.wait()
            for pipe in (process.stdin, process.stdout):
                with suppress(OSError):
                    pipe.close()  # type: ignore[union-attr]

    def stop(self) -> None:
        """Stop the process, and leave it to the thread that waits for it."""
        if (process := self._process) is not None:
            process.kill()

    def _live_process(self) -> subprocess.Popen[bytes]:
        for _ in range(STARTS):
            if self._process is not None and self._process.poll() is None:
                return self._process
            self.end()
            with tempfile.TemporaryFile() as said:
                self._process = subprocess.Popen(
                    [sys.executable, "-c", START],
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    stderr=said,
                    env=_environment(),
                )
                if self.stopping.is_set():
                    raise Stopped
                if _said(self._process, self.setting) == READY:
                    return self._process
                self.end()
                said.seek(0)
                lines = said.read().decode("utf-8", "replace").strip().splitlines()
        raise RuntimeError(f"the workers cannot start: {lines[-1] if lines else 'no reason given'}")


def _keep_interrupts_off() -> None:
    """Block Ctrl-C in this thread (only the main one handles it), and so in all it starts."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})


def _said(process: subprocess.Popen[bytes], words: dict[str, Any]) -> Any:
    """The answer of a worker; ``None`` if it is dead."""
    if process.stdin is None or process.stdout is None:
        return None
    try:
        process.stdin.write(json.dumps(words).encode("ascii") + b"\n")
        process.stdin.flush()
        line = process.stdout.readline()
    except OSError:
        return None
    return json.loads(line) if line.endswith(b"\n") else None


def _environment() -> dict[str, str]:
    """That of this process, with the package found as it was found here; numerical libraries are
    kept to one thread, as there is a worker for every core."""
    package = str(Path(__file__).resolve().parents[2])
    paths = [package, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]
    single = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    return {**os.environ, **single, "PYTHONPATH": os.pathsep.join(paths)}


def order_of(job: Job) -> Order:
    """What a worker is asked to do for a job."""
    return Order(job.source, job.name, tuple(map(str, job.outputs)), job.seed, job.look)


class WorkerPool:
    """Workers side by side, each with a thread that feeds it; used as a context."""

    def __init__(
        self,
        count: int,
        limits: Limits,
        options: BatchOptions,
        place: Place,
        protected: Iterable[Identity] = (),
    ) -> None:
        setting = {
            "options": options._asdict(),
            "memory": limits.memory,
            "place": place,
            "protected": sorted(protected),
        }
        self.count, self.limits, self.stopping = count, limits, Event()
        self._workers = [Worker(setting, self.stopping) for _ in range(count)]
        self._idle: SimpleQueue[Worker] = SimpleQueue()
        for worker in self._workers:
            self._idle.put(worker)
        self._threads = ThreadPoolExecutor(count, initializer=_keep_interrupts_off)

    def __enter__(self) -> WorkerPool:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.stop()
        self._threads.shutdown(cancel_futures=True)
        for worker in self._workers:
            worker.end()

    def stop(self) -> None:
        """Stop all workers at once; what they were doing is not done."""
        self.stopping.set()
        for worker in self._workers:
            worker.stop()

    def asking(self) -> list[subprocess.Popen[bytes]]:
        """The processes that are at work on a file."""
        return [worker.at_work for worker in self._workers if worker.at_work is not None]

    def give(self, order: Job) -> Future[tuple[Job, ResultRow]]:
        """Have an order done when a worker is free."""
        return self._threads.submit(self._do, order)

    def _do(self, order: Job) -> tuple[Job, ResultRow]:
        worker = self._idle.get()
        try:
            return order, self._try_job(worker, order)
        finally:
            self._idle.put(worker)

    def _try_job(self, worker: Worker, order: Job) -> ResultRow:
        begun, why = time.perf_counter(), ""
        for _ in range(LIVES):
            if self.stopping.is_set():
                raise Stopped
            row, why = worker.ask(order, self.limits.time)
            if self.stopping.is_set() and row is None:
                raise Stopped
            if row is not None or not why:
                break
        seconds = time.perf_counter() - begun
        if row is not None:
            return row
        if not why:
            text = f"took longer than {self.limits.time:g} s; allow more with --limit"
        else:
            text = f"killed its worker {LIVES} times ({why}); allow more with --memory"
        return make_failed_row(order.source, seconds, f"{order.source}: {text}")


def arrange_with(
    crew: WorkerPool, orders: Sequence[Job], cancel: Callable[[], bool] | None
) -> Generator[tuple[Job, ResultRow], None, None]:
    """Orders with their rows as they are done; ends early when ``cancel`` answers true."""
    waiting = iter(orders)
    running = {crew.give(order) for order in islice(waiting, AHEAD * crew.count)}
    while running:
        done, running = wait(running, LOOK, FIRST_COMPLETED)
        for future in done:
            order, row = future.result()
            running |= {crew.give(order) for order in islice(waiting, 1)}
            yield order, row
        if cancel is not None and cancel():
            crew.stop()
            return
