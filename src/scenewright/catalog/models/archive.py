"""Entries of a zip archive, read without trusting it.

Only named entries are read, in memory; what they may hold, each and together, is bounded, and
those packed too tightly are refused before they are unpacked.
"""

from __future__ import annotations

import lzma
import struct
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import IO, NamedTuple

from scenewright.catalog.models.files import MEBIBYTE, Beside, check_size, within
from scenewright.catalog.models.model import clean
from scenewright.core.errors import InputError

GREATEST_RATIO = 200
TIGHT = MEBIBYTE
"""Entries smaller than this may be packed more tightly than :data:`GREATEST_RATIO`."""
MOST_ENTRIES = 50_000
FAULTS = (
    zipfile.BadZipFile,
    zlib.error,
    lzma.LZMAError,
    struct.error,
    EOFError,
    ValueError,
    LookupError,
    OverflowError,
    NotImplementedError,
    OSError,
)
"""What a damaged archive leads to."""
MOST_IN_ALL = 2**30
"""Bytes unpacked from one archive."""


class Archive(NamedTuple):
    """An open archive, its entries by name, and a list of the numbers of bytes unpacked."""

    file: zipfile.ZipFile
    entries: dict[str, zipfile.ZipInfo]
    unpacked: list[int]


@contextmanager
def open_archive(stream: IO[bytes]) -> Iterator[Archive]:
    """The archive in a stream; whatever is wrong with it becomes one InputError."""
    try:
        file = zipfile.ZipFile(stream)
    except FAULTS as error:
        reason = clean(str(error), "cut off")
        raise InputError(f"is not a whole zip archive ({reason})", "save it again") from None
    with file:
        listed = file.infolist()
        if len(listed) > MOST_ENTRIES:
            raise InputError(f"holds {len(listed):,} entries", f"at most {MOST_ENTRIES:,}")
        yield Archive(file, {one.filename: one for one in listed}, [])


def entry(archive: Archive, name: str, limit: int) -> bytes | None:
    """The bytes of an entry, at most ``limit``; None if there is none of that name."""
    found = archive.entries.get(within(name))
    if found is None or found.is_dir():
        return None
    if found.file_size > limit:
        raise InputError(f"is larger than {limit / MEBIBYTE:g} MiB", "simplify it", place=name)
    if found.file_size > max(TIGHT, GREATEST_RATIO * found.compress_size):
        raise InputError(
            f"is packed more than {GREATEST_RATIO} times", "save the library again", place=name
        )
    content = _unpack_entry(archive, found, limit)
    archive.unpacked.append(len(content))
    if sum(archive.unpacked) > MOST_IN_ALL:
        raise InputError(f"unpacks to more than {MOST_IN_ALL // MEBIBYTE} MiB", "split it")
    return content


def _unpack_entry(archive: Archive, found: zipfile.ZipInfo, limit: int) -> bytes:
    try:
        with archive.file.open(found) as stream:
            return check_size(stream.read(limit + 1), limit)
    except InputError:
        raise
    except FAULTS as error:
        reason = clean(str(error), "cut off")
        raise InputError(f"cannot be unpacked ({reason})", "save the library again") from None
    except RuntimeError:
        raise InputError("is encrypted", "save it without a password") from None


def beside(archive: Archive, folder: str) -> Beside:
    """Reads entries of a folder of the archive and those below it."""
    top = "" if folder in ("", ".") else within(folder) + "/"

    def read(name: str, limit: int) -> bytes | None:
        return entry(archive, top + within(name), limit)

    return read
