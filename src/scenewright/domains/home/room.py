"""Furnish one room: pose, solve, dress, and try again with less until everything holds."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog import Catalog
from scenewright.domains.home.dress import (
    Dressed,
    Refused,
    Standing,
    dress_patch,
    joined,
    pieces_of,
    standing_of,
)
from scenewright.domains.home.pose import problem_of
from scenewright.domains.home.presets import Preset
from scenewright.domains.home.programme import ALSO, FALLBACK, Wish
from scenewright.domains.home.ways import unreached
from scenewright.problem import Ground, Problem
from scenewright.scene import Piece
from scenewright.solve import Budget
from scenewright.solvers import SOLVERS
from scenewright.space import Space

Floats = NDArray[np.float64]
Cancel = Callable[[], bool]

PENALTY = (1000.0, 60.0, 8.0)  # for what is missing, by rank
UNREACHED = 300.0
LOST = 4.0
LAYOUTS = 5  # how many of the solver's layouts are dressed


class Task(NamedTuple):
    """All that does not change while one room is furnished."""

    space: Space
    ground: Ground
    fixed: tuple[Piece, ...]
    catalog: Catalog
    preset: Preset
    solver: str
    route_width: float
    seed: int
    cancel: Cancel | None


class Placed(NamedTuple):
    """A wish that came true: the item's name, its dressed patch and its pieces."""

    wish: Wish
    name: str
    dressed: Dressed
    pieces: tuple[Piece, ...]


class Missing(NamedTuple):
    """A wish that did not, and why."""

    wish: Wish
    reason: str


class Furnished(NamedTuple):
    """One answer for a room; the lower ``score`` the better."""

    score: float
    placed: tuple[Placed, ...]
    missing: tuple[Missing, ...]
    unreached: tuple[str, ...]
    problem: Problem | None
    energy: float
    evaluations: int


def furnish(task: Task, wishes: tuple[Wish, ...], budget: Budget) -> Furnished:
    """The best answer found: all wishes at once, then again with what held and fallbacks for the
    rest, at last with the essential alone."""
    best = _attempt(task, wishes, _share(budget, 0.5), task.seed)
    if _complete(best):
        return best
    for round_, fewer in enumerate((_held, _essential), 1):
        again = fewer(best)
        if again == wishes or not again:
            continue
        tried = _attempt(task, again, _share(budget, 0.25), task.seed + round_)
        best = _better(best, _reported(tried, wishes, best))
        if not any(m.wish.rank == 0 for m in best.missing) and not best.unreached:
            break
    return best


def _complete(answer: Furnished) -> bool:
    return not answer.missing and not answer.unreached


def _held(answer: Furnished) -> tuple[Wish, ...]:
    """What stood and could be reached, and fallbacks for what did not."""
    kept = [p.wish for p in answer.placed if p.name not in answer.unreached or p.wish.rank < 2]
    for missing in answer.missing:
        wish = missing.wish
        other = FALLBACK.get(wish.group)
        if other:
            kept.append(wish._replace(group=other))
            kept += [wish._replace(group=ALSO[other])] if other in ALSO else []
        elif wish.rank == 0:
            kept.append(wish)
    return tuple(sorted(kept, key=lambda w: w.rank))


def _essential(answer: Furnished) -> tuple[Wish, ...]:
    return tuple(w for w in _held(answer) if w.rank == 0 or w.required)


def _reported(tried: Furnished, wishes: tuple[Wish, ...], before: Furnished) -> Furnished:
    """A later answer, also telling what it no longer attempted, scored against all wishes."""
    asked = [p.wish for p in tried.placed] + [m.wish for m in tried.missing]
    groups = [w.group for w in asked]
    why = {m.wish.group: m.reason for m in before.missing}
    dropped = []
    for wish in wishes:
        if wish.group in groups:
            groups.remove(wish.group)
        elif FALLBACK.get(wish.group) in groups:
            groups.remove(FALLBACK[wish.group])
        else:
            dropped.append(Missing(wish, why.get(wish.group, "no room is left beside the rest")))
    score = tried.score + sum(PENALTY[m.wish.rank] for m in dropped)
    return tried._replace(missing=(*tried.missing, *dropped), score=score)


def _better(first: Furnished, second: Furnished) -> Furnished:
    evaluations = first.evaluations + second.evaluations
    return (second if second.score < first.score else first)._replace(evaluations=evaluations)


def _share(budget: Budget, share: float) -> Budget:
    return budget._replace(
        seconds=None if budget.seconds is None else budget.seconds * share,
        steps=None if budget.steps is None else max(1, int(budget.steps * share)),
    )


def _attempt(task: Task, wishes: tuple[Wish, ...], budget: Budget, seed: int) -> Furnished:
    preset = task.preset
    problem = problem_of(
        task.ground, wishes, preset.weights, preset.printed, task.route_width
    )
    found = SOLVERS[task.solver].run(problem, budget, seed, cancel=task.cancel)
    answers = [
        _dressed(task, wishes, problem, layout.boxes, layout.energy)
        for layout in found.layouts[: LAYOUTS if preset.exact else 1]
    ]
    return min(answers, key=lambda a: a.score)._replace(evaluations=found.evaluations)


def _dressed(
    task: Task, wishes: tuple[Wish, ...], problem: Problem, boxes: Floats, energy: float
) -> Furnished:
    flat = frozenset(c for c, kind in task.catalog.kinds.items() if kind.flat)
    standing: Standing = standing_of(task.fixed, flat)
    placed: list[Placed] = []
    missing: list[Missing] = []
    for wish, name, box in zip(wishes, problem.names, boxes, strict=True):
        dressed = dress_patch(
            wish.group, box, task.ground, standing, task.catalog, task.space.height,
            task.preset.exact,
        )  # fmt: skip
        if isinstance(dressed, Refused):
            missing.append(Missing(wish, dressed.reason))
            continue
        group = f"{task.space.id}/{name}"
        pieces = pieces_of(dressed, task.space.id, group, wish.group, task.catalog)
        placed.append(Placed(wish, name, dressed, pieces))
        standing = joined(standing, standing_of(pieces, flat))
    return _scored(task, tuple(placed), tuple(missing), problem, energy)


def _scored(
    task: Task, placed: tuple[Placed, ...], missing: tuple[Missing, ...], problem: Problem,
    energy: float,
) -> Furnished:  # fmt: skip
    blocked: tuple[str, ...] = ()
    if task.preset.exact:
        placed, gone, blocked = _opened(task, placed)
        missing = (*missing, *gone)
    score = (
        sum(PENALTY[m.wish.rank] for m in missing)
        + UNREACHED * len(blocked)
        + LOST * sum(p.dressed.lost for p in placed)
        + 1e-2 * energy
    )
    return Furnished(score, placed, missing, blocked, problem, energy, 0)


def _opened(
    task: Task, placed: tuple[Placed, ...]
) -> tuple[tuple[Placed, ...], tuple[Missing, ...], tuple[str, ...]]:
    """Take out welcome and usual groups, the least important first, while that opens a way to
    something that cannot be reached."""
    blocked = _blocked(task, placed)
    gone: list[Missing] = []
    for candidate in sorted(placed, key=lambda p: -p.wish.rank):
        if not blocked or candidate.wish.rank == 0:
            break
        others = tuple(p for p in placed if p is not candidate)
        still = _blocked(task, others)
        if len(still) < len(blocked):
            placed, blocked = others, still
            reason = "it would stand in the way to " + " and ".join(
                sorted(candidate.name if b == candidate.name else b for b in blocked)
            ) if blocked else "no walking route of the stated width would be left"
            gone.append(Missing(candidate.wish, reason))
    return placed, tuple(gone), blocked


def _blocked(task: Task, placed: tuple[Placed, ...]) -> tuple[str, ...]:
    """Names of the groups with a piece that no route reaches."""
    pieces = [p for item in placed for p in item.pieces]
    far = unreached(task.ground, (*task.fixed, *pieces), task.catalog, task.route_width)
    return tuple(item.name for item in placed if any(p.id in far for p in item.pieces))
