"""Writing under a temporary name: faults name the file the user knows, solutions are read back."""

from __future__ import annotations

from pathlib import Path

from scenewright import formats
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.formats import solution_json


def write_checked(solution: Solution, partial: Path, path: Path, plan: Plan | None = None) -> None:
    """Write a solution to ``partial``, which is to become ``path``; ``plan`` is made unless given.

    A solution in JSON is read back: it must read, and hold the same pieces. Raises InputError
    where the file cannot be written, RuntimeError where it would not read: nothing is renamed.
    """
    try:
        formats.write(solution, partial, plan)
    except InputError as error:
        raise InputError(error.fault, error.remedy, file=str(path)) from None
    if partial.stat().st_size == 0:
        module = formats.writer(partial).__module__
        fault = f"the format's module {module} has written nothing"
        raise InputError(fault, "use another format", file=str(path))
    if formats.writer(partial) is solution_json.write:
        _check_readable(solution, partial, path, plan)


def _check_readable(solution: Solution, partial: Path, path: Path, plan: Plan | None) -> None:
    known = None if plan is None else (solution.brief, plan)
    try:
        again, _ = solution_json.read_planned(partial, known)
    except InputError as error:
        raise RuntimeError(f"{path} would not read back ({error.place}: {error.fault})") from None
    if again.pieces != solution.pieces:
        raise RuntimeError(f"{path} would not read back as it was written")
