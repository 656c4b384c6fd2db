"""How kernels are compiled: numba, no Python inside, kept on disk between runs.

Numba notices a changed file, but not a change in a file whose functions were inlined. So the
cache folder is named by the size and time of every kernel source: any change starts afresh.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache
from hashlib import blake2b
from pathlib import Path
from typing import Any, TypeVar

import numba

Kernel = TypeVar("Kernel", bound=Callable[..., Any])
OPTIONS: dict[str, Any] = {
    "nogil": True, "error_model": "numpy", "_nrt": False, "no_cfunc_wrapper": True,
}  # fmt: skip
SOURCES = (
    "problem.py", "hall_problem.py", "energy.py", "hall_energy.py", "geometry", "terms",
    "encodings", "solvers",
)  # fmt: skip


def fingerprint(package: Path) -> str:
    """Short name for the present state of the kernel sources below ``package``."""
    digest = blake2b(numba.__version__.encode(), digest_size=6)
    for source in SOURCES:
        for file in sorted(package.glob(source if "." in source else f"{source}/**/*.py")):
            told = file.stat()
            digest.update(f"{file.name} {told.st_size} {told.st_mtime_ns};".encode())
    return digest.hexdigest()


@cache
def cache_folder() -> Path:
    """Where compiled kernels are kept: ``NUMBA_CACHE_DIR``, else beside the sources, else in the
    user's cache folder."""
    package = Path(__file__).parent.parent
    given = os.environ.get("NUMBA_CACHE_DIR")
    beside = package / "__pycache__"
    if given:
        root = Path(given)
    elif os.access(beside if beside.exists() else package, os.W_OK):
        root = beside
    else:
        root = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "scenewright"
    return root / f"kernels-{fingerprint(package)}"


def is_cold() -> bool:
    """True if nothing was compiled yet for these sources: the first call will take seconds."""
    folder = cache_folder()
    return not (folder.is_dir() and next(folder.rglob("*.nbc"), None))


def compiled(function: Kernel) -> Kernel:
    """Compile on first call, keep on disk; runs without the interpreter's lock.

    Kernels read and write arrays but never make any, so numba need not count references to them:
    that counting costs more than a small term itself. Scratch arrays are arguments.
    """
    before = numba.config.CACHE_DIR
    numba.config.CACHE_DIR = str(cache_folder())
    try:
        return numba.njit(cache=True, **OPTIONS)(function)
    finally:
        numba.config.CACHE_DIR = before


def inlined(function: Kernel) -> Kernel:
    """Compile as a part of the kernels that call it: it has no entry from Python and is not kept
    on disk by itself, which takes a third off the time to compile.

    It is copied into its callers. Left to itself the compiler calls what is used often, and hands
    over a problem's arrays one number at a time: annealing took two to three times as long.

    Only other kernels may call it; a call from Python would crash. A test holds that.
    """
    return numba.njit(no_cpython_wrapper=True, forceinline=True, **OPTIONS)(function)
