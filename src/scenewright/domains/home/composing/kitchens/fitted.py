"""Kitchens made to measure for a room: systematically along its walls, from simple to split.

Each step lists kitchens of one make-up over all free stretches of wall: one run with its fridge,
two or three lines round corners (L and U); the same with the fridge apart; hob and sink in lines
of their own. A line takes its stretch up to what the room asks for, or the least without a fault.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import chain, product
from math import hypot, inf
from typing import NamedTuple

from scenewright.domains.home.composing.case_faults import LEG
from scenewright.domains.home.composing.kitchens.corners import list_round_corners, list_us
from scenewright.domains.home.composing.kitchens.free_walls import (
    AT_CORNER,
    KitchenStretch,
    end_of,
    floor_length,
)
from scenewright.domains.home.composing.modest import EXPECTED
from scenewright.domains.home.groups.fitted_kitchen import (
    CORNER,
    SLIM_FRIDGE,
    FittedKitchen,
    UnitLine,
    cook,
    cook_and_wash,
    middle_of,
    wash,
    width_of,
    width_of_line,
)
from scenewright.domains.home.groups.kitchen import BEYOND, FRIDGE, Unit, fill
from scenewright.domains.home.groups.low_fridges import LOW, SHORTEST, WIDE_FRIDGE, pantry, take_in
from scenewright.domains.home.least_sizes import SINK

MORE = 3.0  # metres of front that a mere kitchen has beyond what its room asks for, at most
LIVED_IN_TOP = 0.4  # the same where people live in the room as well
LEAST_RUN = 3.0  # metres of front with its fridge that a run in any room may have
LEAST = {"hs": 1.7, "h": 0.95, "s": SINK.width, "": 0.6}
"""Metres that sink and hob take at least without a fault beside them, by what a line holds."""
AMPLY = LEAST | {"h": 1.2, "s": 1.1}
"""And with 0.6 m of worktop in one piece."""
SPARE = {"hs": 0.8, "h": 0.75, "s": SINK.width, "": 0.6}
"""And where room for no more is left."""
PANTRY = 1.6
"""A run shorter than this that takes in its fridge has too little worktop beside its hob."""
LANDED = 2.4
"""Metres of a run that leave worktop between its fridge and its sink as well."""
FACING = -0.995  # cosine of the angle between walls that face each other
U_FROM = 8.0
"""Area in m² from which a kitchen goes round two corners."""
ALONE_BELOW = 8.0
"""Area in m² from which no sink stands alone at a wall, without worktop to put a plate on."""
Units = tuple[Unit, ...]


class FreeWalls(NamedTuple):
    """Where units stand free (``low``), and where what is as tall as a fridge does, in a room of
    ``area`` square metres; a kitchen in it has at most ``more`` metres of front than it asks for,
    ``longest`` in any case, and may leave ``machine`` metres of a wall to a washing machine."""

    low: list[KitchenStretch]
    tall: list[KitchenStretch]
    area: float
    more: float = MORE
    longest: float = inf
    machine: float = 0.0


def list_steps(free: FreeWalls) -> list[Callable[[], Iterator[FittedKitchen]]]:
    """The kitchens of a room step by step."""
    most = _most(free) / 2
    us = list_us(free.low, most) if free.area >= U_FROM else ()
    return [
        lambda: chain(_runs(free), list_round_corners(free.low, most, True, free.machine), us),
        lambda: _with_fridge(
            free, chain(_bare_runs(free), list_round_corners(free.low, most, False))
        ),
        lambda: chain(_apart(free, True), _with_fridge(free, _apart(free, False))),
        lambda: chain(
            _pantries(free),
            _taking_in(chain(_bare_runs(free), list_round_corners(free.low, most, False))),
            _with_low_fridge(free, chain(_bare_runs(free), _apart(free, False))),
            _taking_in(filter(_faces, _apart(free, False))),
        ),
    ]


def list_bare_steps(free: FreeWalls) -> list[Callable[[], Iterator[FittedKitchen]]]:
    """The same of kitchens without a fridge."""
    most = _most(free) / 2
    return [
        lambda: chain(_bare_runs(free), list_round_corners(free.low, most, False)),
        lambda: _apart(free, False),
    ]


def _most(free: FreeWalls) -> float:
    """Metres of front a kitchen has at most."""
    asked = (least for start, least in EXPECTED["kitchen"].rows if free.area >= start)
    return min(free.longest, free.more + max(asked, default=LEAST_RUN))


def _units_in(holds: str, length: float) -> Units:
    """What stands in a line of units for these things."""
    if holds == "hs":
        return tuple(cook_and_wash(length))
    if holds == "":
        return tuple(fill(length))
    return tuple(cook(length) if holds == "h" else wash(length))


def _lengths(holds: str, spare: float, most: float) -> list[float]:
    """The lengths in which a line is tried: all there is up to ``most``, and the least."""
    full = floor_length(min(spare, most))
    found = [full] if full >= SPARE[holds] else []
    return [*found, LEAST[holds]] if full >= LEAST[holds] + 0.3 else found


def _fridge(spare: float, holds: str) -> Unit:
    """The fridge of a line: a slim one where a wider one takes the worktop."""
    wide = FRIDGE.width if spare >= AMPLY[holds] + FRIDGE.width else SLIM_FRIDGE
    return ("fridge", wide)


def _lines(stretch: KitchenStretch, units: Units) -> Iterator[UnitLine]:
    """The units at either end of a stretch, both ways round."""
    wide = width_of(units)
    starts = {stretch.start, stretch.end - wide}
    for start, order in product(sorted(starts), dict.fromkeys((units, units[::-1]))):
        yield UnitLine(stretch.wall, start, order)


def _runs(free: FreeWalls) -> Iterator[FittedKitchen]:
    """One run with its fridge at either end."""
    for stretch in free.low:
        spare = stretch.end - stretch.start
        fridge = _fridge(spare, "hs")
        for length in _lengths("hs", spare - fridge[1], _most(free) - fridge[1]):
            units = _units_in("hs", length)
            rows = [units, units[::-1], *_landing(length)]
            for whole in ((fridge, *row) for row in rows):
                yield from (FittedKitchen((line,)) for line in _lines(stretch, whole))


def _landing(length: float) -> Iterator[Units]:
    """Sink and hob with worktop on either side of the sink, where nothing else falls short for it:
    what comes out of a fridge beside it is put down there (NKBA, Planning Guidelines, 2012, 16)."""
    if length >= LANDED:
        yield (*fill(BEYOND), *_units_in("hs", length - BEYOND))


def _bare_runs(free: FreeWalls) -> Iterator[FittedKitchen]:
    for stretch in free.low:
        for length in _lengths("hs", stretch.end - stretch.start, _most(free) - FRIDGE.width):
            for line in _lines(stretch, _units_in("hs", length)):
                yield FittedKitchen((line,))


def _with_fridge(free: FreeWalls, kitchens: Iterable[FittedKitchen]) -> Iterator[FittedKitchen]:
    """Kitchens with a fridge apart at either end of any stretch tall enough, or beside their
    own lines."""
    for kitchen in kitchens:
        for stretch in free.tall:
            for start, end in _left_beside(kitchen, stretch):
                wide = FRIDGE.width if end - start >= FRIDGE.width else SLIM_FRIDGE
                if end - start < wide:
                    continue
                for at in sorted({start, end - wide}):
                    line = UnitLine(stretch.wall, at, (("fridge", wide),))
                    yield FittedKitchen((*kitchen.lines, line), kitchen.corners)


def _with_low_fridge(free: FreeWalls, kitchens: Iterable[FittedKitchen]) -> Iterator[FittedKitchen]:
    """Kitchens with a fridge as low as the worktop, as below a window, at an end of any stretch."""
    for kitchen in kitchens:
        for stretch in free.low:
            for start, end in _left_beside(kitchen, stretch):
                wide = WIDE_FRIDGE if end - start >= WIDE_FRIDGE else SLIM_FRIDGE
                for at in sorted({start, end - wide}):
                    line = UnitLine(stretch.wall, at, ((LOW, wide),))
                    yield FittedKitchen((*kitchen.lines, line), kitchen.corners)


def _pantries(free: FreeWalls) -> Iterator[FittedKitchen]:
    """Short runs with their fridge under the worktop."""
    for stretch in free.low:
        spare = floor_length(stretch.end - stretch.start)
        for length in (spare,) if SHORTEST <= spare < PANTRY else ():
            for line in _lines(stretch, tuple(pantry(length))):
                yield FittedKitchen((line,))


def _taking_in(kitchens: Iterable[FittedKitchen]) -> Iterator[FittedKitchen]:
    """Kitchens with their fridge under the worktop of the first line that can take it in."""
    for kitchen in kitchens:
        for k, line in enumerate(kitchen.lines):
            units = take_in(line.units)
            if units is not None:
                lines = (*kitchen.lines[:k], line._replace(units=units), *kitchen.lines[k + 1 :])
                yield kitchen._replace(lines=lines)
                break


def _left_beside(kitchen: FittedKitchen, stretch: KitchenStretch) -> list[tuple[float, float]]:
    """What the lines and corners of a kitchen leave of a stretch."""
    taken = [
        (line.start, line.start + width_of_line(line.units))
        for line in kitchen.lines
        if line.wall == stretch.wall
    ]
    for wall in kitchen.corners:
        if wall == stretch.wall:
            taken.append((0.0, CORNER))
        elif abs(end_of(stretch)[0] - wall.x) + abs(end_of(stretch)[1] - wall.y) < AT_CORNER:
            taken.append((stretch.length - CORNER, stretch.length))
    gaps, at = [], stretch.start
    for start, end in sorted(taken):
        gaps.append((at, min(start, stretch.end)))
        at = max(at, end)
    gaps.append((at, stretch.end))
    return [(a, b) for a, b in gaps if b - a >= SLIM_FRIDGE]


def _apart(free: FreeWalls, whole: bool) -> Iterator[FittedKitchen]:
    """Hob and sink in lines of their own, the fridge at an end of one if it is to be ``whole``."""
    for one, other in product(free.low, free.low):
        if one is other:
            continue
        for cold in (0, 1) if whole else (-1,):
            lines = [
                _ends(stretch, holds, k == cold, _most(free) / 2)
                for k, (stretch, holds) in enumerate(((one, "h"), (other, "s")))
            ]
            for pair in product(*lines):
                alone = len(pair[1].units) == 1 and free.area >= ALONE_BELOW
                if not alone and _within_reach(*pair):
                    yield FittedKitchen(pair)


def _within_reach(cooking: UnitLine, washing: UnitLine) -> bool:
    """Whether the sink is no farther from the hob than a leg of the work triangle may be."""
    one, other = middle_of(cooking, "hob_cabinet"), middle_of(washing, "sink_cabinet")
    return hypot(one[0] - other[0], one[1] - other[1]) <= LEG[1]


def _faces(kitchen: FittedKitchen) -> bool:
    """Whether its two lines face each other."""
    one, other = (line.wall for line in kitchen.lines)
    return one.ux * other.ux + one.uy * other.uy < FACING


def _ends(stretch: KitchenStretch, holds: str, cold: bool, most: float) -> list[UnitLine]:
    """One line, as long as it can be, at either end of its stretch."""
    spare = stretch.end - stretch.start
    fridge: Units = (_fridge(spare, holds),) if cold else ()
    spare -= width_of(fridge)
    found = []
    for length in _lengths(holds, spare, most)[:1]:
        units = (*fridge, *_units_in(holds, length))
        found += [
            UnitLine(stretch.wall, stretch.start, units),
            UnitLine(stretch.wall, stretch.end - width_of(units), units[::-1]),
        ]
    return found
