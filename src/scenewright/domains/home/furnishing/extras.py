"""What completes a furnished room: lamps, what hangs at windows and on bare walls, mats."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.building.ceiling import below, lowest
from scenewright.catalog.classes import EATING_TABLES
from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.home.cases.furnishing import nearest_own
from scenewright.domains.home.furnishing.floor_mats import lay_mats
from scenewright.domains.home.furnishing.obstacles import (
    TOUCHING,
    StandingObstacles,
    flat_kinds,
    standing_of,
)
from scenewright.domains.home.furnishing.wall_art import fill_walls
from scenewright.domains.home.furnishing.window_dressing import dress_windows
from scenewright.domains.home.groups.classes import UNLIVED
from scenewright.domains.home.problem import Ground
from scenewright.geometry.boxes import common_area, make_frame

LAMP = Size(0.46, 0.46, 0.14)
HEAD_ROOM = 2.0  # what a lamp leaves below it, metres
TABLE_ROOM = 1.4  # what a lamp over a table leaves below it, metres
LEAST_LIT = 0.5  # the least floor that a ceiling lamp is hung over, square metres
PENDANT = Size(0.44, 0.44, 0.9)


def extras(
    space: Space, ground: Ground, pieces: tuple[Piece, ...], catalog: Catalog
) -> tuple[Piece, ...]:
    """Lamps, curtains, blinds, pictures and mats for a room in which ``pieces`` stand already."""
    lamps = _lamps(space, ground, pieces, catalog)
    windows = dress_windows(space, ground, pieces, catalog)
    walls = fill_walls(space, ground, (*pieces, *lamps, *windows), catalog)
    return (*lamps, *windows, *walls, *lay_mats(space, ground, pieces, catalog))


def _lamps(
    space: Space, ground: Ground, pieces: tuple[Piece, ...], catalog: Catalog
) -> list[Piece]:
    if UNLIVED & set(space.functions) or not space.functions:
        return []
    tables = [p for p in pieces if p.category in EATING_TABLES and p.function == "dining"]
    pendant, lamp = (
        _real(category, usual, catalog)
        for category, usual in (("pendant_lamp", PENDANT), ("ceiling_lamp", LAMP))
    )
    hung = [
        _hung("pendant_lamp", space, ground, catalog, *t.pose[:2], t.pose.heading, pendant, i)
        for i, t in enumerate(tables)
    ]
    standing = standing_of(pieces, flat_kinds(catalog))
    found = [
        p
        for p in hung
        if p.pose.z > TABLE_ROOM and not _is_before_window(p, ground) and _is_free(p, standing)
    ]
    shape = _shape(space)
    high = shape.difference(below(shape, ground.slopes, space.height, HEAD_ROOM + lamp.height))
    high = high.difference(_overhead(standing, space.height - lamp.height))
    x, y = _middle(high) if high.area > LEAST_LIT else (np.nan, np.nan)
    wide = high.buffer(-max(lamp.width, lamp.depth) * 0.72)
    far = wide.contains(shapely.Point(x, y)) and all(
        np.hypot(x - p.pose.x, y - p.pose.y) > 1.2 for p in found
    )
    if far and space.height - lamp.height > HEAD_ROOM:
        hanging = _hung("ceiling_lamp", space, ground, catalog, x, y, 0.0, lamp, 0)
        found += [hanging] if _is_free(hanging, standing) else []
    return found


def _overhead(standing: StandingObstacles, height: float) -> shapely.Geometry:
    """The floor below what reaches above a height: beams, hoods, cupboards up to the ceiling."""
    boxes = standing.boxes[standing.spans[:, 1] > height]
    return shapely.union_all(shapely.polygons(corners(boxes)))


def _is_free(lamp: Piece, standing: StandingObstacles) -> bool:
    """Whether a lamp hangs in nothing that stands or hangs already."""
    box = make_frame(lamp.pose.x, lamp.pose.y, lamp.pose.heading, *lamp.size[:2])
    low, high = lamp.pose.z, lamp.pose.z + lamp.size.height
    level = (standing.spans[:, 0] < high - TOUCHING) & (standing.spans[:, 1] > low + TOUCHING)
    return all(common_area(box, make_frame(*own)) <= TOUCHING**2 for own in standing.boxes[level])


def _is_before_window(lamp: Piece, ground: Ground) -> bool:
    """Whether a lamp hangs in the floor before a window, higher than its sill."""
    box = make_frame(lamp.pose.x, lamp.pose.y, lamp.pose.heading, *lamp.size[:2])
    top = lamp.pose.z + lamp.size.height
    return any(top > w[5] and common_area(box, make_frame(*w[:5])) > 0.0 for w in ground.windows)


def _real(category: str, usual: Size, catalog: Catalog) -> Size:
    """The size of a user's own lamp nearest to the usual one; the usual one where there is none."""
    own = nearest_own(category, usual, catalog)
    return own.usual if own else usual


def _middle(shape: shapely.Geometry) -> tuple[float, float]:
    """The middle of the largest circle in a floor, where a ceiling lamp belongs."""
    circle = shapely.maximum_inscribed_circle(shape, tolerance=0.05)
    x, y = circle.coords[0]
    centre = shape.centroid
    inside = shape.buffer(-LAMP.width).contains(centre)
    return (centre.x, centre.y) if inside else (x, y)


def _shape(space: Space) -> shapely.Polygon:
    return shapely.Polygon(space.outline, list(space.holes))


def _hung(
    category: str,
    space: Space,
    ground: Ground,
    catalog: Catalog,
    x: float,
    y: float,
    heading: float,
    size: Size,
    index: int,
) -> Piece:
    own = nearest_own(category, size, catalog)
    asset = own if own and own.usual == size else catalog.choose(category, size)
    name = f"{space.id}/{category}" + (f"_{index + 1}" if index else "")
    box = np.array([[x, y, heading, size.width, size.depth]])
    ceiling = float(lowest(box, ground.slopes, space.height)[0])
    pose = Pose(float(x), float(y), ceiling - size.height, float(heading))
    return Piece(name, category, asset.id if asset else "", space.id, pose, size, space.id, "light")
