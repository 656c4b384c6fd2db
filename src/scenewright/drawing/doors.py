"""Which way people go in and out: triangles at the doors to the outside, and door widths."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray
from shapely import Geometry, Point, Polygon, get_coordinates

from scenewright.core.space import Opening
from scenewright.drawing.marks import (
    EXIT,
    FINE,
    GREY,
    INK,
    NOTHING,
    Mark,
    PaperView,
    group,
    plate,
    shape,
    text,
    text_width,
    to_paper,
)
from scenewright.drawing.shell import frame_of

AWAY, LONG, WIDE = 0.9, 2.3, 2.6
"""Millimetres from the wall to a triangle, its length and its width."""

FIGURE, NOTE, THIN = 1.5, 1.8, 1.3
"""Text heights in millimetres: widths in doors, notes beside them; the thinnest wall that holds a
figure."""

HEIGHTS = 1.5
"""Text height in millimetres of sill and head heights."""

BULGE, NO_WALLS = 0.5, Polygon()
"""Metres before a window in which low walls are looked for; none of them."""

WORDS = {"entrance": "Entrance", "exit": "Exit", "both": "In and out"}

Vector = NDArray[np.float64]


def doors_mark(
    view: PaperView, openings: Sequence[Opening], middle: ArrayLike | None = None
) -> Mark:
    """Widths in the doors between rooms and a triangle at those that lead outside. In halls
    there are words and the width beside the triangle, towards the ``middle`` of the plan."""
    doors = [opening for opening in openings if opening.kind != "window"]
    marks = []
    for door in doors:
        if len(door.spaces) > 1:
            marks.append(_width(view, door))
        elif middle is None:
            marks += [_width(view, door), _before(view, door)]
        else:
            marks.append(_note(view, door, np.asarray(middle, dtype=float)))
    return group(marks)


def heights_mark(view: PaperView, openings: Sequence[Opening], low: Geometry = NO_WALLS) -> Mark:
    """Heights of the sill and the head of each window above the floor, in metres, outside it and
    the ``low`` walls below windows, which bulge in a bow front."""
    windows = [o for o in openings if o.kind == "window" and o.roof is None]
    return group([_heights(view, window, low) for window in windows], fill=GREY, stroke="none")


def _bulge(window: Opening, low: Geometry) -> float:
    """How far low walls stand out of the face of a window's wall before it, in metres."""
    middle, along, _ = frame_of(window)
    half, out = along * window.width / 2, outwards(window)
    near = middle + out * window.thickness / 2
    far = near + out * BULGE
    there = Polygon([near - half, near + half, far + half, far - half]).intersection(low)
    if there.is_empty:
        return 0.0
    return float(((get_coordinates(there) - near) @ out).max())


def _heights(view: PaperView, window: Opening, low: Geometry) -> Mark:
    """Both heights in words if the window is wide enough, else as two figures."""
    figures = f"{window.sill:.2f}", f"{window.head:.2f}"
    room = window.width * view.scale
    tried = "sill {} · head {}".format(*figures), "{} / {}".format(*figures)
    words = next((words for words in tried if text_width(words, HEIGHTS) <= room), "")
    if not words:
        return NOTHING
    middle, along, _ = frame_of(window)
    out = _paper(outwards(window))
    face = window.thickness / 2 + _bulge(window, low)
    at = to_paper(view, middle) + out * (face * view.scale + 0.9 * HEIGHTS)
    return text(words, at, HEIGHTS, _turn(along))


def outwards(door: Opening) -> Vector:
    """Unit vector of the plan out of the first of the door's spaces, which lies on its left."""
    return -frame_of(door)[2]


def _before(view: PaperView, door: Opening) -> Mark:
    """A triangle before the door, or behind it where its leaf turns outwards."""
    return triangle(to_paper(view, _foot(view, door)), _paper(-outwards(door)), INK)


def _foot(view: PaperView, door: Opening) -> Vector:
    """The middle of the triangle before a door, in plan metres."""
    side = outwards(door) * (-1.0 if door.swing < 0 else 1.0)
    away = door.thickness / 2 + (AWAY + LONG / 2) / view.scale
    found: Vector = frame_of(door)[0] + side * away
    return found


def triangle_places(view: PaperView, openings: Sequence[Opening]) -> list[Polygon]:
    """The area of the triangles of doors to the outside, in plan metres."""
    doors = [o for o in openings if o.kind != "window" and len(o.spaces) < 2]
    return [Point(_foot(view, door)).buffer(0.7 * LONG / view.scale) for door in doors]


def triangle(at: Vector, way: Vector, fill: str) -> Mark:
    """A triangle on paper, its middle at ``at``, that points along ``way``."""
    half = WIDE / 2 * np.array([-way[1], way[0]])
    foot = at - LONG / 2 * way
    corners = [at + LONG / 2 * way, foot + half, foot - half]
    return shape([corners], fill=fill, stroke="#ffffff", stroke_width=FINE)


def _width(view: PaperView, door: Opening) -> Mark:
    """The clear width in metres, set into the opening where the wall is thick enough."""
    words = f"{door.width:.2f}"
    room, thick = door.width * view.scale - 0.6, door.thickness * view.scale
    if thick < THIN or text_width(words, FIGURE) > room or (door.kind == "door" and not door.hinge):
        return NOTHING
    middle, along, _ = frame_of(door)
    return text(words, to_paper(view, middle), FIGURE, _turn(along), fill=GREY, stroke="none")


def _note(view: PaperView, door: Opening, middle: Vector) -> Mark:
    """Triangles in and out, what the door is for and its width: outside, beside it."""
    at, along, _ = frame_of(door)
    out = _paper(outwards(door))
    sign = 1.0 if (middle - at) @ along > 0 else -1.0
    along = sign * _paper(along)
    place = to_paper(view, at) + out * (door.thickness / 2 * view.scale + AWAY + LONG / 2)
    place = place + along * (door.width / 2 * view.scale + 0.8 + WIDE / 2)
    marks = []
    for use, way, fill in (("entrance", -out, INK), ("exit", out, EXIT)):
        if door.use in (use, "both"):
            marks.append(triangle(place, way, fill))
            place = place + (WIDE + 0.5) * along
    words = f"{WORDS[door.use]} {door.width:.2f} m"
    place = place + along * (text_width(words, NOTE) * 1.1 / 2 - WIDE / 2)
    fill = EXIT if door.use == "exit" else INK
    turn = _turn(_paper(along))
    return group([*marks, plate(words, place, NOTE, turn=turn, fill=fill, font_weight="bold")])


def _paper(vector: Vector) -> Vector:
    return np.asarray(vector, dtype=float) * (1.0, -1.0)


def _turn(along: Vector) -> float:
    """Degrees at which text along a wall reads from below or from the right."""
    degrees = float(np.degrees(np.arctan2(along[1], along[0])))
    return (degrees + 90.0 - 1e-6) % 180.0 - 90.0 + 1e-6
