"""Outlets on the plan: at the wall they are on, in the manner of IEC 60617.

A socket is an arc that opens into the room on a stem, with the bar of its earth contact; antenna
and data sockets are open boxes with letters; a tap with its drain is a ring round a dot.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.core.space import Outlet, Space
from scenewright.drawing.marks import (
    LINE,
    ROUTE,
    Mark,
    PaperView,
    disc,
    group,
    line,
    text,
    title,
    to_paper,
)

Points = NDArray[np.float64]

STEM, RADIUS, LETTERS = 0.7, 1.0, 1.5
"""Millimetres on paper: from the wall to the symbol, its half width, the height of letters."""
HALO = 3 * LINE
WORDS = {"antenna": "TV", "data": "D"}
_ARC = np.linspace(-np.pi / 2, np.pi / 2, 13)


def outlets_mark(view: PaperView, spaces: Sequence[Space]) -> Mark:
    """The outlets of rooms, readable over furniture."""
    return group([_outlet(view, outlet) for space in spaces for outlet in space.outlets])


def _outlet(view: PaperView, outlet: Outlet) -> Mark:
    """One symbol with what it is."""
    foot = to_paper(view, [outlet.x, outlet.y])
    ahead = np.array([np.cos(outlet.heading), -np.sin(outlet.heading)])
    message = f"{outlet.kind} outlet" + (", required" if outlet.required else "")
    return group([title(message), outlet_sign(outlet.kind, foot, ahead)])


def outlet_sign(kind: str, foot: Points, ahead: Points) -> Mark:
    """The symbol of a kind on paper, its stem standing on the wall at ``foot``."""
    side = np.array([-ahead[1], ahead[0]])

    def at(points: Points) -> Points:
        return foot + points[:, :1] * side + points[:, 1:] * ahead

    lines = [at(np.array(points, float)) for points in _lines(kind)]
    marks = [
        line(points, fill="none", stroke=colour, stroke_width=pen, stroke_linecap="round")
        for colour, pen in (("#ffffff", HALO), (ROUTE, LINE))
        for points in lines
    ]
    if kind == "water":
        ring = foot + (STEM + RADIUS) * ahead
        marks.append(disc(ring, RADIUS, fill="#ffffff", stroke=ROUTE, stroke_width=LINE))
        marks.append(disc(ring, 0.4 * RADIUS, fill=ROUTE))
    if kind in WORDS:
        words = foot + (STEM + RADIUS + LETTERS) * ahead
        marks.append(text(WORDS[kind], words, LETTERS, fill=ROUTE))
    return group(marks)


def _lines(kind: str) -> list[list[tuple[float, float]]]:
    """Strokes in millimetres: to the side, and ahead from the wall."""
    stem = [(0.0, 0.0), (0.0, STEM)]
    if kind == "water":
        return [stem]
    if kind in WORDS:
        r, deep = RADIUS, STEM + RADIUS
        return [stem, [(-r, deep), (-r, STEM), (r, STEM), (r, deep)]]
    arc = [(RADIUS * np.sin(a), STEM + RADIUS * (1 - np.cos(a))) for a in _ARC]
    return [stem, arc, [(-RADIUS, STEM), (RADIUS, STEM)]]
