"""Damage to files, drawn by a seed: cut off, turned over, of another type, too deep, too large.

Each function takes sound content and a :class:`random.Random` and gives damaged content. Nothing
here knows what it damages but for its container: bytes, text, JSON, a zip archive, arrays, a
database.
"""

from __future__ import annotations

import copy
import io
import json
import random
import sqlite3
import struct
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

Draw = random.Random
Damage = Callable[[bytes, Draw], bytes]
NUMBERS: tuple[Any, ...] = (
    0, -1, 1e-300, 1e9, -1e17, 1e308, 10**400, 2**63, -(2**31), 0.5, float("nan"), float("inf"),
)  # fmt: skip
ODD: tuple[Any, ...] = (
    None, True, False, "", "x" * 100_000, "../../../etc/passwd", "a\x00b\x1b[31m\nline", "\ud800",
    "𝔘\u202e", [], {}, [[]], [None] * 9, {"": {}}, "NaN", "1e999", "<!ENTITY x>",
    "sample:home-flat",
    ["/dev/zero"], {"path": "/dev/zero"}, [[[[0]]]],
)  # fmt: skip
RUBBISH = (
    b"", b"\x00", b"\x00" * 4096, b"PK\x03\x04", b"SQLite format 3\x00", b"\x80\x04N.", b"glTF",
    b"{}", b"[]", b"null", b"[" * 200_000, b'{"a":' * 100_000, b"<a>" * 50_000,
    b"\xff\xfe[\x00]\x00",
    b"%PDF-1.7", b"1" * 400_000, b'"' + b"\\" * 9999,
)  # fmt: skip
"""Content of no format, or of another one."""
BOMB = 300_000_000
"""Bytes a packed bomb unpacks to."""


def damage_bytes(data: bytes, draw: Draw) -> bytes:
    """Cut off, bits turned over, rubbish put in, a part doubled, zeroed or left out."""
    kind, changed = draw.randrange(7), bytearray(data or b"\x00")
    at = draw.randrange(len(changed))
    if kind == 0:
        return bytes(changed[:at])
    if kind == 1:
        for _ in range(draw.randint(1, 40)):
            changed[draw.randrange(len(changed))] ^= 1 << draw.randrange(8)
    elif kind == 2:
        changed[at:at] = draw.randbytes(draw.randint(1, 3000))
    elif kind == 3:
        changed += changed[at:]
    elif kind == 4:
        end = min(at + draw.randint(1, 4096), len(changed))
        changed[at:end] = bytes(end - at)
    elif kind == 5:
        del changed[at : at + draw.randint(1, 4096)]
    else:
        return draw.choice(RUBBISH)
    return bytes(changed)


def damage_text(data: bytes, draw: Draw) -> bytes:
    """Numbers and names exchanged, NUL bytes, another coding; or bytes damaged."""
    if draw.random() < 0.3:
        return damage_bytes(data, draw)
    text = data.decode("utf-8", "replace") or " "
    digits = [k for k, letter in enumerate(text) if letter.isdigit()]
    words = ("nan", "inf", "-1", "1e999", "1e38", "0", "x", "", "9" * 400, "../../x", "\x00", '"')
    for _ in range(draw.randint(1, 5)):
        at = draw.choice(digits) if digits and draw.random() < 0.7 else draw.randrange(len(text))
        text = text[:at] + draw.choice(words) + text[at + 1 :]
    coding = draw.choice(("utf-8", "utf-8", "utf-8", "utf-16", "utf-8-sig", "latin-1"))
    return text.encode(coding, "replace")


def damage_json(data: bytes, draw: Draw) -> bytes:
    """One to three values of a document exchanged, removed, repeated or nested; or text damaged."""
    try:
        document = json.loads(data) if draw.random() < 0.75 else None
    except ValueError:
        document = None
    if document is None:
        return damage_text(data, draw)
    return damage_value(document, draw).encode("utf-8", "surrogatepass")


def damage_value(document: Any, draw: Draw) -> str:
    """The text of a plain value with one to three things in it exchanged."""
    changed = copy.deepcopy(document)
    for _ in range(draw.randint(1, 3)):
        places = list_places(changed)
        if places:
            value, key = draw.choice(places)
            _change(value, key, draw)
    return json.dumps(changed)


def list_places(value: Any) -> list[tuple[Any, Any]]:
    """Every value below a document, as the list or object it is in and its index or key."""
    found, waiting = [], [value]
    while waiting:
        inside = waiting.pop()
        if isinstance(inside, dict | list):
            for key in inside if isinstance(inside, dict) else range(len(inside)):
                found.append((inside, key))
                waiting.append(inside[key])
    return found


def _change(value: Any, key: Any, draw: Draw) -> None:
    """Exchange one value of a list or object in place."""
    kind, old = draw.randrange(8), value[key]
    if kind == 0:
        del value[key]
    elif kind == 1 and isinstance(old, list) and old:
        times = draw.choice((1, 2, 200))
        old.extend(copy.deepcopy(draw.choice(old)) for _ in range(times if len(old) < 999 else 1))
    elif kind == 2 and isinstance(old, list):
        draw.shuffle(old)
    elif kind == 3:
        inside: Any = 1
        for _ in range(draw.choice((3, 60, 400))):
            inside = [inside] if draw.random() < 0.5 else {"a": inside}
        value[key] = inside
    elif kind == 4 and isinstance(value, dict):
        value[draw.choice(("__proto__", "", "a" * 5000, "walls"))] = draw.choice(ODD)
    elif kind == 5 and isinstance(old, int | float):
        value[key] = old * draw.choice((100, 0.01, -1, 1e6))
    else:
        value[key] = draw.choice(NUMBERS if isinstance(old, int | float) else ODD)


def zipped(entries: dict[str, bytes]) -> bytes:
    """A zip archive of some entries."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries.items():
            archive.writestr(name, content)
    return stream.getvalue()


def damage_zip(inner: Damage) -> Damage:
    """An entry damaged by ``inner``, missing, called otherwise, a bomb; or the archive itself."""

    def damage(data: bytes, draw: Draw) -> bytes:
        if draw.random() < 0.3:
            return damage_bytes(data, draw)
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            entries = {name: archive.read(name) for name in archive.namelist()}
        name, kind = draw.choice(sorted(entries)), draw.randrange(10)
        if kind == 0:
            del entries[name]
        elif kind == 1:
            entries[draw.choice(("../../x", "/etc/x", " ", "a\x00b"))] = entries.pop(name)
        elif kind == 2:
            entries[name] = bytes(BOMB)
        elif kind == 3:
            return _lie_about_size(data, draw)
        else:
            entries[name] = inner(entries[name], draw)
        return zipped(entries)

    return damage


def _lie_about_size(data: bytes, draw: Draw) -> bytes:
    """An archive whose directory states other sizes, methods or flags of an entry."""
    changed, at = bytearray(data), data.rfind(b"PK\x01\x02")
    field, form, values = draw.choice(
        ((24, "<I", (0, 2**32 - 2, 10**9)), (10, "<H", (99, 12, 14)), (8, "<H", (1, 2**11)))
    )
    struct.pack_into(form, changed, at + field, draw.choice(values))
    return bytes(changed)


def damage_arrays(data: bytes, draw: Draw) -> bytes:
    """An array of another type, shape or content, pickled, of a vast shape, missing; or its
    archive damaged."""
    if draw.random() < 0.25:
        return damage_zip(damage_bytes)(data, draw)
    with np.load(io.BytesIO(data), allow_pickle=False) as file:
        arrays: dict[str, Any] = {name: file[name] for name in file.files}
    for _ in range(draw.randint(1, 2)):
        name = draw.choice(sorted(arrays))
        if name == "card" and draw.random() < 0.7:
            text = damage_json(arrays[name].tobytes(), draw)
            arrays[name] = np.frombuffer(text, np.uint8)
        else:
            arrays[name] = _damage_array(arrays[name], draw)
        if arrays[name] is None:
            del arrays[name]
    stream = io.BytesIO()
    np.savez(stream, **arrays)
    return _vast_shape(stream.getvalue(), draw) if draw.random() < 0.15 else stream.getvalue()


def _damage_array(value: Any, draw: Draw) -> Any:
    kinds: tuple[Callable[[], Any], ...] = (
        lambda: None,
        lambda: np.asarray(value, object),
        lambda: np.array(["a" * 99] * 3),
        lambda: np.asarray(value).astype("c16"),
        lambda: np.asarray(value).astype("i1", casting="unsafe"),
        lambda: np.asarray(value, "f8") * draw.choice((0, -1, 1e300, np.nan, np.inf)),
        lambda: np.asarray(value).ravel()[: draw.randrange(9)],
        lambda: np.zeros(draw.choice(((0,), (3, 0), (1,) * 30, (2000, 2000), ()))),
        lambda: np.zeros(3, [("a", "f8"), ("b", "O")]),
        lambda: np.zeros(3, "M8[s]"),
        lambda: draw.random(),
    )  # fmt: skip
    with np.errstate(all="ignore"):
        try:
            return draw.choice(kinds)()
        except (ValueError, TypeError):  # what was damaged before may be no numbers
            return None


def _vast_shape(data: bytes, draw: Draw) -> bytes:
    """An archive in which the header of one array states a vast, odd or unreadable shape."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        entries = {name: archive.read(name) for name in archive.namelist()}
    name = draw.choice(sorted(entries))
    shape = draw.choice(
        ("(1000000000000,)", "(-1,)", "(2147483648, 2147483648)", "[3]", "x", "(1e9,)")
    )
    header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    body = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + bytes(64)
    return zipped(entries | {name: body})


def damage_database(data: bytes, draw: Draw, path: Path) -> bytes:
    """A database with a value exchanged, a row or table missing, something added that runs, or its
    bytes damaged; ``path`` is where it may be written meanwhile."""
    if draw.random() < 0.35:
        return damage_bytes(data, draw)
    path.write_bytes(data)
    base = sqlite3.connect(path)
    try:
        draw.choice((_change_cell, _change_cell, _change_cell, _change_cell, _change_tables))(
            base, draw
        )
        base.commit()
        base.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        base.execute("PRAGMA journal_mode=DELETE")
    except (sqlite3.Error, OverflowError):
        base.rollback()
    finally:
        base.close()
    return path.read_bytes()


def _change_cell(base: sqlite3.Connection, draw: Draw) -> None:
    tables = [row[0] for row in base.execute("SELECT name FROM sqlite_master WHERE type='table'")]
    table = draw.choice(sorted(tables))
    columns = [row[1] for row in base.execute(f'PRAGMA table_info("{table}")')]
    rows = base.execute(f'SELECT rowid, * FROM "{table}" ORDER BY rowid').fetchall()
    if not rows:
        return
    row, k = draw.choice(rows), draw.randrange(len(columns))
    value = _changed_cell(row[1 + k], draw)
    base.execute(f'UPDATE "{table}" SET "{columns[k]}" = ? WHERE rowid = ?', (value, row[0]))


def _changed_cell(value: Any, draw: Draw) -> Any:
    if isinstance(value, bytes):
        bombs = (zlib.compress(bytes(BOMB)), damage_bytes(value, draw), "text", 7)
        return _damage_packed(value, draw) if draw.random() < 0.6 else draw.choice(bombs)
    if isinstance(value, str) and value[:1] in "[{" and draw.random() < 0.8:
        return damage_json(value.encode(), draw).decode("utf-8", "replace")
    return draw.choice((-1, 10**9, "x", "", "9" * 30, "\x00", b"\xff", 1.5, "{}", "[]", "3:a;b"))


def _damage_packed(value: bytes, draw: Draw) -> bytes:
    """Packed JSON damaged within; bytes of another kind as they are."""
    try:
        return zlib.compress(damage_json(zlib.decompress(value), draw))
    except zlib.error:
        return damage_bytes(value, draw)


def _change_tables(base: sqlite3.Connection, draw: Draw) -> None:
    tables = sorted(r[0] for r in base.execute("SELECT name FROM sqlite_master WHERE type='table'"))
    table = draw.choice(tables)
    endless = (
        "WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) SELECT x, x, x FROM c"
    )
    base.execute(
        draw.choice(
            (
                f"DROP TABLE {table}",
                f"DELETE FROM {table}",
                f"ALTER TABLE {table} ADD COLUMN more TEXT",
                f"CREATE TRIGGER t AFTER UPDATE ON {table} BEGIN DELETE FROM {table}; END",
                f"CREATE VIEW v AS {endless}",
                "CREATE TABLE mine (id INTEGER)",
                "PRAGMA application_id=99",
                "PRAGMA user_version=99",
                "PRAGMA encoding='UTF-16'",
            )
        )
    )
