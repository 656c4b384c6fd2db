"""The passes of a solution's domain as a table: what each changed, and what it gained."""

from __future__ import annotations

from typing import Any

from rich.console import Console

from scenewright.cli.tables import print_json, print_line, table
from scenewright.core.passes import PassTally, PassTrace
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution

OTHER = "solved again it is another layout: it was edited, or made with other steps or options"


def print_passes(console: Console, solution: Solution, plan: Plan, as_json: bool = False) -> None:
    """Solve the brief of a solution again and write what each pass changed: rooms, by how much
    their cost and their faults fell, pieces more, processor's seconds."""
    from scenewright.domains import trace_passes

    trace = trace_passes(solution, plan)
    if as_json:
        print_json(make_document(trace))
        return
    table(console, [_row(tally) for tally in trace.tallies], "passes", right=("gain", "faults"))
    if not trace.same:
        print_line(console, OTHER, "dim")


def make_document(trace: PassTrace) -> dict[str, Any]:
    """A trace as plain values; ``same`` tells whether solving again gave the same layout."""
    return {"same": trace.same, "passes": [tally._asdict() for tally in trace.tallies]}


def _row(tally: PassTally) -> dict[str, Any]:
    return {
        "pass": tally.name,
        "group": tally.group,
        "runs": tally.runs,
        "changed": len(tally.spaces),
        "gain": f"{tally.gain:.1f}",
        "faults": f"{tally.faults:.1f}",
        "pieces": f"{tally.pieces:+d}",
        "seconds": f"{tally.seconds:.2f}",
        "what it is for": tally.purpose,
    }
