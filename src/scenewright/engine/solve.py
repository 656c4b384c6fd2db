"""How solvers are asked: budgets, progress, cancelling, and the two contracts they may follow.

*Populations* (genetic, random …) are ask / tell: the solver proposes genes and gets energies, it
never sees the objective. *Chains* (annealing) run compiled inside, re-evaluating only what moved,
and are driven in slices (:mod:`scenewright.engine.pace`). Either way a solver is one function of
:data:`Run`, a row (:class:`scenewright.engine.rows.SolverRow`) of the table of its domain.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Any, Generic, NamedTuple, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from scenewright.core.layout import Layout
from scenewright.engine.asked import rate_unrated
from scenewright.engine.trace import Hear
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]
L = TypeVar("L")


class Report(NamedTuple):
    """What a run tells while it works: the share of its budget that is spent, 0 to 1, the energy of
    the best layout so far, and ``best``, which makes that layout of the domain. It may only be
    called before the listener returns: the run goes on with the same arrays."""

    share: float
    energy: float
    best: Callable[[], Any]


Progress = Callable[[Report], None]
Cancel = Callable[[], bool]
Objective = Callable[[Floats], Floats]
OnRound = Callable[[Any, int, float], None]


class Budget(NamedTuple):
    """What a run may use: seconds, or steps (looked-at layouts), whichever ends first; it also
    ends at an energy of ``target`` or below. ``threads`` is how many it may run on (``None``: one
    for each processor); ``hear`` gets the steps of a traced solver.

    Without ``seconds`` the result depends on the seed alone, on any machine and number of threads.
    """

    seconds: float | None = None
    steps: int | None = None
    target: float = -math.inf
    threads: int | None = None
    hear: Hear | None = None


class Found(NamedTuple, Generic[L]):
    """What a run found: distinct layouts of its domain, best first, and how many it looked at."""

    layouts: tuple[L, ...]
    evaluations: int


Run = Callable[[Any, Budget, int, Progress | None, Cancel | None], Found[Any]]
"""Solve a problem of the solver's domain."""


class BudgetWatch:
    """Tells how much of a budget is spent; started when made.

    >>> watch = BudgetWatch(Budget(steps=10), None, None)
    >>> watch.share(5), watch.over(5, 1.0, list), watch.over(10, 1.0, list)
    (0.5, False, True)
    """

    def __init__(self, budget: Budget, progress: Progress | None, cancel: Cancel | None) -> None:
        self.budget, self.progress, self.cancel = budget, progress, cancel
        self.start = time.perf_counter()

    def seconds(self) -> float:
        """Seconds since the start."""
        return time.perf_counter() - self.start

    def share(self, steps: int) -> float:
        """Share of the budget that is spent, 0 to 1."""
        by_time = self.seconds() / self.budget.seconds if self.budget.seconds else 0.0
        by_steps = steps / self.budget.steps if self.budget.steps else 0.0
        return min(max(by_time, by_steps), 1.0)

    def cancelled(self) -> bool:
        """Whether nobody waits for a better answer."""
        return self.cancel is not None and self.cancel()

    def over(self, steps: int, energy: float, best: Callable[[], Any]) -> bool:
        """Report progress, ``best`` being what makes the best layout so far; true if the run
        should end with what it has."""
        share = self.share(steps)
        if self.progress is not None:
            self.progress(Report(share, energy, best))
        return self.cancelled() or share >= 1.0 or energy <= self.budget.target

    def reached(self, share: float, best: Callable[[], Any]) -> bool:
        """Report a share of the work of a run that knows no energy (0 is reported); true if it
        should end."""
        spent = self.share(0)
        if self.progress is not None:
            self.progress(Report(max(share, spent), 0.0, best))
        return self.cancelled() or spent >= 1.0


class PopulationSolver(Protocol):
    """Ask / tell over genes ``(P, m)`` within bounds. State is a value; nothing else is kept.

    What was asked once is not asked again; what gets infinity or NaN is not rated, and never
    wins. Nothing to be asked means that there is nothing left to try.
    """

    def init(self, rng: np.random.Generator, low: Floats, high: Floats) -> Any:
        """The state before the first ask."""

    def ask(self, state: Any, rng: np.random.Generator) -> tuple[Floats, Any]:
        """Genes to be judged next."""

    def tell(self, state: Any, genes: Floats, energies: Floats) -> Any:
        """The state after hearing their energies."""


def run_population(
    solver: PopulationSolver,
    objective: Objective,
    low: Floats,
    high: Floats,
    rng: np.random.Generator,
    watch: BudgetWatch,
    layout_of: Callable[[Floats], Any],
    rounds: int | None = None,
    on_round: OnRound | None = None,
) -> tuple[Floats, Floats, int]:
    """Ask and tell until the budget (or ``rounds``) is spent.

    ``objective`` may leave genes unrated, as infinity or NaN, when the run is cancelled; they never
    win. ``layout_of`` makes the layout that genes (m,) stand for, for the listener; ``on_round``
    gets the state after each round, the evaluations made and the least energy. Returns the
    last population and every best on the way, as genes (k, m) best first, with their energies
    (k,), and the evaluations made.
    """
    state, done, count = solver.init(rng, low, high), 0, 0
    records: list[Floats] = []
    least = [math.inf]
    while True:
        genes, state = solver.ask(state, rng)
        if not len(genes):
            genes, energies = np.array(records), np.array(least[1:])
            order = np.argsort(energies, kind="stable")
            return genes[order], energies[order], done
        energies = rate_unrated(objective(genes))
        state = solver.tell(state, genes, energies)
        done, count = done + len(genes), count + 1
        first = int(energies.argmin())
        if energies[first] < least[-1] or not records:
            records.append(genes[first].copy())
            least.append(float(energies[first]))
        if on_round is not None:
            on_round(state, done, least[-1])
        if watch.over(done, least[-1], lambda: layout_of(records[-1])) or count == rounds:
            seen = np.concatenate([np.array(records).reshape(-1, len(low)), genes])
            rated = np.concatenate([least[1:], energies])
            order = np.argsort(rated, kind="stable")
            return seen[order], rated[order], done


def distinct(
    boxes: Floats, energies: Floats, keep: int = 8, apart: float = 0.5
) -> tuple[Layout, ...]:
    """The best layouts that differ: some item more than ``apart`` metres or radians away.

    ``boxes`` (P, n, 5), ``energies`` (P,); best first, at most ``keep``.
    """
    order, chosen = np.argsort(energies, kind="stable"), np.empty(keep, np.int64)
    count = choose_apart(np.ascontiguousarray(boxes, np.float64), order, apart, chosen)
    return tuple(Layout(boxes[k].copy(), float(energies[k])) for k in chosen[:count].tolist())


@compiled
def choose_apart(
    boxes: Floats, order: NDArray[np.int64], apart: float, chosen: NDArray[np.int64]
) -> int:
    """Write to ``chosen`` (k,) the first boxes (P, n, 5) in their ``order`` (P,) with some item
    more than ``apart`` metres or radians from its place in each one before; how many."""
    count = 0
    for number in range(order.shape[0]):
        here, unlike = order[number], True
        for c in range(count):
            unlike &= are_apart(boxes[here], boxes[chosen[c]], apart)
        if unlike and count < chosen.shape[0]:
            chosen[count] = here
            count += 1
    return count


@inlined
def are_apart(one: Floats, other: Floats, apart: float) -> bool:
    """Whether some item of boxes (n, 5) is more than ``apart`` metres or radians away."""
    for i in range(one.shape[0]):
        dx, dy = one[i, 0] - other[i, 0], one[i, 1] - other[i, 1]
        turned = abs((one[i, 2] - other[i, 2] + np.pi) % (2 * np.pi) - np.pi)
        if math.sqrt(dx * dx + dy * dy) > apart or turned > apart:
            return True
    return False
