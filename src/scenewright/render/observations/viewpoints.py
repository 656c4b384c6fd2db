"""Where cameras stand and look: seeded, on free floor at eye height, towards what there is to see.

Rooms take turns, large ones more often (the highest averages of Sainte-Laguë, over the root of
their area). In a room a few free places are drawn; of each a coarse panorama tells for every
direction how much furniture is in view and how much is too near; the best view is taken.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.errors import InputError
from scenewright.geometry import rays
from scenewright.render.observations.floor import WalkableFloor
from scenewright.render.observations.views import Lens, Viewpoint
from scenewright.render.observations.world import VisibleWorld

TRIED = 12
"""Places that are tried for one camera."""
AROUND, STEEPS = 72, np.deg2rad(np.arange(-60.0, 31.0, 7.5))
"""Directions of a panorama around, and their heights, radians."""
NEAR, FAR = 0.7, 3.0
"""Nearer than the first, in metres, is in the way; farther than the second is not better."""
LOWEST, LEVEL = float(np.deg2rad(-24.0)), float(np.deg2rad(-2.0))
"""Cameras look down by an angle between these, radians."""

Floats = NDArray[np.float64]
Rng = np.random.Generator


class Panorama(NamedTuple):
    """What is seen around a place: distances and instances ``(72, 13)``."""

    away: NDArray[np.float32]
    met: NDArray[np.int32]


def choose_viewpoints(
    world: VisibleWorld,
    floors: Sequence[WalkableFloor],
    rooms: frozenset[str],
    count: int,
    eye: float,
    clearance: float,
    lens: Lens,
    rng: Rng,
) -> Iterator[Viewpoint]:
    """So many cameras ``eye`` metres above the floor of some ``rooms`` (empty: all), ``clearance``
    metres from walls and pieces; the first ones are the same however many there are."""
    free = list(_free_rooms(floors, rooms, clearance))
    if count and not free:
        raise InputError(
            f"no floor is free for a camera with {clearance:g} m around it",
            "give a smaller --clearance, or another --room",
        )
    taken: list[list[Viewpoint]] = [[] for _ in free]
    for _ in range(count):
        worth = [
            len(cells) ** 0.5 / (2 * len(t) + 1)
            for (_, _, cells), t in zip(free, taken, strict=True)
        ]
        k = int(np.argmax(worth))
        floor, number, cells = free[k]
        found = _best_of(world, floor, number, cells, eye, lens, taken[k], rng)
        taken[k].append(found)
        yield found


def _free_rooms(
    floors: Sequence[WalkableFloor], rooms: frozenset[str], clearance: float
) -> Iterator[tuple[WalkableFloor, int, NDArray[np.int64]]]:
    for floor in floors:
        open_ = floor.clear.values >= clearance
        for number in range(len(floor.spaces)):
            cells = np.flatnonzero(open_ & (floor.room == number))
            if len(cells) and (not rooms or floor.spaces[number].id in rooms):
                yield floor, number, cells


def _best_of(
    world: VisibleWorld,
    floor: WalkableFloor,
    number: int,
    cells: NDArray[np.int64],
    eye: float,
    lens: Lens,
    taken: Sequence[Viewpoint],
    rng: Rng,
) -> Viewpoint:
    """The best of some places drawn in a room, in its best direction."""
    drawn = rng.choice(cells, TRIED)
    pitches = rng.uniform(LOWEST, LEVEL, TRIED).tolist()
    places = np.column_stack([floor.centres(drawn), np.full(TRIED, floor.elevation + eye)])
    best, found = -np.inf, None
    panoramas = _panoramas(world, places)
    for place, cell, pitch, seen in zip(places, drawn, pitches, panoramas, strict=True):
        for yaw, worth in _worths(world, seen, pitch, lens):
            worth -= sum(_likeness(place, yaw, other) for other in taken)
            if worth > best:
                x, y, z = place.tolist()
                clear = round(float(floor.clear.values.flat[cell]), 4)
                space = floor.spaces[number]
                best = worth
                found = Viewpoint((x, y, z), yaw, pitch, space.id, floor.level, clear)
    assert found is not None
    return found


def _panoramas(world: VisibleWorld, places: Floats) -> Iterator[Panorama]:
    turns, steeps = np.meshgrid(2 * np.pi * np.arange(AROUND) / AROUND, STEEPS, indexing="ij")
    level = np.cos(steeps)
    ways = np.stack([level * np.cos(turns), level * np.sin(turns), np.sin(steeps)], -1)
    ways = ways.reshape(-1, 3)
    for place in places:
        away, face, _ = rays.hits(world.every, np.broadcast_to(place, ways.shape), ways)
        met = np.where(face >= 0, world.measured.keys[face], 0)
        yield Panorama(away.reshape(AROUND, -1), met.reshape(AROUND, -1))


def _worths(
    world: VisibleWorld, seen: Panorama, pitch: float, lens: Lens
) -> Iterator[tuple[float, float]]:
    """Directions, and how good the view is there: things in it, less what is too near."""
    piece = np.array([False, *(one.kind == "piece" for one in world.instances)])
    half = max(int(lens.fov / 2 / (2 * np.pi) * AROUND), 1)
    rows = np.abs(STEEPS - pitch) <= max(np.arctan(lens.height / 2 / lens.focal), 0.1)
    for middle in range(0, AROUND, 3):
        here = np.arange(middle - half, middle + half + 1) % AROUND
        away, met = seen.away[here][:, rows], seen.met[here][:, rows]
        shares = np.unique(met[piece[met]], return_counts=True)[1] / met.size
        shown = float(np.sqrt(np.minimum(shares, 0.06) / 0.06).sum())
        near = float((away < NEAR).mean())
        depth = float(np.minimum(np.median(away), FAR)) / FAR
        yield middle * 2 * np.pi / AROUND, shown + 2 * depth - 12 * max(near - 0.03, 0.0)


def _likeness(place: Floats, yaw: float, other: Viewpoint) -> float:
    """How alike two views of a room are, at most 3."""
    apart = np.hypot(*(place[:2] - other.eye[:2]))
    return float(1.5 * np.exp(-apart) * (1 + np.cos(yaw - other.yaw)))


def inside_of(world: VisibleWorld, viewpoint: Viewpoint) -> str:
    """The id of the thing an eye is inside of, empty if it is in the open: most rays from there
    leave through faces that look away from it."""
    turns = np.arange(48) * 2.399963
    up = (2 * np.arange(48) + 1) / 48 - 1
    level = np.sqrt(1 - up**2)
    ways = np.column_stack([level * np.cos(turns), level * np.sin(turns), up])
    eyes = np.broadcast_to(viewpoint.eye, ways.shape)
    _, face, normal = rays.hits(world.every, eyes, ways)
    out = (face >= 0) & (np.einsum("ij,ij->i", normal, ways) > 0)
    if out.mean() < 0.6:
        return ""
    numbers, many = np.unique(world.measured.keys[face[out]], return_counts=True)
    return world.instances[int(numbers[many.argmax()]) - 1].id
