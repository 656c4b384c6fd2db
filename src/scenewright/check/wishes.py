"""Which wishes of a household came true, measured on the final pieces."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely

from scenewright.brief import Room
from scenewright.brief_wishes import WishBrief
from scenewright.check.bodies import Bodies, Rooms, Shape

WINDOW = 1.2
"""What is nearer to a window than this stands by it, in metres."""

CORNER = 0.3
"""What is nearer to a corner of the room than this stands in it, in metres."""


def wishes_told(bodies: Bodies, rooms: Rooms, asked: list[Room]) -> list[dict[str, Any]]:
    """Every wish of every room in words, whether it is fulfilled, and why not."""
    told = []
    for room, wishes in enumerate(r.wishes for r in asked):
        for wish in wishes:
            why = _why_not(bodies, rooms, room, wish)
            told.append({"space": rooms.spaces[room].id, "wish": in_words(wish),
                         "fulfilled": not why, "why": why})  # fmt: skip
    return told


def in_words(wish: WishBrief) -> str:
    """A wish as a person would say it.

    >>> in_words(WishBrief(what="desk", by="window", near="bookcase"))
    'desk by a window and within 1 m of bookcase'
    """
    if wish.forbid:
        return f"no {wish.what}".replace("_", " ")
    places = []
    if wish.by:
        places.append("by a window" if wish.by == "window" else "in a corner")
    if wish.near:
        places.append(f"within {wish.metres:g} m of {wish.near}")
    return f"{wish.what} {' and '.join(places)}".strip().replace("_", " ")


def _why_not(bodies: Bodies, rooms: Rooms, room: int, wish: WishBrief) -> str:
    """Why a wish is not fulfilled; empty if it is."""
    here = _shape(bodies, room, wish.what)
    if wish.forbid:
        return "" if here.is_empty else "it came with the brief"
    if here.is_empty:
        return "there is none in the room: it did not fit, or is left out"
    if wish.by:
        faults = _by_window(rooms, room, here) if wish.by == "window" else _cornered(
            rooms, room, here
        )  # fmt: skip
        if faults:
            return faults
    if wish.near:
        other = _shape(bodies, room, wish.near)
        if other.is_empty:
            return f"there is no {wish.near} in the room"
        gap = float(shapely.distance(here, other))
        if gap > wish.metres + 1e-6:
            return f"it stands {gap:.2f} m away"
    return ""


def _shape(bodies: Bodies, room: int, name: str) -> Shape:
    """The footprints of a group or of the pieces of a kind, in a room."""
    rows = [
        i for i, piece in enumerate(bodies.pieces)
        if bodies.room[i] == room and name in (piece.category, piece.function)
        and not bodies.flat[i]
    ]  # fmt: skip
    return shapely.union_all(bodies.footprints[np.array(rows, np.int64)])


def _by_window(rooms: Rooms, room: int, here: Shape) -> str:
    windows = [o for o in rooms.spaces[room].openings if o.kind == "window"]
    if not windows:
        return "the room has no window"
    gaps = []
    for o in windows:
        half = np.array([o.ux, o.uy]) * o.width / 2
        ends = [np.array([o.x, o.y]) - half, np.array([o.x, o.y]) + half]
        gaps.append(float(shapely.distance(here, shapely.LineString(ends))) - o.thickness / 2)
    return "" if min(gaps) <= WINDOW else f"the nearest window is {min(gaps):.2f} m away"


def _cornered(rooms: Rooms, room: int, here: Shape) -> str:
    corners = shapely.points(np.asarray(rooms.spaces[room].outline))
    gap = float(shapely.distance(here, corners).min())
    return "" if gap <= CORNER else f"the nearest corner is {gap:.2f} m away"
