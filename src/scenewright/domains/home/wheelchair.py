"""Homes for wheelchairs: room to turn is kept, beds and toilets come with floor beside them.

A circle of 1.5 m is reserved at a few places of a room, one after the other, and the best answer
taken; groups of beds and toilets are cases with a strip of 0.9 m on one side.
"""

from __future__ import annotations

from math import pi

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.ceiling import low_floor
from scenewright.core.brief import ACCESSIBLE_ROUTE, Brief
from scenewright.core.catalog import Group, Member
from scenewright.core.layout import corners
from scenewright.core.piece_edits import frame_of, transfer_frame
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    penalty,
)
from scenewright.domains.home.attempts.systematic import essential_layouts
from scenewright.domains.home.cases.library import Library, cases, index_cases
from scenewright.domains.home.easy_forms import keep_roomy, prefer_easy
from scenewright.domains.home.furnishing.furnish import SLACK
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.groups.classes import UNLIVED
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.room import fill_rest, furnish, share_of
from scenewright.engine.solve import Budget
from scenewright.geometry.fit import COLLIDES, faults

Floats = NDArray[np.float64]

TURN = 1.5  # the circle a wheelchair turns in, metres
TRANSFER = 0.9  # free floor beside a bed or toilet, metres
ALONG = 1.2  # length of it along a bed, from its foot, metres
SPARE = 0.03  # what is reserved more than needed, metres
TRANSFER_BEDS = ("double_bed", "single_bed")
WIDENED = {"sleeping": "double_bed", "single": "single_bed", "toilet": "toilet"}
NARROWEST = 0.002  # the same where there is no room for that, metres
SPARED = frozenset(("washer",))  # what a room without space to turn gives up before that


def widen_library(library: Library) -> Library:
    """A library whose beds and toilets have a strip of free floor on one side."""
    own = dict(library.own)
    for function, category in WIDENED.items():
        known = cases(function, library).groups
        own[function] = index_cases(
            tuple(
                wide
                for case in known
                for left in (True, False)
                for wide in _with_strip(case, category, left)
            )
        )
    return library._replace(own=own)


def _with_strip(case: Group, category: str, left: bool) -> list[Group]:
    """A case with 0.9 m free on one side of its main piece, its companions kept in the strip's
    head if they stand there."""
    main = next((m for m in case.members if m.category == category), None)
    if main is None:
        return []
    sign = -1.0 if left else 1.0
    room = case.width / 2 - (sign * main.x + main.size.width / 2)
    more = max(TRANSFER + SPARE - room, 0.0)
    moved = tuple(m._replace(x=m.x - sign * more / 2) for m in case.members)
    wide = case._replace(width=case.width + more, members=moved)
    return [wide] if _strip_free(wide, category, sign) else []


def _strip_free(case: Group, category: str, sign: float) -> bool:
    """Whether no other solid member of a case stands in the strip beside its main piece."""
    main = next(m for m in case.members if m.category == category)
    x0, x1, y0, y1 = _strip(main, sign)
    return not any(_meets(m, x0, x1, y0, y1) for m in case.members if m is not main)


def _meets(member: Member, x0: float, x1: float, y0: float, y1: float) -> bool:
    if member.category in ("rug", "picture", "mirror") or member.on >= 0:
        return False
    w, d = member.size.width / 2 - SLACK, member.size.depth / 2 - SLACK
    return bool(member.x - w < x1 and x0 < member.x + w and member.y - d < y1 and y0 < member.y + d)


def _strip(main: Member, sign: float) -> tuple[float, float, float, float]:
    """The strip in the group's frame: left, right, back, front."""
    w, d = main.size.width / 2, main.size.depth
    long = min(ALONG, d) if main.category in TRANSFER_BEDS else d
    inner, outer = main.x + sign * w, main.x + sign * (w + TRANSFER)
    return min(inner, outer), max(inner, outer), main.y + d / 2 - long, main.y + d / 2


def furnish_by_use(
    task: RoomTask, wishes: tuple[Wish, ...], budget: Budget, roomy: bool = True
) -> RoomAnswer:
    """Furnish a room, with room to turn and to get to bed and toilet if the home is accessible;
    there in ``roomy`` forms first."""
    if not task.accessible:
        return furnish(task, wishes, budget)
    return for_wheelchairs(task, wishes, budget, roomy)


def for_wheelchairs(
    task: RoomTask, wishes: tuple[Wish, ...], budget: Budget, roomy: bool = True
) -> RoomAnswer:
    """The best answer for a room with room to turn in it, if there is any place for that: with what
    is easy to use, in ``roomy`` forms; where something essential lacks, with smaller ones, with
    what is essential before all else, last with what is less easy."""
    easy = prefer_easy(task, wishes)
    essential = tuple(w for w in easy if w.rank == 0 or w.required)
    wide = task._replace(library=keep_roomy(task.library))
    ways = (
        *[(wide, easy, easy)] * roomy,
        (task, easy, easy),
        (task, easy, essential),
        (task, wishes, wishes),
    )
    tried: list[tuple[float, RoomAnswer]] = []
    for one, asked, first in ways:
        tried.append(_turn_in(one, asked, first, budget))
        if tried[-1][0] == 0.0:
            break
    _, best = min(tried, key=lambda way: way[0])
    return best._replace(evaluations=sum(answer.evaluations for _, answer in tried))


def _count_lacking(answer: RoomAnswer) -> int:
    """How much of what is essential, or required, is missing."""
    return sum(m.wish.rank == 0 or m.wish.required for m in answer.missing)


def _cost_faults(task: RoomTask, answer: RoomAnswer) -> float:
    """What it costs that essentials are missing, and beds and toilets out of reach."""
    lost = [m.wish for m in answer.missing if m.wish.rank == 0 or m.wish.required]
    shut = task.costs.no_transfer * count_shut(task, answer)
    return shut + sum(penalty(wish, task.costs) for wish in lost)


def _turn_in(
    task: RoomTask, wishes: tuple[Wish, ...], first: tuple[Wish, ...], budget: Budget
) -> tuple[float, RoomAnswer]:
    """The best answer with room to turn, and what its faults cost; what is asked for ``first``
    stands before the rest."""
    turns = spots(task)
    if not turns and _opens_on_others(task):
        wishes = tuple(wish for wish in wishes if wish.rank == 0 or wish.required)
    answers = [
        _furnish_in_order(_reserve_turning_circle(task, spot), wishes, first, budget)
        for spot in turns
    ]
    more = 0.0
    if not answers or any(map(_is_needed, min(answers, key=_score).missing)):
        plain = _furnish_in_order(task, wishes, first, budget)
        more = task.costs.no_turn if answers else 0.0
        answers.append(plain._replace(score=plain.score + more))
    best = min(answers, key=_score)
    cost = _cost_faults(task, best) + more * (best is answers[-1])
    missing = tuple(m._replace(reason=_reword_reason(m.reason)) for m in best.missing)
    looked = sum(a.evaluations for a in answers)
    return cost, best._replace(missing=missing, evaluations=looked)


def _furnish_in_order(
    task: RoomTask, wishes: tuple[Wish, ...], first: tuple[Wish, ...], budget: Budget
) -> RoomAnswer:
    """A room with what is asked for ``first``, then the rest of its wishes, all within reach."""
    rest = tuple(wish for wish in wishes if wish not in first)
    answer = furnish(task, tuple(w for w in wishes if w in first), budget)
    laid = (
        next(essential_layouts(task, wishes, answer), None)
        if rest and _count_lacking(answer)
        else None
    )
    if laid is not None and _count_lacking(laid) < _count_lacking(answer):
        answer = fill_rest(task, laid, share_of(budget, 1.0, task.preset.settings.tries))
    elif rest:
        more = tuple(Missing(wish, "no room is left beside the rest") for wish in rest)
        lost = sum(penalty(wish, task.costs) for wish in rest)
        answer = answer._replace(missing=(*answer.missing, *more), score=answer.score + lost)
        rule = task.preset.settings.tries
        answer = fill_rest(task, answer, share_of(budget, rule.fill, rule))
    return _clear_approaches(task, answer)


def _opens_on_others(task: RoomTask) -> bool:
    """Whether a hall is open to another space, so that a wheelchair turns in both together."""
    passage = any(opening.kind == "passage" for opening in task.space.openings)
    return passage and "hall" in task.space.functions


def _is_needed(lack: Missing) -> bool:
    """Whether a room is of no use without what is missing, so that it may lack space to turn."""
    return lack.wish.core and lack.wish.group not in SPARED


def _reword_reason(reason: str) -> str:
    return reason.replace("before a door", "before a door or where a wheelchair turns")


def _score(answer: RoomAnswer) -> float:
    return answer.score


def spots(task: RoomTask) -> list[tuple[float, float]]:
    """Where a wheelchair might turn: in the middle, by the door, far from it; none if nowhere."""
    space = task.space
    if set(space.functions) & UNLIVED or not task.preset.settings.exact:
        return []
    ground = task.ground
    shape = shapely.Polygon(space.outline, list(space.holes))
    low = low_floor(ground.slopes, TURN, ground.bounds)
    solid = shapely.union_all(shapely.polygons(corners(np.concatenate([ground.obstacles, low]))))
    radii = ((TURN + spare) / 2 for spare in (SPARE, NARROWEST))
    freely = (shape.buffer(-radius).difference(solid.buffer(radius)) for radius in radii)
    free = next((found for found in freely if not found.is_empty), None)
    if free is None:
        return []
    middle = shapely.Point(free.centroid)
    door = shapely.Point(ground.doors[0, :2]) if len(ground.doors) else middle
    reach = [shapely.Point(p) for p in shapely.get_coordinates(shapely.segmentize(free, 0.2))]
    far = max(reach, key=lambda p: float(p.distance(door)))
    near = [_nearest(free, p) for p in (middle, door, far)]
    found: list[tuple[float, float]] = []
    for at in near:
        if all(np.hypot(at[0] - x, at[1] - y) > TURN / 3 for x, y in found):
            found.append(at)
    return found


def _nearest(shape: shapely.Geometry, point: shapely.Point) -> tuple[float, float]:
    at = shapely.get_coordinates(shapely.shortest_line(shape, point))[0]
    return float(at[0]), float(at[1])


def _reserve_turning_circle(task: RoomTask, spot: tuple[float, float]) -> RoomTask:
    """The task with an octagon round the circle kept free: four boxes turned by an eighth."""
    across = TURN + SPARE
    side = across * (2**0.5 - 1)
    boxes = np.array([(*spot, k * pi / 4, across, side) for k in range(4)])
    ground = task.ground
    kept = np.concatenate([ground.keep_free, boxes])
    return task._replace(ground=ground._replace(keep_free=kept))


def _clear_approaches(task: RoomTask, answer: RoomAnswer) -> RoomAnswer:
    """An answer less the welcome and usual groups that stand where one gets to bed or toilet."""
    while True:
        blocked = {p.id: _in_strips(task, answer, p) for p in _pieces(answer) if _main(p)}
        shut = {i: names for i, names in blocked.items() if names is not None}
        giving = [
            g
            for g in answer.placed
            if g.wish.rank > 0
            and not any(map(_main, g.pieces))
            and any(q.id in names for q in g.pieces for names in shut.values())
        ]
        if not giving:
            return answer._replace(score=answer.score + task.costs.no_transfer * len(shut))
        gone = max(giving, key=lambda g: g.wish.rank)
        text = "it would stand where one gets from a wheelchair to bed or toilet"
        answer = answer._replace(
            placed=tuple(g for g in answer.placed if g is not gone),
            missing=(*answer.missing, Missing(gone.wish, text)),
            score=answer.score + penalty(gone.wish, task.costs),
        )


def count_shut(task: RoomTask, answer: RoomAnswer) -> int:
    """How many beds and toilets of an accessible home one does not get to from a wheelchair."""
    main = (piece for piece in _pieces(answer) if task.accessible and _main(piece))
    return sum(_in_strips(task, answer, piece) is not None for piece in main)


def _main(piece: Piece) -> bool:
    return piece.category in TRANSFER_BEDS or piece.category == "toilet"


def _pieces(answer: RoomAnswer) -> tuple[Piece, ...]:
    groups: tuple[FurnishedGroup, ...] = answer.placed
    return tuple(p for group in groups for p in group.pieces)


def _in_strips(task: RoomTask, answer: RoomAnswer, piece: Piece) -> frozenset[str] | None:
    """Ids of the pieces in both strips beside a piece; ``None`` if one is free."""
    flat = flat_kinds(task.catalog)
    others = tuple(
        p
        for p in (*task.fixed, *task.beside, *_pieces(answer))
        if p.id != piece.id and p.on is None and p.category not in flat and p.pose.z < 2.0
    )
    standing = standing_of(others, flat)
    main = Member(piece.category, 0, 0, 0, 0, piece.size)
    found = []
    for sign in (-1.0, 1.0):
        x0, x1, y0, y1 = _strip(main, sign)
        x, y, h = transfer_frame(
            ((x0 + x1) / 2, (y0 + y1) / 2, 0.0), (0.0, 0.0, pi / 2), frame_of(piece)
        )
        box = np.array([[x, y, h + pi / 2, x1 - x0, y1 - y0]])
        codes, offenders = faults(
            box,
            np.array([[0.05, 2.0]]),
            np.zeros(1, bool),
            task.ground.edges,
            np.zeros((0, 5)),
            np.zeros((0, 6)),
            standing.boxes,
            standing.spans,
            SLACK,
        )
        if codes[0] == 0:
            return None
        if codes[0] == COLLIDES:
            found.append(others[int(offenders[0])].id)
    return frozenset(found)


def accessible(brief: Brief) -> Brief:
    """The brief of a home with room for wheelchairs and routes of at least 0.9 m."""
    width = max(brief.route_width, ACCESSIBLE_ROUTE)
    return brief.model_copy(update={"accessible": True, "route_width": width})
