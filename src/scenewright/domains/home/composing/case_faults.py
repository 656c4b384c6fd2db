"""What is wrong with a case wherever it stands: little worktop, one nightstand, half a wardrobe.

Each fault has a degree from 0 (none) to 1. Kitchen planners ask for 0.6 m of worktop in one piece,
0.3 m between sink and hob and 0.3 m on both sides of a hob, of worktop beside the sink and of units
beside the fridge; a wardrobe holds the clothes of a person from a metre on; a bed for two has a
nightstand on either side, a table two chairs.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import combinations
from math import cos, hypot, pi, remainder, sin

from scenewright.catalog.assets.furniture.cooking import has_worktop
from scenewright.catalog.classes import RUN
from scenewright.core.catalog import Group, Member
from scenewright.domains.home.least_sizes import WARDROBE
from scenewright.domains.home.measures import HAIR, RAISED, SOFA_OF_THREE

Faults = dict[str, float]

TOP_IN_ONE, HOB_TOP = 0.6, 0.3  # worktop in one piece, and beside a hob, metres
FOUR_RINGS = 0.6  # width of a hob of four rings, metres
FULL_SINK = 0.6  # width of a sink for a household, metres
MANY = 3  # seats of a room that is roomy
FULL = 1.0  # width of a wardrobe, metres
LONG = 2.0  # a bed for two, metres
FULL_BED = 0.9  # a bed for one, metres
SLIM = 0.35  # a nightstand that is narrower leaves no way beside the bed, metres
ACROSS, PAST = 2.45, 1.2
"""Metres between hob and sink that face each other across an aisle, and by which one may lie past
the other along it."""
LONE_SINK = 6.0  # cost of a lone sink across from the hob, of one beside worktop
LEG = (1.2, 2.7)  # of a work triangle, metres
ONE_LINE, IN_LINE = 0.03, 0.3  # units nearer, and less far ahead, than this are in one line, metres
TURNED = 0.1  # units turned by more are not in one line, radians


@lru_cache(maxsize=4096)
def find_case_faults(case: Group) -> tuple[tuple[str, float], ...]:
    """The faults of a case with their degrees in ]0, 1].

    >>> from scenewright.domains.home.cases.library import cases
    >>> find_case_faults(cases("wardrobe").groups[0])
    (('wardrobe', 0.4),)
    """
    return tuple((name, degree) for name, degree in _faults(case) if degree > HAIR)


def _faults(case: Group) -> list[tuple[str, float]]:
    if case.function in ("kitchen", "kitchenette"):
        return _of_kitchen(case.members)
    if case.function == "wardrobe":
        deep = max(member.size.depth for member in case.members)
        return [
            ("wardrobe", max(0.0, 1.0 - case.width / FULL)),
            ("shallow", float(deep < WARDROBE.depth - HAIR)),
        ]
    if case.function == "sleeping":
        stands = [m.size.width for m in case.members if m.category == "nightstand"]
        narrow = sum(width < SLIM for width in stands) / 2
        one_side = max(narrow, float(len(stands) < 2))
        short = any(m.size.depth < LONG for m in case.members if m.category == "double_bed")
        return [
            ("nightstand", 1.0 - min(len(stands), 2) / 2),
            ("one_side", one_side),
            ("short_bed", float(short)),
        ]
    if case.function == "single":
        wide = min((m.size.width for m in case.members if m.category == "single_bed"), default=1.0)
        return [("narrow_bed", max(0.0, 1.0 - wide / FULL_BED))]
    if case.function == "seating":
        return [("seats", float(count_seats(case) < MANY))]
    if case.function == "media":
        return [("hung", float(is_hung(case)))]
    if case.function == "terrace":
        chairs = {m.heading for m in case.members if m.category == "outdoor_chair"}
        return [("abreast", float(len(chairs) == 1))]
    if case.function == "dining_wall":
        seats = [m.category for m in case.members if m.category in ("dining_chair", "stool")]
        turns = [round(m.heading, 2) for m in case.members if m.category == "dining_chair"]
        return [
            ("lone", float(len(seats) < 2)),
            ("stools", float("stool" in seats)),
            ("abreast_wall", float(len(turns) > 1 and len(set(turns)) == 1)),
        ]
    return []


def is_hung(case: Group) -> bool:
    """Whether a screen hangs on the wall over a shelf instead of standing."""
    return case.function == "media" and case.members[0].category == "wall_shelf"


def count_seats(case: Group) -> int:
    """Places on the sofas and armchairs of a case."""
    places = {"armchair": 1, "loveseat": 2, "corner_sofa": 4}
    return sum(
        places.get(m.category, 3 if m.size.width >= SOFA_OF_THREE else 2)
        for m in case.members
        if m.category == "sofa" or m.category in places
    )


def _of_kitchen(members: tuple[Member, ...]) -> list[tuple[str, float]]:
    """Shortfalls of worktop of the lines of a kitchen, and of its work triangle."""
    units = [m for m in members if (m.category in RUN or _is_top(m)) and m.z < RAISED]
    hob = next((m for m in units if m.category == "hob_cabinet"), None)
    sink = next((m for m in units if m.category == "sink_cabinet"), None)
    if hob is None:
        return []
    apart = HOB_TOP
    if sink is not None:
        apart = hypot(hob.x - sink.x, hob.y - sink.y) - (hob.size.width + sink.size.width) / 2
    beside = min(_worktop(hob, units, side) for side in (-1, 1))
    cold = [m for m in units if m.category == "fridge"]
    tops = (m for m in units if _is_top(m) and not (m in cold and _is_alone(m, units)))
    longest = max((m.size.width + _worktop(m, units, 1) for m in tops), default=0.0)
    return [
        ("worktop", max(0.0, 1.0 - longest / TOP_IN_ONE)),
        ("hob_at_sink", max(0.0, 1.0 - apart / HOB_TOP)),
        ("hob_at_end", max(0.0, 1.0 - beside / HOB_TOP)),
        ("few_rings", 1.0 - hob.size.width / FOUR_RINGS),
        ("triangle", _off_triangle(units)),
        ("sink_alone", 0.0 if sink is None else 1.0 - _longest_beside(sink, units) / HOB_TOP),
        (
            "fridge_at_sink",
            float(sink is not None and any(_meet(sink, m) for m in cold if not _is_top(m))),
        ),
        ("fridge_alone", float(any(_is_alone(m, units) for m in cold))),
        ("low_fridge", float(any(map(_is_top, cold)))),
        ("small_sink", 0.0 if sink is None else max(0.0, 1.0 - sink.size.width / FULL_SINK)),
        ("across", 0.0 if sink is None else _weigh_across(hob, sink, units)),
        ("split", float(sink is not None and _are_split(hob, sink, units))),
    ]


def _weigh_across(hob: Member, sink: Member, units: list[Member]) -> float:
    """What a sink across from the hob counts: more without worktop, with nowhere to put a plate."""
    if not _are_across(hob, sink, units):
        return 0.0
    return LONE_SINK if _is_alone(sink, units) else 1.0


def find_neighbour(unit: Member, units: list[Member], side: int) -> Member | None:
    """The unit that follows another in its line, to its right if ``side`` is +1."""
    return next((m for m in units if m is not unit and _touches(unit, m, side)), None)


def _longest_beside(unit: Member, units: list[Member]) -> float:
    """Metres of worktop on the better side of a unit, up to the hob."""
    return max(_worktop(unit, units, side) for side in (-1, 1))


def _is_alone(unit: Member, units: list[Member]) -> bool:
    """Whether no other unit follows in its line."""
    return not any(_meet(unit, m) for m in units if m is not unit)


def _are_across(hob: Member, sink: Member, units: list[Member]) -> bool:
    """Whether hob and sink are in lines that face each other across an aisle and are not joined."""
    return _do_face(hob, sink) and not _are_joined(hob, sink, units)


def _are_split(hob: Member, sink: Member, units: list[Member]) -> bool:
    """Whether hob and sink are in lines that neither are joined nor face each other across an
    aisle."""
    return not (_do_face(hob, sink) or _are_joined(hob, sink, units))


def _do_face(one: Member, other: Member) -> bool:
    turned = abs(remainder(one.heading - other.heading - pi, 2 * pi))
    ahead = -sin(one.heading), cos(one.heading)  # of a member, which looks along y unturned
    return turned < TURNED and lie_across((other.x - one.x, other.y - one.y), ahead)


def lie_across(off: tuple[float, float], ahead: tuple[float, float]) -> bool:
    """Whether a piece at offset ``off`` is across an aisle from one that looks ``ahead``, a step
    aside at most.

    >>> lie_across((1.8, 0.9), (1.0, 0.0)), lie_across((1.8, 1.5), (1.0, 0.0))
    (True, False)
    """
    return hypot(*off) <= ACROSS and abs(off[0] * ahead[1] - off[1] * ahead[0]) <= PAST


def _are_joined(one: Member, other: Member, units: list[Member]) -> bool:
    """Whether units without a gap lead from one to the other, round corners as well."""
    joined, edge = [one], [one]
    while edge:
        edge = [m for m in units if m not in joined and any(_meet(at, m) for at in edge)]
        joined += edge
    return other in joined


def _meet(one: Member, other: Member) -> bool:
    """Whether one of two units follows the other, round a corner as well."""
    return any(_touches(*two, side) for two in ((one, other), (other, one)) for side in (-1, 1))


def _is_top(unit: Member) -> bool:
    """Whether worktop lies on a unit: it does over a fridge no higher than that."""
    return has_worktop(unit.category, unit.size.height)


def _worktop(unit: Member, units: list[Member], side: int) -> float:
    """Metres of worktop that begin at one side of a unit, to its right if ``side`` is +1."""
    length, at = 0.0, unit
    while True:
        following = find_neighbour(at, units, side)
        if following is None or not _is_top(following):
            return length
        length, at = length + following.size.width, following


def _touches(one: Member, other: Member, side: int) -> bool:
    """Whether another unit follows in the same line; the top of a corner cabinet lies along two
    walls."""
    corner = "corner_cabinet" in (one.category, other.category)
    if abs(remainder(one.heading - other.heading, pi / 2 if corner else 2 * pi)) > TURNED:
        return False
    c, s = cos(one.heading), sin(one.heading)
    dx, dy = other.x - one.x, other.y - one.y
    along, ahead = side * (c * dx + s * dy), c * dy - s * dx
    gap = along - (one.size.width + other.size.width) / 2
    return abs(gap) < ONE_LINE and abs(ahead) < IN_LINE


def _off_triangle(units: list[Member]) -> float:
    """By how much sink, hob and fridge are off a work triangle, from 0 to 1: the mean of what each
    leg is off 1.2 to 2.7 m, as a share of the nearer, and of 1 where all three stand in one line.

    NKBA (Planning Guidelines, 2012, 5) asks for legs of 4 to 9 feet, 26 feet at most in all.
    """
    named = {m.category: m for m in units}
    if not named.keys() >= {"sink_cabinet", "hob_cabinet", "fridge"}:
        return 0.0
    ends = [named[name] for name in ("sink_cabinet", "hob_cabinet", "fridge")]
    legs = [hypot(a.x - b.x, a.y - b.y) for a, b in combinations(ends, 2)]
    off = [max(1.0 - leg / LEG[0], leg / LEG[1] - 1.0, 0.0) for leg in legs]
    inline = len({round(m.heading, 2) for m in ends}) == 1 and max(legs) > sum(legs) / 2 - IN_LINE
    return min(1.0, (sum(off) + float(inline)) / 4)
