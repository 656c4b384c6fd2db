"""Footprints among the features of a map that no tag says are buildings, and plots about them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import shapely

from scenewright.ground.maps.fates import Note
from scenewright.ground.maps.features import Feature
from scenewright.ground.maps.kinds import is_footprint, kind_of, stands

UNTAGGED = 'has no tag that says what it is: taken as a building (else tag it "building": "no")'
PARCEL = "has no tags and is ground: other footprints lie in it"
PLOT = "its border is laid anew about the building on it"


def find_footprints(features: Sequence[Feature]) -> tuple[set[str], set[str]]:
    """The ids of polygons without a tag of a map that are footprints, and of those that are
    parcels: other footprints lie in them."""
    bare = [f for f in features if f.polygons and is_footprint(f.tags)]
    built = [f for f in features if f.polygons and stands(f.tags)]
    shapes = [_outline(feature) for feature in (*bare, *built)]
    points = shapely.STRtree([shape.representative_point() for shape in shapes])
    parcels = {
        feature.id
        for feature, shape in zip(bare, shapes, strict=False)
        if len(points.query(shape, predicate="contains")) > 1
    }
    return {feature.id for feature in bare} - parcels, parcels


def note_plots(features: Sequence[Feature], notes: Sequence[Note]) -> Iterator[Note]:
    """What becomes of plots where plots are laid about buildings: drawn ones are changed if one
    of their buildings is kept, as ``notes`` say."""
    kept = {note.name for note in notes if note.outcome != "left out"}
    areas = [feature for feature in features if feature.polygons]
    built = [f for f in areas if f.id in kept and (stands(f.tags) or is_footprint(f.tags))]
    plots = [feature for feature in areas if kind_of(feature.tags, "area") == "plot"]
    points = shapely.STRtree([_outline(feature).representative_point() for feature in built])
    for plot in plots:
        if len(points.query(_outline(plot), predicate="contains")):
            yield Note(plot.id, "changed", PLOT)


def _outline(feature: Feature) -> shapely.Geometry:
    """The first outline of a feature, without its holes."""
    return shapely.make_valid(shapely.Polygon(feature.polygons[0][0]))
