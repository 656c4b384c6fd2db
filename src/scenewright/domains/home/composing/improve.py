"""Groups of a furnished room in better sizes and places, one after the other.

The search lays out all groups at once and furnishes its best layouts; where a room is tight it
ends with the smallest forms wherever they fit. Here each group with a fault of composition is taken
out and tried anew along all walls in its better forms, beside all others as they stand. A change
stays if it costs less, counting energy and faults (:mod:`.placed_faults`), and bars no way.
"""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.domains.home.attempt import RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.composing.adding import add_groups
from scenewright.domains.home.composing.anew import compose_anew
from scenewright.domains.home.composing.axis import slide_to_axis
from scenewright.domains.home.composing.bare_floor import furnish_bare_floor
from scenewright.domains.home.composing.bare_walls import furnish_bare_walls
from scenewright.domains.home.composing.bed_ways import list_closing
from scenewright.domains.home.composing.beds import move_double_bed, restore_double_bed
from scenewright.domains.home.composing.clothes import hang_in_closet, list_hung
from scenewright.domains.home.composing.coats import move_coats
from scenewright.domains.home.composing.forms import TABLES, list_forms
from scenewright.domains.home.composing.freeing import free_ways
from scenewright.domains.home.composing.fronts import cost_of_fronts
from scenewright.domains.home.composing.habitual import keep_habits
from scenewright.domains.home.composing.hall_tables import furnish_hall
from scenewright.domains.home.composing.judging import (
    JudgedRoom,
    Placed,
    RoomJudge,
    count_unmet,
    judge_of,
)
from scenewright.domains.home.composing.kitchen_faults import (
    cost_of_fridge,
    cost_of_stand,
    cost_of_washer,
)
from scenewright.domains.home.composing.kitchens.islands import add_island
from scenewright.domains.home.composing.kitchens.reform import reform_kitchen
from scenewright.domains.home.composing.kitchens.second_runs import list_given_up
from scenewright.domains.home.composing.kitchens.slits import close_slits
from scenewright.domains.home.composing.lounges import gather_seats
from scenewright.domains.home.composing.lounges import list_given_up as list_yielded
from scenewright.domains.home.composing.moving import with_margin
from scenewright.domains.home.composing.placed_faults import (
    cost_of_crowding,
    cost_of_group,
    cost_of_hearth,
    cost_of_screen,
    cost_of_shelves,
)
from scenewright.domains.home.composing.rows import close_gaps
from scenewright.domains.home.composing.seats_for_three import seat_three
from scenewright.domains.home.composing.trials import take_first, try_forms
from scenewright.domains.home.composing.views import cost_of_view, list_between
from scenewright.domains.home.composing.wardrobes import trim_wardrobe
from scenewright.domains.home.composing.wet_rooms import fill_wet_room
from scenewright.domains.home.composing.widening import widen_groups

IN_SIGHT = 100.0  # by so much what stands between seats and screen is tried before them


def compose(task: RoomTask, answer: RoomAnswer) -> RoomAnswer:
    """The answer with its groups better composed where that bars no way and takes nothing away.

    Rooms of wheelchair users keep the room to turn they were furnished with, rooms of learned
    groups what was learned (of learned habits: :mod:`.habitual`); presets that are not exact are
    left as they are.
    """
    habits = task.library.habits
    learned = bool(habits.clearances or habits.shares)
    rule = task.preset.settings.composing
    if task.accessible or not answer.placed or not task.preset.settings.exact:
        return answer
    if task.library.own.keys() - task.library.seated and not learned:
        return answer
    if learned:
        barred = frozenset(find_blocked(with_margin(task), answer.placed))
        return keep_habits(task, answer, barred)
    answer = answer._replace(placed=free_ways(task, answer.placed))
    barred = frozenset(find_blocked(with_margin(task), answer.placed))
    before = add_groups(task, answer, barred, lacking=True)
    placed = before.placed
    judge = judge_of(task, placed)
    best = restore_double_bed(task, judge.cost_of(placed), barred)
    if _worst_first(task, best.placed):
        best = move_double_bed(task, best, barred)
        best = _improve_all(judge_of(task, best.placed), best, barred)
        best = reform_kitchen(task, best, barred)
        best = _join_washer(task, best, barred)
        best = seat_three(task, gather_seats(task, best, barred), barred)
        best = hang_in_closet(task, best, barred)
        if len(best.placed) <= rule.few or count_unmet(task, best.placed) > 0:
            best = compose_anew(task, best, barred, _worst_first(task, best.placed))
        best = move_double_bed(task, best, barred)
    best = trim_wardrobe(task, slide_to_axis(task, best, barred))
    gone = list_given_up(before.placed, best.placed, "the kitchen takes its wall")
    gone = (*gone, *list_hung(before.placed, best.placed))
    gone = (*gone, *list_yielded(before.placed, best.placed))
    before = before._replace(placed=best.placed, missing=(*before.missing, *gone))
    better = add_groups(task, before, barred)
    better = add_island(task, better, barred)
    better = furnish_bare_walls(task, furnish_bare_floor(task, better, barred), barred)
    better = close_slits(task, close_gaps(task, better, barred), barred)
    better = furnish_hall(task, fill_wet_room(task, better, barred), barred)
    better = move_coats(task, widen_groups(task, better, barred), barred)
    return (
        better if count_unmet(task, better.placed) <= count_unmet(task, answer.placed) else answer
    )


def _improve_all(judge: RoomJudge, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with each faulty one in a better form or place, the worst first."""
    task, rule = judge.task, judge.task.preset.settings.composing
    for _ in range(rule.rounds):
        before = best.cost
        for name in _worst_first(task, best.placed):
            if not task.cancelled():
                best = _improve(judge, best, name, barred)
        if best.cost > before - rule.least:
            break
    return best


def _join_washer(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with a washing machine of a kitchen at the side of the run that stands by now."""
    if cost_of_washer(best.placed, 1.0) == 0.0 or task.cancelled():
        return best
    name = next(p.name for p in best.placed if p.wish.group == "washer")
    return _improve(judge_of(task, best.placed), best, name, barred)


def _worst_first(task: RoomTask, placed: Placed) -> list[str]:
    """The names of groups with a fault, the costliest first, what stands between seats and screen
    before these; of all where a wish is not met."""
    rule = task.preset.settings.composing
    view = 0.0 if len(task.ground.hearths) else cost_of_view(placed, rule.costs, task.ground.edges)
    whole = {
        "washer": cost_of_washer(placed, rule.costs.loose),
        "fridge": cost_of_fridge(placed, task.ground, rule),
        "wardrobe": cost_of_fronts(placed, rule.costs.doors),
        "storage": cost_of_shelves(placed, task.ground, rule.costs.shelves),
        "media": cost_of_screen(placed, task.ground, rule.costs.screen)
        + cost_of_stand(placed, rule.costs.beside_run)
        + view,
        "seating": cost_of_hearth(placed, task.ground, rule.costs.screen) + view,
    }
    whole |= dict.fromkeys(TABLES, cost_of_crowding(placed, rule.costs.crowded))
    unmet = float(count_unmet(task, placed) > 0)
    between = list_between(placed) if view > 0.0 else frozenset()
    closing = list_closing(placed, task.ground)
    costs = {
        p.name: cost_of_group(p, task.ground, rule)
        + whole.get(p.wish.group, 0.0)
        + unmet
        + IN_SIGHT * (p.name in between)
        + rule.costs.bed_way * (p.name in closing)
        for p in placed
        if p.wish.group not in task.library.own
    }
    return sorted((name for name, cost in costs.items() if cost > 0.0), key=lambda n: -costs[n])


def _improve(judge: RoomJudge, best: JudgedRoom, name: str, barred: frozenset[str]) -> JudgedRoom:
    """The groups with one of them in a better form or place, or as they were."""
    rule = judge.task.preset.settings.composing
    most = best.cost - rule.least
    found = _elsewhere(judge, best.placed, _number_of(best.placed, name), rule.forms, most)
    return take_first(judge.task, best, found, barred)


def _number_of(placed: Placed, name: str) -> int:
    return next(i for i, p in enumerate(placed) if p.name == name)


def _elsewhere(
    judge: RoomJudge, placed: Placed, at: int, forms: int, most: float
) -> Iterator[JudgedRoom]:
    """The groups with one of them in its better forms wherever along the walls it stands free, the
    cheapest first; of those that cost over ``most`` not all."""
    return try_forms(judge, placed, at, list_forms(judge.task, placed[at]), forms, most)
