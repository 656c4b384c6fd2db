"""A room laid out anew for one need of the household, with what is owed kept and comforts last."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from operator import ge

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask
from scenewright.domains.home.cases.library import index_cases
from scenewright.domains.home.composing.compose import compose
from scenewright.domains.home.composing.homewide.settling import measure_case
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.placed_faults import list_standing
from scenewright.domains.home.composing.verdict import LESS, measure_held
from scenewright.domains.home.needs.table import NEEDS
from scenewright.domains.home.programme import WELCOME, Wish, is_essential
from scenewright.domains.home.wheelchair import furnish_by_use
from scenewright.engine.solve import Budget

OWED = frozenset[str]().union(*(need.groups for need in NEEDS)) - {"reading", "shelf", "sideboard"}
"""Groups that a room is laid out anew with; all others wait."""
LATER = "what the household needs comes before it"


def solve_for(
    task: RoomTask,
    wishes: Sequence[Wish],
    budget: Budget,
    before: RoomAnswer,
    need: Wish,
    forms: Sequence[Group],
    spare: float = 0.0,
) -> Iterator[RoomAnswer]:
    """The room with a need in one of its forms, if it then holds no less than ``before`` but for
    ``spare`` metres of storage: what is owed and the need first, all else in the floor that is
    left."""
    owed = (w for w in wishes if w.group in OWED and w.rank < WELCOME)
    first = (*(w for w in wishes if w.core or w.required), *owed)
    first = tuple(dict.fromkeys(first))
    by_group = {
        name: [f for f in forms if f.function == name] for name in {f.function for f in forms}
    }
    own = {name: index_cases(tuple(each)) for name, each in by_group.items()}
    library = task.library._replace(
        own={**task.library.own, **own}, seated=task.library.seated | own.keys()
    )
    for name in sorted(own):
        anew = task._replace(library=library, progress=None, watch=None)
        answer = furnish_by_use(anew, (*first, need._replace(group=name, small=True)), budget)
        if not any(p.wish.group == name for p in answer.placed):
            continue
        gone = tuple(Missing(w, LATER) for w in wishes if w not in first)
        answer = compose(anew, answer._replace(missing=(*answer.missing, *gone)))
        if holds_no_less(before, answer, spare):
            yield answer._replace(drafts=())


def holds_no_less(before: RoomAnswer, after: RoomAnswer, spare: float = 0.0) -> bool:
    """Whether a room lacks nothing essential that it had, and holds no less of anything but for
    ``spare`` metres of storage.

    >>> empty = RoomAnswer(0.0, (), (), (), None, 0.0, 0)
    >>> holds_no_less(empty, empty)
    True
    """
    old, new = _count_lacks(before), _count_lacks(after)
    if new > old or after.unreached or len(after.gone) > len(before.gone):
        return False
    had, has = measure_held(before.placed), measure_held(after.placed)
    enough = has["worktop"] >= had["worktop"] - LESS["worktop"] and has["places"] >= had["places"]
    enough &= has["storage"] >= had["storage"] - max(LESS["storage"], spare)
    return enough and all(map(ge, _sum_held(after.placed), _sum_held(before.placed)))


def _count_lacks(answer: RoomAnswer) -> int:
    return sum(is_essential(m.wish) and not m.replaced for m in answer.missing)


def _sum_held(placed: Placed) -> tuple[float, ...]:
    """Sleepers, nightstands, places to work and soft places of groups."""
    each = [measure_case(list_standing(group))[:4] for group in placed]
    return tuple(map(sum, zip(*each, strict=True))) if each else (0.0,) * 4
