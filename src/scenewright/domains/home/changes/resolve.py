"""A furnished home changed by hand and solved again, only where that is needed."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.brief import Brief
from scenewright.domains.home.attempt import Furnished, Placed, Task
from scenewright.domains.home.cases.own_library import libraries_of, taste_of
from scenewright.domains.home.changes.edits import Edited, Edits, edited, frame_of, laid_on, leads
from scenewright.domains.home.changes.least_change import Rest, rearranged
from scenewright.domains.home.changes.regroup import as_standing, misplaced, regrouped, settled
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.learned.amount import accustomed
from scenewright.domains.home.presets import preset_named
from scenewright.domains.home.reasons import left_out, patches, terms
from scenewright.domains.home.tasks import completed, task_of, wishes_of
from scenewright.domains.home.wheelchair import furnish_by_use, widened
from scenewright.domains.home.wished.wishes import allowed
from scenewright.domains.home.yielding import yielded
from scenewright.domains.standing import is_item, item_of
from scenewright.plan import spaces
from scenewright.scene import Piece
from scenewright.solution import LeftOut, Solution
from scenewright.solve import Budget
from scenewright.space import Space
from scenewright.stock import catalog_of

Floats = NDArray[np.float64]

LIGHT = "light"  # the function of lamps and curtains, which follow the rest


class Revised(NamedTuple):
    """One room after the edits: its task with all that is fixed, the same without the groups that
    are ``held``, the other groups, and what of a moved group had to be given up."""

    task: Task
    bare: Task
    held: tuple[Placed, ...]
    rest: Rest
    given_up: tuple[LeftOut, ...]


def resolve(
    solution: Solution, edits: Edits, *, steps: int | None = None, seed: int | None = None
) -> Solution:
    """Make ``edits`` and solve again the rooms they touch; all others stay as they are.

    In a room where something was moved as little as possible changes; rooms to be furnished
    ``again`` are laid out anew around what is locked. ``steps`` are for one item, else by the
    solution's preset; ``seed`` is the solution's unless given.
    """
    started = time.perf_counter()
    rooms = spaces(solution.brief)
    change = edited(solution.pieces, solution.patches, rooms, edits)
    brief = _with_moved(solution.brief, rooms, solution.pieces, change)
    start = replace(solution, brief=brief, seed=solution.seed if seed is None else seed)
    found = {room: _revised(start, rooms, room, change, edits, steps)
             for room in sorted(change.touched)}  # fmt: skip
    _yield(found, rooms, start, change)
    return _told(start, rooms, found, change, time.perf_counter() - started)


def _revised(
    solution: Solution, rooms: tuple[Space, ...], room: str, change: Edited, edits: Edits,
    steps: int | None,
) -> Revised:  # fmt: skip
    """One touched room."""
    number = next(i for i, space in enumerate(rooms) if space.id == room)
    space, asked = rooms[number], solution.brief.rooms[number]
    here = [p for p in change.pieces if p.space == room]
    groups = {p.group for p in here if p.fixed and p.function in GROUPS}
    firm = [p for p in here if p.fixed or p.group in groups or _plain(p)]
    catalog = catalog_of(solution.brief.catalogs)
    library = libraries_of(solution.brief, catalog)[taste_of(solution.brief, asked)]
    library = allowed(widened(library) if solution.brief.accessible else library, asked)
    preset = preset_named(solution.preset)

    def task_with(fixed: list[Piece]) -> Task:
        task = task_of(
            solution.brief, asked, space, tuple(fixed), catalog, library, preset, solution.solver,
            solution.seed,
        )  # fmt: skip
        return accustomed(task, asked, rooms)

    plain = [p for p in firm if p.function not in GROUPS]
    bare = task_with(plain)
    firm, given_up = _mended(bare, firm, change)
    task = task_with(firm)
    boxes = _boxes(solution, [*firm, *here])
    wishes = wishes_of(asked, bare, rooms, bare.fixed)
    held = regrouped(firm, boxes, wishes)
    free = regrouped([p for p in here if p.group not in groups], boxes, wishes)
    again = {space.id, space.name} & set(edits.again)
    wanted = wishes_of(asked, task, rooms, tuple(firm)) if again else tuple(g.wish for g in free)
    budget = Budget(threads=1, steps=(steps or preset.steps or 1000) * max(len(wanted), 1))
    if again:
        rest = Rest((), furnish_by_use(task, wanted, budget) if wanted else _nothing())
    else:
        rest = rearranged(task, free, budget)
    return Revised(task, bare, held, rest, given_up)


def _plain(piece: Piece) -> bool:
    """Whether a piece belongs to no group and follows none."""
    return piece.function not in GROUPS and piece.function != LIGHT


def _nothing() -> Furnished:
    return Furnished(0.0, (), (), (), None, 0.0, 0)


def _boxes(solution: Solution, here: Sequence[Piece]) -> dict[str, Floats]:
    """Patches by group, carried along with the piece that makes the group."""
    now = {p.id: p for p in reversed(here)}
    was = {p.group: p for p in reversed(solution.pieces) if leads(p) and p.id in now}
    found = {}
    for patch in solution.patches:
        lead = was.get(patch.id)
        if lead is not None:
            frame = laid_on(patch.box[:3], frame_of(lead), frame_of(now[lead.id]))
            found[patch.id] = np.array([*frame, *patch.box[3:]])
    return found


def _mended(
    task: Task, firm: list[Piece], change: Edited
) -> tuple[list[Piece], tuple[LeftOut, ...]]:
    """Fixed pieces without those of moved groups that cannot follow; what makes a group stays
    where the user put it, fitting or not. Swapped groups are put where they fit near by."""
    firm = _settled(task, firm, change.swapped & {p.group for p in firm})
    company = [p for p in firm if p.id in change.moved and p.function in GROUPS
               and p.category not in GROUPS[p.function].essential]  # fmt: skip
    others = as_standing([p for p in firm if p.id not in change.moved], task.catalog)
    why = misplaced(task, company, others)
    told = tuple(LeftOut(task.space.id, p.category, why[p.id], False)
                 for p in company if p.id in why and p.on is None)  # fmt: skip
    return [p for p in firm if p.id not in why], told


def _settled(task: Task, firm: list[Piece], swapped: frozenset[str]) -> list[Piece]:
    """Fixed pieces with swapped groups put where they fit near by: each first as if the others
    that are swapped were not there, then beside them."""
    for ignored in (swapped, frozenset[str]()):
        for group in sorted(swapped):
            rest = [p for p in firm if p.group != group]
            others = as_standing([p for p in rest if p.group not in ignored], task.catalog)
            there = settled(task, [p for p in firm if p.group == group], others)
            firm = [*rest, *there]
    return firm


def _yield(
    found: dict[str, Revised], rooms: tuple[Space, ...], solution: Solution, change: Edited
) -> None:
    """What now bars a way through the home gives way, in the touched rooms only."""
    if not found or not preset_named(solution.preset).exact:
        return
    standing, answers = [], []
    for space in rooms:
        revised = found.get(space.id)
        if revised is None:
            standing.append(tuple(p for p in change.pieces if p.space == space.id))
            answers.append(_nothing())
        else:
            stay, answer = revised.rest
            standing.append(revised.task.fixed)
            answers.append(answer._replace(placed=(*stay, *answer.placed)))
    catalog = catalog_of(solution.brief.catalogs)
    after = yielded(standing, answers, rooms, catalog, solution.brief.route_width)
    for space, answer in zip(rooms, after, strict=True):
        if space.id in found:
            found[space.id] = found[space.id]._replace(rest=Rest((), answer))


def _told(
    solution: Solution, rooms: tuple[Space, ...], found: dict[str, Revised], change: Edited,
    seconds: float,
) -> Solution:  # fmt: skip
    """The whole solution: new in the touched rooms, as it was in all others."""
    pieces, drawn, values, missing = [], [], [], []
    order = {piece.id: number for number, piece in enumerate(solution.pieces)}
    energies = {k: v for k, v in solution.energies.items() if k not in found}
    for space in rooms:
        if space.id not in found:
            pieces += [p for p in change.pieces if p.space == space.id]
            drawn += [p for p in solution.patches if p.space == space.id]
            values += [t for t in solution.terms if t.space == space.id]
            missing += [o for o in solution.left_out if o.space == space.id]
            continue
        revised = found[space.id]
        pieces += sorted(_pieces(revised), key=lambda p: order.get(p.id, len(order)))
        answer = revised.rest.answer
        whole = answer._replace(placed=(*revised.held, *answer.placed))
        costs = terms(revised.bare, whole)
        drawn += patches(revised.bare, whole)
        values += costs
        energies[space.id] = sum(value.cost for value in costs)
        missing += [
            *_still(solution, space.id, whole),
            *left_out(revised.bare, answer),
            *revised.given_up,
        ]
    return replace(
        solution, pieces=tuple(pieces), patches=tuple(drawn), terms=tuple(values),
        left_out=tuple(dict.fromkeys(missing)), energies=energies, seconds=seconds,
        evaluations=sum(r.rest.answer.evaluations for r in found.values()),
    )  # fmt: skip


def _pieces(revised: Revised) -> list[Piece]:
    """All that stands in a revised room, with lamps and curtains anew."""
    task = revised.task
    placed = (*task.fixed, *(p for g in revised.rest.answer.placed for p in g.pieces))
    return completed(task, placed)


def _still(solution: Solution, space: str, answer: Furnished) -> list[LeftOut]:
    """Groups that were left out before and still are: neither placed nor told anew."""
    now = {p.wish.group for p in answer.placed} | {m.wish.group for m in answer.missing}
    lacking = GROUPS.keys() - now
    return [out for out in solution.left_out if out.space == space and out.what in lacking]


def _with_moved(
    brief: Brief, rooms: Sequence[Space], pieces: Sequence[Piece], change: Edited
) -> Brief:
    """The brief with its fixed items where they were moved to."""
    before = [p for p in pieces if p.id in change.moved]
    after = {p.id: p for p in change.pieces if p.id in change.moved}
    listed = []
    carried: dict[str, list[object]] = {space.id: [] for space in rooms}
    for room, space in zip(brief.rooms, rooms, strict=True):
        stays = []
        for item in room.fixed:
            was = next((p for p in before if p.space == space.id and is_item(item, p)), None)
            if was is None:
                stays.append(item)
            else:
                carried[after[was.id].space].append(item_of(after[was.id], item.name))
        listed.append(stays)
    if not any(carried.values()):
        return brief
    updated = [
        room.model_copy(update={"fixed": [*stays, *carried[space.id]]})
        for room, space, stays in zip(brief.rooms, rooms, listed, strict=True)
    ]
    return brief.model_copy(update={"rooms": updated})
