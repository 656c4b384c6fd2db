"""Where a visitor stands to see a group: a few places before its objects."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.domains.hall.visit.floor import AT_EASE, WalkingFloor
from scenewright.geometry.distance_raster import DistanceRaster
from scenewright.geometry.travel import mark_near

Floats = NDArray[np.float64]
Cells = NDArray[np.int64]

SIDES = ("front", "left", "back", "right")
AWAY = (0.5, 0.7, 1.0, 1.4)
"""How far before a side a visitor may stand, in metres."""
STOP_ALONG = 2.0
"""A long object is looked at from places this far apart, in metres."""
IN_VIEW = 3.0
"""What is visible from any place within this many metres counts as seen from here: one place
covers about 6 m of a row."""
MOST, MOST_OF_SEATS = 6, 2
SHARE = 1 / 8
"""Least share of a group's objects a further place must add."""
NO_WIDTH = 1e4
"""A way of more seconds leads through a place narrower than asked for."""
STOP_CLOSE, STOP_TOUCHING = 0.2, 0.05
"""Sight begins so close to an object; nothing is seen through what is nearer than the latter to
the line of sight, in metres."""
SEATS = ("chair", "seat", "stool")


class Views(NamedTuple):
    """Places before the objects of a group: ``points`` (k, 2), the ``cells`` (k,) they are in,
    the ``objects`` (k,) seen from each, and the clearance ``room`` (k,)."""

    points: Floats
    cells: Cells
    objects: Cells
    room: Floats


def stops_of(
    members: tuple[Piece, ...],
    catalog: Catalog,
    floor: WalkingFloor,
    times: Floats,
    half: float,
    most: int = MOST,
) -> list[Cells]:
    """Stops to see a group, at most ``most``: for each the cells of the raster that will do, the
    best one first; none if there is no way to it.

    A place lies before a side its objects are used from, with nothing between. Places are taken
    greedily by how many more objects they show; those in the open come first. Rows of seats are
    looked at from their rim. ``times`` are those from the entrance, ``half`` the clearance a
    visitor would like to have. ``times`` (c,) in seconds, one for each cell of the raster in
    row-major order.
    """
    boxes = np.array([[*p.pose[:2], p.pose.heading, *p.size[:2]] for p in members])
    views = _usable(_views(boxes, members, catalog, floor.clear), times, half)
    seats = bool(members) and any(word in members[0].category for word in SEATS)
    if seats:
        views = _at_the_rim(views, boxes)
    if not len(views.cells):
        return []
    return _cover(floor, _thin_views(views), views, min(most, MOST_OF_SEATS) if seats else most)


def _views(
    boxes: Floats, members: tuple[Piece, ...], catalog: Catalog, clear: DistanceRaster
) -> Views:
    """Places before every side in use."""
    lines = [np.zeros((0, len(AWAY) + 1, 2))]
    owners = []
    for k, (box, piece) in enumerate(zip(boxes, members, strict=True)):
        kind = catalog.kinds.get(piece.category)
        for side in (kind and kind.reached_from) or SIDES:
            lines.append(_before(box, SIDES.index(side), max(STOP_CLOSE, clear.cell)))
            owners += [k] * len(lines[-1])
    starts, points = np.split(np.concatenate(lines), [1], axis=1)
    owner = np.repeat(np.array(owners, np.int64), len(AWAY))
    starts, points = np.broadcast_to(starts, points.shape).reshape(-1, 2), points.reshape(-1, 2)
    room, cells = _look_up(clear, points)
    views = Views(points, cells, owner, room)
    return _some(views, (room > 0) & _in_sight(clear, starts, points))


def _before(box: Floats, side: int, close: float) -> Floats:
    """Points (k, 5, 2) before one side of a box: ``close`` and at the distances to stand at."""
    heading = box[2] + side * np.pi / 2
    wide, deep = (box[3], box[4]) if side % 2 == 0 else (box[4], box[3])
    count = max(int(np.ceil(wide / STOP_ALONG)), 1)
    across = ((np.arange(count) + 0.5) / count - 0.5) * wide
    u, v = np.meshgrid(across, deep / 2 + np.array([close, *AWAY]), indexing="ij")
    x = box[0] + u * np.sin(heading) + v * np.cos(heading)
    y = box[1] - u * np.cos(heading) + v * np.sin(heading)
    return np.stack([x, y], axis=-1)


def _look_up(clear: DistanceRaster, points: Floats) -> tuple[Floats, Cells]:
    """The clearance (k,) at points (k, 2) and the cells they are in; 0 off the raster."""
    shape = np.array(clear.values.shape)
    at = np.floor((points - (clear.x0, clear.y0)) / clear.cell).astype(np.int64)[:, ::-1]
    inside = ((at >= 0) & (at < shape)).all(axis=1)
    row, column = np.clip(at, 0, shape - 1).T
    return np.where(inside, clear.values[row, column], 0.0), row * shape[1] + column


def _in_sight(clear: DistanceRaster, starts: Floats, points: Floats) -> NDArray[np.bool_]:
    """Whether nothing lies between two points, looked at every 10 cm."""
    seen = np.ones(len(points), bool)
    for share in np.linspace(0.0, 1.0, 12, endpoint=False):
        seen &= _look_up(clear, starts + share * (points - starts))[0] > STOP_TOUCHING
    return seen


def _usable(views: Views, times: Floats, half: float) -> Views:
    """The places one can walk to: those in the open, by a way that is nowhere too narrow, if
    there are such."""
    took = times[views.cells]
    for wanted in ((took < NO_WIDTH) & (views.room >= half), took < NO_WIDTH):
        if wanted.any():
            return _some(views, wanted)
    return _some(views, np.isfinite(took))


def _some(views: Views, wanted: NDArray[np.bool_]) -> Views:
    return Views(
        views.points[wanted], views.cells[wanted], views.objects[wanted], views.room[wanted]
    )


def _at_the_rim(views: Views, boxes: Floats) -> Views:
    """The places outside the hull of a group; all of them if there are none."""
    hull = shapely.convex_hull(shapely.multipoints(corners(boxes).reshape(-1, 2)))
    outside = ~shapely.contains_xy(hull, views.points[:, 0], views.points[:, 1])
    return _some(views, outside) if outside.any() else views


def _thin_views(views: Views) -> Views:
    """The place with most room of every square, smaller ones for smaller groups."""
    low, high = views.points.min(axis=0), views.points.max(axis=0)
    square = max(0.5, float((high - low).max()) / 25)
    at = np.floor((views.points - low) / square).astype(np.int64)
    best = np.lexsort((-np.minimum(views.room, AT_EASE), at[:, 0], at[:, 1]))
    _, first = np.unique(at[best], axis=0, return_index=True)
    return _some(views, np.isin(np.arange(len(at)), best[first]))


def _cover(floor: WalkingFloor, places: Views, views: Views, most: int) -> list[Cells]:
    """Cells of places that together show as many objects as possible, each with the others that
    show what it adds."""
    shown = _find_visible_objects(floor, places, views)
    left = shown.copy()
    ease = 0.5 + 0.5 * np.minimum(places.room, AT_EASE) / AT_EASE
    found: list[Cells] = []
    while len(found) < most:
        gain = left.sum(axis=1)
        best = int(np.argmax(gain * ease))
        if gain[best] == 0 or (found and gain[best] < SHARE * shown.shape[1]):
            break
        added = left[best].copy()
        others = np.flatnonzero(shown[:, added].all(axis=1) & (ease > 0.9 * ease[best]))
        found.append(places.cells[[best, *others[others != best]]])
        left[:, added] = False
    return found


def _find_visible_objects(floor: WalkingFloor, places: Views, views: Views) -> NDArray[np.bool_]:
    """Which objects (n,) each of the places (k,) shows: those with a view
    that is near and not behind anything."""
    number = np.unique(views.objects, return_inverse=True)[1]
    shown = np.zeros((len(places.cells), int(number.max()) + 1), bool)
    near = np.zeros((len(places.cells), len(views.cells)), bool)
    cells = places.cells.astype(np.int32), views.cells.astype(np.int32)
    mark_near(near, floor.slow, floor.clear.cell, *cells, IN_VIEW)
    place, view = np.nonzero(near)
    shown[place, number[view]] = True
    return shown
