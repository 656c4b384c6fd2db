"""Whether the main seat is before its screen, in living rooms of real flats.

Flats of Raster-to-Vector in the order of the SHA-256 of their ids, furnished with the default
preset and seed 0: how far the screen is aside of the main seat's axis. The baseline has distance,
angle and bearing of seat and screen in one relation, as the paper's pairs have, and leaves the
screen where the search left it. ``scenewright bench home_axis``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from hashlib import sha256
from math import cos, pi, sin
from typing import Any

import numpy as np

from benchmarks.plans_r2v import adapt, raw_plans
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains import solve
from scenewright.domains.home import build_problem as pose
from scenewright.domains.home.furnishing import facing

Record = dict[str, Any]
Progress = Callable[[float, str], None]
FLATS, QUICK = 270, 100
FAR = 0.3
SEATS = ("sofa", "corner_sofa", "loveseat")
ONE = tuple(
    pose.Relation(first, second, 2.5, pi, 0.0, 3.0)
    for first, second in (("seating", "media"), ("media", "seating"))
)


def records(quick: bool = False, progress: Progress | None = None) -> list[Record]:
    """Share of rooms off the axis, the median, other costs and what is left out, both ways."""
    briefs = list(flats(QUICK if quick else FLATS))
    usual, off = pose.RELATIONS, facing.OFF
    ours = _measured(briefs, progress, 0.0)
    try:
        others = (r for r in usual if {r.first, r.second} != {"seating", "media"})
        pose.RELATIONS = (*ONE, *others)
        facing.OFF = 0.0
        theirs = _measured(briefs, progress, 0.5)
    finally:
        pose.RELATIONS, facing.OFF = usual, off
    return [
        Record(
            case="living rooms",
            metric=name,
            unit=unit,
            ours=round(value, 3),
            baseline=round(theirs[name][0], 3),
            baseline_name="one relation",
            ratio=round(value / theirs[name][0], 2) if theirs[name][0] else 1.0,
            runs=count,
        )
        for name, (value, unit, count) in ours.items()
    ]


def flats(count: int) -> Iterator[Brief]:
    """Of the first flats of the list those that can be built and have a living room."""
    for raw in sorted(raw_plans(), key=lambda plan: sha256(plan["id"].encode()).hexdigest())[
        :count
    ]:
        brief = adapt(raw).brief
        if brief is not None and any("living" in space.functions for space in spaces(brief)):
            yield brief


def _measured(
    briefs: list[Brief], progress: Progress | None, start: float
) -> dict[str, tuple[float, str, int]]:
    off: list[float] = []
    rest: list[float] = []
    out = 0
    for number, brief in enumerate(briefs):
        if progress:
            progress(start + number / len(briefs) / 2, brief.name)
        home = solve(brief, seed=0)
        out += sum(one.required for one in home.left_out)
        for space, aside in asides(home):
            off.append(aside)
            costs = (t.cost for t in home.terms if t.space == space and t.term != "pairs")
            rest.append(sum(costs))
    far = float(np.mean(np.array(off) > FAR))
    return {
        f"seat more than {FAR} m off the screen's axis": (far, "share", len(off)),
        "off the axis, mean": (float(np.mean(off)), "m", len(off)),
        "all costs but pairs, median": (float(np.median(rest)), "cost", len(off)),
        "essential groups left out": (float(out), "groups", len(briefs)),
    }


def asides(home: Solution) -> Iterator[tuple[str, float]]:
    """Rooms with a seat and a screen, and how far the screen is aside of the seat's axis."""
    for space in sorted({p.space for p in home.pieces if p.function == "media"}):
        here = [p for p in home.pieces if p.space == space]
        seats = [p for p in here if p.category in SEATS and p.function == "seating"]
        screen = next((p for p in here if p.category == "tv"), None)
        if seats and screen:
            yield space, _aside(max(seats, key=lambda p: p.size.width * p.size.depth), screen)


def _aside(seat: Piece, screen: Piece) -> float:
    dx, dy = screen.pose.x - seat.pose.x, screen.pose.y - seat.pose.y
    return abs(dx * sin(seat.pose.heading) - dy * cos(seat.pose.heading))


if __name__ == "__main__":
    for row in records():
        told = f"{row['metric']:48} {row['ours']:8.3f} {row['baseline']:8.3f}"
        print(f"{told} {row['unit']} ({row['runs']})")
