"""Kitchen runs: units in a row along a wall, wall cabinets and hood above, and the fridge."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.least_sizes import CABINET, HOB, SINK
from scenewright.domains.home.measures import ROUNDING

UNIT_DEPTH, WORKTOP_HEIGHT = 0.6, 0.9
FRIDGE = Size(0.6, 0.64, 1.9)
WALL_CABINET_BASE = 1.45
BEYOND = 0.3  # worktop between a hob and the end of its run, metres
AMPLY_BEYOND = 0.35  # the same where it fits: one stands before it in a corner, metres
BETWEEN = 0.6  # worktop between sink and hob, metres
HOBS = (0.6, 0.45, HOB.width)  # of four rings, three and two, metres
FILLER, LEAST_FILLER = "filler_panel", 0.01
"""What closes a run where no cabinet has a place: a strip under the worktop; its least width in
metres."""
Unit = tuple[str, float]


def kitchen() -> Iterator[Group]:
    """Complete runs of 1.8 to 4.8 m: fridge, worktop, sink, worktop, hob, both ways round."""
    for width in np.arange(36, 97) / 20:
        units = sequence(float(width) - FRIDGE.width)
        yield _run("kitchen", float(width), units, fridge=True)
        yield _run("kitchen", float(width), units, fridge=True, mirrored=True)


def short_runs() -> Iterator[Group]:
    """Pantry kitchens, the longest first: fridge, sink and hob in 1.7 to 1.45 m, for rooms in which
    no longer run fits."""
    for width in (1.7, 1.6, 1.5, 1.45):
        units = sequence(width - FRIDGE.width)
        yield _run("kitchen", width, units, fridge=True)
        yield _run("kitchen", width, units, fridge=True, mirrored=True)


def shortest_kitchenettes() -> Iterator[Group]:
    """A sink of 0.6 or 0.5 m and two rings side by side, for rooms in which no longer run fits."""
    for width in (0.9, 0.8):
        yield _run("kitchenette", width, sequence(width), fridge=False)
        yield _run("kitchenette", width, sequence(width), fridge=False, mirrored=True)


def kitchenette() -> Iterator[Group]:
    """Runs of 1.0 to 3.0 m without a fridge, for rooms with no long wall."""
    for width in np.arange(20, 61) / 20:
        units = sequence(float(width))
        yield _run("kitchenette", float(width), units, fridge=False)
        yield _run("kitchenette", float(width), units, fridge=False, mirrored=True)


def long_kitchenettes() -> Iterator[Group]:
    """Runs of 3.1 to 3.6 m without a fridge, for large rooms."""
    for width in (3.1, 3.2, 3.4, 3.6):
        yield _run("kitchenette", width, sequence(width), fridge=False)
        yield _run("kitchenette", width, sequence(width), fridge=False, mirrored=True)


def counter() -> Iterator[Group]:
    """A second run: drawers and cupboards under a worktop."""
    for width in np.arange(24, 61) / 20:
        yield _run("counter", float(width), fill(float(width)), fridge=False)


def short_counters() -> Iterator[Group]:
    """Worktop beside a run that has little, 1.2 to 0.6 m, the longest first."""
    for width in (1.2, 0.9, 0.6):
        yield _run("counter", width, fill(width), fridge=False)


def fridge() -> Iterator[Group]:
    """A fridge on its own, full or small."""
    for width in (0.55, 0.6):
        piece = Member("fridge", 0, 0, 0, 0, Size(width, width + 0.04, 1.85))
        yield Group("fridge", "fridge", width, width + 0.05, (piece,))


def island() -> Iterator[Group]:
    """A kitchen island with two bar stools."""
    for width in (1.2, 1.6, 2.0):
        members = [Member("kitchen_island", 0, -0.2, 0, 0, Size(width, 0.8, 0.92))]
        members += [
            Member("bar_stool", x, 0.4, 0, np.pi, Size(0.4, 0.4, 0.7))
            for x in (-width / 4, width / 4)
        ]
        yield Group("island", f"{width:.1f} m island", width, 1.22, tuple(members))


def sequence(length: float) -> list[Unit]:
    """Units of a run of the given length from the fridge on: worktop, sink, worktop, hob, worktop.

    Kitchen planners ask for 0.6 m of worktop between sink and hob and 0.3 m beyond the hob. A run
    shorter than 2.4 m keeps them by a narrower sink, one shorter than 1.9 m by a hob of three or
    two rings; one under 1.7 m keeps 0.3 m on both sides of the hob, one under 1.4 m what there is
    between the two.
    """
    if length < 2.4:
        return _short_sequence(length)
    sink, hob = 0.8, 0.6
    rest = length - sink - hob
    washer: list[Unit] = [("dishwasher", 0.6)] if rest >= 0.9 else []
    rest -= 0.6 * len(washer)
    before = fill(rest * 0.3) if rest >= 1.2 else []
    after = fill(_beyond(rest))
    used = sum(w for _, w in before + after)
    return [
        *before,
        ("sink_cabinet", sink),
        *washer,
        *fill(rest - used),
        ("hob_cabinet", hob),
        *after,
    ]


def _short_sequence(length: float) -> list[Unit]:
    """Sink and hob as wide as the worktop beside the hob allows."""
    small = SINK.width + HOB.width
    if length < small + BEYOND - ROUNDING:
        return [("sink_cabinet", length - HOB.width), ("hob_cabinet", HOB.width)]
    hob, sink = widest_hob(length - SINK.width - BETWEEN - BEYOND), SINK.width
    beyond = BEYOND if length >= small + 2 * BEYOND - ROUNDING else 0.0
    spare = max(length - hob - BETWEEN - BEYOND - sink, 0.0)
    if spare >= AMPLY_BEYOND - BEYOND - ROUNDING:
        beyond, spare = AMPLY_BEYOND, spare - (AMPLY_BEYOND - BEYOND)
    sink += min(spare, 0.6 - sink)
    run = [("sink_cabinet", sink), *fill(length - sink - hob - beyond), ("hob_cabinet", hob)]
    return [*run, *fill(beyond)]


def widest_hob(length: float) -> float:
    """The width of the hob with most rings in ``length`` metres, that of two where none fits.

    >>> widest_hob(0.7), widest_hob(0.5), widest_hob(0.2)
    (0.6, 0.45, 0.3)
    """
    return next((wide for wide in HOBS if wide <= length + 1e-9), HOB.width)


def _beyond(rest: float) -> float:
    """How much of the worktop beside a dishwasher lies beyond the hob."""
    if rest < 2 * BEYOND - 1e-9:
        return rest
    ample = AMPLY_BEYOND if rest >= AMPLY_BEYOND + BEYOND - 1e-9 else BEYOND
    return max(ample, 0.2 * rest if rest >= 1.8 else 0.0)


def fill(length: float) -> list[Unit]:
    """Drawers and cupboards in turn, of equal width near 0.6 m; a strip where none has a place.

    >>> fill(0.2), [name for name, _ in fill(1.2)]
    ([('filler_panel', 0.2)], ['drawer_cabinet', 'base_cabinet'])
    """
    if length < CABINET.width - ROUNDING:
        return [(FILLER, length)] if length > LEAST_FILLER else []
    count = max(1, round(length / 0.6))
    kinds = ("drawer_cabinet", "base_cabinet")
    return [(kinds[i % 2], length / count) for i in range(count)]


def _run(
    function: str, width: float, units: list[Unit], *, fridge: bool, mirrored: bool = False
) -> Group:
    depth = FRIDGE.depth + 0.01 if fridge else UNIT_DEPTH + 0.01
    back = -depth / 2
    members: list[Member] = []
    x = -width / 2
    if fridge:
        y = back + FRIDGE.depth / 2
        members.append(Member("fridge", x + FRIDGE.width / 2, y, 0, 0, FRIDGE))
        x += FRIDGE.width
    for category, wide in units:
        at = x + wide / 2
        y = back + UNIT_DEPTH / 2
        members.append(Member(category, at, y, 0, 0, Size(wide, UNIT_DEPTH, WORKTOP_HEIGHT)))
        members += hang_above(category, at, wide, back)
        x += wide
    if mirrored:
        members = [m._replace(x=-m.x) for m in members]
    text = " with fridge" if fridge else ""
    return Group(function, f"{width:.1f} m kitchen run{text}", width, depth, tuple(members))


def hang_above(category: str, x: float, wide: float, back: float) -> list[Member]:
    """What hangs above a unit: a hood over a hob, nothing over a strip, else a wall cabinet."""
    if category == FILLER:
        return []
    if category == "hob_cabinet":
        return [Member("hood", x, back + 0.24, 1.55, 0, Size(wide, 0.48, 0.65))]
    if category == "sink_cabinet" and wide > 0.7:
        return [Member("wall_cabinet", x, back + 0.175, 1.45, 0, Size(wide, 0.35, 0.7))]
    return [Member("wall_cabinet", x, back + 0.175, WALL_CABINET_BASE, 0, Size(wide, 0.35, 0.7))]
