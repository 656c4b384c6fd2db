"""Which of the chairs set in the end one can get to, and that bar no passage, and which low tables
leave the way to the seats round them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of, polygons_of
from scenewright.core.scene import Piece, Size
from scenewright.core.space import Space
from scenewright.domains.hall.accessories.setting import lead_before
from scenewright.domains.hall.measures import ARM
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.outcome import MeasuredLayout, lacking, measure_among

HALF = 0.2
"""Half of what one takes sideways between furniture, metres."""
BACK, SEEN = 0.3, 0.01
"""Metres that a chair is drawn back at least, and square metres of that floor that do not count."""
LITTLE = 1e-4


def keep_reached_chairs(
    space: Space,
    problem: HallProblem,
    layout: MeasuredLayout,
    chairs: tuple[Piece, ...],
    solid: tuple[Piece, ...],
) -> tuple[Piece, ...]:
    """Those of some chairs that stand on the floor of the hall, off its doors, between zones only
    where the passages stay as wide, and to which one gets from a door past all that is ``solid``,
    sideways if need be."""
    if not chairs:
        return ()
    kept = tuple(chair for chair in chairs if _stands_off(space, problem, chair))
    kept = _off_passages(problem, layout, kept, solid)
    near = _free_floor(space, problem, (*solid, *kept))
    shapes = polygons_of([_grow(chair) for chair in kept])
    return tuple(
        chair for chair, shape in zip(kept, shapes, strict=True) if shapely.intersects(near, shape)
    )


def keep_drawn_back(space: Space, chairs: tuple[Piece, ...]) -> tuple[Piece, ...]:
    """Those of some chairs that can be drawn back from their table: no column is right behind
    them."""
    if not chairs or not space.holes:
        return chairs
    behind = np.array([boxes_of(chair)[0] for chair in chairs])
    behind[:, 2] += np.pi
    floors = shapely.polygons(corners(lead_before(behind, BACK)))
    columns = shapely.union_all([shapely.Polygon(ring) for ring in space.holes])
    taken = shapely.area(shapely.intersection(floors, columns))
    return tuple(chair for chair, area in zip(chairs, taken.tolist(), strict=True) if area <= SEEN)


def keep_off_seats(
    space: Space,
    problem: HallProblem,
    tables: tuple[Piece, ...],
    solid: tuple[Piece, ...],
    route: float,
) -> tuple[Piece, ...]:
    """Some low tables less those with which nobody gets to the front of a seat of their groups
    among what is ``solid``, sideways if need be, though one does without them: the nearest to it
    goes first. A seat is reached from half a ``route`` and an arm before it."""
    groups = {table.group for table in tables}
    seats = [piece for piece in solid if piece.group in groups]
    if not seats:
        return tables
    boxes = np.array([boxes_of(seat)[0] for seat in seats])
    fronts = shapely.polygons(corners(lead_before(boxes, 0.5 * route + ARM)))
    reached = shapely.intersects(_free_floor(space, problem, solid), fronts)
    while tables:
        with_tables = _free_floor(space, problem, (*solid, *tables))
        lost = np.flatnonzero(reached & ~shapely.intersects(with_tables, fronts))
        if not len(lost):
            break
        x, y = seats[lost[0]].pose[:2]
        worst = min(tables, key=lambda t: np.hypot(t.pose.x - x, t.pose.y - y))
        tables = tuple(t for t in tables if t is not worst)
    return tables


def _grow(chair: Piece) -> Piece:
    """A chair with the floor on which one stands to sit down."""
    width, depth, height = chair.size
    out = 2.0 * (HALF + ARM)
    return replace(chair, size=Size(width + out, depth + out, height), footprint=())


def _stands_off(space: Space, problem: HallProblem, chair: Piece) -> bool:
    """Whether a chair stands on the floor, off what doors and windows need."""
    shape = polygons_of([replace(chair, footprint=())])[0]
    floor = shapely.Polygon(space.outline, space.holes)
    doors = shapely.polygons(corners(problem.ground.keep_free))
    return bool(
        shapely.area(shapely.difference(shape, floor)) <= LITTLE
        and (shapely.area(shapely.intersection(doors, shape)) <= LITTLE).all()
    )


def _off_passages(
    problem: HallProblem,
    layout: MeasuredLayout,
    chairs: tuple[Piece, ...],
    solid: tuple[Piece, ...],
) -> tuple[Piece, ...]:
    """Chairs with which no passage between zones, past all that is ``solid``, is narrower than it
    has to be and is without: all, else one after the other."""
    if not len(problem.ground.links) or not chairs:
        return chairs
    least = _lacking(problem, layout, solid)
    if _lacking(problem, layout, (*solid, *chairs)) <= least:
        return chairs
    kept: tuple[Piece, ...] = ()
    for chair in chairs:
        if _lacking(problem, layout, (*solid, *kept, chair)) <= least:
            kept = (*kept, chair)
    return kept


def _lacking(problem: HallProblem, layout: MeasuredLayout, pieces: tuple[Piece, ...]) -> float:
    """Metres that passages lack with some pieces."""
    rows = [(*piece.pose[:2], piece.pose.heading, *piece.size[:2]) for piece in pieces]
    p, s, _ = measure_among(problem, layout, np.array(rows))
    return lacking(p, s)


def _free_floor(
    space: Space, problem: HallProblem, solid: tuple[Piece, ...]
) -> shapely.MultiPolygon:
    """Where the middle of a person can be who walks in at a door and goes on sideways."""
    floor = shapely.Polygon(space.outline, space.holes).buffer(-HALF)
    grown = shapely.buffer(polygons_of(list(solid)), HALF, join_style="mitre")
    parts = shapely.get_parts(shapely.difference(floor, shapely.union_all(grown)))
    plan = problem.visitors
    doors = shapely.multipoints(np.concatenate([plan.entrances, plan.exits, plan.ways_out]))
    return shapely.multipolygons(parts[shapely.distance(parts, doors) <= HALF])
