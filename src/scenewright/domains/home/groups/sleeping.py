"""Groups of bedrooms: beds with their nightstands, wardrobes, chests, vanities, play corner."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.least_sizes import BED, DOUBLE_BED, WARDROBE
from scenewright.text import quantity

BED_LENGTH = 2.05
SHORT_BED = DOUBLE_BED.depth
"""A mattress of 140 x 190 cm without a footboard, metres."""
NARROW = 0.34  # room for a narrow nightstand, metres
DEPTHS = (WARDROBE.depth, 0.6)
"""Depths of wardrobes, metres."""


def sleeping() -> Iterator[Group]:
    """A double bed: both sides open with nightstands, or one side for the tightest rooms."""
    for bed in (1.4, 1.6, 1.8):
        for wing in (0.45, 0.5, 0.6, 0.7):
            yield _bed("sleeping", "double_bed", bed, wing, wing)
        if bed < 1.8:
            yield _bed("sleeping", "double_bed", bed, 0.0, 0.62)
            yield _bed("sleeping", "double_bed", bed, 0.0, 0.62, mirrored=True)


def single() -> Iterator[Group]:
    """A single bed, one long side free to get in, with a nightstand where it fits."""
    for bed, length in (BED[:2], (0.9, 2.05), (1.0, 2.05), (1.2, 2.05)):
        yield _bed("single", "single_bed", bed, 0.0, 0.0, length)
        for wing in (0.45, 0.62):
            yield _bed("single", "single_bed", bed, 0.0, wing, length)
            yield _bed("single", "single_bed", bed, 0.0, wing, length, mirrored=True)


def along_wall() -> Iterator[Group]:
    """Single beds with a long side at the wall, the pillow at either end, with a nightstand beside
    the pillow where it fits."""
    for bed, length in ((0.9, 2.05), (1.0, 2.05), BED[:2]):
        for stand in (0.45, 0.0):
            for side in (1.0, -1.0):
                yield _along(bed, length, stand, side)


def _along(bed: float, length: float, stand: float, side: float) -> Group:
    """A bed with its pillow on the right (``side`` 1) or the left (-1)."""
    depth, turn = bed + stand + 0.01, side * pi / 2
    members = [Member("single_bed", 0, -stand / 2, 0, turn, Size(bed, length, 0.9))]
    if stand:
        x, y = side * (length / 2 - 0.2), depth / 2 - 0.21
        members += [
            Member("nightstand", x, y, 0, turn, Size(0.42, 0.4, 0.5)),
            Member("table_lamp", x, y, 0.5, 0, Size(0.24, 0.24, 0.42), on=1),
        ]
    return Group("single", f"{bed:.1f} m bed along the wall", length, depth, tuple(members))


def narrow_sides() -> Iterator[Group]:
    """Double beds with a narrow nightstand on one side or both, where two usual ones have no
    place, and short beds (:data:`SHORT_BED`) past whose foot one walks where a longer one bars the
    way."""
    for bed in (1.4, 1.6):
        yield _bed("sleeping", "double_bed", bed, NARROW, 0.5)
        yield _bed("sleeping", "double_bed", bed, NARROW, 0.5, mirrored=True)
        yield _bed("sleeping", "double_bed", bed, NARROW, NARROW)
    for wing in (0.45, NARROW):
        yield _bed("sleeping", "double_bed", 1.4, wing, wing, SHORT_BED)


def bunk() -> Iterator[Group]:
    """A bunk bed with a toy box at its foot side."""
    bed = Member("bunk_bed", 0, 0, 0, 0, Size(1.0, BED_LENGTH, 1.65))
    yield Group("bunk", "bunk bed", 1.0, BED_LENGTH + 0.02, (bed,))


def _bed(
    function: str,
    category: str,
    bed: float,
    left: float,
    right: float,
    length: float = BED_LENGTH,
    mirrored: bool = False,
) -> Group:
    width, depth = bed + left + right, length + 0.03
    back = -depth / 2
    x = left + bed / 2 - width / 2
    members = [Member(category, x, back + length / 2, 0, 0, Size(bed, length, 0.9))]
    if min(left, right) >= 0.45:
        members.append(Member("rug", x, depth / 2 - 0.7, 0, 0, Size(width - 0.1, 1.4, 0.012)))
    for sign, wing in ((-1, left), (1, right)):
        wide = 0.3 if wing == NARROW else 0.42
        at = x + sign * (bed / 2 + 0.02 + wide / 2)
        members += _nightstand(at, back, len(members), wide) if wing else []
    if category == "double_bed":
        members.append(Member("picture", x, back + 0.02, 1.35, 0, Size(1.0, 0.04, 0.6)))
    if mirrored:
        members = [m._replace(x=-m.x, heading=-m.heading) for m in members]
    stands = (left > 0) + (right > 0)
    return Group(
        function, f"{bed:.1f} m bed, {quantity(stands, 'nightstand')}", width, depth, tuple(members)
    )


def _nightstand(x: float, back: float, index: int, wide: float = 0.42) -> list[Member]:
    return [
        Member("nightstand", x, back + 0.22, 0, 0, Size(wide, 0.4, 0.5)),
        Member("table_lamp", x, back + 0.2, 0.5, 0, Size(0.24, 0.24, 0.42), on=index),
    ]


def wardrobe() -> Iterator[Group]:
    """Wardrobes from 0.6 to 3.0 m, in steps of 0.2 m, of both depths."""
    for width in (0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.4, 2.8):
        for depth in DEPTHS:
            piece = Member("wardrobe", 0, 0, 0, 0, Size(width, depth, 2.2))
            yield Group("wardrobe", f"{width:.1f} m wardrobe", width, depth + 0.01, (piece,))


def fitted_wardrobes() -> Iterator[Group]:
    """Wardrobes made to measure, 1.0 to 3.0 m wide in steps of 0.1 m, of both depths."""
    for width in range(10, 31):
        for depth in DEPTHS:
            piece = Member("wardrobe", 0, 0, 0, 0, Size(width / 10, depth, 2.2))
            name = f"{width / 10:.1f} m fitted wardrobe"
            yield Group("wardrobe", name, width / 10, depth + 0.01, (piece,))


def chest() -> Iterator[Group]:
    """A chest of drawers with a mirror above it and a bowl on it."""
    for width in (0.6, 0.8, 1.0, 1.2):
        members = (
            Member("chest_of_drawers", 0, 0, 0, 0, Size(width, 0.45, 0.85)),
            Member("vase", width / 4, 0, 0.85, 0, Size(0.16, 0.16, 0.28), on=0),
            Member("mirror", 0, -0.21, 1.15, 0, Size(min(width, 0.7), 0.03, 0.7)),
        )
        yield Group("chest", f"{width:.1f} m chest of drawers", width, 0.46, members)


def vanity() -> Iterator[Group]:
    """A vanity with a stool before it and a mirror above."""
    for width in (0.8, 1.0):
        members = (
            Member("vanity", 0, -0.26, 0, 0, Size(width, 0.42, 0.75)),
            Member("stool", 0, 0.12, 0, pi, Size(0.38, 0.38, 0.45)),
            Member("mirror", 0, -0.455, 0.95, 0, Size(0.6, 0.03, 0.8)),
        )
        yield Group("vanity", f"{width:.1f} m vanity", width, 0.95, members)


def play() -> Iterator[Group]:
    """A child's corner: low shelf and toy box in a row."""
    for width in (0.8, 1.2, 1.5):
        shelf = min(width, 0.9)
        members = [Member("shelf_unit", shelf / 2 - width / 2, 0, 0, 0, Size(shelf, 0.35, 1.0))]
        if width > shelf + 0.25:
            wide = width - shelf - 0.05
            members.append(Member("toy_box", width / 2 - wide / 2, 0, 0, 0, Size(wide, 0.35, 0.42)))
        yield Group("play", f"{width:.1f} m of toys", width, 0.36, tuple(members))
