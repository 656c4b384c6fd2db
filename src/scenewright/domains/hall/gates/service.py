"""Where people are served: a line of desks generated at a wall, looking to the door it belongs to,
with the floor of its staff behind, shut off at its ends, and free floor before it to queue on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from math import cos, sin
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.door_approach import DoorApproach, before, gates
from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.build_problem import HallContext, taken_floor
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.demands.themes import Role
from scenewright.domains.hall.furnishing.pieces import make_piece
from scenewright.domains.hall.gates.barriers import make_barriers
from scenewright.domains.hall.gates.leaves import make_leaf
from scenewright.domains.hall.measures import WAY_WIDTH
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.retouch.places import walk_edges

SERVICE_STEP, SERVICE_LITTLE, END_RAIL = 0.3, 0.005, 0.06
"""Metres between the places tried along a wall, by how much floor is measured less than it is, and
how thick what shuts an end off is."""
STAFF_FLOOR = 0.95
"""Metres from the back of a desk to the wall behind it (Neufert 2012, shops: 0.75 to 0.9 m)."""
CLEAR_OF_WAY = 2.5
"""Metres behind a door on which no desk and no queue stands, where those who come in look round."""
OPEN_END, PER_METRE, PER_BACK = 0.8, 0.8, 0.06
"""What an end that no wall closes costs, each metre off the wished distance, and each metre from
the nearest door at the back."""
ROPES_OFF, ROPE_LANE = 1.0, 1.2
"""Metres from a desk to the ropes before it, and between two."""
LOOKS_AWAY, JUST_INSIDE = -0.45, 1.0
"""The least cosine between the front of each desk and the way to the door; who comes in is looked
at so many metres inside it."""


class Service(NamedTuple):
    """A line of desks: boxes (n, 5) of these, the floor of the line with its staff and that of its
    queue (5,), boxes (k, 5) of what shuts its ends off, that one comes in by first, (1, 5) of
    the floor before that, and (g, 5) of goods at the wall behind."""

    row: Floats
    body: Floats
    queue: Floats
    ends: Floats
    way: Floats
    goods: Floats


def find_service(
    hall: HallContext, wish: HallDemand, role: Role, door: DoorApproach, goods: tuple[Size, ...]
) -> Service | None:
    """The best free place of a line of desks by its role at a door, with as many ``goods`` behind
    it as it is long; None where there is none."""
    ranked = sorted(_list_places(hall, wish, role, door, goods), key=lambda one: one[0])
    floor = shapely.Polygon(hall.space.outline, hall.space.holes)
    way = before(door, max(WAY_WIDTH, door.opening.width), CLEAR_OF_WAY)
    taken = shapely.polygons(corners(taken_floor(hall)))
    tree = shapely.STRtree([*taken, shapely.polygons(corners(np.array([way])))[0]])
    fits = partial(_is_free, floor, tree)
    return next((place for _, place in ranked if fits(place)), None)


def _list_places(
    hall: HallContext, wish: HallDemand, role: Role, door: DoorApproach, goods: tuple[Size, ...]
) -> Iterator[tuple[float, Service]]:
    """Places of a line along the walls of its zones with what each costs."""
    wide = sum(size.width for size in wish.sizes)
    backs = [
        gate.face
        for gate in gates(hall.space)
        if gate.opening.kind != "window" and gate.opening.id != door.opening.id
    ]
    named = [k for k, name in enumerate(hall.names) if not wish.zones or name in wish.zones]
    walls = [(w.x0, w.y0, w.x1, w.y1) for k in named for w in hall.walls[k]]
    floor = shapely.prepared.prep(shapely.Polygon(hall.space.outline, hall.space.holes))
    for start, along, left, length in walk_edges(np.array(walls).reshape(-1, 4)):
        spare = length - wide
        if spare < 0.0:
            continue
        for at in np.unique(
            [0.02, *np.arange(SERVICE_STEP, spare, SERVICE_STEP), max(spare - 0.02, 0.0)]
        ):
            if at > spare:
                continue
            place = _stand(wish, role, start + at * along, along, left, goods)
            shut = [_meets_wall(floor, place, along, left, side) for side in (-1, 1)]
            if not all(shut):
                ends = _list_ends(place, along, left, shut)
                cost = _weigh(place.row, role, door, backs) + OPEN_END * len(ends)
                yield cost, place._replace(ends=ends, way=_find_way(hall, place.body, ends[0]))


def _stand(
    wish: HallDemand,
    role: Role,
    start: Floats,
    along: Floats,
    left: Floats,
    goods: tuple[Size, ...],
) -> Service:
    """A line that begins at a point of a wall; right of its fronts is where the wall begins."""
    turn = float(np.arctan2(left[1], left[0]))
    wide = sum(size.width for size in wish.sizes)
    held = _count_fitting(goods, wide - 2.0 * END_RAIL)
    behind = max((size.depth for size in goods[:held]), default=0.0)
    back = STAFF_FLOOR + behind
    body = back + max(size.depth for size in wish.sizes)

    def line(sizes: tuple[Size, ...], at: float, fronts: float) -> Floats:
        """Boxes (n, 5) side by side, their fronts so far from the wall, the first one last."""
        rows = list[list[float]]()
        for size in reversed(sizes):
            x, y = start + (at + 0.5 * size.width) * along + (fronts - 0.5 * size.depth) * left
            rows.append([float(x), float(y), turn, size.width, size.depth])
            at += size.width
        return np.array(rows[::-1]).reshape(-1, 5)

    def floor(low: float, deep: float) -> Floats:
        """The box (5,) of the floor from so far off the wall on."""
        return np.array(
            [*(start + 0.5 * wide * along + (low + 0.5 * deep) * left), turn, wide, deep]
        )

    stored = sum(size.width for size in goods[:held])
    return Service(
        row=line(wish.sizes, 0.0, body),
        body=floor(0.0, body),
        queue=floor(body, max(role.queue, 0.01)),
        ends=np.zeros((0, 5)),
        way=np.zeros((0, 5)),
        goods=line(goods[:held], 0.5 * (wide - stored), behind),
    )


def _count_fitting(goods: tuple[Size, ...], wide: float) -> int:
    """How many of some goods stand side by side on so many metres."""
    ends = np.cumsum([size.width for size in goods])
    return int((ends <= wide).sum())


def _side(place: Service, along: Floats, left: Floats, side: int) -> Floats:
    """The middle (2,) of the open end of the floor of staff on one side."""
    goods = float(place.goods[:, 4].max(initial=0.0))
    off = 0.5 * (goods + STAFF_FLOOR + goods - place.body[4])
    middle: Floats = place.body[:2] + off * left + side * 0.5 * place.body[3] * along
    return middle


def _meets_wall(
    floor: shapely.prepared.PreparedGeometry, place: Service, along: Floats, left: Floats, side: int
) -> bool:
    """Whether a wall closes one end of the floor of staff."""
    end = _side(place, along, left, side)
    points = (end + side * 0.12 * along + off * left for off in (-0.3, 0.0, 0.3))
    return not any(floor.contains(shapely.Point(point)) for point in points)


def _list_ends(place: Service, along: Floats, left: Floats, shut: list[bool]) -> Floats:
    """Boxes (k, 5) that close the ends no wall does, the one farther from the door last."""
    turn = float(np.arctan2(along[1], along[0]))
    found = [
        [
            *(_side(place, along, left, side) - side * 0.5 * END_RAIL * along),
            turn,
            STAFF_FLOOR - 0.02,
            END_RAIL,
        ]
        for side, closed in zip((-1, 1), shut, strict=True)
        if not closed
    ]
    return np.array(found).reshape(-1, 5)


def _weigh(row: Floats, role: Role, door: DoorApproach, backs: list[Floats]) -> float:
    """What a place of desks (n, 5) costs by its distance from the door, where it looks, and how far
    the door at the back is; infinite where it turns its back to who comes in."""
    middle, turn = row[:, :2].mean(0), float(row[0, 2])
    far, way = (
        float(np.hypot(*(door.face - middle))),
        door.face + JUST_INSIDE * door.inward - middle,
    )
    ahead, to_door = np.array([cos(turn), sin(turn)]), door.face - row[:, :2]
    facing = float(way @ ahead) / max(float(np.hypot(*way)), 1e-9)
    if (to_door @ ahead < LOOKS_AWAY * np.hypot(*to_door.T)).any():
        return float("inf")
    off = max(far - role.within, 0.0) + max(role.least - far, 0.0)
    back = min((float(np.hypot(*(at - middle))) for at in backs), default=0.0)
    return PER_METRE * off + role.faces * (1.0 - facing) + role.back * PER_BACK * back


def _find_way(hall: HallContext, body: Floats, end: Floats) -> Floats:
    """The box (1, 5) of the floor before the end by which staff comes in."""
    along = np.array([sin(body[2]), -cos(body[2])])
    way = end.copy()
    way[:2] += np.sign((end[:2] - body[:2]) @ along) * 0.5 * hall.route * along
    way[4] = hall.route
    return way[None]


def _is_free(floor: shapely.Polygon, taken: shapely.STRtree, place: Service) -> bool:
    """Whether a line, its queue and the way to its staff lie on free floor."""
    boxes = np.concatenate([place.body[None], place.queue[None], place.way])
    little = np.array([0.0, 0.0, 0.0, 2.0 * SERVICE_LITTLE, 2.0 * SERVICE_LITTLE])
    shapes = shapely.polygons(corners(boxes - little))
    return bool(floor.covers(shapely.union_all(shapes))) and not len(
        taken.query(shapes, "intersects")[0]
    )


def place_ropes(hall: HallContext, line: Service, wish: HallDemand) -> Floats | None:
    """Boxes (n, 5) of ropes along both sides of a lane to the middle of a line, the first of them
    a step before it; None where they would bar something."""
    turn, wide = float(line.body[2]), max(size.width for size in wish.sizes)
    left, along = np.array([cos(turn), sin(turn)]), np.array([sin(turn), -cos(turn)])
    start = line.body[:2] + (0.5 * line.body[4] + ROPES_OFF) * left
    rows = [
        [
            *(start + (k // 2 + 0.5) * wide * left + (0.5 - k % 2) * ROPE_LANE * along),
            *(turn + 0.5 * np.pi, size.width, size.depth),
        ]
        for k, size in enumerate(wish.sizes)
    ]
    boxes, free = np.array(rows), hall._replace(queues=())
    floor = shapely.Polygon(hall.space.outline, hall.space.holes)
    around = boxes + np.array([0.0, 0.0, 0.0, 0.0, 2.0 * hall.route])
    shapes = shapely.polygons(corners(around))
    taken = shapely.union_all(shapely.polygons(corners(taken_floor(free))))
    return (
        boxes
        if floor.covers(shapely.union_all(shapes)) and shapely.disjoint(shapes, taken).all()
        else None
    )


def furnish_service(
    hall: HallContext, wish: HallDemand, place: Service, catalog: Catalog
) -> tuple[tuple[Piece, ...], tuple[Piece, ...]]:
    """The pieces of a line with what shuts it off, and the desks as large as the floor they take
    with their staff while the rest is laid out."""
    group = f"{hall.space.id}/{wish.id}"
    desks = tuple(
        make_piece(hall, wish, group, number, (Pose(x, y, 0.0, turn), size), catalog)
        for number, (size, (x, y, turn, *_)) in enumerate(
            zip(wish.sizes, place.row.tolist(), strict=True), 1
        )
    )
    more = make_barriers(hall.space, group, wish.id, place.ends[1:], catalog)
    if len(place.ends):
        x, y, turn, wide, _ = place.ends[0]
        half = 0.5 * wide * np.array([sin(turn), -cos(turn)])
        of = replace(desks[0], function=f"{wish.id}/barriers")
        span = (np.array([x, y]) - half, np.array([x, y]) + half)
        more = (*more, make_leaf(of, span, catalog))
    return (*desks, *more), tuple(_grow(desk, place.body[4]) for desk in desks)


def _grow(desk: Piece, deep: float) -> Piece:
    """A desk as deep as its line with its staff."""
    off, turn = 0.5 * (deep - desk.size.depth), desk.pose.heading
    pose = Pose(desk.pose.x - off * cos(turn), desk.pose.y - off * sin(turn), 0.0, turn)
    size = Size(desk.size.width, deep, desk.size.height)
    return replace(desk, pose=pose, size=size, footprint=())
