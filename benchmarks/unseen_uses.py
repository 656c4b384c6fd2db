"""Counters of how a home is used: its screen, its kitchen's ends, its laundry, doors and chairs.

As :mod:`benchmarks.unseen_counters`: final pieces, rooms and openings alone, no number of a row.
"""

from __future__ import annotations

from math import cos, hypot, sin

import shapely

from benchmarks.composition_faults import SOFAS, Count, Home, Room, count_standing, shape_of
from benchmarks.unseen_counters import TABLES, Row, tally
from scenewright.core.scene import Piece

AXIS, TURNED = 0.35, 0.87
"""Metres a screen may be aside of the axis of a seat of its sofa, and the least cosine of the angle
at which either looks at the other (30 degrees: the eyes turn, the head does not)."""
PANE = 0.3
"""A screen nearer than this before a window, along its back, is dazzled."""
LANDING = 0.3
"""Metres of worktop beside a hob, on either side (NKBA 17: 12 and 15 inches; 0.3 m is 12)."""
TALL = 1.2
"""What is as high stands in the way of an elbow."""
LAUNDRY_FROM = 30.0
"""Floor from which a home washes its clothes, in square metres."""
OPENED = {
    **dict.fromkeys(("wardrobe",), 0.55),
    **dict.fromkeys(("chest_of_drawers", "sideboard", "shoe_cabinet"), 0.45),
    **dict.fromkeys(("bookcase", "storage_shelf"), 0.4),
}
"""Metres before a front, from which it is opened and one reaches in."""
CLOSET = 2.0
"""One reaches into a smaller room through its door, in square metres."""
SHARE = 0.15
"""Of that floor may be taken."""
TINY = {"wardrobe": 0.75, "chest_of_drawers": 0.6, "sideboard": 0.75, "bookcase": 0.55}
"""Narrower is hardly worth its floor, in metres."""
PULLED = 0.5
"""Metres behind a chair to draw it back and sit down."""
LEFT = 0.1
"""What may be missing of a side's width where a chair is drawn back."""
SEATS = ("dining_chair", "stool")
TOPS = ("dishwasher", "filler_panel", "washing_machine", "fridge", "kitchen_island")
"""What carries worktop beside cabinets, where it is low."""


def _ahead(piece: Piece, far: float, shrink: float = 0.04, back: bool = False) -> shapely.Polygon:
    """The floor ``far`` metres before or behind a piece, as wide as it is less ``shrink``."""
    x, y, _, turn = piece.pose
    sign = -1.0 if back else 1.0
    c, s = cos(turn), sin(turn)
    half, near = max(piece.size.width / 2 - shrink, 0.05), piece.size.depth / 2
    corners = ((near, -half), (near, half), (near + far, half), (near + far, -half))
    return shapely.Polygon(
        [(x + sign * a * c - b * s, y + sign * a * s + b * c) for a, b in corners]
    )


def _find_pair(room: Room) -> tuple[Piece | None, Piece | None]:
    """The largest sofa and the screen of a room."""
    sofas = sorted(room.find(*SOFAS), key=lambda p: -p.size.width * p.size.depth)
    screens = room.find("tv")
    return (sofas[0] if sofas else None), (screens[0] if screens else None)


def _off(one: Piece, other: Piece) -> tuple[float, float]:
    """How far another piece is ahead of one, and aside of it."""
    dx, dy = other.pose.x - one.pose.x, other.pose.y - one.pose.y
    c, s = cos(one.pose.heading), sin(one.pose.heading)
    return dx * c + dy * s, abs(dx * s - dy * c)


def off_axis(home: Home, beyond: float) -> Count:
    """Rooms with sofa and screen in which the screen is off the sofa's axis, or turned from it."""
    faults = []
    for room in home:
        sofa, screen = _find_pair(room)
        if sofa is None or screen is None:
            continue
        ahead, aside = _off(sofa, screen)
        back, _ = _off(screen, sofa)
        far = hypot(ahead, aside) or 1.0
        faults.append(aside > AXIS - beyond or ahead < TURNED * far or back < TURNED * far)
    return tally(faults)


def no_screen(home: Home, _beyond: float) -> Count:
    """Living rooms with a sofa and nothing it looks at: no screen, no fireplace."""
    rooms = [r for r in home if "living" in r.space.functions and r.find(*SOFAS)]
    return tally(not r.find("tv", "fireplace") for r in rooms)


def screen_at_window(home: Home, beyond: float) -> Count:
    """Screens with a window right behind them."""
    faults = []
    for room in home:
        windows = [o for o in room.space.openings if o.kind == "window"]
        panes = [
            shapely.LineString(
                [(o.x - o.ux * o.width / 2, o.y - o.uy * o.width / 2),
                 (o.x + o.ux * o.width / 2, o.y + o.uy * o.width / 2)]
            )
            for o in windows
        ]  # fmt: skip
        for tv in room.find("tv"):
            behind = _ahead(tv, PANE + 0.3 + beyond, 0.1, back=True)
            faults.append(any(behind.intersects(pane) for pane in panes))
    return tally(faults)


def no_landing(home: Home, beyond: float) -> Count:
    """Kitchens whose hob has a wall, a tall unit or an end within 0.3 m of either side."""
    faults = []
    for room in home:
        ground = _tops(room)
        for hob in room.find("hob_cabinet"):
            faults.append(any(not _has_landing(hob, side, ground, beyond) for side in (-1.0, 1.0)))
    return tally(faults)


def _tops(room: Room) -> shapely.Geometry:
    """Where worktop lies in a room, hobs and sinks apart."""
    wet = ("hob_cabinet", "sink_cabinet")
    units = [p for p in room.pieces if p.category.endswith("_cabinet") or p.category in TOPS]
    low = [p for p in units if p.pose.z < 0.2 and p.size.height < TALL and p.category not in wet]
    return shapely.union_all([shape_of(p).buffer(0.02) for p in low])


def _has_landing(hob: Piece, side: float, tops: shapely.Geometry, beyond: float) -> bool:
    x, y, _, turn = hob.pose
    c, s = cos(turn), sin(turn)
    wide, half = LANDING + beyond - 0.01, hob.size.width / 2
    corners = ((-0.2, half), (0.2, half), (0.2, half + wide), (-0.2, half + wide))
    strip = shapely.Polygon(
        [(x + a * c + side * b * s, y + a * s - side * b * c) for a, b in corners]
    )
    return strip.intersection(tops).area > 0.9 * strip.area


def sink_at_end(home: Home, beyond: float) -> Count:
    """Kitchens whose sink has worktop of 0.3 m on neither side."""
    faults = []
    for room in home:
        ground = _tops(room)
        for sink in room.find("sink_cabinet"):
            faults.append(not any(_has_landing(sink, side, ground, beyond) for side in (-1.0, 1.0)))
    return tally(faults)


def no_laundry(home: Home, _beyond: float) -> Count:
    """Homes of 30 m² without a washing machine."""
    area = sum(r.floor.area for r in home if "balcony" not in r.space.functions)
    wet = any({"bathroom", "washroom", "kitchen"} & set(r.space.functions) for r in home)
    if area < LAUNDRY_FROM or not wet:
        return Count(0, 0)
    return tally([not any(r.find("washing_machine") for r in home)])


def cupboard_shut(home: Home, beyond: float) -> Count:
    """Cupboards and shelves whose floor in front is taken, by a wall or furniture."""
    faults = []
    for room in home:
        if room.floor.area < CLOSET:
            continue
        standing = [p for p in count_standing(room) if p.category not in (*SEATS, "office_chair")]
        for p in room.find(*OPENED):
            if p.pose.z > 0.1:
                continue
            floor = _ahead(p, OPENED[p.category] + beyond)
            others = shapely.union_all([shape_of(o) for o in standing if o is not p])
            free = floor.intersection(room.floor).difference(others).area
            faults.append(free < (1 - SHARE) * floor.area)
    return tally(faults)


def cupboard_tiny(home: Home, beyond: float) -> Count:
    """Cupboards too narrow to be worth their floor."""
    pieces = [p for r in home for p in r.find(*TINY) if p.pose.z < 0.1]
    return tally(p.size.width < TINY[p.category] + beyond - 1e-6 for p in pieces)


def chair_jammed(home: Home, beyond: float) -> Count:
    """Tables at which a chair cannot be drawn back by half a metre."""
    faults = []
    for room in home:
        standing = count_standing(room)
        for table in room.find(*TABLES):
            seats = [s for s in room.find(*SEATS) if shape_of(s).distance(shape_of(table)) < 0.5]
            if seats:
                faults.append(any(_is_jammed(s, room, standing, beyond) for s in seats))
    return tally(faults)


def _is_jammed(seat: Piece, room: Room, standing: list[Piece], beyond: float) -> bool:
    floor = _ahead(seat, PULLED + beyond, LEFT, back=True)
    others = shapely.union_all([shape_of(o) for o in standing if o is not seat])
    return bool(floor.intersection(room.floor).difference(others).area < (1 - SHARE) * floor.area)


USES: tuple[Row, ...] = (
    Row("screen off the axis of its sofa", off_axis, "screens"),
    Row("screen before a window", screen_at_window, "screens"),
    Row("sofa that looks at nothing", no_screen, "living rooms"),
    Row("hob without 0.3 m on both sides", no_landing, "hobs"),
    Row("sink without 0.3 m on either side", sink_at_end, "sinks"),
    Row("no washing machine from 30 m2", no_laundry, "homes"),
    Row("cupboard that cannot be opened", cupboard_shut, "cupboards"),
    Row("cupboard hardly wider than a door", cupboard_tiny, "cupboards"),
    Row("table with a chair that is jammed", chair_jammed, "tables"),
)
"""The counters by name."""
