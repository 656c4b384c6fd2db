"""A city model (CityJSON) as a site: its buildings stand as landmarks, the ground between is free.

The ground is what the file draws as ``LandUse`` of the class ``site``, else the hull of all
buildings and what lies a few metres around it, less water. Roads, which city models tell as areas,
become straight pieces. Heights above the sea do not count: all ground is level.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.catalog.models.cityjson import City, city_of, parts_at, roots_of, turn_of
from scenewright.catalog.models.files import MEBIBYTE, json_of, whole
from scenewright.catalog.models.model import SkippedModel, clean
from scenewright.core.brief import Brief
from scenewright.core.catalog import OWN, Part
from scenewright.core.errors import InputError
from scenewright.domains.site.brief import VERGE
from scenewright.domains.site.reading.road_areas import pieces
from scenewright.ground.outlines import GRID, polygons

MOST_BYTES = 128 * MEBIBYTE
MARGIN = 12.0
"""Metres of ground around the outermost buildings."""
LARGEST_EXTENT, SPARSE = 10_000.0, 0.01
"""Greatest length of a site in metres, and least share of its hull that buildings cover."""
SLIVER = 1.5
"""Half of the width, in metres, of what is no ground to build on."""
ROADS = ("Road", "Railway")
NARROW = 3.5
"""Roads narrower than this, in metres, are paths."""
MOST_ROADS = 5000
MOST_LANDMARKS = 2000
DEGREES = ("/4326", "/4979", "CRS84", "/4258")


class CityBuilding(NamedTuple):
    """A building of the file: what people call it, its model, footprint, place and heading."""

    name: str
    model: str
    footprint: shapely.Polygon
    at: tuple[float, float]
    heading: float


def read(path: Path, keep: bool = False) -> Brief:
    """The brief of a city model. There is no furniture to ``keep``."""
    del keep
    return read_report(path).brief


class CityReport(NamedTuple):
    """What was read: the brief, how many buildings the file has, and what was left out and why."""

    brief: Brief
    buildings: int
    skipped: tuple[SkippedModel, ...]


def read_report(path: Path) -> CityReport:
    """The brief of a city model, and what was found and left out."""
    return report(json_of(whole(path, MOST_BYTES), "CityJSON"), path)


def brief_of(document: dict[str, Any], path: Path) -> Brief:
    """The brief of a city model; ``path`` is where its buildings' models are."""
    return report(document, path).brief


def report(document: dict[str, Any], path: Path) -> CityReport:
    """The brief and report of a city model already read."""
    city = city_of(document)
    if any(sign in city.system for sign in DEGREES):
        raise InputError("its coordinates are degrees", "export it in a system of metres")
    skipped: list[SkippedModel] = []
    buildings = list(_buildings(city, clean(path.stem, "model"), skipped))
    name = path.stem.removesuffix(".city")
    grounds = _sites(city) or [("", _hull(buildings))]
    roads = shapely.union_all([_area(city, key) for key in _keys(city, ROADS)], grid_size=GRID)
    water = shapely.union_all([_area(city, key) for key in _keys(city, ("WaterBody",))])
    sites = [
        _site(named or name, ground, city, buildings, roads, water, skipped)
        for named, ground in grounds
    ]
    brief = Brief.model_validate(
        {
            "domain": "site",
            "name": name,
            "sites": sites,
            "catalogs": [{"path": str(path.absolute()), "fill": False}],
        }
    )
    return CityReport(brief, len(roots_of(city)), tuple(skipped))


def _site(
    name: str,
    ground: shapely.Polygon,
    city: City,
    buildings: list[CityBuilding],
    roads: shapely.Geometry,
    water: shapely.Geometry,
    skipped: list[SkippedModel],
) -> dict[str, Any]:
    floor = _ground(ground, water)
    outline, holes = rings(floor)
    near = shapely.buffer(ground, VERGE, join_style="mitre")
    ways = pieces(shapely.intersection(roads, near, grid_size=GRID))
    inside = [way for way in ways if shapely.LineString(way.line).dwithin(floor, VERGE)]
    landmarks = list(_landmarks(floor, buildings, skipped))
    if len(landmarks) > MOST_LANDMARKS:
        raise InputError(
            f"has {len(landmarks):,} buildings on its ground",
            f"cut a quarter of at most {MOST_LANDMARKS:,} out",
        )
    return {
        "name": name,
        "outline": outline.tolist(),
        "holes": [hole.tolist() for hole in holes],
        "roads": [
            {
                "line": way.line,
                "width": min(max(way.width, 0.5), 100.0),
                "kind": "path" if way.width < NARROW else "road",
            }
            for way in inside[:MOST_ROADS]
        ],
        "landmarks": landmarks,
        "system": city.system,
        "shift": city.middle[:2],
    }


def _ground(ground: shapely.Polygon, water: shapely.Geometry) -> shapely.Polygon:
    """The largest piece of ground without water, without the slivers that banks leave."""
    dry = shapely.difference(ground, water, grid_size=GRID)
    broad = shapely.buffer(dry, -SLIVER, join_style="mitre").buffer(SLIVER, join_style="mitre")
    parts = polygons(shapely.intersection(dry, broad, grid_size=GRID))
    if not parts:
        raise InputError("its ground lies under water", "leave the WaterBody objects out")
    return parts[0]


def _landmarks(
    floor: shapely.Polygon, buildings: list[CityBuilding], skipped: list[SkippedModel]
) -> Iterator[dict[str, Any]]:
    """Buildings at least half on the ground; what two of them cover belongs to the first."""
    taken = shapely.STRtree([row.footprint for row in buildings])
    kept: dict[int, shapely.Polygon] = {}
    for number, row in enumerate(buildings):
        rest = shapely.intersection(row.footprint, floor, grid_size=GRID)
        near = [kept[k] for k in taken.query(row.footprint).tolist() if k in kept]
        if near:
            rest = shapely.difference(rest, shapely.union_all(near), grid_size=GRID)
        parts = polygons(rest)
        if not parts or parts[0].area < 0.5 * row.footprint.area:
            why = "less than half of it is free on the ground"
            skipped.append(SkippedModel(row.model.partition("/")[2], why))
            continue
        kept[number] = shapely.Polygon(parts[0].exterior)
        yield {
            "id": row.model.partition("/")[2],
            "name": row.name,
            "model": f"{OWN}{row.model}",
            "at": row.at,
            "heading": row.heading,
            "outline": rings(kept[number])[0].tolist(),
        }


def _buildings(city: City, stem: str, skipped: list[SkippedModel]) -> Iterator[CityBuilding]:
    """Every building whose geometry can be used, where it stands."""
    seen: Counter[str] = Counter()
    for number, key in enumerate(roots_of(city), 1):
        short = clean(key, "unnamed")
        try:
            parts = parts_at(city, key)
        except InputError as error:
            skipped.append(SkippedModel(short, error.fault))
            continue
        seen[short] += 1
        model = f"{stem}/{short}" + (f"-{seen[short]}" if seen[short] > 1 else "")
        shape = _shadow(parts)
        if shape.is_empty:
            skipped.append(SkippedModel(short, "covers no ground"))
            continue
        angle = turn_of(parts)
        points = np.concatenate([part.vertices[np.unique(part.faces)] for part in parts])
        cos, sin = np.cos(angle), np.sin(angle)
        back = np.array([[cos, -sin], [sin, cos]])
        local = points[:, :2] @ back
        x, y = (back @ ((local.min(0) + local.max(0)) / 2)).tolist()
        attributes = city.objects[key].get("attributes")
        name = clean(attributes.get("name")) if isinstance(attributes, dict) else ""
        yield CityBuilding(name or f"building {number}", model, shape, (x, y), angle - np.pi / 2)


def _shadow(parts: tuple[Part, ...]) -> shapely.Polygon:
    """What parts cover in plan, without holes; of several pieces their hull."""
    corners = np.concatenate([part.vertices[part.faces][..., :2] for part in parts])
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    wide = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) > 1e-6
    shape = shapely.union_all(shapely.polygons(corners[wide]), grid_size=1e-3)
    found = polygons(shape)
    if not found:
        return shapely.Polygon()
    if sum(part.area for part in found[1:]) > 0.02 * found[0].area:
        hull: shapely.Polygon = shapely.convex_hull(shape)
        return hull
    return shapely.Polygon(found[0].exterior).simplify(0.01)


def _sites(city: City) -> list[tuple[str, shapely.Polygon]]:
    """The grounds that a file draws as sites."""
    found = []
    for key in _keys(city, ("LandUse",)):
        attributes = city.objects[key].get("attributes")
        if isinstance(attributes, dict) and attributes.get("class") == "site":
            found += [
                (clean(attributes.get("name")) or clean(key), part)
                for part in polygons(_area(city, key))[:1]
            ]
    return found


def _hull(buildings: list[CityBuilding]) -> shapely.Polygon:
    """The ground of buildings that draw none; InputError if they lie too far apart."""
    shapes = [row.footprint for row in buildings]
    if not shapes:
        raise InputError("holds no building with a footprint", "give another city model")
    hull = shapely.convex_hull(shapely.union_all(shapes)).buffer(MARGIN, join_style="mitre")
    west, south, east, north = hull.bounds
    longest = max(east - west, north - south)
    share = sum(shape.area for shape in shapes) / hull.area
    if longest > LARGEST_EXTENT or (share < SPARSE and len(shapes) > 1):
        raise InputError(
            f"its {len(shapes)} buildings lie over {longest / 1000:.3g} km and cover "
            f"{100 * share:.2g} % of it",
            "cut a quarter out, or draw the ground as LandUse with the class 'site'",
        )
    found: shapely.Polygon = hull
    return found


def _keys(city: City, kinds: tuple[str, ...]) -> list[str]:
    return [key for key, one in city.objects.items() if one.get("type") in kinds]


def _area(city: City, key: str) -> shapely.Geometry:
    """What an object covers in plan; nothing if its geometry cannot be used."""
    try:
        parts = parts_at(city, key)
    except InputError:
        return shapely.Polygon()
    corners = np.concatenate([part.vertices[part.faces][..., :2] for part in parts])
    return shapely.union_all(shapely.polygons(corners).astype(object), grid_size=1e-3)
