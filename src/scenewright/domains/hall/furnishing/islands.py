"""Islands: groups in a hall that share a carpet, lit from the ceiling.

Only drawn: carpets and spots belong to the scene of a hall, not to its solution, and bar nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely
from shapely import Geometry

from scenewright.building.masonry import polygons
from scenewright.building.shell import scene_of_rooms
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.plan import Plan
from scenewright.core.scene import GroundSurface, Piece, Pose, Scene, Size
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains.hall.classes import CARPETED_EXHIBITS, CARPETED_SEATS
from scenewright.domains.hall.hall_layout import HallLayout, PlacedGroup, Zone

FLOORED_FOR = {
    "gondola": "supermarket",
    "fridge_shelf": "supermarket",
    "pew": "worship",
    "showcase": "museum",
    "exhibit_island": "museum",
    "exhibit_panel": "museum",
}
"""What a hall is for by the things in it, where its brief does not say: its floor is of that."""
CARPETS = ("carpet_grey", "carpet_sand", "carpet_sage")
BEYOND, ONE_CARPET, SEAM = 0.7, 1.3, 0.15
"""How far a carpet reaches beyond its objects, up to which gap two share one, and how far it
keeps from the border of its zone, metres."""
RINGS = ("radiation", "circulation")
"""Patterns on a round carpet."""
LEAST_CARPET = 3.0
"""Square metres of a carpet, at least."""
HOLE, FULL_ISLAND, ROUND_ISLAND = 12.0, 0.7, 0.85
"""Square metres of a hole in a carpet that is filled, the share of its rectangle from which on a
carpet is one, and 4 pi area over squared rim from which on it is round and stays so."""
COLUMN = 1.5
"""Square metres of a column at most: carpets lie close around it."""
PILE = 0.008
SPOT = Size(0.3, 0.3, 0.14)
MOST_SPOTS = 400


def scene_of_hall(solution: Solution, plan: Plan) -> Scene:
    """The scene of halls, with a carpet under each free-standing group and a spot over each of
    its exhibits."""
    scene = scene_of_rooms(solution, plan)
    scene = replace(scene, spaces=tuple(_name_use(s, solution.pieces) for s in scene.spaces))
    if solution.detail is None:  # a saved hall without its groups
        return scene
    layout: HallLayout = solution.detail.layout
    pieces = {piece.id: piece for piece in solution.pieces}
    free = [group for group in layout.groups if group.pattern != "wall"]
    laid = (_lay_carpet(zone, k, free, pieces) for k, zone in enumerate(layout.zones))
    carpets = [carpet for carpet in laid if carpet is not None]
    lit = [pieces[o] for group in free for o in group.objects if o in pieces]
    spots = _hang_spots(
        [p for p in lit if p.category in CARPETED_EXHIBITS][:MOST_SPOTS], plan.spaces
    )
    return replace(scene, surfaces=tuple(carpets), pieces=(*scene.pieces, *spots))


def _name_use(space: Space, pieces: Sequence[Piece]) -> Space:
    """A space of unknown use with the use that its furniture implies."""
    held = {piece.category for piece in pieces if piece.space == space.id}
    found = [use for category, use in FLOORED_FOR.items() if category in held]
    known = space.functions != ("other",) or not found
    return space if known else replace(space, functions=(found[0],))


def _lay_carpet(
    zone: Zone, number: int, groups: Sequence[PlacedGroup], pieces: dict[str, Piece]
) -> GroundSurface | None:
    """The carpets of a zone, in its colour, a seam off its border; ``None`` where nothing in it
    stands on one."""
    held = [
        (group.pattern, tuple(pieces[o] for o in group.objects if o in pieces))
        for group in groups
        if (group.space, group.zone) == (zone.space, zone.id)
    ]
    standing = [
        row for row in held if any(p.category in CARPETED_EXHIBITS | CARPETED_SEATS for p in row[1])
    ]
    standing = [row for row in standing if not _sit_apart(*row)]
    if not standing:
        return None
    whole = shapely.union_all([_surround(some, name in RINGS) for name, some in standing])
    joined = _close(whole, ONE_CARPET / 2).simplify(0.05)
    holes = [hole for hole in zone.holes if shapely.Polygon(hole).area > COLUMN]
    floor = shapely.Polygon(zone.outline, holes)
    if floor.area < LEAST_CARPET:
        return None
    floor = floor.buffer(-SEAM, join_style="mitre")
    parts = [
        p for p in polygons(plain_carpet(joined).intersection(floor)) if p.area >= LEAST_CARPET
    ]
    colour = CARPETS[number % len(CARPETS)]
    name = f"{zone.space}/{zone.id}/carpet"
    rings = tuple(map(_rings, parts))
    return GroundSurface(name, zone.space, colour, rings, 0.0, PILE) if parts else None


def _sit_apart(pattern: str, held: tuple[Piece, ...]) -> bool:
    """Whether pieces are benches set one by one before what they look at, each without a carpet."""
    return pattern == "single" and all(piece.category == "bench" for piece in held)


def _surround(held: tuple[Piece, ...], ring: bool) -> Geometry:
    """The floor round pieces, with square corners, gaps between neighbours closed; of a ``ring``
    all it encloses, with a round rim."""
    boxes = np.array([box for piece in held for box in boxes_of(piece)])
    if ring and len(held) > 2:
        middle = boxes[:, :2].mean(0)
        far = np.hypot(*(corners(boxes).reshape(-1, 2) - middle).T).max()
        return shapely.Point(middle).buffer(float(far) + 0.5 * BEYOND, quad_segs=16)
    boxes[:, 3:] += 2 * BEYOND
    return _close(shapely.union_all(shapely.polygons(corners(boxes))), ONE_CARPET / 2)


def plain_carpet(shape: Geometry) -> Geometry:
    """A shape without small holes, each part filled up to a rectangle where that is little more."""
    whole = []
    for part in polygons(shape):
        holes = [ring for ring in part.interiors if shapely.Polygon(ring).area > HOLE]
        plain = shapely.Polygon(part.exterior, holes)
        box = shapely.minimum_rotated_rectangle(plain)
        round_ = 4 * np.pi * plain.area >= ROUND_ISLAND * plain.length**2
        whole.append(plain if round_ or plain.area < FULL_ISLAND * box.area else box)
    return shapely.union_all(whole)


def _close(shape: Geometry, by: float) -> Geometry:
    """A shape whose gaps up to twice as wide are closed."""
    return shape.buffer(by, join_style="mitre").buffer(-by, join_style="mitre")


def _rings(part: shapely.Polygon) -> tuple[np.ndarray, tuple[np.ndarray, ...]]:
    whole = shapely.orient_polygons(part)
    inner = tuple(np.asarray(ring.coords)[:-1] for ring in whole.interiors)
    return np.asarray(whole.exterior.coords)[:-1], inner


def _hang_spots(exhibits: Sequence[Piece], spaces: Sequence[Space]) -> list[Piece]:
    """A spot at the ceiling over each exhibit."""
    heights = {space.id: space.height for space in spaces}
    return [
        Piece(
            id=f"{piece.id}/spot",
            category="ceiling_lamp",
            asset="ceiling_lamp",
            space=piece.space,
            pose=Pose(piece.pose.x, piece.pose.y, heights[piece.space] - SPOT.height, 0.0),
            size=SPOT,
            group=piece.group,
            function="light",
        )
        for piece in exhibits
        if piece.space in heights
    ]
