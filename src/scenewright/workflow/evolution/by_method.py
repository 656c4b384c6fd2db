"""An evolution by one of the interactive genetic algorithms, instead of ours."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from scenewright import domains
from scenewright.core.breeding import Genome, MatrixBreeder
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.engine.preference.events import (
    MOST_STARS,
    Event,
    Keep,
    Lock,
    Pick,
    Stars,
    Worst,
    champion_of,
    counting,
)
from scenewright.engine.preference.interactive.crowd import Crowd, follow
from scenewright.engine.preference.interactive.methods import InteractiveMethod, method_named
from scenewright.workflow.evolution.history import History
from scenewright.workflow.evolution.population import BredLayout


class MethodRun(NamedTuple):
    """A run of an evolution by a paper's method: the method, the matrix it breeds, the seed."""

    method: InteractiveMethod
    matrix: MatrixBreeder
    seed: int

    def crowd(self, history: History, bred: Mapping[int, BredLayout], sheets: int) -> Crowd:
        """Where the method is after the first ``sheets`` sheets: what was said of each counts as it
        did when the next was asked for."""
        heard = list[dict[Genome, float]]()
        for number, screen in enumerate(history.screens[:sheets]):
            last = number + 1 == len(history.screens)
            said = history.events if last else history.before_screen(number + 1)
            stars = stars_of(counting(said))
            heard.append({bred[n].genome: stars[n] for n in screen.shown if n in stars})
        return follow(self.method, self.matrix, self.seed, heard)


def make_run(name: str, brief: Brief, plan: Plan, seed: int) -> MethodRun:
    """The run of a method by its name, over the matrix code of a brief."""
    return MethodRun(method_named(name), domains.matrix_breeder_of(brief, plan, seed), seed)


def stars_of(events: Sequence[Event]) -> dict[int, float]:
    """Stars of candidates by what was said: those given, 5 for the best of a sheet or what was
    kept, 1 for the worst.

    >>> stars_of([Stars(4, 3, 0), Pick(5, (4, 5)), Worst(6, (4, 6))])
    {4: 3.0, 5: 5.0, 6: 1.0}
    """
    found = dict[int, float]()
    for event in events:
        match event:
            case Stars(candidate, stars, _):
                found[candidate] = float(stars)
            case Pick(candidate, _) | Keep(candidate):
                found[candidate] = float(MOST_STARS)
            case Worst(candidate, _):
                found[candidate] = 1.0
    return found


def best_rated(events: Sequence[Event]) -> int | None:
    """The champion, if there is one; else the last of those with the most stars.

    >>> best_rated([Stars(4, 3, 0), Stars(5, 4, 0), Stars(6, 2, 0)])
    5
    """
    champion, stars = champion_of(events), stars_of(counting(events))
    if champion is not None or not stars:
        return champion
    most = max(stars.values())
    return [candidate for candidate, given in stars.items() if given == most][-1]


def refuse(event: Event | str) -> None:
    """Raise :class:`InputError` for what no method hears: locks, moves, rounds without anybody."""
    if isinstance(event, Lock | str):
        what = "lock" if isinstance(event, Lock) else event
        raise InputError(f"'{what}' is not heard by this method", "give stars: 3=5")
