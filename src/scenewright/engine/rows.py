"""The rows that every domain fills its tables with: solvers, terms, presets."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import cache
from importlib import import_module
from typing import Any, Generic, Literal, NamedTuple, TypeVar

from scenewright.core.errors import InputError
from scenewright.core.registry import load_added
from scenewright.engine.solve import Budget, Cancel, Found, Progress, Report

S = TypeVar("S")


class SolverRow(NamedTuple):
    """One solver: its name, what it is, whose idea it is and ``function``, its
    :data:`scenewright.engine.solve.Run` as ``"package.module:name"``, imported when first run.

    ``encoding`` names what it moves; ``adapter``, as ``"package.module:name"``, calls functions of
    another signature: ``adapter(function, problem, budget, seed, progress, cancel)``. A ``traced``
    one tells its steps to whom its budget names (:mod:`scenewright.engine.trace`).
    """

    name: str
    doc: str
    source: str
    function: str
    encoding: str = ""
    adapter: str = ""
    traced: bool = False

    def run(
        self,
        problem: Any,
        budget: Budget,
        seed: int = 0,
        progress: Progress | None = None,
        cancel: Cancel | None = None,
    ) -> Found[Any]:
        """Solve. ``progress`` is called with shares that never fall, and with 1 and the answer in
        the end; when ``cancel`` answers true, the best layout so far is the answer."""
        function, rising = load_function(self.function), RisingShare(progress)
        given = (problem, budget, seed, rising.hear if progress else None, cancel)
        found: Found[Any] = (
            load_function(self.adapter)(function, *given) if self.adapter else function(*given)
        )
        if not (cancel is not None and cancel()):
            rising.end(found.layouts[0])
        return found


def name_solvers(domain: str, rows: Sequence[SolverRow]) -> dict[str, SolverRow]:
    """The table of solvers of a domain by name, those of other packages last: entry points of
    ``scenewright.solvers``, ``"home.tabu" = "package.module:ROW"``."""
    every = (*rows, *load_added("scenewright.solvers", domain, SolverRow))
    return {row.name: row for row in every}


class TermRow(NamedTuple):
    """One term: ``name`` is what weights are given by (two forms of one term share it), ``number``
    its place in the vector of weights, ``kind`` what its value is of (one box or building, a pair,
    a group, zone or link, or the whole layout), its default ``weight``, what it says and whose idea
    it is. ``form`` tells of a term whether the paper's formula is ``printed`` or ``repaired``.
    ``per_area``: an area, divided by the summed area of all items. ``function`` is the compiled
    function, as "package.module:name", where the domain states it; a term with data of its own
    (:mod:`scenewright.engine.whole_terms`) names that of its ``data``, too."""

    name: str
    number: int
    kind: str
    weight: float
    doc: str
    source: str
    form: Literal["both", "printed", "repaired"] = "repaired"
    per_area: bool = False
    function: str = ""
    data: str = ""


@cache
def load_function(reference: str) -> Any:
    """What ``"package.module:name"`` names."""
    module, _, name = reference.partition(":")
    return getattr(import_module(module), name)


class RisingShare:
    """Passes reports on, with no share below one reported before."""

    def __init__(self, progress: Progress | None) -> None:
        self.progress, self.last = progress, Report(0.0, 0.0, tuple)

    def hear(self, report: Report) -> None:
        """Pass a report on."""
        self.last = report._replace(share=max(report.share, self.last.share))
        if self.progress is not None:
            self.progress(self.last)

    def end(self, answer: Any) -> None:
        """Report that all is done."""
        self.hear(self.last._replace(share=1.0, best=lambda: answer))


class Preset(NamedTuple, Generic[S]):
    """A named way of solving: what it is, the solver, the work in steps of that solver (``None``:
    what it does of itself), weights by name of the term, and ``settings``, what else steers the
    domain and its solvers."""

    doc: str
    solver: str
    steps: int | None
    weights: dict[str, float]
    settings: S


def preset_named(presets: Mapping[str, Preset[S]], name: str) -> Preset[S]:
    """The preset of a name; raises :class:`InputError` if there is none."""
    if name not in presets:
        raise InputError(f"unknown preset '{name}'", "one of " + ", ".join(presets))
    return presets[name]


GIVEN = "given"
"""What is in the place of the solver where a layout came from outside."""


def solver_again(solvers: Collection[str], name: str) -> str | None:
    """The solver a saved solution is solved by again: that it names; ``None``, that of its preset,
    where its layout came from outside. Raises :class:`InputError` if there is none of the name.

    >>> solver_again(["anneal"], "anneal"), solver_again(["anneal"], "given")
    ('anneal', None)
    """
    if name == GIVEN:
        return None
    if name not in solvers:
        raise InputError(f"unknown solver '{name}'", "one of " + ", ".join(solvers))
    return name
