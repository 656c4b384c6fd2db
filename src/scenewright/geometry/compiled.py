"""How kernels are compiled: numba, no Python inside, kept on disk between runs.

What is kept is found by the code of a kernel and of all that is copied into it
(:mod:`scenewright.geometry.code_digest`): a change elsewhere, or of words only, compiles nothing.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from hashlib import blake2b
from pathlib import Path
from typing import Any, TypeVar

import numba

from scenewright.geometry.kernel_parts import KernelCompiler, PartCompiler, take_constants_by_type
from scenewright.geometry.kernel_store import SUFFIX, KernelStore

Kernel = TypeVar("Kernel", bound=Callable[..., Any])
OPTIONS: dict[str, Any] = {
    "nogil": True,
    "error_model": "numpy",
    "_nrt": False,
    "no_cfunc_wrapper": True,
}


def fingerprint() -> str:
    """Short name for the compilers: numba's, Python's and how they are used."""
    versions = f"{numba.__version__} {sys.implementation.cache_tag} {OPTIONS}"
    return blake2b(versions.encode(), digest_size=6).hexdigest()


@cache
def cache_folders() -> tuple[Path, ...]:
    """Where compiled kernels are kept, the first choice first: ``NUMBA_CACHE_DIR`` alone, else
    beside the sources and in the user's cache folder."""
    package = Path(__file__).parent.parent
    roots = [Path(given)] if (given := os.environ.get("NUMBA_CACHE_DIR")) else []
    if not roots:
        roots = [package / "__pycache__"]
        with suppress(RuntimeError):  # a user without a home
            own = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
            roots.append(Path(own) / "scenewright")
    return tuple(root / f"kernels-{fingerprint()}" for root in roots)


def is_cold() -> bool:
    """True if nothing was compiled yet with these compilers: the first call will take seconds."""
    return not any(next(folder.glob(f"*{SUFFIX}"), None) for folder in cache_folders())


def compiled(function: Kernel) -> Kernel:
    """Compile on first call, keep on disk; runs without the interpreter's lock.

    Kernels read and write arrays but never make any, so numba need not count references to them:
    that counting costs more than a small term itself. Scratch arrays are arguments.
    """
    kernel = numba.njit(pipeline_class=KernelCompiler, **OPTIONS)(function)
    kernel._cache = KernelStore(function, cache_folders())
    return take_constants_by_type(kernel)


def inlined(function: Kernel) -> Kernel:
    """Compile as a part of the kernels that call it: it has no entry from Python and is not kept
    on disk separately, which takes a third off the time to compile.

    It is copied into its callers. Left to itself the compiler calls what is used often, and hands
    over a problem's arrays one number at a time: annealing took two to three times as long.

    Only other kernels may call it; a call from Python would crash. A test holds that.
    """
    make = numba.njit(
        no_cpython_wrapper=True, forceinline=True, pipeline_class=PartCompiler, **OPTIONS
    )
    return take_constants_by_type(make(function))
