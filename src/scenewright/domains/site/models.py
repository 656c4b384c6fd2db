"""The models a site names: those of its buildings, and its landmarks where they stand."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.catalog.loading import BUILDING, find_asset
from scenewright.core.catalog import OWN, Asset, Catalog
from scenewright.core.errors import InputError
from scenewright.core.footprint import Footprint, place_outline, read_footprint
from scenewright.core.reference_system import place_of, system_of
from scenewright.core.scene import Size
from scenewright.core.space import Points
from scenewright.domains.site.brief import Building, Landmark, LibraryModel, LockedBuilding, Site
from scenewright.ground import outlines as shapes
from scenewright.ground.buildings.plain_buildings import (
    fits_footprint,
    plain_building,
    style_at,
    usual_height,
)
from scenewright.ground.fit import corners_of
from scenewright.ground.plan import Standing

OVERLAP = 0.02
LANDMARK_HEIGHT, STOREY = 9.0, 3.2
"""Height in metres of a landmark that does not say, and of a storey."""
BOXY, TOUCHING = 0.985, 0.02
"""Share of its box from which a footprint counts as the box; metres to which it fills its box."""


def building_models(
    rows: Sequence[Building | LibraryModel], place: str, catalog: Catalog
) -> tuple[str, ...]:
    """The ids of the assets that draw the buildings asked for."""
    return tuple(
        _model(row, f"{place} buildings[{number}]", catalog) for number, row in enumerate(rows)
    )


def _model(row: Building | LibraryModel, place: str, catalog: Catalog) -> str:
    """The asset of a building: any of the user's own, of the shipped ones a building."""
    try:
        found = find_asset(catalog, row.model)
    except InputError as error:
        raise error.located(place=f"{place} '{row.name or row.model}'") from None
    if found.category != BUILDING and not found.id.startswith(OWN):
        known = ", ".join(asset.id for asset in catalog.of(BUILDING)[:8])
        raise InputError(f"'{row.model}' is not a building", f"use one of: {known}", place=place)
    return found.id


def landmarks_of(
    rows: Sequence[Landmark],
    names: Sequence[str],
    floor: shapely.Polygon,
    place: str,
    catalog: Catalog,
    style: str = "",
) -> tuple[Standing, ...]:
    """The landmarks of a site under their names: inside its ground, and apart. Those without a
    model are drawn by what they are, as houses of a ``style``."""
    found: list[Standing] = []
    for number, name in enumerate(names):
        where = f"{place} landmarks[{number}]"
        try:
            found.append(_landmark(rows[number], name, catalog, style))
        except InputError as error:
            raise error.located(place=where) from None
        out = shapely.difference(shapely.Polygon(found[-1].footprint), floor)
        if out.area > OVERLAP:
            raise InputError(
                f"stands with {out.area:.2f} m² outside the site",
                "move it in or leave it out",
                place=where,
            )
    footprints = np.array([shapely.Polygon(row.footprint) for row in found], object)
    pairs = shapely.STRtree(footprints).query(footprints, predicate="intersects").T if found else ()
    for a, b in pairs:
        shared = shapely.intersection(footprints[a], footprints[b]).area if a < b else 0.0
        if shared > OVERLAP:
            raise InputError(
                f"overlaps landmarks[{a}] '{found[a].id}' by {shared:.2f} m²",
                "move one of them",
                place=f"{place} landmarks[{b}]",
            )
    return tuple(found)


def fixed_of(
    rows: Sequence[LockedBuilding], floor: shapely.Polygon, place: str, catalog: Catalog
) -> tuple[Standing, ...]:
    """The buildings of a site that stay where they stand, on its ground each."""
    found = []
    for number, row in enumerate(rows):
        where = f"{place} fixed[{number}]"
        try:
            model = find_asset(catalog, row.model)
        except InputError as error:
            raise error.located(place=where) from None
        width, depth, height = row.size
        box = (*row.at, row.heading, width, depth)
        local = footprint_of(row.footprint, model, Size(*row.size))
        footprint = (
            place_outline(np.array(local), *row.at, row.heading) if local else corners_of(box)
        )
        if not shapely.Polygon(footprint).intersects(floor):
            raise InputError("stands outside the site", "move it in or let it go", place=where)
        found.append(Standing(row.id, row.name, model.id, footprint, box, height, local))
    name, count = Counter(row.id for row in rows).most_common(1)[0] if rows else ("", 1)
    if count > 1:
        raise InputError(
            f"the id '{name}' is used twice", "give each its own", place=f"{place} fixed"
        )
    return tuple(found)


def footprint_of(
    given: Sequence[tuple[float, float]] | None, model: Asset, size: Size
) -> Footprint:
    """The footprint of a building of some size: the polygon of the brief, else its model's."""
    return read_footprint(given, *size[:2]) if given else model.footprint(size)


def _landmark(row: Landmark, name: str, catalog: Catalog, style: str) -> Standing:
    """The footprint given, or that of a box of its own or its model's size where it stands."""
    model = find_asset(catalog, row.model) if row.model else None
    own = (*model.usual,) if model else None
    size = (row.size or own) if row.at else None
    if row.at is not None and size is not None:
        box = (*row.at, row.heading, size[0], size[1])
        footprint = corners_of(box)
    elif row.outline is not None:
        footprint = rings(shapes.simple(row.outline, "its outline", 0.01))[0]
        box = _box_about(footprint, row.heading)
    else:
        fault = "has no outline, and its size is not known" if row.at else "has no place"
        raise InputError(fault, 'give "at" and "size", or "outline"')
    if row.outline is not None:
        footprint = rings(shapes.simple(row.outline, "its outline", 0.01))[0]
    height = row.height or (size[2] if size else model.usual[2] if model else 0.0)
    height = height or _height(row, float(shapely.Polygon(footprint).area))
    made = Standing(name, row.name or name, model.id if model else "", footprint, box, height)
    return made if model else _plain(made, row, style)


def _height(row: Landmark, area: float) -> float:
    return row.levels * STOREY if row.levels else usual_height(row.use, area, LANDMARK_HEIGHT)


def _plain(made: Standing, row: Landmark, style: str) -> Standing:
    """A landmark without a model, with what draws it."""
    width, depth = made.box[3:]
    area = float(shapely.Polygon(made.footprint).area)
    drawn = plain_building((width, depth, made.height), area, style, row.use, row.roof or "")
    if not fits_footprint(drawn) or area > BOXY * width * depth:
        return made._replace(drawn=drawn)
    x, y, heading = made.box[:3]
    cos, sin = np.cos(np.pi / 2 - heading), np.sin(np.pi / 2 - heading)
    local = (made.footprint - (x, y)) @ np.array([[cos, sin], [-sin, cos]])
    if np.abs(np.abs(local).max(0) - (width / 2, depth / 2)).max() > TOUCHING:
        return made._replace(drawn=drawn)
    return made._replace(drawn=drawn, local=read_footprint(local.tolist(), width, depth))


def style_of(site: Site) -> str:
    """The style of houses where a site lies; empty where that is not known."""
    where = site.origin
    try:
        system = system_of(site.system) if where is None else None
    except InputError:
        system = None
    return style_at(place_of(system, *site.shift) if system else where)


def _box_about(footprint: Points, heading: float) -> tuple[float, float, float, float, float]:
    """The least rectangle about a footprint; of its four fronts that nearest to ``heading``."""
    frame = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shapely.Polygon(footprint)))
    x, y = frame[:4].mean(0)
    along, across = frame[1] - frame[0], frame[2] - frame[1]
    angle, long, wide = np.arctan2(along[1], along[0]), np.hypot(*along), np.hypot(*across)
    quarter = np.round((heading - angle) / (np.pi / 2))
    turned = (angle + quarter * np.pi / 2 + np.pi) % (2 * np.pi) - np.pi
    width, depth = (wide, long) if quarter % 2 == 0 else (long, wide)
    return float(x), float(y), float(turned), float(width), float(depth)
