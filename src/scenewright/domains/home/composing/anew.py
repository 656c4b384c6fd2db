"""Rooms with a fault that no single change mends, composed anew: what is at fault chooses first.

The faulty group is put at its best places as if the room were empty, in the forms with least wrong
(a bed and a wardrobe together: :mod:`.places.pairs`); all others follow, the essential and the
largest first, each where the room so far costs least beside those before it. A way that leaves one
of them without a place, or comes to as many faults as the room has, is given up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import islice
from math import hypot, inf

from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask, bars_no_more
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.improve import list_worst_first
from scenewright.domains.home.composing.judging import (
    JudgedRoom,
    Placed,
    RoomJudge,
    count_unmet,
    find_run,
    judge_of,
    sum_faults,
)
from scenewright.domains.home.composing.kitchens.reform import (
    MORE_FROM,
    as_whole,
    list_fitted,
    may_reform,
    parts_of,
)
from scenewright.domains.home.composing.kitchens.second_runs import price_of_spare, without_spare
from scenewright.domains.home.composing.kitchens.sound import is_sound
from scenewright.domains.home.composing.placed_faults import list_standing
from scenewright.domains.home.composing.places.forms import is_mere_kitchen, list_forms
from scenewright.domains.home.composing.places.moving import with_margin
from scenewright.domains.home.composing.places.pairs import find_pair, list_pair_starts
from scenewright.domains.home.composing.places.trials import take_best, try_forms
from scenewright.domains.home.composing.verdict import find_rows
from scenewright.domains.home.groups.classes import TABLES
from scenewright.domains.home.rules.weigh_home import sum_rows

COMPACT = 2.5  # of front, of a kitchen that leaves its wall to others, metres
MACHINE = 0.64  # of wall for a washing machine beside a run, metres
LIVED_IN_FROM = 10.0
"""In a smaller room with a kitchen, square metres, nothing else finds a place after another one."""
MANY = 12
"""Forms and places in which a table is tried beside a run, or beside seats and screen."""
Judges = Callable[[int], RoomJudge]
"""The judge of the first n groups of a room, by n."""


def compose_anew(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups of a kitchen, or of a room in which an eye finds something, if they are few or a
    wish is not met, laid out anew for the first of the faulty ones, the worst first, or as they
    were."""
    rule = task.preset.settings.composing
    many = len(best.placed) > rule.few and count_unmet(task, best.placed) == 0
    if many or not (is_mere_kitchen(task) or any(find_rows(task, best.placed).values())):
        return best
    names = list_worst_first(task, best.placed)
    paired = {p.name for p in find_pair(best.placed)}
    if is_mere_kitchen(task):  # whatever is at fault there, the run takes its wall
        names = sorted(names, key=lambda n: not any(p.name == n for p in find_run(best.placed)))
    tried: set[str] = set()
    for name in names[: rule.anew]:
        there = any(p.name == name for p in best.placed)
        if name in tried or not there or task.cancelled():
            continue
        lay_out = _lay_out_pair if name in paired else _lay_out_anew
        found = list(lay_out(task, best, barred, name))
        price = price_of_spare(best.placed, found[0].placed, rule) if found else 0.0
        best = take_best(task, best, found, barred, price)
        tried |= paired if name in paired else {name}
    return best


def _lay_out_anew(
    task: RoomTask, best: JudgedRoom, barred: frozenset[str], name: str
) -> Iterator[JudgedRoom]:
    """The whole room from each of the best places of one group; from those of a kitchen without
    second runs."""
    least = task.preset.settings.composing.least
    most = sum_faults(task, best.placed) - least
    first = next(p for p in best.placed if p.name == name)
    run = next(iter(find_run(best.placed)), None)
    kitchen = parts_of(best.placed, run) if run else ()
    cooks = any(first is part for part in kitchen) and may_reform(task, best.placed)
    parts = kitchen if cooks else (first,)
    own = most if cooks and is_mere_kitchen(task) else sum_faults(task, parts) - least
    small = task.ground.area < LIVED_IN_FROM
    if run and cooks and not is_mere_kitchen(task) and (small or is_sound(task, run, best.placed)):
        return
    starts = (
        _list_kitchens(task, run, own, best.placed)
        if run and cooks
        else list_starts(task, first, barred)
    )
    rest = [p for p in best.placed if all(p is not part for part in parts)]
    rest = list(without_spare(tuple(rest))) if cooks else rest
    leader = as_whole(run) if run and cooks else first
    orders = [(judge_in_order(task, (leader, *o)), o) for o in _list_orders(task, rest, cooks)]
    for start in starts:
        better = sum_faults(task, start.placed) < own
        tried = (follow(task, judges, start, o, barred, most) for judges, o in orders if better)
        whole = next((room for room in tried if room is not None), None)
        if whole is not None:
            yield whole


def _list_orders(task: RoomTask, rest: list[FurnishedGroup], cooks: bool) -> list[Placed]:
    """In which order others follow; in a kitchen where the largest table leaves a wardrobe no
    place, also all else before the table."""
    usual = tuple(sorted(rest, key=lambda p: _turn(p, cooks)))
    if not (cooks and is_mere_kitchen(task)):
        return [usual]
    last = tuple(sorted(usual, key=lambda p: p.wish.group in TABLES))
    same = all(a is b for a, b in zip(usual, last, strict=True))
    return [usual] if same else [usual, last]


def _turn(group: FurnishedGroup, cooks: bool) -> tuple[int, bool, float]:
    """Who follows first: the essential, after a kitchen (``cooks``) the table, the largest."""
    away = cooks and group.wish.group not in TABLES
    return group.wish.rank, away, -float(group.dressed.box[3:].prod())


def _list_kitchens(
    task: RoomTask, run: FurnishedGroup, faults: float, placed: Placed
) -> Iterator[JudgedRoom]:
    """Kitchens made to measure for the room as if it were empty, with less wrong than ``faults``:
    of the first two steps that have some the best; a washing machine of those ``placed`` is to
    stand beside the units. Where people live in the room as well and the fridge stands alone,
    also short ones, which leave more of their wall to all others."""
    rule, steps = task.preset.settings.composing, 0
    washes = is_mere_kitchen(task) and any(p.wish.group == "washer" for p in placed)
    for step in list_fitted(task, (), run, frozenset(), machine=MACHINE if washes else 0.0):
        better = [j for j in step(inf) if sum_faults(task, j.placed) < faults]
        yield from better[: rule.starts if task.ground.area < MORE_FROM else 2 * rule.starts]
        steps += bool(better)
        if steps == 2:
            break
    if not is_mere_kitchen(task) and _has_far_fridge(task, placed, run):
        for step in islice(list_fitted(task, (), run, frozenset(), longest=COMPACT), 1):
            better = [j for j in step(inf) if sum_faults(task, j.placed) < faults]
            yield from better[: rule.starts]


def _has_far_fridge(task: RoomTask, placed: Placed, run: FurnishedGroup) -> bool:
    """Whether the fridge of a kitchen stands apart from its units."""
    away = sum_rows(("fridge_away",), placed, task.ground) > 0.0
    return away or any(name == "fridge_alone" for name, _ in find_case_faults(list_standing(run)))


def _lay_out_pair(
    task: RoomTask, best: JudgedRoom, barred: frozenset[str], _: str
) -> Iterator[JudgedRoom]:
    """The whole room from each of the best pairs of places of its bed and its wardrobe."""
    rule = task.preset.settings.composing
    worth, most = best.cost - rule.least, sum_faults(task, best.placed)
    return islice(follow_pairs(task, best.placed, barred, worth, most), rule.starts)


def follow_pairs(
    task: RoomTask, placed: Placed, barred: frozenset[str], worth: float, most: float
) -> Iterator[JudgedRoom]:
    """The groups of a room with a bed and a wardrobe, these at their best pairs of places, all
    others after them: rooms that cost less than they are ``worth``, and their faults less than
    ``most``."""
    rule, pair = task.preset.settings.composing, find_pair(placed)
    paired = {p.name for p in pair}
    rest = [p for p in placed if p.name not in paired]
    order = sorted(rest, key=lambda p: (p.wish.rank, -float(p.dressed.box[3:].prod())))
    judges = judge_in_order(task, (*pair, *order))
    starts = list_pair_starts(judges(2), pair, barred, worth) if pair else iter(())
    for start in islice(starts, rule.pair_starts):
        whole = follow(task, judges, start, order, barred, most)
        if whole is not None and whole.cost < worth:
            yield whole


def list_starts(task: RoomTask, first: FurnishedGroup, barred: frozenset[str]) -> list[JudgedRoom]:
    """One group alone at its best places that bar no further way, without those near to a better
    one."""
    rule = task.preset.settings.composing
    found = try_forms(judge_of(task, (first,)), (first,), 0, list_forms(task, first), rule.forms)
    margin, kept = with_margin(task), list[JudgedRoom]()
    for judged in found:
        near = any(_is_near(judged, other, rule.apart) for other in kept)
        if not near and bars_no_more(margin, judged.placed, barred):
            kept.append(judged)
            if len(kept) == rule.starts:
                break
    return kept


def _is_near(one: JudgedRoom, other: JudgedRoom, apart: float) -> bool:
    """Whether the first groups of two rooms stand less than ``apart`` metres from one another,
    turned alike."""
    (x, y, turn), (u, v, way) = (j.placed[0].dressed.box[:3] for j in (one, other))
    return hypot(x - u, y - v) < apart and abs(turn - way) <= 0.1


def judge_in_order(task: RoomTask, groups: Placed) -> Judges:
    """The judges of the first n of the groups, by n, each made when first asked for."""
    return cache(lambda count: judge_of(task, groups[:count]))


def follow(
    task: RoomTask,
    judges: Judges,
    start: JudgedRoom,
    others: Sequence[FurnishedGroup],
    barred: frozenset[str],
    most: float,
    eats: bool = False,
) -> JudgedRoom | None:
    """The others placed beside the first one by one, as ``judges`` tell; None
    where one finds no place, or where faults cost ``most`` before all stand. As most tables bar
    a way in a small room, :data:`MANY` are tried beside a run, or where one ``eats``."""
    rule, best, wide = task.preset.settings.composing, start, with_margin(task)
    for other in others:
        if sum_faults(task, best.placed) >= most:
            return None
        whole, at = (*best.placed, other), len(best.placed)
        forms = list_forms(task, other)
        count, places = rule.other_forms, rule.places
        if other.wish.group in TABLES and (eats or is_mere_kitchen(task)):
            count = places = MANY
        found = islice(try_forms(judges(at + 1), whole, at, forms, count), places)
        open_ = (j for j in found if bars_no_more(wide, j.placed, barred))
        following = next(open_, None)
        if following is None:
            return None
        best = following
    return best
