"""A project file: every version of a scene, one after another, in SQLite.

Append-only: a verb adds a version below the one it changed, and undo, redo and going back only
add to the list of versions shown. With a write-ahead log and full synchronisation
what was acknowledged survives a kill at any moment.
"""

from __future__ import annotations

import sqlite3
import time
import zlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from scenewright.core.errors import InputError

MARK = 0x5CE9E
"""``application_id`` of our project files."""
SUFFIX = ".studio"
TABLES = """
CREATE TABLE IF NOT EXISTS version (
    id INTEGER PRIMARY KEY, parent INTEGER, what TEXT NOT NULL, solution BLOB NOT NULL);
CREATE TABLE IF NOT EXISTS shown (id INTEGER PRIMARY KEY, version INTEGER NOT NULL);
CREATE TABLE IF NOT EXISTS act (
    version INTEGER PRIMARY KEY, at REAL NOT NULL, who TEXT NOT NULL, edit TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS entry (
    id INTEGER PRIMARY KEY, version INTEGER NOT NULL, at REAL NOT NULL, who TEXT NOT NULL,
    kind TEXT NOT NULL, body TEXT NOT NULL);
"""
REPORT, WHY, MARK_MADE = "report", "why", "mark"
"""Kinds of entries: what the referee says of a version, why each piece changed, what a person
thinks of it."""


class Version(NamedTuple):
    """A version of the scene: the one it was made from (0: none), and what was done."""

    id: int
    parent: int
    what: str


class Act(NamedTuple):
    """How a version came about: seconds since 1970, who made it, and the edit asked for, as JSON
    (empty: none)."""

    version: int
    at: float
    who: str
    edit: str


class Entry(NamedTuple):
    """What is said of a version, as JSON: seconds since 1970, by whom, of which kind."""

    version: int
    at: float
    who: str
    kind: str
    body: str


def open_project(path: Path) -> sqlite3.Connection:
    """The project in a file, begun if there is none. InputError for a file that is none.

    >>> open_project(Path(":memory:")).execute("SELECT count(*) FROM version").fetchone()
    (0,)
    """
    db = sqlite3.connect(path, check_same_thread=False, isolation_level=None)
    try:
        _check_mark(db)
        db.execute("PRAGMA journal_mode=WAL")
        db.execute("PRAGMA synchronous=FULL")
        db.executescript(TABLES)
    except sqlite3.Error as error:
        db.close()
        raise InputError(
            f"is not a project of the studio: {error}", "choose another name", file=str(path)
        ) from None
    return db


def path_of(db: sqlite3.Connection) -> Path | None:
    """The file of a project; none for one in memory.

    >>> path_of(open_project(Path(":memory:")))
    """
    name = db.execute("PRAGMA database_list").fetchone()[2]
    return Path(name) if name else None


def _check_mark(db: sqlite3.Connection) -> None:
    (mark,), (tables,) = (
        db.execute(text).fetchone()
        for text in ("PRAGMA application_id", "SELECT count(*) FROM sqlite_master")
    )
    if tables and mark != MARK:
        raise sqlite3.DatabaseError("it is a database of another program")
    db.execute(f"PRAGMA application_id={MARK}")


@contextmanager
def saved(db: sqlite3.Connection) -> Iterator[None]:
    """All that is written inside, or nothing."""
    db.execute("BEGIN IMMEDIATE")
    try:
        yield
    except BaseException:
        db.execute("ROLLBACK")
        raise
    db.execute("COMMIT")


def add_version(
    db: sqlite3.Connection,
    parent: int,
    what: str,
    solution: str,
    *,
    who: str = "",
    edit: str = "",
    entries: Mapping[str, str] = MappingProxyType({}),
) -> int:
    """Add a version made from ``parent`` and show it; its number. ``who`` made it, the ``edit``
    that was asked for, and ``entries`` by kind, as JSON, are kept beside it with the time.

    >>> db = open_project(Path(":memory:"))
    >>> add_version(db, 0, "arranged", "{}"), shown_version(db), solution_text(db, 1)
    (1, Version(id=1, parent=0, what='arranged'), '{}')
    """
    with saved(db):
        packed = zlib.compress(solution.encode(), 6)
        row = db.execute(
            "INSERT INTO version (parent, what, solution) VALUES (?, ?, ?)", (parent, what, packed)
        )
        number = int(row.lastrowid or 0)
        now = time.time()
        db.execute("INSERT INTO act VALUES (?, ?, ?, ?)", (number, now, who, edit))
        for kind, body in entries.items():
            _add_entry(db, Entry(number, now, who, kind, body))
        db.execute("INSERT INTO shown (version) VALUES (?)", (number,))
    return number


def add_entry(db: sqlite3.Connection, version: int, kind: str, body: str, who: str = "") -> None:
    """Say something of a version that is there."""
    with saved(db):
        _add_entry(db, Entry(version, time.time(), who, kind, body))


def _add_entry(db: sqlite3.Connection, entry: Entry) -> None:
    db.execute("INSERT INTO entry (version, at, who, kind, body) VALUES (?, ?, ?, ?, ?)", entry)


def list_entries(db: sqlite3.Connection, kind: str, version: int = 0) -> list[Entry]:
    """What was said of one version, or of all, in that order.

    >>> db = open_project(Path(":memory:"))
    >>> number = add_version(db, 0, "arranged", "{}", who="Ann", entries={"report": "[]"})
    >>> [(entry.who, entry.body) for entry in list_entries(db, "report", number)]
    [('Ann', '[]')]
    """
    rows = db.execute(
        "SELECT version, at, who, kind, body FROM entry WHERE kind = ? AND ? IN (0, version)"
        " ORDER BY id",
        (kind, version),
    )
    return [Entry(*row) for row in rows]


def list_acts(db: sqlite3.Connection) -> list[Act]:
    """When and by whom versions were made, and what was asked for, in that order."""
    return [Act(*row) for row in db.execute("SELECT * FROM act ORDER BY version")]


def show_version(db: sqlite3.Connection, number: int) -> None:
    """Show a version that was there before."""
    with saved(db):
        db.execute("INSERT INTO shown (version) VALUES (?)", (number,))


def shown_version(db: sqlite3.Connection) -> Version | None:
    """The version shown last."""
    row = db.execute(
        "SELECT v.id, v.parent, v.what FROM shown s JOIN version v ON v.id = s.version"
        " ORDER BY s.id DESC LIMIT 1"
    ).fetchone()
    return Version(*row) if row else None


def next_version(db: sqlite3.Connection, number: int) -> int:
    """The version to go to by redo: of those made from this one the one shown last (0: none)."""
    row = db.execute(
        "SELECT v.id FROM version v JOIN shown s ON s.version = v.id WHERE v.parent = ?"
        " ORDER BY s.id DESC LIMIT 1",
        (number,),
    ).fetchone()
    return int(row[0]) if row else 0


def list_versions(db: sqlite3.Connection) -> list[Version]:
    """All versions in the order in which they were made."""
    return [Version(*row) for row in db.execute("SELECT id, parent, what FROM version ORDER BY id")]


def trace(db: sqlite3.Connection, number: int) -> Iterator[int]:
    """The versions that one was made from, the last first."""
    parents = {row.id: row.parent for row in list_versions(db)}
    while number := parents.get(number, 0):
        yield number


def solution_text(db: sqlite3.Connection, number: int) -> str:
    """The JSON text of a version's solution."""
    row = db.execute("SELECT solution FROM version WHERE id = ?", (number,)).fetchone()
    if row is None:
        raise InputError(f"there is no version {number}", "choose one of the history")
    return zlib.decompress(row[0]).decode()
