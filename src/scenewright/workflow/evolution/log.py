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
from typing import Any, NamedTuple

from scenewright.core.errors import InputError

FORM = 1
"""The form of the file; raised when one that was written before cannot be read any more."""
_TABLES = """
CREATE TABLE IF NOT EXISTS about (name TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS entry (
  number INTEGER PRIMARY KEY, kind TEXT NOT NULL, body TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS bred (
  number INTEGER PRIMARY KEY, epoch TEXT NOT NULL, body TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS solution (number INTEGER PRIMARY KEY, document BLOB NOT NULL);
"""


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
    """A log on disk, or in memory if ``path`` is empty."""

    def __init__(self, path: str | os.PathLike[str] = "") -> None:
        self.path = str(path)
        with self._report_faults():
            if self.path:
                Path(self.path).parent.mkdir(parents=True, exist_ok=True)
            self._base = sqlite3.connect(self.path or ":memory:", timeout=10.0)
            self._base.execute("PRAGMA journal_mode=WAL")
            self._base.execute("PRAGMA synchronous=FULL")
            self._base.executescript(_TABLES)
        form = self.about().get("form")
        if form not in (None, str(FORM)):
            raise InputError(
                f"is the log of another version (form {form})", "start a new one", file=self.path
            )

    def about(self) -> dict[str, str]:
        """What the evolution is of: brief, seed, source."""
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
            return [Entry(number, kind, json.loads(body)) for number, kind, body in rows]

    def read_candidates(self) -> list[tuple[int, str, dict[str, Any]]]:
        """All candidates in order."""
        with self._report_faults():
            rows = self._base.execute("SELECT number, epoch, body FROM bred ORDER BY number")
            return [(number, epoch, json.loads(body)) for number, epoch, body in rows]

    def solution(self, number: int) -> str | None:
        """The document of a candidate's solution, if it was added."""
        with self._report_faults():
            found = self._base.execute(
                "SELECT document FROM solution WHERE number = ?", (number,)
            ).fetchone()
        return zlib.decompress(found[0]).decode() if found else None

    def close(self) -> None:
        """Close the file; nothing can be added any more."""
        self._base.close()

    @contextmanager
    def _report_faults(self) -> Iterator[None]:
        """What SQLite or the system refuses, as one InputError that names the file."""
        try:
            yield
        except sqlite3.IntegrityError:
            raise InputError(
                "is being written by another run", "close that one first", file=self.path
            ) from None
        except (sqlite3.Error, OSError, zlib.error, ValueError) as error:
            raise InputError(
                f"is not a log that can be used: {error}", "choose another name", file=self.path
            ) from None
