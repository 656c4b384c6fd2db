"""Counters of a home that are no rows: only the final pieces, the rooms and their openings.

No rule of a solver is asked and no number of one is used, so that a layout cannot pass for having
been made to. Every counter takes ``beyond``, metres by which its threshold is moved to the strict
side: a home made to fit a threshold shows in the difference. Distances are between footprints.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import cos, hypot, pi, sin
from typing import NamedTuple

import numpy as np
import shapely

from benchmarks.composition_faults import Count, Home, Room, shape_of
from scenewright.core.scene import Piece
from scenewright.core.space import Opening

TABLES = ("dining_table", "round_table")
SOFT = ("sofa", "corner_sofa", "loveseat", "armchair")
SEATS = (*SOFT, "dining_chair", "office_chair", "stool", "bar_stool", "bench", "pouf")
PLACES = ("dining_chair", "stool", "bar_stool", "bench")
SLEEPERS = {"double_bed": 2, "bunk_bed": 2, "single_bed": 1}
RUN = (
    *("sink_cabinet", "hob_cabinet", "base_cabinet", "drawer_cabinet", "corner_cabinet"),
    *("tall_cabinet", "oven_cabinet", "dishwasher", "fridge", "filler_panel"),
)
STRANGERS = ("wardrobe", "shoe_cabinet", "desk", "kids_desk", "corner_desk", "tv", "tv_stand")

PLACE = 0.6
"""Metres of a table's or bench's edge for one who eats there (Neufert)."""
PULLED = 0.5
"""A chair further than this from every table is none to eat at, in metres."""
WARDROBE, CABINET, SINK = 0.5, 0.3, 0.5
"""Least depth of a wardrobe (hangers are 0.45 m wide), least widths of cabinet and sink."""
ACROSS = 0.35
"""Least depth of a wardrobe with rails from front to back, to which hangers are square."""
SMALLEST = {
    "bed": (("single_bed", "double_bed", "bunk_bed"), 0.8, 1.9),
    "desk": (("desk", "kids_desk"), 0.8, 0.5),
    "chest": (("chest_of_drawers",), 0.6, 0.38),
    "shelf": (("bookcase", "storage_shelf"), 0.4, 0.19),
    "basin": (("basin", "pedestal_basin"), 0.45, 0.3),
}
"""What else serves nobody when smaller: kinds, width and depth in metres."""
AT_RUN, AT_UNIT = 0.1, 0.3
"""What stands nearer to a kitchen run is butted to it; a sofa nearer than that is in its way."""
SCREEN, PILLOW, COLD = 1.5, 0.5, 0.5
"""Least distance of eyes and screen; how deep pillows lie; how near a fridge may hum."""
DOOR = 1.0
"""A bed nearer to the front door is beside it."""
SOFT_FROM = 20.0
"""Floor from which a home has a soft seat, in square metres."""

Counter = Callable[[Home, float], Count]


class Row(NamedTuple):
    """A counter: its name, its function, and of what it counts."""

    name: str
    faults: Counter
    of: str


def tally(faults: Iterable[bool]) -> Count:
    seen = list(faults)
    return Count(sum(seen), len(seen))


def _all(home: Home, *kinds: str) -> list[Piece]:
    return [piece for room in home for piece in room.find(*kinds)]


def _area(home: Home) -> float:
    return float(sum(room.floor.area for room in home if "balcony" not in room.space.functions))


def count_sleepers(home: Home) -> int:
    """How many a home beds."""
    return sum(SLEEPERS[bed.category] for bed in _all(home, *SLEEPERS))


def _holds(piece: Piece, long: float, short: float) -> bool:
    return max(piece.size[:2]) >= long - 1e-6 and min(piece.size[:2]) >= short - 1e-6


def without_table(home: Home, beyond: float) -> Count:
    """Homes without a table of 0.8 by 0.6 m to eat at."""
    tables = _all(home, *TABLES)
    return tally([not any(_holds(t, 0.8 + beyond, 0.6 + beyond) for t in tables)])


def without_any_table(home: Home, _beyond: float) -> Count:
    """Homes without a table to eat at, however small."""
    return tally([not _all(home, *TABLES)])


def without_seat(home: Home, _beyond: float) -> Count:
    """Homes in which nobody can sit."""
    return tally([not _all(home, *SEATS)])


def without_soft_seat(home: Home, beyond: float) -> Count:
    """Homes of 20 m² without a soft seat 0.6 m wide."""
    if _area(home) < SOFT_FROM:
        return Count(0, 0)
    return tally([not any(s.size.width >= PLACE + beyond - 1e-6 for s in _all(home, *SOFT))])


def count_places(home: Home, beyond: float = 0.0) -> int:
    """Chairs and stools at a table, and 0.6 m of a bench each, at most as many as its edge has."""
    return sum(_places(room, table, beyond) for room in home for table in room.find(*TABLES))


def _places(room: Room, table: Piece, beyond: float) -> int:
    width, depth, _ = table.size
    edge = 2 * (width + depth) if table.category == "dining_table" else pi * width
    others = [shape_of(t) for t in room.find(*TABLES) if t is not table]
    at = [
        seat
        for seat in room.find(*PLACES)
        if (far := shape_of(seat).distance(shape_of(table))) <= PULLED - beyond
        and far <= min(map(shape_of(seat).distance, others), default=far)
    ]
    seats = sum(int(s.size.width / PLACE + 1e-6) if s.category == "bench" else 1 for s in at)
    return min(seats, int(edge / PLACE + 1e-6))


def too_few_places(home: Home, beyond: float) -> Count:
    """Homes with beds in which fewer can eat at a table than sleep."""
    sleepers = count_sleepers(home)
    return tally([count_places(home, beyond) < sleepers] if sleepers else [])


def _has_rails_across(piece: Piece) -> bool:
    return piece.asset == "wardrobe_shallow"


def shallow_wardrobe(home: Home, beyond: float) -> Count:
    """Wardrobes too shallow for a hanger, along them or, with rails from front to back, across."""
    return tally(
        p.size.depth < (ACROSS if _has_rails_across(p) else WARDROBE) + beyond - 1e-6
        for p in _all(home, "wardrobe")
    )


def rails_across(home: Home, _beyond: float) -> Count:
    """Wardrobes with rails from front to back: those of the usual depth had no place."""
    return tally(map(_has_rails_across, _all(home, "wardrobe")))


def below(name: str) -> Counter:
    """A counter of pieces smaller than one of :data:`SMALLEST`."""
    kinds, width, depth = SMALLEST[name]

    def count(home: Home, beyond: float) -> Count:
        return tally(
            p.size.width < width + beyond - 1e-6 or p.size.depth < depth + beyond - 1e-6
            for p in _all(home, *kinds)
        )

    return count


def homes_shallow_wardrobe(home: Home, beyond: float) -> Count:
    """Homes with a wardrobe too shallow for a hanger, of those with one."""
    faulty, of = shallow_wardrobe(home, beyond)
    return Count(min(faulty, 1), min(of, 1))


def narrow_cabinet(home: Home, beyond: float) -> Count:
    """Drawer cabinets that are filler strips."""
    return tally(p.size.width < CABINET + beyond - 1e-6 for p in _all(home, "drawer_cabinet"))


def narrow_sink(home: Home, beyond: float) -> Count:
    """Sinks in which no pan goes."""
    return tally(p.size.width < SINK + beyond - 1e-6 for p in _all(home, "sink_cabinet"))


def _near(ones: list[Piece], others: list[Piece], limit: float) -> bool:
    return any(shape_of(a).distance(shape_of(b)) < limit - 1e-6 for a in ones for b in others)


def butted_run(home: Home, beyond: float) -> Count:
    """Kitchens against whose run a wardrobe, shoes, a desk or a screen stands."""
    kitchens = [room for room in home if room.find(*RUN)]
    near = AT_RUN + beyond
    return tally(_near(room.find(*STRANGERS), room.find(*RUN), near) for room in kitchens)


def sofa_at_unit(home: Home, beyond: float) -> Count:
    """Kitchens with a soft seat so near a unit that it cannot be used."""
    kitchens = [room for room in home if room.find(*RUN) and room.find(*SOFT)]
    near = AT_UNIT + beyond
    return tally(_near(room.find(*SOFT), room.find(*RUN), near) for room in kitchens)


def fridge_between(home: Home, beyond: float) -> Count:
    """Kitchens in which the straight way from sink to hob leads through the fridge."""
    faults = []
    for room in home:
        sinks, hobs, fridges = map(room.find, ("sink_cabinet", "hob_cabinet", "fridge"))
        ways = [shapely.LineString([a.pose[:2], b.pose[:2]]) for a in sinks for b in hobs]
        cold = [shape_of(fridge).buffer(beyond) for fridge in fridges if fridge.size.height > 1.0]
        if ways and cold:
            faults.append(any(way.intersects(one) for way in ways for one in cold))
    return tally(faults)


def pillow_of(bed: Piece) -> shapely.Polygon:
    """Where the pillows of a bed lie: the strip along its back."""
    x, y, _, heading = bed.pose
    ahead, side = np.array([cos(heading), sin(heading)]), np.array([sin(heading), -cos(heading)])
    back = np.array([x, y]) - ahead * bed.size.depth / 2
    half = side * bed.size.width / 2
    deep = ahead * PILLOW
    return shapely.Polygon([back - half, back + half, back + half + deep, back - half + deep])


def pillow_at_fridge(home: Home, beyond: float) -> Count:
    """Rooms with bed and fridge in which a pillow lies beside the fridge."""
    rooms = [room for room in home if room.find("fridge") and room.find(*SLEEPERS)]
    return tally(
        pillow_of(bed).distance(shape_of(fridge)) < COLD + beyond - 1e-6
        for room in rooms
        for bed in room.find(*SLEEPERS)
        for fridge in room.find("fridge")
    )


def _sees(seat: Piece, screen: Piece) -> bool:
    """Whether a seat looks at a screen, to within 60 degrees."""
    dx, dy = screen.pose.x - seat.pose.x, screen.pose.y - seat.pose.y
    along = dx * cos(seat.pose.heading) + dy * sin(seat.pose.heading)
    return along > 0.5 * hypot(dx, dy)


def _eyes_to(seat: Piece, screen: Piece) -> float:
    """From the line on which people sit to the middle of a screen."""
    x, y, _, heading = seat.pose
    wide = max(seat.size.width / 2 - 0.3, 0.0)
    side = np.array([sin(heading), -cos(heading)]) * wide
    at = np.array([x, y])
    line = shapely.LineString([at - side, at + side]) if wide else shapely.Point(at)
    return float(line.distance(shapely.Point(screen.pose[:2])))


def screen_too_near(home: Home, beyond: float) -> Count:
    """Screens nearer than 1.5 m to the nearest soft seat that looks at them."""
    faults = []
    for room in home:
        for screen in room.find("tv"):
            far = [_eyes_to(seat, screen) for seat in room.find(*SOFT) if _sees(seat, screen)]
            faults += [min(far) < SCREEN + beyond - 1e-6] if far else []
    return tally(faults)


def bed_at_front_door(home: Home, beyond: float) -> Count:
    """Rooms that one enters from outside and sleeps in, with a bed beside that door."""
    faults = []
    for room in home:
        doors = [o for o in room.space.openings if o.kind == "door" and len(o.spaces) < 2]
        beds = room.find(*SLEEPERS)
        ways = [_doorway(door) for door in doors]
        near = [shape_of(bed).distance(way) < DOOR + beyond for bed in beds for way in ways]
        faults += [any(near)] if near else []
    return tally(faults)


def _doorway(door: Opening) -> shapely.LineString:
    x, y, ux, uy, half = door.x, door.y, door.ux, door.uy, door.width / 2
    return shapely.LineString([(x - ux * half, y - uy * half), (x + ux * half, y + uy * half)])


COUNTERS: tuple[Row, ...] = (
    Row("no table", without_any_table, "homes"),
    Row("no table of 0.8 x 0.6 m", without_table, "homes"),
    Row("no seat", without_seat, "homes"),
    Row("no soft seat from 20 m2", without_soft_seat, "homes"),
    Row("fewer places to eat than sleepers", too_few_places, "homes"),
    Row("wardrobe under 0.5 m deep", shallow_wardrobe, "wardrobes"),
    Row("home with a wardrobe under 0.5 m deep", homes_shallow_wardrobe, "homes"),
    Row("drawer cabinet under 0.3 m wide", narrow_cabinet, "cabinets"),
    Row("sink under 0.5 m wide", narrow_sink, "sinks"),
    Row("wardrobe with rails across", rails_across, "wardrobes"),
    *(
        Row(f"{name} under {width:g} x {depth:g} m", below(name), f"{name}s")
        for name, (_, width, depth) in SMALLEST.items()
    ),
    Row("butted kitchen run", butted_run, "kitchens"),
    Row("soft seat at a unit", sofa_at_unit, "kitchens"),
    Row("fridge between sink and hob", fridge_between, "kitchens"),
    Row("pillow beside a fridge", pillow_at_fridge, "beds"),
    Row("screen nearer than 1.5 m", screen_too_near, "screens"),
    Row("bed beside the front door", bed_at_front_door, "rooms"),
)
"""The counters by name."""


def count_all(
    home: Home, beyond: float = 0.0, rows: tuple[Row, ...] = COUNTERS
) -> dict[str, Count]:
    """Every counter of a home with its threshold moved ``beyond`` metres.

    >>> count_all(())["wardrobe under 0.5 m deep"]
    Count(faulty=0, of=0)
    """
    return {row.name: row.faults(home, beyond) for row in rows}
