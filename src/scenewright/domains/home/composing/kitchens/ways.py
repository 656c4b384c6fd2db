"""Whether one can walk where a kitchen would stand, before its units are laid out."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.attempts.attempt import DOOR, RoomTask
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.kitchens.free_walls import KitchenStretch
from scenewright.domains.home.groups.fitted_kitchen import (
    BACK,
    FittedKitchen,
    list_fronts,
    list_solid,
    place,
)
from scenewright.domains.home.groups.kitchen import UNIT_DEPTH
from scenewright.domains.home.walking.ways import REACH, Walked, list_walked, walk

UNIT = "unit "
SAMPLE = 0.1  # between places along a wall, metres
UNIT_ASIDE = 0.32  # how far beside where one stands a unit may begin, metres


class RoomWays(NamedTuple):
    """The ways of a room without its kitchen: pieces in them, pieces to be reached, and which
    doors and pieces need not be."""

    task: RoomTask
    width: float
    walked: Walked
    joined: NDArray[np.bool_]
    far: frozenset[str]


def ways_of(task: RoomTask, rest: Placed, barred: frozenset[str]) -> RoomWays:
    """The ways beside the ``rest`` of the groups; what is ``barred`` (doors, fixed pieces, groups
    by name) need not be reached."""
    width = min(task.route_width, task.use_width) + task.preset.settings.composing.wider
    pieces = (*task.fixed, *task.beside, *(q for p in rest for q in p.pieces))
    walked = list_walked(task.ground, pieces, task.catalog, width)
    names = [f"{DOOR}{k + 1}" for k in range(len(task.ground.doors))]
    closed = barred | task.tight
    joined = np.array([name not in closed for name in names], bool)
    lost = {q.id for p in rest if p.name in barred for q in p.pieces}
    return RoomWays(task, width, walked, joined, closed | lost)


def trim_to_ways(
    ways: RoomWays, stretches: list[KitchenStretch], least: float
) -> list[KitchenStretch]:
    """The stretches cut to where people can stand before them, if at least ``least`` metres."""
    if not len(ways.task.ground.doors):
        return stretches
    deep = ways.width / 2 + REACH
    zones, owner = [], []
    for k, stretch in enumerate(stretches):
        for at in np.arange(stretch.start, stretch.end, SAMPLE).tolist():
            zones.append(place(stretch.wall, at, SAMPLE, deep, UNIT_DEPTH + BACK))
            owner.append((k, at))
    names = tuple(f"{k} {at}" for k, at in owner)
    walked = Walked(ways.walked.solid, np.array(zones).reshape(-1, 5), names)
    far, _ = walk(ways.task.ground, walked, ways.width, ways.task.entered)
    found = []
    for k, stretch in enumerate(stretches):
        near = [
            at for (i, at), name in zip(owner, names, strict=True) if i == k and name not in far
        ]
        if near:
            start = max(stretch.start, near[0] - UNIT_ASIDE)
            end = min(stretch.end, near[-1] + SAMPLE + UNIT_ASIDE)
            if end - start >= least:
                found.append(stretch._replace(start=start, end=end))
    return found


def is_walked(ways: RoomWays, kitchen: FittedKitchen, known: dict[FittedKitchen, bool]) -> bool:
    """Whether with a kitchen all that is to be reached still is, and each of its units; line after
    line, as what its first lines bar no further one opens. What is found out is ``known`` then."""
    joined = [kitchen] if kitchen.corners else []
    parts = joined or [FittedKitchen(kitchen.lines[: k + 1]) for k in range(len(kitchen.lines))]
    for part in parts:
        open_ = known.get(part)
        if open_ is None:
            open_ = known[part] = _is_walked(ways, part)
        if not open_:
            return False
    return True


def _is_walked(ways: RoomWays, kitchen: FittedKitchen) -> bool:
    if not len(ways.task.ground.doors):
        return True
    before, deep = ways.walked, ways.width / 2 + REACH
    fronts = list_fronts(kitchen, deep)
    walked = Walked(
        np.concatenate([before.solid, np.array(list_solid(kitchen))]),
        np.concatenate([before.zones, np.array(fronts)]),
        (*before.owner, *(f"{UNIT}{k}" for k in range(len(fronts)))),
    )
    far, joined = walk(ways.task.ground, walked, ways.width, ways.task.entered)
    return not far - ways.far and bool((joined | ~ways.joined).all())
