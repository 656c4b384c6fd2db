"""Facades of houses over 200 random footprints, in every style: what a passer-by would notice.

A door over or under a window, a street front without a window, a roof's edge that runs on across
a wall (looked at square on). Meshes are measured, not what made them.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from scenewright.catalog.assets import shipped
from scenewright.catalog.assets.buildings.building_styles import STYLES
from scenewright.catalog.assets.buildings.house_fronts import openings
from scenewright.catalog.assets.buildings.house_looks import FORMS, LOOKS
from scenewright.catalog.assets.buildings.house_walls import front_of
from scenewright.catalog.assets.buildings.rural_houses import body_of, build_house, walls_of
from scenewright.core.catalog import Part
from scenewright.core.footprint import Footprint, read_footprint
from scenewright.core.scene import Size
from scenewright.geometry import rays
from scenewright.geometry.mesh import Mesh

COUNT = 200
BLANK = 40.0
"""Metres of width at which models are looked at."""
OPEN = ("dark window", "dark timber", "curtain wall", "slate")
"""Materials of doors and windows."""
BARE, EYES, SHARP = 8.0, 6.0, 0.2
"""Metres of a front without an opening that are blank, of the height looked at, and between
rays."""
STEPPED = "hui"
"""The style whose gables rise in steps: their copings stand over the next step by a hand's width,
so that an eave is what is seen at two places side by side."""
CORNER, STEP = 1.2, 0.4
"""Metres from corners that are not looked at, and between the places that are."""


class Faults(NamedTuple):
    """How many footprints of a style have each fault."""

    door_over_window: int
    blank_front: int
    orphan_eave: int


def footprints(seed: int, count: int = COUNT) -> Iterator[tuple[Footprint, Size]]:
    """Rectangles, terraces of 4 to 6 m, L, U and T shapes, and convex polygons, with sizes."""
    rng = np.random.default_rng(seed)
    for number in range(count):
        w, d = rng.uniform(3.2, 22.0), rng.uniform(3.2, 16.0)
        a, b = rng.uniform(0.25, 0.6) * w, rng.uniform(0.25, 0.6) * d
        w = rng.uniform(4.0, 6.0) if number % 6 == 1 else w
        a = min(a, 0.6 * w)
        ring = np.array(_shape(number % 6, w / 2, d / 2, a, b, rng), float)
        low, high = ring.min(0), ring.max(0)
        ring, (w, d) = ring - (low + high) / 2, (high - low).tolist()
        height = float(rng.integers(1, 4) * 2.7 + 0.4 + 0.3 * min(w, d))
        yield read_footprint([(float(x), float(y)) for x, y in ring], w, d), Size(w, d, height)


def _shape(kind: int, w: float, d: float, a: float, b: float, rng: np.random.Generator) -> Any:
    if kind == 2:
        return [(-w, -d), (w, -d), (w, d - b), (w - a, d - b), (w - a, d), (-w, d)]
    if kind == 3:
        c = a / 2
        notch = [(c, d), (c, d - b), (-c, d - b), (-c, d)]
        return [(-w, -d), (w, -d), (w, d), *notch, (-w, d)]
    if kind == 4:
        return [(-w, -d), (w - a, -d), (w - a, b - d), (w, b - d), (w, d), (-w, d)]
    if kind == 5:
        turns = (np.arange(6) + rng.uniform(-0.3, 0.3, 6)) * np.pi / 3
        return np.stack([w * np.cos(turns), d * np.sin(turns)], 1)
    return [(-w, -d), (w, -d), (w, d), (-w, d)]


def outline_of(footprint: Footprint, size: Size) -> Footprint:
    """A footprint, or the corners of its box."""
    w, d = size.width / 2, size.depth / 2
    return footprint or ((-w, -d), (w, -d), (w, d), (-w, d))


def count_faults(style: str, form: str = "house", seed: int = 3, count: int = COUNT) -> Faults:
    """The faults of the houses of a style and form over random footprints."""
    over, blank, orphan = 0, 0, 0
    for number, (footprint, size) in enumerate(footprints(seed, count)):
        clash, bare = front_faults(footprint, size, style, form)
        over, blank = over + clash, blank + bare
        roof = ("gabled", "hipped")[number % 2]
        roof = roof if roof in FORMS[form].roofs else FORMS[form].roofs[0]
        drawn = build_house(size, footprint, style, roof, form)
        orphan += has_orphan_eave(drawn, outline_of(footprint, size), style)
    return Faults(over, blank, orphan)


def front_faults(footprint: Footprint, size: Size, style: str, form: str) -> tuple[bool, bool]:
    """Whether the entrance of a house covers a window, a shutter or another door, and whether its
    front has no window."""
    body = body_of(size, footprint, style, form)
    outline = walls_of(body)
    found = openings(outline, size.height - 2.0, body.look, body.form)
    doors = [row for row in (_span(mesh, outline) for mesh in found.doors) if row is not None]
    panes = [row for row in (_span(mesh, outline) for mesh in found.panes) if row is not None]
    leaves = [row for row in (_span(mesh, outline) for mesh in found.shutters) if row is not None]
    clash = False
    for k, door in enumerate(doors):
        others = [*leaves, *doors[:k], *(row for row in panes if not _holds(door, row))]
        clash |= any(_shares(door, row) for row in others)
    return clash or not doors, not panes


def _span(mesh: Mesh, outline: Footprint) -> tuple[float, float, float, float] | None:
    """Where a mesh is on the front, along it and upwards; None if it is on another side."""
    ring = np.array(outline)
    k = front_of(outline)
    start, way = ring[k], ring[(k + 1) % len(ring)] - ring[k]
    way = way / np.hypot(*way)
    points = mesh.vertices[:, :2] - start
    if np.abs(points @ np.array([way[1], -way[0]])).max() > 0.4:
        return None
    along = points @ way
    if np.ptp(along) < 0.15:
        return None
    high = mesh.vertices[:, 2]
    return float(along.min()), float(along.max()), float(high.min()), float(high.max())


def _holds(one: tuple[float, ...], other: tuple[float, ...]) -> bool:
    """Whether a door holds a light of its own."""
    return one[0] < other[0] and other[1] < one[1] and one[2] < other[2] and other[3] < one[3]


def _shares(one: tuple[float, ...], other: tuple[float, ...]) -> bool:
    across = min(one[1], other[1]) - max(one[0], other[0])
    return across > 1e-6 and min(one[3], other[3]) - max(one[2], other[2]) > 1e-6


def has_orphan_eave(parts: tuple[Part, ...], outline: Footprint, style: str) -> bool:
    """Whether somewhere before a facade roof is seen with its wall above it, looked at square
    on; not within :data:`CORNER` of corners, where one sees past them."""
    look = LOOKS[style]
    is_roof = np.concatenate([np.full(len(p.faces), p.material == look.roof) for p in parts])
    shift = np.cumsum([0, *(len(p.vertices) for p in parts)])[:-1]
    faces = np.concatenate([p.faces + s for p, s in zip(parts, shift, strict=True)])
    scene = rays.build(np.concatenate([p.vertices for p in parts]), faces)
    ring = np.array(outline)
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        long = float(np.hypot(*(b - a)))
        way = (b - a) / long
        out = np.array([way[1], -way[0]])
        at, up = np.arange(CORNER, long - CORNER, STEP), np.arange(0.6, 14.0, 0.2)
        spots = a + at[:, None] * way + 2.0 * out
        eyes = np.array([(*spot, z) for spot in spots for z in up])
        if not len(eyes):
            continue
        distance, face, _ = rays.hits(scene, eyes, np.tile((*-out, 0.0), (len(eyes), 1)))
        tile = (face >= 0) & is_roof[np.maximum(face, 0)]
        roof = tile & (distance < 2.0 + look.overhang - 0.05)
        wall = (face >= 0) & ~is_roof[np.maximum(face, 0)] & (distance < 2.1 + look.overhang)
        roof, wall = roof.reshape(len(at), -1), wall.reshape(len(at), -1)
        above = np.flip(np.cumsum(np.flip(wall, 1), 1), 1)
        places = (roof[:, :-1] & (above[:, 1:] >= 2)).any(1)
        if (places[1:] & places[:-1]).any() if style == STEPPED else places.any():
            return True
    return False


def widest_blank(parts: tuple[Part, ...]) -> float:
    """Metres of the longest stretch of a front, seen square on up to :data:`EYES`, without a door
    or a window."""
    points = np.concatenate([p.vertices for p in parts])
    shift = np.cumsum([0, *(len(p.vertices) for p in parts)])[:-1]
    faces = np.concatenate([p.faces + s for p, s in zip(parts, shift, strict=True)])
    is_open = np.concatenate([np.full(len(p.faces), p.material.name in OPEN) for p in parts])
    (west, front), east = points.max(0)[:2] * (-1, 1), points[:, 0].max()
    x, z = np.arange(west, east, SHARP), np.arange(SHARP, min(EYES, points[:, 2].max()), SHARP)
    eyes = np.array([(a, front + 2.0, b) for a in x for b in z])
    scene = rays.build(points, faces)
    _, face, _ = rays.hits(scene, eyes, np.tile((0.0, -1.0, 0.0), (len(eyes), 1)))
    seen = (face >= 0) & is_open[np.maximum(face, 0)]
    shown = np.flatnonzero(seen.reshape(len(x), -1).any(1))
    marks = np.concatenate([[-1], shown, [len(x)]])
    return float((np.diff(marks) - 1).max() * SHARP)


def count_blank_models() -> tuple[int, int]:
    """Of the shipped models of housing, public buildings and shops, :data:`BLANK` metres wide, how
    many have a front with a stretch of :data:`BARE` metres and more without an opening; and of
    how many."""
    assets = shipped().assets
    rows = [name for name, row in STYLES.items() if row.use in ("housing", "civic", "commercial")]
    wide = [(assets[name], assets[name].usual) for name in rows]
    found = [
        widest_blank(a.mesh(u._replace(width=BLANK, depth=min(u.depth, BLANK)))) for a, u in wide
    ]
    return sum(one >= BARE for one in found), len(found)
