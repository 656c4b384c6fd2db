"""A model's portrait: from its best view, plain and coloured by mesh saliency.

Both are ray-cast in the light of :mod:`.picture`, the sun over the viewer's left shoulder. For
the colours a white model gives the light, and four rays a pixel where on the surface it looks;
saliency is looked up there, so its colours are as fine as the picture, whatever the triangles.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Material, Part
from scenewright.core.errors import InputError
from scenewright.geometry import rays
from scenewright.geometry.best_view import best_view
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.prisms import normals_of
from scenewright.geometry.saliency import Saliency, saliency, values_at, visual_quality
from scenewright.render import light
from scenewright.render.colour import linear_of
from scenewright.render.items import SLAB
from scenewright.render.picture import FINER, PAGE, Camera, Pixels, render, view_of
from scenewright.render.stage import PartTriangles, stage_of

Floats = NDArray[np.float64]

SPAN = 4.0
"""Metres to which models are brought: light and shadow are made for rooms."""
ANGLE = np.deg2rad(18.0)
MARGIN = 1.12
HOTTEST = 1.5
"""Saliency of the last colour of :data:`RAMP`."""
RAMP = np.array(
    [[0.900, 0.895, 0.880], [0.965, 0.830, 0.470], [0.930, 0.480, 0.200], [0.640, 0.070, 0.170]]
)
"""Colours from no saliency to :data:`HOTTEST`, sRGB."""
CLAY = Material("clay", PAGE.color, 1.0)


class Portrait(NamedTuple):
    """Two square pictures, the visual quality S(O), the way to the eye ``(3,)``, its score by
    the measure asked for, and how many triangles the model has."""

    name: str
    plain: Pixels
    salient: Pixels
    quality: float
    way: Floats
    score: float
    faces: int


def portrait(name: str, parts: Sequence[Part], side: int, measure: str = "picture") -> Portrait:
    """The portrait of a model, ``side`` pixels wide; InputError if it has no surface."""
    mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
    try:
        found = saliency(mesh)
        best = best_view(mesh, found, measure)
    except ValueError as error:
        raise InputError(str(error), "give a model with a surface", place=name) from None
    low, high = mesh.vertices.min(0), mesh.vertices.max(0)
    middle = np.array([*(low + high)[:2] / 2, low[2]])
    grown = SPAN / float(np.linalg.norm(high - low))
    shown = [_part(part, middle, grown) for part in _make_solid(parts)]
    bounds = np.concatenate([part.vertices for part in shown])
    camera = facing(bounds, best.way)
    plain = render(stage_of(_blocks(shown), bounds), camera, side, side, sun_of(best.way))
    white = [Part(CLAY, part.vertices, part.faces) for part in shown]
    clay = render(stage_of(_blocks(white), bounds), camera, side, side, sun_of(best.way))
    share = _tones(mesh, found, camera, side, middle, grown)
    salient = np.round(255 * _srgb(linear_of(clay / 255.0) * share)).astype(np.uint8)
    return Portrait(
        name, plain, salient, visual_quality(found), best.way, best.score, len(mesh.faces)
    )


def facing(points: Floats, way: Floats) -> Camera:
    """A camera in the direction ``way`` that sees all points, as large as a margin allows.

    ``points`` (n, 3) in metres, ``way`` (3,).
    """
    target = (points.min(0) + points.max(0)) / 2
    away = 2 * SPAN / ANGLE
    for _ in range(12):
        camera = Camera(tuple(target + away * way), tuple(target), float(ANGLE))
        view = view_of(camera, 1, 1)
        local = (points - target) @ view.axes.T.astype(float)
        deep = local[:, 2] + away
        seen = local[:, :2] / deep[:, None]
        low, high = seen.min(0), seen.max(0)
        target = target + (low + high) / 2 * away @ view.axes[:2].astype(float)
        away *= float((high - low).max()) / 2 * MARGIN / view.across
    return Camera(tuple(target + away * way), tuple(target), float(ANGLE))


def sun_of(way: Floats) -> tuple[float, float, float]:
    """The direction to the sun: behind the viewer, to the left, high up.

    >>> [round(v, 2) for v in sun_of(np.array([0.0, -1.0, 0.0]))]
    [-0.75, -0.6, 1.4]
    """
    flat = way[:2] / max(float(np.hypot(*way[:2])), 1e-9)
    left = np.array([flat[1], -flat[0]])
    x, y = 0.6 * flat + 0.75 * left
    return float(x), float(y), 1.4


def heat(values: Floats) -> Floats:
    """Linear colours ``(n, 3)`` of saliency ``(n,)``."""
    share = np.clip(values / HOTTEST, 0.0, 1.0) * (len(RAMP) - 1)
    stops = np.arange(len(RAMP))
    return linear_of(np.stack([np.interp(share, stops, RAMP[:, k]) for k in range(3)], 1))


def _tones(
    mesh: Mesh, found: Saliency, camera: Camera, side: int, middle: Floats, grown: float
) -> Floats:
    """Colours ``(side, side, 3)`` to lay over the white model: 1 where it does not cover."""
    view = view_of(camera, side, side)
    pixels = np.repeat(np.arange(side * side, dtype=np.int32), len(FINER))
    ways = np.empty((len(pixels), 3), np.float32)
    light.camera_rays(view.axes, side, side, view.across, pixels, FINER, ways)
    caster = rays.build(_grow_outline(mesh.vertices, middle, grown), mesh.faces)
    distance, met, _ = rays.hits(caster, np.broadcast_to(view.eye, ways.shape), ways)
    seen = np.flatnonzero(met >= 0)
    places = view.eye + distance[seen, None].astype(np.float64) * ways[seen]
    places[:, 2] += SLAB
    tones = np.ones((len(pixels), 3))
    tones[seen] = heat(values_at(found, places / grown + middle)) / linear_of(np.array(PAGE.color))
    return tones.reshape(side, side, len(FINER), 3).mean(2)


def _grow_outline(points: Floats, middle: Floats, grown: float) -> Floats:
    return (points - middle) * grown - np.array([0.0, 0.0, SLAB])


def _make_solid(parts: Sequence[Part]) -> Sequence[Part]:
    """The parts; of what is all glass, which would be a flat shade, the parts as solids."""
    if any(part.material.opacity >= 0.8 for part in parts):
        return parts
    return [replace(part, material=replace(part.material, opacity=1.0)) for part in parts]


def _part(part: Part, middle: Floats, grown: float) -> Part:
    return Part(part.material, _grow_outline(part.vertices, middle, grown), part.faces)


def _blocks(parts: Sequence[Part]) -> list[PartTriangles]:
    normals = normals_of([(part.vertices, part.faces) for part in parts])
    return [
        PartTriangles(part.material, part.vertices, part.faces, own)
        for part, own in zip(parts, normals, strict=True)
    ]


def _srgb(linear: Floats) -> Floats:
    light_ = np.clip(linear, 0.0, 1.0)
    return np.where(light_ <= 0.0031308, 12.92 * light_, 1.055 * light_ ** (1 / 2.4) - 0.055)
