"""Facades of village houses over random footprints: doors, windows and eaves know each other."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
import shapely

from scenewright.catalog.assets.buildings.house_shapes import inset
from scenewright.catalog.assets.buildings.house_walls import front_of, openings
from scenewright.catalog.assets.buildings.rural_houses import LOOKS, SHED, build_house
from scenewright.catalog.assets.materials import TILES
from scenewright.core.footprint import Footprint, read_footprint
from scenewright.core.scene import Size
from scenewright.geometry import rays

COUNT = 200


def footprints(seed: int) -> Iterator[tuple[Footprint, Size]]:
    """Rectangles, terraces of 4 to 6 m, L, U and T shapes, and convex polygons, with sizes."""
    rng = np.random.default_rng(seed)
    for number in range(COUNT):
        w, d = rng.uniform(3.2, 22.0), rng.uniform(3.2, 16.0)
        a, b = rng.uniform(0.25, 0.6) * w, rng.uniform(0.25, 0.6) * d
        w = rng.uniform(4.0, 6.0) if number % 6 == 1 else w
        a = min(a, 0.6 * w)
        ring = np.array(shapes_of(number % 6, w / 2, d / 2, a, b, rng), float)
        low, high = ring.min(0), ring.max(0)
        ring, (w, d) = ring - (low + high) / 2, (high - low).tolist()
        height = float(rng.integers(1, 4) * 2.7 + 0.4 + 0.3 * min(w, d))
        yield read_footprint([(float(x), float(y)) for x, y in ring], w, d), Size(w, d, height)


def shapes_of(kind: int, w: float, d: float, a: float, b: float, rng: np.random.Generator):
    box = [(-w, -d), (w, -d), (w, d), (-w, d)]
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
    return box


def outline_of(footprint: Footprint, size: Size) -> Footprint:
    w, d = size.width / 2, size.depth / 2
    return footprint or ((-w, -d), (w, -d), (w, d), (-w, d))


@pytest.mark.parametrize("look", list(LOOKS))
def test_no_door_stands_over_a_window_and_every_front_has_one(look: str) -> None:
    faults = []
    for number, (footprint, size) in enumerate(footprints(3)):
        outline = inset(outline_of(footprint, size), LOOKS[look].overhang)
        shed = shapely.Polygon(outline).area < SHED
        gate = min(2.4, 0.6 * size.width) if shed else 0.0
        found = openings(outline, size.height - 2.0, LOOKS[look].windows, gate)
        (door,) = (spans(mesh, outline) for mesh in found.doors)
        panes = [spans(mesh, outline) for mesh in found.panes]
        panes = [row for row in panes if row is not None]
        beside = [row for row in panes if not shares(door, row, -0.3)]
        shutters = [spans(mesh, outline) for mesh in found.shutters]
        over = [row for row in (*beside, *filter(None, shutters)) if shares(door, row, 0.0)]
        faults += [f"{number}: door over a window"] * bool(over)
        faults += [f"{number}: front without a window"] * (not panes)
    assert not faults, faults[:8]


def spans(mesh, outline: Footprint):
    """Where a mesh is on the front, along it and upwards; None if it is on another side."""
    ring = np.array(outline)
    k = front_of(outline)
    start, way = ring[k], ring[(k + 1) % len(ring)] - ring[k]
    way = way / np.hypot(*way)
    out = np.array([way[1], -way[0]])
    points = mesh.vertices[:, :2] - start
    if np.abs(points @ out).max() > 0.4:
        return None
    along = points @ way
    if along.max() - along.min() < 0.15:
        return None
    return along.min(), along.max(), mesh.vertices[:, 2].min(), mesh.vertices[:, 2].max()


def shares(one, other, slack: float) -> bool:
    across = min(one[1], other[1]) - max(one[0], other[0])
    up = min(one[3], other[3]) - max(one[2], other[2])
    inside = slack < 0 and one[0] < other[0] and other[1] < one[1] and other[3] < one[3]
    return inside if slack < 0 else across > slack + 1e-6 and up > slack + 1e-6


@pytest.mark.parametrize("roof", ["gabled", "hipped"])
def test_no_eave_runs_across_a_wall(roof: str) -> None:
    faults = []
    for number, (footprint, size) in enumerate(footprints(5)):
        built = build_house(size, footprint, "rural", roof)
        if eaves_across_walls(built, outline_of(footprint, size)):
            faults.append(number)
    assert not faults, faults[:8]


def eaves_across_walls(parts, outline: Footprint) -> bool:
    """Whether somewhere before a facade roof is seen with its wall above it, looked at square
    on; not within 1.2 m of corners."""
    is_roof = np.concatenate([np.full(len(p.faces), p.material == TILES) for p in parts])
    shift = np.cumsum([0, *(len(p.vertices) for p in parts)])[:-1]
    faces = np.concatenate([p.faces + s for p, s in zip(parts, shift, strict=True)])
    scene = rays.build(np.concatenate([p.vertices for p in parts]), faces)
    ring, by = np.array(outline), LOOKS["rural"].overhang
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        long = float(np.hypot(*(b - a)))
        way = (b - a) / long
        out = np.array([way[1], -way[0]])
        at = np.arange(1.2, long - 1.2, 0.4)
        up = np.arange(0.6, 14.0, 0.2)
        spots = a + at[:, None] * way + 2.0 * out
        eyes = np.array([(*spot, z) for spot in spots for z in up])
        if not len(eyes):
            continue
        distance, face, _ = rays.hits(scene, eyes, np.tile((*-out, 0.0), (len(eyes), 1)))
        roof = (face >= 0) & is_roof[np.maximum(face, 0)] & (distance < 2.0 + by - 0.05)
        wall = (face >= 0) & ~is_roof[np.maximum(face, 0)] & (distance < 2.0 + by + 0.1)
        roof, wall = roof.reshape(len(at), -1), wall.reshape(len(at), -1)
        above = np.flip(np.cumsum(np.flip(wall, 1), 1), 1)
        if (roof[:, :-1] & (above[:, 1:] >= 2)).any():
            return True
    return False
