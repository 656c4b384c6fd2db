"""Groups of halls, storage rooms and studies: desk, shoes, coats, console, shelving."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.least_sizes import DESK, SHELF

SHELVES = (SHELF.depth, 0.3, 0.4)
"""Depths of shelving, metres; the least leaves the floor behind the door of a closet half a metre
deep free."""


def desk() -> Iterator[Group]:
    """A desk at the wall, its chair before it, a screen and a lamp on it."""
    for width, deep in (DESK[:2], (0.9, 0.5), (1.0, 0.55), (1.2, 0.6), (1.4, 0.65), (1.6, 0.7)):
        yield _desk("desk", width, deep, "office_chair", Size(0.58, 0.58, 0.95))


def corner_desk() -> Iterator[Group]:
    """A desk round the corner, its wing on either side; the chair stands in its nook, where a
    rectangle would have no floor left, with a screen before it and a lamp in the corner."""
    for width, deep in ((1.3, 1.2), (1.4, 1.3), (1.6, 1.4), (1.8, 1.5)):
        for model, side in (("corner_desk", 1.0), ("corner_desk_right", -1.0)):
            yield _corner_desk(model, side, width, deep)


def _corner_desk(model: str, side: float, width: float, deep: float) -> Group:
    leg, wing = min(0.7, 0.5 * deep), min(0.6, 0.45 * width)
    back, chair, lamp = -deep / 2, Size(0.58, 0.58, 0.95), Size(0.2, 0.24, 0.45)
    x, end = side * wing / 2, side * (0.13 - width / 2)
    members = (
        Member("corner_desk", 0, 0, 0, 0, Size(width, deep, 0.74), asset=model),
        Member("office_chair", x, back + leg - 0.2 + chair.depth / 2, 0, pi, chair),
        Member("desk_lamp", end, back + 0.18, 0.74, 0, lamp, on=0),
        Member("monitor", x, back + 0.2, 0.74, 0, Size(0.58, 0.2, 0.45), on=0),
    )
    return Group("corner_desk", f"{width:.1f} m corner desk", width, deep, members)


def kids_desk() -> Iterator[Group]:
    """A smaller desk with a chair."""
    for width in (DESK.width, 0.9, 1.0, 1.2):
        yield _desk("kids_desk", width, 0.55, "dining_chair", Size(0.44, 0.46, 0.8))


def _desk(function: str, width: float, deep: float, seat: str, chair: Size) -> Group:
    depth = deep + 0.55
    back = -depth / 2
    table = "desk" if function == "desk" else "kids_desk"
    screen = min(0.58, width - 0.42)
    members = [
        Member(table, 0, back + deep / 2, 0, 0, Size(width, deep, 0.74)),
        Member(seat, 0, back + deep - 0.2 + chair.depth / 2, 0, pi, chair),
        Member("desk_lamp", -width / 2 + 0.13, back + 0.18, 0.74, 0, Size(0.2, 0.24, 0.45), on=0),
    ]
    if function == "desk":
        size = Size(screen, 0.2, 0.45)
        members.append(Member("monitor", 0.12, back + 0.2, 0.74, 0, size, on=0))
    else:
        members.append(Member("books", width / 4, back + 0.2, 0.74, 0, Size(0.3, 0.2, 0.24), on=0))
    return Group(function, f"{width:.1f} m desk", width, depth, tuple(members))


def shoes() -> Iterator[Group]:
    """A shoe cabinet with a mirror above."""
    for width in (0.5, 0.6, 0.8, 1.0, 1.2):
        for depth in (0.22, 0.34):
            yield _shoes(width, depth)


def fitted_shoes() -> Iterator[Group]:
    """Shoe cabinets as wide as what is left of a wall, 0.5 to 1.8 m."""
    for width in range(5, 19):
        for depth in (0.22, 0.34):
            yield _shoes(width / 10, depth)


def _shoes(width: float, depth: float) -> Group:
    members = (
        Member("shoe_cabinet", 0, 0, 0, 0, Size(width, depth, 1.0)),
        Member("bowl", 0, 0, 1.0, 0, Size(0.2, 0.2, 0.08), on=0),
        Member("mirror", 0, 0.015 - depth / 2, 1.2, 0, Size(min(width, 0.6), 0.03, 0.8)),
    )
    return Group("shoes", f"{width:.1f} m shoe cabinet", width, depth + 0.01, members)


def coats() -> Iterator[Group]:
    """A coat rack."""
    for width in (0.4, 0.5):
        piece = Member("coat_rack", 0, 0, 0, 0, Size(width, width, 1.75))
        yield Group("coats", "coat rack", width, width, (piece,))


def console() -> Iterator[Group]:
    """A narrow console table with a vase and a picture above."""
    for width in (0.8, 1.0, 1.2):
        yield _console(width)


def fitted_consoles() -> Iterator[Group]:
    """Console tables as wide as what is left of a wall, 0.7 to 1.6 m; slim ones for corridors."""
    for width in range(7, 17):
        for depth in (0.22, 0.3):
            yield _console(width / 10, depth)


def _console(width: float, depth: float = 0.3) -> Group:
    members = (
        Member("console_table", 0, 0, 0, 0, Size(width, depth, 0.8)),
        Member("vase", width / 4, 0, 0.8, 0, Size(0.16, 0.16, 0.3), on=0),
        Member("picture", 0, 0.015 - depth / 2, 1.3, 0, Size(0.6, 0.03, 0.5)),
    )
    return Group("console", f"{width:.1f} m console", width, depth + 0.01, members)


def storage() -> Iterator[Group]:
    """Storage shelving, 0.4 to 3.0 m long."""
    for width in (SHELF.width, 0.5, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 2.0, 2.4, 3.0):
        for depth in SHELVES:
            yield _shelving(width, depth)


def fitted_storage() -> Iterator[Group]:
    """Shelving made to measure, 0.7 to 3.0 m long in steps of 0.1 m."""
    for width in range(7, 31):
        for depth in SHELVES:
            yield _shelving(width / 10, depth)


def fitted_shelving() -> Iterator[Group]:
    """Shelving from wall to wall, 0.5 to 3.6 m long in steps of 0.05 m."""
    for width in range(10, 73):
        for depth in SHELVES:
            yield _shelving(width / 20, depth)


def _shelving(width: float, depth: float) -> Group:
    count = max(1, round(width / 1.0))
    each = width / count
    members = tuple(
        Member("storage_shelf", (i - (count - 1) / 2) * each, 0, 0, 0, Size(each, depth, 1.9))
        for i in range(count)
    )
    return Group("storage", f"{width:.1f} m of shelving", width, depth + 0.01, members)
