"""The one loop that repairs: the worst row, the moves it names, kept if the verdict is better."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from typing import Generic, NamedTuple, TypeVar

from scenewright.arranging.verdict import LEAST, Verdict, better, list_worst

State = TypeVar("State")
Move = Callable[[State, str], Iterable[State]]
"""The states a move makes of one for the sake of a row, the likeliest first."""


class Step(NamedTuple):
    """A change that was kept: the row it was made for, by which move, and what it gained: of lost
    things, hard rows, findings and cost."""

    row: str
    move: str
    gained: tuple[float, int, float, float]


class Repaired(NamedTuple, Generic[State]):
    """A state with its verdict, the steps to it, how many states were weighed, and whether nothing
    that is known improves it (``settled``), or the budget ended it."""

    state: State
    verdict: Verdict
    steps: tuple[Step, ...]
    weighed: int
    settled: bool


class Repair(NamedTuple, Generic[State]):
    """What the loop works with: the verdict on a state (``judge``), the ``moves`` by name and those
    each row names (``by_row``; a row that is not in it names none), what tells two states apart
    (``key``), by how much a cost falls at ``least``, what a better state must hold besides that
    is too dear to ask of all (``holds``), and whether a state shows itself to be no better before
    all of its verdict is known (``worse``)."""

    judge: Callable[[State], Verdict]
    moves: Mapping[str, Move[State]]
    by_row: Mapping[str, tuple[str, ...]]
    key: Callable[[State], Hashable]
    least: float = LEAST
    holds: Callable[[State], bool] | None = None
    worse: Callable[[State, Verdict], bool] | None = None


def repair(
    by: Repair[State],
    start: State,
    budget: int,
    stopped: Callable[[], bool] = lambda: False,
    show: Callable[[Step], None] | None = None,
) -> Repaired[State]:
    """The state after the loop: for the worst row that does not hold the moves it names are tried,
    and the first better state is kept; then the worst row again. It ends when no move of any row
    gains (settled), after ``budget`` states weighed, or when ``stopped``. No state is weighed
    twice. ``show`` gets every step as it is made, its state the one judged last.

    >>> judge = lambda n: Verdict(cost={"even": float(n % 2), "large": float(n)})
    >>> moves = {"less": lambda n, row: [n - 1] if n else [], "half": lambda n, row: [n // 2]}
    >>> done = repair(Repair(judge, moves, {"large": ("less", "half")}, lambda n: n), 6, 100)
    >>> done.state, done.settled, [(step.row, step.move) for step in done.steps][:2]
    (2, True, [('large', 'half'), ('large', 'less')])
    """
    now, verdict, steps = start, by.judge(start), list[Step]()
    seen, weighed = {by.key(start)}, 1
    while True:
        for row, move, state in _propose(by, now, verdict):
            if weighed >= budget or stopped():
                return Repaired(now, verdict, tuple(steps), weighed, False)
            if (key := by.key(state)) in seen:
                continue
            seen.add(key)
            weighed += 1
            if by.worse is not None and by.worse(state, verdict):
                continue
            found = by.judge(state)
            if better(found, verdict, by.least) and (by.holds is None or by.holds(state)):
                steps.append(Step(row, move, _gain(verdict, found)))
                now, verdict = state, found
                if show is not None:
                    show(steps[-1])
                break
        else:
            return Repaired(now, verdict, tuple(steps), weighed, True)


def _propose(by: Repair[State], state: State, verdict: Verdict) -> Iterable[tuple[str, str, State]]:
    """What the moves make of a state, for its worst row first, with the names of both."""
    for row in list_worst(verdict):
        for move in by.by_row.get(row, ()):
            for proposed in by.moves[move](state, row):
                yield row, move, proposed


def _gain(before: Verdict, after: Verdict) -> tuple[float, int, float, float]:
    """What is less after a change."""
    found = [sum(each.findings.values()) for each in (before, after)]
    return (
        before.lost - after.lost,
        before.broken - after.broken,
        found[0] - found[1],
        before.total - after.total,
    )
