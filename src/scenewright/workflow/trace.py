"""The trace of a run as JSON Lines: what was run, then every step that its solver told."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from scenewright.core.atomic_file import whole_together
from scenewright.core.solution import Solution
from scenewright.engine.trace import Step


def trace_lines(solution: Solution, steps: Iterable[Step]) -> Iterator[str]:
    """A line that says what was run, and one a step: its space, kind and number, then its facts.
    The steps of a space follow one another as they were told, whatever the number of threads."""
    keys = ("preset", "solver", "seed", "evaluations", "version", "brief_hash")
    domain = {"kind": "run", "domain": solution.brief.domain}
    yield json.dumps(domain | {key: getattr(solution, key) for key in keys})
    told = list(steps)
    places = {space: k for k, space in enumerate(sorted({step.space for step in told}))}
    for step in sorted(told, key=lambda one: places[one.space]):
        head = {"space": step.space, "kind": step.kind, "number": step.number}
        yield json.dumps(head | dict(step.facts), ensure_ascii=False)


def write_trace(path: Path, solution: Solution, steps: Sequence[Step]) -> None:
    """Write the trace of a solution to a file, whole or not at all."""
    with whole_together([path]) as (partial,):
        partial.write_text("".join(f"{line}\n" for line in trace_lines(solution, steps)), "utf-8")
