"""How solvers are asked: budgets, progress, cancelling, and the two contracts they may follow.

*Populations* (genetic, random …) are ask / tell: the solver proposes genes and hears energies, it
never sees the objective. *Chains* (annealing) run compiled inside, re-evaluating only what moved,
and are driven in slices (:mod:`scenewright.domains.home.solvers.anneal`). Either way a solver is
one function of :data:`Run`, a row of :data:`scenewright.domains.home.solvers.SOLVERS`.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from scenewright.core.layout import Layout

Floats = NDArray[np.float64]
Progress = Callable[[float, float], None]
Cancel = Callable[[], bool]
Objective = Callable[[Floats], Floats]


class Budget(NamedTuple):
    """What a run may use: seconds, or steps (looked-at layouts), whichever ends first; it also
    ends at an energy of ``target`` or below. ``threads`` is how many it may run on (``None``: one
    for each processor).

    Without ``seconds`` the result depends on the seed alone, on any machine and number of threads.
    """

    seconds: float | None = None
    steps: int | None = None
    target: float = -math.inf
    threads: int | None = None


class Found(NamedTuple):
    """What a run found: distinct layouts, best first, and how many it looked at."""

    layouts: tuple[Layout, ...]
    evaluations: int


Run = Callable[[Any, Budget, int, Progress | None, Cancel | None], Found]
"""Solve a problem of the solver's domain."""


class BudgetWatch:
    """Tells how much of a budget is spent; started when made.

    >>> watch = BudgetWatch(Budget(steps=10), None, None)
    >>> watch.share(5), watch.over(5, 1.0), watch.over(10, 1.0)
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

    def over(self, steps: int, best: float) -> bool:
        """Report progress; true if the run should end with what it has."""
        share = self.share(steps)
        if self.progress is not None:
            self.progress(share, best)
        cancelled = self.cancel is not None and self.cancel()
        return cancelled or share >= 1.0 or best <= self.budget.target


class Population(NamedTuple):
    """What every population solver keeps: genes (P, m) and their energies (P,)."""

    genes: Floats
    energies: Floats
    round: int = 0


class PopulationSolver(Protocol):
    """Ask / tell over genes ``(P, m)`` within bounds. State is a value; nothing else is kept."""

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
    rounds: int | None = None,
) -> tuple[Floats, Floats, int]:
    """Ask and tell until the budget (or ``rounds``) is spent.

    Returns the last population and every best on the way, as genes (k, m) best first, with their
    energies (k,), and the evaluations made.
    """
    state, done, count = solver.init(rng, low, high), 0, 0
    records: list[Floats] = []
    least = [math.inf]
    while True:
        genes, state = solver.ask(state, rng)
        energies = objective(genes)
        state = solver.tell(state, genes, energies)
        done, count = done + len(genes), count + 1
        first = int(energies.argmin())
        if energies[first] < least[-1]:
            records.append(genes[first].copy())
            least.append(float(energies[first]))
        if watch.over(done, least[-1]) or count == rounds:
            seen = np.concatenate([np.array(records).reshape(-1, len(low)), genes])
            heard = np.concatenate([least[1:], energies])
            order = np.argsort(heard, kind="stable")
            return seen[order], heard[order], done


def distinct(
    boxes: Floats, energies: Floats, keep: int = 8, apart: float = 0.5
) -> tuple[Layout, ...]:
    """The best layouts that differ: some item more than ``apart`` metres or radians away.

    ``boxes`` (P, n, 5), ``energies`` (P,); best first, at most ``keep``.
    """
    chosen: list[int] = []
    left = np.argsort(energies, kind="stable")
    while len(left) and len(chosen) < keep:
        first, left = int(left[0]), left[1:]
        gaps = boxes[left, :, :3] - boxes[first, :, :3]
        turned = np.abs((gaps[..., 2] + np.pi) % (2 * np.pi) - np.pi)
        near = (np.hypot(gaps[..., 0], gaps[..., 1]) <= apart) & (turned <= apart)
        chosen.append(first)
        left = left[~near.all(axis=1)]
    return tuple(Layout(boxes[k].copy(), float(energies[k])) for k in chosen)
