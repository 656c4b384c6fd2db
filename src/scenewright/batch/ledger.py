"""What is done already: a line of JSON for each finished file, so that a batch can go on.

Results are brought to the disk and appear under their names first; the line, with size and digest
of each, is written after and brought to the disk before anybody is told. So a batch killed between
the two does that file again and writes the same, and a result that was lost, emptied or changed
since is no result. A line that is damaged or was cut off is passed over.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import secrets
import stat
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Annotated, Any, BinaryIO, Literal, NamedTuple

from pydantic import Field, ValidationError

from scenewright.batch.jobs import Job
from scenewright.batch.table import FAILED, ResultRow
from scenewright.core.atomic_file import TEMPORARY, bring_to_disk, note_read
from scenewright.core.brief.fields import StrictModel, Whole
from scenewright.core.errors import InputError

NAME = ".batch.jsonl"
PARTS = re.compile(r"\.scenewright-parts-[0-9a-f]{16}")
"""Name of the folders in which results lie before they are whole."""
FIRST = json.dumps({"format": "scenewright/batch", "version": 2}).encode()
"""The first line of a ledger."""
LONGEST = 4 * 2**20
"""Bytes of a line at most; longer ones are passed over."""
BLOCK = 2**20

Text = Annotated[str, Field(max_length=100_000)]
Count = Annotated[Whole, Field(ge=0, le=10**9)]


class ResultFile(NamedTuple):
    """One result as it was written: bytes, and a digest of them."""

    size: int
    digest: str


IsWhole = Callable[[Path, ResultFile], bool]
"""Whether a result is there as it was written."""


class LedgerLine(StrictModel):
    """A line: the name of a scene, the key of all it depends on, its row and its files."""

    name: Text
    key: Annotated[str, Field(max_length=64)]
    file: Text
    status: Literal["complete", "left out", "not valid", "failed"]
    seconds: Annotated[float, Field(ge=0, allow_inf_nan=False)]
    pieces: Count
    left_out: Count
    violations: Count
    message: Text
    outputs: Annotated[tuple[Text, ...], Field(max_length=100)]
    files: Annotated[tuple[ResultFile, ...], Field(max_length=100)]
    facts: dict[str, Any] = {}


class Ledger:
    """The ledger of a folder of results, and ``parts``, where they are before they are whole;
    ``is_whole`` looks at results that are elsewhere.

    Used as a context; only one batch at a time may write into a folder.
    """

    def __init__(self, folder: Path, is_whole: IsWhole | None = None) -> None:
        self.path = folder / NAME
        self._is_whole = is_whole or is_as_written
        self.parts = folder / f".scenewright-parts-{secrets.token_hex(8)}"
        self._lines: dict[str, LedgerLine] = {}
        self._file: BinaryIO

    def __enter__(self) -> Ledger:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._file = _open(self.path)
            self._claim()
            self._read()
            for left in self.path.parent.glob(".scenewright-parts-*"):
                _remove_parts(left)
            self.parts.mkdir()
        except OSError as error:
            raise self._refusal(error) from None
        return self

    def _refusal(self, error: OSError) -> InputError:
        text = f"cannot be written into: {error.strerror or error}"
        return InputError(text, "choose another folder", file=str(self.path.parent))

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        with suppress(OSError):  # what a full disk did not take was reported when it was written
            self._file.close()
        _remove_parts(self.parts)

    def find(self, order: Job) -> ResultRow | None:
        """The row of an order that is done, unchanged since, and whose results are there as they
        were written; those that failed are tried again."""
        line = self._lines.get(order.name)
        if line is None or line.key != order.key or line.status == FAILED:
            return None
        if len(line.files) != len(order.outputs):
            return None
        whole = all(map(self._is_whole, order.outputs, line.files))
        return ResultRow(*(getattr(line, name) for name in ResultRow._fields)) if whole else None

    def write(self, order: Job, row: ResultRow) -> None:
        """Note that an order is done; it is on the disk when this returns."""
        try:
            files = _files_of(order, row)
            known = {"name": order.name, "key": order.key, **row._asdict(), "files": files}
            self._file.write(json.dumps(known).encode() + b"\n")
            self._file.flush()
            os.fsync(self._file.fileno())
        except OSError as error:
            raise self._refusal(error) from None

    def _claim(self) -> None:
        """Refuse a folder another batch is writing into (where the system can tell)."""
        try:
            import fcntl
        except ImportError:
            return
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self._file.close()
            raise InputError(
                "another batch is writing into it",
                "wait for it or choose another folder",
                file=str(self.path.parent),
            ) from None

    def _read(self) -> None:
        """Take in what is done; a line that was cut off is ended so that the next stands alone."""
        self._file.seek(0)
        head = self._file.readline(LONGEST)
        if not FIRST.startswith(head.rstrip(b"\n")) and not head.startswith(b'{"name": "'):
            self._file.close()
            raise InputError(
                "is not the ledger of a batch", "choose another folder", file=str(self.path)
            )
        whole = head.endswith(b"\n") or not head
        for text in iter(lambda: self._file.readline(LONGEST), b""):
            whole = text.endswith(b"\n")
            with suppress(ValidationError, ValueError, RecursionError):
                line = LedgerLine.model_validate_json(text)
                self._lines[line.name] = line
        self._file.seek(0, os.SEEK_END)
        self._file.write(b"" if whole else b"\n")
        if not head:
            self._file.write(FIRST + b"\n")
            self._file.flush()
            bring_to_disk(self.path.parent)


def _open(path: Path) -> BinaryIO:
    """A plain file of one's own to be read and added to: no link, no pipe."""
    flags = os.O_RDWR | os.O_APPEND | os.O_CREAT
    flags |= getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    handle = os.open(path, flags, 0o666)
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise InputError("is not a plain file", "remove it", file=str(path))
    note_read(path)
    return open(handle, "r+b")


def _files_of(order: Job, row: ResultRow) -> list[ResultFile]:
    """The results of a row as whoever wrote them has measured them, else as they are."""
    if row.status == FAILED:
        return []
    if "files" in row.facts:
        return [ResultFile(file["bytes"], file["blake2b"]) for file in row.facts["files"]]
    return [measure_file(path) for path in order.outputs]


def measure_file(path: Path) -> ResultFile:
    """Bytes and digest of a file."""
    digest, size = hashlib.blake2b(digest_size=16), 0
    with path.open("rb") as file:
        for block in _blocks(file):
            digest.update(block)
            size += len(block)
    return ResultFile(size, digest.hexdigest())


def _blocks(file: BinaryIO) -> Iterator[bytes]:
    return iter(lambda: file.read(BLOCK), b"")


def is_as_written(path: Path, known: ResultFile) -> bool:
    """Whether a result is a plain file of the size and the digest it was written with."""
    try:
        there = path.is_file() and path.stat().st_size == known.size > 0
        return there and measure_file(path) == known
    except OSError:
        return False


def _remove_parts(folder: Path) -> None:
    """Remove a folder of temporary files that a batch has made, and nothing else in it."""
    if not PARTS.fullmatch(folder.name) or folder.is_symlink():
        return
    with suppress(OSError):
        for file in folder.iterdir():
            if TEMPORARY.fullmatch(file.name):
                file.unlink()
        folder.rmdir()
