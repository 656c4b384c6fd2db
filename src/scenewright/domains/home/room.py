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
    dress_patch,
    joined,
    pieces_of,
    standing_of,
)
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.pose import problem_of
from scenewright.domains.home.presets import Preset
from scenewright.domains.home.programme import ALSO, FALLBACK, Wish
from scenewright.domains.home.ways import unreached
from scenewright.geometry.fit import settle
from scenewright.problem import Ground, Problem
from scenewright.scene import Piece
from scenewright.solve import Budget
from scenewright.solvers import SOLVERS
from scenewright.space import Space

Floats = NDArray[np.float64]
Cancel = Callable[[], bool]

PENALTY = (1000.0, 60.0, 8.0)  # for what is missing, by rank
CORE = 3000.0  # for a missing core
UNREACHED = 300.0  # for a group no route reaches
BARRED = 1500.0  # for a door that nothing joins to the others
LOST = 4.0
CLOSE = 0.3  # gaps up to this many metres beside a patch are closed
DOOR = "door "
LAYOUTS = 5  # how many of the solver's layouts are dressed


class Task(NamedTuple):
    """All that does not change while one room is furnished; ``tight`` names the doors that no
    route joins even while the room is empty."""

    space: Space
    ground: Ground
    fixed: tuple[Piece, ...]
    catalog: Catalog
    preset: Preset
    solver: str
    route_width: float
    tight: frozenset[str]
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
    """The best answer found: all wishes at once; if that fails, what held and fallbacks for the
    rest; then the first wish alone; what is still missing is tried in the room that is left."""
    best = _attempt(task, wishes, _share(budget, 0.5), task.seed)
    for round_, fewer in enumerate((_held, _core), 1):
        again = () if _sound(best) else fewer(best, wishes)
        if again and again != wishes:
            tried = _attempt(task, again, _share(budget, 0.3), task.seed + round_)
            best = _better(best, _reported(tried, wishes, best))
    return best if not best.missing else _filled(task, best, _share(budget, 0.2))


def _penalty(wish: Wish) -> float:
    return CORE if wish.core else PENALTY[wish.rank]


def _sound(answer: Furnished) -> bool:
    """Nothing essential is missing and everything can be reached."""
    return not answer.unreached and not any(m.wish.rank == 0 for m in answer.missing)


def _held(answer: Furnished, wishes: tuple[Wish, ...]) -> tuple[Wish, ...]:
    """What stood and could be reached, and fallbacks for what did not or what bars a door."""
    barred = any(name.startswith(DOOR) for name in answer.unreached)
    kept: list[Wish] = []
    for wish in wishes:
        stood = [p for p in answer.placed if p.wish == wish]
        reached = bool(stood) and stood[0].name not in answer.unreached and not barred
        if stood and (reached or (wish.group not in FALLBACK and wish.rank == 0)):
            kept.append(wish)
        elif wish.group in FALLBACK:
            kept += _instead(wish)
        elif wish.rank == 0:
            kept.append(wish._replace(small=True))
    return tuple(kept)


def _core(answer: Furnished, wishes: tuple[Wish, ...]) -> tuple[Wish, ...]:
    """What makes the room's functions alone, in its smallest form, if some of it is missing."""
    if not any(m.wish.core for m in answer.missing):
        return ()
    return tuple(other for w in wishes if w.core for other in _instead(w))


def _instead(wish: Wish) -> list[Wish]:
    other = FALLBACK.get(wish.group, wish.group)
    also = [ALSO[other]] if other in ALSO else []
    return [wish._replace(group=group, small=True) for group in (other, *also)]


def _filled(task: Task, answer: Furnished, budget: Budget) -> Furnished:
    """Try what is missing in the room that is left, with what stands taken as fixed."""
    wanted = [m.wish for m in answer.missing if m.wish.rank < 2 or len(answer.missing) < 4]
    wishes = tuple(w._replace(small=True) for w in wanted)
    taken = np.array([p.dressed.box for p in answer.placed]).reshape(-1, 5)
    ground = task.ground._replace(obstacles=np.concatenate([task.ground.obstacles, taken]))
    problem = problem_of(ground, wishes, task.preset.weights, task.preset.printed, task.route_width)
    found = SOLVERS[task.solver].run(problem, budget, task.seed, cancel=task.cancel)
    best = answer
    for layout in found.layouts[:2]:
        more = _dressed(task, wishes, problem, layout.boxes, answer.energy, answer.placed)
        others = tuple(m for m in answer.missing if m.wish not in wanted)
        more = more._replace(
            missing=(*more.missing, *others),
            score=more.score + sum(_penalty(m.wish) for m in others),
        )
        best = min(best, more, key=lambda a: a.score)
    return best._replace(evaluations=answer.evaluations + found.evaluations)


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
    score = tried.score + sum(_penalty(m.wish) for m in dropped)
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
    problem = problem_of(task.ground, wishes, preset.weights, preset.printed, task.route_width)
    found = SOLVERS[task.solver].run(problem, budget, seed, cancel=task.cancel)
    answers = [
        _dressed(task, wishes, problem, layout.boxes, layout.energy)
        for layout in found.layouts[: LAYOUTS if preset.exact else 1]
    ]
    return min(answers, key=lambda a: a.score)._replace(evaluations=found.evaluations)


def _dressed(
    task: Task, wishes: tuple[Wish, ...], problem: Problem, boxes: Floats, energy: float,
    before: tuple[Placed, ...] = (),
) -> Furnished:  # fmt: skip
    """Dress a layout; then once more with the patches pushed together."""
    placed, missing = _placed(task, wishes, problem.names, boxes, before)
    if task.preset.exact and placed:
        names = tuple(p.name for p in placed)
        settled = settle(
            np.array([p.dressed.box for p in placed]),
            np.array([GROUPS[p.wish.group].nestle > 0 for p in placed]) & _new(placed, before),
            task.ground.edges, np.concatenate([task.ground.keep_free, task.ground.obstacles]),
            CLOSE,
        )  # fmt: skip
        again, lost = _placed(task, tuple(p.wish for p in placed), names, settled, ())
        if not lost and _lost(again) <= _lost(placed):
            placed = again
    return _scored(task, placed, missing, problem, energy)


def _new(placed: tuple[Placed, ...], before: tuple[Placed, ...]) -> NDArray[np.bool_]:
    return np.array([p not in before for p in placed])


def _lost(placed: tuple[Placed, ...]) -> int:
    return sum(p.dressed.lost for p in placed)


def _placed(
    task: Task, wishes: tuple[Wish, ...], names: tuple[str, ...], boxes: Floats,
    before: tuple[Placed, ...],
) -> tuple[tuple[Placed, ...], tuple[Missing, ...]]:  # fmt: skip
    """Dress the patches one by one, in order, beside what was placed before."""
    flat = frozenset(c for c, kind in task.catalog.kinds.items() if kind.flat)
    standing = standing_of((*task.fixed, *(q for p in before for q in p.pieces)), flat)
    placed, missing = list(before), []
    taken = {p.name for p in before}
    for wish, wanted, box in zip(wishes, names, boxes, strict=True):
        name = wanted if wanted not in taken else f"{wanted}_{len(taken) + 1}"
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
        taken.add(name)
        standing = joined(standing, standing_of(pieces, flat))
    return tuple(placed), tuple(missing)


def _scored(
    task: Task, placed: tuple[Placed, ...], missing: tuple[Missing, ...], problem: Problem,
    energy: float,
) -> Furnished:  # fmt: skip
    blocked: tuple[str, ...] = ()
    if task.preset.exact:
        placed, gone, blocked = _opened(task, placed)
        missing = (*missing, *gone)
    score = (
        sum(_penalty(m.wish) for m in missing)
        + sum(BARRED if b.startswith(DOOR) else UNREACHED for b in blocked)
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
        barred = any(b.startswith(DOOR) for b in blocked)
        if not blocked or candidate.wish.core or (candidate.wish.rank == 0 and not barred):
            break
        others = tuple(p for p in placed if p is not candidate)
        still = _blocked(task, others)
        if len(still) < len(blocked):
            opened = sorted(set(blocked) - set(still))
            placed, blocked = others, still
            gone.append(Missing(candidate.wish, _barred(candidate.name, opened)))
    return placed, tuple(gone), blocked


def _barred(name: str, opened: list[str]) -> str:
    others = [o.replace("_", " ") for o in opened if o != name]
    if not others:
        return "no walking route of the stated width would reach it"
    return f"it would bar the walking route to the {' and the '.join(others)}"


def _blocked(task: Task, placed: tuple[Placed, ...]) -> tuple[str, ...]:
    """What no route reaches though one would in the empty room: doors and fixed pieces by name,
    and the groups with a piece out of reach."""
    pieces = [p for item in placed for p in item.pieces]
    far = unreached(task.ground, (*task.fixed, *pieces), task.catalog, task.route_width)
    groups = [item.name for item in placed if any(p.id in far for p in item.pieces)]
    others = far - task.tight - {p.id for p in pieces}
    return (*sorted(others), *groups)
