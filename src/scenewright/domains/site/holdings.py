"""What a site is to hold: one row a building, with the model that draws it."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from scenewright.core.catalog import OWN, Asset, Catalog
from scenewright.core.errors import InputError
from scenewright.core.footprint import Footprint, extents
from scenewright.core.scene import Size
from scenewright.domains.site.amounts import STOREY, amounts, count_models, find_target
from scenewright.domains.site.brief import Building, Site
from scenewright.domains.site.models import footprint_of
from scenewright.ground.plan import SitePlan, Standing

MOST = 20_000
LEAST = 1.5
"""Least side in plan, in metres, from which a lone model is taken for a building."""


class BuildingDemand(NamedTuple):
    """One building to be placed: the number of its wish, its model, size, storeys, whether it must
    stand, the planar forms it may take (empty: all), and the polygon it covers (empty: its box)."""

    wish: int
    name: str
    asset: Asset
    size: Size
    floors: int
    required: bool
    forms: frozenset[str]
    footprint: Footprint = ()


def collect_buildings(
    site: Site, plan: SitePlan, place: str, catalog: Catalog, choose: bool = False
) -> list[BuildingDemand]:
    """The buildings a site asks for, or those that bring its floor-area ratio and coverage, less
    those that stand already. Of a library as many of each model as might stand, to ``choose``
    from, or numbers by their shares."""
    if site.library:
        asked = _list_library(site, plan, place, catalog, choose)
    else:
        asked = (_list_demands if site.buildings else _filling)(site, plan, place, catalog)
    return without_standing(asked, plan.fixed)


def without_standing(
    asked: list[BuildingDemand], standing: Sequence[Standing]
) -> list[BuildingDemand]:
    """Demands without one for each building that stands: one of its model, of its name and the
    nearest size where there are several."""
    left, met = Counter(asked), Counter[BuildingDemand]()
    for there in standing:
        size = (*there.box[3:], there.height)
        same = [row for row, count in left.items() if count and row.asset.id == there.model]
        if same:
            best = min(same, key=lambda r: (r.name != there.name, math.dist(r.size, size)))
            left[best] -= 1
            met[best] += 1
    found = []
    for row in asked:
        if met[row]:
            met[row] -= 1
        else:
            found.append(row)
    return found


def _list_demands(site: Site, plan: SitePlan, place: str, catalog: Catalog) -> list[BuildingDemand]:
    found: list[BuildingDemand] = []
    for number, (row, model) in enumerate(zip(site.buildings, plan.models, strict=True)):
        asset = catalog.assets[model]
        where = f"{place} buildings[{number}] '{row.name or row.model}'"
        size = _size(row, asset, where)
        if site.height_limit is not None and size.height > site.height_limit + 1e-6:
            raise InputError(
                f"is {size.height:g} m high, the limit of the site is {site.height_limit:g} m",
                "give it a lower size or raise height_limit",
                place=where,
            )
        floors = row.floors or max(round(size.height / STOREY), 1)
        one = BuildingDemand(
            number,
            row.name or asset.name,
            asset,
            size,
            floors,
            row.required,
            frozenset(row.forms),
            footprint_of(row.footprint, asset, size),
        )
        found += [one] * row.count
    if len(found) > MOST:
        raise InputError(f"asks for {len(found)} buildings", f"ask for {MOST} at most", place=place)
    return found


def _list_library(
    site: Site, plan: SitePlan, place: str, catalog: Catalog, choose: bool
) -> list[BuildingDemand]:
    """Candidates of every model of a library, or numbers that bring the target."""
    kinds = []
    for number, (row, model) in enumerate(zip(site.library, plan.models, strict=True)):
        asset, where = catalog.assets[model], f"{place} library[{number}] '{row.name or row.model}'"
        one = Building(model=row.model, name=row.name, size=row.size, floors=row.floors)
        size = _size(one, asset, where)
        floors = row.floors or max(round(size.height / STOREY), 1)
        covered = footprint_of(None, asset, size)
        name = row.name or asset.name
        kinds.append(BuildingDemand(number, name, asset, size, floors, False, frozenset(), covered))
    areas = [row.size.width * row.size.depth for row in kinds]
    storeys = [area * row.floors for area, row in zip(areas, kinds, strict=True)]
    cover, floor = find_target(site, plan)
    if choose:
        counts = [
            min(math.ceil(cover / area), math.ceil(min(floor, 1e12) / whole), MOST // len(kinds))
            for area, whole in zip(areas, storeys, strict=True)
        ]
    else:
        weights = [1.0 / row.share for row in site.library]
        counts = count_models(areas, storeys, weights, cover, floor)
    return [one for one, count in zip(kinds, counts, strict=True) for _ in range(count)]


def _filling(site: Site, plan: SitePlan, place: str, catalog: Catalog) -> list[BuildingDemand]:
    found: list[BuildingDemand] = []
    for number, (asset, count) in enumerate(amounts(site, plan, place, catalog)):
        floors = max(round(asset.usual.height / STOREY), 1)
        covered = asset.footprint(asset.usual)
        one = BuildingDemand(
            number, asset.name, asset, asset.usual, floors, False, frozenset(), covered
        )
        found += [one] * min(count, MOST - len(found))
    return found


def _size(row: Building, asset: Asset, place: str) -> Size:
    """The size given, else the extents of the footprint given, else that of the model if it is one
    of a building."""
    if row.size:
        return Size(*row.size)
    size = asset.usual
    if row.footprint:
        return Size(*extents(row.footprint), size.height)
    if asset.id.startswith(OWN) and min(size.width, size.depth) < LEAST:
        raise InputError(
            f"is only {size.width:.3g} x {size.depth:.3g} m, {size.height:.3g} m high by its file",
            "give its size, or its catalogue a scale",
            place=place,
        )
    return size
