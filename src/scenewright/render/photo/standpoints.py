"""Where a photographer stands in a room: at a wall, level, with windows and furniture in view.

Places near the walls of the free floor are tried. From each a ring of level rays tells how far it
is free; of pieces and windows in view it counts how much of the picture they fill, up to a share
each, less for what is cut by an edge; things nearer than an arm's length are in the way.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.scene import CLUTTER, Scene
from scenewright.core.space import Space
from scenewright.geometry import rays
from scenewright.render.observations.floor import WalkableFloor, walkable_floor
from scenewright.render.observations.world import VisibleWorld
from scenewright.render.photo.following import PhotoFrame
from scenewright.render.public_rooms import is_public

EYE, PUBLIC = 1.35, 1.5
"""Height of the camera in metres: above tables, below the eye, as interiors are photographed;
over counters and racks in rooms of the public."""
WIDE = float(np.tan(np.deg2rad(37.0)))
"""Tangent of half the view's width (a lens of 24 mm)."""
SHIFT = 0.17
"""How far the film is moved down, as a share of its height: floor rather than ceiling."""
TRIED = 48
AROUND, STEEPS = 96, np.linspace(-0.75, 0.35, 15)
"""Directions of the ring, and tangents of their steepness."""
CLEARANCE, NEAR, FAR, WIDE_ROOM = 0.22, 1.25, 4.5, 6.0
"""Metres: what a camera keeps off things, what is too near, and what is far in a room of this
width; farther in wider ones."""
SHORT = 0.1
"""How far before what a ray meets it is asked in which room that is, in metres."""
OTHER, SMALL = 0.15, 0.02
"""What seeing a thing of another room is worth, and a small object."""
ENOUGH = 0.05
"""Share of a picture from which a thing is not worth more."""

Floats = NDArray[np.float64]


def stand_in_rooms(
    world: VisibleWorld,
    rooms: frozenset[str],
    size: tuple[int, int],
    seed: int = 0,
    tried: int = TRIED,
) -> Iterator[tuple[Space, WalkableFloor, PhotoFrame]]:
    """A camera for each room that has a free place for one, the best of ``tried``, with the room
    and its level's floor; ``rooms`` empty: all of them, in the order of the scene."""
    scene = world.scene
    for level in scene.levels:
        floor = walkable_floor(scene, level.id, EYE)
        for number, space in enumerate(floor.spaces):
            if not rooms or space.id in rooms:
                rng = np.random.default_rng([seed, number])
                camera = _best_in_room(world, floor, number, size, rng, tried)
                if camera is not None:
                    yield space, floor, camera


def _best_in_room(
    world: VisibleWorld,
    floor: WalkableFloor,
    number: int,
    size: tuple[int, int],
    rng: np.random.Generator,
    tried: int,
) -> PhotoFrame | None:
    free = (floor.room == number) & (floor.clear.values >= CLEARANCE)
    cells = np.flatnonzero(free)
    if not len(cells):
        return None
    places = floor.centres(cells)
    outward = np.linalg.norm(places - places.mean(0), axis=1)
    chance = (outward + 0.1) ** 2
    drawn = rng.choice(len(cells), min(tried, len(cells)), replace=False, p=chance / chance.sum())
    own = _own_things(world, world.scene, floor.spaces[number].id)
    best, found = -np.inf, (places[drawn[0]], 0.0)
    space = floor.spaces[number]
    height = floor.elevation + (PUBLIC if is_public(space) else EYE)
    far = FAR * max(1.0, float(np.sqrt(shapely.Polygon(space.outline).area)) / WIDE_ROOM)
    for place in places[drawn]:
        eye = np.array([*place, height])
        for yaw, worth in _worths(world, eye, own, floor, number, far):
            if worth > best:
                best, found = worth, (place, yaw)
    return frame_of((*found[0], height), found[1], size)


def _own_things(world: VisibleWorld, scene: Scene, room: str) -> NDArray[np.float64]:
    """What it is worth to see each instance: pieces and openings of the room more than others."""
    mine = {piece.id for piece in scene.pieces if piece.space == room}
    small = {piece.id for piece in scene.pieces if piece.function == CLUTTER}
    mine |= {one.id for one in scene.openings if room in one.spaces and one.kind == "window"}
    shown = (one.kind in ("piece", "opening") for one in world.instances)
    worths = (
        SMALL if one.id in small else 1.0 if one.id in mine else OTHER for one in world.instances
    )
    return np.array([0.0, *(s * w for s, w in zip(shown, worths, strict=True))])


def _worths(
    world: VisibleWorld, eye: Floats, own: Floats, floor: WalkableFloor, number: int, reach: float
) -> Iterator[tuple[float, float]]:
    """Directions around a place, and how good the picture is; at ``reach`` a depth is enough."""
    turns = 2 * np.pi * np.arange(AROUND) / AROUND
    ways = np.stack(
        [
            np.repeat(np.cos(turns), len(STEEPS)),
            np.repeat(np.sin(turns), len(STEEPS)),
            np.tile(STEEPS, AROUND),
        ],
        -1,
    )
    away, face, _ = rays.hits(world.every, np.broadcast_to(eye, ways.shape), ways)
    met = np.where(face >= 0, world.measured.keys[face], 0).reshape(AROUND, -1)
    ends = eye + np.maximum(np.minimum(away, 99.0) - SHORT, 0.0)[:, None] * ways
    beyond = _is_elsewhere(floor, number, ends).reshape(AROUND, -1)
    away = away.reshape(AROUND, -1)
    wider = reach / FAR
    half = int(np.arctan(WIDE) / (2 * np.pi) * AROUND)
    for ahead in range(0, AROUND, 2):
        here = np.arange(ahead - half, ahead + half + 1) % AROUND
        seen, far = met[here], np.minimum(away[here], reach)
        numbers, counts = np.unique(seen, return_counts=True)
        shares = counts / seen.size
        shown = float((own[numbers] * np.sqrt(np.minimum(shares, ENOUGH) / ENOUGH)).sum())
        cut = float(own[np.unique(seen[[0, -1]])].sum())
        near = float((far < NEAR * np.sqrt(wider)).mean())
        deep = float(far[:, len(STEEPS) // 2 :].mean()) / reach
        third = len(here) // 3
        middle = float(far[third : 2 * third, len(STEEPS) // 3 :].min(1).mean()) / reach
        other = float(beyond[here].mean())
        open_view = 3.0 * deep + 2.0 * wider**1.5 * middle
        blocked = 0.6 * cut + 14.0 * max(near - 0.01, 0.0) + 8.0 * other
        yield turns[ahead], shown + open_view - blocked


def _is_elsewhere(floor: WalkableFloor, number: int, points: Floats) -> NDArray[np.bool_]:
    """Whether each point is in another room than the one of a ``number``."""
    clear = floor.clear
    columns, rows = ((points[:, :2] - (clear.x0, clear.y0)) / clear.cell).astype(int).T
    high, wide = floor.room.shape
    inside = (rows >= 0) & (columns >= 0) & (rows < high) & (columns < wide)
    room = floor.room[rows.clip(0, high - 1), columns.clip(0, wide - 1)]
    return inside & (room >= 0) & (room != number)


def frame_of(eye: tuple[float, ...], yaw: float, size: tuple[int, int]) -> PhotoFrame:
    """A level camera: verticals stay upright, the film is shifted down."""
    width, height = size
    step = 2 * WIDE / width
    ahead = np.array([np.cos(yaw), np.sin(yaw), 0.0])
    right = np.array([np.sin(yaw), -np.cos(yaw), 0.0])
    axes = np.stack([right, [0.0, 0.0, 1.0], ahead]).astype(np.float32)
    top = (0.5 - SHIFT) * height * step
    frame = np.array([-WIDE, top, step], np.float32)
    return PhotoFrame(np.array(eye, np.float32), axes, frame, width, height)
