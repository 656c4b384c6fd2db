"""Outlets and radiators of a brief, put on the walls of their room."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import count
from math import atan2

import numpy as np

from scenewright.building.ceiling import lowest, planes
from scenewright.building.openings import REACH, Runs, line_of, runs_of, stretch_of
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.services import OutletBrief, RadiatorBrief
from scenewright.core.errors import InputError
from scenewright.core.space import Opening, Outlet, Radiator, Space

PLATE = 0.08
"""Width of what an outlet takes of its wall, in metres."""
LEVEL = 1e-6
"""Metres up to which two heights count as the same."""


def add_services(brief: Brief, room: Room, space: Space, place: str) -> Space:
    """The space with the outlets and radiators its room lists; ``place`` names it in messages."""
    if not room.outlets and not room.radiators:
        return space
    runs, reach = runs_of(space), max(brief.wall_thickness, REACH)
    names = _names(brief, space)
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
                radiators.append(_radiator(runs, wish, wish.id or next(names), space, reach))
        except InputError as error:
            raise error.located(place=f"{place} {which}") from None
    return replace(space, outlets=tuple(outlets), radiators=tuple(radiators))


def _names(brief: Brief, space: Space) -> Iterator[str]:
    """Names for radiators without one, different from all names in the brief."""
    given = {item.id for room in brief.rooms for item in room.fixed}
    given |= {radiator.id for room in brief.rooms for radiator in room.radiators}
    names = (f"{space.id}/radiator_{number}" for number in count(1))
    return (name for name in names if name not in given)


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
    x, y = (middle + np.array([-along[1], along[0]]) * wish.depth / 2).tolist()
    box = np.array([[x, y, heading := atan2(along[0], -along[1]), width, wish.depth]])
    ceiling, top = float(lowest(box, planes(space), space.height)[0]), wish.z + wish.height
    if top > ceiling + LEVEL:
        raise InputError(
            f"rises to {top:g} m, but the ceiling there is at {ceiling:.4g} m", "make it lower"
        )
    return Radiator(name, x, y, heading, width, wish.depth, wish.height, wish.z)


def _before(
    opening: Opening,
    middle: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
    along: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
    width: float,
) -> bool:
    """Whether a stretch of wall and an opening take the same part of it, by over a centimetre."""
    off = np.array([opening.x, opening.y]) - middle
    parallel = abs(opening.ux * along[0] + opening.uy * along[1]) > 0.9
    across = abs(off[0] * along[1] - off[1] * along[0]) < opening.thickness / 2 + 0.05
    return bool(parallel and across and abs(off @ along) < (width + opening.width) / 2 - 0.01)
