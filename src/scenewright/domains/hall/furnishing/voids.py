"""Floor left empty where a brief leaves numbers open: islands of the theme of a hall stand in the
middle of the widest empty circles, off the way in and the floor people queue on."""

from __future__ import annotations

from functools import partial
from math import atan2, cos, radians, sin

import numpy as np
import shapely

from scenewright.building.door_approach import before, gates
from scenewright.catalog.kinds import SIZES
from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of, polygons_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.build_problem import HallContext, taken_floor
from scenewright.domains.hall.classes import LOUNGE_SEATS, SERVING
from scenewright.domains.hall.measures import QUEUE, WAY_WIDTH
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.visit.doors import ways_in

EMPTY_RADIUS, VOID_GRID, MOST_ISLANDS, LARGE_HALL = 2.4, 0.5, 16, 1000.0
"""Radius of a circle of floor that stays empty at most, metres between the points looked at, the
most islands, and square metres of halls from which on none are set."""
SEEN_FROM, BACK_SEEN = 7.0, 0.5
"""Metres from a door within which a back is seen, and the cosine from which on it is one."""
ISLAND_OFF_WAY, ISLAND_ASIDE, FUNCTION = 3.0, 0.9, "island"
"""Metres of the way in that stay free, around an island at least, and its function."""


def fill_voids(
    hall: HallContext, standing: tuple[Piece, ...], catalog: Catalog
) -> tuple[Piece, ...]:
    """The pieces of islands in the empty circles of a hall; none where it has no theme."""
    floor = shapely.Polygon(hall.space.outline, hall.space.holes)
    if not hall.island or floor.area >= LARGE_HALL:
        return ()
    along = atan2(*np.diff(hall.space.outline[:2], axis=0)[0][::-1])
    doors = {gate.opening.id: gate.face for gate in gates(hall.space)}
    backed = any(kind in LOUNGE_SEATS for kind, _, _ in hall.island)
    ways = [doors[door.id] for door in ways_in(hall.space)]
    found, low = list[Piece](), [p for p in standing if p.pose.z < 1.0 and not p.on]
    shapes = [floor.boundary, *polygons_of(low)]
    free = floor.difference(shapely.union_all(shapely.polygons(corners(_list_kept(hall, low)))))
    shapely.prepare(free)
    points = _list_points(floor)
    for number in range(1, MOST_ISLANDS + 1):
        far = shapely.STRtree(shapes).query_nearest(
            points, return_distance=True, all_matches=False
        )[1]
        taken = shapely.union_all(shapes)
        shapely.prepare(taken)
        island = list[Piece]()
        for k in np.argsort(-far)[: int((far > EMPTY_RADIUS).sum())]:
            at = shapely.get_coordinates(points[k])[0]
            axes = (along, along + 0.5 * np.pi)[: 2 if backed else 1]
            axis = min(axes, key=partial(_look_to, at, ways))
            if backed and _look_to(at, ways, axis) > BACK_SEEN:
                continue
            island = _make_island(hall, at, axis, number, catalog)
            around = shapely.union_all(polygons_of(island))
            if free.covers(around) and taken.disjoint(around.buffer(ISLAND_ASIDE)):
                break
            island = []
        if not island:
            break
        found += island
        shapes += list(polygons_of(island))
    return tuple(found)


def _look_to(at: Floats, ways: list[Floats], axis: float) -> float:
    """The largest cosine between an axis and the way from a point to the main entrance, or to any
    other from which one sees it."""
    off = [way - at for k, way in enumerate(ways) if not k or np.hypot(*(way - at)) < SEEN_FROM]
    ahead = np.array([cos(axis), sin(axis)])
    return max((abs(float(way @ ahead) / float(np.hypot(*way))) for way in off), default=0.0)


def _list_points(floor: shapely.Polygon) -> Floats:
    x0, y0, x1, y1 = floor.bounds
    grid = np.meshgrid(
        np.arange(x0 + VOID_GRID, x1, VOID_GRID), np.arange(y0 + VOID_GRID, y1, VOID_GRID)
    )
    points = shapely.points(*(part.ravel() for part in grid))
    return np.asarray(points[shapely.contains(floor, points)])


def _list_kept(hall: HallContext, standing: list[Piece]) -> Floats:
    """Boxes (k, 5) of floor on which no island stands."""
    doors = [gate for gate in gates(hall.space) if gate.opening.kind != "window"]
    ways = [before(gate, max(gate.opening.width, WAY_WIDTH), ISLAND_OFF_WAY) for gate in doors]
    desks = np.array([b for p in standing if p.category in SERVING for b in boxes_of(p)])
    desks = desks.reshape(-1, 5).copy()
    off = 0.5 * (desks[:, 4] + QUEUE)
    desks[:, :2] += off[:, None] * np.column_stack([np.cos(desks[:, 2]), np.sin(desks[:, 2])])
    desks[:, 4] = QUEUE
    return np.concatenate([np.array(ways).reshape(-1, 5), desks, taken_floor(hall)])


def _make_island(
    hall: HallContext, at: Floats, axis: float, number: int, catalog: Catalog
) -> list[Piece]:
    """The pieces of one island about a point."""
    group, found = f"{hall.space.id}/{FUNCTION}-{number}", list[Piece]()
    for k, (category, ahead, turn) in enumerate(hall.island, 1):
        x, y = at + ahead * np.array([cos(axis), sin(axis)])
        size = Size(*SIZES[category][1])
        asset = catalog.choose(category, size)
        heading = (axis + radians(turn) + np.pi) % (2.0 * np.pi) - np.pi
        found.append(
            Piece(
                id=f"{group}/{category}_{k}",
                category=category,
                asset=asset.id if asset else "",
                space=hall.space.id,
                pose=Pose(float(x), float(y), 0.0, float(heading)),
                size=size,
                group=group,
                function=FUNCTION,
                footprint=footprint_of(asset, size),
            )
        )
    return found
