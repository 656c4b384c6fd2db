"""Pictures by ray casting: coloured triangles and a camera in, pixels out; no screen needed.

One ray a pixel finds the surface; one more each goes to the sun and to the sky, and neighbours
share what they found (:mod:`scenewright.render.light`). Pixels at edges are drawn again with
four rays. Glass is laid over at the end. The same scene gives the same picture.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Material
from scenewright.geometry import rays
from scenewright.render import finish, light

Singles = NDArray[np.float32]
Ints = NDArray[np.int32]
Pixels = NDArray[np.uint8]

REACH = 2.2
"""How far away, in metres, things in a room still darken a surface."""
SUN_SPREAD = 0.045
FINER = np.array([[-0.375, -0.125], [0.125, -0.375], [0.375, 0.125], [-0.125, 0.375]], np.float32)
"""Where in a pixel the four finer rays go (a rotated grid)."""
CENTRE = np.zeros((1, 2), np.float32)
SETS = light.samples()
PORTION = 1 << 15
PAGE = Material("page", (0.955, 0.950, 0.942))
NEAREST = 0.01
"""How far before the eye, in metres, glass must lie to be found by its bounds on the screen."""
MORE = 3
"""Further rays to the sun for pixels in half shadow."""


class Camera(NamedTuple):
    """Eye, the point looked at (both in metres, z up) and the width of the view in radians."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    angle: float


class Air(NamedTuple):
    """Linear colours of the sky at the horizon and overhead, and the visibility, in metres:
    at that distance a third of a thing's own colour is left (H. Koschmieder 1924)."""

    horizon: tuple[float, float, float]
    zenith: tuple[float, float, float]
    sight: float


class RenderStage(NamedTuple):
    """What is drawn: triangles ``corners`` (m, 3, 3) with ``normals`` at their corners, the
    ``finishes`` (m,) they have (rows of ``table``: linear colour, roughness, metallic, emission,
    pattern), ``keys`` (m,) equal where light may be shared, ``smooth`` (m,) for round parts;
    ``glass`` (g, 3, 3) and ``tints`` (g, 4), linear colour and opacity; ``near`` (2, 3), the
    lower and upper corner of what shadows may fall on; ``reach`` how far away, in metres, things
    still darken a surface; ``air`` what is beyond them (left out: the page)."""

    corners: Singles
    normals: Singles
    finishes: Ints
    keys: Ints
    smooth: NDArray[np.bool_]
    table: Singles
    glass: Singles
    tints: Singles
    near: Singles
    reach: float = REACH
    air: Air | None = None


class StageCasters(NamedTuple):
    """Embree's trees over the triangles and the glass of a stage, built once for all its views."""

    solid: rays.Caster
    panes: rays.Caster


class RayHits(NamedTuple):
    """What rays met: triangle, key (-1 beyond all shadows), point and normal; where nothing is
    met, the direction of the ray instead of a normal."""

    met: Ints
    keys: Ints
    points: Singles
    facing: Singles


class CameraView(NamedTuple):
    """A camera as numbers: eye, axes (right, up, ahead), tangent of half the width, size."""

    eye: Singles
    axes: Singles
    across: float
    width: int
    height: int


def render(
    stage: RenderStage,
    camera: Camera,
    width: int,
    height: int,
    sun: tuple[float, float, float] = (-0.50, -0.22, 1.0),
) -> Pixels:
    """The picture ``(height, width, 3)`` in sRGB; ``sun`` is the direction towards the sun."""
    return draw_view(stage, build_casters(stage), view_of(camera, width, height), sun)


def build_casters(stage: RenderStage) -> StageCasters:
    """What rays are cast against."""
    return StageCasters(build_caster(stage.corners), build_caster(stage.glass))


def build_caster(corners: Singles) -> rays.Caster:
    """A caster for triangles ``(m, 3, 3)``."""
    count = len(corners)
    triples = np.arange(3 * count, dtype=np.int32).reshape(-1, 3)
    return rays.build(corners.reshape(-1, 3), triples)


def draw_view(
    stage: RenderStage, casters: StageCasters, view: CameraView, sun: tuple[float, float, float]
) -> Pixels:
    """One view of a stage as pixels ``(height, width, 3)`` in sRGB."""
    to_sun, solid = _frame(sun), casters.solid
    every = np.arange(view.width * view.height, dtype=np.int32)
    seen = look_through(stage, solid, view, every, CENTRE)
    arriving = _arriving(solid, view, seen, to_sun, stage.reach)
    linear = _shade_surfaces(stage, view, seen, arriving, to_sun[2])
    _refine(stage, solid, view, seen, arriving, to_sun[2], linear)
    _glaze(stage, casters.panes, view, seen, linear)
    return develop_image(linear).reshape(view.height, view.width, 3)


def view_of(camera: Camera, width: int, height: int) -> CameraView:
    """The camera's axes: right, up and ahead, with z upwards in the picture."""
    eye, target = np.array(camera.eye, float), np.array(camera.target, float)
    ahead = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(ahead, [0.0, 0.0, 1.0])
    right = right / np.linalg.norm(right)
    axes = np.stack([right, np.cross(right, ahead), ahead]).astype(np.float32)
    return CameraView(eye.astype(np.float32), axes, float(np.tan(camera.angle / 2)), width, height)


def develop_image(linear: Singles) -> Pixels:
    """sRGB bytes of linear light, highlights rolled off above 0.8 so that white keeps its form."""
    light_ = np.linspace(0.0, 4.0, 4096)
    rolled = np.where(light_ < 0.7, light_, 0.7 + 0.3 * np.tanh((light_ - 0.7) / 0.3 * 0.75))
    coded = np.where(rolled < 0.0031308, 12.92 * rolled, 1.055 * rolled ** (1 / 2.4) - 0.055)
    shades = np.clip(np.round(coded * 255), 0, 255).astype(np.uint8)
    return shades[np.minimum(linear * (4095 / 4.0), 4095.0).astype(np.int16)]


def _frame(sun: tuple[float, float, float]) -> Singles:
    """Two directions across the sun's, and the sun's own."""
    towards = np.array(sun) / np.linalg.norm(sun)
    side = np.cross(towards, [0.0, 1.0, 0.0] if abs(towards[1]) < 0.9 else [1.0, 0.0, 0.0])
    side = side / np.linalg.norm(side)
    return np.stack([side, np.cross(towards, side), towards]).astype(np.float32)


def _by_portions(work: Callable[[slice], None], count: int) -> None:
    """Work through ``count`` pixels by the portion, few enough that the numbers of all rays stay
    in the cache. Two threads: while one casts rays, the other can run a kernel."""
    portions = [slice(start, start + PORTION) for start in range(0, count, PORTION)]
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(work, portions))


def look_through(
    stage: RenderStage, solid: rays.Caster, view: CameraView, pixels: Ints, shift: Singles
) -> RayHits:
    """What rays through ``pixels`` (n,), shifted in turn by ``shift`` (k, 2) of a pixel, meet."""
    met, keys = (np.empty(len(pixels), np.int32) for _ in range(2))
    points, facing = (np.zeros((len(pixels), 3), np.float32) for _ in range(2))

    def look(here: slice) -> None:
        ways = _aim_rays(view, pixels[here], shift)
        met[here] = rays.first(solid, np.broadcast_to(view.eye, ways.shape), ways)
        light.surface_hits(
            view.eye,
            ways,
            met[here],
            stage.corners,
            stage.normals,
            stage.smooth,
            stage.keys,
            stage.near,
            points[here],
            facing[here],
            keys[here],
        )
        if stage.air is not None:
            missed = met[here] < 0
            facing[here][missed] = _unit(ways[missed])

    _by_portions(look, len(pixels))
    return RayHits(met, keys, points, facing)


def _aim_rays(view: CameraView, pixels: Ints, shift: Singles) -> Singles:
    ways = np.empty((len(pixels), 3), np.float32)
    light.camera_rays(view.axes, view.width, view.height, view.across, pixels, shift, ways)
    return ways


def _arriving(
    solid: rays.Caster, view: CameraView, seen: RayHits, sun: Singles, reach: float
) -> Singles:
    """Share of the sun and of the sky ``(n, 2)`` that reaches each pixel's surface.

    Pixels that came out half in the sun take more rays before they are averaged again.
    """
    raw = np.ones((len(seen.keys), 2), np.float32)
    everywhere = np.flatnonzero(seen.keys >= 0).astype(np.int32)

    def once(here: slice) -> None:
        starts, to_sun, to_sky = _sample_light(view, seen, everywhere[here], sun, 0)
        raw[everywhere[here], 0] = ~rays.is_occluded(solid, starts, to_sun)
        raw[everywhere[here], 1] = ~rays.is_occluded(solid, starts, to_sky, reach)

    def again(here: slice) -> None:
        for turn in range(1, 1 + MORE):
            starts, to_sun, _ = _sample_light(view, seen, half[here], sun, turn)
            raw[half[here], 0] += ~rays.is_occluded(solid, starts, to_sun)

    _by_portions(once, len(everywhere))
    mean = _average_samples(seen, view, raw)
    half = np.flatnonzero(np.abs(mean[:, 0] - 0.5) < 0.48).astype(np.int32)
    _by_portions(again, len(half))
    raw[half, 0] /= 1 + MORE
    return _average_samples(seen, view, raw)


def _sample_light(
    view: CameraView, seen: RayHits, pixels: Ints, sun: Singles, turn: int
) -> tuple[Singles, Singles, Singles]:
    """Where rays to the light start, and their directions to the sun and to the sky."""
    starts, to_sun, to_sky = (np.empty((len(pixels), 3), np.float32) for _ in range(3))
    light.light_samples(
        pixels,
        view.width,
        seen.points,
        seen.facing,
        sun,
        SUN_SPREAD,
        SETS,
        turn,
        starts,
        to_sun,
        to_sky,
    )
    return starts, to_sun, to_sky


def _average_samples(seen: RayHits, view: CameraView, raw: Singles) -> Singles:
    rows, both = raw.copy(), raw.copy()
    light.average(seen.keys, view.width, 1, raw, rows)
    light.average(seen.keys, view.width, view.width, rows, both)
    return both


def _shade_surfaces(
    stage: RenderStage, view: CameraView, seen: RayHits, arriving: Singles, to_sun: Singles
) -> Singles:
    linear = np.empty((len(seen.met), 3), np.float32)
    grain = 2 * view.across / view.width

    def shade(here: slice) -> None:
        met = seen.met[here]
        finishes = np.where(met >= 0, stage.finishes[met], len(stage.table) - 1).astype(np.int32)
        finish.shade(
            view.eye,
            seen.points[here],
            seen.facing[here],
            finishes,
            stage.table,
            arriving[here],
            to_sun,
            grain,
            linear[here],
        )
        if stage.air is not None:
            _apply_haze(stage.air, view, seen, here, linear)

    _by_portions(shade, len(linear))
    return linear


def _apply_haze(air: Air, view: CameraView, seen: RayHits, here: slice, linear: Singles) -> None:
    """Sky where nothing is met, and a veil of the horizon's colour before what is far away."""
    sky = seen.met[here] < 0
    up = np.maximum(seen.facing[here][sky, 2:], 0.0)
    horizon, zenith = (np.array(colour, np.float32) for colour in air[:2])
    linear[here][sky] = zenith + (horizon - zenith) * (1.0 - up) ** 3
    away = np.linalg.norm(seen.points[here] - view.eye, axis=1)[:, None]
    left = np.where(sky[:, None], 1.0, np.exp(-away / air.sight)).astype(np.float32)
    linear[here] = linear[here] * left + horizon * (1.0 - left)


def _unit(ways: Singles) -> Singles:
    lengths = np.linalg.norm(ways, axis=1, keepdims=True)
    return np.asarray(ways / lengths, np.float32)


def _refine(
    stage: RenderStage,
    solid: rays.Caster,
    view: CameraView,
    seen: RayHits,
    arriving: Singles,
    to_sun: Singles,
    linear: Singles,
) -> None:
    """Draw the pixels at edges again, as the mean of four finer rays."""
    marked = np.zeros(len(seen.keys), np.bool_)
    light.edges(seen.keys, view.width, marked)
    pixels = np.repeat(np.flatnonzero(marked).astype(np.int32), len(FINER))
    finer = look_through(stage, solid, view, pixels, FINER)
    lent = np.empty((len(pixels), 2), np.float32)
    light.borrow(pixels, seen.keys, view.width, arriving, finer.keys, lent)
    shades = _shade_surfaces(stage, view, finer, lent, to_sun)
    linear[pixels[:: len(FINER)]] = np.minimum(shades, 1.2).reshape(-1, len(FINER), 3).mean(1)


def _glaze(
    stage: RenderStage, panes: rays.Caster, view: CameraView, seen: RayHits, linear: Singles
) -> None:
    """Lay the colour of glass over what is seen through it."""
    if not len(stage.glass):
        return
    pixels = _find_covered_pixels(stage.glass, view)
    ways = _aim_rays(view, pixels, CENTRE)
    distance, face, _ = rays.hits(panes, np.broadcast_to(view.eye, ways.shape), ways)
    behind = (seen.points[pixels] - view.eye) @ view.axes[2]
    over = (face >= 0) & ((distance < behind) | (seen.met[pixels] < 0))
    tint = stage.tints[face[over]]
    share = tint[:, 3:]
    linear[pixels[over]] = linear[pixels[over]] * (1 - share) + tint[:, :3] * share


def _find_covered_pixels(triangles: Singles, view: CameraView) -> Ints:
    """Pixels within the bounds of any of the triangles on the screen; all of them where one lies
    partly behind the eye."""
    away = (triangles - view.eye) @ view.axes.T
    away = away[away[..., 2].max(1) > 0.0]
    if (away[..., 2] < NEAREST).any():
        return np.arange(view.width * view.height, dtype=np.int32)
    step = 2.0 * view.across / view.width
    x = away[..., 0] / away[..., 2] / step + view.width / 2
    y = view.height / 2 - away[..., 1] / away[..., 2] / step
    mask = np.zeros((view.height, view.width), np.bool_)
    for left, right, top, bottom in (
        np.stack([x.min(1), x.max(1) + 2, y.min(1), y.max(1) + 2], 1).clip(0).astype(int).tolist()
    ):
        mask[top:bottom, left:right] = True
    return np.flatnonzero(mask).astype(np.int32)
