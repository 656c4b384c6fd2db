"""Groups of a living room: media, seating, reading corner, shelves, sideboard, plant."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import ceil, cos, pi, sin

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size

SOFA_DEPTH, SOFA_HEIGHT = 0.9, 0.8
OUT = 0.6  # how far an armchair is turned out of its corner, radians
WAY_TO_SEAT = 0.62  # the way in between a sofa and the armchair beside its table, metres
BETWEEN = 0.68  # the same where armchairs on both sides leave no other way, metres
HUNG, BOARD = 0.55, 0.15  # where the shelf below a screen on the wall is, and its height, metres
STEP_IN = 0.4  # how far a sofa reaches beyond its table at each end, so that one gets to it, metres


def media() -> Iterator[Group]:
    """A TV on its stand, 0.9 to 2.4 m wide; wide ones carry a plant beside the screen."""
    for width in (0.9, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.2, 2.4):
        screen = min(1.45, max(0.75, width - 0.35))
        members = [
            Member("tv_stand", 0, 0, 0, 0, Size(width, 0.4, 0.45)),
            Member("tv", 0, -0.02, 0.45, 0, Size(screen, 0.22, screen * 0.62), on=0),
        ]
        if width - screen > 0.6:
            x = (width + screen) / 4 + 0.02
            members.append(Member("plant", x, 0, 0.45, 0, Size(0.22, 0.22, 0.4), on=0))
        yield Group("media", f"TV on a {width:.1f} m stand", width, 0.42, tuple(members))


def hung_screens() -> Iterator[Group]:
    """A TV over a narrow shelf on the wall, for walls before which no stand has a place."""
    for width in (0.9, 1.2, 1.4):
        screen = Size(width - 0.1, 0.12, 0.62 * (width - 0.1))
        members = (
            Member("wall_shelf", 0, 0, HUNG, 0, Size(width, 0.16, BOARD)),
            Member("tv", 0, 0, HUNG + BOARD, 0, screen, on=0),
        )
        yield Group("media", f"TV on the wall over a {width:.1f} m shelf", width, 0.18, members)


def low_board(width: float) -> Group:
    """A low cabinet on the floor of a stand of that width, with a vase and a lamp."""
    members = (
        Member("sideboard", 0, 0, 0, 0, Size(width, 0.4, 0.7)),
        Member("vase", -width / 2 + 0.2, 0, 0.7, 0, Size(0.16, 0.16, 0.3), on=0),
        Member("table_lamp", width / 2 - 0.22, 0, 0.7, 0, Size(0.28, 0.28, 0.48), on=0),
    )
    return Group("media", f"{width:.1f} m low cabinet", width, 0.42, members)


def seating() -> Iterator[Group]:
    """A sofa and coffee table on a rug, with armchairs or a lamp table where there is room."""
    yield _alone(1.2)
    yield _alone(1.4)
    yield _compact(1.2)
    for sofa in (1.4, 1.6, 1.8, 2.0, 2.2, 2.4):
        if sofa <= 1.8:
            yield _compact(sofa)
        yield _sofa_and_table(sofa, lamps=0)
        if sofa >= 1.6:
            yield _sofa_and_table(sofa, lamps=1)
        if sofa >= 1.8:
            yield _sofa_and_table(sofa, lamps=2)
            yield _one_armchair(sofa)
        if sofa >= 2.0:
            yield _two_armchairs(sofa)


def more_seats() -> Iterator[Group]:
    """Sofas for three for rooms in which no group with one stands: before a small table or
    beside a side table."""
    for sofa in (2.0, 1.9):
        yield _compact(sofa)
    for sofa in (2.0, 1.9):
        yield _alone(sofa)


def seats_for_many() -> Iterator[Group]:
    """What seats three to five on little floor: those of :func:`more_seats`, armchairs in line with
    a sofa, a corner sofa with a side table."""
    yield from more_seats()
    for sofa, chairs in ((1.9, 1), (2.0, 2)):
        yield _in_line(sofa, chairs)
    for wide, deep in ((2.1, 1.45), (2.3, 1.6)):
        members = (
            Member("corner_sofa", -0.21, 0, 0, 0, Size(wide, deep, SOFA_HEIGHT)),
            Member("side_table", wide / 2, 0.2 - deep / 2, 0, 0, Size(0.4, 0.4, 0.5)),
        )
        name = f"{wide:.1f} m corner sofa, side table"
        yield Group("seating", name, wide + 0.42, deep, members)


def corner_sofas() -> Iterator[Group]:
    """Corner sofas of four seats, the table in the nook of the L on a rug, the lounge on either
    side; wide ones with an armchair at the open side of the table."""
    for wide, deep in ((2.2, 1.6), (2.4, 1.65), (2.6, 1.7)):
        for model, side in (("corner_sofa", 1.0), ("corner_sofa_right", -1.0)):
            yield _corner(model, side, wide, deep, armchair=False)
            yield _corner(model, side, wide, deep, armchair=True)


def further_seats() -> Iterator[Group]:
    """Seats tried where a room is composed: :func:`more_seats` and :func:`corner_sofas`."""
    yield from more_seats()
    yield from corner_sofas()


def _corner(model: str, side: float, wide: float, deep: float, armchair: bool) -> Group:
    """One with its lounge on the left (``side`` 1) or on the right (-1)."""
    seat, lounge = min(0.95, 0.7 * deep), min(1.0, 0.42 * wide)
    nook = wide - lounge
    table = Size(min(0.8, nook - 0.55), 0.55, 0.4)
    depth = max(deep, seat + 0.35 + table.depth + 0.1)
    more = WAY_TO_SEAT + 0.8 - 0.3 if armchair else 0.0
    width, back = wide + more, -depth / 2
    x = -side * more / 2
    middle = x + side * lounge / 2
    at = back + seat + 0.35 + table.depth / 2
    members = [
        Member("corner_sofa", x, back + deep / 2, 0, 0, Size(wide, deep, SOFA_HEIGHT), asset=model),
        Member("coffee_table", middle, at, 0, 0, table),
        Member("rug", x, back + depth / 2 + 0.27, 0, 0, Size(wide, depth - 0.55, 0.012)),
    ]
    if armchair:
        end = side * (width / 2 - 0.4)
        y = depth / 2 - 0.4
        members.append(Member("armchair", end, y, 0, side * pi / 2, Size(0.78, 0.8, 0.85)))
    members.append(_picture_above(depth, x, wide))
    words = " and an armchair" if armchair else ""
    name = f"{wide:.1f} m corner sofa, table{words}"
    return Group("seating", name, width, depth, tuple(members))


def _in_line(sofa: float, chairs: int) -> Group:
    """A sofa, a side table and one or two armchairs along one wall."""
    armchair, table = Size(0.78, 0.8, 0.85), Size(0.4, 0.4, 0.5)
    parts = [("sofa", Size(sofa, 0.8, SOFA_HEIGHT)), ("side_table", table)]
    parts += [("armchair", armchair)]
    if chairs > 1:
        parts = [("armchair", armchair), ("side_table", table), *parts]
    width = sum(size.width + 0.04 for _, size in parts)
    members, left = [], -width / 2
    for name, size in parts:
        at = left + 0.02 + size.width / 2
        members.append(Member(name, at, size.depth / 2 - 0.42, 0, 0, size))
        left += size.width + 0.04
    words = "an armchair" if chairs == 1 else "two armchairs"
    return Group("seating", f"{sofa:.1f} m sofa, {words} in line", width, 0.84, tuple(members))


def _sofa(width: float, depth: float, x: float = 0.0) -> Member:
    category = "sofa" if width >= 1.7 else "loveseat"
    return Member(category, x, -depth / 2 + 0.45, 0, 0, Size(width, SOFA_DEPTH, SOFA_HEIGHT))


def _table(width: float, depth: float, x: float = 0.0, deep: float = 0.55) -> Member:
    y = -depth / 2 + SOFA_DEPTH + 0.35 + deep / 2
    return Member("coffee_table", x, y, 0, 0, Size(width, deep, 0.4))


def _beside_legs(share: float, sofa: float) -> float:
    """Width of a table before a sofa: a share of it that leaves a step in at each end."""
    return min(share * sofa, sofa - 2 * STEP_IN)


def _rug(width: float, depth: float, x: float = 0.0) -> Member:
    deep = depth - 0.55
    return Member("rug", x, depth / 2 - deep / 2, 0, 0, Size(width, deep, 0.012))


def _alone(sofa: float) -> Group:
    """A sofa with a side table, for rooms with no depth for more."""
    width, depth = sofa + 0.42, 0.82
    members = (
        Member("sofa" if sofa >= 1.7 else "loveseat", -0.21, 0, 0, 0, Size(sofa, 0.8, SOFA_HEIGHT)),
        Member("side_table", sofa / 2, -0.1, 0, 0, Size(0.4, 0.4, 0.5)),
    )
    return Group("seating", f"{sofa:.1f} m sofa, side table", width, depth, members)


def _compact(sofa: float) -> Group:
    depth = SOFA_DEPTH + 0.35 + 0.42
    members = (
        _sofa(sofa, depth),
        _table(_beside_legs(0.45, sofa), depth, deep=0.4),
        _rug(sofa, depth),
    )
    return Group("seating", f"{sofa:.1f} m sofa, small table", sofa, depth, members)


def _sofa_and_table(sofa: float, lamps: int) -> Group:
    width, depth = sofa + 0.5 * lamps, 1.95
    x = -0.25 if lamps == 1 else 0.0
    members = [
        _sofa(sofa, depth, x),
        _table(_beside_legs(0.55, sofa), depth, x),
        _rug(sofa, depth, x),
    ]
    for sign in (1, -1)[:lamps]:
        side = len(members)
        at = x + sign * (sofa / 2 + 0.26)
        members += [
            Member("side_table", at, -depth / 2 + 0.3, 0, 0, Size(0.42, 0.42, 0.5)),
            Member("table_lamp", at, -depth / 2 + 0.3, 0.5, 0, Size(0.28, 0.28, 0.48), on=side),
        ]
    members.append(_picture_above(depth, x, sofa))
    tables = ("", " and a lamp table", " between lamp tables")[lamps]
    return Group("seating", f"{sofa:.1f} m sofa, table{tables}", width, depth, tuple(members))


def _armchair(x: float, depth: float, heading: float) -> Member:
    y = depth / 2 - 0.41
    return Member("armchair", x, y, 0, heading, Size(0.78, 0.8, 0.85))


def _one_armchair(sofa: float) -> Group:
    table, depth = 0.5 * sofa, SOFA_DEPTH + WAY_TO_SEAT + 0.8
    reach = table / 2 + 0.3 + 0.8
    width = sofa / 2 + max(reach, sofa / 2)
    x = sofa / 2 - width / 2
    members = (
        _sofa(sofa, depth, x),
        _table(table, depth, x),
        _rug(min(table + 1.0, sofa), depth, x),
        _armchair(x + reach - 0.4, depth, pi / 2),
        _picture_above(depth, x, sofa),
    )
    return Group("seating", f"{sofa:.1f} m sofa and an armchair", width, depth, members)


def _two_armchairs(sofa: float) -> Group:
    table, depth = 0.5 * sofa, SOFA_DEPTH + BETWEEN + 0.8
    reach = table / 2 + 0.3 + 0.8
    width = 2 * max(reach, sofa / 2)
    members = (
        _sofa(sofa, depth),
        _table(table, depth),
        _rug(table + 1.2, depth),
        _armchair(reach - 0.4, depth, pi / 2),
        _armchair(0.4 - reach, depth, -pi / 2),
        _picture_above(depth, 0, sofa),
    )
    return Group("seating", f"{sofa:.1f} m sofa and two armchairs", width, depth, members)


def _picture_above(depth: float, x: float, over: float) -> Member:
    wide = round(min(1.4, over * 0.55), 2)
    return Member("picture", x, -depth / 2 + 0.02, 1.25, 0, Size(wide, 0.04, wide * 0.6))


def reading() -> Iterator[Group]:
    """An armchair with a floor lamp: square to the wall, or turned out of its corner."""
    lamp, seat = Size(0.36, 0.36, 1.55), Size(0.78, 0.8, 0.85)
    for side, name in ((1, ""), (-1, ", the lamp left")):
        members = (
            Member("armchair", -side * 0.22, 0, 0, 0, seat),
            Member("floor_lamp", side * 0.42, -0.18, 0, 0, lamp),
        )
        yield Group("reading", f"armchair and floor lamp{name}", 1.24, 0.82, members)
        members = (
            Member("armchair", -side * 0.13, 0.03, 0, side * OUT, seat),
            Member("floor_lamp", side * 0.5, -0.42, 0, 0, lamp),
        )
        yield Group("reading", f"armchair turned out, floor lamp{name}", 1.36, 1.2, members)


def talking() -> Iterator[Group]:
    """Two armchairs with a lamp table between them on a rug: turned to one another, face to face,
    side by side."""
    seat, table = Size(0.78, 0.8, 0.85), Size(0.42, 0.42, 0.5)
    for turn, apart, name in (
        (0.4, 0.82, "turned in"),
        (pi / 2, 0.95, "face to face"),
        (0, 0.68, ""),
    ):
        width = 2 * (apart + abs(cos(turn)) * seat.width / 2 + sin(turn) * seat.depth / 2)
        depth = seat.depth + 0.22 * (0 < turn < 1)
        members = (
            Member("armchair", -apart, 0, 0, -turn, seat),
            Member("armchair", apart, 0, 0, turn, seat),
            Member("side_table", 0, -0.1 if turn < 1 else 0, 0, 0, table),
            Member("table_lamp", 0, -0.1 if turn < 1 else 0, 0.5, 0, Size(0.28, 0.28, 0.48), on=2),
            Member("rug", 0, 0.3 if turn < 1 else 0, 0, 0, Size(width - 0.3, 1.5, 0.012)),
        )
        words = f"two armchairs {name}".rstrip()
        yield Group("reading", f"{words}, lamp table", width + 0.02, depth + 0.02, members)


def shelf() -> Iterator[Group]:
    """Bookcases, alone or in a row."""
    for width in (0.6, 0.8, 1.0, 1.2, 1.6, 2.0, 2.4):
        yield _bookcases(width, 1 if width <= 1.2 else 2)


def fitted_bookcases() -> Iterator[Group]:
    """Rows of bookcases as wide as what is left of a wall, 0.6 to 3.6 m."""
    for width in range(6, 37):
        yield _bookcases(width / 10, ceil(width / 12))


def deep_bookcases() -> Iterator[Group]:
    """The same 0.32 and, as in stores, 0.4 m deep."""
    for depth, width in product((0.32, 0.4), range(6, 37)):
        yield _bookcases(width / 10, ceil(width / 12), depth)


def _bookcases(width: float, count: int, depth: float = 0.32) -> Group:
    each = width / count
    members = tuple(
        Member("bookcase", (i - (count - 1) / 2) * each, 0, 0, 0, Size(each, depth, 2.0))
        for i in range(count)
    )
    return Group("shelf", f"{width:.1f} m of bookcase", width, depth + 0.01, members)


def sideboard() -> Iterator[Group]:
    """A sideboard with a vase and a lamp, a picture above."""
    for width in (1.0, 1.2, 1.4, 1.6, 1.8):
        members = (
            Member("sideboard", 0, 0, 0, 0, Size(width, 0.42, 0.78)),
            Member("vase", -width / 2 + 0.2, 0, 0.78, 0, Size(0.16, 0.16, 0.3), on=0),
            Member("table_lamp", width / 2 - 0.22, 0, 0.78, 0, Size(0.28, 0.28, 0.48), on=0),
            Member("picture", 0, -0.2, 1.3, 0, Size(width * 0.5, 0.04, 0.5)),
        )
        yield Group("sideboard", f"{width:.1f} m sideboard", width, 0.44, members)


def plant() -> Iterator[Group]:
    """A tree in a pot."""
    for width, height in ((0.4, 1.1), (0.5, 1.5), (0.6, 1.7)):
        tree = Member("potted_tree", 0, 0, 0, 0, Size(width, width, height))
        yield Group("plant", "potted tree", width + 0.04, width + 0.04, (tree,))
