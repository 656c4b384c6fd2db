"""Thirty functional briefs over real flats: ``scenewright bench briefs``.

A functional brief is what a household says it needs: how many sleep, eat and sit there, who works,
what is kept, whether a wheelchair is used. Each is put to flats of ``floorplans_r2v`` that
``bench composition`` does not furnish and that are large enough for it, told by bedrooms and square
metres alone; a brief is met where **every** need is, on the final pieces and by the referee, not
the average of its needs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, partial
from itertools import islice
from typing import Any, NamedTuple

from benchmarks import stages
from benchmarks.composition_faults import SOFAS, TABLES, Home, count_seats, list_rooms
from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.real_data import data_set
from benchmarks.spread import spread
from scenewright.core.brief import Brief
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.core.space import Space

Record = dict[str, Any]
FLATS, QUICK = 3, 1
"""Flats a brief is put to."""
FIRST, STEP = 2, 4
"""Flats are every fourth, those that ``bench composition`` leaves out."""
BEDS = {"double_bed": 2, "single_bed": 1, "bunk_bed": 2}
DESKS = ("desk", "corner_desk", "kids_desk")
BOOKS = ("bookcase", "shelf_unit")
LARGE = 8.8
"""A bedroom for two has so many square metres."""


class Furnished(NamedTuple):
    """A furnished flat: its solution, the referee's report, and its rooms with what they hold."""

    solution: Solution
    report: Report
    home: Home

    def count(self, *categories: str) -> int:
        """How many pieces of some categories there are."""
        return sum(p.category in categories for p in self.solution.pieces)


Met = Callable[[Furnished], bool]


def sleeps(people: int) -> Met:
    """Whether so many have a bed."""
    return lambda flat: sum(BEDS.get(p.category, 0) for p in flat.solution.pieces) >= people


def eats(people: int) -> Met:
    """Whether so many have a chair at a table in one room."""
    return lambda flat: any(
        room.find(*TABLES) and len(room.find("dining_chair")) >= people for room in flat.home
    )


def sits(people: int) -> Met:
    """Whether so many have a seat on sofas and armchairs in one room."""
    return lambda flat: any(room.find(*SOFAS) and count_seats(room) >= people for room in flat.home)


def works(people: int) -> Met:
    """Whether so many have a desk with a chair."""
    return lambda flat: (
        flat.count(*DESKS) >= people and flat.count("office_chair", "dining_chair") >= people
    )


def keeps(categories: tuple[str, ...], metres: float) -> Met:
    """Whether there are so many metres of furniture of some kinds."""
    return lambda flat: (
        sum(p.size.width for p in flat.solution.pieces if p.category in categories) >= metres
    )


def has(*categories: str) -> Met:
    """Whether there is a piece of one of some kinds."""
    return lambda flat: flat.count(*categories) > 0


def lacks(category: str) -> Met:
    """Whether there is none of a kind."""
    return lambda flat: flat.count(category) == 0


def cooks(flat: Furnished) -> bool:
    """Whether a room has a hob, a sink and a fridge."""
    kitchen = ("hob_cabinet", "sink_cabinet", "fridge")
    return any(all(map(room.find, kitchen)) for room in flat.home)


class FunctionalBrief(NamedTuple):
    """What a household says: in words, how many live there, the ``bedrooms`` and square metres of
    living room (``living``) it takes, whether a wheelchair is used, wishes by the function of their
    room, and what must then be so (``needs``)."""

    words: str
    residents: int
    bedrooms: int
    living: float
    needs: tuple[Met, ...]
    wishes: tuple[tuple[str, dict[str, Any]], ...] = ()
    accessible: bool = False


def _wish(room: str, what: str, **place: Any) -> tuple[str, dict[str, Any]]:
    return room, {"what": what, **place}


def _forbid(room: str, what: str) -> tuple[str, dict[str, Any]]:
    return room, {"what": what, "forbid": True}


WARDROBE = ("wardrobe",)
DESK = _wish("bedroom", "desk")
_LIVING_DESK = _wish("living", "desk")
BRIEFS = (
    FunctionalBrief("one person", 1, 1, 9, (sleeps(1), eats(1), sits(1), cooks)),
    FunctionalBrief("a couple", 2, 1, 12, (sleeps(2), eats(2), sits(2), cooks)),
    FunctionalBrief(
        "a couple, one works from home",
        2,
        1,
        14,
        (sleeps(2), eats(2), works(1), cooks),
        (_LIVING_DESK,),
    ),
    FunctionalBrief(
        "a couple, both work from home",
        2,
        2,
        16,
        (sleeps(2), eats(2), works(2), cooks),
        (DESK, _LIVING_DESK),
    ),
    FunctionalBrief(
        "a couple that cooks, one wheelchair", 2, 1, 16, (sleeps(2), eats(2), cooks), (), True
    ),
    FunctionalBrief("one person in a wheelchair", 1, 1, 14, (sleeps(1), eats(1), cooks), (), True),
    FunctionalBrief(
        "a couple that reads",
        2,
        1,
        16,
        (sleeps(2), eats(2), keeps(BOOKS, 0.8), cooks),
        (_wish("living", "shelf"),),
    ),
    FunctionalBrief(
        "a couple with two wardrobes' worth of clothes",
        2,
        1,
        12,
        (sleeps(2), eats(2), keeps(WARDROBE, 2.0), cooks),
    ),
    FunctionalBrief(
        "a couple without television",
        2,
        1,
        14,
        (sleeps(2), eats(2), lacks("tv"), cooks),
        (_forbid("living", "tv"),),
    ),
    FunctionalBrief("a couple and a child", 3, 2, 14, (sleeps(3), eats(3), sits(3), cooks)),
    FunctionalBrief(
        "a couple and a child, one works from home",
        3,
        2,
        16,
        (sleeps(3), eats(3), works(1), cooks),
        (_LIVING_DESK,),
    ),
    FunctionalBrief(
        "a couple and two children in a room each", 4, 3, 16, (sleeps(4), eats(4), sits(3), cooks)
    ),
    FunctionalBrief("a couple and two children", 4, 2, 18, (sleeps(4), eats(4), cooks)),
    FunctionalBrief(
        "a family of four that plays the piano",
        4,
        3,
        22,
        (sleeps(4), eats(4), has("piano"), cooks),
        (_wish("living", "piano"),),
    ),
    FunctionalBrief("a family of five", 5, 3, 20, (sleeps(5), eats(5), cooks)),
    FunctionalBrief(
        "two who share a flat, a room each",
        2,
        2,
        12,
        (sleeps(2), eats(2), works(2), cooks),
        (DESK,),
    ),
    FunctionalBrief("three who share a flat", 3, 3, 12, (sleeps(3), eats(3), cooks)),
    FunctionalBrief("a student", 1, 1, 9, (sleeps(1), works(1), cooks), (DESK,)),
    FunctionalBrief(
        "an old couple, easy to walk through",
        2,
        1,
        14,
        (sleeps(2), eats(2), sits(2), cooks),
        (),
        True,
    ),
    FunctionalBrief(
        "a couple that has guests to dinner", 2, 1, 22, (sleeps(2), eats(4), sits(3), cooks)
    ),
    FunctionalBrief(
        "one person who trains at home",
        1,
        1,
        16,
        (sleeps(1), eats(1), has("exercise_bike"), cooks),
        (_wish("living", "exercise_bike"),),
    ),
    FunctionalBrief(
        "a couple with plants",
        2,
        1,
        14,
        (sleeps(2), eats(2), has("potted_tree"), cooks),
        (_wish("living", "plant"),),
    ),
    FunctionalBrief(
        "one who writes by the window",
        1,
        1,
        14,
        (sleeps(1), works(1), cooks),
        (_wish("living", "desk", by="window"),),
    ),
    FunctionalBrief(
        "a couple and a baby",
        3,
        2,
        14,
        (sleeps(3), has("cot"), eats(2), cooks),
        (_wish("bedroom", "cot"),),
    ),
    FunctionalBrief("a single parent and a child", 2, 2, 12, (sleeps(2), eats(2), sits(2), cooks)),
    FunctionalBrief(
        "a couple with an armchair to read in",
        2,
        1,
        18,
        (sleeps(2), eats(2), has("armchair"), cooks),
        (_wish("living", "reading"),),
    ),
    FunctionalBrief(
        "a couple that does its washing at home",
        2,
        1,
        12,
        (sleeps(2), eats(2), has("washing_machine"), cooks),
    ),
    FunctionalBrief("four who watch films", 4, 2, 20, (sleeps(4), sits(4), has("tv"), cooks)),
    FunctionalBrief(
        "one who dresses at a vanity",
        1,
        1,
        12,
        (sleeps(1), has("vanity"), cooks),
        (_wish("bedroom", "vanity"),),
    ),
    FunctionalBrief(
        "a couple and a grandparent in a wheelchair",
        3,
        2,
        18,
        (sleeps(3), eats(3), cooks),
        (),
        True,
    ),
)
"""Thirty households."""


class Answer(NamedTuple):
    """What came of a brief in a flat: of how many needs how many were met, whether the referee
    finds the home valid and whole, and the numbers of the brief and the flat."""

    brief: int
    flat: int
    met: int
    needs: int
    sound: bool

    @property
    def whole(self) -> bool:
        """Whether all of it is met."""
        return self.sound and self.met == self.needs


def records(quick: bool = False, progress: stages.Progress | None = None) -> Iterator[Record]:
    """A record a brief and one of all; of an interrupted run those of the flats that are done."""
    data_set(PLANS)
    yield from stages.tally(answer_briefs(QUICK if quick else FLATS, progress), tally_answers)


def answer_briefs(flats: int, progress: stages.Progress | None = None) -> Iterator[Answer]:
    """Each brief in as many flats, seed 0."""
    pairs = list_pairs(flats)
    for done, answer in enumerate(spread([partial(answer_brief, *pair) for pair in pairs])):
        if progress:
            progress((done + 1) / len(pairs), f"{done + 1} of {len(pairs)} flats")
        yield answer


def list_pairs(flats: int) -> list[tuple[int, int]]:
    """Numbers of briefs with those of their flats: each brief begins its search where the one
    before ended, so that few flats are used twice."""
    numbers = list(range(FIRST, len(raw_plans()), STEP))
    found, start = [], 0
    for k, row in enumerate(BRIEFS):
        turned = (numbers[(start + i) % len(numbers)] for i in range(len(numbers)))
        fits = list(islice((n for n in turned if _suits(row, measure_flat(n))), flats))
        found += [(k, n) for n in fits]
        start = numbers.index(fits[-1]) + 1 if fits else start
    return found


class FlatSize(NamedTuple):
    """Areas in square metres of the bedrooms, largest first, and of the largest living room;
    whether there is a kitchen and a bathroom."""

    bedrooms: tuple[float, ...]
    living: float
    services: bool


@cache
def measure_flat(number: int) -> FlatSize:
    """What a flat is judged by before a brief is put to it."""
    from scenewright.building import plan

    brief = adapt(raw_plans()[number]).brief
    if brief is None:
        return FlatSize((), 0.0, False)
    rooms = list_rooms(plan.spaces(brief), ())
    beds = sorted((r.floor.area for r in rooms if "bedroom" in r.space.functions), reverse=True)
    living = max((r.floor.area for r in rooms if "living" in r.space.functions), default=0.0)
    used = {f for room in rooms for f in room.space.functions}
    return FlatSize(tuple(beds), living, {"kitchen", "bathroom"} <= used)


def _suits(row: FunctionalBrief, size: FlatSize) -> bool:
    """Whether a flat has the rooms: as many bedrooms, of which as many are for two as it takes to
    sleep all, and the living room."""
    pairs = max(row.residents - row.bedrooms, 1 if "couple" in row.words else 0)
    double = sum(area >= LARGE for area in size.bedrooms) >= min(pairs, row.bedrooms)
    enough = len(size.bedrooms) >= row.bedrooms and size.living >= row.living
    return enough and double and size.services


def answer_brief(brief_number: int, flat: int) -> Answer:
    """One brief put to one flat."""
    from scenewright.building import plan
    from scenewright.domains import check
    from scenewright.domains.home.solving import solve
    from scenewright.domains.home.wheelchair import accessible

    row, brief = BRIEFS[brief_number], adapt(raw_plans()[flat]).brief
    assert brief is not None
    brief = state(row, brief, plan.spaces(brief))
    brief = accessible(brief) if row.accessible else brief
    solution = solve(brief, seed=0, threads=1)
    spaces = plan.spaces(brief)
    report = check(solution, spaces=spaces)
    done = Furnished(solution, report, list_rooms(spaces, solution.pieces))
    sound = not report.findings and not any(out.required for out in solution.left_out)
    return Answer(brief_number, flat, sum(need(done) for need in row.needs), len(row.needs), sound)


def state(row: FunctionalBrief, brief: Brief, spaces: tuple[Space, ...]) -> Brief:
    """A flat's brief with what a household says: residents, and each wish in the largest room of
    its function."""
    rooms = list(brief.rooms)
    document = [room.model_dump(mode="json", exclude_unset=True) for room in rooms]
    sizes = {r.space.id: r.floor.area for r in list_rooms(spaces, ())}
    for function, wish in row.wishes:
        of = [k for k, space in enumerate(spaces) if function in space.functions]
        best = max(of, key=lambda k: sizes[spaces[k].id])
        document[best].setdefault("wishes", []).append(wish)
    whole = brief.model_dump(mode="json", exclude_unset=True)
    return Brief.model_validate(whole | {"rooms": document, "residents": row.residents})


def tally_answers(answers: list[Answer]) -> list[Record]:
    """The share of flats in which each brief is met whole, then of all; beside it the mean share of
    its needs, which is what an average would say."""
    found = []
    for k, row in enumerate(BRIEFS):
        mine = [answer for answer in answers if answer.brief == k]
        if mine:
            found.append(_record(row.words, mine))
    return [*found, _record("all briefs", answers)]


def _record(case: str, answers: list[Answer]) -> Record:
    whole = sum(answer.whole for answer in answers) / len(answers)
    needs = sum(a.met / a.needs for a in answers) / len(answers)
    return {
        "case": case,
        "metric": "whole brief met",
        "unit": "1",
        "ours": round(whole, 4),
        "baseline": round(needs, 4),
        "baseline_name": "mean share of needs",
        "ratio": round(whole / needs, 4) if needs else None,
        "runs": len(answers),
    }
