"""Buildings of a city model under the roofs they are drawn with: closed solids of detail 2.0.

The planes of a roof share the footprint out: their borders, noded, are the edges of the roof. Walls
go up to its rim side by side, others stand where one plane ends above another, and one floor closes
the body: every edge is used twice, in opposite directions.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import shapely

from scenewright.building.outlines import signed_area
from scenewright.catalog.assets.buildings.roof_planes import RoofPlane, roof_planes
from scenewright.core.footprint import Footprint, place_outline
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece
from scenewright.ground.buildings.city_objects import (
    GROUND,
    ROOF,
    SCALE,
    SURFACES,
    WALL,
    Vertices,
    add_vertex,
    prism_object,
)

STEP = 0.005
"""Metres by which planes may miss each other where they meet; borders are rounded to SCALE."""
Key = tuple[int, int]
Spot = tuple[Key, float]
Side = tuple[float, float]
Face = tuple[list[list[Key]], tuple[float, float, float]]


def add_roof(made: dict[str, Any], piece: Piece, vertices: Vertices) -> dict[str, Any]:
    """The object of a building with its solid of level of detail 2 beside what it has, where it is
    drawn as a house with a roof that is known, or as a prism, having no model."""
    if not piece.asset:
        return add_flat_roof(made)
    solid = find_roofed(piece, vertices)
    return made if solid is None else made | {"geometry": [*made["geometry"], solid]}


def roofed_building(piece: Piece, attributes: dict[str, Any], vertices: Vertices) -> dict[str, Any]:
    """A building as a prism over its footprint, and its body under its roof where that is known;
    name, height and front are told beside ``attributes``."""
    told = {"name": piece.function, "measuredHeight": round(piece.size[2], 3), **attributes}
    told["heading"] = round(float(np.rad2deg(piece.pose.heading)), 3)
    low = piece.pose.z
    made = prism_object(outline_of(piece), low, low + piece.size[2], told, vertices)
    return add_roof(made, piece, vertices)


def find_roofed(piece: Piece, vertices: Vertices) -> dict[str, Any] | None:
    """The solid of a building under the roof its model is drawn with; ``None`` if that roof is not
    known or the body would not close."""
    w, d = piece.size.width / 2, piece.size.depth / 2
    outline = piece.footprint or ((w, -d), (w, d), (-w, d), (-w, -d))
    planes = roof_planes(piece.asset, piece.size, piece.footprint)
    return roofed_solid(outline, planes, piece.pose, vertices) if planes else None


def add_flat_roof(made: dict[str, Any]) -> dict[str, Any]:
    """The object of a building that is drawn as a prism: that is its body of detail 2.0 too."""
    (prism,) = made["geometry"]
    return made | {"geometry": [prism, prism | {"lod": "2.0"}]}


def roofed_solid(
    outline: Footprint, planes: Sequence[RoofPlane], pose: Sequence[float], vertices: Vertices
) -> dict[str, Any] | None:
    """The closed body between a footprint and a roof, in a local frame that ``pose`` (x, y, z,
    heading) places; ``None`` if planes do not cover the footprint or the body would not close.

    >>> from scenewright.core.scene import Pose
    >>> from scenewright.catalog.assets.buildings.roof_planes import flat_roof
    >>> square = ((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0))
    >>> made = roofed_solid(square, flat_roof(square, 3.0), Pose(0.0, 0.0, 0.0, 0.0), {})
    >>> made["semantics"]["values"]
    [[0, 1, 2, 2, 2, 2]]
    """
    ordered = outline if signed_area(np.array(outline)) > 0 else outline[::-1]
    corners = [_key(point) for point in ordered]
    faces = _noded(_shared_out(outline, planes))
    levels = _levels(faces)
    rim = _rim([rings for rings, _ in faces])
    if rim is None or not set(corners) <= set(rim) or min(map(min, levels.values())) <= STEP:
        return None
    start = rim.index(corners[0])
    rim = rim[start:] + rim[:start]
    if [key for key in rim if key in set(corners)] != corners:
        return None
    exact = dict(zip(corners, ordered, strict=True))
    tops = [(key, high) for key, rows in levels.items() for high in rows]
    spots = [exact.get(key, (key[0] * SCALE, key[1] * SCALE)) for key, _ in tops]
    numbers = _placed([*spots, *ordered], [*(z for _, z in tops), *[0.0] * len(corners)], pose)
    if len(set(numbers)) < len(numbers):
        return None
    named = [add_vertex(number, vertices) for number in numbers]
    at = dict(zip([*tops, *((key, 0.0) for key in corners)], named, strict=True))
    sides = _sides(faces, levels)
    roof = [
        [[(key, _level(levels[key], plane, key)) for key in r] for r in rings]
        for rings, plane in faces
    ]
    walls = [*_outer_walls(rim, corners, sides, levels), *_inner_walls(sides, levels)]
    floor = [[(key, 0.0) for key in corners[::-1]]]
    shell = [floor, *roof, *([ring] for ring in walls)]
    if not _is_closed([ring for face in shell for ring in face]):
        return None
    kinds = [GROUND, *[ROOF] * len(roof), *[WALL] * len(walls)]
    return {
        "type": "Solid",
        "lod": "2.0",
        "boundaries": [[[[at[spot] for spot in ring] for ring in face] for face in shell]],
        "semantics": {"surfaces": SURFACES, "values": [kinds]},
    }


def _is_closed(rings: list[list[Spot]]) -> bool:
    """Whether every side is used twice, in opposite directions."""
    sides = [(ring[k - 1], ring[k]) for ring in rings for k in range(len(ring))]
    known = set(sides)
    return len(known) == len(sides) and all((b, a) in known for a, b in sides)


def _key(point: Sequence[float]) -> Key:
    return round(float(point[0]) / SCALE), round(float(point[1]) / SCALE)


def _shared_out(
    outline: Footprint, planes: Sequence[RoofPlane]
) -> list[tuple[shapely.Polygon, tuple[float, float, float]]]:
    """The footprint shared out among planes: what is between their borders goes to the highest."""
    floor = shapely.Polygon(outline)
    borders = [shapely.boundary(row.ground) for row in planes]
    noded = shapely.union_all([floor.exterior, *borders], grid_size=SCALE)
    held: dict[tuple[float, float, float], list[shapely.Polygon]] = {}
    for cell in shapely.get_parts(shapely.polygonize(shapely.get_parts(noded))):
        at = shapely.point_on_surface(cell)
        if not floor.covers(at):
            continue
        over = [row.plane for row in planes if row.ground.distance(at) <= SCALE]
        if over:
            highest = max(over, key=lambda row: row[0] * at.x + row[1] * at.y + row[2])
            held.setdefault(highest, []).append(cell)
    return [
        (part, plane)
        for plane, cells in held.items()
        for part in shapely.get_parts(shapely.union_all(cells, grid_size=SCALE))
    ]


def _noded(parts: list[tuple[shapely.Polygon, tuple[float, float, float]]]) -> list[Face]:
    """Faces by the corners of their rings, counter-clockwise, with every corner of another face
    that lies on a side among them."""
    rings = [
        [
            [_key(point) for point in shapely.get_coordinates(ring)[:-1]]
            for ring in (sound.exterior, *sound.interiors)
        ]
        for sound in (shapely.orient_polygons(part) for part, _ in parts)
    ]
    nodes = np.array(sorted({key for face in rings for ring in face for key in ring}), float)
    return [
        ([_with_nodes(ring, nodes) for ring in face], plane)
        for face, (_, plane) in zip(rings, parts, strict=True)
    ]


def _with_nodes(ring: list[Key], nodes: np.ndarray) -> list[Key]:
    """A ring with the nodes (n, 2) that lie on its sides."""
    found = list[Key]()
    for k, start in enumerate(ring):
        found.append(start)
        step = np.subtract(ring[(k + 1) % len(ring)], start)
        length = max(float(np.hypot(*step)), 1e-9)
        away = nodes - start
        along = away @ step / length
        aside = np.abs(away[:, 0] * step[1] - away[:, 1] * step[0]) / length
        on = np.flatnonzero((aside <= 0.75) & (along > 0.5) & (along < length - 0.5))
        found += [_whole(nodes[n]) for n in on[np.argsort(along[on])]]
    return found


def _whole(node: np.ndarray) -> Key:
    return int(node[0]), int(node[1])


def _height(plane: tuple[float, float, float], key: Key) -> float:
    return plane[0] * key[0] * SCALE + plane[1] * key[1] * SCALE + plane[2]


def _levels(faces: list[Face]) -> dict[Key, list[float]]:
    """The heights at which planes pass each corner, from below; those that nearly meet are one."""
    found: dict[Key, list[float]] = {}
    for rings, plane in faces:
        for key in {key for ring in rings for key in ring}:
            found.setdefault(key, []).append(_height(plane, key))
    for key, rows in found.items():
        ordered = sorted(rows)
        found[key] = [z for k, z in enumerate(ordered) if not k or z - ordered[k - 1] > STEP]
    return found


def _level(levels: list[float], plane: tuple[float, float, float], key: Key) -> float:
    """That of the heights of a corner at which a plane passes it."""
    high = _height(plane, key)
    return min(levels, key=lambda level: abs(level - high))


def _sides(faces: list[Face], levels: dict[Key, list[float]]) -> dict[tuple[Key, Key], Side]:
    """The heights of both ends of each side of a face, by those ends."""
    return {
        (a, b): (_level(levels[a], plane, a), _level(levels[b], plane, b))
        for rings, plane in faces
        for ring in rings
        for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)
    }


def _rim(faces: list[list[list[Key]]]) -> list[Key] | None:
    """The corners once around all faces; ``None`` if these are not one patch without holes."""
    sides = [(ring[k - 1], ring[k]) for face in faces for ring in face for k in range(len(ring))]
    known = set(sides)
    after = {a: b for a, b in sides if (b, a) not in known}
    free = sum((b, a) not in known for a, b in sides)
    if len(known) < len(sides) or not after or free != len(after):
        return None
    found = [next(iter(after))]
    while len(found) <= len(after) and (following := after.get(found[-1])) != found[0]:
        if following is None:
            return None
        found.append(following)
    return found if len(found) == len(after) else None


def _placed(
    spots: Sequence[Sequence[float]], heights: Sequence[float], pose: Sequence[float]
) -> list[tuple[int, int, int]]:
    """Corners at their heights, placed by a pose, in whole millimetres."""
    x, y, z, heading = pose
    plan = np.round(place_outline(np.array(spots, float), x, y, heading) / SCALE).astype(int)
    return [
        (east, north, round((z + high) / SCALE))
        for (east, north), high in zip(plan.tolist(), heights, strict=True)
    ]


def _upright(key: Key, low: float, high: float, levels: dict[Key, list[float]]) -> list[Spot]:
    """The corners above one place from a height to another, both among them."""
    rows = {low, high, *(z for z in levels[key] if min(low, high) < z < max(low, high))}
    return [(key, z) for z in sorted(rows, reverse=low > high)]


def _outer_walls(
    rim: list[Key],
    corners: list[Key],
    sides: dict[tuple[Key, Key], Side],
    levels: dict[Key, list[float]],
) -> Iterator[list[Spot]]:
    """A wall over each side of the footprint, up to the rim of the roof."""
    starts = [rim.index(key) for key in corners]
    closed = [*rim, rim[0]]
    for first, last in zip(starts, [*starts[1:], len(rim)], strict=True):
        ring: list[Spot] = [
            (closed[first], 0.0),
            *_upright(closed[last], 0.0, sides[closed[last - 1], closed[last]][1], levels),
        ]
        for k in range(last - 1, first - 1, -1):
            below = sides[closed[k - 1], closed[k]][1] if k > first else 0.0
            ring += _upright(closed[k], sides[closed[k], closed[k + 1]][0], below, levels)
        yield list(dict.fromkeys(ring))


def _inner_walls(
    sides: dict[tuple[Key, Key], Side], levels: dict[Key, list[float]]
) -> Iterator[list[Spot]]:
    """A wall wherever one plane ends above another."""
    for (a, b), (high_a, high_b) in sides.items():
        low_b, low_a = sides.get((b, a), (high_b, high_a))
        if (high_a - low_a) + (high_b - low_b) > 0:
            ring = [*_upright(a, high_a, low_a, levels), *_upright(b, low_b, high_b, levels)]
            yield list(dict.fromkeys(ring))
