"""One attempt at a room by a solver that places single pieces."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.core.layout import Layout, NamedBox, name_rows
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    build_task_problem,
    furnished_as,
    score_answer,
)
from scenewright.domains.home.furnishing.furnish import (
    BACKED,
    SLACK,
    FurnishedPatch,
    Refused,
    pieces_of,
    too_tall,
    why_not,
    world,
)
from scenewright.domains.home.furnishing.obstacles import (
    StandingObstacles,
    flat_kinds,
    join_standing,
    standing_of,
)
from scenewright.domains.home.furnishing.pieces import Parts, as_laid, parts_of, posed_pieces
from scenewright.domains.home.grounds.hanging_walls import hanging_walls
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solvers import SOLVERS
from scenewright.engine.solve import Budget
from scenewright.engine.watched import add_watch
from scenewright.geometry.fit import faults, is_backed

Floats = NDArray[np.float64]


def piecewise(task: RoomTask, wishes: tuple[Wish, ...], budget: Budget) -> RoomAnswer:
    """Place all pieces of the wished groups at once; what then runs into something is left out,
    and a group with it if it is what makes it. Presets that are not exact leave all standing."""
    preset = task.preset
    area = furnished_as(task)
    parts = tuple(parts_of(wish, area, task.catalog, task.library) for wish in wishes)
    problem = posed_pieces(
        task.ground, parts, task.catalog, preset.weights, preset.settings.printed, task.route_width
    )
    listener = add_watch(task.progress, task.watch, task.space.id, partial(_group_rows, parts))
    found = SOLVERS[task.solver].run(problem, budget, task.seed, listener, task.cancel)
    placed, missing = lay_out_parts(task, parts, found.layouts[0].boxes)
    answer = score_answer(task, placed, missing, build_task_problem(task, wishes, task.ground), 0.0)
    return answer._replace(evaluations=found.evaluations)


def _group_rows(parts: tuple[Parts, ...], layout: Layout) -> tuple[NamedBox, ...]:
    """The groups of a layout of single pieces, each by the box drawn round its pieces."""
    first, boxes = 0, []
    for part in parts:
        boxes.append(as_laid(part, layout.boxes[first : first + len(part.placed)])[1])
        first += len(part.placed)
    return name_rows([part.wish.group for part in parts], np.array(boxes))


def lay_out_parts(
    task: RoomTask, parts: tuple[Parts, ...], boxes: Floats
) -> tuple[tuple[FurnishedGroup, ...], tuple[Missing, ...]]:
    """Groups whose pieces stand on ``boxes`` (n, 5), and those that could not."""
    flat = flat_kinds(task.catalog)
    standing, placed, missing = standing_of((*task.fixed, *task.beside), flat), [], []
    names = build_task_problem(task, tuple(p.wish for p in parts), task.ground).names
    taken = {p.group.rpartition("/")[2] for p in task.fixed}
    first = 0
    for part, wanted in zip(parts, names, strict=True):
        case, box = as_laid(part, boxes[first : first + len(part.placed)])
        first += len(part.placed)
        furnished = _furnish_part(task, part, case, box, standing)
        if isinstance(furnished, Refused):
            missing.append(Missing(part.wish, furnished.reason))
            continue
        name = wanted if wanted not in taken else f"{wanted}_{len(taken) + 1}"
        group = f"{task.space.id}/{name}"
        pieces = pieces_of(furnished, task.space.id, group, part.wish.group, task.catalog)
        placed.append(FurnishedGroup(part.wish, name, furnished, pieces))
        taken.add(name)
        standing = join_standing(standing, standing_of(pieces, flat))
    return tuple(placed), tuple(missing)


def _furnish_part(
    task: RoomTask, part: Parts, case: Group, box: Floats, standing: StandingObstacles
) -> FurnishedPatch | Refused:
    """Which members of a group stand: the placed ones in turn, then what rides with them."""
    count = len(case.members)
    if not task.preset.settings.exact:
        return FurnishedPatch(case, box, (True,) * count, 0)
    boxes, spans, flat = world(case.members, box, task.catalog)
    stands = [False] * count
    order = [part.anchor, *(i for i in part.placed if i != part.anchor)]
    for i in (*order, *(i for i in range(count) if i not in part.placed)):
        member = case.members[i]
        code, offender = _fault(task, member.category, boxes[i], spans[i], flat[i], standing)
        held = code == 0 and (i in part.placed or stands[part.rides[i]])
        if task.catalog.kinds[member.category].support == "wall":
            held = held and bool(is_backed(boxes[i], hanging_walls(task.ground), BACKED))
        stands[i] = held and (member.on < 0 or stands[member.on])
        if not stands[i] and member.category in GROUPS[part.wish.group].essential:
            return Refused(why_not(member, code, offender, standing))
        if stands[i] and i in part.placed:
            here = StandingObstacles(boxes[i][None], spans[i][None], (member.category,))
            standing = join_standing(standing, here)
    lost = sum(not stands[i] for i in part.placed)
    return FurnishedPatch(case, box, tuple(stands), lost)


def _fault(
    task: RoomTask,
    category: str,
    box: Floats,
    span: Floats,
    flat: bool,
    standing: StandingObstacles,
) -> tuple[int, int]:
    """What is wrong with a piece where it stands; what it may be pushed under is no obstacle."""
    under = task.catalog.kinds[category].under
    open_ = np.array([name not in under for name in standing.names], bool)
    ground = task.ground
    codes, offenders = faults(
        box[None],
        span[None],
        np.array([flat]),
        ground.edges,
        ground.keep_free,
        ground.windows,
        standing.boxes[open_],
        standing.spans[open_],
        SLACK,
    )
    codes = too_tall(box[None], span[None], ground, task.space.height, codes)
    offender = int(offenders[0])
    return int(codes[0]), int(np.flatnonzero(open_)[offender]) if codes[0] == 4 else offender
