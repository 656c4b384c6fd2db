"""What a person locks stays where it stands in the champion, in all that is bred from then on."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from scenewright import domains
from scenewright.core.brief import Brief
from scenewright.core.registry import domain_of
from scenewright.core.solution import Solution
from scenewright.engine.preference.events import Event, Lock, champion_of


def name_epoch(events: Sequence[Event]) -> str:
    """The epoch that ``events`` lead to: every lock with the champion it was said of; empty
    without locks.

    >>> from scenewright.engine.preference.events import Keep
    >>> name_epoch([Keep(4), Lock("church"), Keep(9)])
    '4:church'
    """
    said = [(champion_of(events[:k]), e.name) for k, e in enumerate(events) if isinstance(e, Lock)]
    return ";".join(f"{champion}:{name}" for champion, name in said if champion is not None)


def lock_brief(epoch: str, solution_of: Callable[[int], Solution]) -> Brief:
    """The brief that an epoch's candidates are bred on: what was locked last in one champion
    stands there as it does in it."""
    pairs = [part.split(":", 1) for part in epoch.split(";")]
    champion = pairs[-1][0]
    solution = solution_of(int(champion))
    names = [name for number, name in pairs if number == champion]
    locked = domains.adjust(solution, lock=names).solution
    brief: Brief = domain_of(locked.brief.domain).verb("locked")(locked)
    return brief
