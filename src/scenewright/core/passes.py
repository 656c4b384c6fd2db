"""Passes: steps that change an answer for the better, as rows of a table, run by one loop.

A table says by name what each pass is for. The loop (:func:`run_passes`) runs the rows one after
the other; what it is told (:class:`PassOptions`) switches rows off, or hears what each changed.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

if TYPE_CHECKING:
    from scenewright.core.plan import Plan
    from scenewright.core.solution import Solution

Run = TypeVar("Run")
State = TypeVar("State")


class Pass(NamedTuple, Generic[Run]):
    """A row: the pass by ``name``, the ``group`` it belongs to, the function that ``run`` names,
    and its ``purpose`` in a few words."""

    name: str
    group: str
    run: Run
    purpose: str


class PassChange(NamedTuple):
    """A space that a pass changed: by how much its cost fell (``gain``), and what is wrong with it
    (``faults``), less than 0 where they rose; how many more ``pieces`` it holds."""

    space: str
    gain: float
    faults: float
    pieces: int


class PassRun(NamedTuple):
    """One run of a pass: its ``name``, the processor's ``seconds`` of its thread, the changes."""

    name: str
    seconds: float
    changes: tuple[PassChange, ...]


class PassOptions(NamedTuple):
    """Names of passes and of groups that are ``off``, and who is to ``hear`` of every run; from
    several threads where spaces are worked on side by side. Once ``cancelled`` says so no further
    pass is run."""

    off: frozenset[str] = frozenset()
    hear: Callable[[PassRun], None] | None = None
    cancelled: Callable[[], bool] = lambda: False


ALL_PASSES = PassOptions()
"""Every pass runs, and nobody hears."""


class PassTally(NamedTuple):
    """What all runs of a pass came to: how many, the ``spaces`` changed, the sums of what the
    changes gained (:class:`PassChange`) and of ``seconds``."""

    name: str
    group: str
    purpose: str
    runs: int
    spaces: tuple[str, ...]
    gain: float
    faults: float
    pieces: int
    seconds: float


class PassTrace(NamedTuple):
    """The tallies of a domain's passes in the order of its table, and whether the answer they were
    heard of is the one asked about (``same``)."""

    tallies: tuple[PassTally, ...]
    same: bool


def run_passes(
    passes: Iterable[Pass[Run]],
    state: State,
    options: PassOptions,
    apply: Callable[[Run, State], State],
    compare: Callable[[State, State], Iterable[PassChange]],
    show: Callable[[str, State, State], None] | None = None,
) -> State:
    """The state after all passes that are not off: ``apply`` calls one, ``compare`` lists what it
    changed, and is called only where somebody hears. ``show`` gets what each is for, and the
    states before and after it.

    >>> grow, heard = Pass("grow", "all", 2, "twice as large"), []
    >>> options = PassOptions(hear=heard.append)
    >>> more = lambda a, b: [PassChange("", float(b - a), 0.0, 0)]
    >>> run_passes([grow, grow], 3, options, lambda by, n: by * n, more)
    12
    >>> [change.gain for run in heard for change in run.changes]
    [3.0, 6.0]
    """
    for each in passes:
        if options.cancelled():
            break
        if each.name in options.off or each.group in options.off:
            continue
        begun = time.thread_time()
        after = apply(each.run, state)
        if options.hear is not None:
            seconds = time.thread_time() - begun
            options.hear(PassRun(each.name, seconds, tuple(compare(state, after))))
        if show is not None:
            show(f"{each.name}: {each.purpose}", state, after)
        state = after
    return state


def tally_passes(passes: Iterable[Pass[Run]], runs: Sequence[PassRun]) -> tuple[PassTally, ...]:
    """What the runs of each pass came to, in the order of the table, spaces in that of their names.

    >>> rows = [Pass("a", "g", None, "first"), Pass("b", "g", None, "second")]
    >>> runs = [PassRun("b", 0.5, (PassChange("hall", 2.0, 1.0, 0),)), PassRun("b", 0.25, ())]
    >>> [(t.name, t.runs, t.spaces, t.gain, t.seconds) for t in tally_passes(rows, runs)]
    [('a', 0, (), 0, 0), ('b', 2, ('hall',), 2.0, 0.75)]
    """
    return tuple(_tally(each, [run for run in runs if run.name == each.name]) for each in passes)


def trace_passes(
    passes: Iterable[Pass[Run]], solve: Callable[..., Solution], solution: Solution, plan: Plan
) -> PassTrace:
    """What each pass changes when the brief of a solution is solved again (``solve``) with its
    preset, solver and seed; every run counts, in drafts and further tries too."""
    heard = list[PassRun]()
    again = solve(
        solution.brief,
        plan=plan,
        preset=solution.preset,
        solver=solution.solver,
        seed=solution.seed,
        passes=PassOptions(hear=heard.append),
    )
    return PassTrace(tally_passes(passes, heard), again.pieces == solution.pieces)


def _tally(each: Pass[Run], runs: Sequence[PassRun]) -> PassTally:
    changes = [change for run in runs for change in run.changes]
    return PassTally(
        each.name,
        each.group,
        each.purpose,
        len(runs),
        tuple(sorted({change.space for change in changes})),
        sum(change.gain for change in changes),
        sum(change.faults for change in changes),
        sum(change.pieces for change in changes),
        sum(run.seconds for run in runs),
    )
