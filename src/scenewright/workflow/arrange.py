"""One file arranged: read, planned once, solved, judged, and every file written or none."""

from __future__ import annotations

import os
from collections.abc import Callable, Generator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from scenewright import domains
from scenewright.core.atomic_file import recorded_run
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.layout import BestLayout, Watch
from scenewright.core.map_options import AS_IT_IS, MapOptions
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.engine.trace import Step
from scenewright.workflow.disturb import disturb
from scenewright.workflow.events import (
    Changed,
    Event,
    Hear,
    Judged,
    Progress,
    Solved,
    Wrote,
    run_to_end,
)
from scenewright.workflow.looks import draw_clutter, stream_of
from scenewright.workflow.request import ArrangeRequest, note_heavy, note_losses, open_request
from scenewright.workflow.stream import Cancel, stream_events
from scenewright.workflow.trace import write_trace
from scenewright.workflow.writing import write_all


class Arranged(NamedTuple):
    """What came of a run."""

    solution: Solution
    plan: Plan
    report: Report

    @property
    def complete(self) -> bool:
        """Whether all that was asked for stands, no rule is broken, and the file was read whole."""
        missing = any(out.required for out in self.solution.left_out)
        return self.report.valid and not missing and self.solution.brief.is_read_whole


def arrange_file(
    request: ArrangeRequest,
    *,
    cancel: Cancel | None = None,
    threads: int | None = None,
    parts: Path | None = None,
) -> Generator[Event, None, Arranged]:
    """Solve a request, judge the solution and write its outputs.

    When ``cancel`` answers true, the best so far is written; if nothing was found yet it raises
    ``CancelledError`` and writes nothing. ``parts`` is the folder of temporary files.
    """
    brief, plan, domain = yield from open_request(request)
    steps = list[Step]()
    heard: dict[str, Any] = {} if request.trace is None else {"hear": steps.append}
    watches = domain.takes("solve", "watch")
    try:
        solution = yield from stream_events(
            lambda tell, cancelled: domain.verb("solve")(
                brief,
                plan=plan,
                preset=request.preset,
                solver=request.solver,
                seconds=request.seconds,
                steps=request.work,
                seed=request.seed,
                threads=threads,
                progress=lambda share, what: tell(Progress(share, what)),
                cancel=cancelled,
                **(heard | ({"watch": _tell_changes(tell)} if watches else {})),
            ),
            cancel,
        )
    except InputError as error:
        raise error.located(file=request.source) from None
    if cancel is not None and cancel() and not solution.evaluations:
        raise CancelledError
    look, report = request.look, None
    if look is not None and look.number and "poses" in look.vary:
        solution, report, _ = disturb(solution, plan, stream_of(brief, look, "poses"))
    solution = replace(solution, clutter=draw_clutter(brief, look, request.clutter))
    yield from (Changed(o.space, "left out", f"{o.what}: {o.reason}") for o in solution.left_out)
    yield Solved(solution)
    report = report or domains.check(solution, plan=plan)
    yield Judged(report)
    yield from write_all([(solution, path) for path in request.outputs], plan, parts)
    if request.trace is not None:
        write_trace(request.trace, solution, steps)
        yield Wrote(request.trace)
    yield from note_losses(solution, request.outputs)
    yield from note_heavy(solution)
    return Arranged(solution, plan, report)


def _tell_changes(tell: Callable[[Changed], None]) -> Watch:
    """A listener to layouts that tells those changed after the search; no picture is made."""

    def hear(layout: BestLayout) -> None:
        if layout.reason:
            tell(Changed(layout.space, layout.stage, layout.reason))

    return hear


def arrange(
    source: str | os.PathLike[str],
    outputs: Sequence[str | os.PathLike[str]] = (),
    *,
    progress: Callable[[float, str], None] | None = None,
    cancel: Cancel | None = None,
    hear: Hear | None = None,
    threads: int | None = None,
    preset: str = "default",
    solver: str | None = None,
    seconds: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    keep: bool = False,
    catalogs: Sequence[str] = (),
    groups: Sequence[str] = (),
    accessible: bool = False,
    scale: float = 1.0,
    hidden_levels: bool = False,
    style: str = "",
    layouts: int | None = None,
    map_options: MapOptions = AS_IT_IS,
    trace: str | os.PathLike[str] | None = None,
    nets: str = "",
    clutter: str = "none",
) -> Arranged:
    """Read a brief, solve it, judge the solution and write it to all ``outputs`` or none.

    The options are those of ``scenewright arrange``. ``progress`` is called with the share done, 0
    to 1, and what is done; ``hear`` with every event (:mod:`scenewright.workflow.events`); when
    ``cancel`` answers true, the best so far is taken. Raises :class:`InputError` for bad input.

    >>> arrange("sample:home-room", steps=200).report.valid
    True
    """
    asked = ArrangeRequest(os.fspath(source), tuple(map(Path, outputs)), preset, solver, seconds)
    request = asked._replace(
        steps=steps,
        seed=seed,
        keep=keep,
        catalogs=tuple(catalogs),
        groups=tuple(groups),
        accessible=accessible,
        scale=scale,
        hidden_levels=hidden_levels,
        style=style,
        layouts=layouts,
        map_options=map_options,
        trace=None if trace is None else Path(trace),
        nets=nets,
        clutter=clutter,
    )

    def pass_on(event: Event) -> None:
        if progress is not None and isinstance(event, Progress):
            progress(*event)
        if hear is not None:
            hear(event)

    with recorded_run():
        return run_to_end(arrange_file(request, cancel=cancel, threads=threads), pass_on)
