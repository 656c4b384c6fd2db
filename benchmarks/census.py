"""What designers' homes hold of each need: ``scenewright bench census``.

Six homes of Sweet Home 3D as their designers left them, none of which a number of the ledger was
fitted to: how much each holds of a need, by those who sleep there, beside what our table of needs
says that it owes. The column *ours* is the share of homes that hold what is owed, or how much they
hold for each resident or in all: the least, the median, the most.
"""

from __future__ import annotations

from collections.abc import Iterator
from statistics import median
from typing import Any, NamedTuple

from benchmarks.designer_rooms import files
from benchmarks.home_learned import list_furnished
from benchmarks.stages import Progress
from scenewright.domains.home.needs.ledger import NEARLY, describe_residence
from scenewright.domains.home.needs.table import NEEDS

Record = dict[str, Any]
EACH = frozenset(("beds", "places to eat", "soft seats", "clothes", "shelves"))
"""Needs that are owed to each resident."""


class Held(NamedTuple):
    """A need in one home: what is owed, what is there, and for how many."""

    owed: float
    held: float
    people: int


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """A record of each need and figure; ``quick`` of two homes."""
    homes: list[dict[str, Held]] = []
    for path in files()[: 2 if quick else 6]:
        if progress:
            progress(len(homes) / 6, path.stem)
        homes.append(count_home(list_furnished(path)))
    yield from tally_homes(homes)


def count_home(rooms: list[Any]) -> dict[str, Held]:
    """Each need of one home by its name."""
    people = int(sum(NEEDS[0].serve(room.pieces) for room in rooms))
    home = describe_residence([room.space for room in rooms], people)
    sums = {need.name: sum(need.serve(room.pieces) for room in rooms) for need in NEEDS}
    return {need.name: Held(need.owed(home), sums[need.name], people) for need in NEEDS}


def tally_homes(homes: list[dict[str, Held]]) -> Iterator[Record]:
    """Of each need the share of homes that hold it, and how much: least, median, most.

    >>> found = list(tally_homes([{"shelves": Held(0.8, 2.0, 2)}, {"shelves": Held(1.6, 1.2, 4)}]))
    >>> [(record["metric"], record["ours"]) for record in found]
    [('hold it', 0.5), ('least', 0.3), ('median', 0.65), ('most', 1.0)]
    """
    for name in homes[0]:
        rows = [home[name] for home in homes]
        kept = sum(row.held >= row.owed - NEARLY for row in rows) / len(rows)
        each = [row.held / (max(row.people, 1) if name in EACH else 1) for row in rows]
        figures = (kept, min(each), median(each), max(each))
        for metric, value in zip(("hold it", "least", "median", "most"), figures, strict=True):
            yield _record(name, metric, value, len(rows))


def _record(name: str, metric: str, value: float, runs: int) -> Record:
    per = " a resident" if name in EACH and metric != "hold it" else ""
    return {
        "case": f"{name}{per}",
        "metric": metric,
        "unit": "1",
        "ours": round(value, 2),
        "baseline": None,
        "baseline_name": "",
        "ratio": None,
        "runs": runs,
    }


def markdown_lines(found: list[Record]) -> list[str]:
    """A row a need.

    >>> markdown_lines(list(tally_homes([{"hob": Held(1.0, 1.0, 2)}])))[-1]
    '| hob | 1.0 | 1.0 | 1.0 | 1.0 |'
    """
    heads = "| need | homes that hold what is owed | least | median | most |"
    rows: dict[str, list[str]] = {}
    for record in found:
        rows.setdefault(record["case"].removesuffix(" a resident"), []).append(str(record["ours"]))
    named = {r["case"].removesuffix(" a resident"): r["case"] for r in found}
    return [
        heads,
        "|---|---|---|---|---|",
        *(f"| {named[name]} | {' | '.join(cells)} |" for name, cells in rows.items()),
    ]
