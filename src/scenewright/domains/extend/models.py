"""The model that draws a building: the one it names, else a plain one of ours."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.house_looks import LOOKS
from scenewright.catalog.loading import BUILDING, catalog_of, find_asset
from scenewright.core.brief import Brief
from scenewright.core.brief.catalog import CatalogBrief, entry_of
from scenewright.core.catalog import OWN, Catalog
from scenewright.core.errors import InputError
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Size
from scenewright.domains.extend.areas import ExtendPlan
from scenewright.domains.extend.given import BOXY, footprint_within
from scenewright.domains.extend.pattern import BuildingKind, SourcePattern
from scenewright.domains.extend.problem import Floats
from scenewright.ground.buildings.plain_buildings import fits_footprint, plain_building, style_at
from scenewright.ground.buildings.use_words import use_of_word

ROUNDED = 0.015
"""Metres by which corners of the same footprint may differ."""


def with_source_models(brief: Brief, plan: ExtendPlan) -> Brief:
    """The brief with the models of its city models among its catalogues."""
    named = {entry_of(entry).path for entry in brief.catalogs}
    rows = zip(brief.part.sources, plan.sources, strict=True)
    paths = {scene.catalog: row.scale for row, scene in rows if scene.catalog}
    more = [
        CatalogBrief(path=path, fill=False, scale=scale, buildings=True)
        for path, scale in paths.items()
        if path not in named
    ]
    return brief.model_copy(update={"catalogs": [*brief.catalogs, *more]}) if more else brief


def model_of(
    kind: BuildingKind, style: str, catalog: Catalog, told: tuple[str, str] = ("", "")
) -> str:
    """The id of the asset that draws a kind of building, of which a use and a roof may be
    ``told``; one that is drawn in its box only draws no other footprint."""
    if kind.model:
        return find_asset(catalog, kind.model).id
    (use, roof), area = told, float(shapely.Polygon(kind.local).area)
    found = plain_building(kind.size, area, style, use, roof)
    if fits_footprint(found) or area > BOXY * kind.size[0] * kind.size[1]:
        return found
    return plain_building(kind.size, area, style, use_of_word(use) or "", roof)


def local_style(brief: Brief, plan: ExtendPlan) -> str:
    """The style of houses a brief names, else that of the country its ground lies in."""
    places = (brief.part.origin, *(scene.origin for scene in plan.sources))
    return brief.style or style_at(next((at for at in places if at is not None), None))


def check_models(brief: Brief, plan: ExtendPlan) -> Catalog:
    """The catalogue of a brief with the models of its sources; InputError for a style or a model
    there is not."""
    if brief.style and brief.style not in LOOKS:
        known = ", ".join(LOOKS)
        raise InputError(f"'{brief.style[:40]}' is no style", f"use one of: {known}", place="style")
    catalog = catalog_of(with_source_models(brief, plan).catalogs)
    taller = [area.id for area in plan.areas if area.row.storeys]
    for kind in plan.pattern.kinds:
        if kind.model.startswith(OWN) and taller:
            raise InputError(
                f"'{kind.model}' is a model of its own: it cannot be made taller",
                "grow the model: scenewright fold MODEL --to N -o taller.obj",
                place=f"{taller[0]} storeys",
            )
        try:
            model_of(kind, brief.style, catalog)
        except InputError as error:
            raise error.located(place=f"sources[{kind.source}]") from None
    return catalog


def as_drawn(pattern: SourcePattern, catalog: Catalog) -> SourcePattern:
    """The pattern with what each kind covers as it is drawn, where that is not its footprint."""
    kinds = []
    for kind in pattern.kinds:
        size = Size(*kind.size)
        asset = catalog.assets.get(model_of(kind, "", catalog))
        covered = footprint_within(kind.local, size, asset) or rectangle(size.width, size.depth)
        local = keep_alike(shapely.Polygon(kind.local), shapely.Polygon(covered))
        kinds.append(kind._replace(local=shapely.get_coordinates(local.exterior)[:-1]))
    return pattern._replace(kinds=tuple(kinds))


def keep_alike(one: shapely.Polygon, other: shapely.Polygon) -> shapely.Polygon:
    """One of two polygons that are the same but for rounding, else the other."""
    return one if shapely.hausdorff_distance(one, other) < ROUNDED else other


def rectangle(width: float, depth: float) -> Footprint:
    """The corners of a box about its middle, counter-clockwise."""
    x, y = width / 2, depth / 2
    return ((-x, -y), (x, -y), (x, y), (-x, y))


def use_catalogue(pattern: SourcePattern, catalog: Catalog) -> SourcePattern:
    """The pattern with models of the brief's catalogues in place of the sources' own buildings:
    each kind becomes the building nearest to its size, as large as that is."""
    own = [asset for asset in catalog.of(BUILDING) if asset.id.startswith(OWN)]
    if not own:
        raise InputError("the brief's catalogues hold no building", 'name one in "catalogs"')
    kinds = []
    for kind in pattern.kinds:
        chosen = min(own, key=lambda asset: _misfit(asset.usual, kind.size))
        width, depth, height = chosen.usual
        covered = chosen.footprint(chosen.usual) or rectangle(width, depth)
        local = np.array(covered, float)
        size = (width, depth, height)
        kinds.append(kind._replace(local=local, size=size, model=chosen.id))
    boxes = pattern.boxes.copy()
    boxes[:, 3:] = np.array([kinds[k].size[:2] for k in pattern.kind])
    return pattern._replace(kinds=tuple(kinds), boxes=boxes)


def _misfit(size: Size, wish: tuple[float, float, float]) -> float:
    found: Floats = np.abs(np.log(np.array(size)) - np.log(np.array(wish)))
    return float(found.sum())
