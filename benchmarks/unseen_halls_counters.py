"""Counters of a hall that are no rows: final pieces, floor and doors, with their own numbers.

Distances are between footprints. Every counter takes ``beyond``, metres by which its threshold is
moved to the strict side. What depends on how much stands there is counted apart where the brief
left numbers open (:attr:`Row.open`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import cos, hypot, sin
from typing import NamedTuple

import numpy as np
import shapely

from benchmarks.composition_faults import Count, Room, count_standing, shape_of
from scenewright.core.scene import Piece
from scenewright.core.space import Opening

CIRCLE, SMALL_HALL = 5.0, 1000.0
"""Metres across that may be empty in a hall smaller than this, in square metres."""
STEP = 0.25
"""Metres between the points at which floor is looked at."""
WALL_SHARE, AT_WALL, SERVED_BEHIND = 0.6, 0.3, 1.3
"""Share of a shop's walls that goods take; how far off these stand, and desks with staff behind."""
LONGEST_ROW, ROW_GAP = 12.0, 0.9
"""Metres of a row without an aisle across it, and the width of one."""
PITCH = (0.8, 1.1)
"""Metres from pew to pew."""
SEAT_AREA = {"canteen": 2.0, "restaurant": 2.4}
"""Square metres of the whole floor for each seat, at most."""
FILL = {"museum": 0.08, "bank": 0.08, "showroom": 0.1, "fair": 0.1, "boarding gate": 0.12}
USUAL_FILL = 0.18
"""Share of the floor that footprints cover, at least."""
ROLES = {
    "supermarket": (("checkout", "out", 6.0), ("ticket_gate", "in", 3.0)),
    "boarding gate": (("counter", "out", 5.0), ("ticket_gate", "out", 3.0)),
    "bank": (("cash_machine", "in", 6.0),),
}
USUAL_ROLES = (("info_desk", "in", 8.0), ("checkout", "out", 8.0))
"""What stands at doors people come in or go out by, and at most how far off, in metres."""
VISIBLE, TURNED, FREE = 6.0, -0.5, 0.6
"""Metres from an entrance at which backs are seen; the cosine of a front turned from it; how far
off walls what has a back stands free, in metres."""
PARADED = ("mannequin", "plinth", "round_rack", "display_table", "potted_tree", "exhibit_island")
MANY, ALIKE, SAME = 9, 0.8, 0.1
"""So many things are a formation where this share of them hangs together, each as far from a
neighbour as is usual among them, rounded to this length in metres."""
GOODS = (
    *("gondola", "book_stack", "clothes_rail", "wall_shelving", "bookcase", "lockers"),
    *("showcase", "display_cabinet", "fridge_shelf"),
)
SEATS = ("dining_chair", "reading_chair", "stool", "bar_stool", "auditorium_seat")
BACKED = ("wall_shelving", "bookcase", "sofa", "lounge_seat", "armchair")
DESKS = ("counter", "info_desk", "checkout")
SHOPS = ("clothes shop", "bookshop", "household shop", "jeweller", "supermarket", "mall shop")


class Hall(NamedTuple):
    """A furnished hall: its theme, whether its brief leaves numbers open, and its room."""

    theme: str
    open: bool
    room: Room


class Row(NamedTuple):
    """A counter: its name, its function, of what it counts, and whether it is of halls whose brief
    leaves numbers open only (False: of the others, None: of all)."""

    name: str
    faults: Callable[[Hall, float], Count]
    of: str = "halls"
    open: bool | None = None


def _tally(faults: Iterable[bool]) -> Count:
    seen = list(faults)
    return Count(sum(seen), len(seen))


def _doors(room: Room, way: str = "") -> list[shapely.LineString]:
    """Doors that people come ``in`` or go ``out`` by; all doors."""
    other = {"in": "exit", "out": "entrance"}.get(way)
    every = [o for o in room.space.openings if o.kind != "window"]
    used = [o for o in every if o.use != other] or every
    return [_doorway(o) for o in used]


def _doorway(door: Opening) -> shapely.LineString:
    dx, dy = door.ux * door.width / 2, door.uy * door.width / 2
    return shapely.LineString([(door.x - dx, door.y - dy), (door.x + dx, door.y + dy)])


def measure_fill(hall: Hall, beyond: float = 0.0) -> float:
    """The share of the floor that footprints cover, each ``beyond`` narrower."""
    shapes = [shape_of(p).buffer(-beyond / 2) for p in count_standing(hall.room)]
    return float(shapely.union_all(shapes).area / hall.room.floor.area)


def measure_circle(hall: Hall) -> float:
    """How wide the largest empty circle of floor is, in metres."""
    floor, standing = hall.room.floor, [shape_of(p) for p in count_standing(hall.room)]
    x0, y0, x1, y1 = floor.bounds
    grid = np.meshgrid(np.arange(x0, x1, STEP), np.arange(y0, y1, STEP))
    points = shapely.points(*(part.ravel() for part in grid))
    points = points[shapely.contains(floor, points)]
    tree = shapely.STRtree([floor.boundary, *standing])
    near = tree.query_nearest(points, return_distance=True, all_matches=False)[1]
    return float(2.0 * near.max(initial=0.0))


def measure_walls(hall: Hall, beyond: float = 0.0) -> float:
    """The share of the walls, without openings, at which something stands with its back."""
    room = hall.room
    holes = [_doorway(o).buffer(0.4, cap_style="square") for o in room.space.openings]
    wall = room.floor.exterior.difference(shapely.union_all(holes))
    standing = [p for p in count_standing(room) if p.category != "partition"]
    taken = wall.intersection(shapely.union_all([_behind(p, beyond) for p in standing]))
    return float(taken.length / max(wall.length, 1e-9))


def _behind(piece: Piece, beyond: float) -> shapely.Geometry:
    """A footprint drawn out backwards to the wall it may stand at."""
    far = (SERVED_BEHIND if piece.category in DESKS else AT_WALL) - beyond
    dx, dy = -far * cos(piece.pose.heading), -far * sin(piece.pose.heading)
    shape = shape_of(piece)
    return shapely.union(shape, shapely.affinity.translate(shape, dx, dy)).convex_hull


def count_seats(hall: Hall) -> int:
    """Chairs, and 0.5 m of a bench each."""
    benches = hall.room.find("bench", "pew")
    return len(hall.room.find(*SEATS)) + sum(int(b.size.width / 0.5 + 1e-6) for b in benches)


def little_fill(hall: Hall, beyond: float) -> Count:
    """Halls that look empty."""
    return _tally([measure_fill(hall, beyond) < FILL.get(hall.theme, USUAL_FILL)])


def bare_walls(hall: Hall, beyond: float) -> Count:
    """Shops with less than 60 per cent of their walls used."""
    if hall.theme not in SHOPS or not hall.room.find(*GOODS):
        return Count(0, 0)
    return _tally([measure_walls(hall, beyond) < WALL_SHARE])


def empty_circle(hall: Hall, beyond: float) -> Count:
    """Halls below 1,000 m² with a circle of 5 m of bare floor."""
    small = hall.room.floor.area < SMALL_HALL
    return _tally([measure_circle(hall) > CIRCLE - beyond] if small else [])


def roles_adrift(hall: Hall, beyond: float) -> Count:
    """Tills, gates and desks away from the doors they serve."""
    faults = []
    for kind, way, far in ROLES.get(hall.theme, USUAL_ROLES):
        ways = shapely.union_all(_doors(hall.room, way))
        mine = [shape_of(piece).distance(ways) for piece in hall.room.find(kind)]
        faults += [min(mine) > far - beyond] if mine else []
    return _tally(faults)


def long_rows(hall: Hall, beyond: float) -> Count:
    """Halls with a row of goods longer than 12 m without an aisle across it."""
    lengths = [length for kind in GOODS for length in _row_lengths(hall.room, kind)]
    return _tally([max(lengths) > LONGEST_ROW - beyond] if lengths else [])


def _row_lengths(room: Room, kind: str) -> list[float]:
    """Metres of the rows of a kind that stand free of walls."""
    mine = [p for p in room.find(kind) if shape_of(p).distance(room.floor.boundary) > FREE]
    found = []
    while mine:
        row = [mine.pop()]
        for piece in row:
            beside = [other for other in mine if _beside(piece, other)]
            mine = [other for other in mine if other not in beside]
            row += beside
        axis = np.array([-sin(row[0].pose.heading), cos(row[0].pose.heading)])
        at = [axis @ np.array([*p.pose[:2]]) for p in row]
        found.append(float(max(at) - min(at) + row[0].size.width))
    return found


def _beside(one: Piece, other: Piece) -> bool:
    """Whether two pieces stand in a row with less than an aisle between them."""
    dx, dy = other.pose.x - one.pose.x, other.pose.y - one.pose.y
    c, s = cos(one.pose.heading), sin(one.pose.heading)
    along, ahead = abs(-dx * s + dy * c), abs(dx * c + dy * s)
    gap = along - (one.size.width + other.size.width) / 2
    turned = abs(sin(one.pose.heading - other.pose.heading)) > 0.1
    return not turned and ahead < 0.5 * one.size.depth and gap < ROW_GAP


def pew_pitch(hall: Hall, beyond: float) -> Count:
    """Pews too near or far behind those before them, of those with some before them."""
    pews = hall.room.find("bench", "pew") if hall.theme == "church" else []
    pitches = [pitch for pew in pews if (pitch := _pitch(pew, pews)) is not None]
    low, high = PITCH[0] + beyond, PITCH[1] - beyond
    return _tally(not low - 1e-3 <= pitch <= high + 1e-3 for pitch in pitches)


def _pitch(pew: Piece, pews: list[Piece]) -> float | None:
    """Metres from a pew to the one before it, if that is nearer than 4 m."""
    c, s = cos(pew.pose.heading), sin(pew.pose.heading)
    steps = [(p.pose.x - pew.pose.x, p.pose.y - pew.pose.y) for p in pews if p is not pew]
    ahead = [dx * c + dy * s for dx, dy in steps if abs(-dx * s + dy * c) < 0.5 * pew.size.width]
    return min((far for far in ahead if 0.3 < far < 4.0), default=None)


def spacious_seats(hall: Hall, beyond: float) -> Count:
    """Halls to eat in with too much floor for each seat; each seat ``beyond`` wider and deeper."""
    most, seats = SEAT_AREA.get(hall.theme), count_seats(hall)
    if most is None:
        return Count(0, 0)
    return _tally([hall.room.floor.area > (most - beyond * 0.5) * max(seats, 1)])


def formations(hall: Hall, beyond: float) -> Count:
    """Kinds shown singly that stand in a regular grid all the same."""
    faults = []
    for kind in PARADED:
        mine = np.array([p.pose[:2] for p in hall.room.find(kind)]).reshape(-1, 2)
        if len(mine) >= MANY:
            far = np.hypot(*(mine[:, None] - mine[None]).transpose(2, 0, 1))
            near = float(np.median(np.sort(far, axis=1)[:, 1]))
            faults.append(_largest(far < near + SAME + beyond) >= ALIKE * len(mine))
    return _tally(faults)


def _largest(linked: np.ndarray) -> int:
    """How many of some things (n, n) hang together at most."""
    reach = linked.copy()
    for _ in range(len(reach).bit_length()):
        reach = (reach.astype(int) @ reach.astype(int)) > 0
    return int(reach.sum(1).max())


def backs_to_entrance(hall: Hall, beyond: float) -> Count:
    """Halls where a free-standing thing near an entrance turns its back to it."""
    ways = _doors(hall.room, "in")
    mine = hall.room.find(*BACKED, *DESKS)
    return _tally([any(_turns_back(hall.room, p, w, beyond) for p in mine for w in ways)])


def _turns_back(room: Room, piece: Piece, way: shapely.LineString, beyond: float) -> bool:
    shape, middle = shape_of(piece), way.centroid
    dx, dy = middle.x - piece.pose.x, middle.y - piece.pose.y
    ahead = dx * cos(piece.pose.heading) + dy * sin(piece.pose.heading)
    free = room.floor.boundary.distance(shapely.Point(_back(piece))) > FREE
    near = shape.distance(way) < VISIBLE + beyond
    return near and free and ahead < TURNED * hypot(dx, dy)


def _back(piece: Piece) -> tuple[float, float]:
    x, y, _, turn = piece.pose
    return x - cos(turn) * piece.size.depth / 2, y - sin(turn) * piece.size.depth / 2


COUNTERS: tuple[Row, ...] = (
    Row("little stands there, numbers open", little_fill, open=True),
    Row("little stands there, numbers stated", little_fill, open=False),
    Row("walls used under 60 per cent, numbers open", bare_walls, "shops", True),
    Row("walls used under 60 per cent, numbers stated", bare_walls, "shops", False),
    Row("empty circle over 5 m, numbers open", empty_circle, open=True),
    Row("empty circle over 5 m, numbers stated", empty_circle, open=False),
    Row("too much floor a seat, numbers open", spacious_seats, open=True),
    Row("too much floor a seat, numbers stated", spacious_seats, open=False),
    Row("role away from its door", roles_adrift, "roles"),
    Row("row over 12 m without an aisle", long_rows),
    Row("pitch of pews not 0.8 to 1.1 m", pew_pitch, "pews"),
    Row("formation", formations, "kinds"),
    Row("back to the entrance", backs_to_entrance),
)
"""The counters by name."""


def count_all(hall: Hall, beyond: float = 0.0) -> dict[str, Count]:
    """Every counter of a hall with its threshold moved ``beyond`` metres."""
    return {
        row.name: row.faults(hall, beyond) if row.open in (None, hall.open) else Count(0, 0)
        for row in COUNTERS
    }


def measure_all(hall: Hall) -> dict[str, float]:
    """Figures of a hall without thresholds."""
    figures = {"fill share": measure_fill(hall), "empty circle, m across": measure_circle(hall)}
    if hall.theme in SHOPS:
        figures["wall share of shops"] = measure_walls(hall)
    if hall.theme in SEAT_AREA and count_seats(hall):
        figures["m2 a seat"] = hall.room.floor.area / count_seats(hall)
    return figures
