"""One attempt at a room: solve the problem, dress the layouts, keep ways open, score."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.brief import Room
from scenewright.core.catalog import Catalog
from scenewright.core.layout import Layout, NamedBox, Watch, name_rows
from scenewright.core.passes import ALL_PASSES, PassOptions
from scenewright.core.same import Same
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.build_problem import build_problem, scale_area_weights
from scenewright.domains.home.cases.library import SHIPPED, Library
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.furnishing.facing import face_screen
from scenewright.domains.home.furnishing.furnish import (
    FurnishedPatch,
    Refused,
    furnish_patch,
    pieces_of,
)
from scenewright.domains.home.furnishing.high_walls import raise_tall_items
from scenewright.domains.home.furnishing.obstacles import flat_kinds, join_standing, standing_of
from scenewright.domains.home.furnishing.tidy import tidy_groups
from scenewright.domains.home.furnishing.whole import Gone
from scenewright.domains.home.paper_problem import as_in_paper
from scenewright.domains.home.presets import HomePreset
from scenewright.domains.home.problem import Ground, Problem
from scenewright.domains.home.programme import Wish, part_of
from scenewright.domains.home.settings import FaultCosts
from scenewright.domains.home.solvers import SOLVERS
from scenewright.domains.home.walking.ways import find_unreached
from scenewright.domains.home.wished.places import assign_places as at_places
from scenewright.domains.home.wished.unmet import count_unmet_wishes
from scenewright.domains.home.wished.wishes import apply_preferences
from scenewright.engine.solve import Budget, Progress
from scenewright.engine.watched import add_watch

Floats = NDArray[np.float64]
Cancel = Callable[[], bool]

DOOR = "door "


class RoomTask(NamedTuple):
    """All that does not change while one room is furnished.

    ``route_width`` is that of the way from door to door, ``use_width`` of the way to the pieces;
    ``tight`` names the doors and fixed pieces no route reaches even while the room is empty;
    ``forbidden`` are kinds of pieces the household will not have; sizes are those of a room
    ``amount`` times as large, of whose floor people furnish a ``share`` (none: not known), and
    ``welcome`` the welcome groups (none: the usual); ``asked`` is the room of the brief;
    ``beside`` are pieces of other rooms that reach into this one. In an
    open space groups may stand ``elsewhere``, in another room of it, and this one has others
    ``instead``. ``entered`` are the doors one comes in by (none: any); ``closet`` says whether
    clothes can hang in a closet of the room. ``progress`` gets what the solvers report, ``watch``
    the best layouts of groups; ``passes`` switches passes off or hears of them."""

    space: Space
    ground: Ground
    fixed: tuple[Piece, ...]
    catalog: Catalog
    preset: HomePreset
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
    share: float | None = None
    welcome: tuple[str, ...] | None = None
    asked: Room | None = None
    beside: tuple[Piece, ...] = ()
    elsewhere: frozenset[str] = frozenset()
    instead: tuple[Wish, ...] = ()
    entered: tuple[int, ...] = ()
    closet: bool = False
    progress: Progress | None = None
    watch: Watch | None = None
    passes: PassOptions = ALL_PASSES

    @property
    def costs(self) -> FaultCosts:
        """What faults of an answer cost."""
        return self.preset.settings.costs

    def cancelled(self) -> bool:
        """Whether nobody waits for a better answer."""
        return self.cancel is not None and self.cancel()


class FurnishedGroup(NamedTuple):
    """A wish that came true: the item's name, its dressed patch and its pieces."""

    wish: Wish
    name: str
    dressed: FurnishedPatch
    pieces: tuple[Piece, ...]


class Missing(NamedTuple):
    """A wish that did not, and why; whether something else stands for it (``replaced``)."""

    wish: Wish
    reason: str
    replaced: bool = False


class RoomAnswer(NamedTuple):
    """One answer for a room; the lower ``score`` the better. ``unmet`` counts the wishes for
    places and the outlets it does not meet; ``gone`` are pieces that gave way when all was done;
    ``drafts`` other answers, the next best first."""

    score: float
    placed: tuple[FurnishedGroup, ...]
    missing: tuple[Missing, ...]
    unreached: tuple[str, ...]
    problem: Problem | None
    energy: float
    evaluations: int
    unmet: int = 0
    gone: tuple[Gone, ...] = ()
    drafts: tuple[RoomAnswer, ...] = ()


def penalty(wish: Wish, costs: FaultCosts) -> float:
    """What it costs that a wish did not come true."""
    return costs.core if wish.core else costs.missing[wish.rank]


def floor_of(ground: Ground) -> float:
    """The floor of a room with what fixed pieces take of it, square metres."""
    return ground.area + float(ground.obstacles[:, 3:].prod(-1).sum())


def furnished_as(task: RoomTask) -> float:
    """The area by which sizes are chosen, square metres."""
    return part_of(task.space.functions, floor_of(task.ground) * task.amount)


def build_task_problem(task: RoomTask, wishes: tuple[Wish, ...], ground: Ground) -> Problem:
    """The problem of placing wishes on a ground, by the task's preset; of the same task and ground
    made once."""
    return _build_task_problem(Same(task), wishes, Same(ground))


@lru_cache(maxsize=64)
def _build_task_problem(
    same: Same[RoomTask], wishes: tuple[Wish, ...], on: Same[Ground]
) -> Problem:
    task, ground, preset = same.value, on.value, same.value.preset
    problem = build_problem(
        ground,
        wishes,
        preset.weights,
        preset.settings.printed,
        task.route_width,
        furnished_as(task),
        task.library,
    )
    problem = problem._replace(settings=preset.settings)
    if preset.settings.paper:
        return as_in_paper(problem, wishes, task.space, task.library)
    items = raise_tall_items(problem.items, wishes, ground)
    items = at_places(items, wishes, task.space, task.fixed, task.library)
    weights = scale_area_weights(preset.weights, items)
    return problem._replace(items=apply_preferences(items, wishes), weights=weights)


def attempt(task: RoomTask, wishes: tuple[Wish, ...], budget: Budget, seed: int) -> RoomAnswer:
    """One run of the solver; the best of its layouts once dressed. Those whose energy alone counts
    more than the best's score are not looked at."""
    preset = task.preset
    problem = build_task_problem(task, wishes, task.ground)
    listener = hear_groups(task, tuple(w.group for w in wishes))
    found = SOLVERS[task.solver].run(problem, budget, seed, listener, task.cancel)
    first, *others = found.layouts[: preset.settings.tries.layouts if preset.settings.exact else 1]
    best = furnish_layout(task, wishes, problem, first.boxes, first.energy)
    for layout in others:
        if task.costs.energy * layout.energy >= best.score or task.cancelled():
            continue
        other = furnish_layout(task, wishes, problem, layout.boxes, layout.energy, most=best.score)
        best = other if other.score < best.score else best
    return best._replace(evaluations=found.evaluations)


def hear_groups(
    task: RoomTask, groups: tuple[str, ...], before: tuple[FurnishedGroup, ...] = ()
) -> Progress | None:
    """The listener to a solver that places groups beside those that stand ``before``."""
    standing = tuple((p.wish.group, p.dressed.box) for p in before)

    def rows(layout: Layout) -> tuple[NamedBox, ...]:
        names = (*(name for name, _ in standing), *groups)
        return name_rows(names, np.array([*(box for _, box in standing), *layout.boxes]))

    return add_watch(task.progress, task.watch, task.space.id, rows)


def furnish_layout(
    task: RoomTask,
    wishes: tuple[Wish, ...],
    problem: Problem,
    boxes: Floats,
    energy: float,
    before: tuple[FurnishedGroup, ...] = (),
    most: float = math.inf,
) -> RoomAnswer:
    """Dress a layout; then with the patches pushed together, and with the screen before the seat.
    An answer that will not score below ``most`` is given up as soon as that shows.

    ``boxes`` (n, 5) x, y, heading, width, depth of the patches, metres and radians.
    """
    placed, missing = _place_groups(task, wishes, problem.names, boxes, before, most)
    if sum(penalty(m.wish, task.costs) for m in missing) >= most:
        return RoomAnswer(math.inf, placed, missing, (), problem, energy, 0)
    if task.preset.settings.exact and placed:
        new = np.array([p not in before for p in placed])
        groups = tuple(p.wish.group for p in placed)
        placed = _again(task, placed, tidy_groups(groups, _boxes(placed), new, task.ground))
        cases = [p.dressed.case for p in placed]
        placed = _again(task, placed, face_screen(cases, _boxes(placed), new, task.ground))
    return score_answer(task, placed, missing, problem, energy, most)


def _again(
    task: RoomTask, placed: tuple[FurnishedGroup, ...], boxes: Floats
) -> tuple[FurnishedGroup, ...]:
    """The same groups dressed on other boxes; as they were where something would be lost."""
    if np.array_equal(boxes, _boxes(placed)):
        return placed
    names = tuple(p.name for p in placed)
    again, lost = _place_groups(task, tuple(p.wish for p in placed), names, boxes, ())
    return again if not lost and _count_lost(again) <= _count_lost(placed) else placed


def _boxes(placed: tuple[FurnishedGroup, ...]) -> Floats:
    return np.array([p.dressed.box for p in placed])


def _count_lost(placed: tuple[FurnishedGroup, ...]) -> int:
    return sum(p.dressed.lost for p in placed)


def _place_groups(
    task: RoomTask,
    wishes: tuple[Wish, ...],
    names: tuple[str, ...],
    boxes: Floats,
    before: tuple[FurnishedGroup, ...],
    most: float = math.inf,
) -> tuple[tuple[FurnishedGroup, ...], tuple[Missing, ...]]:
    """Dress the patches one by one, in order, beside what was placed before; those after the one
    with which ``most`` is missed are not looked at."""
    flat = flat_kinds(task.catalog)
    standing = standing_of(
        (*task.fixed, *task.beside, *(q for p in before for q in p.pieces)), flat
    )
    placed, missing = list(before), []
    taken = {p.name for p in before} | {p.group.rpartition("/")[2] for p in task.fixed}
    for wish, wanted, box in zip(wishes, names, boxes, strict=True):
        name, number = wanted, len(taken)
        while name in taken:
            number += 1
            name = f"{wanted}_{number}"
        furnished = furnish_patch(
            wish.group,
            box,
            task.ground,
            standing,
            task.catalog,
            task.space.height,
            task.preset.settings.exact,
            task.library,
            task.space.outlets,
        )
        if isinstance(furnished, Refused):
            missing.append(Missing(wish, furnished.reason))
            if sum(penalty(m.wish, task.costs) for m in missing) >= most:
                break
            continue
        group = f"{task.space.id}/{name}"
        pieces = pieces_of(furnished, task.space.id, group, wish.group, task.catalog)
        placed.append(FurnishedGroup(wish, name, furnished, pieces))
        taken.add(name)
        standing = join_standing(standing, standing_of(pieces, flat))
    return tuple(placed), tuple(missing)


def score_answer(
    task: RoomTask,
    placed: tuple[FurnishedGroup, ...],
    missing: tuple[Missing, ...],
    problem: Problem,
    energy: float,
    most: float = math.inf,
) -> RoomAnswer:
    """The answer that groups so placed make, ways kept open; ``energy`` if nothing stands. Its
    score is infinite as soon as it is not below ``most``."""
    blocked: tuple[str, ...] = ()
    if task.preset.settings.exact:
        placed, gone, blocked = _open_ways(task, placed)
        missing = (*missing, *gone)
    standing = (*task.fixed, *(p for item in placed for p in item.pieces))
    unmet, costs = count_unmet_wishes(task.asked, task.space, standing, task.catalog), task.costs
    score = (
        sum(penalty(m.wish, task.costs) for m in missing)
        + sum(costs.barred if b.startswith(DOOR) else costs.unreached for b in blocked)
        + costs.piece * _count_lost(placed)
        + costs.unmet * unmet
    )
    if score >= most:
        return RoomAnswer(math.inf, placed, missing, blocked, problem, energy, 0)
    energy = _energy(task, placed, problem, energy)
    total = score + costs.energy * energy
    return RoomAnswer(total, placed, missing, blocked, problem, energy, 0, unmet)


def _energy(
    task: RoomTask, placed: tuple[FurnishedGroup, ...], asked: Problem, otherwise: float
) -> float:
    """Energy of the patches as they are dressed; ``asked`` is the problem they answer."""
    if not placed:
        return otherwise
    same = asked.ground is task.ground and asked.names == tuple(p.name for p in placed)
    problem = (
        asked if same else build_task_problem(task, tuple(p.wish for p in placed), task.ground)
    )
    return float(evaluate(problem, np.array([[p.dressed.box for p in placed]]))[0])


def _open_ways(
    task: RoomTask, placed: tuple[FurnishedGroup, ...]
) -> tuple[tuple[FurnishedGroup, ...], tuple[Missing, ...], tuple[str, ...]]:
    """Take out welcome and usual groups, the least important first, while that opens a way to
    something that cannot be reached."""
    blocked = find_blocked(task, placed)
    gone: list[Missing] = []
    for candidate in sorted(placed, key=lambda p: -p.wish.rank):
        barred = any(b.startswith(DOOR) for b in blocked)
        if not blocked or candidate.wish.core or (candidate.wish.rank == 0 and not barred):
            break
        others = tuple(p for p in placed if p is not candidate)
        still = find_blocked(task, others)
        if len(still) < len(blocked):
            opened = sorted(set(blocked) - set(still))
            placed, blocked = others, still
            gone.append(Missing(candidate.wish, _explain_barring(candidate.name, opened)))
    return placed, tuple(gone), blocked


def _explain_barring(name: str, opened: list[str]) -> str:
    others = [o.replace("_", " ") for o in opened if o != name]
    if not others:
        return "no walking route of the stated width would reach it"
    return f"it would bar the walking route to the {' and the '.join(others)}"


def find_blocked(task: RoomTask, placed: tuple[FurnishedGroup, ...]) -> tuple[str, ...]:
    """What no route reaches though one would in the empty room: doors and fixed pieces by name,
    and the groups with a piece out of reach."""
    pieces = tuple(p for item in placed for p in item.pieces)
    far = out_of_reach(task, pieces)
    if not far:
        return ()
    groups = [item.name for item in placed if any(p.id in far for p in item.pieces)]
    others = far - task.tight - {p.id for p in pieces}
    return (*sorted(others), *groups)


def bars_no_more(
    task: RoomTask, placed: tuple[FurnishedGroup, ...], barred: frozenset[str]
) -> bool:
    """Whether nothing is out of reach but what was (``barred``, of :func:`find_blocked`)."""
    return barred.issuperset(find_blocked(task, placed))


def out_of_reach(task: RoomTask, pieces: tuple[Piece, ...]) -> frozenset[str]:
    """Doors that no route joins to the first, and pieces that none reaches."""
    standing = (*task.fixed, *task.beside, *pieces)
    far = find_unreached(task.ground, standing, task.catalog, task.route_width, task.entered)
    if task.use_width == task.route_width:
        return far
    doors = frozenset(name for name in far if name.startswith(DOOR))
    near = find_unreached(task.ground, standing, task.catalog, task.use_width, task.entered)
    return doors | frozenset(name for name in near if not name.startswith(DOOR))
