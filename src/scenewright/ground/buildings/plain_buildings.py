"""Draws a building known only by its footprint, height and tags.

By what it is where that has a look of its own (a church, a mosque, a warehouse) and its footprint
fills the model's box; else a plain building over its footprint, with its roof, in the style of the
country it stands in. Never by size alone: what is nearest in size may be a pavilion.
"""

from __future__ import annotations

from typing import NamedTuple

from scenewright.catalog.assets.buildings import house_looks
from scenewright.ground.buildings.use_words import use_of_word

STOREY, ROOF, SMALL = 3.0, 3.5, 400.0
"""Metres of a storey and of the roof over them, and floor area in square metres up to which a
building is drawn as a house."""
BLOCK, FLAT = "modern_residential", 3.2
"""What draws larger buildings; the height in metres up to which a roof is flat."""
FULL = 0.7
"""Share of its box that a footprint fills where a model of its own is drawn in that box."""


HEIGHTS = {
    3.0: "garage garages carport shed hut cabin greenhouse kiosk roof toilets",
    4.5: "barn stable cowshed sty farm_auxiliary bungalow",
    7.5: "house detached semidetached_house terrace farm yes",
    18.0: "church cathedral mosque",
}
"""Usual heights in metres of uses whose buildings say neither height nor storeys."""
SHED, SHED_HEIGHT = 40.0, 3.0
"""Square metres below which a building is a shed, and its height in metres."""


class Look(NamedTuple):
    """A model that buildings of some uses look like, and from which width, depth and height in
    metres they do."""

    asset: str
    uses: frozenset[str]
    least: tuple[float, float, float]


def _look(asset: str, uses: str, *least: float) -> Look:
    width, depth, height = least
    return Look(asset, frozenset(uses.split()), (width, depth, height))


LOOKS = (
    _look("gothic_church", "church cathedral basilica minster abbey", 12, 20, 9),
    _look("mosque", "mosque", 14, 14, 8),
    _look("buddhist_temple", "temple shrine", 10, 8, 5),
    _look("warehouse", "warehouse industrial factory hangar storage_tank depot", 15, 12, 4),
    _look("office_tower", "office commercial hotel", 15, 15, 45),
    _look("point_tower", "apartments residential", 14, 14, 45),
    _look("commercial_block", "commercial retail office hotel mall", 20, 15, 13),
    _look("gymnasium", "sports_hall sports_centre gymnasium", 25, 18, 7),
    _look("museum", "museum", 30, 20, 10),
)
"""Of several that fit the first is drawn."""


def plain_building(
    size: tuple[float, float, float], area: float, style: str = "", use: str = "", roof: str = ""
) -> str:
    """The id of the shipped asset for a building of width, depth and height in metres, m² of
    footprint, a style of houses, a use and the shape of its roof.

    >>> plain_building((9.0, 7.0, 8.0), 63.0), plain_building((40.0, 12.0, 18.0), 480.0)
    ('house_rural_gabled', 'modern_residential')
    >>> plain_building((18.0, 40.0, 25.0), 700.0, use="church")
    'gothic_church'
    >>> plain_building((6.0, 4.0, 3.0), 24.0, use="church", style="riviera")
    'house_riviera_flat'
    >>> plain_building((12.0, 8.0, 7.0), 96.0, use="bakery"), plain_building((12.0, 8.0, 7.0), 96.0,
    ...     use="retail", style="alpine")
    ('house_rural_gabled', 'shop_alpine_gabled')
    """
    for look in LOOKS:
        large = all(side >= least for side, least in zip(size, look.least, strict=True))
        if use in look.uses and large and area >= FULL * size[0] * size[1]:
            return look.asset
    row = house_looks.LOOKS.get(style, house_looks.LOOKS[house_looks.RURAL])
    if size[2] > STOREY * row.most + ROOF or area > SMALL:
        return BLOCK
    shape = roof or (row.roofs[0] if size[2] > FLAT else "flat")
    told = use_of_word(use) if area >= house_looks.SHED else None
    return house_looks.asset_of_house(house_looks.form_of_use(told or "dwelling"), style, shape)


def usual_height(use: str, area: float, otherwise: float) -> float:
    """The height in metres of a building of a use with m² of footprint that does not say.

    >>> usual_height("garage", 60.0, 9.0), usual_height("", 18.0, 9.0), usual_height("", 200.0, 9.0)
    (3.0, 3.0, 9.0)
    """
    known = [height for height, uses in HEIGHTS.items() if use in uses.split()]
    return known[0] if known else SHED_HEIGHT if area < SHED else otherwise


def fits_footprint(asset: str) -> bool:
    """Whether a shipped asset is drawn over any footprint, not only in its box.

    >>> fits_footprint("house_rural_gabled"), fits_footprint("gothic_church")
    (True, False)
    """
    return asset == BLOCK or house_looks.read_asset(asset) is not None


def style_at(where: tuple[float, float] | None) -> str:
    """The style of houses at a longitude and latitude; empty where none is known.

    >>> style_at((11.07, 49.45)), style_at((7.42, 43.73)), style_at((118.3, 29.9))
    ('', 'riviera', 'hui')
    """
    return "" if where is None else house_looks.style_of_region(*where)
