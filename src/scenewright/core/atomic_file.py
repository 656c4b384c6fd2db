"""Files that appear whole or not at all, and never in the place of a file that the run reads.

Everything is written to a temporary file, brought to the disk and renamed. Temporary names are
random, made so that they cannot exist (``O_EXCL``: no link is followed), short whatever the target
is called, and removed however the writing ends. A run (one command, one worker of a batch) records
what it reads with :func:`note_read` inside :func:`recorded_run`; whatever is written meanwhile is
compared with that record by device and file number, so symbolic links, hard links and names in
other letter case are the same file.
"""

from __future__ import annotations

import os
import re
import secrets
import stat
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from pathlib import Path
from typing import NamedTuple

from scenewright.core.errors import InputError
from scenewright.core.workspace import check_inside

Name = str | os.PathLike[str]
Identity = tuple[int, int]
LONGEST_SUFFIX = 100
"""Bytes of a target's suffixes that its temporary name keeps; file systems allow 255 in all."""
TEMPORARY = re.compile(r"\.scenewright-[0-9a-f]{16}(\..*)?")
"""What the temporary names of :func:`whole_together` and :func:`atomic_write` look like."""
DATABASE = b"SQLite format 3\0"
"""How an SQLite database begins."""
WRITTEN_BY_US = "written by Scenewright"
"""What a map that is a database says in its first pages: an output may replace it."""
HEAD = 256 * 1024
_EXCLUSIVE = os.O_WRONLY | os.O_CREAT | os.O_EXCL


class RunFiles(NamedTuple):
    """The files a run has ``read``, and those of them it may replace, by device and number."""

    read: set[Identity]
    replaceable: set[Identity]


_RUN: ContextVar[RunFiles | None] = ContextVar("run_files", default=None)


@contextmanager
def recorded_run(protected: Iterable[Identity] = ()) -> Iterator[RunFiles]:
    """Record in the block what is read, so that no output replaces it; ``protected`` files count
    as read, and so does what an enclosing run has read."""
    outer = _RUN.get() or RunFiles(set(), set())
    token = _RUN.set(RunFiles(outer.read | set(protected), set(outer.replaceable)))
    try:
        yield _RUN.get() or outer
    finally:
        _RUN.reset(token)


def identity_of(path: Name) -> Identity | None:
    """Device and number of the file a name leads to; None if there is none."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_dev, status.st_ino


def note_read(path: Name) -> None:
    """Tell the run that a file is read; without effect outside :func:`recorded_run`."""
    run = _RUN.get()
    if run is not None and (identity := identity_of(path)) is not None:
        run.read.add(identity)


def allow_replacing(path: Name) -> None:
    """Let the run replace a file that it reads: the saved home that is being edited."""
    run = _RUN.get()
    if run is not None and (identity := identity_of(path)) is not None:
        run.replaceable.add(identity)


def check_targets(paths: Sequence[Name]) -> None:
    """Raise InputError unless every path can be a new file or replace a plain one that the run
    does not read, and no two are the same."""
    for path in paths:
        check_inside(path)
        _check_target(Path(path))
    check_distinct(paths)


def check_distinct(paths: Sequence[Name]) -> None:
    """Raise InputError unless no two of the files a run writes are the same, by whatever name."""
    seen: set[Path | Identity] = set()
    for path in paths:
        same: set[Path | Identity] = {Path(os.path.realpath(path))}
        if (identity := identity_of(path)) is not None:
            same.add(identity)
        if same & seen:
            raise InputError(
                "is given twice", "give each file that is written another name", file=str(path)
            )
        seen |= same


def _check_target(path: Path) -> None:
    """Raise InputError for what no output may replace: a folder, a pipe or device, a database (an
    evolution's log, or somebody's), a file that the run reads."""
    try:
        os.lstat(path)
    except FileNotFoundError:
        return
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(
            f"cannot be written: {reason}", "choose another place", file=str(path)
        ) from None
    if os.path.isdir(path):
        raise InputError("is a folder", "give the name of a file", file=str(path))
    if os.path.exists(path) and not os.path.isfile(path):
        raise InputError("is not a plain file", "give the name of a file", file=str(path))
    if holds_database(path):
        raise InputError(
            "is a database and would be replaced", "give -o another name", file=str(path)
        )
    run, identity = _RUN.get(), identity_of(path)
    if run is not None and identity in run.read - run.replaceable:
        raise InputError(
            "is read by this run and would be replaced", "give -o another name", file=str(path)
        )


def holds_database(path: Name) -> bool:
    """Whether there is a plain file that begins as an SQLite database does, and that we have not
    written as an output."""
    try:
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
    except (OSError, ValueError):
        return False
    with open(handle, "rb") as file:
        plain = stat.S_ISREG(os.fstat(handle).st_mode)
        head = file.read(HEAD) if plain else b""
    return head.startswith(DATABASE) and WRITTEN_BY_US.encode() not in head


@contextmanager
def whole_together(paths: Sequence[Name], folder: Name | None = None) -> Iterator[list[Path]]:
    """Names to write to in the block, with the suffixes of ``paths``; at its end every target is
    checked again and then all are renamed. If anything fails none appears.

    They are beside their targets, whose folders are made, or in ``folder`` of the same file system.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as top:
    ...     with whole_together([Path(top, "a.svg"), Path(top, "new", "b.txt")]) as partials:
    ...         _ = [partial.write_text("x") for partial in partials]
    ...     sorted(file.name for file in Path(top).rglob("*.*"))
    ['a.svg', 'b.txt']
    """
    finals = [Path(path) for path in paths]
    check_targets(finals)
    partials = [_temporary_name(final, Path(folder or final.parent)) for final in finals]
    try:
        for partial, final in zip(partials, finals, strict=True):
            with _report_refusal(final):
                final.parent.mkdir(parents=True, exist_ok=True)
                _create(partial)
        yield partials
        check_targets(finals)
        for partial, final in zip(partials, finals, strict=True):
            with _report_refusal(final):
                _settle(partial, final)
        for partial, final in zip(partials, finals, strict=True):
            with _report_refusal(final):
                os.replace(partial, final)
        for place in {final.parent for final in finals}:
            bring_to_disk(place)
    finally:
        _remove(partials)


@contextmanager
def atomic_write(path: Name, *, own: bool = False) -> Iterator[Path]:
    """The name to write to in the block. It becomes ``path`` at the end; if anything fails it is
    removed, and what was there before stays. ``own`` files (copies we keep, our registers) may
    be replaced though they were read.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     with atomic_write(Path(folder, "plan.svg")) as partial:
    ...         _ = partial.write_text("<svg/>")
    ...     [file.name for file in Path(folder).iterdir()]
    ['plan.svg']
    """
    final = Path(path)
    partial = _temporary_name(final, final.parent)
    try:
        if not own:
            _check_target(final)
        _create(partial)
        yield partial
        if not own:
            _check_target(final)
            _settle(partial, final)
        os.replace(partial, final)
    finally:
        _remove([partial])


def write_atomically(path: Name, text: str, *, own: bool = False) -> None:
    """Write a text as UTF-8."""
    with atomic_write(path, own=own) as partial:
        partial.write_text(text, encoding="utf-8")


def _settle(partial: Path, final: Path) -> None:
    """Bring what was written to the disk, so that no power cut leaves an empty file under its name;
    RuntimeError where nothing was written."""
    if partial.stat().st_size == 0:
        raise RuntimeError(f"nothing was written to {final}")
    bring_to_disk(partial)


def bring_to_disk(path: Name) -> None:
    """Have the system write to the disk what it holds of a file or of a folder's names, where it
    can."""
    with suppress(OSError):
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _temporary_name(final: Path, folder: Path) -> Path:
    """A hidden random name with the suffixes of a target, as many as fit.

    >>> _temporary_name(Path("plan.street.png"), Path("out")).suffixes
    ['.street', '.png']
    """
    suffixes = final.suffixes
    while len(os.fsencode("".join(suffixes))) > LONGEST_SUFFIX:
        suffixes = suffixes[1:]
    return folder / f".scenewright-{secrets.token_hex(8)}{''.join(suffixes)}"


def _create(partial: Path) -> None:
    os.close(os.open(partial, _EXCLUSIVE, 0o666))


@contextmanager
def _report_refusal(final: Path) -> Iterator[None]:
    """What the system refuses, as one InputError that names the target."""
    try:
        yield
    except OSError as error:
        raise InputError(
            f"cannot be written: {error.strerror or error}", "choose another place", file=str(final)
        ) from None


def _remove(partials: Iterable[Path]) -> None:
    for partial in partials:
        with suppress(OSError):
            partial.unlink()
