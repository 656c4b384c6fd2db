"""What a site is to hold: one row a building, with the model that draws it."""

from __future__ import annotations

from difflib import get_close_matches
from typing import NamedTuple

from scenewright.brief_site import Building, Site
from scenewright.catalog import Asset, Catalog
from scenewright.errors import InputError
from scenewright.scene import Size

STOREY = 3.0
HOUSING = ("modern_residential", "point_tower", "row_houses", "villa")
"""What fills a site that asks for nothing but an amount of floor."""
MOST = 20_000


class Wanted(NamedTuple):
    """One building to be placed: the number of its wish, its model, size, storeys, whether it must
    stand, and the planar forms it may take (empty: all)."""

    wish: int
    name: str
    asset: Asset
    size: Size
    floors: int
    required: bool
    forms: frozenset[str]


def wanted(site: Site, place: str, buildable: float, catalog: Catalog) -> list[Wanted]:
    """The buildings a site asks for, or those that bring its floor-area ratio and coverage."""
    rows = site.buildings or _amounts(site, buildable, catalog)
    found: list[Wanted] = []
    for number, row in enumerate(rows):
        told = f"{place} buildings[{number}] '{row.name or row.model}'"
        asset = asset_of(row.model, catalog, told)
        size = Size(*row.size) if row.size else asset.usual
        if site.height_limit is not None and size.height > site.height_limit + 1e-6:
            raise InputError(
                f"is {size.height:g} m high, the limit of the site is {site.height_limit:g} m",
                "give it a lower size or raise height_limit", place=told,
            )  # fmt: skip
        floors = row.floors or max(round(size.height / STOREY), 1)
        one = Wanted(
            number, row.name or asset.name, asset, size, floors, row.required, frozenset(row.forms)
        )
        found += [one] * row.count
    if len(found) > MOST:
        raise InputError(f"asks for {len(found)} buildings", f"ask for {MOST} at most", place=place)
    return found


def asset_of(model: str, catalog: Catalog, place: str) -> Asset:
    """The asset of a building's model."""
    if model in catalog.assets and catalog.assets[model].category == "building":
        return catalog.assets[model]
    known = sorted(a.id for a in catalog.of("building"))
    near = get_close_matches(model, known, 3) or known[:8]
    raise InputError(f"'{model}' is no building", f"use one of: {', '.join(near)}", place=place)


def _amounts(site: Site, buildable: float, catalog: Catalog) -> list[Building]:
    """As many dwellings as the floor-area ratio, the coverage or usual values ask for."""
    ratio, cover = site.floor_area_ratio, site.coverage or 0.25
    limit = site.height_limit or 1e9
    kinds = [catalog.assets[k] for k in HOUSING if k in catalog.assets]
    usable = [a for a in kinds if a.usual.height <= limit] or kinds[-1:]
    rows = []
    for asset in usable:
        width, depth, height = asset.usual
        footprint, floors = width * depth, max(round(min(height, limit) / STOREY), 1)
        count = cover * buildable / len(usable) / footprint
        if ratio is not None:
            count = min(count, ratio * buildable / len(usable) / (footprint * floors))
        if round(count) >= 1:
            rows.append(Building(model=asset.id, count=round(count), required=False))
    return rows or [Building(model=usable[-1].id, required=False)]
