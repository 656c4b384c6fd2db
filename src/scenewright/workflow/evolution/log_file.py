"""Whether a file is the log of an evolution: looked at read-only, before it is opened to write.

A log is an SQLite database marked by its ``application_id``. One without the mark may have been
written before there was one: it must hold exactly the tables of a log. A database of another
program is never opened to be written, and nothing is left beside it.
"""

from __future__ import annotations

import sqlite3
import time
from pathlib import Path
from urllib.parse import quote

from scenewright.core.atomic_file import DATABASE
from scenewright.core.errors import InputError
from scenewright.core.stored_file import MEBIBYTE, check_plain

MARK = int.from_bytes(b"SCEV", "big")
"""The ``application_id`` of a log."""
LARGEST = 512 * MEBIBYTE
"""Bytes of a log at most."""
PATIENCE = 20.0
"""Processor seconds that looking at a log may take."""
STEPS = 100_000
"""Steps of SQLite's machine between looks at the time."""
TABLES = (
    "CREATE TABLE about (name TEXT PRIMARY KEY, value TEXT NOT NULL)",
    "CREATE TABLE entry (number INTEGER PRIMARY KEY, kind TEXT NOT NULL, body TEXT NOT NULL)",
    "CREATE TABLE bred (number INTEGER PRIMARY KEY, epoch TEXT NOT NULL, body TEXT NOT NULL)",
    "CREATE TABLE solution (number INTEGER PRIMARY KEY, document BLOB NOT NULL)",
)
MOST_TEXT = {"about": 64 * MEBIBYTE, "entry": 64 * MEBIBYTE, "bred": 128 * MEBIBYTE}
"""Bytes all values of a table may hold."""
MOST_ROWS = 1_000_000
VALUES = {"about": ("name", "value"), "entry": ("kind", "body"), "bred": ("epoch", "body")}
"""The columns of text of each table."""


def check_log(path: Path) -> None:
    """InputError, and nothing changed, unless a file that is not empty is a log that can be used:
    of this program, of a form and a size that can be read, whole."""
    check_plain(path, LARGEST)
    with path.open("rb") as file:
        head = file.read(100)
    if not head.startswith(DATABASE) or len(head) < 100:
        raise InputError("is not a log that can be used: no database", "choose another name")
    mark = int.from_bytes(head[68:72], "big")
    if mark not in (0, MARK):
        raise InputError("is a database of another program", "choose another name")
    page, pages = int.from_bytes(head[16:18], "big"), int.from_bytes(head[28:32], "big")
    whole = path.stat().st_size >= pages * (page if page > 1 else 2**16)
    if not whole and not has_writings(path):
        raise InputError("is damaged: it was cut off", "start a new one")
    base = _open_readonly(path)
    try:
        check_content(base)
    finally:
        base.close()


def has_writings(path: Path) -> bool:
    """Whether what was written last to a database lies beside it, in SQLite's write-ahead log."""
    return path.with_name(path.name + "-wal").exists()


def _open_readonly(path: Path) -> sqlite3.Connection:
    """A connection that writes nothing; where no other file belongs to the database, none appears
    beside it either."""
    mode = "mode=ro" if has_writings(path) else "mode=ro&immutable=1"
    return bound(sqlite3.connect(f"file:{quote(str(path.absolute()))}?{mode}", uri=True))


def bound(base: sqlite3.Connection) -> sqlite3.Connection:
    """A connection that runs nothing a file brings with it, and gives up what takes too long."""
    end = time.process_time() + PATIENCE
    base.set_progress_handler(lambda: int(time.process_time() > end), STEPS)
    base.execute("PRAGMA trusted_schema=OFF")
    return base


def check_content(base: sqlite3.Connection) -> None:
    """InputError or an SQLite error unless a database holds a log's tables and nothing else, its
    pages are whole, and its values are texts that can be held."""
    rows = base.execute("SELECT sql FROM sqlite_master WHERE sql IS NOT NULL").fetchall()
    stated = sorted(" ".join(str(row[0]).split()) for row in rows)
    if stated != sorted(TABLES):
        raise InputError("is a database, but not the log of an evolution", "choose another name")
    found = base.execute("PRAGMA quick_check(1)").fetchone()
    if found is None or found[0] != "ok":
        raise InputError("is damaged", "start a new one")
    for table, columns in VALUES.items():
        _check_values(base, table, columns)
    (odd,) = base.execute("SELECT count(*) FROM solution WHERE typeof(document) <> 'blob'")
    if odd[0]:
        raise InputError("is damaged: a solution is no document", "start a new one")


def _check_values(base: sqlite3.Connection, table: str, columns: tuple[str, ...]) -> None:
    odd = " OR ".join(f"typeof({column}) <> 'text'" for column in columns)
    size = " + ".join(f"length(CAST({column} AS BLOB))" for column in columns)
    query = f"SELECT count(*), total({odd}), total({size}) FROM {table}"
    count, wrong, held = base.execute(query).fetchone()
    if wrong:
        raise InputError(f"is damaged: a value of '{table}' is no text", "start a new one")
    if count > MOST_ROWS or held > MOST_TEXT[table]:
        raise InputError(f"holds more in '{table}' than can be read", "start a new one")
