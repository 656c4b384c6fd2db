"""Tables out of the records of :mod:`.papers_home`."""

from __future__ import annotations

import statistics
from collections.abc import Iterator, Sequence
from typing import Any

from benchmarks.papers_home_rooms import BOXED

Record = dict[str, Any]
GA, SA, SA1, MERRELL = (
    "composite GA",
    "patch annealing, 8 moves an iteration",
    "patch annealing, 1 move an iteration",
    "furniture annealing",
)
EVALUATIONS, FEW, TIME = "ours, 4000 layouts", "ours, 545 layouts", "ours, as long as the GA"
HEADS = {
    GA: "composite GA",
    SA: "annealing, 8 moves",
    SA1: "annealing, 1 move",
    MERRELL: "single pieces",
    EVALUATIONS: EVALUATIONS,
    FEW: FEW,
    TIME: "ours, the GA's time",
}
BESIDE = {GA: EVALUATIONS, SA: EVALUATIONS, SA1: FEW, MERRELL: FEW}
"""What of ours looks at about as many layouts as each of the paper's methods, or at fewer."""


def markdown_lines(told: Sequence[Record]) -> Iterator[str]:
    """The costs by room and method, the paper's below; where ours is the lowest."""
    costs = {(r["case"], r["baseline_name"]): r for r in told if r["unit"] == "cost"}
    seconds = {(r["case"], r["baseline_name"]): r for r in told if r["unit"] == "s"}
    rooms = list(dict.fromkeys(row["case"] for row in told))
    yield "| room | " + " | ".join(HEADS.values()) + " |"
    yield "|---|" + "---|" * len(HEADS)
    for room in rooms:
        yield f"| {room} | " + " | ".join(show_spread(costs[room, n]) for n in HEADS) + " |"
    yield _printed("the paper, its room", [costs[rooms[0], name]["printed"] for name in HEADS])
    milli = (f"{1000 * seconds[rooms[0], name]['baseline']:.1f}" for name in HEADS)
    yield f"| milliseconds in {rooms[0]} | " + " | ".join(milli) + " |"
    yield _printed("the paper's seconds", [seconds[rooms[0], name]["printed"] for name in HEADS])
    yield ""
    yield from count_rooms([room for room in rooms if BOXED not in room], costs, seconds)


def show(value: float) -> str:
    """Three digits below a thousand, else whole numbers.

    >>> show(52.743), show(1849.2), show(12143.0)
    ('52.7', '1849', '12143')
    """
    return f"{value:.3g}" if value < 1000.0 else f"{value:.0f}"


def show_spread(row: Record) -> str:
    """Mean, least and most of a record."""
    return f"{show(row['baseline'])} ({show(row['least'])}–{show(row['most'])})"


def _printed(name: str, values: list[tuple[float, float, float] | None]) -> str:
    told = (f"{v[0]:g} ({v[1]:g}–{v[2]:g})" if v else "" for v in values)
    return f"| {name} | " + " | ".join(told) + " |"


def count_rooms(
    rooms: list[str], costs: dict[Any, Record], seconds: dict[Any, Record]
) -> Iterator[str]:
    """In how many rooms the mean of ours is below that of each method: at as many layouts, and
    in no more time."""
    for name, mine in BESIDE.items():
        there = [(costs[room, name]["baseline"], costs[room, mine]["baseline"]) for room in rooms]
        lower = sum(ours < theirs for theirs, ours in there)
        looked = [round(costs[rooms[0], n]["layouts"]) for n in (mine, name)]
        timed = (mine, *((TIME,) if name == GA else ()))
        quick = sum(
            any(
                costs[room, n]["baseline"] < costs[room, name]["baseline"]
                and seconds[room, n]["baseline"] <= seconds[room, name]["baseline"]
                for n in timed
            )
            for room in rooms
        )
        yield (
            f"* ours below {HEADS[name]}: in {lower} of {len(rooms)} rooms at as many layouts "
            f"({looked[0]}, and {looked[1]} in {rooms[0]}), in {quick} of {len(rooms)} in no "
            "more time;"
        )


def tell_designer(rows: Sequence[Record]) -> Iterator[str]:
    """What the furnished homes say."""
    ours = [row for row in rows if EVALUATIONS in row["metric"]]
    bred = [row for row in rows if EVALUATIONS not in row["metric"]]
    middle = [
        statistics.median(values)
        for values in (
            [row["baseline"] for row in ours],
            [row["ours"] for row in bred],
            [row["ours"] for row in ours],
        )
    ]
    better = [sum(row["ours"] <= row["baseline"] for row in some) for some in (bred, ours)]
    yield (
        f"In the {len(ours)} rooms of the furnished homes the median is {middle[0]:.1f} for the "
        f"designer, {middle[1]:.1f} for the composite GA and {middle[2]:.1f} for ours at 4000 "
        f"layouts. The GA's mean is no higher than the designer's in {better[0]} rooms, ours in "
        f"{better[1]}."
    )
