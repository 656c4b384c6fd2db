"""A furnished home changed by hand and solved again, only where that is needed."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from scenewright.building.plan import plan_rooms
from scenewright.building.standing import is_item, lock_item, reaching_in
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.edits import Adjusted, Cancel, Edits
from scenewright.core.piece_edits import frame_of, transfer_frame
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Solution
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import RoomTask
from scenewright.domains.home.cases.library import Library
from scenewright.domains.home.cases.own_library import libraries_of, taste_of
from scenewright.domains.home.changes.assembling import assemble_home
from scenewright.domains.home.changes.edits import LIGHT, EditedHome, apply_edits, leads
from scenewright.domains.home.changes.least_change import Rest, rearrange_groups
from scenewright.domains.home.changes.listing import changes_of
from scenewright.domains.home.changes.needless import take_back
from scenewright.domains.home.changes.open_ways import open_ways
from scenewright.domains.home.changes.regroup import (
    as_standing,
    find_misplaced,
    regroup_pieces,
    settle_group,
)
from scenewright.domains.home.changes.revised import NOTHING, Revised
from scenewright.domains.home.composing.compose import compose
from scenewright.domains.home.furnishing.look import keep_palette
from scenewright.domains.home.grounds.closets import has_closet, list_wet_walls
from scenewright.domains.home.grounds.open_plan import held_elsewhere
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.learned.density import match_learned_density
from scenewright.domains.home.needs.household import Household, decide_household, seat_residents
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish, standing_groups
from scenewright.domains.home.room import count_steps
from scenewright.domains.home.solvers import SOLVERS
from scenewright.domains.home.tasks import task_of, wishes_of
from scenewright.domains.home.walking.entrances import entered_by
from scenewright.domains.home.walking.home_floor import join_floors
from scenewright.domains.home.wheelchair import furnish_by_use, widen_library
from scenewright.domains.home.wished.shared_wishes import share_with_home
from scenewright.domains.home.wished.wishes import restrict_library
from scenewright.engine.rows import preset_named, solver_again
from scenewright.engine.solve import Budget

Floats = NDArray[np.float64]


def adjust(
    solution: Solution,
    edits: Edits,
    *,
    plan: Plan | None = None,
    steps: int | None = None,
    seed: int | None = None,
) -> Adjusted:
    """Make ``edits`` and solve again the rooms they touch; all others stay as they are.

    In a room where something was moved as little as possible changes; rooms to be furnished
    ``again`` are laid out anew around what is locked. ``steps`` are for one item, else by the
    solution's preset; ``seed`` is the solution's and ``plan`` is made unless given.
    """
    started = time.perf_counter()
    rooms = (plan or plan_rooms(solution.brief)).spaces
    change = apply_edits(solution.pieces, solution.patches, rooms, edits)
    brief = _with_moved(solution.brief, rooms, solution.pieces, change)
    seed = solution.seed if seed is None else seed
    start = replace(solution, brief=keep_palette(brief, solution.seed, seed), seed=seed)
    found = {
        room: _revise_room(start, rooms, room, change, edits, steps)
        for room in sorted(change.touched)
    }
    exact = found and preset_named(PRESETS, solution.preset).settings.exact
    floors = join_floors(rooms, brief.route_width) if exact else ()
    found = open_ways(found, rooms, floors, start, change.pieces)
    spent = time.perf_counter() - started
    after = assemble_home(start, rooms, floors, found, change, spent)
    released = _without_released(after.brief, rooms, solution.pieces, after.pieces)
    after = replace(after, brief=released)
    again = {room.id for room in rooms if {room.id, room.name} & set(edits.again)}
    reasons = {k: why for revised in found.values() for k, why in revised.reasons.items()}
    return Adjusted(after, changes_of(solution, after, change, again, reasons))


def _revise_room(
    solution: Solution,
    rooms: tuple[Space, ...],
    room: str,
    change: EditedHome,
    edits: Edits,
    steps: int | None,
) -> Revised:
    """One touched room."""
    number = next(i for i, space in enumerate(rooms) if space.id == room)
    asked = solution.brief.rooms[number]
    here = [p for p in change.pieces if p.space == room]
    groups = {p.group for p in here if p.fixed and p.function in GROUPS}
    firm = [p for p in here if p.fixed or p.group in groups or _plain(p)]
    household = decide_household(rooms, solution.brief.residents)
    library = _library_of(solution.brief, household, asked, room)
    told = solution, rooms, number, library, change.pieces, edits.cancel
    task_with = partial(_task_with, *told)

    bare = task_with([p for p in firm if p.function not in GROUPS])
    firm, given_up, reasons = _repair_fixed(bare, firm, change)
    task = task_with(firm)
    boxes = _boxes(solution, [*firm, *here], change.moved)
    wishes = wishes_of(asked, bare, rooms, bare.fixed)
    held = regroup_pieces(firm, boxes, wishes)
    free = regroup_pieces([p for p in here if p.group not in groups], boxes, wishes)
    steps = steps or task.preset.steps or 1000
    if {room, task.space.name} & set(edits.again):
        anew = wishes_of(asked, task, rooms, tuple(firm))
        anew = share_with_home(household, task, anew, _groups_of(change.pieces, room, anew))
        many = count_steps(task, steps, len(anew))
        budget = Budget(threads=1, steps=many)
        answer = compose(task, furnish_by_use(task, anew, budget)) if anew else NOTHING
        return Revised(task, bare, held, Rest((), answer), given_up, reasons, anew, budget)
    budget = Budget(threads=1, steps=steps * max(len(free), 1))
    rest = rearrange_groups(task, free, budget)
    if task.preset.settings.exact:
        rest, more = take_back(bare, held, free, rest)
        reasons |= more
    return Revised(task, bare, held, rest, given_up, reasons, (), budget)


def _library_of(brief: Brief, household: Household, asked: Room, room: str) -> Library:
    """The cases that a room may take."""
    library = libraries_of(brief, catalog_of(brief.catalogs))[taste_of(brief, asked)]
    wide = widen_library(library) if brief.accessible else library
    return seat_residents(household, room, restrict_library(wide, asked))


def _task_with(
    solution: Solution,
    rooms: tuple[Space, ...],
    number: int,
    library: Library,
    pieces: Sequence[Piece],
    cancel: Cancel,
    fixed: Sequence[Piece],
) -> RoomTask:
    """A room in which some pieces are ``fixed``, as a task; ``pieces`` are those of the home."""
    space, asked = rooms[number], solution.brief.rooms[number]
    others = [[p for p in solution.pieces if p.fixed and p.space == s.id] for s in rooms]
    preset = preset_named(PRESETS, solution.preset)
    task = task_of(
        solution.brief,
        asked,
        space,
        tuple(fixed),
        catalog_of(solution.brief.catalogs),
        library,
        preset,
        solver_again(SOLVERS, solution.solver) or preset.solver,
        solution.seed,
        cancel,
        beside=reaching_in(others, rooms)[number],
        entered=entered_by(space, rooms),
        closet=has_closet(space, rooms),
        pipes=list_wet_walls(space, rooms),
    )
    task = task._replace(elsewhere=held_elsewhere(space.id, pieces, rooms))
    return match_learned_density(task, asked, rooms)


def _groups_of(pieces: Sequence[Piece], room: str, wanted: Sequence[Wish]) -> frozenset[str]:
    """The groups that stand in the other rooms, and those ``wanted`` in this one."""
    others = [p for p in pieces if p.space != room]
    standing = standing_groups(others) | {p.function for p in others}
    return standing | {wish.group for wish in wanted}


def _plain(piece: Piece) -> bool:
    """Whether a piece belongs to no group and follows none."""
    return piece.function not in GROUPS and piece.function != LIGHT


def _boxes(
    solution: Solution, here: Sequence[Piece], moved: Mapping[str, str]
) -> dict[str, Floats]:
    """Patches by group, carried along with the piece that makes the group."""
    ids = {former: present for present, former in moved.items()}
    now = {p.id: p for p in reversed(here)}
    leaders = {
        former.group: (former, now[i])
        for former in reversed(solution.pieces)
        if leads(former) and (i := ids.get(former.id, former.id)) in now
    }
    found = {}
    for patch in solution.patches:
        if patch.id in leaders:
            former, lead = leaders[patch.id]
            frame = transfer_frame(patch.box[:3], frame_of(former), frame_of(lead))
            found[lead.group] = np.array([*frame, *patch.box[3:]])
    return found


def _repair_fixed(
    task: RoomTask, firm: list[Piece], change: EditedHome
) -> tuple[list[Piece], tuple[LeftOut, ...], dict[str, str]]:
    """Fixed pieces without those of moved groups that cannot follow; what makes a group stays
    where the user put it, fitting or not. Swapped groups are put where they fit near by."""
    firm = _settle_swapped(task, firm, change.swapped)
    company = [
        p
        for p in firm
        if p.id in change.moved
        and p.function in GROUPS
        and p.category not in GROUPS[p.function].essential
    ]
    others = as_standing([p for p in firm if p.id not in change.moved], task.catalog)
    why = find_misplaced(task, company, others)
    changes = tuple(
        LeftOut(task.space.id, p.category, why[p.id], False)
        for p in company
        if p.id in why and p.on is None
    )
    return [p for p in firm if p.id not in why], changes, why


def _settle_swapped(
    task: RoomTask, firm: list[Piece], swapped: Sequence[frozenset[str]]
) -> list[Piece]:
    """Fixed pieces with what was swapped put where it fits near by: each first as if the others
    that are swapped were not there, then beside them."""
    for ignored in (frozenset[str]().union(*swapped), frozenset[str]()):
        for together in swapped:
            rest = [p for p in firm if p.id not in together]
            others = as_standing([p for p in rest if p.id not in ignored], task.catalog)
            there = settle_group(task, [p for p in firm if p.id in together], others)
            firm = [*rest, *there]
    return firm


def _without_released(
    brief: Brief, rooms: Sequence[Space], before: Sequence[Piece], after: Sequence[Piece]
) -> Brief:
    """The brief without fixed items that were let go, or had to give way to what was moved."""
    stay = {piece.id for piece in after if piece.fixed}
    gone = [piece for piece in before if piece.fixed and piece.id not in stay]
    listed = [
        [i for i in room.fixed if not any(is_item(i, p) for p in gone if p.space == space.id)]
        for room, space in zip(brief.rooms, rooms, strict=True)
    ]
    if all(len(kept) == len(room.fixed) for kept, room in zip(listed, brief.rooms, strict=True)):
        return brief
    updated = [
        room.model_copy(update={"fixed": kept})
        for room, kept in zip(brief.rooms, listed, strict=True)
    ]
    return brief.model_copy(update={"rooms": updated})


def _with_moved(
    brief: Brief, rooms: Sequence[Space], pieces: Sequence[Piece], change: EditedHome
) -> Brief:
    """The brief with its fixed items where they were moved to."""
    after = {change.moved[p.id]: p for p in change.pieces if p.id in change.moved}
    before = [p for p in pieces if p.id in after]
    listed = []
    carried: dict[str, list[object]] = {space.id: [] for space in rooms}
    for room, space in zip(brief.rooms, rooms, strict=True):
        stays = []
        for item in room.fixed:
            was = next((p for p in before if p.space == space.id and is_item(item, p)), None)
            if was is None:
                stays.append(item)
            else:
                carried[after[was.id].space].append(lock_item(after[was.id], item))
        listed.append(stays)
    if not any(carried.values()):
        return brief
    updated = [
        room.model_copy(update={"fixed": [*stays, *carried[space.id]]})
        for room, space, stays in zip(brief.rooms, rooms, listed, strict=True)
    ]
    return brief.model_copy(update={"rooms": updated})
