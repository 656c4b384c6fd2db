"""Several plans of one home that differ: other walls, other groups, room by room.

Candidates are solved with every room arranged around another of its walls, and every second time
with other groups for the same use. Each plan takes for each room the candidate that adds most to
those already taken, judged by energy and difference (maximal marginal relevance, Carbonell and
Goldstein 1998), so plans differ in all rooms that allow it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import cos, pi
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.building.plan import plan_rooms
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.solution import Patch, Solution
from scenewright.core.space import Space
from scenewright.domains import check
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.settings import VarietySettings
from scenewright.domains.home.solving import solve
from scenewright.engine.diversity import choose_diverse
from scenewright.engine.rows import preset_named

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

MOVED_BY = 2.0
"""A group that lies this far from where it did counts as standing elsewhere, metres."""

MAKES = {"sleeping": "bed", "single": "bed", "bunk": "bunk bed", "seating": "sofa", "desk": "desk"}
"""What groups that make a room are called."""
WINDS = ("east", "north-east", "north", "north-west", "west", "south-west", "south", "south-east")


class Candidate(NamedTuple):
    """One answer for one room: its patches, energy and what it lacks."""

    patches: tuple[Patch, ...]
    energy: float
    lacking: int


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
    """Up to ``count`` plans that differ by the ``least`` of the preset's variety, best first;
    ``options`` are those of :func:`scenewright.domains.home.solving.solve`."""
    made = plan or plan_rooms(brief)
    rule = preset_named(PRESETS, options.get("preset", "default")).settings.variety
    tried = rule.tried * count + rule.spare
    found: list[Solution] = []
    for k in range(tried):
        if cancel is not None and cancel() and found:
            break
        found.append(solve(brief, plan=made, seed=seed + k, variant=k, cancel=cancel, **options))
        if progress:
            progress((k + 1) / tried, f"plan {k + 1} of {tried}")
    return choose(found, count, made, rule)


def choose(
    found: Sequence[Solution],
    count: int,
    plan: Plan | None = None,
    rule: VarietySettings = PRESETS["default"].settings.variety,
) -> tuple[Solution, ...]:
    """Plans put together room by room from whole ones: the best, then those that add most."""
    made = plan or plan_rooms(found[0].brief)
    rooms = made.spaces
    ordered = sorted(found, key=_rank)
    chosen = [_choose_for(ordered, room, count, rule) for room in rooms]
    plans: list[Solution] = []
    for numbers in zip(*chosen, strict=True):
        home = compose_home(ordered, numbers, rooms)
        if not check(home, plan=made).valid:
            home = max(
                ordered, key=lambda s: min((difference(s, p, made) for p in plans), default=0.0)
            )
        if all(difference(home, other, made) >= rule.least for other in plans):
            plans.append(home)
    return tuple(sorted(plans, key=_rank))


def _choose_for(
    found: Sequence[Solution], room: Space, count: int, rule: VarietySettings
) -> list[int]:
    """The solutions that plan after plan takes for a room, each what adds most to those before."""
    known = [_candidate(solution, room.id) for solution in found]
    energies = np.array([c.energy for c in known])
    worth = -(energies - energies.min()) / max(float(np.ptp(energies)), 1e-9)
    worth = worth - rule.missing * np.array([c.lacking for c in known])
    return choose_diverse(
        worth,
        lambda k, t: _apart(known[k].patches, known[t].patches),
        count,
        rule.different,
        again=True,
    )


def _candidate(solution: Solution, room: str) -> Candidate:
    lacking = sum(out.required for out in solution.left_out if out.space == room)
    patches = tuple(p for p in solution.patches if p.space == room)
    return Candidate(patches, solution.energies.get(room, 0.0), lacking)


def compose_home(
    found: Sequence[Solution], take: Sequence[int], rooms: Sequence[Space]
) -> Solution:
    """One home, each room taken from the solution with the given number."""
    parts = [(room.id, found[k]) for room, k in zip(rooms, take, strict=True)]
    return replace(
        found[0],
        pieces=tuple(p for room, s in parts for p in s.pieces if p.space == room),
        patches=tuple(p for room, s in parts for p in s.patches if p.space == room),
        terms=tuple(t for room, s in parts for t in s.terms if t.space == room),
        left_out=tuple(o for room, s in parts for o in s.left_out if o.space == room),
        energies={room: s.energies.get(room, 0.0) for room, s in parts},
        seconds=sum(s.seconds for s in found),
        evaluations=sum(s.evaluations for s in found),
    )


def difference(one: Solution, other: Solution, plan: Plan | None = None) -> float:
    """How much two plans of a home differ, 0 to 1: the mean over its rooms, by floor area, of the
    share of furniture, by area, that stands elsewhere, looks another way or is in one only."""
    total, summed = 0.0, 0.0
    for room in (plan or plan_rooms(one.brief)).spaces:
        area = float(shapely.Polygon(room.outline, list(room.holes)).area)
        mine, theirs = (tuple(p for p in s.patches if p.space == room.id) for s in (one, other))
        if mine or theirs:
            total += area
            summed += area * _apart(mine, theirs)
    return summed / total if total else 0.0


def _apart(mine: Sequence[Patch], theirs: Sequence[Patch]) -> float:
    """How much two layouts of one room differ, 0 to 1, whichever comes first."""
    return (_measure_change(mine, theirs) + _measure_change(theirs, mine)) / 2


def _measure_change(mine: Sequence[Patch], theirs: Sequence[Patch]) -> float:
    """The share of the furniture, by area, that is not where the other layout has the like."""
    left = list(theirs)
    changed, total = 0.0, 0.0
    for patch in mine:
        area = patch.box[3] * patch.box[4]
        same = [p for p in left if p.function == patch.function]
        nearest = min(same, key=lambda p: _measure_move(patch, p), default=None)
        if nearest is not None:
            left.remove(nearest)
        total += area
        changed += area * (1.0 if nearest is None else _measure_move(patch, nearest))
    alone = sum(p.box[3] * p.box[4] for p in left)
    return (changed + alone) / max(total + alone, 1e-9)


def _measure_move(one: Patch, other: Patch) -> float:
    """How much a group stands elsewhere, 0 to 1: wholly if it looks another way."""
    if cos(one.box[2] - other.box[2]) < 0.7:
        return 1.0
    return min(
        float(np.hypot(one.box[0] - other.box[0], one.box[1] - other.box[1])) / MOVED_BY, 1.0
    )


def sides(solution: Solution, plan: Plan | None = None) -> str:
    """Where what makes its rooms stands, in words: ``Bedroom: bed at the east wall; …``."""
    lines = []
    for room in (plan or plan_rooms(solution.brief)).spaces:
        stand = [
            f"{MAKES[p.function]} at the {WINDS[round((p.box[2] + pi) / (pi / 4)) % 8]} wall"
            for p in solution.patches
            if p.space == room.id and p.function in MAKES
        ]
        if stand:
            lines.append(f"{room.name}: {', '.join(stand)}")
    return "; ".join(lines)


def _rank(solution: Solution) -> tuple[int, float]:
    return sum(out.required for out in solution.left_out), sum(solution.energies.values())
