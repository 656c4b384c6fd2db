"""Solving a fitted hall, again where the answer leaves something that nobody can get to."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from scenewright.catalog import Catalog
from scenewright.domains.hall.assign import Unit
from scenewright.domains.hall.fit import TRIES, Fitted
from scenewright.domains.hall.pose import Hall, pose
from scenewright.domains.hall.presets import HallPreset
from scenewright.domains.hall.wanted import Wanted
from scenewright.solve import Budget
from scenewright.solvers.hall_chains import MANY, HallFound, first_layout
from scenewright.solvers.halls import HALL_SOLVERS

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

ATTEMPTS = 4
"""How often a hall is solved while something in it cannot be reached."""
FIRST = 0.7
"""Share of the steps a user states that the first attempt gets."""
LARGE = 6
"""Groups of so many objects are tried in halves in the end."""


class Search(NamedTuple):
    """A hall to solve, and how; ``stated`` if a user said how many steps."""

    hall: Hall
    wishes: list[Wanted]
    preset: HallPreset
    solver: str
    budget: Budget
    seed: int
    catalog: Catalog
    stated: bool


def searched(
    search: Search, fitted: Fitted, progress: Progress | None, cancel: Cancel | None
) -> tuple[Fitted, HallFound]:
    """The solver's answer. While it leaves something that nobody reaches, or a passage too
    narrow, ours tries again: from other first layouts, then with large groups in halves. Of
    seconds or steps that a user states, a part is kept for that."""
    again = search.solver == "anneal" and not search.preset.whole
    attempts = ATTEMPTS if len(fitted.units) <= MANY else 2
    budget, tries, seen = search.budget, attempts if again else 1, 0
    if budget.seconds is not None:
        budget = budget._replace(seconds=budget.seconds / (1.5 if again else 1.0))
    elif again and search.stated and budget.steps is not None:
        budget = budget._replace(steps=max(int(FIRST * budget.steps), 1))
    answers: list[tuple[float, int, Fitted, HallFound]] = []
    for attempt in range(tries):
        seed = search.seed + 104_729 * attempt
        if attempt > 0 and attempt + 1 == tries:
            fitted = halved(search, fitted, seed)
        run = HALL_SOLVERS[search.solver].run
        heard = None if progress is None else _heard(progress, attempt)
        found = run(fitted.problem, fitted.start, budget, seed, heard, cancel)
        seen += found.evaluations
        wrong = found.layouts[0].missed + found.layouts[0].lacking
        answers.append((wrong, attempt, fitted, found))
        if wrong == 0.0 or (cancel is not None and cancel()):
            break
        if budget.seconds is not None:
            budget = budget._replace(seconds=0.5 * budget.seconds)
        elif search.stated and search.budget.steps is not None:
            rest = (1.0 - FIRST) / (ATTEMPTS - 1)
            budget = budget._replace(steps=max(int(rest * search.budget.steps), 1))
    _, _, fitted, found = min(answers, key=lambda answer: answer[:2])
    return fitted, found._replace(evaluations=seen)


def _heard(progress: Progress, attempt: int) -> Callable[[float, float], None]:
    """Tells how far a search is, and never goes back: all is done but for the attempts after
    the first."""
    again = f", attempt {attempt + 1} of {ATTEMPTS}" if attempt else ""
    return lambda share, best: progress(1.0 if attempt else share, f"energy {best:.1f}{again}")


def halved(search: Search, fitted: Fitted, seed: int) -> Fitted:
    """The same with every free group of six or more in two; unchanged if that finds no room."""
    units: list[Unit] = []
    for unit in fitted.units:
        middle = (unit.first + unit.last + 1) // 2
        if unit.last - unit.first >= LARGE and not search.wishes[unit.demand].at_wall:
            units += [unit._replace(last=middle), unit._replace(first=middle)]
        else:
            units.append(unit)
    problem = pose(search.hall, search.wishes, units, fitted.hosts, search.preset.weights,
                   search.catalog)  # fmt: skip
    start, lost = first_layout(problem, fitted.start.walls, seed, TRIES)
    return fitted if lost else fitted._replace(units=units, problem=problem, start=start)
