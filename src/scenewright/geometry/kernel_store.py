"""Compiled kernels on disk: one file each, checked before use, compiled again if not sound.

A file is a mark, a digest of what follows and the compiler's result. What is missing, cut short,
altered, unreadable or of another compiler counts as not there: it is removed, compiled and written
again. Files appear whole, so that processes that compile at once do not disturb each other, and
a folder that cannot be written to costs time but no failure. The name of a file tells processor,
signature and code apart (:mod:`scenewright.geometry.code_digest`): what was compiled is used until
the code of a kernel, or of what is copied into it, changes.
"""

from __future__ import annotations

import os
import pickle
import tempfile
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from hashlib import blake2b
from pathlib import Path
from typing import Any

from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

from scenewright.geometry.code_digest import code_digest

SUFFIX = ".kernel"
MARK = b"scenewright kernel 1\n"
DIGEST = 16
"""Bytes of the digest."""


@dataclass(frozen=True, slots=True)
class KernelStore:
    """What numba asks of the cache of one ``function``: it is looked for in all ``folders`` and
    kept in the first that can be written to."""

    function: Callable[..., Any]
    folders: tuple[Path, ...]

    @property
    def cache_path(self) -> str:
        """The first folder."""
        return str(self.folders[0])

    def load_overload(self, signature: Any, target: Any) -> Any:
        """The compiled function for a signature; ``None`` if it must be compiled."""
        target.refresh()
        name = file_name(self.function, signature, target.codegen())
        results = (load(folder / name, target) for folder in self.folders)
        return next((result for result in results if result is not None), None)

    def save_overload(self, signature: Any, result: Any) -> None:
        """Keep a result of the compiler, if there is anywhere to keep it."""
        if result.library.has_dynamic_globals:
            return
        name = file_name(self.function, signature, result.codegen)
        payload = dumps(result._reduce())
        any(save(folder / name, payload) for folder in self.folders)

    def enable(self) -> None:
        """Always enabled; asked for by numba."""

    def disable(self) -> None:
        """Always enabled; asked for by numba."""

    def flush(self) -> None:
        """Nothing is held back; asked for by numba."""


def file_name(function: Callable[..., Any], signature: Any, codegen: Any) -> str:
    """Name for a function as compiled for one signature on one kind of processor."""
    digest = blake2b(repr((str(signature), codegen.magic_tuple())).encode(), digest_size=8)
    digest.update(code_digest(function))
    place = function.__module__.rpartition(".")[2]
    return f"{place}.{function.__name__}-{digest.hexdigest()}{SUFFIX}"


def load(path: Path, target: Any) -> Any:
    """The compiled function in a file; ``None`` if there is none. A file that is not sound is
    removed."""
    with suppress(FileNotFoundError, NotADirectoryError):
        try:
            return CompileResult._rebuild(target, *pickle.loads(unsealed(path.read_bytes())))
        except FileNotFoundError:
            raise
        except Exception:  # whatever is wrong with it, compiling again mends it
            with suppress(OSError):
                path.unlink()
    return None


def save(path: Path, payload: bytes) -> bool:
    """Write a sealed ``payload`` that appears whole; False if it cannot be written here."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, partial = tempfile.mkstemp(prefix=".", suffix=".partial", dir=path.parent)
    except OSError:
        return False
    try:
        with open(handle, "wb") as file:
            file.write(sealed(payload))
        os.replace(partial, path)
    except OSError:
        return False
    finally:
        Path(partial).unlink(missing_ok=True)
    return True


def sealed(payload: bytes) -> bytes:
    """A payload behind its mark and digest.

    >>> unsealed(sealed(b"machine code"))
    b'machine code'
    """
    return MARK + blake2b(payload, digest_size=DIGEST).digest() + payload


def unsealed(data: bytes) -> bytes:
    """The payload of a file's ``data``; raises ``ValueError`` if a byte of it was altered."""
    digest, payload = data[len(MARK) : len(MARK) + DIGEST], data[len(MARK) + DIGEST :]
    if not data.startswith(MARK) or blake2b(payload, digest_size=DIGEST).digest() != digest:
        raise ValueError("not a sound kernel file")
    return payload
