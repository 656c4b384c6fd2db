"""The houses a village is filled with: those of the brief, models of its catalogues, or ours."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.house_looks import LOOKS, asset_of_house
from scenewright.catalog.credits import UNKNOWN
from scenewright.catalog.loading import BUILDING, find_asset
from scenewright.core.brief import Brief
from scenewright.core.brief.uses import UseName
from scenewright.core.catalog import OWN, Asset, Catalog
from scenewright.core.errors import InputError
from scenewright.core.footprint import Footprint, read_footprint
from scenewright.core.space import Points
from scenewright.domains.village.brief import LibraryHouse
from scenewright.domains.village.house import House, class_of_area, class_of_shape, to_own_frame
from scenewright.domains.village.learned.style import style_named

STOREY, SILL = 2.7, 0.4
"""Height of a storey and of the plinth, in metres."""
FLAT = 0.5
"""Height of a parapet, in metres."""
COARSE, FILLED, MOST_CORNERS = 0.2, 0.95, 40
"""Of the plan of a model: metres of its corners that are left out, the share of its sides that one
outline has, and its corners at most."""

_OURS: tuple[tuple[str, float, float, float, float, int, str, float], ...] = (
    ("Shed", 4.0, 3.0, 0, 0, 1, "gabled", 2.0),
    ("Garage", 6.0, 3.5, 0, 0, 1, "flat", 3.0),
    ("Small barn", 7.0, 5.0, 0, 0, 1, "gabled", 3.0),
    ("Wash house", 5.0, 4.5, 0, 0, 1, "hipped", 2.0),
    ("Stable", 9.0, 5.0, 0, 0, 1, "gabled", 2.0),
    ("Cottage", 9.0, 7.0, 0, 0, 1, "gabled", 2.0),
    ("Smallholding", 11.0, 7.5, 0, 0, 1, "gabled", 2.0),
    ("Square house", 9.0, 8.5, 0, 0, 2, "hipped", 2.0),
    ("Corner cottage", 10.0, 8.5, 4.5, 3.5, 1, "gabled", 1.5),
    ("House", 12.0, 9.0, 0, 0, 2, "gabled", 4.0),
    ("Broad house", 13.5, 10.0, 0, 0, 2, "gabled", 4.0),
    ("Square villa", 11.5, 10.5, 0, 0, 2, "hipped", 3.0),
    ("Farmhouse", 16.0, 10.0, 0, 0, 2, "gabled", 3.0),
    ("Long farmhouse", 21.0, 10.0, 0, 0, 2, "gabled", 2.0),
    ("Barn", 18.0, 12.0, 0, 0, 1, "gabled", 1.5),
    ("Large barn", 25.0, 13.0, 0, 0, 1, "gabled", 1.0),
    ("Angle house", 13.0, 11.0, 5.5, 4.5, 2, "gabled", 3.0),
    ("Angle farm", 18.0, 14.0, 9.0, 6.0, 2, "gabled", 2.0),
    ("Inn", 20.0, 15.0, 10.0, 6.0, 2, "gabled", 1.0),
    ("Annexe house", 15.0, 9.5, 4.5, 3.0, 2, "gabled", 3.0),
    ("Corner farm", 22.0, 18.0, 13.0, 10.0, 2, "gabled", 1.0),
    ("Court farm", 22.0, 16.0, -9.0, 8.0, 2, "gabled", 1.0),
    ("Court house", 14.0, 11.0, -5.0, 4.5, 2, "gabled", 1.5),
)
"""Name, width, depth, width and depth of what is cut out (of a corner; below 0: of the middle of
a long side), storeys, roof, share."""


_PURPOSES = (
    ("Workshop", 16.0, 11.0, 0, 0, 1, "gabled", 0.0),
    ("Large workshop", 26.0, 14.0, 0, 0, 1, "gabled", 0.0),
    ("Village hall", 12.0, 18.0, 0, 0, 2, "gabled", 0.0),
    ("Schoolhouse", 20.0, 12.0, 0, 0, 2, "gabled", 0.0),
)
"""Such as are built only where a brief asks for their use."""
_USES: dict[str, UseName] = {
    **dict.fromkeys(
        ("Shed", "Garage", "Small barn", "Wash house", "Stable", "Barn", "Large barn"),
        "outbuilding",
    ),
    **dict.fromkeys(
        ("Smallholding", "Farmhouse", "Long farmhouse", "Angle farm", "Corner farm", "Court farm"),
        "farm",
    ),
    **dict.fromkeys(("Workshop", "Large workshop"), "works"),
    **dict.fromkeys(("Village hall", "Schoolhouse"), "public"),
}
"""The uses of ours that are no dwellings."""


def houses_of(
    rows: Sequence[LibraryHouse], look: str, catalog: Catalog, purposes: bool = False
) -> tuple[House, ...]:
    """The houses to choose from: those of the brief, else the models of its catalogues, else our
    own. InputError, with its place, for a row that is no house."""
    if not rows:
        own = [a for a in catalog.of(BUILDING) if a.id.startswith(OWN)]
        if own:
            return tuple(_of_model(asset.name, asset, 1.0, 2) for asset in own)
        return our_houses(look, purposes)
    found = []
    for number, row in enumerate(rows):
        try:
            found.append(_of_row(row, look, catalog))
        except InputError as error:
            raise error.located(place=f"houses[{number}] '{row.name}'") from None
    names = [house.name for house in found]
    for number, name in enumerate(names):
        if name in names[:number]:
            where = f"houses[{number}]"
            raise InputError(f"the name '{name}' is used twice", "give each its own", place=where)
    return tuple(found)


def list_looks() -> list[dict[str, Any]]:
    """The styles the houses of a village may have; they have no other words and no palettes.

    >>> [row["name"] for row in list_looks()]
    ['rural', 'riviera', 'hui', 'timbered', 'hill', 'alpine', 'brick', 'plain']
    """
    return [{"name": look, "also": "", "palettes": ""} for look in LOOKS]


def sources_of(brief: Brief) -> tuple[tuple[str, str, str], ...]:
    """Author, licence and name of the data that the style of a village was learned from.

    >>> sources_of(Brief(domain="village", blocks=[{"outline": [(0, 0), (9, 0), (9, 9)]}]))[0][:2]
    ('OpenStreetMap contributors', 'ODbL-1.0')
    """
    card = style_named(brief.style).card
    licence, _, author = str(card.get("licence", UNKNOWN)).partition(", © ")
    name = f"style of villages learned from {card.get('houses', 'their')} houses"
    return ((author or UNKNOWN, licence.replace("ODbL 1.0", "ODbL-1.0"), name),)


@lru_cache(maxsize=8)
def our_houses(look: str, purposes: bool = False) -> tuple[House, ...]:
    """Our own library in a style, with workshops and halls for the ``purposes`` a brief names.

    >>> len(our_houses("rural")) > 20, our_houses("hui")[0].asset
    (True, 'house_hui_gabled')
    """
    rows = (*_OURS, *_PURPOSES) if purposes else _OURS
    return tuple(
        _house(
            name, _shape(w, d, cut_w, cut_d), *_built(look, k, levels, roof), look, share
        )._replace(use=_USES.get(name, ""))
        for k, (name, w, d, cut_w, cut_d, levels, roof, share) in enumerate(rows)
    )


def _built(look: str, number: int, levels: int, roof: str) -> tuple[int, None, str]:
    """Storeys and the asset of one of ours in a style: its houses of two storeys are as high as
    those of the style in turn, and roofed as they are where that is not under gables."""
    row = LOOKS[look]
    storeys = row.storeys[number % len(row.storeys)] if levels > 1 else levels
    over = roof if row.roofs[0] == "gabled" else row.roofs[number % len(row.roofs)]
    return storeys, None, asset_of_house("house", look, over)


def _shape(width: float, depth: float, cut_w: float, cut_d: float) -> list[tuple[float, float]]:
    """A rectangle, an L or a U."""
    w, d = width / 2, depth / 2
    if cut_w > 0:
        return [(-w, -d), (w, -d), (w, d - cut_d), (w - cut_w, d - cut_d), (w - cut_w, d), (-w, d)]
    if cut_w < 0:
        c = -cut_w / 2
        cut = [(c, d), (c, d - cut_d), (-c, d - cut_d), (-c, d)]
        return [(-w, -d), (w, -d), (w, d), *cut, (-w, d)]
    return [(-w, -d), (w, -d), (w, d), (-w, d)]


def _of_row(row: LibraryHouse, look: str, catalog: Catalog) -> House:
    if row.model:
        found = _of_model(row.name, find_asset(catalog, row.model), row.share, row.levels)
        return found._replace(height=row.height or found.height, use=row.use or "")
    if row.footprint is None:
        raise InputError("has neither footprint nor model", 'give "footprint" or "model"')
    outline = [(float(x), float(y)) for x, y in row.footprint]
    asset = asset_of_house("house", look, row.roof)
    found = _house(row.name, outline, row.levels, row.height, asset, look, row.share)
    return found._replace(use=row.use or "")


def _of_model(name: str, asset: Asset, share: float, levels: int) -> House:
    width, depth, height = asset.usual
    box = ((-width / 2, -depth / 2), (width / 2, -depth / 2), (width / 2, depth / 2))
    outline = list(_footprint_of_model(asset) or (*box, (-width / 2, depth / 2)))
    local, turn = to_own_frame(np.array(outline, float))
    return classify_house(name, local, levels, height, asset.id, share)._replace(
        front=np.pi / 2 - turn
    )


def _footprint_of_model(asset: Asset) -> Footprint:
    """What a model covers in plan, small corners left out; empty where that is its box, or where
    one outline does not tell it."""
    width, depth, _ = asset.usual
    own = asset.footprint(asset.usual)
    lines = [] if own else asset.symbol(asset.usual)
    if not lines:
        return own
    shape = shapely.Polygon(lines[0]).simplify(COARSE)
    low, high = np.array(shape.bounds).reshape(2, 2) if shape.is_valid else np.zeros((2, 2))
    fills = ((high - low) > FILLED * np.array((width, depth))).all()
    corners = shapely.get_coordinates(shape.exterior)[:-1]
    if not fills or len(corners) > MOST_CORNERS:
        return ()
    return read_footprint(corners.tolist(), width, depth)


def _house(
    name: str,
    outline: Sequence[tuple[float, float]],
    levels: int,
    height: float | None,
    asset: str,
    look: str,
    share: float,
) -> House:
    local = to_own_frame(np.array(outline, float))[0]
    wide = float(np.ptp(local, axis=0).min())
    rise = FLAT if asset.endswith("flat") else LOOKS[look].pitch * min(wide, 12.0) / 2
    tall = height or round(levels * STOREY + SILL * (levels > 1) + rise, 2)
    return classify_house(name, local, levels, tall, asset, share)


def classify_house(
    name: str, outline: Points, levels: int, height: float, asset: str, share: float
) -> House:
    """A house of a footprint (n, 2) in its own frame, with its classes."""
    polygon = shapely.Polygon(outline)
    wide, deep = np.ptp(outline, axis=0).tolist()
    area = float(polygon.area)
    return House(
        name,
        outline,
        area,
        (wide, deep),
        class_of_area(area),
        class_of_shape(outline),
        levels,
        height,
        asset,
        share,
    )
