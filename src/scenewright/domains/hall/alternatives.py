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

from scenewright.building.plan import plan_rooms
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.hall.presets import PRESETS
from scenewright.domains.hall.settings import OtherPlansSettings
from scenewright.domains.hall.solving import solve
from scenewright.engine.diversity import choose_diverse
from scenewright.engine.rows import preset_named

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]


def alternatives(
    brief: Brief,
    count: int,
    *,
    plan: Plan | None = None,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    **options: Any,
) -> tuple[Solution, ...]:
    """``count`` plans that differ, best first; ``options`` are those of
    :func:`scenewright.domains.hall.solving.solve`."""
    made = plan or plan_rooms(brief)
    rule = preset_named(PRESETS, options.get("preset", "default")).settings.other_plans
    tried = rule.tried * count + rule.spare
    found: list[Solution] = []
    for k in range(tried):
        if cancel is not None and cancel() and found:
            break
        varied: dict[str, Any] = {"seed": seed + k, "variant": k % (count + 1), "lean": k}
        found.append(solve(brief, plan=made, cancel=cancel, **varied, **options))
        if progress:
            progress((k + 1) / tried, f"plan {k + 1} of {tried}")
    chosen = choose(found, count, rule)
    return tuple(sorted(chosen, key=_rank))


def choose(
    found: list[Solution],
    count: int,
    rule: OtherPlansSettings = PRESETS["default"].settings.other_plans,
) -> list[Solution]:
    """The best, then those that add most."""
    left = sorted(found, key=_rank)
    energies = np.array([_rank(solution)[1] for solution in left])
    worth = -(energies - energies.min()) / max(float(np.ptp(energies)), 1e-9)
    worth = worth - rule.missing * np.array([len(solution.left_out) for solution in left])
    taken = choose_diverse(worth, lambda k, t: difference(left[k], left[t]), count, rule.different)
    return [left[k] for k in taken]


def difference(one: Solution, other: Solution) -> float:
    """How much two plans differ, 0 to 3: the share of groups in another pattern or zone, how far
    groups lie apart (in diagonals of their hall, at most 1), and the share of zoned floor that
    belongs to another zone."""
    if one.detail is None or other.detail is None:
        return 0.0
    theirs = {group.id: group for group in other.detail.layout.groups}
    pairs = [(g, theirs[g.id]) for g in one.detail.layout.groups if g.id in theirs]
    lost = len(one.detail.layout.groups) + len(theirs) - 2 * len(pairs)
    changed = sum(a.pattern != b.pattern or a.zone != b.zone for a, b in pairs) + lost
    span = max(
        (float(np.hypot(*np.ptp(z.outline, axis=0))) for z in one.detail.layout.zones), default=1.0
    )
    far = [np.hypot(a.pose[0] - b.pose[0], a.pose[1] - b.pose[1]) / span for a, b in pairs]
    groups = max(len(pairs) + lost, 1)
    return (
        changed / groups + min(float(np.sum(far)) / groups, 1.0) + _measure_zone_change(one, other)
    )


def _measure_zone_change(one: Solution, other: Solution) -> float:
    assert one.detail is not None
    assert other.detail is not None
    theirs = {(z.space, z.id): shapely.Polygon(z.outline) for z in other.detail.layout.zones}
    mine = {(z.space, z.id): shapely.Polygon(z.outline) for z in one.detail.layout.zones}
    total = sum(shape.area for shape in mine.values())
    same = sum(shape.intersection(theirs[k]).area for k, shape in mine.items() if k in theirs)
    return 1.0 - float(same / total) if total else 0.0


def _rank(solution: Solution) -> tuple[int, float]:
    return len(solution.left_out), sum(solution.energies.values())


def compare(one: Solution, other: Solution, plan: Plan | None = None) -> float:
    """How much two plans differ, 0 to 1: a third of :func:`difference`, whatever the ``plan``."""
    del plan
    return difference(one, other) / 3.0


def describe(solution: Solution, plan: Plan | None = None) -> str:
    """How the groups are laid out, whatever the ``plan``: ``showcases grid, panels chain``."""
    del plan
    groups = () if solution.detail is None else solution.detail.layout.groups
    words = [f"{group.demand} {group.pattern}" for group in groups if len(group.objects) > 1]
    return ", ".join(words)
