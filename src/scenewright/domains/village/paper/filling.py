"""The loop of Zhu, Jiang and Li (2022): another? which? where? which way? fetch it, repeat.

Where a library has no doors, each longer side of a house may have it: a candidate each.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.village.house import House, class_of_shape
from scenewright.domains.village.paper.nets_file import PaperNets
from scenewright.domains.village.paper.passes import (
    draw_cosine,
    odds_of_another,
    odds_of_classes,
    odds_of_places,
)
from scenewright.domains.village.paper.retrieval import PlacedHouse, RetrievedHouse, retrieve
from scenewright.domains.village.paper.views import (
    SHAPES,
    PaperHouses,
    ViewFrame,
    base_and_door,
    centre_view,
    class_planes,
    count_vector,
    door_points,
    frame_of,
    paint,
)
from scenewright.domains.village.problem import VillageProblem
from scenewright.domains.village.standing import Floats, StandingHouses
from scenewright.engine.trace import Hear, tell

MOST, TRIES = 150, 12
"""Houses of a block at most, and places tried for one."""
LIKELY = 0.5
"""Odds of *continue* from which on another house follows."""
DOOR = 2.5
"""Metres that a side must have for a door, if any has them."""


class PaperFilling(NamedTuple):
    """Houses put on a block: their numbers in the library and poses (3,)."""

    houses: tuple[int, ...]
    poses: tuple[Floats, ...]


class _Candidate(NamedTuple):
    number: int
    house: RetrievedHouse


def fill_as_paper(
    nets: PaperNets,
    problem: VillageProblem,
    rng: np.random.Generator,
    goes_on: Callable[[PaperFilling], bool] | None = None,
    hear: Hear | None = None,
) -> PaperFilling:
    """The houses put on a block until *continue* says stop, at most as many as are asked for;
    ``goes_on`` gets the houses so far and may end it, ``hear`` every step (*continue*'s odds, the
    classes drawn, what was retrieved)."""
    frame = frame_of(problem.floor, nets.sizes.pixels)
    free = problem.floor.difference(problem.kept_free)
    shapely.prepare(free)
    candidates = list_candidates(problem.houses)
    houses = tell_standing(problem.fixed, problem.streets)
    found, ended = PaperFilling((), ()), f"{MOST} houses stand"
    facts = {"pixels": frame.size, "candidates": len(candidates), "standing": len(houses.bases)}
    tell(hear, "begin", 0, **facts)
    while len(found.houses) < MOST:
        if goes_on is not None and not goes_on(found):
            ended = "cancelled"
            break
        view, number = paint(frame, problem.floor, houses), len(found.houses) + 1
        odds = odds_of_another(nets, view)
        if odds < LIKELY or _is_enough(problem, houses):
            ended = "continue says stop" if odds < LIKELY else "as much stands as is asked for"
            tell(hear, "continue", number, odds=odds, another=False)
            break
        placed = _place(nets, problem.floor, free, frame, houses, view, candidates, rng)
        if placed is None:
            ended = f"no place found in {TRIES} tries"
            break
        chosen, at = placed
        house = {"house": chosen.number, "classes": chosen.house.classes, "pose": at.pose}
        tell(hear, "house", number, odds=odds, another=True, **house)
        found = PaperFilling((*found.houses, chosen.number), (*found.poses, at.pose))
        houses = _with(houses, at, chosen.house.classes)
    tell(hear, "stop", len(found.houses), reason=ended)
    return found


def _is_enough(problem: VillageProblem, houses: PaperHouses) -> bool:
    """Whether as much stands as is asked for, where a brief says how much."""
    if problem.asked is not None:
        return len(houses.footprints) >= problem.asked
    covered = float(shapely.area(houses.footprints).sum())
    return problem.coverage is not None and covered >= problem.coverage * problem.floor.area


def list_candidates(houses: Sequence[House]) -> list[_Candidate]:
    """Every house of a library with its door, or each side that may have it."""
    found = []
    for number, house in enumerate(houses):
        ring = house.outline
        step = np.roll(ring, -1, axis=0) - ring
        length, middle = np.hypot(step[:, 0], step[:, 1]), ring + step / 2
        wide = np.flatnonzero(length >= min(DOOR, length.max()))
        if house.front is not None:
            ahead = middle @ (np.cos(house.front), np.sin(house.front))
            wide = np.array([int(np.argmax(np.round(ahead, 6)))])
        doors = [np.array(house.door)] if house.door is not None else [middle[k] for k in wide]
        classes = (house.material, house.shape, house.size)
        found += [_Candidate(number, RetrievedHouse(ring, door, classes)) for door in doors]
    return found


def tell_standing(standing: StandingHouses, streets: Floats) -> PaperHouses:
    """Houses that stand as the paper tells them, their doors assumed."""
    rings = [shapely.get_coordinates(shape.exterior)[:-1] for shape in standing.shapes]
    doors = door_points(rings, streets)
    ends = [base_and_door(ring, door) for ring, door in zip(rings, doors, strict=True)]
    return PaperHouses(
        standing.shapes,
        np.array([base for base, _ in ends]).reshape(-1, 2),
        np.array([angle for _, angle in ends]),
        np.zeros(len(rings), np.int64),
        np.array([class_of_shape(ring) for ring in rings], np.int64),
        standing.sizes,
    )


def _place(
    nets: PaperNets,
    floor: shapely.Polygon,
    free: shapely.Geometry,
    frame: ViewFrame,
    houses: PaperHouses,
    view: np.ndarray,
    candidates: Sequence[_Candidate],
    rng: np.random.Generator,
) -> tuple[_Candidate, PlacedHouse] | None:
    """The next house and where it stands; None if no place is found."""
    counts = count_vector(houses).astype(np.float32)
    drawn = [
        _draw(odds_of_classes(nets, name, view, counts), rng)
        for name in ("material", "shape", "area")
    ]
    classes = (drawn[0], drawn[1], drawn[2])
    where = odds_of_places(nets, np.concatenate([view, class_planes(classes, frame.size)]))
    where = np.where(view[0] < 0.5, -1e9, where).ravel()
    looked = [one.house for one in candidates]
    for _ in range(TRIES):
        pixel = _draw(where, rng)
        at = np.array([[pixel % frame.size, pixel // frame.size]]) + rng.random((1, 2))
        base = frame.metres(at)[0]
        near = paint(centre_view(frame, base), floor, houses)
        shape = np.eye(SHAPES, dtype=np.float32)[classes[1]]
        cosine = draw_cosine(
            nets, near, shape, rng.normal(size=nets.sizes.hidden).astype(np.float32)
        )
        angle = float(np.arccos(np.clip(cosine, -1, 1)))
        found = retrieve(looked, classes, base, angle, floor, free, houses.footprints)
        if found is not None:
            return candidates[found.number], found.placed
    return None


def _draw(odds: np.ndarray, rng: np.random.Generator) -> int:
    shares = np.exp(odds.astype(float) - odds.max())
    return int(rng.choice(len(shares), p=shares / shares.sum()))


def _with(houses: PaperHouses, at: PlacedHouse, classes: tuple[int, int, int]) -> PaperHouses:
    base, angle = base_and_door(at.ring, at.door)
    shapes = np.empty(len(houses.footprints) + 1, object)
    shapes[:-1], shapes[-1] = houses.footprints, shapely.Polygon(at.ring)
    material, shape, area = (
        np.append(old, new) for old, new in zip(houses[3:], classes, strict=True)
    )
    bases = np.concatenate([houses.bases, base[None]])
    return PaperHouses(shapes, bases, np.append(houses.doors, angle), material, shape, area)
