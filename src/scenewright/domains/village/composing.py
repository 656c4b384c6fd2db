"""What a designer adds to what was learned: dwellings by ways, fronts about the square,
outbuildings behind the houses they belong to and not too many of them.

Real blocks are drawn without their drives, and half of their buildings are sheds. So where a
village is composed, the learned weights of poses are changed by these rules, as costs in nats.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.house import House, is_outbuilding
from scenewright.domains.village.learned.surroundings import Surroundings
from scenewright.domains.village.problem import VillageProblem
from scenewright.domains.village.relations import fold
from scenewright.domains.village.standing import Flags, Floats, Shapes

FRONT, FAR_BACK, DEEPER = 10.0, 5.0, 0.12
"""Metres from a way within which a dwelling stands; what it costs to stand farther, and each metre
more."""
STRAIGHT, ASLANT = 0.12, 6.0
"""Radians by which a dwelling may be askew to its way, and what each radian more costs."""
BELONGS, BACK = 9.0, 1.0
"""Metres from a dwelling within which an outbuilding belongs to it, and by which it stands farther
from the street."""
MOST_SERVING = 0.34
"""Share of the houses that may be outbuildings."""
RIM_GAPS, RIM_STEPS = (1.5, 3.0, 5.0), 7
"""Metres tried between a square and the fronts about it, and places along each side."""
ALONG_RIM = 0.55
"""Least length of a front about a square by the side before it."""


def serves(house: House) -> bool:
    """Whether a house of the library is an outbuilding."""
    return is_outbuilding(house.use, house.area)


def compose_weights(
    problem: VillageProblem, house: House, shapes: Shapes, angles: Floats
) -> Floats:
    """What is added (k,) to the log weights of footprints (k,) of a house at angles (k,): 0 at
    best."""
    sides = ways_of(problem)
    lines = shapely.linestrings(sides)
    each = shapely.distance(shapes[:, None], lines[None])
    away, nearest = each.min(1), each.argmin(1)
    if not serves(house):
        along = sides[nearest, 1] - sides[nearest, 0]
        aslant = fold(angles - np.arctan2(along[:, 1], along[:, 0]))
        far = np.where(away > FRONT, FAR_BACK + DEEPER * (away - FRONT), 0.0)
        return -far - ASLANT * np.maximum(aslant - STRAIGHT, 0.0)
    return np.zeros(len(shapes))


def stands_behind(problem: VillageProblem, seen: Surroundings, shapes: Shapes) -> Flags:
    """Which footprints (k,) of an outbuilding are behind a house they belong to: near it, and
    farther from the way than it. All, where no house stands or can stand."""
    homes = seen.standing.shapes[~_serving(seen)]
    if not len(homes) or not len(shapes):
        return np.ones(len(shapes), np.bool_)
    ways = shapely.union_all(shapely.linestrings(ways_of(problem)))
    near, gap = shapely.STRtree(homes).query_nearest(
        shapes, return_distance=True, all_matches=False
    )
    theirs, away = shapely.distance(homes[near[1]], ways), shapely.distance(shapes, ways)
    return np.asarray((gap <= BELONGS) & (away >= theirs + BACK))


def _serving(seen: Surroundings) -> np.ndarray:
    return np.array([is_outbuilding("", float(s.area)) for s in seen.standing.shapes], bool)


def ways_of(problem: VillageProblem) -> Points:
    """Street sides (s, 2, 2) and the sides of the square: what fronts look at."""
    return np.concatenate([problem.streets, problem.rim])


def is_enough(problem: VillageProblem, numbers: tuple[int, ...]) -> bool:
    """Whether another outbuilding would be one too many beside the houses placed; never where the
    brief says how large houses are, or the library holds nothing else."""
    asked = any(use == "outbuilding" for use, _ in problem.uses)
    if problem.sizes is not None or asked or all(serves(house) for house in problem.houses):
        return False
    standing = len(problem.fixed.shapes) + len(numbers)
    own = sum(serves(problem.houses[k]) for k in numbers)
    own += sum(is_outbuilding("", float(s.area)) for s in problem.fixed.shapes)
    return own + 1 > MOST_SERVING * (standing + 1)


def stand_ins(problem: VillageProblem, number: int) -> list[int]:
    """Dwellings to place where one of the library by ``number`` finds no place or may not stand:
    that about as large, a smaller one and the least."""
    own = problem.houses[number].area
    most = max(1.1 * own, 60.0)
    homes = [k for k, h in enumerate(problem.houses) if not serves(h) and h.share > 0]
    fitting = [k for k in homes if problem.houses[k].area <= most] or homes
    fitting.sort(key=lambda k: abs(problem.houses[k].area - own))
    return list(dict.fromkeys([*fitting[:1], *fitting[len(fitting) // 2 :][:1], *fitting[-1:]]))


def rim_of(square: Points | None, streets: Points) -> Points:
    """The sides (k, 2, 2) of a square (4, 2) that are not on a street.

    >>> square = np.array([[0.0, 0.01], [9, 0.01], [9, 9.01], [0, 9.01]])
    >>> len(rim_of(square, np.array([[[-20.0, 0.0], [30.0, 0.0]]])))
    3
    """
    if square is None:
        return np.zeros((0, 2, 2))
    sides = np.stack([square, np.roll(square, -1, axis=0)], 1)
    away = shapely.distance(
        shapely.points(sides.mean(1)), shapely.union_all(shapely.linestrings(streets))
    )
    return sides[away > 2.0]


def rim_poses(side: Points, house: House) -> Floats:
    """Poses (k, 3) of a house along a side (2, 2) of a square, which has the square on its left:
    parallel to it, its longer wall before its shorter, near its middle first. None of a house with
    a notch, whose front may be on another side."""
    along = side[1] - side[0]
    long = float(np.hypot(*along))
    if house.shape:
        return np.zeros((0, 3))
    way = along / long
    out = np.array([way[1], -way[0]])
    turn = float(np.arctan2(way[1], way[0]))
    found = []
    for quarter in (0, 1):
        wide, deep = house.extent if quarter == 0 else house.extent[::-1]
        if not ALONG_RIM * long <= wide <= 1.6 * long:
            continue
        slack = np.linspace(-0.35, 0.35, RIM_STEPS) * long
        for gap in RIM_GAPS:
            middle = side.mean(0) + out * (gap + deep / 2)
            for shift in slack[np.argsort(np.abs(slack), kind="stable")]:
                for half in (0.0, np.pi):
                    found.append((*(middle + shift * way), turn + quarter * np.pi / 2 + half))
    return np.array(found, float).reshape(-1, 3)
