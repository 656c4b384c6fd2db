"""Filling a block house by house, the largest first.

How many houses, then which, then where each stands: poses are proposed, those that are legal are
weighed, and one is drawn. What no way can lead to is taken away and tried again.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.composing import (
    compose_weights,
    is_enough,
    rim_poses,
    serves,
    stand_ins,
    stands_behind,
    ways_of,
)
from scenewright.domains.village.doors import assign_doors
from scenewright.domains.village.house import House
from scenewright.domains.village.learned.pose_net import score_poses
from scenewright.domains.village.learned.surroundings import (
    Surroundings,
    survey,
    with_house,
    without_houses,
)
from scenewright.domains.village.learned.tokens import tokens_of
from scenewright.domains.village.problem import VillageLayout, VillageProblem
from scenewright.domains.village.proposals import is_legal, propose, shapes_at, shrink
from scenewright.domains.village.relations import relate
from scenewright.domains.village.standing import Flags, Floats, Shapes, StandingHouses, add, place
from scenewright.domains.village.weights import weigh
from scenewright.engine.growing import OnGrowth
from scenewright.ground.streetside.neighbours import find_crowding
from scenewright.ground.streetside.plots import OUTBUILDING

SLIT = (0.01, 0.3)
"""Metres between walls that nobody leaves."""

Weighing = Callable[[VillageProblem, Surroundings, House, Shapes, Floats], Floats]
"""Log weights (k,) of legal poses (k, 3) of a house with their footprints (k,)."""


class Growth(NamedTuple):
    """A block while it is filled: its houses and surroundings, and the numbers in the
    library and poses of the houses placed."""

    seen: Surroundings
    houses: tuple[int, ...]
    poses: tuple[Floats, ...]

    @property
    def standing(self) -> StandingHouses:
        """The houses of the block, those that stay first."""
        return self.seen.standing


def grow(
    problem: VillageProblem,
    chosen: list[int],
    rng: np.random.Generator,
    weighing: Weighing | None = None,
    on_growth: OnGrowth | None = None,
) -> VillageLayout:
    """Fill a block with houses of the library by number. ``weighing`` tells how likely poses are
    (left out: by the learned net); ``on_growth`` is called for every house and may end it."""
    weighing = weighing or weigh_by_net
    growth = Growth(survey_problem(problem, len(chosen)), (), ())
    goes_on = partial(_goes_on, problem, len(chosen), on_growth)
    growth, rest = _front_square(problem, growth, chosen)
    grown = _add_all(problem, growth, rest, rng, weighing, goes_on)
    grown, doors, lost = _keep_reached(problem, grown)
    if lost:
        grown = _add_all(problem, grown, lost, rng, weighing, goes_on)
        grown, doors, _ = _keep_reached(problem, grown)
    spared = sum(serves(problem.houses[k]) for k in chosen) if problem.settings.composed else 0
    asked = len(chosen) if problem.asked is not None else max(len(chosen) - spared, 0)
    return _layout(grown, doors, max(asked, len(grown.houses)))


def _front_square(
    problem: VillageProblem, growth: Growth, chosen: list[int]
) -> tuple[Growth, list[int]]:
    """Houses before each side of the square, their fronts to it, and those that are left."""
    rest = list(chosen)
    for side in problem.rim:
        for number in [k for k in dict.fromkeys(rest) if _may_front(problem.houses[k])]:
            house = problem.houses[number]
            poses = rim_poses(side, house)
            good = _legal(problem, growth.standing, house, poses)
            if len(good):
                growth = _with(growth, house, number, poses[good[0]])
                rest.remove(number)
                break
    return growth, rest


def _may_front(house: House) -> bool:
    """Whether a house is one that stands about a square."""
    return not serves(house) and house.use != "works"


def _legal(
    problem: VillageProblem, standing: StandingHouses, house: House, poses: Floats
) -> np.ndarray:
    """The numbers of legal poses."""
    if not len(poses):
        return np.zeros(0, np.int64)
    shapes, rings = shapes_at(house, poses)
    blocked = [*standing.shapes, problem.kept_free]
    good = np.flatnonzero(is_legal(problem.floor, shrink(np.array(blocked, object)), shapes, rings))
    good = good[~is_slit(standing, shapes[good])]
    if problem.settings.composed:
        turns = standing.frames[:, 2]
        good = good[~find_crowding(shapes[good], poses[good, 2], standing.shapes, turns)]
    return good


def layout_of(
    problem: VillageProblem, houses: Sequence[int], poses: Sequence[Floats]
) -> VillageLayout:
    """The layout of houses of the library at poses (3,), less those that no way leads to."""
    growth = Growth(survey_problem(problem, len(houses)), (), ())
    for number, pose in zip(houses, poses, strict=True):
        growth = _with(growth, problem.houses[number], number, pose)
    grown, doors, _ = _keep_reached(problem, growth)
    given = problem.asked
    asked = len(houses) if given is None else max(given - len(problem.fixed.shapes), 0)
    return _layout(grown, doors, asked)


def _goes_on(
    problem: VillageProblem, asked: int, on_growth: OnGrowth | None, growth: Growth
) -> bool:
    """Tell how far a block is; whether it is to be filled further."""
    if on_growth is None:
        return True
    return not on_growth(
        len(growth.houses) / max(asked, 1), partial(_as_grown, problem, growth, asked)
    )


def _as_grown(problem: VillageProblem, growth: Growth, asked: int) -> VillageLayout:
    grown, doors, _ = _keep_reached(problem, growth)
    return _layout(grown, doors, asked)


def _layout(grown: Growth, doors: np.ndarray, asked: int) -> VillageLayout:
    houses, poses = np.array(grown.houses, np.int64), np.array(grown.poses).reshape(-1, 3)
    return VillageLayout(houses, poses, doors, asked, {})


def survey_problem(problem: VillageProblem, added: int) -> Surroundings:
    """What can be seen of a block on which ``added`` houses join those that stay."""
    planned = added + len(problem.fixed.shapes)
    share = problem.street_share
    return survey(problem.floor, problem.streets, share, planned, problem.fixed)


def weigh_by_net(
    problem: VillageProblem, seen: Surroundings, house: House, shapes: Shapes, poses: Floats
) -> Floats:
    """Log weights of poses by the net of the style."""
    return score_poses(problem.style.poses, tokens_of(seen, house, poses, shapes))


def weigh_by_tables(
    problem: VillageProblem, seen: Surroundings, house: House, shapes: Shapes, poses: Floats
) -> Floats:
    """Log weights of poses by the tables of the manner."""
    found = relate(shapes, poses[:, 2], seen.standing, problem.streets)
    return weigh(found, house.size, problem.style.manner, not len(seen.standing.shapes))


def _add_all(
    problem: VillageProblem,
    growth: Growth,
    chosen: list[int],
    rng: np.random.Generator,
    weighing: Weighing,
    goes_on: Callable[[Growth], bool],
) -> Growth:
    """Place houses one by one; one without a place is tried again, then a smaller one of its
    class in its stead."""
    for number in chosen:
        if not goes_on(growth):
            break
        for candidate in _candidates(problem, growth, number):
            pose = draw_pose(problem, growth.seen, problem.houses[candidate], rng, weighing)
            if pose is not None:
                growth = _with(growth, problem.houses[candidate], candidate, pose)
                break
    return growth


def _candidates(problem: VillageProblem, growth: Growth, number: int) -> list[int]:
    """The houses tried for one of the library, one after the other."""
    again = problem.settings.grow.retries
    if not problem.settings.composed:
        return [number] * again + _smaller(problem, number)
    house = problem.houses[number]
    if serves(house) and is_enough(problem, growth.houses):
        wanted = problem.asked is not None or house.area > OUTBUILDING
        return stand_ins(problem, number) if wanted else []
    more = stand_ins(problem, number) if not serves(house) or house.area > OUTBUILDING else []
    return [number] * again + _smaller(problem, number) + more


def _smaller(problem: VillageProblem, number: int) -> list[int]:
    """Houses of the same class of area that need less ground, the largest first; one of each of
    three sizes."""
    house = problem.houses[number]
    fitting = [
        k
        for k, h in enumerate(problem.houses)
        if h.size == house.size and h.area < house.area and (not problem.uses or h.use == house.use)
    ]
    fitting.sort(key=lambda k: -problem.houses[k].area)
    return fitting[:: max(1, len(fitting) // 3)][-3:]


def draw_pose(
    problem: VillageProblem,
    seen: Surroundings,
    house: House,
    rng: np.random.Generator,
    weighing: Weighing,
) -> Floats | None:
    """A legal pose (3,) of a house, drawn by its weight; None if none of those proposed is."""
    settings, standing = problem.settings.grow, seen.standing
    poses = propose(problem, standing, house, rng)
    shapes, _ = shapes_at(house, poses)
    good = _legal(problem, standing, house, poses)
    if problem.settings.composed and serves(house):
        good = good[stands_behind(problem, seen, shapes[good])]
    if not len(good):
        return None
    good = rng.permutation(good)[: settings.judged]
    weight = weighing(problem, seen, house, shapes[good], poses[good])
    if problem.settings.composed:
        weight = weight + compose_weights(problem, house, shapes[good], poses[good, 2])
    if settings.temperature <= 0:
        return np.asarray(poses[good[int(np.argmax(weight))]])
    odds = np.exp((weight - weight.max()) / settings.temperature)
    return np.asarray(poses[good[int(rng.choice(len(good), p=odds / odds.sum()))]])


def is_slit(standing: StandingHouses, shapes: Shapes) -> Flags:
    """Which footprints (k,) leave a slit beside a house: walls are shared or stand apart."""
    found = np.zeros(len(shapes), np.bool_)
    if len(standing.shapes) and len(shapes):
        tree = shapely.STRtree(standing.shapes)
        (row, _), away = tree.query_nearest(shapes, return_distance=True, all_matches=False)
        found[row] = (away > SLIT[0]) & (away < SLIT[1])
    return found


def _with(growth: Growth, house: House, number: int, pose: Floats) -> Growth:
    ring = place(house.outline, pose[None])[0]
    frame = np.array([pose[0], pose[1], pose[2], *house.extent])
    standing = add(growth.standing, shapely.Polygon(ring), frame, house.size)
    return Growth(
        with_house(growth.seen, standing), (*growth.houses, number), (*growth.poses, pose)
    )


def _keep_reached(problem: VillageProblem, growth: Growth) -> tuple[Growth, np.ndarray, list[int]]:
    """What was grown less houses that no way leads to, smallest first; their doors; and which
    were taken away."""
    fixed = len(problem.fixed.shapes)
    lost: list[int] = []
    while True:
        doors = assign_doors(
            problem.walkable, ways_of(problem), _rings(growth.standing), fronts_of(problem, growth)
        )
        own = np.flatnonzero(~doors.reached[fixed:])
        if not len(own):
            return growth, doors.side[fixed:], lost
        worst = int(min(own, key=lambda k: problem.houses[growth.houses[k]].area))
        lost.append(growth.houses[worst])
        growth = _without(growth, fixed, worst)


def _rings(standing: StandingHouses) -> list[Points]:
    return [shapely.get_coordinates(shape.exterior)[:-1] for shape in standing.shapes]


def fronts_of(problem: VillageProblem, growth: Growth) -> list[int]:
    """The only side that may have the door of each house (-1: any); models have a front."""
    found = [-1] * len(problem.fixed.shapes)
    for number in growth.houses:
        house = problem.houses[number]
        found.append(-1 if house.front is None else front_side(house.outline, house.front))
    return found


def front_side(outline: Points, front: float) -> int:
    """The side of a ring (n, 2) farthest ahead in a direction.

    >>> front_side(np.array([[-1, -1], [1, -1], [1, 1], [-1, 1.0]]), np.pi / 2)
    2
    """
    middle = (outline + np.roll(outline, -1, axis=0)) / 2
    return int(np.argmax(np.round(middle @ (np.cos(front), np.sin(front)), 6)))


def _without(growth: Growth, fixed: int, number: int) -> Growth:
    keep = np.arange(len(growth.standing.shapes)) != fixed + number
    standing = growth.standing.take(keep)
    houses = (*growth.houses[:number], *growth.houses[number + 1 :])
    return Growth(
        without_houses(growth.seen, standing),
        houses,
        (*growth.poses[:number], *growth.poses[number + 1 :]),
    )
