"""A saved solution changed by hand: read, planned once, solved where touched, judged, written."""

from __future__ import annotations

from collections.abc import Generator, Mapping
from contextlib import closing
from pathlib import Path
from typing import Any, NamedTuple

from scenewright import domains
from scenewright.core.atomic_file import allow_replacing
from scenewright.core.edits import Change
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.core.stored_file import MEBIBYTE, check_plain, report_damage
from scenewright.formats import check_outputs, solution_json, writer
from scenewright.workflow import project
from scenewright.workflow.events import Event, Judged, Planned, Solved
from scenewright.workflow.scene_project import change_scene, describe_result, dump_edits, name_edits
from scenewright.workflow.writing import write_all

LARGEST = 4096 * MEBIBYTE
"""Bytes of a project at most."""


class AdjustRequest(NamedTuple):
    """A saved solution to change, the files to write, and the edits by name, as
    :func:`.scene_project.change_scene` takes them."""

    file: Path
    outputs: tuple[Path, ...]
    edits: Mapping[str, Any]
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
    before, plan = _read(request.file)
    allow_replacing(request.file)
    check_outputs(request.outputs, before.brief)
    yield Planned(before.brief, plan, domains.domain_of(before.brief.domain))
    try:
        solution, changes = change_scene(
            before, request.edits, plan=plan, steps=request.steps, seed=request.seed
        )
    except InputError as error:
        raise error.located(file=str(request.file)) from None
    yield Solved(solution)
    if solution.brief is not before.brief:  # what stands fixed was moved
        plan = domains.plan_of(solution.brief)
    report = domains.check(solution, plan=plan)
    yield Judged(report)
    yield from write_all([(solution, path) for path in request.outputs], plan)
    if request.file.suffix == project.SUFFIX:
        _keep(request, solution, describe_result(report, changes))
    lost = any(out.required for out in set(solution.left_out) - set(before.left_out))
    complete = report.valid and not lost and solution.brief.is_read_whole
    return AdjustedFile(solution, plan, report, tuple(changes), complete)


def _read(file: Path) -> tuple[Solution, Plan]:
    """The solution of a file, or the version that a project shows."""
    if file.suffix != project.SUFFIX:
        return solution_json.read_planned(file)
    check_plain(file, LARGEST)
    with closing(project.open_project(file)) as db:
        version = project.shown_version(db)
        if version is None:
            raise InputError("the project is empty", "arrange a plan in it first", file=str(file))
        text = project.solution_text(db, version.id)
    with report_damage(file, "a project with a scene", "arrange the plan first"):
        solution = solution_json.loads(text)
    return solution, domains.plan_of(solution.brief)


def _keep(request: AdjustRequest, solution: Solution, entries: Mapping[str, str]) -> None:
    """Add what came of it to its project."""
    with closing(project.open_project(request.file)) as db:
        version = project.shown_version(db)
        parent, text = version.id if version else 0, solution_json.dumps(solution)
        project.add_version(
            db,
            parent,
            name_edits(request.edits),
            text,
            edit=dump_edits(request.edits, request.seed),
            entries=entries,
        )
