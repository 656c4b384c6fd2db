"""Which wishes of a brief are met, measured on the final pieces.

Distances are between footprints, and from footprints to the face of the wall an opening is in. A
thing faces another if some of that lies within 30 degrees of straight ahead of its middle; of a
group the largest piece counts, and people at a desk look over it.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely

from scenewright.check.bodies import Bodies, Indices, Rooms, Shape
from scenewright.core.brief import Room
from scenewright.core.brief.wishes import NEAREST, OPENINGS, SIGHT, WishBrief
from scenewright.core.space import Opening

_OVER = frozenset(("desk", "kids_desk", "vanity", "piano"))  # one sits before it, looking over it
_FAR = 200.0
_IN_WORDS = {
    "window": "by a window",
    "door": "by a door",
    "wall": "at a wall",
    "corner": "in a corner",
}


def wishes_told(bodies: Bodies, rooms: Rooms, asked: list[Room]) -> list[dict[str, Any]]:
    """Every wish of every room in words, whether it is met, and why not."""
    lines = []
    for room, wishes in enumerate(r.wishes for r in asked):
        for wish in wishes:
            why = _why_not(bodies, rooms, room, wish)
            lines.append(
                {
                    "space": rooms.spaces[room].id,
                    "wish": in_words(wish),
                    "fulfilled": not why,
                    "why": why,
                }
            )
    return lines


def in_words(wish: WishBrief) -> str:
    """A wish as a person would say it.

    >>> in_words(WishBrief(what="desk", by="window", near="bookcase"))
    'desk by a window and within 1 m of bookcase'
    >>> in_words(WishBrief(what="armchair", face="window", away_from="door"))
    'armchair facing a window and at least 2 m away from a door'
    """
    if wish.forbid:
        return f"no {wish.what}".replace("_", " ")
    places = [_IN_WORDS[wish.by]] if wish.by else []
    if wish.face:
        places.append(f"facing {_get_display_name(wish.face)}")
    if wish.near:
        places.append(f"within {wish.within:g} m of {wish.near}")
    if wish.away_from:
        places.append(f"at least {wish.beyond:g} m away from {_get_display_name(wish.away_from)}")
    return f"{wish.what} {' and '.join(places)}".strip().replace("_", " ")


def _get_display_name(name: str) -> str:
    return f"a {name}" if name in OPENINGS else name


def _why_not(bodies: Bodies, rooms: Rooms, room: int, wish: WishBrief) -> str:
    """Why a wish is not met; empty if it is."""
    rows = _rows(bodies, room, wish.what)
    if wish.forbid:
        return _why_there(bodies, rows)
    if not len(rows):
        return "there is none in the room"
    here = shapely.union_all(bodies.footprints[rows])
    faults = [
        _not_by(rooms, room, here, wish.by) if wish.by else "",
        _not_facing(bodies, rooms, room, rows, wish.face) if wish.face else "",
        _too_far(bodies, rooms, room, rows, wish) if wish.near else "",
        _too_near(bodies, rooms, room, rows, wish) if wish.away_from else "",
    ]
    return next(filter(None, faults), "")


def _rows(bodies: Bodies, room: int, name: str) -> Indices:
    """The pieces of a group or kind in a room."""
    return np.array(
        [
            i
            for i, piece in enumerate(bodies.pieces)
            if bodies.room[i] == room
            and name in (piece.category, piece.function)
            and not bodies.flat[i]
        ],
        np.int64,
    )


def _why_there(bodies: Bodies, rows: Indices) -> str:
    """Why something forbidden stands in a room; empty if nothing does."""
    if not len(rows):
        return ""
    given = all(bodies.pieces[i].fixed for i in rows)
    return "it is fixed in the brief" if given else "another request brings it"


def _target(bodies: Bodies, rooms: Rooms, room: int, rows: Indices, name: str) -> Shape:
    """Openings of a room as lines on its walls' faces, or the footprints of a group or kind,
    less the ``rows`` that are to stand by it: nothing is near itself."""
    if name not in OPENINGS:
        return shapely.union_all(bodies.footprints[np.setdiff1d(_rows(bodies, room, name), rows)])
    return _openings(rooms, room, name)


def _none(name: str) -> str:
    return f"the room has no {name}" if name in OPENINGS else f"there is no {name} in the room"


def _openings(rooms: Rooms, room: int, kind: str) -> Shape:
    return shapely.union_all(
        [
            _face(rooms, room, o)
            for o in rooms.spaces[room].openings
            if (o.kind == "window") == (kind == "window")
        ]
    )


def _face(rooms: Rooms, room: int, opening: Opening) -> Shape:
    """An opening as a line on the face of its wall that looks into the room."""
    middle, along = np.array([opening.x, opening.y]), np.array([opening.ux, opening.uy])
    side = np.array([-along[1], along[0]]) * opening.thickness / 2
    faces = [
        shapely.LineString([m - along * opening.width / 2, m + along * opening.width / 2])
        for m in (middle - side, middle + side)
    ]
    return min(faces, key=lambda f: float(shapely.distance(f.centroid, rooms.shapes[room])))


def _not_by(rooms: Rooms, room: int, here: Shape, what: str) -> str:
    outline = np.asarray(rooms.spaces[room].outline)
    if what == "corner":
        target = shapely.MultiPoint(outline)
    elif what == "wall":
        target = shapely.LinearRing(outline)
    else:
        target = _openings(rooms, room, what)
    if target.is_empty:
        return f"the room has no {what}"
    gap = float(shapely.distance(here, target))
    return "" if gap <= NEAREST[what] else f"the nearest {what} is {gap:.2f} m away"


def _not_facing(bodies: Bodies, rooms: Rooms, room: int, rows: Indices, name: str) -> str:
    target = _target(bodies, rooms, room, rows, name)
    if target.is_empty:
        return _none(name)
    i = int(rows[np.argmax(shapely.area(bodies.footprints[rows]))])
    pose = bodies.pieces[i].pose
    look = pose.heading + (np.pi if bodies.pieces[i].category in _OVER else 0.0)
    eye = np.array([pose.x, pose.y])
    seen = [eye] + [
        eye + _FAR * np.array([np.cos(look + a), np.sin(look + a)]) for a in (-SIGHT, SIGHT)
    ]
    if shapely.intersects(shapely.Polygon(seen), target):
        return ""
    ways = shapely.get_coordinates(shapely.segmentize(target, 0.05)) - eye
    off = np.abs((np.arctan2(ways[:, 1], ways[:, 0]) - look + np.pi) % (2 * np.pi) - np.pi)
    return f"it faces {np.degrees(off.min()):.0f}° to the side"


def _too_far(bodies: Bodies, rooms: Rooms, room: int, rows: Indices, wish: WishBrief) -> str:
    other = _target(bodies, rooms, room, rows, str(wish.near))
    if other.is_empty:
        return _none(str(wish.near))
    gap = float(shapely.distance(shapely.union_all(bodies.footprints[rows]), other))
    return "" if gap <= wish.within + 1e-6 else f"it stands {gap:.2f} m away"


def _too_near(bodies: Bodies, rooms: Rooms, room: int, rows: Indices, wish: WishBrief) -> str:
    """No piece that is not there is too near; an opening that is not there is a slip."""
    other = _target(bodies, rooms, room, rows, str(wish.away_from))
    if other.is_empty and wish.away_from in OPENINGS:
        return f"the room has no {wish.away_from}"
    here = shapely.union_all(bodies.footprints[rows])
    gap = np.inf if other.is_empty else float(shapely.distance(here, other))
    return "" if gap >= wish.beyond - 1e-6 else f"it stands only {gap:.2f} m away"
