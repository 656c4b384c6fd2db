"""Groups that are added to a composed room."""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    bars_no_more,
)
from scenewright.domains.home.composing.filling.additions import (
    forms_to_add,
    is_wanted,
    list_additions,
)
from scenewright.domains.home.composing.filling.talking import joins_sofa
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.places.moving import make_unplaced, with_margin
from scenewright.domains.home.composing.places.trials import try_forms
from scenewright.domains.home.programme import WELCOME, Wish


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
        if wish.group == "reading":
            worth = rule.costs.seats
        for rest, gone in _list_rooms(answer.placed, lacks):
            added = _best_added(task, rest, wish, worth, barred)
            if added is not None:
                missing = (*(m for m in answer.missing if m not in lacks), *gone)
                answer = answer._replace(placed=(*rest, added), missing=missing)
                break
    return answer


def _list_rooms(
    placed: Placed, lacks: tuple[Missing, ...]
) -> Iterator[tuple[Placed, tuple[Missing, ...]]]:
    """What a group is added beside, and what that costs: all that stands; for something lacking
    also all but one thing that is merely welcome."""
    yield placed, ()
    for other in placed if lacks else ():
        if other.wish.rank == WELCOME and not other.wish.required:
            gone = Missing(other.wish, f"it makes room for the {lacks[0].wish.group}")
            yield tuple(p for p in placed if p is not other), (gone,)


def _best_added(
    task: RoomTask, placed: Placed, wish: Wish, worth: float, barred: frozenset[str]
) -> FurnishedGroup | None:
    """One more group where the room as a whole costs least, at most what it is ``worth`` more; None
    if it stands nowhere without barring a way."""
    group = make_unplaced(task, placed, wish, forms_to_add(task, wish)[-1])
    judge = judge_of(task, (*placed, group))
    alone = judge_of(task, placed).cost_of(placed).cost if placed else 0.0
    forms = forms_to_add(task, wish)
    count = len(forms) if wish.small else 2
    found = try_forms(judge, (*placed, group), len(placed), forms, count, alone + worth)
    for judged in found:
        if judged.cost > alone + worth:
            break
        added = judged.placed[-1]
        if wish.group == "reading" and not joins_sofa(added, placed):
            continue
        if not added.dressed.lost and bars_no_more(with_margin(task), judged.placed, barred):
            return added
    return None
