"""A city model (CityJSON) as a site: its buildings stand as landmarks, the ground between is free.

The ground is what the file draws as ``LandUse`` of the class ``site``, else the hull of all
buildings and what lies a few metres around it, less water. Roads, which city models tell as areas,
become straight pieces. Heights above the sea do not count: all ground is level. The brief carries a
report of what became of every object.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.catalog.models.city_documents import document_of
from scenewright.catalog.models.cityjson import City, city_of, parts_at, roots_of, turn_of
from scenewright.catalog.models.files import MEBIBYTE, whole
from scenewright.catalog.models.model import SkippedModel, clean
from scenewright.core.brief import Brief
from scenewright.core.brief.fields import BUILDING
from scenewright.core.catalog import OWN, Part
from scenewright.core.errors import InputError
from scenewright.domains.site.brief import VERGE
from scenewright.domains.site.reading.city_fates import report_objects
from scenewright.ground.maps.fates import Note
from scenewright.ground.outlines import GRID, LEAST_AREA, polygons
from scenewright.ground.reading.road_areas import NARROW, pieces

MOST_BYTES = 128 * MEBIBYTE
MARGIN = 12.0
"""Metres of ground around the outermost buildings."""
LARGEST_EXTENT, SPARSE = 10_000.0, 0.01
"""Greatest length of a site in metres, and least share of its hull that buildings cover."""
TOGETHER = 150.0
"""Metres up to which buildings strewn over a larger ground are neighbours."""
SLIVER = 1.5
"""Half of the width, in metres, of what is no ground to build on."""
WAYS = ("Road", "Railway", "Bridge")
OUTSIDE, COVERED = "lies outside the ground", "another building covers it"
CUT, LEAST_CUT = "cut at the border of the ground or where another building stands", 0.02
"""The report on a building cut, and the share cut from which it is made."""
MOST_ROADS = 5000
MOST_LANDMARKS = 2000


class CityBuilding(NamedTuple):
    """A building of the file: its key there, what people call it, its model, footprint, place,
    heading and height."""

    key: str
    name: str
    model: str
    footprint: shapely.Polygon
    at: tuple[float, float]
    heading: float
    height: float


def read(path: Path, keep: bool = False) -> Brief:
    """The brief of a city model. There is no furniture to ``keep``."""
    del keep
    return read_report(path).brief


class CityReport(NamedTuple):
    """What was read: the brief, how many buildings the file has, and what of them was left out and
    why."""

    brief: Brief
    buildings: int
    skipped: tuple[SkippedModel, ...]


def read_report(path: Path) -> CityReport:
    """The brief of a city model, and what was found and left out."""
    return report(document_of(whole(path, MOST_BYTES)), path)


def brief_of(document: dict[str, Any], path: Path) -> Brief:
    """The brief of a city model; ``path`` is where its buildings' models are."""
    return report(document, path).brief


def report(document: dict[str, Any], path: Path) -> CityReport:
    """The brief and report of a city model already read."""
    city = city_of(document)
    notes: list[Note] = []
    buildings = list(_buildings(city, clean(path.stem, "model"), notes))
    name = re.sub(r"\.city$", "", path.stem)
    grounds = _sites(city, notes) or [("", _hull(buildings, notes))]
    flat = _Flat(
        {key: _area(city, key) for key in _keys(city, WAYS)},
        {key: _area(city, key) for key in _keys(city, ("WaterBody",))},
    )
    sites = [
        _site(named or name, ground, city, buildings, flat, notes) for named, ground in grounds
    ]
    stated = report_objects(city, notes)
    brief = Brief.model_validate(
        {
            "domain": "site",
            "name": name,
            "sites": sites,
            "catalogs": [{"path": str(path.absolute()), "fill": False}],
            "input_report": stated,
        }
    )
    roots = set(roots_of(city))
    lost = [n for n in notes if n.outcome == "left out" and n.name in roots]
    kept = {n.name for n in notes if n.outcome != "left out"}
    skipped = [SkippedModel(clean(n.name, "unnamed"), n.reason) for n in lost if n.name not in kept]
    return CityReport(brief, len(roots), tuple(skipped))


class _Flat(NamedTuple):
    """The areas of the ways and the water of a file in plan, by their keys."""

    ways: dict[str, shapely.Geometry]
    water: dict[str, shapely.Geometry]


def _site(
    name: str,
    ground: shapely.Polygon,
    city: City,
    buildings: list[CityBuilding],
    flat: _Flat,
    notes: list[Note],
) -> dict[str, Any]:
    floor = _ground(ground, shapely.union_all(list(flat.water.values())))
    outline, holes = rings(floor)
    roads = shapely.union_all(list(flat.ways.values()), grid_size=GRID)
    near = shapely.buffer(ground, VERGE, join_style="mitre")
    ways = pieces(shapely.intersection(roads, near, grid_size=GRID))
    inside = [way for way in ways if shapely.LineString(way.line).dwithin(floor, VERGE)]
    notes += _note_flat(flat, near)
    landmarks = list(_landmarks(floor, buildings, notes))
    if len(landmarks) > MOST_LANDMARKS:
        raise InputError(
            f"has {len(landmarks):,} buildings on its ground",
            f"cut a quarter of at most {MOST_LANDMARKS:,} out",
        )
    found: dict[str, Any] = {
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
    }
    if city.map_.where:
        found["latitude"] = max(min(city.map_.where[1], 89.0), -89.0)
    if city.map_.turns:
        return found | {"origin": city.map_.where}
    return found | {"system": city.system, "shift": city.middle[:2]}


def _note_flat(flat: _Flat, ground: shapely.Polygon) -> Iterator[Note]:
    """The fates of the ways and the water."""
    for areas, about in ((flat.ways, "read as straight pieces"), (flat.water, "")):
        for key, area in areas.items():
            if area.is_empty:
                yield Note(key, "left out", "covers no ground")
            elif not shapely.intersects(area, ground):
                yield Note(key, "left out", OUTSIDE)
            else:
                yield Note(key, "changed" if about else "used", about)


def _ground(ground: shapely.Polygon, water: shapely.Geometry) -> shapely.Polygon:
    """The largest piece of ground without water, without the slivers that banks leave."""
    dry = shapely.difference(ground, water, grid_size=GRID)
    broad = shapely.buffer(dry, -SLIVER, join_style="mitre").buffer(SLIVER, join_style="mitre")
    parts = polygons(shapely.intersection(dry, broad, grid_size=GRID))
    if not parts:
        raise InputError("its ground lies under water", "leave the WaterBody objects out")
    return parts[0]


def _landmarks(
    floor: shapely.Polygon, buildings: list[CityBuilding], notes: list[Note]
) -> Iterator[dict[str, Any]]:
    """Buildings on the ground, each piece of them; what two cover belongs to the first."""
    taken = shapely.STRtree([row.footprint for row in buildings])
    kept: dict[int, list[shapely.Polygon]] = {}
    for number, row in enumerate(buildings):
        inside = shapely.intersection(row.footprint, floor, grid_size=GRID)
        near = [one for k in taken.query(row.footprint).tolist() for one in kept.get(k, ())]
        rest = shapely.difference(inside, shapely.union_all(near), grid_size=GRID)
        parts = [shapely.Polygon(part.exterior) for part in polygons(rest)]
        if not parts:
            covered = inside.area >= LEAST_AREA
            outside = "covers less than 1 m²" if row.footprint.area < LEAST_AREA else OUTSIDE
            notes.append(Note(row.key, "left out", COVERED if covered else outside))
            continue
        kept[number] = parts
        cut = sum(part.area for part in parts) < (1 - LEAST_CUT) * row.footprint.area
        notes.append(Note(row.key, "changed" if cut else "used", CUT if cut else ""))
        for piece, part in enumerate(parts):
            short = row.model.partition("/")[2]
            yield {
                "id": f"{short}.part-{piece}" if piece else short,
                "name": row.name,
                "outline": rings(part)[0].tolist(),
            } | (
                {"model": f"{OWN}{row.model}", "at": row.at, "heading": row.heading}
                if not piece
                else {"height": row.height}
            )


def _buildings(city: City, stem: str, notes: list[Note]) -> Iterator[CityBuilding]:
    """Every building whose geometry can be used, where it stands."""
    seen: Counter[str] = Counter()
    for number, key in enumerate(roots_of(city), 1):
        short = clean(key, "unnamed")
        try:
            parts = parts_at(city, key)
        except InputError as error:
            notes.append(Note(key, "left out", error.fault, True))
            continue
        seen[short] += 1
        model = f"{stem}/{short}" + (f"-{seen[short]}" if seen[short] > 1 else "")
        shape = _shadow(parts)
        if shape.is_empty:
            notes.append(Note(key, "left out", "covers no ground"))
            continue
        angle = turn_of(parts)
        points = np.concatenate([part.vertices[np.unique(part.faces)] for part in parts])
        cos, sin = np.cos(angle), np.sin(angle)
        back = np.array([[cos, -sin], [sin, cos]])
        local = points[:, :2] @ back
        x, y = (back @ ((local.min(0) + local.max(0)) / 2)).tolist()
        attributes = city.objects[key].get("attributes")
        name = clean(attributes.get("name")) if isinstance(attributes, dict) else ""
        height = max(float(np.ptp(points[:, 2])), 1.0)
        side = max(height, float(np.ptp(local, axis=0).max()))
        if side > BUILDING:
            large = f"is {side:,.0f} m large, more than a building's {BUILDING:g} m"
            notes.append(Note(key, "left out", large, True))
            continue
        yield CityBuilding(
            key, name or f"building {number}", model, shape, (x, y), angle - np.pi / 2, height
        )


def _shadow(parts: tuple[Part, ...]) -> shapely.Polygon:
    """The outline of parts in plan, without holes; of several pieces their hull."""
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


def _sites(city: City, notes: list[Note]) -> list[tuple[str, shapely.Polygon]]:
    """The grounds that a file draws as sites."""
    found = []
    for key in _keys(city, ("LandUse",)):
        attributes = city.objects[key].get("attributes")
        if not isinstance(attributes, dict) or attributes.get("class") != "site":
            continue
        parts = polygons(_area(city, key))
        about = "only the largest of its parts was read" if parts[1:] else ""
        if not parts:
            notes.append(Note(key, "left out", "covers no ground", True))
            continue
        notes.append(Note(key, "changed" if about else "used", about))
        found.append((clean(attributes.get("name")) or clean(key), parts[0]))
    return found


def _hull(buildings: list[CityBuilding], notes: list[Note]) -> shapely.Polygon:
    """The ground of buildings that draw none: what lies about them, or, where they are strewn over
    kilometres, about those that stand together. InputError if none do."""
    if not buildings:
        raise InputError("holds no building with a footprint", "give another city model")
    shapes = [row.footprint for row in buildings]
    if _are_together(shapes):
        return _about(shapes)
    near = shapely.buffer(np.array(shapes, object), TOGETHER / 2)
    groups = polygons(shapely.union_all(near, grid_size=0.01))
    built = [[shape for shape in shapes if shapely.intersects(shape, part)] for part in groups]
    largest = max(built, key=lambda group: (len(group), sum(shape.area for shape in group)))
    if len(largest) < 2:
        west, south, east, north = _about(shapes).bounds
        raise InputError(
            f"its {len(shapes)} buildings lie over {max(east - west, north - south) / 1000:.3g} "
            f"km, none within {TOGETHER:g} m of another",
            "cut a quarter out, or draw the ground as LandUse with the class 'site'",
        )
    chosen = {id(shape) for shape in largest}
    away = f"stands more than {TOGETHER:g} m from the {len(largest)} that are the site"
    notes += [Note(b.key, "left out", away) for b in buildings if id(b.footprint) not in chosen]
    return _about(largest)


def _about(shapes: list[shapely.Polygon]) -> shapely.Polygon:
    hull: shapely.Polygon = shapely.convex_hull(shapely.union_all(shapes))
    return hull.buffer(MARGIN, join_style="mitre")


def _are_together(shapes: list[shapely.Polygon]) -> bool:
    """Whether buildings are dense enough for a site."""
    hull = _about(shapes)
    west, south, east, north = hull.bounds
    share = sum(shape.area for shape in shapes) / hull.area
    dense = share >= SPARSE or len(shapes) == 1
    return bool(max(east - west, north - south) <= LARGEST_EXTENT and dense)


def _keys(city: City, kinds: tuple[str, ...]) -> list[str]:
    return [key for key, one in city.objects.items() if one.get("type") in kinds]


def _area(city: City, key: str) -> shapely.Geometry:
    """The outline of an object in plan; empty if its geometry cannot be used."""
    try:
        parts = parts_at(city, key)
    except InputError:
        return shapely.Polygon()
    corners = np.concatenate([part.vertices[part.faces][..., :2] for part in parts])
    return shapely.union_all(shapely.polygons(corners).astype(object), grid_size=1e-3)
