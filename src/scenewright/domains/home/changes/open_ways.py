"""The ways of a changed home: what bars one gives way, in the rooms that were touched only."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial

from scenewright.catalog.classes import EATING_TABLES, SOFT_SEATS
from scenewright.catalog.loading import catalog_of
from scenewright.core.passes import Pass
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import RoomAnswer
from scenewright.domains.home.attempts.second_try import tried_again
from scenewright.domains.home.changes.least_change import Rest
from scenewright.domains.home.changes.revised import NOTHING, Revised
from scenewright.domains.home.composing.home_passes import (
    ALIGNING,
    MENDING,
    SETTLING,
    HomePass,
    finish_home,
)
from scenewright.domains.home.composing.homewide.settling import HomeState
from scenewright.domains.home.needs.counting import count_eaters
from scenewright.domains.home.needs.household import Household, decide_household
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.walking.home_floor import HomeFloor
from scenewright.domains.home.walking.remove_blockers import Opened, remove_blockers
from scenewright.engine.rows import preset_named

Answers = Sequence[RoomAnswer]


def open_ways(
    found: Mapping[str, Revised],
    rooms: Sequence[Space],
    floors: Sequence[HomeFloor],
    solution: Solution,
    pieces: Sequence[Piece],
) -> dict[str, Revised]:
    """The rooms that were touched without what bars a way over the ``floors`` of the home; those
    furnished again are tried otherwise where they lose something essential to that. ``pieces`` are
    those of the whole home as it was changed."""
    if not floors:
        return dict(found)
    touched = [found.get(space.id) for space in rooms]
    standing = [
        revised.task.fixed if revised else tuple(p for p in pieces if p.space == space.id)
        for space, revised in zip(rooms, touched, strict=True)
    ]
    opened = partial(
        remove_blockers,
        standing,
        rooms=tuple(rooms),
        floors=floors,
        catalog=catalog_of(solution.brief.catalogs),
        settings=preset_named(PRESETS, solution.preset).settings,
    )
    answers = [_whole_answer(revised.rest) if revised else NOTHING for revised in touched]
    anew = {revised.task.space.id for revised in touched if revised and revised.anew}
    before = [piece for piece in solution.pieces if piece.space in anew]
    household = decide_household(rooms, solution.brief.residents)
    household = household._replace(residents=round(count_eaters(before)))
    settling = tuple(_settled_by(before))
    after = opened(_try_anew(touched, answers, opened, household, settling))
    return {
        space.id: revised._replace(rest=Rest((), answer))
        for space, revised, answer in zip(rooms, touched, after, strict=True)
        if revised is not None
    }


def _whole_answer(rest: Rest) -> RoomAnswer:
    stay, answer = rest
    return answer._replace(placed=(*stay, *answer.placed))


def _settled_by(before: Sequence[Piece]) -> Iterator[Pass[HomePass]]:
    """The passes that settle the needs of a home which pieces served."""
    stood = {piece.category for piece in before}
    for row in SETTLING:
        if stood & (SOFT_SEATS if row.name == "soft seat" else EATING_TABLES):
            yield row


def _try_anew(
    touched: Sequence[Revised | None],
    answers: Answers,
    opened: Opened,
    household: Household,
    settling: Sequence[Pass[HomePass]],
) -> list[RoomAnswer]:
    """The answers for all rooms, with further tries for those furnished again, finished as
    at first."""
    anew = {i: revised for i, revised in enumerate(touched) if revised and revised.anew}

    def together(some: Answers) -> list[RoomAnswer]:
        each = dict(zip(anew, some, strict=True))
        return [each.get(i, answer) for i, answer in enumerate(answers)]

    def opened_anew(some: Answers) -> list[RoomAnswer]:
        after = opened(together(some))
        return [after[i] for i in anew]

    tasks = [revised.task for revised in anew.values()]
    wishes = [revised.anew for revised in anew.values()]
    budgets = [revised.budget for revised in anew.values()]
    again = tried_again(tasks, wishes, budgets, [answers[i] for i in anew], opened_anew)
    home = HomeState(tasks, opened_anew, household, False, wishes, budgets, whole=False)
    return together(finish_home(home, again, (*MENDING, *settling, *ALIGNING)))
