"""What is wrong with a case wherever it stands: little worktop, one nightstand, half a wardrobe.

Each fault has a degree from 0 (none) to 1. Kitchen planners ask for 0.6 m of worktop in one piece,
0.3 m between sink and hob and 0.3 m on both sides of a hob; a wardrobe holds the clothes of a
person from a metre on; a bed for two has a nightstand on either side.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import takewhile

from scenewright.core.catalog import Group, Member

Faults = dict[str, float]

WORKTOP = frozenset(("base_cabinet", "drawer_cabinet", "corner_cabinet", "dishwasher"))
RUN = WORKTOP | {"sink_cabinet", "hob_cabinet", "fridge"}
RAISED = 0.3  # what begins so high is no unit of a run, metres
AMPLE, BESIDE = 0.6, 0.3  # worktop in one piece, and beside a hob, metres
MANY = 3  # seats of a room that is roomy
SOFA_OF_THREE = 1.9  # width of a sofa for three, metres
FULL = 1.0  # width of a wardrobe, metres
HAIR = 1e-6


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
        return [("wardrobe", max(0.0, 1.0 - case.width / FULL))]
    if case.function == "sleeping":
        stands = sum(member.category == "nightstand" for member in case.members)
        return [("nightstand", 1.0 - min(stands, 2) / 2), ("one_side", float(stands < 2))]
    if case.function == "seating":
        return [("seats", float(_seats(case) < MANY))]
    return []


def _seats(case: Group) -> int:
    places = {"armchair": 1, "loveseat": 2, "corner_sofa": 4}
    return sum(
        places.get(m.category, 3 if m.size.width >= SOFA_OF_THREE else 2)
        for m in case.members
        if m.category == "sofa" or m.category in places
    )


def _of_kitchen(members: tuple[Member, ...]) -> list[tuple[str, float]]:
    """Shortfalls of worktop of a run; a sink in the wing round the corner is far enough."""
    row = sorted((m for m in members if _is_in_run(m)), key=lambda m: m.x)
    names = [m.category for m in row]
    if "hob_cabinet" not in names:
        return []
    hob = names.index("hob_cabinet")
    sink = names.index("sink_cabinet") if "sink_cabinet" in names else -1
    between = BESIDE
    if sink >= 0:
        between = sum(m.size.width for m in row[min(hob, sink) + 1 : max(hob, sink)])
    beside = min(_worktop(row[hob + 1 :]), _worktop(row[:hob][::-1]))
    longest = max(_worktop(row[i:]) for i in range(len(row)))
    return [
        ("worktop", max(0.0, 1.0 - longest / AMPLE)),
        ("hob_at_sink", max(0.0, 1.0 - between / BESIDE)),
        ("hob_at_end", max(0.0, 1.0 - beside / BESIDE)),
    ]


def _is_in_run(member: Member) -> bool:
    straight = abs(member.heading) < HAIR or member.category == "corner_cabinet"
    return member.category in RUN and member.z < RAISED and straight


def _worktop(row: list[Member]) -> float:
    """Metres of worktop a row begins with."""
    return sum(m.size.width for m in takewhile(lambda m: m.category in WORKTOP, row))
