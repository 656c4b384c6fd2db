"""Where light comes from: sun, sky through the openings of outer walls, and lamps.

In kilolux and kilocandela a square metre. Lamps give what their kind states.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.door_uses import OPEN_AIR, classify_doors
from scenewright.core.catalog import Material
from scenewright.core.scene import Scene
from scenewright.core.space import Opening, Space
from scenewright.render.colour import linear_of
from scenewright.render.daylight import HOURS, towards
from scenewright.render.items import to_level_coordinates
from scenewright.render.lamps import Lamp
from scenewright.render.light_rows import find_dark, light_rows
from scenewright.render.observations.ceilings import CEILING
from scenewright.render.observations.floor import WalkableFloor
from scenewright.render.observations.world import VisibleWorld
from scenewright.render.street import MEADOW

Singles = NDArray[np.float32]
Floats = NDArray[np.float64]

GLAZED = 0.8
"""Share of light that two panes and a frame let through (EN 410: 0.80 to 0.82)."""
SUN_RADIUS = 0.008
"""Tangent of the radius of the sun's disc, softened a little by haze."""
ASIDE = float(np.deg2rad(38.0))
"""How far the sun stands aside of the way out of the largest window."""
BEYOND = 0.15
"""What a source is expected to give to a room next door, as a share."""
BESIDE = 0.3
"""How far beside a wall's middle, in metres, it is asked which side is a room."""


GRASS = (0.018, 0.026, 0.008)
"""Share of each colour that a lawn gives back; as the sky, it is shown darker than it is."""


class Sources(NamedTuple):
    """Sources as arrays for kernels: ``sun`` (4, 3), ``sky`` (3, 3), lamps and windows (k, 11),
    the share of light that gets from room to room (r, r), the raster of rooms over its ground
    (left, low, cell), and the finishes with what they glow."""

    sun: Singles
    sky: Singles
    sources: Singles
    links: Singles
    rooms: NDArray[np.int32]
    ground: Singles
    table: Singles


def find_sources(
    world: VisibleWorld, floor: WalkableFloor, lit: Sequence[Lamp], hour: str, room: str
) -> Sources:
    """The sources of light of a level, with the lamps ``lit``, at an hour of
    :data:`~scenewright.render.daylight.HOURS`; the sun stands where it shines in through the
    largest window of a room."""
    light, scene = HOURS[hour], world.scene
    numbers = {space.id: number for number, space in enumerate(floor.spaces)}
    windows = np.array([*_windows(scene, floor, numbers)]).reshape(-1, 11)
    windows[:, 1] *= float(np.mean(light.horizon))
    lamps = np.array([*_lamps(scene, lit, numbers)]).reshape(-1, 11)
    lamps = np.vstack([lamps, *_light_rows(floor, lit, lamps, windows)])
    side = _sun_side(windows, numbers.get(room, -1))
    return Sources(
        np.vstack([_sun_towards(side, light.height), [light.sun]]).astype(np.float32),
        np.array([light.ground, light.horizon, light.zenith], np.float32),
        np.vstack([lamps, windows]).astype(np.float32),
        _links(scene.openings, numbers),
        _rooms_under_roofs(floor),
        np.array([floor.clear.x0, floor.clear.y0, floor.clear.cell], np.float32),
        _glowing(world.stage.table, light.glow),
    )


def _rooms_under_roofs(floor: WalkableFloor) -> NDArray[np.int32]:
    """The raster of rooms; those in the open air are none."""
    shut = [OPEN_AIR.isdisjoint(space.functions) for space in floor.spaces]
    return np.where(np.array([*shut, False])[floor.room], floor.room, np.int32(-1))


def _links(openings: Sequence[Opening], numbers: Mapping[str, int]) -> Singles:
    """How much of a source is expected in another room: all in its own, some through a door."""
    found = np.eye(len(numbers), dtype=np.float32)
    for one in openings:
        joined = [numbers[name] for name in one.spaces if name in numbers]
        if len(joined) == 2 and one.kind != "window":
            found[joined[0], joined[1]] = found[joined[1], joined[0]] = BEYOND
    return found


def _windows(
    scene: Scene, floor: WalkableFloor, numbers: Mapping[str, int]
) -> Iterator[list[float]]:
    """Openings of a level to the open air: room, area, middle, 0, way out, width, height, what is
    let in."""
    rooms = {space.id: space for space in floor.spaces if OPEN_AIR.isdisjoint(space.functions)}
    uses = classify_doors(scene.openings, scene.spaces)
    for one in scene.openings:
        inner = [rooms[name] for name in one.spaces if name in rooms]
        clear = one.kind != "door" or uses.get(one.id) == "garden"
        if len(inner) == 1 and clear and one.roof is None:
            x, y = _way_out(one, inner[0])
            middle, tall = floor.elevation + (one.sill + one.head) / 2, one.head - one.sill
            place = [one.x, one.y, middle, 0.0]
            number = numbers[inner[0].id]
            yield [number, one.width * tall, *place, x, y, one.width, tall, GLAZED]


def _way_out(opening: Opening, room: Space) -> tuple[float, float]:
    x, y = -opening.uy, opening.ux
    away = opening.thickness / 2 + BESIDE
    floor = shapely.Polygon(room.outline)
    inside = floor.contains(shapely.Point(opening.x + away * x, opening.y + away * y))
    return (-x, -y) if inside else (x, y)


def _sun_side(windows: Floats, room: int) -> float:
    """The direction in plan in which the sun stands."""
    mine = windows[windows[:, 0] == room] if (windows[:, 0] == room).any() else windows
    if not len(mine):
        return -np.pi / 3
    row = mine[np.argmax(mine[:, 1])]
    return float(np.arctan2(row[7], row[6])) + ASIDE


def _sun_towards(turn: float, height: float) -> Floats:
    """Two directions across the sun by its radius, and the one to it."""
    to = towards(turn, height)
    side = np.array([-np.sin(turn), np.cos(turn), 0.0])
    return np.stack([SUN_RADIUS * side, SUN_RADIUS * np.cross(to, side), to])


def _lamps(scene: Scene, lit: Sequence[Lamp], numbers: Mapping[str, int]) -> Iterator[list[float]]:
    heights = {level.id: level.elevation for level in scene.levels}
    for lamp in lit:
        if lamp.item.space in numbers:
            x, y, z = to_level_coordinates(lamp.item, np.array([lamp.at]))[0].tolist()
            z += heights[lamp.item.level]
            candela = lamp.lumens / (4 * np.pi) / 1000
            light = [candela * share for share in lamp.color]
            yield [numbers[lamp.item.space], candela, x, y, z, lamp.radius, *light, 0.0, 0.0]


def _light_rows(
    floor: WalkableFloor, lit: Sequence[Lamp], lamps: Floats, windows: Floats
) -> Iterator[Floats]:
    """Rows of lights under the ceilings of dark rooms that are large or have no other light."""
    numbers = {space.id: number for number, space in enumerate(floor.spaces)}
    known = frozenset(floor.spaces[int(k)].id for k in {*lamps[:, 0], *windows[:, 0]})
    for row in light_rows(find_dark(floor.spaces, lit), known):
        light = row.candela / 1000 * np.array(row.color)
        for x, y, z in row.places:
            place = [numbers[row.space.id], row.candela / 1000, x, y, floor.elevation + z]
            yield np.array([*place, 0.05, *light, 0.0, 0.0])


def _glowing(table: Singles, glow: float) -> Singles:
    """The finishes with their glow in kilocandela a square metre; ceilings do not glow here, and
    a meadow swallows more light than it is drawn with."""
    found = table.copy()
    found[:, 5] *= glow
    found[_made_of(CEILING, found), 5] = 0.0
    found[_made_of(MEADOW, found), :3] = GRASS
    return found


def _made_of(material: Material, table: Singles) -> NDArray[np.bool_]:
    color = linear_of(np.array(material.color)).astype(np.float32)
    return np.asarray(np.abs(table[:, :3] - color).max(1) < 1e-6)
