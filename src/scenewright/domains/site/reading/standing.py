"""Buildings on the ground of a site map: footprints as landmarks, each part of them.

Polygons tagged as buildings stand; so do those that no tag names as something else, as registers
of buildings export them, unless other footprints lie in them (then they are parcels). What lies
across the border is cut there; of what two cover the first keeps all.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import shapely

from scenewright.building.outlines import rings
from scenewright.core.projection import Projection, metres
from scenewright.domains.site.reading.tags import appearance_of
from scenewright.ground.maps.fates import Note
from scenewright.ground.maps.features import Feature
from scenewright.ground.maps.footprints import UNTAGGED
from scenewright.ground.maps.kinds import PUBLIC, is_footprint, stands
from scenewright.ground.outlines import GRID

LEAST_BUILDING = 1.0
"""Square metres below which a part of a building is left out."""
LEAST_CUT = 0.02
"""Share of a building from which a cut is reported."""
PARCEL = 0.6
"""Share of a site from which an area without tags is its ground."""
WHOLE = 0.98
"""Share of a site from which a building leaves no site."""
OUTSIDE = "lies outside the site"


NOTHING = shapely.Polygon()


class DrawnFeature(NamedTuple):
    """A feature with its polygons in metres."""

    feature: Feature
    shape: shapely.Geometry


class _Part(NamedTuple):
    """One polygon of a building, without holes, and its number among those of the feature."""

    row: DrawnFeature
    outline: shapely.Polygon
    number: int


def find_landmarks(
    drawn: list[DrawnFeature], ground: shapely.Polygon, sites: list[Feature], notes: list[Note]
) -> list[dict[str, Any]]:
    """The landmarks of a site as documents of the brief; what became of each is added to
    ``notes``."""
    rows = list(_buildings(drawn, ground, sites, notes))
    parts = [part for row in rows for part in _parts(row)]
    taken = shapely.STRtree([part.outline for part in parts])
    kept: dict[int, list[shapely.Polygon]] = {}
    shapely.prepare(ground)
    found: list[dict[str, Any]] = []
    for number, part in enumerate(parts):
        name = part.row.feature.id
        reaches = ground.intersects(part.outline)
        inside = shapely.intersection(part.outline if reaches else NOTHING, ground, grid_size=GRID)
        near = [one for k in taken.query(part.outline).tolist() for one in kept.get(k, ())]
        rest = shapely.difference(inside, shapely.union_all(near), grid_size=GRID)
        shapes = _polygons(rest)
        if not shapes:
            covered = inside.area >= LEAST_BUILDING
            reason = "another building covers it" if covered else OUTSIDE
            small = part.outline.area < LEAST_BUILDING
            notes.append(Note(name, "left out", "covers less than 1 m²" if small else reason))
            continue
        kept[number] = shapes
        cut = 1 - sum(shape.area for shape in shapes) / part.outline.area
        notes.append(_note(part.row.feature, cut, inside.area / part.outline.area))
        for piece, shape in enumerate(shapes):
            names = [
                name,
                *[str(part.number)] * (part.number > 1),
                *[f"part-{piece}"] * (piece > 0),
            ]
            found.append(
                {
                    "id": ".".join(names),
                    "name": part.row.feature.tags.get("name", ""),
                    "outline": rings(shape)[0].tolist(),
                }
                | appearance_of(part.row.feature.tags)
            )
    return found


def note_points(
    features: tuple[Feature, ...],
    map_: Projection,
    ground: shapely.Polygon,
    landmarks: list[dict[str, Any]],
) -> Iterator[Note]:
    """Buildings that are only a point or an open line: lost, unless a landmark stands there."""
    standing = shapely.union_all([shapely.Polygon(row["outline"]) for row in landmarks])
    for feature in features:
        if feature.polygons or not _is_built(feature):
            continue
        at = feature.point[None] if feature.point is not None else feature.lines[0]
        place = shapely.LineString(metres(map_, at)) if len(at) > 1 else None
        place = place or shapely.Point(metres(map_, at)[0])
        if not shapely.intersects(ground, place):
            yield Note(feature.id, "left out", OUTSIDE)
        elif shapely.intersects(standing, place):
            yield Note(feature.id, "left out", "a building with an outline stands there")
        else:
            shape = "a point" if feature.point is not None else "an open line"
            yield Note(feature.id, "left out", f"is {shape}: its footprint is not known", True)


def _buildings(
    drawn: list[DrawnFeature], ground: shapely.Polygon, sites: list[Feature], notes: list[Note]
) -> Iterator[DrawnFeature]:
    """Standing buildings: tagged ones, parts of buildings, footprints without tags."""
    own = {feature.id for feature in sites}
    rows = [row for row in drawn if row.feature.id not in own]
    tagged = []
    for row in (row for row in rows if stands(row.feature.tags)):
        covers = shapely.intersection(row.shape, ground).area >= WHOLE * ground.area
        if row.shape.is_empty or covers:
            why = "covers the whole site" if covers else "encloses no area"
            notes.append(Note(row.feature.id, "left out", why, covers))
        else:
            tagged.append(row)
    whole = [row for row in tagged if "building" in row.feature.tags]
    bare = [row for row in rows if is_footprint(row.feature.tags)]
    untagged = {row.feature.id for row in bare}
    inner = shapely.STRtree([row.shape.representative_point() for row in (*tagged, *bare)])
    yield from (*whole, *(row for row in tagged if "building" not in row.feature.tags))
    for row in (row for row in rows if not row.shape.is_empty):
        name = row.feature.id
        bare_one = name in untagged
        holds = len(inner.query(row.shape, predicate="contains")) > bare_one
        inside = shapely.intersection(row.shape, ground).area
        if bare_one and inside < LEAST_BUILDING:
            notes.append(Note(name, "left out", OUTSIDE))
        elif bare_one and (holds or inside > PARCEL * ground.area):
            why = "other footprints lie in it" if holds else "it covers most of the site"
            notes.append(Note(name, "left out", f"has no tags and is ground: {why}"))
        elif bare_one:
            yield row
        elif _is_built(row.feature) and not stands(row.feature.tags):
            about = "is the ground around buildings" if holds else OUTSIDE
            lost = not holds and inside >= LEAST_BUILDING
            about = 'may be a building: tag it "building": "yes" if it stands' if lost else about
            notes.append(Note(name, "left out", about, lost))


def _is_built(feature: Feature) -> bool:
    """Whether a feature is a building, or an institution that has one."""
    tags = feature.tags
    return stands(tags) or (tags.get("amenity") in PUBLIC and "building" not in tags)


def _note(feature: Feature, cut: float, inside: float) -> Note:
    """The fate of a building on the site."""
    reasons = [UNTAGGED] * (not stands(feature.tags))
    reasons += ["cut at the border of the site"] * (inside < 1 - LEAST_CUT)
    reasons += ["cut where another building stands"] * (cut - (1 - inside) > LEAST_CUT)
    reasons += [feature.lost] * bool(feature.lost)
    return Note(feature.id, "changed" if reasons else "used", "; ".join(reasons))


def _parts(row: DrawnFeature) -> list[_Part]:
    outlines = [shapely.Polygon(part.exterior) for part in shapely.get_parts(row.shape)]
    return [_Part(row, outline, k) for k, outline in enumerate(outlines, 1)]


def _polygons(shape: shapely.Geometry) -> list[shapely.Polygon]:
    """The pieces of a shape that are large enough, largest first, without holes."""
    parts = [part for part in shapely.get_parts(shape) if part.geom_type == "Polygon"]
    large = [shapely.Polygon(part.exterior) for part in parts if part.area >= LEAST_BUILDING]
    return sorted(large, key=lambda part: -part.area)
