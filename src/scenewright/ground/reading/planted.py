"""Trees and street lamps of maps, by the tags of OpenStreetMap, and what looks like trees where a
map has no tags."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.projection import Projection, metres
from scenewright.core.space import Points
from scenewright.ground.buildings.built import Spot
from scenewright.ground.maps.fates import Note
from scenewright.ground.maps.features import Feature
from scenewright.ground.maps.kinds import is_footprint
from scenewright.ground.planting.places import AVENUE, points_beside

TREE, ROW, LAMP = ("natural", "tree"), ("natural", "tree_row"), ("highway", "street_lamp")
IN_ROW, SHORTEST = 5.0, 0.5
"""Metres from a drawn row of trees within which a tree that is drawn by itself is of the row, and
that a row extends at least."""
CROWN, ROUND, CORNERS, MANY = 80.0, 0.93, 8, 10
"""Square metres of the largest crown, the least of 4 π area / perimeter² of a round one and its
least corners; how many alike are taken for trees."""
ROUNDED = (
    'has no tag: taken as a tree, small and round as {} others (else tag it "building": "yes")'
)
BARE_POINT = 'has no tag: one of {} such points; trees have "natural": "tree"'


class PlantedMap(NamedTuple):
    """Trees and lamps in metres, and what became of the features that they are, by a note each."""

    trees: tuple[Spot, ...]
    lamps: tuple[Spot, ...]
    notes: tuple[Note, ...]


def read_planted(features: Sequence[Feature], map_: Projection) -> PlantedMap:
    """The trees and street lamps of the features of a map: points, rows with a tree every
    :data:`~scenewright.ground.planting.places.AVENUE` metres, and many round areas without
    tags."""
    notes = list[Note]()
    single = [*_spots(features, TREE, map_, notes), *_rounded(features, map_, notes)]
    rows = [spot for f in _tagged(features, ROW) for spot in _row(f, map_, single, notes)]
    lamps = _spots(features, LAMP, map_, notes)
    bare = [f for f in features if f.point is not None and not f.tags and not f.polygons]
    if len(bare) >= MANY:
        notes += [Note(f.id, "left out", BARE_POINT.format(len(bare))) for f in bare]
    return PlantedMap((*single, *rows), tuple(lamps), tuple(notes))


def drop_planted(features: Sequence[Feature], planted: PlantedMap) -> tuple[Feature, ...]:
    """The features that are no trees and no lamps."""
    known = {note.name for note in planted.notes}
    return tuple(feature for feature in features if feature.id not in known)


def _tagged(features: Sequence[Feature], tag: tuple[str, str]) -> Iterator[Feature]:
    return (f for f in features if f.tags.get(tag[0]) == tag[1])


def _spots(
    features: Sequence[Feature], tag: tuple[str, str], map_: Projection, notes: list[Note]
) -> list[Spot]:
    """Where the features of a tag stand: points, and the middles of areas."""
    found = []
    for feature in _tagged(features, tag):
        at = feature.point
        if at is None and feature.polygons:
            at = feature.polygons[0][0][:-1].mean(0)
        if at is None:
            notes.append(Note(feature.id, "left out", "is a line"))
            continue
        notes.append(Note(feature.id, "used"))
        found.append(_spot(metres(map_, at[None])[0]))
    return found


def _row(
    feature: Feature, map_: Projection, single: Sequence[Spot], notes: list[Note]
) -> Iterator[Spot]:
    """The trees of a drawn row, unless they are drawn one by one beside it."""
    drawn_lines = (metres(map_, one) for one in feature.lines)
    lines = [line for line in drawn_lines if np.ptp(line, axis=0).max() > SHORTEST]
    drawn = shapely.union_all([shapely.LineString(line) for line in lines])
    if single and shapely.dwithin(drawn, shapely.multipoints(np.array(single)), IN_ROW):
        notes.append(Note(feature.id, "left out", "its trees are drawn one by one"))
        return
    spots = [_spot(at) for line in lines for at in points_beside(line, 0.0, AVENUE, 0.0)]
    every = Note(feature.id, "changed", f"a tree every {AVENUE:g} m")
    notes.append(every if spots else Note(feature.id, "left out", "has no length"))
    yield from spots


def _rounded(features: Sequence[Feature], map_: Projection, notes: list[Note]) -> list[Spot]:
    """The middles of small round areas without tags of a map, where there are many."""
    rings = [
        (feature, metres(map_, feature.polygons[0][0]))
        for feature in features
        if len(feature.polygons) == 1 and is_footprint(feature.tags)
    ]
    crowns = [(feature, ring) for feature, ring in rings if is_crown(ring)]
    if len(crowns) < MANY:
        return []
    told = ROUNDED.format(len(crowns) - 1)
    notes += [Note(feature.id, "changed", told) for feature, _ in crowns]
    return [_spot(ring[:-1].mean(0)) for _, ring in crowns]


def is_crown(ring: Points) -> bool:
    """Whether a closed ring (n, 2) in metres is as small and round as the crown of a tree.

    >>> turn = np.linspace(0, 2 * np.pi, 17)
    >>> circle = np.stack([np.cos(turn), np.sin(turn)], 1)
    >>> is_crown(3 * circle), is_crown(9 * circle), is_crown(np.array(shapely.box(0, 0, 4, 4).
    ... exterior.coords))
    (True, False, False)
    """
    if len(ring) <= CORNERS:
        return False
    shape = shapely.Polygon(ring)
    area, length = float(shape.area), float(shape.length)
    return 0 < area <= CROWN and 4 * np.pi * area >= ROUND * length * length


def _spot(at: Points) -> Spot:
    x, y = (round(float(value), 3) for value in at[:2])
    return x, y
