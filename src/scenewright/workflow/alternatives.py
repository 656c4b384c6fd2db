"""Several plans of one file that differ, ranked, each with its files."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from scenewright import domains
from scenewright.core.atomic_file import check_targets
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.formats import suffix_of
from scenewright.workflow.events import Event, Judged, Solved
from scenewright.workflow.request import ArrangeRequest, open_request
from scenewright.workflow.stream import Cancel, stream_progress
from scenewright.workflow.writing import write_all


class RankedSolution(NamedTuple):
    """One solution: its rank from 1, the files it was written to, and the referee's report."""

    rank: int
    outputs: tuple[Path, ...]
    solution: Solution
    plan: Plan
    report: Report

    @property
    def complete(self) -> bool:
        """Whether all that was asked for stands, no rule is broken, and the file was read whole."""
        missing = any(out.required for out in self.solution.left_out)
        return self.report.valid and not missing and self.solution.brief.is_read_whole


def arrange_alternatives(
    request: ArrangeRequest, *, cancel: Cancel | None = None
) -> Generator[Event, None, list[RankedSolution]]:
    """Solve, judge and write several plans of a request, as
    :func:`~scenewright.workflow.arrange.arrange_file` does one.

    ``plan.svg`` becomes ``plan-1.svg``, ``plan-2.svg`` …; all files appear together.
    """
    brief, plan, _ = yield from open_request(request)
    ranks = range(1, request.alternatives + 1)
    check_targets([number_path(path, rank) for path in request.outputs for rank in ranks])
    try:
        found = yield from stream_progress(
            lambda tell, cancelled: domains.alternatives(
                brief,
                request.alternatives,
                plan=plan,
                preset=request.preset,
                solver=request.solver,
                seconds=request.seconds,
                steps=request.work,
                seed=request.seed,
                progress=tell,
                cancel=cancelled,
            ),
            cancel,
        )
    except InputError as error:
        raise error.located(file=request.source) from None
    if cancel is not None and cancel() and not any(solution.evaluations for solution in found):
        raise CancelledError
    found = tuple(replace(solution, clutter=request.clutter) for solution in found)
    ranked = rank_solutions(found, plan, request.outputs)
    for one in ranked:
        yield Solved(one.solution)
        yield Judged(one.report)
    yield from write_all([(one.solution, path) for one in ranked for path in one.outputs], plan)
    return ranked


def rank_solutions(
    found: Sequence[Solution], plan: Plan, outputs: Sequence[Path]
) -> list[RankedSolution]:
    """Solutions judged and numbered: those that break no rule and leave nothing out come first."""
    judged = [(solution, domains.check(solution, plan=plan)) for solution in found]
    order = sorted(judged, key=lambda pair: (not pair[1].valid, len(pair[0].left_out)))
    return [
        RankedSolution(
            rank, tuple(number_path(path, rank) for path in outputs), solution, plan, report
        )
        for rank, (solution, report) in enumerate(order, 1)
    ]


def number_path(path: Path, rank: int) -> Path:
    """The name of one plan's file.

    >>> number_path(Path("out/plan.svg"), 2).as_posix()
    'out/plan-2.svg'
    >>> number_path(Path("plan.street.png"), 2).as_posix()
    'plan-2.street.png'
    """
    suffix = suffix_of(path)
    return path.with_name(f"{path.name.removesuffix(suffix)}-{rank}{suffix}")
