"""Fridges under the worktop: short runs with one, and runs that take one in.

A pantry kitchen has its fridge under the worktop between sink and hob: so a run that a tall one
would leave without worktop keeps 0.6 m of it in one piece.
"""

from __future__ import annotations

from itertools import groupby

from scenewright.catalog.classes import PLAIN_CABINETS
from scenewright.domains.home.groups.kitchen import Unit, fill
from scenewright.domains.home.least_sizes import CABINET, HOB, SINK
from scenewright.domains.home.measures import ROUNDING

LOW = "low fridge"
"""The unit that is a fridge under the worktop."""
WIDE_FRIDGE, SLIM = 0.6, 0.5  # widths of fridges under a worktop, metres
FILLED = 0.05  # by which a fridge's place may be wider than it, metres
SHORTEST = SINK.width + SLIM + HOB.width
"""The shortest run with a fridge under its worktop, metres."""


def pantry(length: float) -> list[Unit]:
    """Sink, fridge and hob side by side under one worktop, what is left beyond the hob.

    >>> [(name, round(wide, 2)) for name, wide in pantry(1.5)]
    [('sink_cabinet', 0.6), ('low fridge', 0.6), ('hob_cabinet', 0.3)]
    """
    sink, hob = SINK.width, HOB.width
    cold = min(WIDE_FRIDGE, length - sink - hob)
    beyond = length - sink - cold - hob
    if beyond < CABINET.width - ROUNDING:
        sink, beyond = sink + beyond, 0.0
    return [("sink_cabinet", sink), (LOW, cold), ("hob_cabinet", hob), *fill(beyond)]


def take_in(units: tuple[Unit, ...]) -> tuple[Unit, ...] | None:
    """The units with a fridge under the longest piece of their worktop, away from the hob; None
    where none is as wide as a fridge.

    >>> take_in((("sink_cabinet", 0.5), ("drawer_cabinet", 0.6), ("hob_cabinet", 0.3)))
    (('sink_cabinet', 0.5), ('low fridge', 0.6), ('hob_cabinet', 0.3))
    """
    pieces = _find_storing(units) or [(k, k + 1, w) for k, (n, w) in enumerate(units) if n == WASH]
    start, end, wide = max(pieces, key=lambda piece: piece[2], default=(0, 0, 0.0))
    if wide < SLIM - ROUNDING:
        return None
    slim = SLIM + CABINET.width - ROUNDING <= wide < WIDE_FRIDGE + CABINET.width - ROUNDING
    cold = wide if wide <= WIDE_FRIDGE + FILLED else SLIM if slim else WIDE_FRIDGE
    part: list[Unit] = [(LOW, cold), *fill(wide - cold)]
    if start > 0 and units[start - 1][0] == "hob_cabinet":
        part.reverse()
    return (*units[:start], *part, *units[end:])


WASH = "dishwasher"


def _find_storing(units: tuple[Unit, ...]) -> list[tuple[int, int, float]]:
    """Where drawers and cupboards as wide as a fridge follow one another: first, end, metres."""
    found, at = [], 0
    for storing, group in groupby(units, key=lambda unit: unit[0] in PLAIN_CABINETS):
        held = list(group)
        wide = sum(w for _, w in held)
        if storing and wide >= SLIM - ROUNDING:
            found.append((at, at + len(held), wide))
        at += len(held)
    return found
