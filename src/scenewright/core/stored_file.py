"""The boundary of every stored format: whatever a file holds, it is used or named in one line.

What is stored (logs, ledgers, styles, learned groups, copies) was written by us, and may have been
damaged or made up since. Files are opened only if they are plain ones, read up to a limit, and
whatever their content leads to while it is validated becomes one :class:`InputError`.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pydantic import ValidationError

from scenewright.core.atomic_file import note_read
from scenewright.core.document_faults import to_input_error
from scenewright.core.errors import InputError
from scenewright.core.workspace import check_inside

MEBIBYTE = 2**20


@contextmanager
def report_damage(path: str | os.PathLike[str], what: str, remedy: str) -> Iterator[None]:
    """Whatever goes wrong in the block as one InputError: the file is not ``what`` it should be.

    >>> with report_damage("my.evolution", "the log of an evolution", "choose another name"):
    ...     [][0]
    Traceback (most recent call last):
    scenewright.core.errors.InputError: my.evolution: is not the log of an evolution: list index \
out of range; choose another name
    """
    try:
        yield
    except InputError as error:
        raise error.located(file=str(path)) from None
    except ValidationError as error:
        fault = to_input_error(error)
        raise InputError(
            f"is not {what}: {fault.fault}", remedy, file=str(path), place=fault.place
        ) from None
    except FileNotFoundError:
        raise InputError("there is no such file", "check the path", file=str(path)) from None
    except OSError as error:
        raise InputError(
            f"cannot be read: {error.strerror or error}", "check the path", file=str(path)
        ) from None
    except Exception as error:
        reason = " ".join(str(error).split())[:100] or type(error).__name__
        raise InputError(f"is not {what}: {reason}", remedy, file=str(path)) from error


def read_plain(path: str | os.PathLike[str], most: int) -> bytes:
    """The bytes of a plain file of at most ``most`` bytes. Raises OSError where it cannot be
    opened, InputError for a folder, a pipe or a device (none is waited for) and for a larger
    file."""
    check_inside(path)
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
    with open(handle, "rb") as stream:
        status = os.fstat(handle)
        if not stat.S_ISREG(status.st_mode):
            raise InputError("is not a plain file", "give the file itself")
        if status.st_size > most:
            raise InputError(f"is larger than {most / MEBIBYTE:g} MiB", "simplify or split it")
        note_read(path)
        return stream.read(min(status.st_size + 1, most))  # it may have grown meanwhile


def check_plain(path: str | os.PathLike[str], most: int) -> None:
    """InputError unless there is a plain file of at most ``most`` bytes. The run counts as reading
    it, also where its content is known from before."""
    check_inside(path)
    try:
        status = Path(path).stat()
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}", "check the path") from None
    if not stat.S_ISREG(status.st_mode):
        raise InputError("is not a plain file", "give the file itself")
    if status.st_size > most:
        raise InputError(f"is larger than {most / MEBIBYTE:g} MiB", "choose another one")
    note_read(path)
