"""Faults of composition in a furnished home: what nobody calls invalid and everyone sees.

Each fault is counted among what could have it: of living rooms those with too few seats, of double
beds those with one nightstand. Exact polygons of the final pieces; nothing here is asked during the
search.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from math import atan2, cos, degrees, hypot, pi, remainder, sin
from typing import NamedTuple

import numpy as np
import shapely

from benchmarks import composition_kitchen
from scenewright.building.door_approach import DoorApproach, gates
from scenewright.catalog.assets import shipped
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece
from scenewright.core.space import Space

HABITABLE = frozenset({"living", "bedroom", "study", "child_bedroom", "dining"})
SOFAS = ("sofa", "corner_sofa", "loveseat")
TABLES = ("dining_table", "round_table")
BASINS = ("basin", "pedestal_basin", "vanity")
LAMPS = ("ceiling_lamp", "pendant_lamp", "wall_lamp", "floor_lamp", "table_lamp", "desk_lamp")
HUNG = ("picture", "mirror", "wall_shelf", "wall_clock", "wall_cabinet")
SHADING = (*SOFAS, "armchair", "chest_of_drawers", "sideboard", "tv", "tv_stand", "single_bed")
SHADING_TOO = ("double_bed", "bunk_bed", "bookcase", "wardrobe", "shelf_unit")
TWO_SEATS = 1.9  # a sofa narrower than this seats two, metres
STRIP = 0.3  # depth of the floor before a window, metres
SLIDING = 0.3  # depth of the floor that a sliding door is walked through, metres
OVERLAP = 0.02  # of a strip before an opening that counts as stood in, metres
AT = 0.15  # nearer than this is at a wall, metres
BESIDE = 0.45  # free floor beside a bed from which one gets in, metres


class Room(NamedTuple):
    """A room: its space, its floor and what is in it."""

    space: Space
    floor: shapely.Polygon
    pieces: tuple[Piece, ...]

    def find(self, *categories: str) -> list[Piece]:
        """Its pieces of some categories."""
        return [p for p in self.pieces if p.category in categories]


Home = tuple[Room, ...]


class Count(NamedTuple):
    """How many have a fault, of how many that could."""

    faulty: int
    of: int


def list_rooms(spaces: Iterable[Space], pieces: Iterable[Piece]) -> Home:
    """The rooms of a home with what each holds."""
    held: dict[str, list[Piece]] = {}
    for piece in pieces:
        held.setdefault(piece.space, []).append(piece)
    return tuple(
        Room(s, shapely.Polygon(s.outline, list(s.holes)), tuple(held.get(s.id, ())))
        for s in spaces
    )


def _tally(faults: Iterable[bool]) -> Count:
    seen = list(faults)
    return Count(sum(seen), len(seen))


def _with(home: Home, functions: Iterable[str], area: float = 0.0) -> list[Room]:
    wanted = set(functions)
    return [r for r in home if wanted & set(r.space.functions) and r.floor.area >= area]


def shape_of(piece: Piece) -> shapely.Polygon:
    """The floor a piece covers."""
    return shapely.Polygon(outline_of(piece))


def count_standing(room: Room) -> list[Piece]:
    """What stands on the floor and is not flat."""
    kinds = shipped().kinds
    return [
        p
        for p in room.pieces
        if p.pose.z < 0.05 and kinds[p.category].support == "floor" and not kinds[p.category].flat
    ]


def no_table(home: Home) -> Count:
    """Homes with a living room or kitchen of 9 m² and no table to eat at."""
    if not _with(home, ("living", "kitchen"), 9.0):
        return Count(0, 0)
    return Count(int(not any(room.find(*TABLES) for room in home)), 1)


def count_seats(room: Room) -> int:
    """Places on sofas and armchairs."""
    places = {"corner_sofa": 4, "loveseat": 2, "armchair": 1}
    return sum(
        places.get(p.category, 2 if p.size.width < TWO_SEATS else 3)
        for p in room.find(*SOFAS, "armchair")
    )


def few_seats(home: Home) -> Count:
    """Living rooms of 14 m² and more with two seats or fewer."""
    return _tally(count_seats(room) <= 2 for room in _with(home, ("living",), 14.0))


def small_screen(home: Home) -> Count:
    """Screens watched from more than 3.2 times their width."""
    pairs = [
        (min(room.find("tv"), key=partial(_apart, seat)), seat)
        for room in home
        for seat in room.find(*SOFAS)[:1]
        if room.find("tv")
    ]
    return _tally(_apart(tv, seat) > 3.2 * tv.size.width for tv, seat in pairs)


def _apart(one: Piece, other: Piece) -> float:
    return hypot(one.pose.x - other.pose.x, one.pose.y - other.pose.y)


def sparse_room(home: Home) -> Count:
    """Living rooms of 9 m² and more of whose floor less than 22 % is under furniture."""
    return _tally(
        shapely.union_all([shape_of(p) for p in count_standing(room)]).area < 0.22 * room.floor.area
        for room in _with(home, ("living",), 9.0)
    )


def narrow_rug(home: Home) -> Count:
    """Rugs before a sofa that are no wider than it is."""
    return _tally(
        _extent(rug, sofa.pose.heading) <= sofa.size.width for sofa, rug in _rugs_of_sofas(home)
    )


def _rugs_of_sofas(home: Home) -> list[tuple[Piece, Piece]]:
    return [
        (sofa, rug)
        for room in home
        for sofa in room.find(*SOFAS)
        for rug in sorted(room.find("rug"), key=partial(_apart, sofa))[:1]
        if shape_of(rug).distance(shape_of(sofa)) < 0.5
    ]


def _extent(piece: Piece, heading: float) -> float:
    """Of a piece, across a heading."""
    turned = abs(sin(piece.pose.heading - heading)) > 0.7
    return piece.size.depth if turned else piece.size.width


def table_at_edge(home: Home) -> Count:
    """Coffee tables on a rug that stand nearer to its edge than 15 cm, or beyond it."""
    pairs = [
        (shape_of(rug), shape_of(table))
        for room in home
        for table in room.find("coffee_table")
        for rug in room.find("rug")
        if shape_of(rug).intersects(shape_of(table))
    ]
    return _tally(
        not rug.contains(table) or rug.exterior.distance(table) < 0.15 for rug, table in pairs
    )


def _windows(room: Room) -> list[DoorApproach]:
    return [g for g in gates(room.space) if g.opening.kind == "window" and not g.opening.roof]


def strip_before(gate: DoorApproach, depth: float) -> shapely.Polygon:
    """The floor before an opening, as wide as it is."""
    x, y = gate.face
    ux, uy = gate.opening.ux * gate.opening.width / 2, gate.opening.uy * gate.opening.width / 2
    dx, dy = gate.inward * depth
    return shapely.Polygon(
        [(x - ux, y - uy), (x + ux, y + uy), (x + ux + dx, y + uy + dy), (x - ux + dx, y - uy + dy)]
    )


def bare_window(home: Home) -> Count:
    """Windows of rooms one lives and sleeps in with neither curtain nor blind."""
    return _tally(
        not any(shape_of(p).distance(strip_before(gate, STRIP)) < 0.3 for p in hung)
        for room in _with(home, HABITABLE)
        for hung in (room.find("curtain", "blind"),)
        for gate in _windows(room)
    )


def before_window(home: Home) -> Count:
    """Windows with a sofa, chest, screen, bed, shelf or hob before them."""
    return _tally(
        any(_shades(p, gate) for p in room.pieces)
        for room in _with(home, (*HABITABLE, "kitchen"))
        for gate in _windows(room)
    )


def _shades(piece: Piece, gate: DoorApproach) -> bool:
    if piece.category not in (*SHADING, *SHADING_TOO, "hob_cabinet"):
        return False
    common = strip_before(gate, STRIP).intersection(shape_of(piece))
    return bool(common.area > 0.1 * STRIP)


def before_sliding_door(home: Home) -> Count:
    """Sliding doors with something before a part of them."""
    return _tally(
        shapely.union_all([shape_of(p) for p in count_standing(room)])
        .intersection(strip_before(gate, SLIDING))
        .area
        > OVERLAP * SLIDING
        for room in home
        for gate in gates(room.space)
        if gate.opening.kind == "door" and not gate.opening.hinge and gate.opening.width > 1.2
    )


def basins_together(home: Home) -> Count:
    """Homes in which two basins hang within 1.6 m of each other."""
    rooms = [room.find(*BASINS) for room in home]
    near = any(a is not b and _apart(a, b) < 1.6 for found in rooms for a in found for b in found)
    return Count(int(near), int(any(rooms)))


def shoes_everywhere(home: Home) -> Count:
    """Homes with shoe cabinets in several rooms."""
    rooms = sum(bool(room.find("shoe_cabinet")) for room in home)
    return Count(int(rooms > 1), int(rooms > 0))


def few_nightstands(home: Home) -> Count:
    """Double beds with fewer than two nightstands."""
    return _tally(
        sum(_apart(bed, n) < 1.8 for n in room.find("nightstand")) < 2
        for room in home
        for bed in room.find("double_bed")
    )


def _sides(bed: Piece, room: Room) -> tuple[float, float]:
    """Shares of free floor beside a bed from its middle to its foot, on either side."""
    taken = [shape_of(p) for p in count_standing(room) if p is not bed]
    free = room.floor.difference(shapely.union_all(taken))
    shares = []
    for side in (-1, 1):
        near, far = bed.size.width / 2 + 0.01, bed.size.width / 2 + BESIDE
        corners = [(near, 0.0), (far, 0.0), (far, bed.size.depth / 2), (near, bed.size.depth / 2)]
        strip = shapely.Polygon([_local(bed, side * x, y) for x, y in corners])
        shares.append(float(free.intersection(strip).area / strip.area))
    return shares[0], shares[1]


def _local(piece: Piece, x: float, y: float) -> tuple[float, float]:
    """A point ``x`` to the right and ``y`` ahead of the middle of a piece, in the plan."""
    c, s = cos(piece.pose.heading), sin(piece.pose.heading)
    return piece.pose.x + s * x + c * y, piece.pose.y - c * x + s * y


def one_sided_bed(home: Home) -> Count:
    """Double beds one gets into from one side only."""
    return _tally(min(_sides(bed, room)) < 0.9 for room in home for bed in room.find("double_bed"))


def bed_adrift(home: Home) -> Count:
    """Single beds of which no long side is at a wall."""
    return _tally(
        min(_side_gaps(bed, room)) > AT for room in home for bed in room.find("single_bed")
    )


def _side_gaps(bed: Piece, room: Room) -> list[float]:
    half, along = bed.size.width / 2, 0.3 * bed.size.depth
    walls = room.floor.exterior
    sides = [[_local(bed, s * half, y) for y in (-along, along)] for s in (-1, 1)]
    return [max(float(walls.distance(shapely.Point(p))) for p in side) for side in sides]


def narrow_wardrobe(home: Home) -> Count:
    """Wardrobes under a metre."""
    return _tally(p.size.width < 0.999 for room in home for p in room.find("wardrobe"))


def short_shelves(home: Home) -> Count:
    """Storage rooms whose shelves stand along less than 60 % of the longest wall."""
    return _tally(
        sum(p.size.width for p in room.find("storage_shelf")) < 0.6 * _longest_wall(room)
        for room in home
        if room.find("storage_shelf")
    )


def _longest_wall(room: Room) -> float:
    ring = room.space.outline
    return float(np.linalg.norm(np.roll(ring, -1, 0) - ring, axis=1).max())


def one_lamp(home: Home) -> Count:
    """Rooms of 12 m² and more that one lives in, with a single lamp."""
    return _tally(len(room.find(*LAMPS)) < 2 for room in _with(home, HABITABLE, 12.0))


def bare_walls(home: Home) -> Count:
    """Rooms of 8 m² and more that one lives in, with nothing on any wall."""
    return _tally(not room.find(*HUNG) for room in _with(home, HABITABLE, 8.0))


def armchair_alone(home: Home) -> Count:
    """Armchairs of rooms with a sofa that are no part of its group: further than 2.6 m from every
    sofa, or turned away from the middle of the group."""
    return _tally(
        all(_apart(chair, sofa) > 2.6 or _turned(chair, sofa) > 100 for sofa in room.find(*SOFAS))
        for room in home
        if room.find(*SOFAS)
        for chair in room.find("armchair")
    )


def _turned(chair: Piece, sofa: Piece) -> float:
    """Degrees by which one in the armchair turns the head to what the sofa looks at."""
    x, y = _local(sofa, 0.0, 0.9)
    way = atan2(y - chair.pose.y, x - chair.pose.x)
    return degrees(abs(remainder(way - chair.pose.heading, 2 * pi)))


FAULTS: dict[str, Callable[[Home], Count]] = {
    "no dining table": no_table,
    "two seats in a living room": few_seats,
    "screen too small": small_screen,
    "living room covered under 22 %": sparse_room,
    "worktop under 0.6 m": lambda home: _kitchens(home, composition_kitchen.short_worktop),
    "hob against the sink": lambda home: _kitchens(home, composition_kitchen.hob_at_sink),
    "hob at the end": lambda home: _kitchens(home, composition_kitchen.hob_at_end),
    "rug no wider than the sofa": narrow_rug,
    "coffee table at the rug's edge": table_at_edge,
    "window bare": bare_window,
    "something before a window": before_window,
    "something before a sliding door": before_sliding_door,
    "two basins within 1.6 m": basins_together,
    "shoe cabinets in several rooms": shoes_everywhere,
    "double bed with one nightstand": few_nightstands,
    "double bed from one side": one_sided_bed,
    "single bed adrift": bed_adrift,
    "wardrobe under 1.0 m": narrow_wardrobe,
    "shelves under 60 % of the wall": short_shelves,
    "one lamp in 12 m²": one_lamp,
    "bare walls": bare_walls,
    "armchair alone": armchair_alone,
}
"""The faults by name."""


def _kitchens(home: Home, fault: Callable[[list[Piece]], bool]) -> Count:
    rooms = [room for room in home if room.find("hob_cabinet") and room.find("sink_cabinet")]
    return _tally(fault(list(room.pieces)) for room in rooms)
