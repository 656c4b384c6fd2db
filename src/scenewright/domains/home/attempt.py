"""One attempt at a room: solve the problem, dress the layouts, keep ways open, score."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.brief import Room
from scenewright.catalog import Catalog
from scenewright.domains.home.cases.library import SHIPPED, Library
from scenewright.domains.home.dressing.dress import Dressed, Refused, dress_patch, pieces_of
from scenewright.domains.home.dressing.facing import faced
from scenewright.domains.home.dressing.high_walls import raised
from scenewright.domains.home.dressing.obstacles import joined, standing_of
from scenewright.domains.home.dressing.tidy import tidied
from scenewright.domains.home.pose import firm, problem_of
from scenewright.domains.home.presets import Preset
from scenewright.domains.home.programme import Wish, part_of
from scenewright.domains.home.ways import unreached
from scenewright.domains.home.wished.heard import unheard
from scenewright.domains.home.wished.places import placed as at_places
from scenewright.domains.home.wished.wishes import swayed
from scenewright.energy import evaluate
from scenewright.problem import Ground, Problem
from scenewright.scene import Piece
from scenewright.solve import Budget
from scenewright.solvers import SOLVERS
from scenewright.space import Space

Floats = NDArray[np.float64]
Cancel = Callable[[], bool]

PENALTY = (1000.0, 60.0, 8.0)  # for what is missing, by rank
CORE = 3000.0  # for a missing core
UNREACHED = 600.0  # for a group no route reaches
BARRED = 1500.0  # for a door that nothing joins to the others
LOST = 4.0
UNHEARD = 30.0  # for a wish for a place, or an outlet, that what stands does not meet
ENERGY = 0.05  # what a unit of energy counts beside the above
DOOR = "door "
LAYOUTS = 5  # how many of the solver's layouts are dressed


class Task(NamedTuple):
    """All that does not change while one room is furnished.

    ``route_width`` is that of the way from door to door, ``use_width`` of the way to the pieces;
    ``tight`` names the doors and fixed pieces no route reaches even while the room is empty;
    ``forbidden`` are kinds of pieces the household will not have; sizes are those of a room
    ``amount`` times as large, and ``welcome`` the welcome groups (none: the usual); ``asked`` is
    the room of the brief."""

    space: Space
    ground: Ground
    fixed: tuple[Piece, ...]
    catalog: Catalog
    preset: Preset
    solver: str
    route_width: float
    use_width: float
    tight: frozenset[str]
    seed: int
    cancel: Cancel | None
    library: Library = SHIPPED
    accessible: bool = False
    forbidden: frozenset[str] = frozenset()
    amount: float = 1.0
    welcome: tuple[str, ...] | None = None
    asked: Room | None = None


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
    """One answer for a room; the lower ``score`` the better. ``unheard`` counts the wishes for
    places and the outlets it does not meet."""

    score: float
    placed: tuple[Placed, ...]
    missing: tuple[Missing, ...]
    unreached: tuple[str, ...]
    problem: Problem | None
    energy: float
    evaluations: int
    unheard: int = 0


def penalty(wish: Wish) -> float:
    """What it costs that a wish did not come true."""
    return CORE if wish.core else PENALTY[wish.rank]


def floor_of(ground: Ground) -> float:
    """The floor of a room with what fixed pieces take of it, square metres."""
    return ground.area + float(ground.obstacles[:, 3:].prod(-1).sum())


def furnished_as(task: Task) -> float:
    """The area by which sizes are chosen, square metres."""
    return part_of(task.space.functions, floor_of(task.ground) * task.amount)


def posed(task: Task, wishes: tuple[Wish, ...], ground: Ground) -> Problem:
    """The problem of placing wishes on a ground, by the task's preset."""
    preset = task.preset
    problem = problem_of(
        ground, wishes, preset.weights, preset.printed, task.route_width,
        furnished_as(task), task.library,
    )  # fmt: skip
    items = problem.items if preset.printed else raised(problem.items, wishes, ground)
    items = at_places(items, wishes, task.space, task.fixed, task.library)
    weights = preset.weights if preset.printed else firm(preset.weights, items)
    return problem._replace(items=swayed(items, wishes), weights=weights)


def attempt(task: Task, wishes: tuple[Wish, ...], budget: Budget, seed: int) -> Furnished:
    """One run of the solver; the best of its layouts once dressed. Those whose energy alone counts
    more than the best's score are not looked at."""
    preset = task.preset
    problem = posed(task, wishes, task.ground)
    found = SOLVERS[task.solver].run(problem, budget, seed, cancel=task.cancel)
    first, *others = found.layouts[: LAYOUTS if preset.exact else 1]
    best = dressed(task, wishes, problem, first.boxes, first.energy)
    for layout in others:
        if ENERGY * layout.energy >= best.score:
            continue
        other = dressed(task, wishes, problem, layout.boxes, layout.energy, most=best.score)
        best = other if other.score < best.score else best
    return best._replace(evaluations=found.evaluations)


def dressed(
    task: Task, wishes: tuple[Wish, ...], problem: Problem, boxes: Floats, energy: float,
    before: tuple[Placed, ...] = (), most: float = math.inf,
) -> Furnished:  # fmt: skip
    """Dress a layout; then with the patches pushed together, and with the screen before the seat.
    An answer that will not score below ``most`` is given up as soon as that shows."""
    placed, missing = _placed(task, wishes, problem.names, boxes, before, most)
    if sum(penalty(m.wish) for m in missing) >= most:
        return Furnished(math.inf, placed, missing, (), problem, energy, 0)
    if task.preset.exact and placed:
        new = np.array([p not in before for p in placed])
        groups = tuple(p.wish.group for p in placed)
        placed = _again(task, placed, tidied(groups, _boxes(placed), new, task.ground))
        cases = [p.dressed.case for p in placed]
        placed = _again(task, placed, faced(cases, _boxes(placed), new, task.ground))
    return scored(task, placed, missing, problem, energy, most)


def _again(task: Task, placed: tuple[Placed, ...], boxes: Floats) -> tuple[Placed, ...]:
    """The same groups dressed on other boxes; as they were where something would be lost."""
    if np.array_equal(boxes, _boxes(placed)):
        return placed
    names = tuple(p.name for p in placed)
    again, lost = _placed(task, tuple(p.wish for p in placed), names, boxes, ())
    return again if not lost and _lost(again) <= _lost(placed) else placed


def _boxes(placed: tuple[Placed, ...]) -> Floats:
    return np.array([p.dressed.box for p in placed])


def _lost(placed: tuple[Placed, ...]) -> int:
    return sum(p.dressed.lost for p in placed)


def _placed(
    task: Task, wishes: tuple[Wish, ...], names: tuple[str, ...], boxes: Floats,
    before: tuple[Placed, ...], most: float = math.inf,
) -> tuple[tuple[Placed, ...], tuple[Missing, ...]]:  # fmt: skip
    """Dress the patches one by one, in order, beside what was placed before; those after the one
    with which ``most`` is missed are not looked at."""
    flat = frozenset(c for c, kind in task.catalog.kinds.items() if kind.flat)
    standing = standing_of((*task.fixed, *(q for p in before for q in p.pieces)), flat)
    placed, missing = list(before), []
    taken = {p.name for p in before} | {p.group.rpartition("/")[2] for p in task.fixed}
    for wish, wanted, box in zip(wishes, names, boxes, strict=True):
        name = wanted if wanted not in taken else f"{wanted}_{len(taken) + 1}"
        worn = dress_patch(
            wish.group, box, task.ground, standing, task.catalog, task.space.height,
            task.preset.exact, task.library, task.space.outlets,
        )  # fmt: skip
        if isinstance(worn, Refused):
            missing.append(Missing(wish, worn.reason))
            if sum(penalty(m.wish) for m in missing) >= most:
                break
            continue
        group = f"{task.space.id}/{name}"
        pieces = pieces_of(worn, task.space.id, group, wish.group, task.catalog)
        placed.append(Placed(wish, name, worn, pieces))
        taken.add(name)
        standing = joined(standing, standing_of(pieces, flat))
    return tuple(placed), tuple(missing)


def scored(
    task: Task, placed: tuple[Placed, ...], missing: tuple[Missing, ...], problem: Problem,
    energy: float, most: float = math.inf,
) -> Furnished:  # fmt: skip
    """The answer that groups so placed make, ways kept open; ``energy`` if nothing stands. Its
    score is infinite as soon as it is not below ``most``."""
    blocked: tuple[str, ...] = ()
    if task.preset.exact:
        placed, gone, blocked = _opened(task, placed)
        missing = (*missing, *gone)
    standing = (*task.fixed, *(p for item in placed for p in item.pieces))
    deaf = unheard(task.asked, task.space, standing, task.catalog)
    score = (
        sum(penalty(m.wish) for m in missing)
        + sum(BARRED if b.startswith(DOOR) else UNREACHED for b in blocked)
        + LOST * _lost(placed)
        + UNHEARD * deaf
    )
    if score >= most:
        return Furnished(math.inf, placed, missing, blocked, problem, energy, 0)
    energy = _energy(task, placed, problem, energy)
    total = score + ENERGY * energy
    return Furnished(total, placed, missing, blocked, problem, energy, 0, deaf)


def _energy(task: Task, placed: tuple[Placed, ...], asked: Problem, otherwise: float) -> float:
    """Energy of the patches as they are dressed; ``asked`` is the problem they answer."""
    if not placed:
        return otherwise
    same = asked.ground is task.ground and asked.names == tuple(p.name for p in placed)
    problem = asked if same else posed(task, tuple(p.wish for p in placed), task.ground)
    return float(evaluate(problem, np.array([[p.dressed.box for p in placed]]))[0])


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
    pieces = tuple(p for item in placed for p in item.pieces)
    far = out_of_reach(task, pieces)
    groups = [item.name for item in placed if any(p.id in far for p in item.pieces)]
    others = far - task.tight - {p.id for p in pieces}
    return (*sorted(others), *groups)


def out_of_reach(task: Task, pieces: tuple[Piece, ...]) -> frozenset[str]:
    """Doors that no route joins to the first, and pieces that none reaches."""
    standing = (*task.fixed, *pieces)
    far = unreached(task.ground, standing, task.catalog, task.route_width)
    if task.use_width == task.route_width:
        return far
    doors = frozenset(name for name in far if name.startswith(DOOR))
    near = unreached(task.ground, standing, task.catalog, task.use_width)
    return doors | frozenset(name for name in near if not name.startswith(DOOR))
