"""Numbers of a furnished room that guidelines of interior design speak of.

Exact polygons of the final pieces; nothing here is asked during the search. ``None`` where the room
does not have what is measured.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import atan2, cos, degrees, hypot, pi, remainder, sin

import numpy as np
import shapely

from benchmarks.designer_rooms import Seen
from scenewright.building.door_approach import DoorApproach, gates
from scenewright.catalog.assets import shipped
from scenewright.core.scene import Piece
from scenewright.domains.home.learned.space import footprint
from scenewright.domains.home.learned.targets import free_before

SOFAS = ("sofa", "corner_sofa", "loveseat")
SEATS = (*SOFAS, "armchair")
BEDS = ("double_bed", "single_bed", "bunk_bed")
DESKS = ("desk", "kids_desk")
STORES = (
    "wardrobe",
    "chest_of_drawers",
    "bookcase",
    "sideboard",
    "shelf_unit",
    "storage_shelf",
    "shoe_cabinet",
    *BEDS,
)
KITCHEN = ("sink_cabinet", "hob_cabinet", "fridge")
WIDTHS = np.arange(0.3, 1.0001, 0.05)  # of ways that are tried, metres
TURNED = np.deg2rad(5.0)  # a piece further off the walls' directions is askew
BACKED = 0.1  # a back nearer to a wall than this stands at it, metres
WINDOW_DEPTH = 0.3  # what is before the glass, metres
TALL = 1.3  # what is taller hides the door from one who lies in bed, metres


def standing(room: Seen) -> list[Piece]:
    """What stands on the floor and is not flat."""
    kinds = shipped().kinds
    return [
        p
        for p in room.pieces
        if p.pose.z < 0.05
        and p.size.height > 0.05
        and kinds[p.category].support == "floor"
        and not kinds[p.category].flat
    ]


def _of(room: Seen, kinds: Iterable[str]) -> list[Piece]:
    wanted = tuple(kinds)
    return sorted((p for p in room.pieces if p.category in wanted), key=_by_size)


def _by_size(piece: Piece) -> float:
    return -piece.size.width * piece.size.depth


def faults(room: Seen) -> float | None:
    """What the referee finds wrong."""
    return float(room.faults)


def route(room: Seen) -> float | None:
    """The widest way that joins all doors and comes to everything used from the floor."""
    kinds = shipped().kinds
    pieces = standing(room)
    used = [p for p in pieces if kinds[p.category].access and not kinds[p.category].under]
    doors = [g.face for g in gates(room.space) if g.opening.kind != "window"]
    if not used or not doors:
        return None
    shapes = [footprint(p) for p in pieces]
    goals = [*(footprint(p) for p in used), *(shapely.Point(face) for face in doors)]
    low, high = 0, len(WIDTHS)
    while low < high:
        middle = (low + high) // 2
        joined = _joins(room, shapes, goals, float(WIDTHS[middle]) / 2)
        low, high = (middle + 1, high) if joined else (low, middle)
    return float(WIDTHS[max(low - 1, 0)])


def _joins(
    room: Seen, shapes: list[shapely.Polygon], goals: list[shapely.Geometry], radius: float
) -> bool:
    """Whether a disc can go from each goal to each other."""
    taken = shapely.union_all(shapely.buffer(shapes, radius, quad_segs=4))
    free = shapely.buffer(room.floor, -radius, quad_segs=4).difference(taken)
    near = np.array(
        [shapely.distance(part, goals) < radius + 0.15 for part in shapely.get_parts(free)]
    )
    return bool(len(near)) and bool(near.all(1).any())


def open_floor(room: Seen) -> float | None:
    """Diameter of the largest circle of free floor."""
    free = room.floor.difference(shapely.union_all([footprint(p) for p in standing(room)]))
    if free.is_empty:
        return 0.0
    return 2 * max(
        float(shapely.maximum_inscribed_circle(part, tolerance=0.02).length)
        for part in shapely.get_parts(free)
    )


def clearance(room: Seen) -> float | None:
    """Free floor before cupboards, desks and appliances as a share of what using them takes."""
    kinds, pieces = shipped().kinds, standing(room)
    shares = [
        min(
            free_before(
                p,
                [
                    footprint(q)
                    for q in pieces
                    if q is not p and p.category not in kinds[q.category].under
                ],
                room.floor,
            )
            / kinds[p.category].reach,
            1.0,
        )
        for p in pieces
        if kinds[p.category].access == ("front",) and p.category not in SEATS
    ]
    return float(np.mean(shares)) if shares else None


def _watching(room: Seen) -> tuple[Piece, Piece] | None:
    """The main seat and the screen."""
    seats, screens = _of(room, SOFAS) or _of(room, SEATS), _of(room, ("tv",))
    return (seats[0], screens[0]) if seats and screens else None


def viewing_distance(room: Seen) -> float | None:
    """From the main seat to the screen, in widths of the screen."""
    found = _watching(room)
    return _apart(*found) / found[1].size.width if found else None


def off_axis(room: Seen) -> float | None:
    """How far from the middle before the screen the main seat stands, seen from the screen."""
    found = _watching(room)
    return _off_front(found[1], found[0].pose.x, found[0].pose.y) if found else None


def turned_away(room: Seen) -> float | None:
    """How far one on the main seat turns the head to the screen."""
    found = _watching(room)
    return _off_front(found[0], found[1].pose.x, found[1].pose.y) if found else None


def _apart(one: Piece, other: Piece) -> float:
    return hypot(one.pose.x - other.pose.x, one.pose.y - other.pose.y)


def _off_front(piece: Piece, x: float, y: float) -> float:
    """Degrees between the front of a piece and the way to a point."""
    way = atan2(y - piece.pose.y, x - piece.pose.x)
    return degrees(abs(remainder(way - piece.pose.heading, 2 * pi)))


def conversation(room: Seen) -> float | None:
    """Mean distance from a seat to the nearest other."""
    seats = _of(room, SEATS)
    if len(seats) < 2:
        return None
    return float(np.mean([min(_apart(a, b) for b in seats if b is not a) for a in seats]))


def focal_point(room: Seen) -> float | None:
    """Share of the seats that look within 45 degrees at screen, fire or coffee table."""
    seats = _of(room, SEATS)
    points = next(
        (found for kind in ("tv", "fireplace", "coffee_table") if (found := _of(room, (kind,)))), []
    )
    if not seats or not points:
        return None
    x, y = points[0].pose.x, points[0].pose.y
    return float(np.mean([_off_front(seat, x, y) <= 45.0 for seat in seats]))


def balance(room: Seen) -> float | None:
    """From the middle of the room to that of all furniture, as a share of the root of its area."""
    shapes = [footprint(p) for p in standing(room)]
    if len(shapes) < 3:
        return None
    areas, middles = shapely.area(shapes), shapely.get_coordinates(shapely.centroid(shapes))
    x, y = areas @ middles / areas.sum()
    away = shapely.Point(x, y).distance(room.floor.centroid)
    return float(away / np.sqrt(room.floor.area))


def alignment(room: Seen) -> float | None:
    """Share of the pieces that stand parallel or square to a wall near them."""
    pieces = [p for p in standing(room) if p.size.width * p.size.depth > 0.1]
    walls = np.roll(room.space.outline, -1, 0) - room.space.outline
    ways = np.arctan2(walls[:, 1], walls[:, 0])
    square = [min(abs(remainder(p.pose.heading - way, pi / 2)) for way in ways) for p in pieces]
    return float(np.mean(np.array(square) < TURNED)) if pieces else None


def backs(room: Seen) -> float | None:
    """Share of cupboards, shelves and beds whose head or back is at a wall."""
    pieces = _of(room, STORES)
    at_wall = [room.floor.exterior.distance(_back(p)) < BACKED for p in pieces]
    return float(np.mean(at_wall)) if pieces else None


def _back(piece: Piece) -> shapely.Point:
    away = piece.size.depth / 2
    return shapely.Point(
        piece.pose.x - away * cos(piece.pose.heading), piece.pose.y - away * sin(piece.pose.heading)
    )


def furnished(room: Seen) -> float | None:
    """Share of the floor that the boxes of the groups cover."""
    return float(room.boxes[:, 3:].prod(-1).sum() / room.floor.area)


def desk_light(room: Seen) -> float | None:
    """From the desk to the nearest window; a table in a bedroom is a desk."""
    tables = ("dining_table",) if "bedroom" in room.space.functions else ()
    desks = _of(room, (*DESKS, *tables))
    panes = [_pane(g) for g in gates(room.space) if g.opening.kind == "window"]
    if not desks or not panes:
        return None
    return max(float(min(shapely.distance(footprint(d), panes))) for d in desks)


def _pane(gate: DoorApproach) -> shapely.LineString:
    """A window's breadth on the face of its wall."""
    ux, uy, half = gate.opening.ux, gate.opening.uy, gate.opening.width / 2
    x, y = gate.face
    return shapely.LineString([(x - half * ux, y - half * uy), (x + half * ux, y + half * uy)])


def windows(room: Seen) -> float | None:
    """Share of the floor before windows under something taller than the sill."""
    panes = [g for g in gates(room.space) if g.opening.kind == "window"]
    covered, whole = 0.0, 0.0
    for pane in panes:
        before = _pane(pane).buffer(WINDOW_DEPTH, cap_style="flat").intersection(room.floor)
        tall = [footprint(p) for p in standing(room) if p.size.height > pane.opening.sill + 0.04]
        covered += before.intersection(shapely.union_all(tall)).area
        whole += before.area
    return covered / whole if whole else None


def _sleeper(room: Seen) -> tuple[Piece, shapely.Point, list[shapely.Point]] | None:
    """The main bed, where its pillow is, and the doors."""
    beds = _of(room, BEDS)
    doors = [shapely.Point(g.face) for g in gates(room.space) if g.opening.kind == "door"]
    if not beds or not doors:
        return None
    bed, up = beds[0], beds[0].size.depth / 2 - 0.3
    head = shapely.Point(
        bed.pose.x - up * cos(bed.pose.heading), bed.pose.y - up * sin(bed.pose.heading)
    )
    return bed, head, doors


def door_in_sight(room: Seen) -> float | None:
    """How far one lying in the main bed turns the head to the door; 180 if it is hidden."""
    found = _sleeper(room)
    if not found:
        return None
    bed, head, doors = found
    door = min(doors, key=head.distance)
    line = shapely.LineString([head, door])
    hidden = any(
        p.size.height > TALL and p is not bed and footprint(p).intersection(line).length > 0.1
        for p in standing(room)
    )
    way = atan2(door.y - head.y, door.x - head.x)
    return 180.0 if hidden else degrees(abs(remainder(way - bed.pose.heading, 2 * pi)))


def away_from_door(room: Seen) -> float | None:
    """From the pillow to the nearest door as a share of the farthest the room allows."""
    found = _sleeper(room)
    if not found:
        return None
    _, head, doors = found
    door = min(doors, key=head.distance)
    return float(head.distance(door) / door.hausdorff_distance(room.floor))


def work_triangle(room: Seen) -> float | None:
    """Length of the way sink, hob, fridge and back."""
    corners = [_of(room, (kind,)) for kind in KITCHEN]
    if not all(corners):
        return None
    sink, hob, fridge = (found[0] for found in corners)
    return _apart(sink, hob) + _apart(hob, fridge) + _apart(fridge, sink)
