"""Light followed back from a camera: sun, sky through windows and lamps, over bounces."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry import rays
from scenewright.render.finish import PLAIN
from scenewright.render.observations.world import VisibleWorld
from scenewright.render.photo import kernels
from scenewright.render.photo.panes import pass_panes
from scenewright.render.photo.sources import Sources
from scenewright.render.photo.texture_kernels import paint_hits
from scenewright.render.textures.worn import WornTextures, wear_textures

Singles = NDArray[np.float32]
Ints = NDArray[np.int32]

PORTION = 1 << 15
"""Pixels that are followed together: their numbers stay in the cache."""
BOUNCES = 2
PANE = 0.2
"""The sky beyond a window is shown darker than it shines, as a photographer blends two pictures."""
SPARK = 0.7
"""After the first bounce a sample brings at most this many times what the sky gives: more is a
spark."""


class PhotoFrame(NamedTuple):
    """A camera that looks level: ``eye`` (3,), ``axes`` (3, 3) right, up and ahead, the ``frame``
    (3,) left edge, top edge and step of a pixel at distance 1, and the size in pixels."""

    eye: Singles
    axes: Singles
    frame: Singles
    width: int
    height: int


class LitWorld(NamedTuple):
    """What rays run through: a world, its sources of light, and what its faces wear."""

    world: VisibleWorld
    sources: Sources
    worn: WornTextures


class Exposure(NamedTuple):
    """What light fell on a film, ``(height, width, 3)`` each: linear light, and of the surface
    seen first its colour and its normal."""

    light: Singles
    body: Singles
    facing: Singles


class Paths(NamedTuple):
    """Rays under way: their pixel, row of the film, start, direction, what they let through, and
    whether they saw no rough surface yet."""

    pixels: Ints
    rows: Ints
    starts: Singles
    ways: Singles
    through: Singles
    bare: NDArray[np.bool_]

    def keep(self, which: NDArray[np.intp]) -> Paths:
        """Those of some rows."""
        return Paths(
            self.pixels[which],
            self.rows[which],
            self.starts[which],
            self.ways[which],
            self.through[which],
            self.bare[which],
        )


def expose(
    world: VisibleWorld,
    sources: Sources,
    camera: PhotoFrame,
    samples: int,
    worn: WornTextures | None = None,
    tell: Callable[[float], None] = lambda _share: None,
) -> Exposure:
    """Follow ``samples`` paths a pixel; the same camera gives the same film. Surfaces are plain
    unless it is said what they have ``worn``. ``tell`` hears the share done, from several threads;
    what it raises ends the work."""
    lit = _lit_world(world, sources, worn)
    count = camera.width * camera.height
    film = Exposure(*(np.zeros((count, 3), np.float32) for _ in range(3)))
    parts, done = samples * -(-count // PORTION), list[int]()

    def work(start: int) -> None:
        here = slice(start, min(start + PORTION, count))
        part = Exposure(*(plane[here] for plane in film))
        pixels = np.arange(here.start, here.stop, dtype=np.int32)
        for sample in range(samples):
            tell(len(done) / parts)
            _follow(lit, camera, pixels, sample, part)
            done.append(sample)

    with ThreadPoolExecutor(2) as pool:
        list(pool.map(work, range(0, count, PORTION)))
    shape = (camera.height, camera.width, 3)
    share = np.float32(1 / samples)
    return Exposure(*((plane * share).reshape(shape) for plane in film))


def _lit_world(world: VisibleWorld, sources: Sources, worn: WornTextures | None) -> LitWorld:
    """A world and its light; finishes that have a texture lose the pattern drawn in its stead."""
    worn = wear_textures((), len(world.stage.finishes)) if worn is None else worn
    table = sources.table.copy()
    table[np.unique(world.stage.finishes[worn.worn >= 0]), 6] = PLAIN
    return LitWorld(world, sources._replace(table=table), worn)


def _follow(lit: LitWorld, camera: PhotoFrame, pixels: Ints, sample: int, film: Exposure) -> None:
    """One path for each of some pixels, added to their part of the film."""
    count = len(pixels)
    starts, ways = (np.empty((count, 3), np.float32) for _ in range(2))
    kernels.aim_rays(
        camera.eye, camera.axes, camera.frame, camera.width, pixels, sample, starts, ways
    )
    rows = np.arange(count, dtype=np.int32)
    through = np.ones((count, 3), np.float32)
    pass_panes(lit.world, int(pixels[0]), sample, starts, ways, through)
    paths = Paths(pixels, rows, starts, ways, through, np.ones(count, np.bool_))
    step = float(camera.frame[2])
    for bounce in range(BOUNCES + 1):
        paths = _bounce(lit, paths, sample, bounce, step, film)
        if not len(paths.rows):
            break


def _bounce(
    lit: LitWorld, paths: Paths, sample: int, bounce: int, step: float, film: Exposure
) -> Paths:
    """Land all paths, add what falls on them there, and send them on; ``step`` is the width of a
    pixel at distance 1."""
    world, sources, worn = lit
    stage, count = world.stage, len(paths.rows)
    met = rays.first(world.casters.solid, paths.starts, paths.ways)
    points, facing, body = (np.zeros((count, 3), np.float32) for _ in range(3))
    dull = np.zeros(count, np.float32)
    surfaces = (stage.corners, stage.normals, stage.smooth, stage.finishes, sources.table)
    kernels.land_rays(
        met,
        paths.ways,
        paths.starts,
        *surfaces,
        sources.sky,
        paths.bare,
        1.0 if bounce else PANE,
        paths.rows,
        paths.through,
        film.light,
        points,
        facing,
        body,
        dull,
    )
    paint_hits(
        met, paths.bare, paths.starts, points, facing, paths.ways, stage.corners, *worn, step, body
    )
    if bounce == 0:
        film.body[:] += body
        film.facing[:] += facing
    landed = np.flatnonzero(met >= 0)
    paths, met = paths.keep(landed), met[landed]
    points, facing, body, dull = points[landed], facing[landed], body[landed], dull[landed]
    _light_up(world, sources, paths, (points, facing, body, dull), sample, bounce, film)
    if bounce < BOUNCES:
        kernels.send_on(
            sample,
            bounce,
            paths.pixels,
            met,
            stage.finishes,
            sources.table,
            points,
            facing,
            body,
            paths.starts,
            paths.ways,
            paths.through,
            paths.bare,
        )
    return paths


def _light_up(
    world: VisibleWorld,
    sources: Sources,
    paths: Paths,
    landed: tuple[Singles, Singles, Singles, Singles],
    sample: int,
    bounce: int,
    film: Exposure,
) -> None:
    """What sun, lamps and windows give where paths landed."""
    count = len(paths.rows)
    points, facing, body, dull = landed
    starts, to_sun, from_sun, ways, brought = (np.zeros((count, 3), np.float32) for _ in range(5))
    reach, far = np.zeros(count, np.float32), np.full(count, kernels.FAR, np.float32)
    turn = (sample, bounce, paths.pixels)
    kernels.ask_sun(*turn, points, facing, dull, sources.sun, starts, to_sun, from_sun)
    kernels.ask_sources(
        *turn,
        facing,
        dull,
        sources.sky,
        sources.sources,
        sources.links,
        sources.rooms,
        sources.ground,
        starts,
        ways,
        reach,
        brought,
    )
    most = SPARK * float(sources.sky[1:].max()) if bounce else np.inf
    for way, ends, light in ((to_sun, far, from_sun), (ways, reach, brought)):
        asked = np.flatnonzero(light.max(1) > 0)
        hidden = rays.is_occluded(world.casters.solid, starts[asked], way[asked], ends[asked])
        kernels.gather_light(
            paths.rows, asked, hidden, paths.through, body, light, most, film.light
        )
