"""From houses placed by hand or by another program to the solution of a village."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.layout import Layouts, NamedBox, check_layouts
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.village.build_problem import build_problem
from scenewright.domains.village.furnish import direction_of, front_frame
from scenewright.domains.village.house import House
from scenewright.domains.village.plan import plan_village
from scenewright.domains.village.presets import PRESETS
from scenewright.domains.village.problem import VillageLayout
from scenewright.domains.village.solving import FilledBlock, assemble_solution, furnish_block

FITS = 0.01
"""Metres by which a box may differ from the house it is of."""


def solution_of(
    brief: Brief, layouts: Layouts, *, plan: Plan | None = None, seed: int = 0
) -> Solution:
    """The solution whose houses stand on the boxes given, by their names in the library, the door
    ahead; trees are added by ``seed``. What a block asks for beyond these is left out."""
    started = time.perf_counter()
    made = plan or plan_village(brief)
    check_layouts(layouts, [space.id for space in made.spaces])
    built: list[FilledBlock] = []
    for k, (block, one) in enumerate(zip(brief.part.blocks, made.detail.blocks, strict=True)):
        problem = build_problem(block, one, made.detail, PRESETS["default"].settings)
        free = shapely.difference(problem.floor, problem.kept_free)
        layout = _layout(made.detail.houses, layouts.get(one.id, ()), one.id, free)
        asked = max((block.count or 0) - len(one.fixed), len(layout.houses), 1)
        layout = layout._replace(asked=asked)
        built.append(furnish_block(block, one, made.detail, problem, layout, 0, seed + 7919 * k))
    return assemble_solution(brief, built, "default", "given", seed, time.perf_counter() - started)


def _layout(
    houses: Sequence[House], given: Sequence[NamedBox], block: str, free: shapely.Geometry
) -> VillageLayout:
    """Houses, poses and doors of boxes; InputError for a box that no house fits. Of several ways a
    house fits its box, as one with a corner cut out does, that which keeps most to ``free`` ground
    and off the houses that fit theirs in one way.
    """
    names = {house.name: number for number, house in enumerate(houses)}
    numbers, fitting = [], []
    for k, one in enumerate(given):
        place = f"{block}[{k}] '{one.name}'"
        if one.name not in names:
            known = ", ".join(sorted(names))
            raise InputError("is no house of the library", f"use one of: {known}", place=place)
        house = houses[names[one.name]]
        fronts = _find_fronts(house, one.box, place)
        fitting.append([(side, _pose_in(house, front, one.box)) for side, front in fronts])
        numbers.append(names[one.name])
    doors, poses = np.zeros(len(given), np.int64), np.zeros((len(given), 3))
    for k in sorted(range(len(given)), key=lambda k: len(fitting[k])):
        house = houses[numbers[k]]
        shapes = [_stand(house, pose) for _, pose in fitting[k]]
        best = int(np.argmin([round(shapely.difference(s, free).area, 2) for s in shapes]))
        doors[k], poses[k] = fitting[k][best]
        free = shapely.difference(free, shapes[best])
    return VillageLayout(np.array(numbers, np.int64), poses, doors, len(numbers), {})


def _pose_in(house: House, front: float, box: tuple[float, ...]) -> tuple[float, float, float]:
    """The pose of a house whose front is that of a box."""
    turn = box[2] - front
    cos, sin = math.cos(turn), math.sin(turn)
    x, y = front_frame(house, front).middle
    return box[0] - cos * x + sin * y, box[1] - sin * x - cos * y, turn


def _stand(house: House, pose: tuple[float, float, float]) -> shapely.Polygon:
    """The ground a house stands on."""
    cos, sin = math.cos(pose[2]), math.sin(pose[2])
    return shapely.Polygon(house.outline @ np.array([[cos, sin], [-sin, cos]]) + np.array(pose[:2]))


def _find_fronts(house: House, box: tuple[float, ...], place: str) -> list[tuple[int, float]]:
    """The sides of a house that may be the front of a box, and their directions: those that make
    the box of its size; InputError if none does."""
    sides = range(len(house.outline)) if house.front is None else (0,)
    seen, found = [], []
    for side in sides:
        front = direction_of(house.outline, side) if house.front is None else house.front
        frame = front_frame(house, front)
        if max(abs(frame.width - box[3]), abs(frame.depth - box[4])) <= FITS:
            found.append((side, front))
        seen.append(f"{frame.width:g} x {frame.depth:g}")
    if found:
        return found
    area = float(shapely.area(shapely.Polygon(house.outline)))
    raise InputError(
        f"is {box[3]:g} x {box[4]:g} m, the house {' or '.join(dict.fromkeys(seen))} m "
        f"({area:.0f} m²)",
        "give the box the house's size",
        place=place,
    )
