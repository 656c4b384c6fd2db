"""Several plans of one brief that differ: other patterns, other proposals of zones, other places.

Candidates are solved with the patterns of each demand narrowed to one and with the next proposal
of zones; of these the best is taken first, then again and again the one that adds most, judged by
energy and by how much it differs from all taken (maximal marginal relevance, Carbonell and
Goldstein 1998).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import shapely

from scenewright.brief import Brief
from scenewright.domains.hall import solve
from scenewright.solution import Solution

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

TRIED = 2
"""Candidates for every plan asked for, and two more."""
DIFFERENT = 0.5
"""Weight of differing against being good."""


def alternatives(
    brief: Brief, count: int, *, seed: int = 0, progress: Progress | None = None,
    cancel: Cancel | None = None, **options: Any,
) -> tuple[Solution, ...]:  # fmt: skip
    """``count`` plans that differ, best first; ``options`` are those of
    :func:`scenewright.domains.hall.solve`."""
    tried = TRIED * count + 2
    found: list[Solution] = []
    for k in range(tried):
        if cancel is not None and cancel() and found:
            break
        found.append(solve(brief, seed=seed + k, variant=k % (count + 1), lean=k, cancel=cancel,
                           **options))  # fmt: skip
        if progress:
            progress((k + 1) / tried, f"plan {k + 1} of {tried}")
    chosen = choose(found, count)
    return tuple(sorted(chosen, key=_rank))


def choose(found: list[Solution], count: int) -> list[Solution]:
    """The best, then those that add most."""
    left = sorted(found, key=_rank)
    energies = np.array([_rank(solution)[1] for solution in left])
    worth = -(energies - energies.min()) / max(float(np.ptp(energies)), 1e-9)
    taken: list[int] = []
    while len(taken) < min(count, len(left)):
        scores = [
            -np.inf
            if k in taken
            else worth[k]
            - 10.0 * len(left[k].left_out)
            + DIFFERENT * min((difference(left[k], left[t]) for t in taken), default=0.0)
            for k in range(len(left))
        ]
        taken.append(int(np.argmax(scores)))
    return [left[k] for k in taken]


def difference(one: Solution, other: Solution) -> float:
    """How much two plans differ, 0 to 3: the share of groups in another pattern or zone, how far
    groups lie apart (in diagonals of their hall, at most 1), and the share of zoned floor that
    belongs to another zone."""
    if one.graph is None or other.graph is None:
        return 0.0
    theirs = {group.id: group for group in other.graph.groups}
    pairs = [(g, theirs[g.id]) for g in one.graph.groups if g.id in theirs]
    lost = len(one.graph.groups) + len(theirs) - 2 * len(pairs)
    changed = sum(a.pattern != b.pattern or a.zone != b.zone for a, b in pairs) + lost
    span = max((float(np.hypot(*np.ptp(z.outline, axis=0))) for z in one.graph.zones), default=1.0)
    far = [np.hypot(a.pose[0] - b.pose[0], a.pose[1] - b.pose[1]) / span for a, b in pairs]
    groups = max(len(pairs) + lost, 1)
    return changed / groups + min(float(np.sum(far)) / groups, 1.0) + _rezoned(one, other)


def _rezoned(one: Solution, other: Solution) -> float:
    assert one.graph is not None
    assert other.graph is not None
    theirs = {(z.space, z.id): shapely.Polygon(z.outline) for z in other.graph.zones}
    mine = {(z.space, z.id): shapely.Polygon(z.outline) for z in one.graph.zones}
    total = sum(shape.area for shape in mine.values())
    same = sum(shape.intersection(theirs[k]).area for k, shape in mine.items() if k in theirs)
    return 1.0 - float(same / total) if total else 0.0


def _rank(solution: Solution) -> tuple[int, float]:
    return len(solution.left_out), sum(solution.energies.values())
