"""Islands before the run of a large kitchen, where passages remain all round them.

An island stands along the line with the hob, its working side towards it, its stools on the other
(:mod:`.island_places`). A second run gives way to it; a table is placed anew, with as many seats.
"""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    bars_no_more,
)
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.kitchens.island_places import (
    clear_floor,
    front_of,
    has_hob,
    has_passages,
    list_island_places,
)
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced, with_margin
from scenewright.domains.home.composing.places.trials import try_forms
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.groups.classes import RUNS, TABLES
from scenewright.domains.home.groups.kitchen import island
from scenewright.domains.home.programme import WELCOME, Wish

FROM = 14.0
"""Square metres from which a kitchen may have an island."""
FORMS, TRIED = 6, 3
"""Forms of a table tried beside an island, and islands tried before a table."""


def add_island(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer with an island before its kitchen run with a hob, the longest that has its
    passages and bars no way; a second run gives way to it, a table to dine at goes elsewhere. As it
    was where no island has its passages."""
    run = next((p for p in answer.placed if p.wish.group in RUNS and has_hob(p)), None)
    if run is None or not _may_have_island(task, answer.placed):
        return answer
    missing = tuple(m for m in answer.missing if m.wish.group != "island")
    for rest, gone, later in _list_rests(answer.placed):
        for placed in _list_with_island(task, rest, run, barred):
            whole = _set_tables(task, placed, later, barred)
            if whole is not None:
                return answer._replace(placed=whole, missing=(*missing, *gone))
    return answer


def _list_rests(placed: Placed) -> Iterator[tuple[Placed, tuple[Missing, ...], Placed]]:
    """What an island is placed beside, what gives way to it, and what is placed after it."""
    yield placed, (), ()
    spare = [p for p in placed if p.wish.group == "counter" and not p.wish.required]
    tables = tuple(p for p in placed if p.wish.group in TABLES)
    gone = tuple(Missing(p.wish, "the kitchen island takes its place") for p in spare)
    fewer = tuple(p for p in placed if p not in spare)
    if spare:
        yield fewer, gone, ()
    if tables:
        yield tuple(p for p in fewer if p not in tables), gone, tables


def _list_with_island(
    task: RoomTask, rest: Placed, run: FurnishedGroup, barred: frozenset[str]
) -> Iterator[Placed]:
    """The rest with an island in its best places, at most :data:`TRIED`."""
    standing = (*task.fixed, *task.beside, *(q for p in rest for q in p.pieces))
    floor, obstacles = clear_floor(task, standing), standing_of(standing, flat_kinds(task.catalog))
    tried = 0
    for case in sorted(island(), key=lambda form: -form.width):
        group = make_unplaced(task, rest, Wish("island", WELCOME), case)
        for box in list_island_places(case, front_of(run), floor):
            added = dress_group(task, group, case, box, obstacles)
            if added is not None and _is_open(task, (*rest, added), barred):
                tried += 1
                yield (*rest, added)
            if tried == TRIED:
                return


def _set_tables(
    task: RoomTask, placed: Placed, later: Placed, barred: frozenset[str]
) -> Placed | None:
    """The tables beside an island, none with fewer seats than it had, and the passages round the
    island kept; None where one finds no place."""
    for table in later:
        whole, forms = (*placed, table), list_forms(task, table)
        tried = try_forms(judge_of(task, whole), whole, len(placed), forms, FORMS)
        seats = len(table.pieces)
        good = (
            j.placed
            for j in tried
            if len(j.placed[-1].pieces) >= seats
            and has_passages(task, j.placed)
            and _is_open(task, j.placed, barred)
        )
        following = next(good, None)
        if following is None:
            return None
        placed = following
    return placed


def _may_have_island(task: RoomTask, placed: Placed) -> bool:
    """Whether a kitchen is large, and nobody has said what is to be in it."""
    listed = task.asked is not None and task.asked.ask is not None
    there = {p.wish.group for p in placed} | {piece.category for piece in task.fixed}
    apart = listed or "island" in task.library.own or "kitchen_island" in task.forbidden
    return task.ground.area >= FROM and not apart and not there & {"island", "kitchen_island"}


def _is_open(task: RoomTask, placed: Placed, barred: frozenset[str]) -> bool:
    return bars_no_more(with_margin(task), placed, barred)
