"""Thirty functional briefs over real flats: ``scenewright bench briefs``.

A functional brief is what a household says it needs: how many sleep, eat and sit there, who works,
what is kept, whether a wheelchair is used. Each is put to flats of ``floorplans_r2v`` that
``bench composition`` does not furnish and that are large enough for it, told by bedrooms and square
metres alone; a brief is met where **every** need is, on the final pieces and by the referee, not
the average of its needs.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache, partial
from itertools import islice
from typing import Any, NamedTuple

from benchmarks import stages
from benchmarks.briefs_households import BRIEFS, FunctionalBrief, Furnished
from benchmarks.composition_faults import list_rooms
from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.real_data import data_set
from benchmarks.spread import spread
from scenewright.core.brief import Brief
from scenewright.core.space import Space

Record = dict[str, Any]
FLATS, QUICK = 3, 1
"""Flats a brief is put to."""
COMPOSED = 4
"""Flats whose number this divides are those of ``bench composition``: they are left out."""
LARGE, KITCHEN = 8.8, 4.0
"""A bedroom for two, and a kitchen, have so many square metres."""


class Answer(NamedTuple):
    """What came of a brief in a flat: of how many needs how many were met, whether the referee
    finds the home valid, and the numbers of the brief and the flat."""

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
    numbers = [n for n in range(len(raw_plans())) if n % COMPOSED]
    found, start = [], 0
    for k, row in enumerate(BRIEFS):
        turned = (numbers[(start + i) % len(numbers)] for i in range(len(numbers)))
        fits = list(islice((n for n in turned if _suits(row, measure_flat(n))), flats))
        found += [(k, n) for n in fits]
        start = numbers.index(fits[-1]) + 1 if fits else start
    return found


class FlatSize(NamedTuple):
    """Areas in square metres of the bedrooms, largest first, and of the largest living room;
    whether there is a kitchen one can stand in and a bathroom."""

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
    kitchen = max((r.floor.area for r in rooms if "kitchen" in r.space.functions), default=0.0)
    bath = any("bathroom" in room.space.functions for room in rooms)
    return FlatSize(tuple(beds), living, bath and kitchen >= KITCHEN)


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
    met = sum(need(done) for need in row.needs)
    return Answer(brief_number, flat, met, len(row.needs), not report.findings)


def state(row: FunctionalBrief, brief: Brief, spaces: tuple[Space, ...]) -> Brief:
    """A flat's brief with what a household says: residents, and what it needs in the largest room
    of its function, the same again in the next."""
    rooms = list(brief.rooms)
    document = [room.model_dump(mode="json", exclude_unset=True) for room in rooms]
    sizes = {r.space.id: r.floor.area for r in list_rooms(spaces, ())}
    placed: list[tuple[int, dict[str, Any]]] = []
    for function, wish in row.wishes:
        of = [k for k, space in enumerate(spaces) if function in space.functions]
        others = [k for k in of if (k, wish) not in placed]
        best = max(others or of, key=lambda k: sizes[spaces[k].id])
        placed.append((best, wish))
        asked = wish if wish.get("forbid") else wish | {"required": True}
        document[best].setdefault("wishes", []).append(asked)
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
