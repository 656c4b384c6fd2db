"""Footprints among the features of a map that no tag says are buildings."""

from __future__ import annotations

from collections.abc import Sequence

import shapely

from scenewright.ground.map_features import Feature
from scenewright.ground.map_kinds import is_footprint, stands

UNTAGGED = 'has no tag that says what it is: taken as a building (else tag it "building": "no")'
PARCEL = "has no tags and is ground: other footprints lie in it"


def find_footprints(features: Sequence[Feature]) -> tuple[set[str], set[str]]:
    """The ids of polygons without a tag of a map that are footprints, and of those that are
    parcels: other footprints lie in them."""
    bare = [f for f in features if f.polygons and is_footprint(f.tags)]
    built = [f for f in features if f.polygons and stands(f.tags)]
    shapes = [shapely.make_valid(shapely.Polygon(f.polygons[0][0])) for f in (*bare, *built)]
    points = shapely.STRtree([shape.representative_point() for shape in shapes])
    parcels = {
        feature.id
        for feature, shape in zip(bare, shapes, strict=False)
        if len(points.query(shape, predicate="contains")) > 1
    }
    return {feature.id for feature in bare} - parcels, parcels
