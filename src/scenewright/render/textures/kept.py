"""Arrays that take long to make, kept in the user's cache folder.

The folder is ``textures`` in ``SCENEWRIGHT_CACHE``, else in ``scenewright`` of ``XDG_CACHE_HOME``
or ``~/.cache``. Files are written under another name and renamed, so that processes beside one
another may make and read them at once; what cannot be read is made again, what cannot be written
is not kept.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import suppress
from hashlib import blake2b
from pathlib import Path
from zipfile import BadZipFile

import numpy as np
from numpy.typing import NDArray

from scenewright.core.atomic_file import atomic_write

Singles = NDArray[np.float32]


def texture_folder() -> Path:
    """Where textures are kept.

    >>> texture_folder().name
    'textures'
    """
    if given := os.environ.get("SCENEWRIGHT_CACHE"):
        return Path(given) / "textures"
    root = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(root) / "scenewright" / "textures"


def keep_arrays(name: str, make: Callable[[], tuple[Singles, Singles]]) -> tuple[Singles, Singles]:
    """Two arrays read from the file of a name, or made and left there; in half precision, so that
    it makes no difference which."""
    file: Path | None = None
    with suppress(RuntimeError, OSError, ValueError, KeyError, EOFError, BadZipFile):
        file = texture_folder() / f"{blake2b(name.encode(), digest_size=12).hexdigest()}.npz"
        with np.load(file, allow_pickle=False) as held:
            return held["first"].astype(np.float32), held["second"].astype(np.float32)
    first, second = (array.astype(np.float16) for array in make())
    if file is not None:
        with suppress(OSError):
            file.parent.mkdir(parents=True, exist_ok=True)
            with atomic_write(file, own=True) as partial, partial.open("wb") as out:
                np.savez(out, first=first, second=second)
    return first.astype(np.float32), second.astype(np.float32)
