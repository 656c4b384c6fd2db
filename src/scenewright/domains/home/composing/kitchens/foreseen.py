"""What a kitchen made to measure will cost, told from its lines before its units are laid out."""

from __future__ import annotations

from functools import lru_cache
from itertools import combinations, takewhile
from math import hypot, inf
from typing import NamedTuple

from scenewright.domains.home.composing.case_faults import AMPLE, BESIDE, LEG, WORKTOP
from scenewright.domains.home.composing.forms import FROM
from scenewright.domains.home.composing.modest import CORNER_RUN, EXPECTED
from scenewright.domains.home.groups.fitted_kitchen import BACK, LOW, FittedKitchen, UnitLine, place
from scenewright.domains.home.groups.kitchen import FRIDGE, UNIT_DEPTH, Unit
from scenewright.domains.home.settings import ComposingSettings

STATIONS = {"sink_cabinet": 0, "hob_cabinet": 1, "fridge": 2, LOW: 2}


class LineFacts(NamedTuple):
    """Metres of worktop of a line: the longest piece, on either side of the hob, and between hob
    and sink; infinite where the line has none."""

    longest: float
    before: float
    after: float
    between: float


def foresee_cost(kitchen: FittedKitchen, area: float, rule: ComposingSettings) -> float:
    """What its case will cost in a room of ``area`` square metres, nearly: faults of worktop, of
    the triangle, and what it is short of for its room."""
    facts = [_facts_of(line.units) for line in kitchen.lines]
    cooks, costs = facts[0], rule.costs
    beside = min(cooks.before, cooks.after)
    longest = max(f.longest for f in facts)
    if kitchen.corners:
        beside, longest = max(cooks.before, cooks.after), inf
    found = [
        (costs.worktop, 1.0 - longest / AMPLE),
        (costs.hob_at_end, 1.0 - beside / BESIDE),
        (costs.hob_at_sink, 1.0 - cooks.between / BESIDE),
        (costs.triangle, _off_triangle(kitchen) if area >= FROM["triangle"] else 0.0),
    ]
    fronts = sum(w for line in kitchen.lines for _, w in line.units)
    fronts += CORNER_RUN * len(kitchen.corners)
    rows = EXPECTED["kitchen"].rows
    least = max((metres for start, metres in rows if area >= start), default=0.0)
    short = max(0.0, 1.0 - fronts / least) if least else 0.0
    faults = sum(cost * (1.0 + degree) / 2 for cost, degree in found if degree > 1e-6)
    return faults + costs.modest * short


@lru_cache(maxsize=4096)
def _facts_of(units: tuple[Unit, ...]) -> LineFacts:
    names = [name for name, _ in units]
    longest = max(_worktop(units[i:]) for i in range(len(units)))
    if "hob_cabinet" not in names:
        return LineFacts(longest, inf, inf, inf)
    hob, between = names.index("hob_cabinet"), inf
    if "sink_cabinet" in names:
        ends = sorted((hob, names.index("sink_cabinet")))
        between = sum(w for _, w in units[ends[0] + 1 : ends[1]])
    return LineFacts(longest, _worktop(units[:hob][::-1]), _worktop(units[hob + 1 :]), between)


def _worktop(units: tuple[Unit, ...]) -> float:
    """Metres of worktop some units begin with."""
    return sum(wide for _, wide in takewhile(lambda unit: unit[0] in WORKTOP, units))


def _off_triangle(kitchen: FittedKitchen) -> float:
    """What the legs between sink, hob and fridge are off, as a share; of those in one line more."""
    places: dict[int, tuple[float, float]] = {}
    lines: dict[int, UnitLine] = {}
    for line in kitchen.lines:
        at = line.start
        for name, wide in line.units:
            if name in STATIONS:
                deep = FRIDGE.depth if name == "fridge" else UNIT_DEPTH
                places[STATIONS[name]] = place(line.wall, at, wide, deep, BACK)[:2]
                lines[STATIONS[name]] = line
            at += wide
    legs = [hypot(a[0] - b[0], a[1] - b[1]) for a, b in combinations(places.values(), 2)]
    off = sum(max(1.0 - leg / LEG[0], leg / LEG[1] - 1.0, 0.0) for leg in legs)
    inline = len({line.wall for line in lines.values()}) == 1
    return min(1.0, (off + float(inline)) / 4)
