"""Packages ``.usdz``: a zip of files that are stored as they are, each beginning at a multiple of
64 bytes (*USDZ File Format Specification*), with one fixed date: same files, same bytes."""

from __future__ import annotations

import io
import struct
from collections.abc import Mapping
from zipfile import ZIP_STORED, ZipFile, ZipInfo

ALIGNED = 64
"""Each file begins at a multiple of this number of bytes."""
HEADER = 30
"""Bytes of a zip's local header before name and padding."""
PADDING = 0x1986
"""The id of the field that pads, as in packages made by OpenUSD."""
DAY = (1980, 1, 1, 0, 0, 0)


def pack_files(files: Mapping[str, bytes]) -> bytes:
    """The package of named files; the first is the one that is opened.

    >>> data = pack_files({"scene.usda": b"#usda 1.0"})
    >>> data.index(b"#usda") % 64, data == pack_files({"scene.usda": b"#usda 1.0"})
    (0, True)
    """
    buffer = io.BytesIO()
    with ZipFile(buffer, "w", ZIP_STORED) as package:
        for name, data in files.items():
            entry = ZipInfo(name, DAY)
            begin = buffer.tell() + HEADER + len(name.encode()) + 4
            room = -begin % ALIGNED
            entry.extra = struct.pack("<HH", PADDING, room) + bytes(room)
            package.writestr(entry, data)
    return buffer.getvalue()
