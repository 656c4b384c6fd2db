"""The table of regional styles of houses, and of the forms that their uses give them.

Every style is one row: roofs and their pitch, storeys, walls, windows, the width of its lanes,
what encloses its plots, and where in the world it is built.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from scenewright.catalog.assets.materials import (
    BLUSH,
    BRICK,
    GREY,
    LIMESTONE,
    MASONRY,
    OAK_DARK,
    OCHRE,
    PLASTER,
    RENDER,
    SAGE,
    SANDSTONE,
    SLATE,
    STONE,
    TEAK,
    TILES,
    TILES_DARK,
    TIMBER,
    WALNUT,
    WHITE,
)
from scenewright.core.brief.uses import UseName
from scenewright.core.catalog import Material

Roof = Literal["gabled", "hipped", "flat"]
Entrance = Literal["door", "byre", "gate", "shop", "portal"]
Enclosing = Literal["hedge", "stone", "white"]
Region = tuple[float, float, float, float]
RURAL = "rural"
"""The style where no other is named or known."""
SHED = 45.0
"""Square metres below which a building is no dwelling: a gate, no windows nor chimney."""


class WindowLook(NamedTuple):
    """How windows look: the width of a bay, width and height of a window, its sill above the floor
    in metres, and whether it has shutters."""

    bay: float
    wide: float
    tall: float
    sill: float
    shutters: bool


class HouseLook(NamedTuple):
    """A style: materials of ``walls`` (one is picked by size), roof and shutters, the rise of a
    roof by half its span, the overhang of the eaves in metres, and its windows; ``base`` is the
    material of the ground floor and ``frame`` of beams on the walls above, if they differ;
    ``balcony`` whether the front has one; ``roofs`` its usual forms, the first the most usual;
    ``storeys`` those of its two-storeyed houses in turn, ``most`` a house has; ``lane`` and
    ``street``: metres of a laid lane and of one along street sides where none is drawn; what
    encloses plots; ``regions``: west, south, east and north in degrees."""

    walls: tuple[Material, ...]
    roof: Material
    shutters: Material
    pitch: float
    overhang: float
    windows: WindowLook
    base: Material | None = None
    frame: Material | None = None
    trim: Material = WHITE
    wood: Material = TIMBER
    balcony: bool = False
    roofs: tuple[Roof, ...] = ("gabled",)
    storeys: tuple[int, ...] = (2,)
    most: int = 3
    lane: float = 3.6
    street: float = 4.4
    enclosed: Enclosing = "hedge"
    regions: tuple[Region, ...] = ()


LOOKS: dict[str, HouseLook] = {
    "rural": HouseLook(
        (RENDER, RENDER, OCHRE), TILES, TIMBER, 0.85, 0.35, WindowLook(2.7, 0.95, 1.25, 0.95, True)
    ),
    "riviera": HouseLook(
        (OCHRE, BLUSH, SANDSTONE, RENDER),
        TILES,
        SAGE,
        0.42,
        0.25,
        WindowLook(2.9, 0.9, 1.45, 0.85, True),
        lane=3.0,
        enclosed="stone",
        regions=((-10.0, 34.0, 36.5, 44.3),),
    ),
    "hui": HouseLook(
        (PLASTER,),
        TILES_DARK,
        TIMBER,
        0.55,
        0.0,
        WindowLook(4.2, 0.6, 0.7, 1.7, False),
        trim=STONE,
        wood=WALNUT,
        lane=2.6,
        enclosed="white",
        regions=((97.0, 18.0, 123.0, 42.0),),
    ),
    "timbered": HouseLook(
        (RENDER, OCHRE, BLUSH),
        TILES,
        SAGE,
        1.1,
        0.3,
        WindowLook(2.0, 0.75, 1.15, 0.95, False),
        base=SANDSTONE,
        frame=WALNUT,
        storeys=(2, 3),
        regions=((7.6, 48.0, 9.6, 51.8),),
    ),
    "hill": HouseLook(
        (LIMESTONE, SANDSTONE, MASONRY, OCHRE),
        TILES,
        WALNUT,
        0.36,
        0.2,
        WindowLook(2.7, 0.8, 1.3, 0.9, True),
        trim=STONE,
        storeys=(3, 4, 2),
        most=4,
        lane=2.8,
        street=3.0,
        enclosed="stone",
    ),
    "alpine": HouseLook(
        (TEAK, OAK_DARK),
        SLATE,
        SAGE,
        0.45,
        0.8,
        WindowLook(2.4, 0.95, 1.1, 0.95, True),
        base=RENDER,
        wood=WALNUT,
        balcony=True,
        storeys=(2, 3),
        regions=((6.0, 45.8, 14.5, 47.25),),
    ),
    "brick": HouseLook(
        (BRICK,),
        TILES_DARK,
        WHITE,
        1.0,
        0.2,
        WindowLook(2.2, 1.0, 1.6, 0.75, False),
        wood=WALNUT,
        regions=((2.5, 50.8, 7.2, 57.8), (7.2, 52.6, 15.0, 57.8), (-6.0, 50.0, 1.9, 56.0)),
    ),
    "plain": HouseLook(
        (RENDER, GREY, RENDER),
        TILES_DARK,
        GREY,
        0.5,
        0.15,
        WindowLook(3.2, 1.9, 1.6, 0.6, False),
        trim=SLATE,
        wood=SLATE,
        roofs=("flat", "gabled"),
        storeys=(2, 3),
        lane=4.4,
    ),
}
"""Of regions that overlap the first named counts; those without one are named in a brief only."""


class HouseForm(NamedTuple):
    """What a ``use`` makes of a house: how one goes in, whether its side walls are shared with
    neighbours (no windows, no overhang there), its own windows if any, and the roofs it has."""

    use: UseName = "dwelling"
    entrance: Entrance = "door"
    party: bool = False
    windows: WindowLook | None = None
    roofs: tuple[Roof, ...] = ("gabled", "hipped", "flat")


SLITS, LIGHTS = WindowLook(5.0, 0.6, 0.5, 1.9, False), WindowLook(4.0, 2.4, 1.2, 1.6, False)
TALL = WindowLook(3.2, 1.1, 2.1, 0.9, False)
FORMS: dict[str, HouseForm] = {
    "house": HouseForm(),
    "row": HouseForm(party=True, roofs=("gabled",)),
    "farm": HouseForm("farm", "byre", roofs=("gabled",)),
    "shop": HouseForm("shop", "shop"),
    "rowshop": HouseForm("shop", "shop", party=True, roofs=("gabled",)),
    "barn": HouseForm("outbuilding", "gate", windows=SLITS),
    "works": HouseForm("works", "gate", windows=LIGHTS, roofs=("gabled",)),
    "hall": HouseForm("public", "portal", windows=TALL, roofs=("gabled",)),
}
"""The first form of a use is drawn, or its form with party walls where it stands in a row."""


def asset_of_house(form: str, style: str, roof: str) -> str:
    """The id of the asset that draws a form in a style; of a roof the form has not, of its first.

    >>> asset_of_house("shop", "alpine", "hipped"), asset_of_house("row", "", "flat")
    ('shop_alpine_hipped', 'row_rural_gabled')
    """
    roofs = FORMS[form].roofs
    look = style if style in LOOKS else RURAL
    return f"{form}_{look}_{roof if roof in roofs else roofs[0]}"


def form_of_use(use: UseName, party: bool = False) -> str:
    """The form of houses of a use, one with party walls if there is such.

    >>> form_of_use("shop", party=True), form_of_use("public", party=True)
    ('rowshop', 'hall')
    """
    found = [name for name, form in FORMS.items() if form.use == use]
    return next((name for name in found if FORMS[name].party == party), found[0])


def read_asset(asset: str) -> tuple[str, str, str] | None:
    """Form, style and roof of the asset of a house; ``None`` of another.

    >>> read_asset("barn_hill_gabled"), read_asset("gothic_church")
    (('barn', 'hill', 'gabled'), None)
    """
    words = asset.split("_")
    known = len(words) == 3 and words[0] in FORMS and words[1] in LOOKS
    return (words[0], words[1], words[2]) if known else None


def style_of_asset(asset: str) -> str:
    """The style of the asset of a house; another asset is its own.

    >>> style_of_asset("barn_hill_gabled"), style_of_asset("villa")
    ('hill', 'villa')
    """
    words = read_asset(asset)
    return asset if words is None else words[1]


def style_of_region(lon: float, lat: float) -> str:
    """The style built at a longitude and latitude; empty where none is known.

    >>> style_of_region(7.42, 43.73), style_of_region(9.9, 53.5), style_of_region(-70.0, 40.0)
    ('riviera', 'brick', '')
    """
    for name, look in LOOKS.items():
        if any(w <= lon <= e and s <= lat <= n for w, s, e, n in look.regions):
            return name
    return ""
