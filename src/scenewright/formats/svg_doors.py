"""Which way people go in and out: triangles at the doors to the outside, and door widths."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.formats.svg_marks import (
    EXIT,
    FINE,
    GREY,
    INK,
    View,
    group,
    plate,
    shape,
    text,
    text_width,
    to_paper,
)  # fmt: skip
from scenewright.formats.svg_shell import frame_of
from scenewright.space import Opening

AWAY, LONG, WIDE = 0.9, 2.3, 2.6
"""Millimetres from the wall to a triangle, its length and its width."""

FIGURE, NOTE, LEAST = 1.5, 1.8, 1.1
"""Text heights in millimetres: widths in doors, notes beside them, the least that can be read."""

WORDS = {"entrance": "Entrance", "exit": "Exit", "both": "In and out"}

Vector = NDArray[np.float64]


def doors_mark(view: View, openings: Sequence[Opening], notes: bool) -> str:
    """Widths in the doors between rooms, triangles at those that lead outside; with ``notes``
    (in halls) what they are for and their width beside them."""
    doors = [opening for opening in openings if opening.kind != "window"]
    marks = []
    for door in doors:
        outer = len(door.spaces) == 1
        marks.append(_ways(view, door, notes) if outer else "")
        marks.append(_note(view, door) if outer and notes else _width(view, door))
    return group(marks)


def outwards(door: Opening) -> Vector:
    """Unit vector of the plan out of the first of the door's spaces, which lies on its left."""
    return -frame_of(door)[2]


def _ways(view: View, door: Opening, paired: bool) -> str:
    """A triangle into the building or out of it; where ``paired`` both, side by side, at wide
    doors people use both ways."""
    both = paired and door.use == "both" and door.width * view.scale > 2 * WIDE
    uses = ("entrance", "exit") if both else (door.use,)
    shifts = (np.arange(len(uses)) - (len(uses) - 1) / 2) * (WIDE + 0.6)
    return "\n".join(
        _triangle(view, door, use, shift) for use, shift in zip(uses, shifts, strict=True)
    )


def _triangle(view: View, door: Opening, use: str, shift: float) -> str:
    """Before the door, or behind it where its leaf turns outwards; green if it points out."""
    middle, along, _ = frame_of(door)
    out = outwards(door)
    side = -out if door.swing < 0 else out
    face = to_paper(view, middle + side * door.thickness / 2) + AWAY * _paper(side)
    face = face + shift * _paper(along)
    near, far = face, face + LONG * _paper(side)
    inwards = use != "exit"
    tip, foot = (near, far) if inwards == (door.swing >= 0) else (far, near)
    half = WIDE / 2 * _paper(along)
    fill = INK if inwards else EXIT
    return shape([[tip, foot + half, foot - half]], fill=fill, stroke="#ffffff", stroke_width=FINE)


def _width(view: View, door: Opening) -> str:
    """The clear width in metres, set into the opening where the wall is thick enough."""
    size = min(FIGURE, 0.62 * door.thickness * view.scale)
    words = f"{door.width:.2f}"
    room = door.width * view.scale - 0.6
    if size < LEAST or text_width(words, size) > room or (door.kind == "door" and not door.hinge):
        return ""
    middle, along, _ = frame_of(door)
    return text(words, to_paper(view, middle), size, _turn(along), fill=GREY, stroke="none")


def _note(view: View, door: Opening) -> str:
    """What the door is for and its width, outside, beside it along the wall."""
    middle, along, _ = frame_of(door)
    words = f"{WORDS[door.use]} {door.width:.2f} m"
    reach = door.width / 2 * view.scale + 1.2 + text_width(words, NOTE) / 2
    at = to_paper(view, middle + outwards(door) * door.thickness / 2)
    at = at + (AWAY + LONG / 2) * _paper(outwards(door)) + reach * _paper(along)
    fill = EXIT if door.use == "exit" else INK
    return plate(words, at, NOTE, turn=_turn(along), fill=fill, font_weight="bold")


def _paper(vector: Vector) -> Vector:
    return np.asarray(vector, dtype=float) * (1.0, -1.0)


def _turn(along: Vector) -> float:
    """Degrees at which text along a wall reads from below or from the right."""
    degrees = float(np.degrees(np.arctan2(along[1], along[0])))
    return (degrees + 90.0 - 1e-6) % 180.0 - 90.0 + 1e-6
