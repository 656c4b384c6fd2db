"""Compiled parsers of other people's files, in a process of their own with limits.

A damaged file can bring such a parser down or make it take all memory. It works in a child: a
module of ours with a function ``main``, which finds its arguments in ``sys.argv`` and prints one
JSON document. Whatever becomes of the child, the parent gets a document or nothing.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from typing import Any

_PROGRAM = """
import sys
module, memory, seconds = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
try:
    import resource
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
except ImportError:
    pass
del sys.argv[1:4]
from importlib import import_module
import_module(module).main()
"""
SINGLE = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
"""Threads of linear algebra reserve memory that nothing here uses."""


def run_isolated(
    module: str, arguments: Sequence[str], *, memory: int, seconds: int
) -> dict[str, Any] | None:
    """The JSON object that ``main`` of a ``module`` prints, run in a child that may take
    ``memory`` bytes of addresses and ``seconds`` of the processor; ``None`` where it crashed, was
    stopped or printed anything else.

    >>> run_isolated("this", [], memory=2**31, seconds=5) is None
    True
    """
    command = [sys.executable, "-c", _PROGRAM, module, str(memory), str(seconds), *arguments]
    try:
        done = subprocess.run(
            command,
            capture_output=True,
            check=False,
            timeout=2 * seconds,
            env={**os.environ, **SINGLE},
        )
        document = json.loads(done.stdout)
    except (subprocess.TimeoutExpired, ValueError, RecursionError):
        return None
    return document if isinstance(document, dict) else None
