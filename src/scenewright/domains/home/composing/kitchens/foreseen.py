"""What a kitchen made to measure will cost, told from its lines before its units are laid out."""

from __future__ import annotations

from functools import lru_cache
from itertools import chain, combinations, pairwise, takewhile
from math import hypot, inf
from typing import NamedTuple

from scenewright.catalog.classes import WORKTOP
from scenewright.core.same import Same
from scenewright.domains.home.composing.case_faults import (
    FOUR_RINGS,
    FULL_SINK,
    HOB_TOP,
    LEG,
    ONE_LINE,
    TOP_IN_ONE,
    lie_across,
)
from scenewright.domains.home.composing.kitchens.fitted import FACING
from scenewright.domains.home.composing.modest import CORNER_RUN, EXPECTED
from scenewright.domains.home.composing.places.forms import share_in
from scenewright.domains.home.groups.fitted_kitchen import (
    BACK,
    CORNER,
    FittedKitchen,
    UnitLine,
    middle_of,
    point_at,
    width_of_line,
)
from scenewright.domains.home.groups.kitchen import FRIDGE, UNIT_DEPTH, Unit
from scenewright.domains.home.groups.low_fridges import LOW
from scenewright.domains.home.rules.kitchen import WHOLE_FROM
from scenewright.domains.home.settings import ComposingSettings, CompositionCosts

TOPS = WORKTOP | {LOW}
STATIONS = {"sink_cabinet": 0, "hob_cabinet": 1, "fridge": 2, LOW: 2}


class LineFacts(NamedTuple):
    """Metres of worktop of a line: the longest piece, on either side of the hob, and between hob
    and sink (infinite where the line has none), on the better side of the sink (``rinsed``); and
    the widths of its hob, of its sink (none where it has none) and of all its units."""

    longest: float
    before: float
    after: float
    between: float
    rinsed: float
    hob: float
    sink: float
    widths: tuple[float, ...]


def foresee_cost(
    kitchen: FittedKitchen, area: float, rule: ComposingSettings, most: float = inf
) -> float:
    """What its case will cost in a room of ``area`` square metres, nearly: faults of worktop, of
    the triangle, and what it is short of for its room; of what costs ``most`` or more only a part
    of that."""
    costs, lines = rule.costs, tuple([line.units for line in kitchen.lines])
    faults = _cost_of_units(lines, len(kitchen.corners), area, Same(costs))
    if faults >= most:
        return faults
    if _has_lone_fridge(kitchen):
        faults += costs.fridge_alone * share_in(area, "fridge_alone")
    split = _tell_split(kitchen)
    if split:
        faults += getattr(costs, split) * share_in(area, split)
    if area >= WHOLE_FROM:
        faults += costs.triangle * _off_triangle(kitchen)
    return faults


@lru_cache(maxsize=16384)
def _cost_of_units(
    lines: tuple[tuple[Unit, ...], ...], corners: int, area: float, by: Same[CompositionCosts]
) -> float:
    """What the units of a kitchen, by their lines, cost wherever they stand."""
    costs, units = by.value, _measure_units(lines, corners, area)
    faults = 0.0
    for name, share, degree in units.faults:
        faults += getattr(costs, name) * share * (1.0 + degree) / 2
    low = costs.low_fridge * share_in(area, "low_fridge") if units.low else 0.0
    return faults + low + costs.short_run * units.short


class UnitFaults(NamedTuple):
    """What the units of a kitchen have wrong wherever they stand: each fault with its share in a
    room of that size and its degree; whether a fridge is under the worktop; and which share of
    the front that the room asks for is missing."""

    faults: tuple[tuple[str, float, float], ...]
    low: bool
    short: float


def _measure_units(lines: tuple[tuple[Unit, ...], ...], corners: int, area: float) -> UnitFaults:
    """The same of units by their lines, the one with the hob first."""
    facts = [_facts_of(units) for units in lines]
    cooks = facts[0]
    beside = min(cooks.before, cooks.after)
    longest = max(f.longest for f in facts)
    if corners:
        beside, longest = max(cooks.before, cooks.after), inf
    rinsed = HOB_TOP if corners else max(f.rinsed for f in facts)
    sink = max(f.sink for f in facts)
    cold_sink = float(any(_has_cold_sink(units) for units in lines))
    found = (
        ("worktop", 1.0, 1.0 - longest / TOP_IN_ONE),
        ("hob_at_end", 1.0, 1.0 - beside / HOB_TOP),
        ("hob_at_sink", 1.0, 1.0 - cooks.between / HOB_TOP),
        ("few_rings", share_in(area, "few_rings"), 1.0 - cooks.hob / FOUR_RINGS),
        ("small_sink", share_in(area, "small_sink"), 1.0 - sink / FULL_SINK),
        ("sink_alone", share_in(area, "sink_alone"), 1.0 - rinsed / HOB_TOP),
        ("fridge_at_sink", share_in(area, "fridge_at_sink"), cold_sink),
    )
    fronts = sum(chain.from_iterable(f.widths for f in facts)) + CORNER_RUN * corners
    least = _least_front(area)
    short = max(0.0, 1.0 - fronts / least) if least else 0.0
    low = any(name == LOW for units in lines for name, _ in units)
    return UnitFaults(tuple(row for row in found if row[2] > 1e-6), low, short)


@lru_cache(maxsize=256)
def _least_front(area: float) -> float:
    """Metres of front that a room of ``area`` square metres asks for."""
    rows = EXPECTED["kitchen"].rows
    return max((metres for start, metres in rows if area >= start), default=0.0)


@lru_cache(maxsize=4096)
def _facts_of(units: tuple[Unit, ...]) -> LineFacts:
    names, widths, rinsed = [name for name, _ in units], tuple(wide for _, wide in units), 0.0
    wide = dict(units).get("sink_cabinet", 0.0)
    if "sink_cabinet" in names:
        sink = names.index("sink_cabinet")
        rinsed = max(_worktop(units[:sink][::-1]), _worktop(units[sink + 1 :]))
    longest = max(_worktop(units[i:]) for i in range(len(units))) if names != [LOW] else 0.0
    if "hob_cabinet" not in names:
        return LineFacts(longest, inf, inf, inf, rinsed, inf, wide, widths)
    hob, between = names.index("hob_cabinet"), inf
    if "sink_cabinet" in names:
        ends = sorted((hob, names.index("sink_cabinet")))
        between = sum(w for _, w in units[ends[0] + 1 : ends[1]])
    sides = _worktop(units[:hob][::-1]), _worktop(units[hob + 1 :])
    return LineFacts(longest, *sides, between, rinsed, units[hob][1], wide, widths)


def _worktop(units: tuple[Unit, ...]) -> float:
    """Metres of worktop some units begin with."""
    return sum(wide for _, wide in takewhile(lambda unit: unit[0] in TOPS, units))


def _line_of(kitchen: FittedKitchen, name: str) -> UnitLine:
    for line in kitchen.lines:
        for unit in line.units:
            if unit[0] == name:
                return line
    raise ValueError(name)


@lru_cache(maxsize=4096)
def _has_cold_sink(units: tuple[Unit, ...]) -> bool:
    """Whether a fridge stands hard at the sink."""
    return any({one[0], other[0]} == {"sink_cabinet", "fridge"} for one, other in pairwise(units))


def _has_lone_fridge(kitchen: FittedKitchen) -> bool:
    """Whether a fridge is a line of its own that continues no other."""
    for lone in kitchen.lines:
        if len(lone.units) == 1 and lone.units[0][0] in ("fridge", LOW):
            return not _is_continued(lone, kitchen)
    return False


def _is_continued(lone: UnitLine, kitchen: FittedKitchen) -> bool:
    """Whether another line or a corner begins or ends where a line does."""
    start, wall = lone.start, lone.wall
    end = start + width_of_line(lone.units)
    if wall in kitchen.corners and min(abs(start - CORNER), abs(end - CORNER)) <= ONE_LINE:
        return True
    for line in kitchen.lines:
        if line is not lone and line.wall == wall:
            after, before = line.start, line.start + width_of_line(line.units)
            if abs(end - after) <= ONE_LINE or abs(start - before) <= ONE_LINE:
                return True
    return False


def _tell_split(kitchen: FittedKitchen) -> str:
    """The fault of hob and sink in lines that do not meet in a corner: they face each other or do
    not even that; empty where there is none."""
    if kitchen.corners:
        return ""
    cooking, washing = _line_of(kitchen, "hob_cabinet"), _line_of(kitchen, "sink_cabinet")
    if cooking is washing:
        return ""
    if cooking.wall.ux * washing.wall.ux + cooking.wall.uy * washing.wall.uy >= FACING:
        return "split"
    one, other = middle_of(cooking, "hob_cabinet"), middle_of(washing, "sink_cabinet")
    off, ahead = (other[0] - one[0], other[1] - one[1]), (-cooking.wall.uy, cooking.wall.ux)
    return "across" if lie_across(off, ahead) else "split"


def _off_triangle(kitchen: FittedKitchen) -> float:
    """What the legs between sink, hob and fridge are off, as a share; of those in one line more."""
    places: dict[int, tuple[float, float]] = {}
    lines: dict[int, UnitLine] = {}
    for line in kitchen.lines:
        for number, at, out in _stations_of(line.units):
            places[number] = point_at(line.wall, line.start + at, out)
            lines[number] = line
    legs = [hypot(a[0] - b[0], a[1] - b[1]) for a, b in combinations(places.values(), 2)]
    off = sum(max(1.0 - leg / LEG[0], leg / LEG[1] - 1.0, 0.0) for leg in legs)
    inline = len({line.wall for line in lines.values()}) == 1
    return min(1.0, (off + float(inline)) / 4)


@lru_cache(maxsize=4096)
def _stations_of(units: tuple[Unit, ...]) -> tuple[tuple[int, float, float], ...]:
    """Sink, hob and fridge of a line by number: metres from where it begins to the middle of each,
    and from the wall."""
    found, at = [], 0.0
    for name, wide in units:
        if name in STATIONS:
            deep = FRIDGE.depth if name == "fridge" else UNIT_DEPTH
            found.append((STATIONS[name], at + wide / 2, BACK + deep / 2))
        at += wide
    return tuple(found)
