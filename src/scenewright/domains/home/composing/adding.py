"""Groups that are added to a composed room."""

from __future__ import annotations

from scenewright.domains.home.attempt import FurnishedGroup, RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.composing.additions import forms_to_add, is_wanted, list_additions
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.moving import make_unplaced, try_forms, with_margin
from scenewright.domains.home.programme import Wish


def add_groups(
    task: RoomTask, answer: RoomAnswer, barred: frozenset[str], lacking: bool = False
) -> RoomAnswer:
    """The answer with what can still be taken in beside all others; only what is ``lacking``."""
    rule = task.preset.settings.composing
    for wish, lacks in list_additions(task, answer.placed, answer.missing):
        if lacking and not lacks:
            break
        still = all(lack in answer.missing for lack in lacks)
        if not still or not is_wanted(task, answer.placed, wish, lacks) or task.cancelled():
            continue
        worth = rule.lacking if lacks else rule.addition
        added = _best_added(task, answer.placed, wish, worth, barred)
        if added is not None:
            missing = tuple(m for m in answer.missing if m not in lacks)
            answer = answer._replace(placed=(*answer.placed, added), missing=missing)
    return answer


def _best_added(
    task: RoomTask, placed: Placed, wish: Wish, worth: float, barred: frozenset[str]
) -> FurnishedGroup | None:
    """One more group where the room as a whole costs least, at most what it is ``worth`` more; None
    if it stands nowhere without barring a way."""
    group = make_unplaced(task, placed, wish, forms_to_add(task, wish)[-1])
    judge = judge_of(task, (*placed, group))
    alone = judge_of(task, placed).cost_of(placed).cost if placed else 0.0
    found = try_forms(judge, (*placed, group), len(placed), forms_to_add(task, wish), 2)
    for judged in found:
        if judged.cost > alone + worth:
            break
        added = judged.placed[-1]
        if not added.dressed.lost and barred.issuperset(
            find_blocked(with_margin(task), judged.placed)
        ):
            return added
    return None
