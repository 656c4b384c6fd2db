"""Reading in a process apart: a hostile or damaged file can bring down no more than that.

Parsers are others' code, in part compiled, and geometry has no bound that a count of lines would
give. What reads a file runs in a process with limits of memory and time; its result, plain values,
comes back as one JSON document on the standard output.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Mapping
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple, TextIO

from scenewright.core.errors import InputError

PROGRAM = "from scenewright.core.isolated_reading import answer; answer()"
MEBIBYTE = 2**20
STOPPED = (-9, -24)
"""Exit codes of what was killed, or took more of the processor than it may."""
CRASHED = "is damaged or too large: its parser gave up"
FAULTS = (
    ValueError,
    ArithmeticError,
    LookupError,
    TypeError,
    AttributeError,
    RuntimeError,
    OSError,
)
"""Exceptions that parsers raise over damaged files."""


SMALLER = "save it again from its program, only the plan of a storey"


class Allowance(NamedTuple):
    """The most memory in MiB, and MiB more for each of the file; the most seconds of processor;
    the remedy for a file that is damaged or needs more."""

    memory: int
    per_size: int
    seconds: int
    remedy: str = SMALLER


def read_apart(
    module: str, path: Path, allowance: Allowance, options: Mapping[str, Any]
) -> dict[str, Any]:
    """The document that ``extract(path, **options)`` of a module returns.

    Raises :class:`InputError` as the function does, and where the process is brought down or needs
    more than it may.
    """
    size = path.stat().st_size / MEBIBYTE
    memory = int(allowance.memory + allowance.per_size * size)
    order: dict[str, Any] = {
        "module": module,
        "path": str(path.resolve()),
        "options": dict(options),
    }
    order |= {"memory": memory, "seconds": allowance.seconds, "remedy": allowance.remedy}
    try:
        done = run_child(json.dumps(order).encode(), 20.0 * allowance.seconds)
        document: dict[str, Any] = json.loads(done.said)
    except subprocess.TimeoutExpired:
        document = {"fault": _too_much(memory, allowance.seconds), "remedy": allowance.remedy}
    except (ValueError, RecursionError):
        stopped = done.code in STOPPED
        fault = _too_much(memory, allowance.seconds) if stopped else CRASHED
        document = {"fault": fault, "remedy": allowance.remedy}
    if "fault" in document:
        raise InputError(document["fault"], document["remedy"], place=document.get("place", ""))
    return document


class Ended(NamedTuple):
    """The standard output of a process, and its exit code."""

    said: bytes
    code: int


def run_child(order: bytes, seconds: float) -> Ended:
    """Carry out an order in a new interpreter; ``TimeoutExpired`` after so long."""
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        input=order,
        capture_output=True,
        check=False,
        timeout=seconds,
        env=surroundings(),
    )
    return Ended(done.stdout, done.returncode)


def surroundings() -> dict[str, str]:
    """The environment of a process apart: one thread."""
    return {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


def _too_much(memory: int, seconds: int) -> str:
    return f"cannot be read within {seconds} s and {memory} MiB of memory: damaged or too large"


def answer() -> None:
    """Print the document that is asked for on the standard input, or its fault and remedy."""
    order = json.load(sys.stdin)
    import_module(order["module"])
    limit(order["memory"] * MEBIBYTE, order["seconds"])
    carry_out(order, sys.stdout)


def carry_out(order: Mapping[str, Any], out: TextIO) -> None:
    """Write the document of an order, or its fault and remedy."""
    try:
        document = import_module(order["module"]).extract(order["path"], **order["options"])
    except InputError as error:
        document = {"fault": error.fault, "remedy": error.remedy, "place": error.place}
    except MemoryError:
        fault = _too_much(order["memory"], order["seconds"])
        document = {"fault": fault, "remedy": order["remedy"]}
    except FAULTS as error:
        own = isinstance(error, (TypeError, AttributeError, LookupError))
        reason = "" if own else " ".join(str(error).split())[:120]
        fault = f"is damaged ({reason or 'its parts do not fit'})"
        document = {"fault": fault, "remedy": order["remedy"]}
    out.write(json.dumps(document))


def limit(memory: int, seconds: int) -> None:
    """Limit this process; where the system knows no limits there are none."""
    try:
        import resource
    except ImportError:
        return
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
