"""The files of a map, copied or unpacked into a folder of their own under plain names.

A parser is given nothing but what lies there: an archive that swells, names that lead elsewhere
and links do not reach it, and nothing appears beside the user's file.
"""

from __future__ import annotations

import bz2
import gzip
import lzma
import re
import zipfile
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path, PurePosixPath
from typing import IO, Any

from scenewright.core.atomic_file import note_read
from scenewright.core.errors import InputError
from scenewright.ground.geodata.kinds import BESIDE, KINDS, check_content, kind_by_suffix
from scenewright.ground.geodata.limits import CUT

GREATEST_FILE = 256 * 2**20
"""Bytes of a map, unpacked, that are read."""
MOST_ENTRIES, MOST_FILES = 10_000, 200
PACKED: dict[str, Callable[..., Any]] = {".gz": gzip.open, ".bz2": bz2.open}
ARCHIVES = (".zip", ".kmz")
DAMAGED = (
    zipfile.BadZipFile,
    zlib.error,
    lzma.LZMAError,
    EOFError,
    gzip.BadGzipFile,
    NotImplementedError,
    UnicodeDecodeError,
)
WANTED = ", ".join(kind.suffix for kind in KINDS)
TOO_LARGE = f"is larger than {GREATEST_FILE // 2**20} MiB unpacked"


def unpack(path: Path, folder: Path) -> tuple[Path, ...]:
    """The map files of ``path``, each a kind that is read, below an empty ``folder``; what lies
    beside a shapefile lies beside it there. Raises :class:`InputError` for what is no such map."""
    suffix = path.suffix.lower()
    try:
        if suffix in ARCHIVES:
            made = _unzip(path, folder)
        elif suffix in PACKED:
            made = [folder / _plain(path.stem)]
            with PACKED[suffix](path, "rb") as stream:
                _copy(stream, made[0], GREATEST_FILE)
        else:
            made = list(_copies(path, folder))
    except DAMAGED as error:
        reason = str(error) or type(error).__name__
        raise InputError(f"is a damaged archive ({reason[:80]})", "export it again") from None
    maps = tuple(file for file in made if kind_by_suffix(file.name))
    if not maps:
        raise InputError("holds no map", f"give a map in one of: {WANTED}")
    for file in maps:
        _check(file, several=len(maps) > 1)
    return maps


def _check(file: Path, several: bool) -> None:
    kind = kind_by_suffix(file.name)
    assert kind is not None
    try:
        check_content(file, kind)
    except InputError as error:
        raise error.located(place=file.name) if several else error from None


def _copies(path: Path, folder: Path) -> Iterator[Path]:
    """The copy of a file, and of what lies beside a shapefile, in whatever case it is written."""
    beside = [path]
    if path.suffix.lower() == ".shp":
        beside += [
            file
            for file in sorted(path.parent.iterdir())
            if file.stem == path.stem and file.suffix.lower() in BESIDE and file.is_file()
        ]
    for file in beside:
        target = folder / _plain(file.name)
        note_read(file)
        with file.open("rb") as stream:
            _copy(stream, target, GREATEST_FILE)
        yield target


def _unzip(path: Path, folder: Path) -> list[Path]:
    """What an archive holds of maps, folders within it as folders with a number."""
    made: list[Path] = []
    folders: dict[str, Path] = {}
    room = GREATEST_FILE
    with zipfile.ZipFile(path) as archive:
        for entry in _entries(archive):
            place = PurePosixPath(entry.filename.replace("\\", "/"))
            if str(place.parent) not in folders:
                folders[str(place.parent)] = folder / str(len(folders))
                folders[str(place.parent)].mkdir()
            target = folders[str(place.parent)] / _plain(place.name)
            if entry.file_size > room:
                raise InputError(TOO_LARGE, CUT)
            with _open(archive, entry) as stream:
                room -= _copy(stream, target, room)
            made.append(target)
    return made


def _entries(archive: zipfile.ZipFile) -> list[zipfile.ZipInfo]:
    listed = archive.infolist()
    if len(listed) > MOST_ENTRIES:
        raise InputError(f"holds {len(listed):,} entries", f"at most {MOST_ENTRIES:,} are read")
    suffixes = (*BESIDE, *(kind.suffix for kind in KINDS))
    found = [
        entry
        for entry in listed
        if entry.filename.lower().endswith(suffixes) and "__MACOSX" not in entry.filename
    ]
    maps = sum(kind_by_suffix(entry.filename) is not None for entry in found)
    if not maps:
        raise InputError("is an archive that holds no map", f"give a map in one of: {WANTED}")
    if maps > MOST_FILES:
        raise InputError(f"holds {maps} maps", f"give at most {MOST_FILES} in one archive")
    return found


def _open(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> IO[bytes]:
    if entry.flag_bits & 1:
        raise InputError(f"{entry.filename[:60]} is encrypted", "pack it without a password")
    return archive.open(entry)


def _copy(stream: Any, target: Path, room: int) -> int:
    """Write what a stream holds, of at most ``room`` bytes; how many they were."""
    size = 0
    with target.open("wb") as out:
        while chunk := stream.read(2**20):
            size += len(chunk)
            if size > room:
                raise InputError(TOO_LARGE, CUT)
            out.write(chunk)
    return size


def _plain(name: str) -> str:
    """A name of letters that no system takes for anything else, its suffix in small letters.

    >>> _plain("Straßen Ost.SHP"), _plain("-x;y.kml")
    ('Straßen_Ost.shp', '_x_y.kml')
    """
    stem, dot, suffix = name.rpartition(".")
    safe = re.sub(r"[^\w.-]|^[.-]", "_", stem or "map")[:80]
    return safe + dot + suffix.lower()
