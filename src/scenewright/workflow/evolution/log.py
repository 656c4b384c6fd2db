"""The log of an evolution: an SQLite file to which is only added, so that nothing said is lost.

Every event is on disk before :meth:`EvolutionLog.append` returns; SQLite's write-ahead log keeps
what was committed whatever kills the process. An entry is an event, a screen shown, or generations
that were bred without asking.
"""

from __future__ import annotations

import json
import os
import sqlite3
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import RLock
from typing import Any, NamedTuple

from scenewright.core.atomic_file import bring_to_disk, check_targets, note_read
from scenewright.core.errors import InputError
from scenewright.core.stored_file import report_damage
from scenewright.workflow.evolution.log_file import MARK, TABLES, bound, check_content, check_log
from scenewright.workflow.evolution.log_records import (
    check_order,
    read_body,
    read_bred,
    unpack_document,
)

FORM = 1
"""The form of the file; raised when one that was written before cannot be read any more."""


class Entry(NamedTuple):
    """One line of the log: its number from 0, what kind it is, and what it says."""

    number: int
    kind: str
    body: dict[str, Any]


class NewCandidates(NamedTuple):
    """Candidates to be written down: number, epoch and what each is made of; and the documents of
    whole solutions by number."""

    rows: tuple[tuple[int, str, dict[str, Any]], ...] = ()
    documents: tuple[tuple[int, str], ...] = ()


NONE_NEW = NewCandidates()


class EvolutionLog:
    """A log on disk, or in memory if ``path`` is empty. A file that is there must be a log, or
    empty; it is looked at read-only before it is opened to be written. It may be used from any
    thread, one at a time."""

    def __init__(self, path: str | os.PathLike[str] = "") -> None:
        self.path, self._lock = str(path), RLock()
        with self._report_faults():
            self._base = _open(Path(self.path)) if self.path else _connect(":memory:")
            if not self.path:
                _create(self._base)
            self._base.execute("PRAGMA synchronous=FULL")
        form = self.about().get("form")
        if form not in (None, str(FORM)):
            self.close()
            raise InputError(
                f"is the log of another version (form {form[:20]})",
                "start a new one",
                file=self.path,
            )

    def about(self) -> dict[str, str]:
        """The subject of the evolution: brief, seed, source."""
        with self._report_faults():
            return dict(self._base.execute("SELECT name, value FROM about").fetchall())

    def begin(self, about: dict[str, str]) -> None:
        """Say what the evolution is of; only once."""
        rows = [*about.items(), ("form", str(FORM))]
        with self._report_faults(), self._base:
            self._base.executemany("INSERT INTO about VALUES (?, ?)", rows)

    def append(
        self, number: int, kind: str, body: dict[str, Any], found: NewCandidates = NONE_NEW
    ) -> None:
        """Add an entry, with the candidates it is about, all or nothing; it is on disk when this
        returns. InputError if another run has added one of this number."""
        made = [(number, epoch, json.dumps(record)) for number, epoch, record in found.rows]
        whole = [(n, zlib.compress(text.encode(), 6)) for n, text in found.documents]
        with self._report_faults(), self._base:
            text = json.dumps(body, sort_keys=True)
            self._base.execute("INSERT INTO entry VALUES (?, ?, ?)", (number, kind, text))
            self._base.executemany("INSERT INTO bred VALUES (?, ?, ?)", made)
            self._base.executemany("INSERT OR IGNORE INTO solution VALUES (?, ?)", whole)

    def entries(self) -> list[Entry]:
        """All entries in order."""
        with self._report_faults():
            rows = self._base.execute("SELECT number, kind, body FROM entry ORDER BY number")
            found = [Entry(number, kind, read_body(kind, body)) for number, kind, body in rows]
            check_order([entry.number for entry in found], "entries")
            return found

    def read_candidates(self) -> list[tuple[int, str, dict[str, Any]]]:
        """All candidates in order."""
        with self._report_faults():
            rows = self._base.execute("SELECT number, epoch, body FROM bred ORDER BY number")
            found = [(number, epoch, read_bred(body)) for number, epoch, body in rows]
            check_order([number for number, _, _ in found], "candidates")
            return found

    def solution(self, number: int) -> str | None:
        """The document of a candidate's solution, if it was added."""
        with self._report_faults():
            found = self._base.execute(
                "SELECT document FROM solution WHERE number = ?", (number,)
            ).fetchone()
            return unpack_document(found[0]) if found else None

    def close(self) -> None:
        """Close the file; nothing can be added any more."""
        self._base.close()

    @contextmanager
    def _report_faults(self) -> Iterator[None]:
        """Whatever SQLite, the system or damaged content leads to, as one InputError that names
        the file."""
        with self._lock, report_damage(self.path, "a log that can be used", "choose another name"):
            try:
                yield
            except sqlite3.IntegrityError:
                raise InputError(
                    "is being written by another run", "close that one first"
                ) from None


def _open(path: Path) -> sqlite3.Connection:
    """The database of a log that was checked, or of a new one."""
    if path.exists() and path.stat().st_size:
        check_log(path)
        base = _connect(path)
        check_content(base)
        base.execute(f"PRAGMA application_id={MARK}")
    else:
        check_targets([path])
        path.parent.mkdir(parents=True, exist_ok=True)
        base = _connect(path)
        _create(base)
        bring_to_disk(path.parent)
    base.execute("PRAGMA journal_mode=WAL")
    base.set_progress_handler(None, 0)
    note_read(path)
    return base


def _connect(path: Path | str) -> sqlite3.Connection:
    return bound(sqlite3.connect(path, timeout=10.0, check_same_thread=False))


def _create(base: sqlite3.Connection) -> None:
    """Make the tables of a log, all or none, unless another run just has."""
    base.execute("BEGIN IMMEDIATE")
    (there,) = base.execute("SELECT count(*) FROM sqlite_master").fetchone()
    if not there:
        base.execute(f"PRAGMA application_id={MARK}")
        for table in TABLES:
            base.execute(table)
    base.execute("COMMIT")
