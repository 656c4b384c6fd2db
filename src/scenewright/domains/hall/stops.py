"""Where a visitor stands to see a group: a few places before its objects."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.catalog import Catalog
from scenewright.geometry.clearway import Raster
from scenewright.layout import corners
from scenewright.scene import Piece
from scenewright.scene_graph import PlacedGroup

Floats = NDArray[np.float64]

SIDES = ("front", "left", "back", "right")
AWAY = (0.7, 1.0, 1.4)
"""How far before a side a visitor may stand, in metres."""
ALONG = 2.0
"""A long object is looked at from places this far apart, in metres."""
IN_VIEW = 3.0
"""What could be seen from a place within so many metres is seen from here as well: a place looks
after about 6 m of a row."""
MOST, MOST_OF_SEATS = 6, 2
SHARE = 1 / 8
"""Least share of a group's objects a further place must add."""
NARROW = 500.0
"""A way slower by so many seconds leads through a place narrower than asked for."""
AT_EASE = 1.2
"""More clearance than this, in metres, makes a place no better."""
SEATS = ("chair", "seat", "stool")


class Views(NamedTuple):
    """Places before the objects of a group: ``points`` (k, 2), the ``cells`` (k,) they are in,
    the ``objects`` (k,) seen from each, and the clearance ``room`` (k,)."""

    points: Floats
    cells: NDArray[np.int64]
    objects: NDArray[np.int64]
    room: Floats


def stops_of(
    group: PlacedGroup,
    members: tuple[Piece, ...],
    catalog: Catalog,
    clear: Raster,
    times: Floats,
) -> NDArray[np.int64]:
    """Cells of the raster to stop at so as to see a group, none if there is no way to it.

    A place lies before a side its objects are used from, as far away as gives most room. Places
    are taken greedily by how many more objects they show; those in the open come first. Rows of
    seats are looked at from their rim. ``times`` are those from the entrance.
    """
    boxes = np.array([[*p.pose[:2], p.pose.heading, *p.size[:2]] for p in members])
    views = _usable(_views(boxes, members, catalog, clear), times)
    seats = bool(members) and any(word in members[0].category for word in SEATS)
    if seats:
        views = _at_the_rim(views, boxes)
    if not len(views.cells):
        return np.zeros(0, np.int64)
    return _cover(_thinned(views, clear), views, MOST_OF_SEATS if seats else MOST)


def _views(boxes: Floats, members: tuple[Piece, ...], catalog: Catalog, clear: Raster) -> Views:
    """A grid of places before every side in use."""
    rows = [np.zeros((0, 3))]
    for k, (box, piece) in enumerate(zip(boxes, members, strict=True)):
        kind = catalog.kinds.get(piece.category)
        rows += [_before(box, SIDES.index(s), k) for s in (kind and kind.access) or SIDES]
    found = np.vstack(rows)
    points, owners = found[:, :2], found[:, 2].astype(np.int64)
    shape = np.array(clear.values.shape)
    corner = np.array([clear.x0, clear.y0])
    at = np.floor((points - corner) / clear.cell).astype(np.int64)[:, ::-1]
    inside = ((at >= 0) & (at < shape)).all(axis=1)
    cells = np.ravel_multi_index(tuple(at[inside].T), tuple(shape))
    return Views(points[inside], cells, owners[inside], clear.values.ravel()[cells])


def _before(box: Floats, side: int, owner: int) -> Floats:
    """Places (k, 3) before one side of a box, with the object they show."""
    heading = box[2] + side * np.pi / 2
    wide, deep = (box[3], box[4]) if side % 2 == 0 else (box[4], box[3])
    count = max(int(np.ceil(wide / ALONG)), 1)
    across = ((np.arange(count) + 0.5) / count - 0.5) * wide
    u, v = (axis.ravel() for axis in np.meshgrid(across, deep / 2 + np.array(AWAY)))
    x = box[0] + u * np.sin(heading) + v * np.cos(heading)
    y = box[1] - u * np.cos(heading) + v * np.sin(heading)
    return np.column_stack([x, y, np.full(len(x), owner)])


def _usable(views: Views, times: Floats) -> Views:
    """The places one can walk to; by a way that is nowhere too narrow, if there are such."""
    took = times[views.cells]
    least = took.min(initial=np.inf)
    return _some(views, np.isfinite(took) & (took < least + NARROW))


def _some(views: Views, wanted: NDArray[np.bool_]) -> Views:
    return Views(*(column[wanted] for column in views))


def _at_the_rim(views: Views, boxes: Floats) -> Views:
    """The places outside the hull of a group; all of them if there are none."""
    hull = shapely.convex_hull(shapely.multipoints(corners(boxes).reshape(-1, 2)))
    outside = ~shapely.contains_xy(hull, views.points[:, 0], views.points[:, 1])
    return _some(views, outside) if outside.any() else views


def _thinned(views: Views, clear: Raster) -> Views:
    """The place with most room of every square, smaller ones for smaller groups."""
    low, high = views.points.min(axis=0), views.points.max(axis=0)
    square = max(0.5, float((high - low).max()) / 25)
    at = np.floor((views.points - low) / square).astype(np.int64)
    best = np.lexsort((-np.minimum(views.room, AT_EASE), at[:, 0], at[:, 1]))
    _, first = np.unique(at[best], axis=0, return_index=True)
    return _some(views, np.isin(np.arange(len(at)), best[first]))


def _cover(places: Views, views: Views, most: int) -> NDArray[np.int64]:
    """Cells of places that together show as many objects as possible, best first."""
    total = len(np.unique(views.objects))
    apart = np.hypot(*(places.points[:, None] - views.points[None]).transpose(2, 0, 1))
    number = np.unique(views.objects, return_inverse=True)[1]
    shown = np.zeros((len(places.cells), total), bool)
    place, view = np.nonzero(apart <= IN_VIEW)
    shown[place, number[view]] = True
    ease = 0.5 + 0.5 * np.minimum(places.room, AT_EASE) / AT_EASE
    found: list[int] = []
    while len(found) < most:
        gain = shown.sum(axis=1)
        best = int(np.argmax(gain * ease))
        if gain[best] == 0 or (found and gain[best] < SHARE * total):
            break
        found.append(int(places.cells[best]))
        shown[:, shown[best]] = False
    return np.array(found, np.int64)
