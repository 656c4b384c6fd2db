"""Solving a fitted hall, again where the answer leaves something that nobody can get to."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from scenewright.core.catalog import Catalog
from scenewright.core.layout import Boxes, NamedBox, Watch, name_rows
from scenewright.core.passes import ALL_PASSES, PassOptions
from scenewright.domains.hall.build_problem import HallContext, build_problem
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.fit import Fitted, build_hosts
from scenewright.domains.hall.presets import HallPreset
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.seats.seating import bare_tables
from scenewright.domains.hall.settings import SearchSettings
from scenewright.domains.hall.solvers import HALL_SOLVERS
from scenewright.domains.hall.solvers.chains import cooled_hall, first_layout
from scenewright.domains.hall.solvers.outcome import (
    HallFound,
    MeasuredLayout,
    StartedHall,
    measure_layout,
)
from scenewright.domains.hall.terms.table import SPACE, space_cost
from scenewright.domains.hall.zoning.assign import Unit
from scenewright.engine.solve import Budget, Found, Report
from scenewright.engine.watched import add_watch, show

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]
OnReport = Callable[[Report], None]

WAYS = ("access", "reach")
"""The faults of a layout that cost anything."""


class HallSearch(NamedTuple):
    """A hall to solve, and how; ``stated`` if a user said how many steps; ``watch`` gets the
    best layouts of objects, ``passes`` switches retouches off or hears of them."""

    hall: HallContext
    wishes: list[HallDemand]
    preset: HallPreset
    solver: str
    budget: Budget
    seed: int
    catalog: Catalog
    stated: bool
    watch: Watch | None = None
    passes: PassOptions = ALL_PASSES


class Answer(NamedTuple):
    """What one attempt found: objects and doors nobody reaches plus metres that passages lack, how
    crowded it is (:func:`measure_crowding`), for which units, and the layouts."""

    wrong: float
    crowding: float
    fitted: Fitted
    found: HallFound

    @property
    def rank(self) -> tuple[float, float]:
        """The key answers are compared by: faults, then the energy."""
        return self.wrong, self.found.layouts[0].energy


def search_layout(
    search: HallSearch, fitted: Fitted, progress: Progress | None, cancel: Cancel | None
) -> tuple[Fitted, HallFound]:
    """The solver's answer. While it leaves something that nobody reaches, or a passage too
    narrow, ours tries again: from other first layouts, then with large groups in halves; once more
    where it is crowded, with more walls if there is a place for them. Of seconds or steps that a
    user states, a part is kept for that; what is left of them in the end improves the answer."""
    again = may_retry(search)
    shared = again and (search.stated or search.budget.seconds is not None)
    rule, many = search.preset.settings.search, search.preset.settings.chains.many
    tries = 1 if not again else rule.attempts if len(fitted.units) <= many else 2
    begun, answers = time.perf_counter(), list[Answer]()
    for attempt in range(tries):
        seed = search.seed + 104_729 * attempt
        if attempt > 0 and attempt + 1 == tries and answers[-1].wrong > 0.0:
            fitted = halve_groups(search, fitted, seed)
        elif attempt == 1 and answers[0].crowding > rule.crowded:
            fitted = add_walls(search, fitted, seed)
        share = rule.again if attempt else rule.first
        budget = take_share(search.budget, share) if shared else search.budget
        on_progress = _make_progress_reporter(progress, attempt, shared, rule)
        on_progress = _watch_objects(search, fitted, on_progress)
        run = HALL_SOLVERS[search.solver].run
        problem = weigh_wrong(fitted.problem) if shared and attempt else fitted.problem
        found = run(StartedHall(problem, fitted.start), budget, seed, on_progress, cancel)
        answers.append(_answer(fitted, found))
        if _suffices(answers, rule) or (cancel is not None and cancel()):
            break
    seen = sum(answer.found.evaluations for answer in answers)
    best = min(answers, key=lambda answer: answer.rank)
    if shared and not (cancel is not None and cancel()):
        rest = _rest(search.budget, seen, time.perf_counter() - begun)
        on_progress = _make_progress_reporter(progress, rule.attempts, shared, rule)
        on_progress = _watch_objects(search, best.fitted, on_progress)
        found = _improve_answer(best, rest, search.seed, on_progress, cancel)
        seen, best = seen + found.evaluations - best.found.evaluations, best._replace(found=found)
    return best.fitted, best.found._replace(evaluations=seen)


def may_retry(search: HallSearch) -> bool:
    """Whether a solver may try again, and groups may be split or given up: ours may."""
    return search.solver == "anneal" and not search.preset.settings.whole


def _answer(fitted: Fitted, found: HallFound) -> Answer:
    best = found.layouts[0]
    return Answer(measure_wrong(best), measure_crowding(fitted.problem, best), fitted, found)


def _suffices(answers: list[Answer], rule: SearchSettings) -> bool:
    """Whether no further attempt is made: nothing is wrong, and it is not crowded or was tried
    twice, three times where it is ten times as crowded."""
    last = answers[-1]
    again = 1 if last.crowding <= 10.0 * rule.crowded else 2
    return last.wrong == 0.0 and (last.crowding <= rule.crowded or len(answers) > again)


def measure_crowding(problem: HallProblem, layout: MeasuredLayout) -> float:
    """How far E_s (eq. 1) of all groups of a layout lies above its least, unweighted."""
    p, s, _ = measure_layout(problem, layout)
    least = space_cost(0.0, 1.0)
    return float((s.costs[SPACE, : len(p.spans)] - least).sum())


def measure_wrong(layout: MeasuredLayout) -> float:
    """Objects and doors nobody reaches, and metres that passages lack."""
    return layout.missed + layout.lacking


def _rank(layout: MeasuredLayout) -> tuple[float, float]:
    return measure_wrong(layout), layout.energy


def take_share(budget: Budget, share: float) -> Budget:
    """A part of a budget, whether of seconds, of steps or of both."""
    steps = None if budget.steps is None else max(int(share * budget.steps), 1)
    seconds = None if budget.seconds is None else share * budget.seconds
    return budget._replace(steps=steps, seconds=seconds)


def _rest(budget: Budget, steps: int, seconds: float) -> Budget:
    """The rest of a budget."""
    left = None if budget.steps is None else max(budget.steps - steps, 0)
    time_left = None if budget.seconds is None else max(budget.seconds - seconds, 0.0)
    return budget._replace(steps=left, seconds=time_left)


def _improve_answer(
    answer: Answer, rest: Budget, seed: int, progress: OnReport | None, cancel: Cancel | None
) -> HallFound:
    """What was found, cooled again for as long as there is; never worse. While something is
    wrong, that weighs more than all else."""
    if rest.steps == 0 or rest.seconds == 0.0:
        return answer.found
    problem = answer.fitted.problem if answer.wrong == 0.0 else weigh_wrong(answer.fitted.problem)
    start = answer.found.layouts[0].kept
    more = cooled_hall(problem, start, rest, seed, progress, cancel)
    layouts = sorted((*answer.found.layouts, *more.layouts), key=_rank)
    return Found(tuple(layouts), answer.found.evaluations + more.evaluations)


def weigh_wrong(problem: HallProblem) -> HallProblem:
    """The same problem with more weight on what must not be wrong."""
    wrong = problem.settings.search.wrong
    heavy = {name: wrong * weight for name, weight in problem.weights.items() if name in WAYS}
    return problem._replace(weights=problem.weights | heavy)


def _make_progress_reporter(
    progress: Progress | None, attempt: int, shared: bool, rule: SearchSettings
) -> OnReport | None:
    """Tells how far a search is, and never goes back. Attempts that share a budget have their
    parts of it, the improvement (after the last) the rest; else all is done but for the attempts
    after the first."""
    if progress is None:
        return None
    again = f", attempt {attempt + 1} of {rule.attempts}" if 0 < attempt < rule.attempts else ""
    low, high = float(attempt > 0), 1.0
    if shared:
        low = rule.first + rule.again * (attempt - 1) if attempt else 0.0
        high = rule.first + rule.again * attempt if attempt < rule.attempts else 1.0

    def pass_on(report: Report) -> None:
        progress(low + (high - low) * report.share, f"energy {report.energy:.1f}{again}")

    return pass_on


def _watch_objects(
    search: HallSearch, fitted: Fitted, on_progress: OnReport | None
) -> OnReport | None:
    """A listener that tells who watches of the objects, by the ids of their demands and without
    the chairs at them."""

    def rows(layout: MeasuredLayout) -> tuple[NamedBox, ...]:
        return name_objects(search, fitted, layout.boxes)

    return add_watch(on_progress, search.watch, search.hall.space.id, rows)


def name_objects(search: HallSearch, fitted: Fitted, boxes: Boxes) -> tuple[NamedBox, ...]:
    """Objects by the ids of their demands, without the chairs at them."""
    each = [search.wishes[unit.demand] for unit in fitted.units for _ in range(*unit[2:4])]
    return name_rows([wish.id for wish in each], bare_tables(each, boxes))


def show_objects(
    search: HallSearch, fitted: Fitted, boxes: Callable[[], Boxes], stage: str, reason: str
) -> None:
    """Show objects as they stand to who watches, if anybody does, with what changed them."""
    rows = partial(_make_rows, search, fitted, boxes)
    show(search.watch, search.hall.space.id, rows, stage, reason)


def show_found(
    search: HallSearch, fitted: Fitted, before: HallFound, now: HallFound, stage: str, reason: str
) -> None:
    """Show the best layout if it is another than before."""
    if now.layouts[0] is not before.layouts[0]:
        show_objects(search, fitted, lambda: now.layouts[0].boxes, stage, reason)


def _make_rows(
    search: HallSearch, fitted: Fitted, boxes: Callable[[], Boxes]
) -> tuple[NamedBox, ...]:
    return name_objects(search, fitted, boxes())


def halve_groups(search: HallSearch, fitted: Fitted, seed: int) -> Fitted:
    """The same with every free group of six or more in two; unchanged if that finds no room."""
    settings, units = search.preset.settings, list[Unit]()
    large = settings.search.large
    for unit in fitted.units:
        middle = (unit.first + unit.last + 1) // 2
        if unit.last - unit.first >= large and not search.wishes[unit.demand].at_wall:
            units += [unit._replace(last=middle), unit._replace(first=middle)]
        else:
            units.append(unit)
    problem = build_problem(
        search.hall, search.wishes, units, fitted.hosts, search.preset.weights, search.catalog
    )
    start, lost = first_layout(problem, fitted.start.walls, seed, settings.fit.tried)
    return fitted if lost else fitted._replace(units=units, problem=problem, start=start)


def add_walls(search: HallSearch, fitted: Fitted, seed: int) -> Fitted:
    """The same with walls on further borders, as many as the paper builds (a metre between all
    objects at walls); unchanged if that builds none, or something then finds no room."""
    hosts = build_hosts(search.hall, search.wishes, fitted.units, True)
    there = {host.row for host in fitted.hosts}
    more = tuple(host for host in hosts if host.row not in there)
    if not more:
        return fitted
    hosts = (*fitted.hosts, *more)
    problem = build_problem(
        search.hall, search.wishes, fitted.units, hosts, search.preset.weights, search.catalog
    )
    spans = np.array([host.span for host in hosts]).reshape(-1, 2)
    rule = search.preset.settings.fit
    for chance in range(rule.chances):
        start, lost = first_layout(problem, spans, seed + chance, 2 * rule.tried)
        if not lost:
            return Fitted(fitted.units, hosts, problem, start)
    return fitted
