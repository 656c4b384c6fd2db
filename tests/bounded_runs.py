"""Runs each of some files in a process of its own, and tells what it took: memory, processor time.

Started with a list of files; each is read (and, asked to, laid out and written) in a fork of this
warm process, that may not take more than a gibibyte beside what it began with.
"""

from __future__ import annotations

import json
import os
import resource
import sys
import tempfile
from pathlib import Path
from typing import Any

MEBIBYTE = 2**20
GUARD = 2048 * MEBIBYTE
"""Bytes of address space beyond which a run is ended, over what the process began with."""
LONGEST = 120
"""Seconds of the processor after which a run is ended."""
OUTPUTS = ("out.json", "out.glb", "out.svg", "out.png")


def run(path: Path, whole: bool) -> dict[str, Any]:
    """What reading a file leads to: refused with which line, or done; seconds, mebibytes."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        with os.fdopen(writer, "w") as answers:
            json.dump(_bounded(path, whole), answers)
            answers.flush()
            os._exit(0)
    os.close(writer)
    with os.fdopen(reader) as answers:
        text = answers.read()
    _, status = os.waitpid(child, 0)
    lost = {
        "name": path.name,
        "told": f"ended by {status}",
        "error": True,
        "done": False,
        "seconds": 0.0,
        "memory": 0.0,
    }
    return json.loads(text) if text else lost


def _bounded(path: Path, whole: bool) -> dict[str, Any]:
    before = _resident()
    size = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (size + GUARD, size + GUARD))
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST))
    told, failed, refused = "", False, False
    from scenewright.core.errors import InputError

    try:
        _use(path, whole)
    except InputError as error:
        told, refused = str(error), True
    except BaseException as error:
        told, failed = f"{type(error).__name__}: {error}"[:300], True
    used = resource.getrusage(resource.RUSAGE_SELF)
    return {
        "name": path.name,
        "told": told,
        "error": failed,
        "done": not failed and not refused,
        "seconds": round(used.ru_utime + used.ru_stime, 2),
        "memory": round(max(_peak() - before, 0) / MEBIBYTE, 1),
    }


def _use(path: Path, whole: bool) -> None:
    from scenewright import domains, formats
    from scenewright.catalog import models
    from scenewright.core.errors import InputError
    from scenewright.formats import solution_json

    if path.suffix in models.suffixes() and path.suffix not in (".json", ".cityjson"):
        skipped = models.report(path).skipped
        if skipped:
            raise InputError(skipped[0].reason)
        return
    if path.name.endswith(".solution.json"):
        solution_json.read(path)
    brief = formats.read(path)
    if whole:
        solution = domains.solve(brief, steps=4, threads=1)
        with tempfile.TemporaryDirectory() as folder:
            for name in OUTPUTS:
                formats.write(solution, Path(folder, name))


def _resident() -> int:
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


def _peak() -> int:
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(row.split()[1]) for row in lines if row.startswith("VmHWM")) * 1024


def main(arguments: list[str]) -> None:
    """Run every file named and print a line of JSON for each; ``--whole`` lays out as well."""
    whole = "--whole" in arguments
    import scenewright.catalog.models  # noqa: F401

    for name in arguments:
        if name != "--whole":
            sys.stdout.write(json.dumps(run(Path(name), whole)) + "\n")
            sys.stdout.flush()


if __name__ == "__main__":
    main(sys.argv[1:])
