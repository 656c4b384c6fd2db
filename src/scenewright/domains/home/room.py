"""Furnish one room: try all wishes at once, then with less, then fill what room is left."""

from __future__ import annotations

import numpy as np

from scenewright.domains.home.attempts.attempt import (
    Missing,
    RoomAnswer,
    RoomTask,
    attempt,
    build_task_problem,
    furnish_layout,
    hear_groups,
    penalty,
)
from scenewright.domains.home.attempts.piecewise import piecewise
from scenewright.domains.home.programme import FALLBACK, Wish, instead_of
from scenewright.domains.home.settings import FaultCosts, TrySettings
from scenewright.domains.home.solvers import SOLVERS
from scenewright.engine.solve import Budget

LEAST_SHARE = 1 / 3
"""Of the stated steps for an item, those it takes in a room with few: composed anew in any case."""


def furnish(task: RoomTask, wishes: tuple[Wish, ...], budget: Budget) -> RoomAnswer:
    """The best answer found: all wishes at once; if that fails, what held and fallbacks for the
    rest; then, where only a way is missing, the same afresh; then the core alone; what is still
    missing is tried in the room that is left. The same wishes are tried again only afresh, or
    because a place that is wished for is not met. Presets that are not exact, and solvers that
    place single pieces, try once."""
    if SOLVERS[task.solver].encoding == "pieces":
        return piecewise(task, wishes, budget)
    if not task.preset.settings.exact:
        return attempt(task, wishes, budget, task.seed)
    rule = task.preset.settings.tries
    best = attempt(task, wishes, share_of(budget, rule.first, rule), task.seed)
    if budget.seconds is not None and _sound(best) and not task.cancelled():
        rest = budget._replace(seconds=budget.seconds * (1 - rule.first / _all_shares(rule)))
        return _better(best, attempt(task, wishes, rest, task.seed + 1))
    known = {_sort_wishes(wishes)}
    for round_, fewer in enumerate(FEWER, 1):
        again = () if _sound(best) or task.cancelled() else fewer(best, wishes, rule)
        if again and (fewer is _afresh or _sort_wishes(again) not in known):
            known.add(_sort_wishes(again))
            tried = attempt(task, again, share_of(budget, rule.again, rule), task.seed + round_)
            best = _better(best, _report_dropped(tried, wishes, best, task.costs))
    for round_ in range(rule.unmet if budget.seconds is None else 0):
        if best.unmet and not task.cancelled():
            seed = task.seed + len(FEWER) + 1 + round_
            tried = attempt(task, wishes, share_of(budget, rule.again, rule), seed)
            best = _better(best, _report_dropped(tried, wishes, best, task.costs))
    if not best.missing or task.cancelled():
        return best
    return fill_rest(task, best, share_of(budget, rule.fill, rule))


def _sort_wishes(wishes: tuple[Wish, ...]) -> tuple[Wish, ...]:
    return tuple(sorted(wishes, key=repr))


def _sound(answer: RoomAnswer) -> bool:
    """Nothing essential is missing and everything can be reached."""
    return not answer.unreached and not any(m.wish.rank == 0 for m in answer.missing)


def _keep_standing(
    answer: RoomAnswer, wishes: tuple[Wish, ...], _: TrySettings
) -> tuple[Wish, ...]:
    """What stood and could be reached, and fallbacks for the essential that did not or that bars
    a way."""
    kept: list[Wish] = []
    for wish in wishes:
        stood = [p for p in answer.placed if _is_same(p.wish, wish)]
        if _is_reached(answer, wish):
            kept.append(stood[0].wish)
        elif wish.rank == 0 or (wish.group in FALLBACK and not stood):
            kept += instead_of(wish)
    return tuple(kept)


def _is_reached(answer: RoomAnswer, wish: Wish) -> bool:
    """Whether a wish stands, in any size, and neither it nor a door is cut off."""
    stood = [p for p in answer.placed if _is_same(p.wish, wish)]
    return bool(stood) and stood[0].name not in answer.unreached and not _is_barred(answer)


def _is_same(placed: Wish, wish: Wish) -> bool:
    """Whether what was placed was wished for, if in another size."""
    return placed._replace(small=wish.small, becoming=wish.becoming) == wish


def _shrink(answer: RoomAnswer, wishes: tuple[Wish, ...], rule: TrySettings) -> tuple[Wish, ...]:
    """The essential that did not stand in a modest size (in any, if another group would take its
    place), the rest as it was."""

    def shrunk(wish: Wish) -> Wish:
        if wish.rank > 0 or _is_reached(answer, wish):
            return wish
        small = wish.small or wish.group in FALLBACK
        return wish._replace(small=small, becoming=min(wish.becoming, rule.modest))

    return tuple(shrunk(wish) for wish in wishes)


def _afresh(answer: RoomAnswer, _: tuple[Wish, ...], rule: TrySettings) -> tuple[Wish, ...]:
    """All that is placed, to be laid out anew, if something of a roomy room is out of reach."""
    if not answer.unreached or len(answer.placed) < rule.roomy:
        return ()
    return tuple(p.wish for p in answer.placed)


def _is_barred(answer: RoomAnswer) -> bool:
    """True if a door or fixed piece is cut off."""
    return bool(set(answer.unreached) - {p.name for p in answer.placed})


def _core(answer: RoomAnswer, wishes: tuple[Wish, ...], _: TrySettings) -> tuple[Wish, ...]:
    """What makes the room's functions alone, in its smallest form, unless all of it stands and can
    be reached."""
    if not answer.unreached and all(_is_reached(answer, w) for w in wishes if w.core):
        return ()
    return tuple(other for w in wishes if w.core for other in instead_of(w))


def fill_rest(task: RoomTask, answer: RoomAnswer, budget: Budget) -> RoomAnswer:
    """Try the missing groups in the space left, with placed groups taken as fixed."""
    wanted = [m.wish for m in answer.missing if m.wish.rank < 2 or len(answer.missing) < 4]
    wishes = tuple(w._replace(small=True) for w in wanted)
    taken = np.array([p.dressed.box for p in answer.placed]).reshape(-1, 5)
    ground = task.ground._replace(obstacles=np.concatenate([task.ground.obstacles, taken]))
    problem = build_task_problem(task, wishes, ground)
    listener = hear_groups(task, tuple(w.group for w in wishes), answer.placed)
    found = SOLVERS[task.solver].run(problem, budget, task.seed, listener, task.cancel)
    best = answer
    others = tuple(m for m in answer.missing if m.wish not in wanted)
    lacking = sum(penalty(m.wish, task.costs) for m in others)
    for layout in found.layouts[: task.preset.settings.tries.fills]:
        more = furnish_layout(
            task, wishes, problem, layout.boxes, answer.energy, answer.placed, best.score - lacking
        )
        more = more._replace(missing=(*more.missing, *others), score=more.score + lacking)
        best = min(best, more, key=lambda a: a.score)
    return best._replace(evaluations=answer.evaluations + found.evaluations)


def _report_dropped(
    tried: RoomAnswer, wishes: tuple[Wish, ...], before: RoomAnswer, costs: FaultCosts
) -> RoomAnswer:
    """A later answer, also telling what it no longer attempted, scored against all wishes."""
    asked = [p.wish for p in tried.placed] + [m.wish for m in tried.missing]
    groups = [w.group for w in asked]
    why = {m.wish.group: m.reason for m in before.missing}
    dropped, instead = [], 0
    for wish in wishes:
        if wish.group in groups:
            groups.remove(wish.group)
        elif FALLBACK.get(wish.group) in groups:
            groups.remove(FALLBACK[wish.group])
            instead += 1
        else:
            dropped.append(Missing(wish, why.get(wish.group, "no room is left beside the rest")))
    score = tried.score + sum(penalty(m.wish, costs) for m in dropped) + costs.fallback * instead
    return tried._replace(missing=(*tried.missing, *dropped), score=score)


def _better(first: RoomAnswer, second: RoomAnswer) -> RoomAnswer:
    evaluations = first.evaluations + second.evaluations
    return (second if second.score < first.score else first)._replace(evaluations=evaluations)


def count_steps(task: RoomTask, each: int, items: int) -> int:
    """The steps for a room with ``items`` items, each of which takes ``each`` in a crowded room:
    in proportion to ``items``, but at least a third of that, or all of it."""
    least = 1.0 if _needs_all_steps(task) else LEAST_SHARE
    return int(each * max(items, 1) * max(items / task.preset.settings.tries.crowded, least))


def _needs_all_steps(task: RoomTask) -> bool:
    """Whether somebody asked for groups or places in a room, outlets tell where some go, or it is
    not composed anew: for wheelchairs, by learned habits, or of groups of one's own."""
    asks = task.asked is not None and bool(task.asked.ask or task.asked.wishes)
    own = task.library.own.keys() - task.library.seated
    return asks or bool(task.space.outlets or task.accessible or own)


def share_of(budget: Budget, share: float, rule: TrySettings) -> Budget:
    """A share of the work; all shares a room may take together stay within its seconds."""
    return budget._replace(
        seconds=None if budget.seconds is None else budget.seconds * share / _all_shares(rule),
        steps=None if budget.steps is None else max(1, int(budget.steps * share)),
    )


FEWER = (_shrink, _keep_standing, _afresh, _afresh, _afresh, _core)


def _all_shares(rule: TrySettings) -> float:
    return rule.first + len(FEWER) * rule.again + rule.fill
