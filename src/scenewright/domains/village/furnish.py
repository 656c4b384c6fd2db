"""From a filled block to its pieces and scene: houses, squares, lanes, yards."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from scenewright.core.footprint import Footprint, read_footprint
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.core.solution import Patch, Solution
from scenewright.core.space import Points
from scenewright.domains.village.blocks import BlockPlan
from scenewright.domains.village.gardens import lay_ground
from scenewright.domains.village.house import House
from scenewright.domains.village.lanes import opened
from scenewright.domains.village.library import sources_of
from scenewright.domains.village.problem import VillageLayout
from scenewright.domains.village.standing import place

SQUARE = "square"


class FrontFrame(NamedTuple):
    """A house seen from its door: the box about it, width and depth, the footprint in it, and
    where its middle is (2,) in the house's own frame."""

    width: float
    depth: float
    footprint: Footprint
    middle: tuple[float, float]


def pieces_of(plan: BlockPlan, houses: Sequence[House], layout: VillageLayout) -> tuple[Piece, ...]:
    """One piece a house, its front the side with the door; ids count by name, past those that
    stay."""
    taken = {row.id for row in plan.fixed}
    counts: dict[str, int] = {}
    found = []
    for number, pose, side in zip(
        layout.houses.tolist(), layout.poses, layout.doors.tolist(), strict=True
    ):
        house = houses[number]
        word = house.name.lower().replace(" ", "_")
        counts[word] = counts.get(word, 0) + 1
        while f"{plan.id}/{word}_{counts[word]}" in taken:
            counts[word] += 1
        found.append(_piece(plan, house, pose, side, f"{plan.id}/{word}_{counts[word]}"))
    return tuple(found)


def _piece(plan: BlockPlan, house: House, pose: Points, side: int, name: str) -> Piece:
    front = house.front if house.front is not None else direction_of(house.outline, side)
    frame = front_frame(house, front)
    at = place(np.array([frame.middle]), pose[None])[0, 0]
    heading = (float(pose[2]) + front + math.pi) % (2 * math.pi) - math.pi
    return Piece(
        id=name,
        category="building",
        asset=house.asset,
        space=plan.id,
        pose=Pose(float(at[0]), float(at[1]), 0.0, heading),
        size=Size(frame.width, frame.depth, house.height),
        group=f"{plan.id}/houses",
        function=house.name,
        footprint=frame.footprint,
    )


def direction_of(outline: Points, side: int) -> float:
    """The direction in radians in which a side of a ring (n, 2) looks."""
    step = outline[(side + 1) % len(outline)] - outline[side]
    return float(np.arctan2(-step[0], step[1]))


def front_frame(house: House, front: float) -> FrontFrame:
    """A house seen from a front that looks in the direction ``front`` of its own frame."""
    return _frame(house.outline.tobytes(), front)


@lru_cache(maxsize=4096)
def _frame(outline: bytes, front: float) -> FrontFrame:
    ring = np.frombuffer(outline).reshape(-1, 2)
    turn = math.pi / 2 - front
    cos, sin = math.cos(turn), math.sin(turn)
    local = np.round(ring @ np.array([[cos, sin], [-sin, cos]]), 9)
    low, high = local.min(0), local.max(0)
    width, depth = (round(float(v), 6) for v in high - low)
    x, y = ((low + high) / 2).tolist()
    middle = (cos * x + sin * y, -sin * x + cos * y)
    corners = [(float(a), float(b)) for a, b in local]
    return FrontFrame(width, depth, read_footprint(corners, width, depth), middle)


def square_patch(plan: BlockPlan, corners: Points) -> Patch:
    """A free square (4, 2) as a patch of the solution."""
    step = corners[1] - corners[0]
    side = float(np.hypot(*step))
    x, y = corners.mean(0).tolist()
    heading = float(np.arctan2(-step[0], step[1]))
    return Patch(f"{plan.id}/{SQUARE}", plan.id, SQUARE, (x, y, heading, side, side))


def scene_of_village(solution: Solution, plan: Plan) -> Scene:
    """The scene of a solution: lanes, squares, walks and yards, and houses."""
    ground = lay_ground(opened(plan, solution).detail, solution.pieces, solution.patches)
    sources = sources_of(solution.brief)
    return Scene(
        solution.brief.name,
        plan.levels,
        plan.spaces,
        (),
        (),
        solution.pieces,
        ground,
        (),
        sources=sources,
    )
