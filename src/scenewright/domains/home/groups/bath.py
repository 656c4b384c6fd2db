"""Groups of bathrooms, toilets and washrooms."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.groups.sleeping import DEPTHS
from scenewright.domains.home.least_sizes import HAND_BASIN


def toilet() -> Iterator[Group]:
    """A toilet with elbow room on both sides."""
    for width in (0.6, 0.7, 0.8):
        piece = Member("toilet", 0, 0, 0, 0, Size(0.38, 0.66, 0.78))
        yield Group("toilet", "toilet", width, 0.67, (piece,))
    for width, depth in ((0.56, 0.56), (0.5, 0.5)):
        piece = Member("toilet", 0, 0, 0, 0, Size(0.36, depth, 0.76))
        yield Group("toilet", "short toilet", width, depth + 0.01, (piece,))


def basin() -> Iterator[Group]:
    """A wash basin, on a cabinet where wide enough, with its mirror."""
    width, depth, _ = HAND_BASIN
    yield _basin(width, depth + 0.01, f"{width:.2f} m hand basin")
    for width, depth in ((0.5, 0.42), (0.6, 0.46), (0.8, 0.48), (1.0, 0.5), (1.2, 0.5)):
        yield _basin(width, depth, f"{width:.1f} m basin")


def fitted_basins() -> Iterator[Group]:
    """Wash basins as wide as what is left of a wall, 0.45 to 1.2 m."""
    for width in range(9, 25):
        depth = 0.33 if width < 10 else 0.42 if width < 12 else 0.46 if width < 16 else 0.5
        yield _basin(width / 20, depth, f"{width / 20:.2f} m basin")


def _basin(width: float, depth: float, name: str) -> Group:
    category = "basin" if width >= 0.6 else "pedestal_basin"
    members = (
        Member(category, 0, 0, 0, 0, Size(width, depth - 0.01, 0.88)),
        Member("mirror", 0, 0.02 - depth / 2, 1.15, 0, Size(width - 0.05, 0.03, 0.75)),
    )
    return Group("basin", name, width, depth, members)


def bath() -> Iterator[Group]:
    """A bathtub along the wall."""
    for width, depth in ((1.2, 0.7), (1.4, 0.7), (1.5, 0.7), (1.6, 0.75), (1.7, 0.75), (1.8, 0.8)):
        tub = Member("bathtub", 0, 0, 0, 0, Size(width, depth, 0.58))
        yield Group("bath", f"{width:.1f} m bath", width, depth, (tub,))


def fitted_baths() -> Iterator[Group]:
    """Bathtubs from wall to wall, 1.25 to 1.9 m long."""
    for depth in (0.7, 0.75, 0.8):
        for width in range(25, 39):
            tub = Member("bathtub", 0, 0, 0, 0, Size(width / 20, depth, 0.58))
            yield Group("bath", f"{width / 20:.2f} m bath", width / 20, depth, (tub,))


def shower() -> Iterator[Group]:
    """A shower tray with its screen."""
    for width, depth in ((0.7, 0.7), (0.8, 0.8), (0.9, 0.9), (1.2, 0.8)):
        tray = Member("shower", 0, 0, 0, 0, Size(width, depth, 2.0))
        yield Group("shower", f"{width:.1f} m shower", width, depth, (tray,))


def fitted_showers() -> Iterator[Group]:
    """Showers made to measure for a niche, 0.7 to 1.4 m wide."""
    for depth in (0.7, 0.8, 0.9):
        for width in range(14, 29):
            tray = Member("shower", 0, 0, 0, 0, Size(width / 20, depth, 2.0))
            yield Group("shower", f"{width / 20:.2f} m shower", width / 20, depth, (tray,))


def washer() -> Iterator[Group]:
    """A washing machine, with a dryer beside it where there is room."""
    machine = Size(0.6, 0.6, 0.85)
    yield Group(
        "washer", "washing machine", 0.62, 0.64, (Member("washing_machine", 0, 0, 0, 0, machine),)
    )
    yield Group(
        "washer",
        "small washing machine",
        0.5,
        0.5,
        (Member("washing_machine", 0, 0, 0, 0, Size(0.48, 0.48, 0.85)),),
    )
    pair = (
        Member("washing_machine", -0.31, 0, 0, 0, machine),
        Member("dryer", 0.31, 0, 0, 0, machine),
    )
    yield Group("washer", "washing machine and dryer", 1.24, 0.64, pair)


def fitted_machines() -> Iterator[Group]:
    """Washing machines as they stand between walls and cabinets, without room beside them."""
    for name, side in (("washing machine", 0.6), ("small washing machine", 0.48)):
        piece = Member("washing_machine", 0, 0, 0, 0, Size(side, side, 0.85))
        yield Group("washer", name, side, side + 0.01, (piece,))


def linen() -> Iterator[Group]:
    """A tall bathroom cabinet, or a laundry basket."""
    for width in (0.4, 0.6):
        piece = Member("bathroom_cabinet", 0, 0, 0, 0, Size(width, 0.34, 1.7))
        yield Group("linen", "bathroom cabinet", width, 0.35, (piece,))


def fitted_cabinets() -> Iterator[Group]:
    """Tall bathroom cabinets as wide as what is left of a wall, 0.4 to 1.0 m, and deep ones
    that end nearly where a bath beside them does."""
    for deep, width in product((0.34, 0.6), range(8, 21)):
        wide = width / 20
        piece = Member("bathroom_cabinet", 0, 0, 0, 0, Size(wide, deep, 1.7))
        yield Group("linen", f"{wide:.2f} m bathroom cabinet", wide, deep + 0.01, (piece,))


def fitted_closets() -> Iterator[Group]:
    """Wardrobes of bathrooms as wide as what is left of a wall, 0.45 to 1.2 m."""
    for deep, width in product(DEPTHS, range(9, 25)):
        wide = width / 20
        piece = Member("wardrobe", 0, 0, 0, 0, Size(wide, deep, 2.0))
        yield Group("wardrobe", f"{wide:.2f} m wardrobe", wide, deep + 0.01, (piece,))


def basket() -> Iterator[Group]:
    """A laundry basket."""
    piece = Member("laundry_basket", 0, 0, 0, 0, Size(0.4, 0.36, 0.55))
    yield Group("basket", "laundry basket", 0.42, 0.38, (piece,))
