"""A saved solution changed by hand: read, planned once, solved where touched, judged, written."""

from __future__ import annotations

from collections.abc import Generator, Mapping
from pathlib import Path
from typing import NamedTuple

from scenewright import domains
from scenewright.core.atomic_file import allow_replacing
from scenewright.core.edits import Change
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.formats import check_outputs, solution_json, writer
from scenewright.workflow.events import Event, Judged, Planned, Solved
from scenewright.workflow.writing import write_all


class AdjustRequest(NamedTuple):
    """A saved solution to change, the files to write, and the edits."""

    file: Path
    outputs: tuple[Path, ...]
    move: Mapping[str, tuple[float, ...]]
    swap: tuple[tuple[str, str], ...]
    lock: tuple[str, ...]
    unlock: tuple[str, ...]
    again: tuple[str, ...]
    steps: int | None
    seed: int | None


class AdjustedFile(NamedTuple):
    """What came of it, with every change; ``complete`` if no rule is broken, nothing that had
    a place has lost it, and the file was read whole."""

    solution: Solution
    plan: Plan
    report: Report
    changes: tuple[Change, ...]
    complete: bool


def adjust_file(request: AdjustRequest) -> Generator[Event, None, AdjustedFile]:
    """Change a saved solution, judge it and write its outputs; the file itself may be replaced."""
    for path in request.outputs:
        writer(path)
    before, plan = solution_json.read_planned(request.file)
    allow_replacing(request.file)
    check_outputs(request.outputs, before.brief)
    yield Planned(before.brief, plan, domains.domain_of(before.brief.domain))
    try:
        solution, changes = domains.adjust(
            before,
            plan=plan,
            move=request.move,
            swap=request.swap,
            lock=request.lock,
            unlock=request.unlock,
            again=request.again,
            steps=request.steps,
            seed=request.seed,
        )
    except InputError as error:
        raise error.located(file=str(request.file)) from None
    yield Solved(solution)
    if solution.brief is not before.brief:  # what stands fixed was moved
        plan = domains.plan_of(solution.brief)
    report = domains.check(solution, plan=plan)
    yield Judged(report)
    yield from write_all([(solution, path) for path in request.outputs], plan)
    lost = any(out.required for out in set(solution.left_out) - set(before.left_out))
    complete = report.valid and not lost and solution.brief.is_read_whole
    return AdjustedFile(solution, plan, report, tuple(changes), complete)
