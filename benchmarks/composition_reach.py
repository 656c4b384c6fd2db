"""How far the beds of real flats could go: ``scenewright bench composition_reach``.

Two rows of ``bench composition`` stay high: beds before a window and single beds away from walls.
In every room that has such a bed each place with its head, or a single one's long side, at a wall
is tried for it (or for the least bed of its kind) by :mod:`benchmarks.bed_places`: in the room as
if it were empty, there without any other fault of beds as well, there beside a wardrobe of a metre,
and beside all that stands. What no
place can be found for is a fault of the plan. The baseline is the number of rooms with the fault.
Of the same flats as ``bench composition`` (every fiftieth if quick), with ``--rescaled`` at their
true scale, too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

from benchmarks import stages
from benchmarks.bed_places import Case, find_beside_wardrobe, has_back, is_faulty, list_valid
from benchmarks.composition import QUICK, USUAL
from benchmarks.composition_faults import (
    Room,
    bed_adrift,
    before_window,
    count_standing,
    list_rooms,
)
from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.real_data import data_set
from benchmarks.rescaled_r2v import rescale
from benchmarks.spread import spread

Record = dict[str, Any]
Good = Callable[[Room], bool]
WITH_BED = ("nightstand", "table_lamp")
"""What goes where the bed goes."""
METRICS = (
    "rooms with a place in the empty room",
    "the same without another fault of beds",
    "the same beside a wardrobe of a metre",
    "rooms with a place beside what stands",
)


class Found(NamedTuple):
    """A room with a faulty bed: the fault, and of each of :data:`METRICS` whether it is so."""

    fault: str
    places: tuple[bool, bool, bool, bool]


def records(
    quick: bool = False, progress: stages.Progress | None = None, rescaled: bool = False
) -> Iterator[Record]:
    """A record a fault and metric; of an interrupted run those of the flats that are done.
    ``rescaled``: of flats at their true scale."""
    data_set(PLANS)
    flats = _try_flats(QUICK if quick else USUAL, progress, rescaled)
    yield from stages.tally(flats, _tally)


def _try_flats(
    step: int, progress: stages.Progress | None, rescaled: bool
) -> Iterator[list[Found]]:
    numbers = range(0, len(raw_plans()), step)
    for done, found in enumerate(spread([partial(try_flat, n, rescaled) for n in numbers])):
        if progress:
            progress((done + 1) / len(numbers), f"{done + 1} of {len(numbers)} flats")
        yield found


def _tally(flats: list[list[Found]]) -> Iterator[Record]:
    found = [room for flat in flats for room in flat]
    for fault in sorted({room.fault for room in found}):
        rooms = [room.places for room in found if room.fault == fault]
        for number, metric in enumerate(METRICS):
            yield {
                "case": fault,
                "metric": metric,
                "unit": "rooms",
                "ours": sum(places[number] for places in rooms),
                "baseline": len(rooms),
                "baseline_name": "rooms with the fault",
                "ratio": round(sum(places[number] for places in rooms) / len(rooms), 4),
                "runs": len(flats),
            }


def try_flat(number: int, rescaled: bool = False) -> list[Found]:
    """Furnish one flat and look for places of its faulty beds."""
    from scenewright.building import plan
    from scenewright.domains.home.solving import solve

    raw = raw_plans()[number]
    brief = adapt(rescale(raw) if rescaled else raw).brief
    if brief is None:
        return []
    solution, spaces = solve(brief, seed=0, threads=1), plan.spaces(brief)
    cases = [
        (Case(solution, spaces, room.space, bed), room)
        for room in list_rooms(spaces, solution.pieces)
        for bed in room.find("single_bed", "double_bed")[:1]
    ]
    return [found for case, room in cases for found in _try_room(case, room)]


def _try_room(case: Case, room: Room) -> Iterator[Found]:
    beds = room._replace(pieces=tuple(p for p in room.pieces if "bed" in p.category))
    if bed_adrift((beds,)).faulty:
        yield Found("single bed adrift", _find(case, room, lambda r: not bed_adrift((r,)).faulty))
    if before_window((beds,)).faulty:
        kind = case.bed.category.replace("_", " ")
        clear = partial(_is_clear_of_windows, case)
        yield Found(f"{kind} before a window", _find(case, room, clear))


def _is_clear_of_windows(case: Case, room: Room) -> bool:
    """Whether no bed stands before a window and each has its head, or a single one a long side, at
    a wall."""
    beds = tuple(p for p in room.pieces if p.category == case.bed.category)
    alone = room._replace(pieces=beds)
    along = case.bed.category == "single_bed" and not bed_adrift((alone,)).faulty
    stands = along or all(has_back(bed, case.space) for bed in beds)
    return stands and not before_window((alone,)).faulty


def _find(case: Case, room: Room, good: Good) -> tuple[bool, bool, bool, bool]:
    """What is so of one room, by :data:`METRICS`."""
    empty = any(True for _ in list_valid(case, (), good))
    if not empty:
        return (False, False, False, False)
    stands = tuple(p for p in count_standing(room) if p is not case.bed)
    stays = tuple(p for p in stands if p.category not in WITH_BED)
    return (
        True,
        any(True for _ in list_valid(case, (), lambda r: good(r) and not is_faulty(case, r))),
        find_beside_wardrobe(case, list_valid(case, (), good)),
        any(True for _ in list_valid(case, stays, good)),
    )
