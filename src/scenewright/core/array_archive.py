"""Named arrays in a ``.npz`` file, read without trusting it: numbers only, nothing pickled.

What an array is said to be is compared with the bytes there are before room is made for it, so
that a small file cannot take much memory.
"""

from __future__ import annotations

import io
import os
import zipfile
from typing import Any

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from scenewright.core.errors import InputError
from scenewright.core.stored_file import MEBIBYTE, read_plain

MOST_ARRAYS = 5000
NUMBERS = "bifu"
"""Kinds of numbers an array may be of: whole, signed or not, floating, true or false."""


def read_arrays(path: str | os.PathLike[str], most: int) -> dict[str, NDArray[Any]]:
    """The arrays of a file that together take at most ``most`` bytes once unpacked. InputError or
    any error of its parts for another one (see :func:`scenewright.core.stored_file.report_damage`).

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = os.path.join(folder, "some.npz")
    ...     np.savez(file, sizes=np.arange(3.0))
    ...     read_arrays(file, 10_000)["sizes"].tolist()
    [0.0, 1.0, 2.0]
    """
    with zipfile.ZipFile(io.BytesIO(read_plain(path, most))) as archive:
        listed = archive.infolist()
        if len(listed) > MOST_ARRAYS or sum(one.file_size for one in listed) > most:
            raise InputError(f"is larger than {most / MEBIBYTE:.0f} MiB unpacked", "give another")
        return {one.filename.removesuffix(".npy"): _array(archive.read(one)) for one in listed}


def _array(content: bytes) -> NDArray[Any]:
    """The array of an entry."""
    stream = io.BytesIO(content)
    version = npy.read_magic(stream)
    if version != (1, 0):
        raise ValueError(f"an array of form {version}")
    shape, by_columns, kind = npy.read_array_header_1_0(stream)
    numbers = content[stream.tell() :]
    if kind.kind not in NUMBERS or kind.fields is not None or kind.subdtype is not None:
        raise ValueError(f"an array of {str(kind)[:40]}, not of numbers")
    count = 1
    for side in shape:
        count *= side
    if min(shape, default=0) < 0 or count * kind.itemsize != len(numbers):
        raise ValueError("an array that is not whole")
    return np.frombuffer(numbers, kind).reshape(shape, order="F" if by_columns else "C").copy()
