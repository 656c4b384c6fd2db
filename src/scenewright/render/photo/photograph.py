"""A photograph of each room: camera, light, film, picture."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import NamedTuple

import shapely

from scenewright.core.catalog import Catalog
from scenewright.core.errors import InputError
from scenewright.core.scene import Scene
from scenewright.core.space import Space
from scenewright.render.items import things
from scenewright.render.lamps import lamps_of
from scenewright.render.observations.floor import walkable_floor
from scenewright.render.observations.world import VisibleWorld, solid_parts
from scenewright.render.photo.denoising import take_out_noise
from scenewright.render.photo.developing import develop
from scenewright.render.photo.following import PhotoFrame, expose
from scenewright.render.photo.sources import Sources, find_sources
from scenewright.render.photo.standpoints import EYE, frame_of, stand_in_rooms
from scenewright.render.picture import Pixels
from scenewright.render.textures.worn import wear_textures

SIZE, SAMPLES = (1280, 800), 8


class View(NamedTuple):
    """A room, its camera and the light there."""

    space: Space
    camera: PhotoFrame
    sources: Sources


class Photo(NamedTuple):
    """A room and its picture ``(height, width, 3)`` in sRGB."""

    space: Space
    pixels: Pixels


def shut_doors(scene: Scene) -> Scene:
    """A scene whose leaves are shut unless its brief says how far they stand open: as drawn they
    stand open, in the way of a view."""
    shut = (replace(one, ajar=0.0) if one.ajar is None else one for one in scene.openings)
    return replace(scene, openings=tuple(shut))


def views_of(
    world: VisibleWorld,
    catalog: Catalog,
    rooms: frozenset[str] = frozenset(),
    hour: str = "day",
    size: tuple[int, int] = SIZE,
    seed: int = 0,
) -> Iterator[View]:
    """The best view of each room by id (none given: all), in the order of the scene; a room
    without a free place is left out. ``hour`` is one of
    :data:`scenewright.render.daylight.HOURS`."""
    lit = [*lamps_of(things(world.scene, catalog), catalog)]
    for space, floor, camera in stand_in_rooms(world, rooms, size, seed):
        yield View(space, camera, find_sources(world, floor, lit, hour, space.id))


def photograph(
    world: VisibleWorld,
    catalog: Catalog,
    rooms: frozenset[str] = frozenset(),
    hour: str = "day",
    size: tuple[int, int] = SIZE,
    samples: int = SAMPLES,
    seed: int = 0,
) -> Iterator[Photo]:
    """A picture of each of :func:`views_of`; ``samples`` paths are followed a pixel. The same seed
    gives the same picture."""
    worn = wear_textures(solid_parts(world.scene, catalog), len(world.stage.corners))
    for space, camera, sources in views_of(world, catalog, rooms, hour, size, seed):
        film = expose(world, sources, camera, samples, worn)
        yield Photo(space, develop(take_out_noise(film)))


def photograph_view(
    world: VisibleWorld,
    catalog: Catalog,
    eye: tuple[float, float, float],
    heading: float,
    hour: str = "day",
    size: tuple[int, int] = SIZE,
    samples: int = SAMPLES,
    tell: Callable[[float], None] = lambda _share: None,
) -> Pixels:
    """A picture ``(height, width, 3)`` from (x, y, z) of an ``eye`` in a room, metres, looking
    level along a ``heading``; ``tell`` hears the share done, from several threads, and may raise to
    end it. InputError where no room is."""
    scene, (x, y, z) = world.scene, eye
    below = [level for level in scene.levels if level.elevation <= z] or [*scene.levels[:1]]
    level = max(below, key=lambda one: one.elevation)
    at = shapely.Point(x, y)
    rooms = [space for space in scene.spaces if space.level == level.id]
    here = [space for space in rooms if shapely.Polygon(space.outline).covers(at)]
    if not here:
        raise InputError(f"no room is at ({x:.2f}, {y:.2f})", "stand in one")
    floor = walkable_floor(scene, level.id, EYE)
    lit = [*lamps_of(things(scene, catalog), catalog)]
    sources = find_sources(world, floor, lit, hour, here[0].id)
    worn = wear_textures(solid_parts(scene, catalog), len(world.stage.corners))
    film = expose(world, sources, frame_of(eye, heading, size), samples, worn, tell)
    return develop(take_out_noise(film))
