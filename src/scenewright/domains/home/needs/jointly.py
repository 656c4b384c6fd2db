"""A need and up to three groups of a room put down together: of all their places the best.

What is put down after the others misses a place that is only there while one of them stands
elsewhere. So places of the need in all its forms, and of every group that may move in the forms
that hold no less but for what is spare, are combined: those in which pieces run into one another or
stand on floor another is used from are left out, and of the rest those that lose least storage, and
then cost least, are furnished until some leave every way open.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import combinations
from operator import ge, itemgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group, Member
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask, bars_no_more
from scenewright.domains.home.attempts.bed_first import with_narrow_ways
from scenewright.domains.home.composing.bed_places import place_member
from scenewright.domains.home.composing.filling.bare_floor import pieces_of
from scenewright.domains.home.composing.homewide.settling import (
    find_barred,
    is_harmless,
    is_roomy,
    measure_case,
)
from scenewright.domains.home.composing.homewide.used_floor import list_floors_before
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.placed_faults import cost_of_group, list_standing
from scenewright.domains.home.composing.places.forms import cost_of_case, list_forms
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced, with_margin
from scenewright.domains.home.composing.places.pairs import FormPlaces, do_overlap, list_form_places
from scenewright.domains.home.furnishing.obstacles import flat_kinds, join_standing, standing_of
from scenewright.domains.home.groups.classes import COOKING
from scenewright.domains.home.measures import HAIR, RAISED
from scenewright.domains.home.needs.forms import measure_places
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.classes import MOVED

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

STAYING = COOKING | {"basin", "washer", "toilet", "bath", "shower"}
"""Groups that move for no need: what has water, and what stands beside it."""
FORMS = 2
"""Of a group that moves, those that hold no less, and as many that do."""
GONE = -1
"""The form of a group that stands nowhere."""
TOGETHER = 3
"""Groups that move for a need at most."""
FEW = 16
"""Places of each group where :data:`TOGETHER` move."""
RATED, WALKED = 1000, 200
"""Layouts whose energy is measured, and that are furnished and walked through."""
UNLIKE = (0.3, 0.3, 0.5)
"""Metres, and radians, by which two layouts differ in one place at least."""
IN_TURN = 4
"""Layouts with the need in one place that are tried before those with it elsewhere."""
MOVING = 1.0
"""What it costs that one group more moves."""
MISSED = 20.0
"""What it costs that a group that is merely usual goes."""
LOST = 0.2
"""Metres of storage that are one step in how much is lost."""


class Options(NamedTuple):
    """Where one group may stand: its form by number (n,) of ``cases``, the boxes (n, 5), what is
    wrong there (n,), of that with how it ``stands``, and metres of storage it then lacks (n,); of
    a group that stands its place first."""

    group: FurnishedGroup
    cases: tuple[Group, ...]
    forms: NDArray[np.int64]
    boxes: Floats
    faults: Floats
    stands: Floats
    lost: Floats


def list_jointly(
    task: RoomTask,
    before: Placed,
    rest: Placed,
    wish: Wish,
    forms: Sequence[Group],
    spare: float,
    shrunk: float,
) -> Iterator[Placed]:
    """The ``rest`` of a room with a need in one of its forms and up to :data:`TOGETHER` of its
    groups elsewhere, what loses least storage first; a stand may cost ``spare`` more than
    ``before``, and ``shrunk`` metres of storage may be lost."""
    if not forms:
        return
    need = _list_need(task, rest, wish, forms)
    stand = tuple(_list_moved(task, group, shrunk) for group in rest)
    options = (*stand, need)
    barred = find_barred(task, before)
    for counts in (range(TOGETHER), (TOGETHER,)):
        tight: list[tuple[bool, Placed]] = []
        for layout in _order(task, options, _list_layouts(options, counts, shrunk, spare)):
            placed = _furnish(task, options, layout)
            if placed is None or not bars_no_more(with_narrow_ways(task), placed, barred):
                continue
            stays = tuple(g for g, k in zip(rest, layout, strict=False) if not k)
            sound = is_harmless(task, before, stays, placed, spare)
            if not sound or not is_roomy(task, before, placed):
                continue
            if bars_no_more(with_margin(task), placed, barred):
                yield placed
            else:
                tight.append((not bars_no_more(task, placed, barred), placed))
        yield from (placed for _, placed in sorted(tight, key=itemgetter(0)))


def _list_need(task: RoomTask, rest: Placed, wish: Wish, forms: Sequence[Group]) -> Options:
    group = make_unplaced(task, rest, wish, forms[0])
    return _join(task, group, list_form_places(task, group, lambda *_: forms), lambda _: 0.0)


def _list_moved(task: RoomTask, group: FurnishedGroup, shrunk: float) -> Options:
    """A group where it stands, and elsewhere if it may move."""
    own = list_standing(group)
    (*others, stored), places = measure_case(own), measure_places(own.members)
    faults = np.array([cost_of_group(group, task.ground, task.preset.settings.composing)])
    stays = FormPlaces(group.dressed.case, group.dressed.box[None], faults)

    def list_fit(_task: RoomTask, _group: FurnishedGroup) -> Iterable[Group]:
        least = (*others, stored - shrunk - HAIR)
        forms = (c for c in list_forms(task, group) if all(map(ge, measure_case(c), least)))
        fit = [c for c in forms if measure_places(c.members) >= places]
        fit.sort(key=lambda c: c.width * c.depth)
        whole = [c for c in fit if measure_case(c)[-1] >= stored]
        less = sorted(fit, key=lambda c: -min(measure_case(c)[-1], stored))[len(whole) :]
        return dict.fromkeys((group.dressed.case, *whole[:FORMS], *less[:FORMS]))

    may_move = not group.wish.required and group.wish.group not in STAYING
    found = list_form_places(task, group, list_fit) if may_move else []
    joined = _join(task, group, [stays, *found], lambda c: max(stored - measure_case(c)[-1], 0.0))
    may_go = (
        may_move
        and bool(group.wish.rank)
        and places == 0.0
        and stored <= shrunk + HAIR
        and not any(others)
    )
    return _let_go(joined, stored) if may_go else joined


def _let_go(options: Options, stored: float) -> Options:
    """The places of a group and, last, none at all."""
    return Options(
        options.group,
        options.cases,
        np.append(options.forms, GONE),
        np.append(options.boxes, options.boxes[:1], axis=0),
        np.append(options.faults, MISSED),
        np.append(options.stands, 0.0),
        np.append(options.lost, stored),
    )


def _join(
    task: RoomTask,
    group: FurnishedGroup,
    places: Sequence[FormPlaces],
    lost: Callable[[Group], float],
) -> Options:
    area, rule = task.ground.area, task.preset.settings.composing
    counts = [len(each.boxes) for each in places]
    faults = np.concatenate([np.empty(0), *(each.faults for each in places)])
    cases = tuple(each.case for each in places)
    return Options(
        group,
        cases,
        np.repeat(np.arange(len(places)), counts),
        np.concatenate([np.empty((0, 5)), *(each.boxes for each in places)]),
        faults,
        faults - np.repeat([cost_of_case(case, area, rule) for case in cases], counts),
        np.repeat([lost(case) for case in cases], counts),
    )


def _list_layouts(
    options: Sequence[Options], counts: Iterable[int], shrunk: float, spare: float
) -> list[tuple[int, ...]]:
    """The cheapest choices of one place for each group, the need last, in which at most
    :data:`TOGETHER` of the others move and nothing is in the way of another."""
    last, n = len(options) - 1, len(options)
    clash = {(a, b): _find_clashes(options[a], options[b]) for a, b in combinations(range(n), 2)}
    movable = [k for k in range(last) if len(options[k].boxes) > 1]
    found: list[tuple[float, tuple[int, ...]]] = []
    for count in counts:
        for moved in combinations(movable, count):
            found += _combine(options, clash, (*moved, last), shrunk, spare)
    found.sort()
    return [layout for _, layout in found[:RATED]]


def _combine(
    options: Sequence[Options],
    clash: dict[tuple[int, int], Bools],
    moved: tuple[int, ...],
    shrunk: float,
    spare: float,
) -> list[tuple[float, tuple[int, ...]]]:
    free = [_stand_free(options, clash, k, moved) for k in moved]
    if len(moved) > TOGETHER:
        free = [at[:: -(-len(at) // FEW) or 1] for at in free]
    if not all(map(len, free)):
        return []
    shape = tuple(map(len, free))
    clear, (cost, lost, stands) = np.ones(shape, bool), np.zeros((3, *shape))
    for axis, (k, at) in enumerate(zip(moved, free, strict=True)):
        along = [1] * len(moved)
        along[axis] = len(at)
        cost += options[k].faults[at].reshape(along)
        lost += options[k].lost[at].reshape(along)
        stands += options[k].stands[at].reshape(along)
        for other in range(axis + 1, len(moved)):
            pair = [1] * len(moved)
            pair[axis], pair[other] = len(at), len(free[other])
            clear &= ~clash[k, moved[other]][np.ix_(at, free[other])].reshape(pair)
    most = spare + sum(float(options[k].stands[0]) for k in moved[:-1])
    clear &= (lost <= shrunk + HAIR) & (stands <= most + HAIR)
    rows = np.argwhere(clear)
    rated = cost[clear] + MOVING * len(moved) + 1000.0 * np.floor(lost[clear] / LOST + HAIR)
    best = np.argsort(rated, kind="stable")[:RATED]
    layouts = np.zeros((len(best), len(options)), np.int64)
    for axis, k in enumerate(moved):
        layouts[:, k] = free[axis][rows[best, axis]]
    return list(zip(rated[best].tolist(), map(tuple, layouts.tolist()), strict=True))


def _stand_free(
    options: Sequence[Options], clash: dict[tuple[int, int], Bools], k: int, moved: tuple[int, ...]
) -> NDArray[np.int64]:
    """The places of a group that are in the way of none that stays."""
    free = np.ones(len(options[k].boxes), bool)
    for other in range(len(options)):
        if other not in moved:
            free &= ~(clash[k, other][:, 0] if k < other else clash[other, k][0])
    if k < len(options) - 1:
        free[0] = False
    return np.flatnonzero(free)


def _find_clashes(one: Options, other: Options) -> Bools:
    """Which places of two groups are in the way of one another (n, m)."""
    clash = np.zeros((len(one.boxes), len(other.boxes)), bool)
    for a, case in enumerate(one.cases):
        rows = np.flatnonzero(one.forms == a)
        for b, their in enumerate(other.cases):
            columns = np.flatnonzero(other.forms == b)
            met = _do_clash(case, one.boxes[rows], their, other.boxes[columns])
            clash[np.ix_(rows, columns)] = met
    return clash


def _do_clash(one: Group, boxes: Floats, other: Group, their: Floats) -> Bools:
    met = np.zeros((len(boxes), len(their)), bool)
    if not met.size:
        return met
    for a in _list_bodies(one):
        for b in _list_bodies(other):
            met |= do_overlap(place_member(a, boxes), place_member(b, their))
    for holder, bodies, flip in ((one, other, False), (other, one, True)):
        for floor in _list_floors(holder):
            for body in _list_bodies(bodies):
                if body.category in MOVED and floor.category != "double_bed":
                    continue
                if flip:
                    met |= do_overlap(place_member(body, boxes), place_member(floor, their))
                else:
                    met |= do_overlap(place_member(floor, boxes), place_member(body, their))
    return met


def _list_bodies(case: Group) -> list[Member]:
    stand = (m for m in case.members if m.z < RAISED or m.category == "wall_shelf")
    return [m for m in stand if m.on < 0 and m.category != "rug"]


def _list_floors(case: Group) -> list[Member]:
    return [floor for m in case.members if m.on < 0 for floor in list_floors_before(m)]


def _order(
    task: RoomTask, options: Sequence[Options], layouts: list[tuple[int, ...]]
) -> Iterator[tuple[int, ...]]:
    """Layouts by what they lose, then by what they cost with their energy; of like ones one."""
    if not layouts:
        return
    chosen = np.array(layouts)
    boxes = np.stack([o.boxes[chosen[:, k]] for k, o in enumerate(options)], axis=1)
    faults = sum(o.faults[chosen[:, k]] for k, o in enumerate(options))
    lost = sum(o.lost[chosen[:, k]] for k, o in enumerate(options))
    energy = judge_of(task, tuple(o.group for o in options)).energies_of(boxes)
    cost = faults + task.costs.energy * energy + MOVING * (chosen > 0).sum(-1)
    order = np.lexsort((cost, np.floor(lost / LOST + HAIR)))
    like = np.round(boxes[order][..., :3] / UNLIKE)
    _, first = np.unique(like.reshape(len(like), -1), axis=0, return_index=True)
    first.sort()
    turns: Counter[int] = Counter()
    rounds = []
    for place in np.unique(like[first, -1], axis=0, return_inverse=True)[1].ravel().tolist():
        rounds.append(turns[place] // IN_TURN)
        turns[place] += 1
    chosen_first = first[np.argsort(rounds, kind="stable")]
    yield from (layouts[k] for k in order[chosen_first[:WALKED]].tolist())


def _furnish(task: RoomTask, options: Sequence[Options], layout: tuple[int, ...]) -> Placed | None:
    """The groups at their places, None where one of them does not stand there."""
    flat = flat_kinds(task.catalog)
    need = len(options) - 1
    stays = [o.group for o, k in zip(options[:need], layout, strict=False) if not k]
    standing = standing_of(pieces_of(task, tuple(stays)), flat)
    placed: list[FurnishedGroup] = []
    for number, (option, k) in enumerate(zip(options, layout, strict=True)):
        if number < need and not k:
            placed.append(option.group)
            continue
        if option.forms[k] == GONE:
            continue
        case = option.cases[option.forms[k]]
        there = dress_group(task, option.group, case, option.boxes[k], standing)
        if there is None:
            return None
        placed.append(there)
        standing = join_standing(standing, standing_of(there.pieces, flat))
    return tuple(placed)
