"""The ``Home.xml`` inside a Sweet Home 3D file, taken out without trusting the file.

Only that one entry is read, in memory and up to a limit, so names in the archive do not matter
and an archive that swells on unpacking is refused.
"""

from __future__ import annotations

import zipfile
import zlib
from pathlib import Path

from scenewright.core.errors import InputError

ENTRY = "Home.xml"
GREATEST_XML = 64 * 2**20
GREATEST_RATIO = 1000
MOST_ENTRIES = 50_000


def home_xml(path: Path) -> bytes:
    """The bytes of ``Home.xml``: of the archive, or of the file itself if it is XML."""
    if path.suffix.lower() == ".xml":
        if path.stat().st_size > GREATEST_XML:
            raise _too_large()
        return path.read_bytes()
    if path.stat().st_size == 0:
        raise InputError("is empty", "save the home again")
    try:
        with zipfile.ZipFile(path) as archive:
            return _entry(archive)
    except (zipfile.BadZipFile, zlib.error, EOFError, ValueError, NotImplementedError) as error:
        if isinstance(error, InputError):
            raise
        reason = str(error) or type(error).__name__
        raise InputError(f"is not a whole zip archive ({reason})", "save the home again") from None
    except RuntimeError:
        raise InputError(f"{ENTRY} is encrypted", "save the home without a password") from None


def _entry(archive: zipfile.ZipFile) -> bytes:
    entries = archive.infolist()
    if len(entries) > MOST_ENTRIES:
        raise InputError(f"holds {len(entries)} entries", f"at most {MOST_ENTRIES} are read")
    found = [entry for entry in entries if entry.filename == ENTRY]
    if not found:
        raise InputError(
            f"holds no {ENTRY}", "save it again with Sweet Home 3D 5.3 or a later version"
        )
    entry = found[-1]
    if entry.file_size > GREATEST_XML or entry.file_size > GREATEST_RATIO * entry.compress_size:
        raise _too_large()
    with archive.open(entry) as stream:
        content = stream.read(GREATEST_XML + 1)
    if len(content) > GREATEST_XML:
        raise _too_large()
    return content


def _too_large() -> InputError:
    return InputError(
        f"{ENTRY} is larger than {GREATEST_XML // 2**20} MiB, or packed more than "
        f"{GREATEST_RATIO} times",
        "split the home into several files",
    )
