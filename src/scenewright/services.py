"""Outlets and radiators of a brief, put on the walls of their room."""

from __future__ import annotations

from dataclasses import replace
from math import atan2

import numpy as np

from scenewright.brief import Brief, Room
from scenewright.brief.services import OutletBrief, RadiatorBrief
from scenewright.errors import InputError
from scenewright.openings import REACH, Runs, line_of, runs_of, stretch_of
from scenewright.space import Opening, Outlet, Radiator, Space

PLATE = 0.08
"""Width of what an outlet takes of its wall, in metres."""


def served(brief: Brief, room: Room, space: Space, told: str) -> Space:
    """The space with the outlets and radiators its room lists; ``told`` names it in messages."""
    if not room.outlets and not room.radiators:
        return space
    runs, reach = runs_of(space), max(brief.wall_thickness, REACH)
    listed: list[tuple[str, OutletBrief | RadiatorBrief]] = [
        *((f"outlets[{k}]", outlet) for k, outlet in enumerate(room.outlets)),
        *((f"radiators[{k}]", radiator) for k, radiator in enumerate(room.radiators)),
    ]
    outlets: list[Outlet] = []
    radiators: list[Radiator] = []
    for which, wish in listed:
        try:
            if isinstance(wish, OutletBrief):
                outlets.append(_outlet(runs, wish, reach))
            else:
                name = wish.id or f"{space.id}/radiator_{len(radiators) + 1}"
                radiators.append(_radiator(runs, wish, name, space, reach))
        except InputError as error:
            raise error.located(place=f"{told} {which}") from None
    return replace(space, outlets=tuple(outlets), radiators=tuple(radiators))


def _outlet(runs: Runs, wish: OutletBrief, reach: float) -> Outlet:
    middle, along, _ = line_of(stretch_of(runs, wish.at, PLATE, reach))
    heading = atan2(along[0], -along[1])
    return Outlet(wish.id, wish.kind, float(middle[0]), float(middle[1]), heading, wish.required)


def _radiator(runs: Runs, wish: RadiatorBrief, name: str, space: Space, reach: float) -> Radiator:
    """A radiator with its back on the wall; not where one goes through a door."""
    middle, along, width = line_of(stretch_of(runs, wish.at, wish.width, reach))
    for opening in space.openings:
        if opening.kind != "window" and _before(opening, middle, along, width):
            raise InputError(f"stands before {opening.id}", "move it along the wall")
    if wish.z + wish.height > space.height:
        raise InputError(
            f"is {wish.z + wish.height:g} m high, but the ceiling is at {space.height:g} m",
            "make it lower",
        )
    x, y = middle + np.array([-along[1], along[0]]) * wish.depth / 2
    return Radiator(
        name, float(x), float(y), atan2(along[0], -along[1]),
        width, wish.depth, wish.height, wish.z,
    )  # fmt: skip


def _before(
    opening: Opening, middle: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
    along: np.ndarray[tuple[int, ...], np.dtype[np.float64]], width: float,
) -> bool:  # fmt: skip
    """Whether a stretch of wall and an opening take the same part of it, by over a centimetre."""
    off = np.array([opening.x, opening.y]) - middle
    parallel = abs(opening.ux * along[0] + opening.uy * along[1]) > 0.9
    across = abs(off[0] * along[1] - off[1] * along[0]) < opening.thickness / 2 + 0.05
    return bool(parallel and across and abs(off @ along) < (width + opening.width) / 2 - 0.01)
