"""Who else may come: people with a link each, what they may do, and what they marked.

All is in the project file, to which is only added: a link is kept as its hash, so whoever reads the
file gets in nowhere by it; a new link for a person makes the one before useless. Marks of many
people at once are written together: each is on disk when :meth:`People.keep` returns.
"""

from __future__ import annotations

import hashlib
import json
import secrets
import sqlite3
from contextvars import ContextVar
from threading import Event, Lock
from typing import Any, NamedTuple

from scenewright.core.errors import InputError
from scenewright.workflow.evolution.raters import Mark
from scenewright.workflow.project import path_of, saved

VIEW, RATE, EDIT, OWN = RIGHTS = ("view", "rate", "edit", "own")
"""What a person may do, each with what those before it may."""
MOST = 1000
"""People of a project."""
AUTHOR: ContextVar[str] = ContextVar("AUTHOR", default="")
"""The name of whoever asks for the verb being done."""
TABLES = """
CREATE TABLE IF NOT EXISTS person (
    id INTEGER PRIMARY KEY, name TEXT NOT NULL, may TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS link (
    id INTEGER PRIMARY KEY, person INTEGER NOT NULL, seal TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS pool (id INTEGER PRIMARY KEY, brief TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS mark (
    id INTEGER PRIMARY KEY, pool INTEGER NOT NULL, person TEXT NOT NULL, kind TEXT NOT NULL,
    body TEXT NOT NULL);
"""


Row = tuple[int, str, str, str]


class Person(NamedTuple):
    """Someone with a link: a number, a name and what she may do."""

    id: int
    name: str
    right: str


OWNER = Person(0, "", OWN)
"""Whoever started the studio."""


def may(right: str, needed: str) -> bool:
    """Whether someone of a right may do what needs another.

    >>> may("edit", "rate"), may("view", "rate")
    (True, False)
    """
    return RIGHTS.index(right) >= RIGHTS.index(needed)


class People:
    """The people of a project; usable from any thread."""

    def __init__(self, db: sqlite3.Connection) -> None:
        path = path_of(db)
        self._db = _connect(str(path)) if path else db
        self._own = path is not None
        self._db.executescript(TABLES)
        self._lock, self._writing = Lock(), Lock()
        self._waiting: list[tuple[Row, Event]] = []
        self._people: dict[int, Person] = {}
        self._seals: dict[str, int] = {}
        for row in self._db.execute("SELECT id, name, may FROM person"):
            self._people[row[0]] = Person(*row)
        for person, seal in self._db.execute("SELECT person, seal FROM link ORDER BY id"):
            self._set(person, seal)

    def invite(self, name: str, right: str) -> str:
        """The token of a link for a new person."""
        if right not in (VIEW, RATE, EDIT):
            raise InputError(f"{right!r} is no right", "use view, rate or edit")
        plain = " ".join(name.split())[:60]
        if not plain or len(self._people) >= MOST:
            raise InputError("a person has a name", f"give one; {MOST} people at most")
        with self._writing:
            row = self._db.execute("INSERT INTO person (name, may) VALUES (?, ?)", (plain, right))
            number = int(row.lastrowid or 0)
            self._people[number] = Person(number, plain, right)
        return self.renew(number)

    def renew(self, number: int) -> str:
        """The token of another link for a person; the one before lets nobody in any more."""
        token = secrets.token_urlsafe(18)
        self._link(number, seal_of(token))
        return token

    def drop(self, number: int) -> None:
        """Let a person in no more; her marks stay."""
        self._link(number, "")

    def find(self, token: str) -> Person | None:
        """Whose a token is."""
        return self._people.get(self._seals.get(seal_of(token), 0))

    def all(self) -> list[Person]:
        """Those who have a link."""
        linked = {*self._seals.values()}
        return [one for number, one in sorted(self._people.items()) if number in linked]

    def name_of(self, number: str) -> str:
        """The name of a person by number, also of one who has no link any more."""
        known = self._people.get(int(number)) if number.isdecimal() else None
        return known.name if known else number

    def begin_pool(self, brief: str) -> int:
        """The number of the pool of a brief, begun if it is not the last one."""
        last = self.last_pool()
        if last is not None and last[1] == brief:
            return last[0]
        with self._writing:
            row = self._db.execute("INSERT INTO pool (brief) VALUES (?)", (brief,))
        return int(row.lastrowid or 0)

    def last_pool(self) -> tuple[int, str] | None:
        """Number and brief of the pool that is rated now."""
        found = self._db.execute("SELECT id, brief FROM pool ORDER BY id DESC LIMIT 1").fetchone()
        return (int(found[0]), str(found[1])) if found else None

    def marks(self, pool: int) -> list[Mark]:
        """All marks of a pool in order."""
        query = "SELECT person, kind, body FROM mark WHERE pool = ? ORDER BY id"
        rows = self._db.execute(query, (pool,)).fetchall()
        return [Mark(person, kind, json.loads(body)) for person, kind, body in rows]

    def keep(self, pool: int, person: str, kind: str, body: dict[str, Any]) -> None:
        """Keep a mark: it is on disk when this returns. Whoever gets to write writes what the
        others wait for as well."""
        row, done = (pool, person, kind, json.dumps(body)), Event()
        with self._lock:
            self._waiting.append((row, done))
        with self._writing:
            with self._lock:
                waiting, self._waiting = self._waiting, []
            if waiting:
                self._write([one for one, _ in waiting])
            for _, written in waiting:
                written.set()
        if not done.is_set():
            raise InputError("the mark could not be kept", "say it again", file="the project")

    def close(self) -> None:
        """Close the file."""
        if self._own:
            self._db.close()

    def _write(self, rows: list[Row]) -> None:
        with saved(self._db):
            self._db.executemany(
                "INSERT INTO mark (pool, person, kind, body) VALUES (?, ?, ?, ?)", rows
            )

    def _link(self, number: int, seal: str) -> None:
        if number not in self._people:
            raise InputError(f"there is no person {number}", "choose one of the list")
        with self._writing:
            self._db.execute("INSERT INTO link (person, seal) VALUES (?, ?)", (number, seal))
            self._set(number, seal)

    def _set(self, number: int, seal: str) -> None:
        self._seals = {key: one for key, one in self._seals.items() if one != number}
        if seal:
            self._seals[seal] = number


def seal_of(token: str) -> str:
    """What is kept of a token.

    >>> seal_of("a") == seal_of("a") != seal_of("b")
    True
    """
    return hashlib.sha256(token.encode()).hexdigest()


def _connect(path: str) -> sqlite3.Connection:
    db = sqlite3.connect(path, timeout=20.0, check_same_thread=False, isolation_level=None)
    db.execute("PRAGMA synchronous=FULL")
    return db
