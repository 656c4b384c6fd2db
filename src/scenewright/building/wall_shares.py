"""The solid between rooms shared out among their wall faces: to each what lies behind it.

Every step looks only at walls that are near, so that a thousand walls take a thousand steps.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
import shapely
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from scenewright.core.space import Points, Space

CRUMB = 1e-4
"""Pieces of wall smaller than this, in square metres, join their neighbour or are dropped."""
MITRE = 4.0
CURVE = np.cos(np.deg2rad(25.0))
PLAIN = 2000
"""Corners of a solid up to which it is cut as a whole."""


def polygons(shape: BaseGeometry) -> list[Polygon]:
    """The polygons in a shape that are more than a crumb, largest first.

    >>> [round(p.area, 1) for p in polygons(shapely.MultiPolygon(
    ...     [shapely.box(0, 0, 1, 1), shapely.box(2, 0, 4, 1)]))]
    [2.0, 1.0]
    """
    parts = (part for part in shapely.get_parts(shape) if isinstance(part, Polygon))
    return sorted((p for p in parts if p.area > CRUMB), key=lambda p: -p.area)


def stretches_of(spaces: Sequence[Space]) -> Iterator[tuple[str, LineString]]:
    """Every wall face of the rooms, named, the longest first; columns before all."""
    faces = []
    for space in spaces:
        for number, hole in enumerate(space.holes):
            closed = LineString(np.vstack([hole, hole[:1]]))
            faces.append((1, f"{space.id}/column-{number}", closed))
        for start, run in _runs(space.outline):
            faces.append((0, f"{space.id}/wall-{start}", LineString(run)))
    faces.sort(key=lambda face: (-face[0], -round(face[2].length, 6)))
    return ((name, line) for _, name, line in faces)


def _runs(ring: Points) -> Iterator[tuple[int, Points]]:
    """A ring cut at its corners of more than 25 degrees: first edge and polyline of each run."""
    along = np.roll(ring, -1, axis=0) - ring
    along = along / np.linalg.norm(along, axis=1)[:, None]
    cuts = np.flatnonzero((along * np.roll(along, 1, axis=0)).sum(1) < CURVE)
    cuts = cuts if len(cuts) > 1 else np.array([0, len(ring) // 2])
    turned = np.roll(ring, -cuts[0], axis=0)
    closed = np.vstack([turned, turned[:1]])
    for low, high in pairwise([*(cuts - cuts[0]).tolist(), len(ring)]):
        yield int((low + cuts[0]) % len(ring)), closed[low : high + 1]


def shared_out(
    solid: BaseGeometry, stretches: list[tuple[str, LineString]], reach: float
) -> list[tuple[str, Polygon]]:
    """The solid cut into one piece (or more, numbered) for every stretch that has some."""
    strips = [_behind(line, reach, "/column-" in name) for name, line in stretches]
    tree = shapely.STRtree(strips)
    shares: dict[int, list[Polygon]] = {}
    for number, region in enumerate(_within(solid, strips)):
        before = sorted(k for k in tree.query(strips[number]).tolist() if k in shares)
        gone = [part for k in before for part in shares[k]]
        taken = polygons(region.difference(shapely.union_all(gone)) if gone else region)
        if taken:
            shares[number] = taken
    pieces = [(stretches[k][0], part) for k, parts in shares.items() for part in parts]
    rest = solid.difference(shapely.union_all([part for _, part in pieces]))
    return _number_pieces(_with_corners(pieces, polygons(rest)))


def _within(solid: BaseGeometry, strips: Sequence[BaseGeometry]) -> list[BaseGeometry]:
    """What of the solid lies in each strip. A large solid is halved first, so that no strip is
    held against walls far away."""
    if shapely.get_num_coordinates(solid) <= PLAIN or len(strips) < 8:
        return [_areal(solid.intersection(strip)) for strip in strips]
    bounds = shapely.bounds(np.array(strips, object))
    middles = (bounds[:, :2] + bounds[:, 2:]) / 2
    axis = int(np.argmax(np.ptp(middles, axis=0)))
    order = np.argsort(middles[:, axis], kind="stable")
    found: list[BaseGeometry] = [Polygon()] * len(strips)
    for half in (order[: len(order) // 2], order[len(order) // 2 :]):
        near = shapely.box(*bounds[half, :2].min(0), *bounds[half, 2:].max(0))
        clipped = _areal(solid.intersection(near))
        if shapely.get_num_coordinates(clipped) > 0.9 * shapely.get_num_coordinates(solid):
            parts = [_areal(solid.intersection(strips[k])) for k in half.tolist()]
        else:
            parts = _within(clipped, [strips[k] for k in half.tolist()])
        for k, part in zip(half.tolist(), parts, strict=True):
            found[k] = part
    return found


def _areal(shape: BaseGeometry) -> BaseGeometry:
    """A shape without the points and lines where shapes only touch."""
    if shape.geom_type in ("Polygon", "MultiPolygon"):
        return shape
    parts = [part for part in shapely.get_parts(shape) if isinstance(part, Polygon)]
    return shapely.MultiPolygon(parts)


def _behind(line: LineString, reach: float, column: bool) -> BaseGeometry:
    """What lies within ``reach`` outside a wall face (the inside is on its left)."""
    if column:
        return Polygon(line)
    strip = shapely.buffer(
        line, -reach, cap_style="flat", join_style="mitre", mitre_limit=MITRE, single_sided=True
    )
    return strip if strip.is_valid else shapely.make_valid(strip)


def _with_corners(
    pieces: list[tuple[str, Polygon]], corners: list[Polygon]
) -> list[tuple[str, Polygon]]:
    """Each corner joined to the piece it borders on most; alone if it borders on none."""
    shapes = [shape for _, shape in pieces]
    names = [name for name, _ in pieces]
    tree = shapely.STRtree(shapes)
    for corner in corners:
        rim = shapely.buffer(corner, 1e-6)
        near = np.sort(tree.query(rim)).tolist()
        shared = shapely.length(shapely.intersection(rim, [shapes[k] for k in near]))
        best = near[int(np.argmax(shared))] if near else -1
        joined = shapely.union(shapes[best], corner) if best >= 0 else corner
        if best >= 0 and isinstance(joined, Polygon):
            shapes[best] = joined
        else:
            names.append("corner")
            shapes.append(corner)
    return list(zip(names, shapes, strict=True))


def _number_pieces(pieces: list[tuple[str, Polygon]]) -> list[tuple[str, Polygon]]:
    seen: dict[str, int] = {}
    found = []
    for name, shape in pieces:
        seen[name] = seen.get(name, 0) + 1
        found.append((name if seen[name] == 1 else f"{name}-{seen[name]}", shape))
    return found
