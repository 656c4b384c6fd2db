"""Stairs in plan, as architects draw them: on the lower floor solid up to the cut and dashed above
it, on the upper floor seen through the well; the arrow goes up on both."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.ops import substring

from scenewright.building.stair_parts import railing_lines, well_of
from scenewright.core.space import Space
from scenewright.core.stairs import Stairs, Tread, describe_stairs
from scenewright.drawing.labels import polygon_of
from scenewright.drawing.marks import (
    FINE,
    GREY,
    INK,
    LINE,
    Mark,
    PaperView,
    arrow_head,
    disc,
    group,
    line,
    shape,
    title,
    to_paper,
)
from scenewright.drawing.shell import CUT_HEIGHT

Floats = NDArray[np.float64]

DASHES = "0.9 0.6"
BREAK = 0.16
"""Half the height of the zigzag of the cut line, metres."""
HEAD = 1.5
"""Length of the arrow's head, millimetres."""
WHITE = "#ffffff"


def stairs_mark(
    view: PaperView, stairs: Sequence[Stairs], level: str, spaces: Sequence[Space]
) -> Mark:
    """The stairs that lead up from a level, over those that arrive in it."""
    floors = [polygon_of(space) for space in spaces]
    arriving = [_upper(view, one, floors) for one in stairs if one.upper == level]
    leaving = [_lower(view, one) for one in stairs if one.level == level]
    return group([*arriving, *leaving], stroke_linejoin="round", stroke_linecap="round")


def _lower(view: PaperView, stairs: Stairs) -> Mark:
    """Up to the cut solid, above it dashed; the cut line across; the arrow as far as the cut."""
    solid = [t for t in stairs.treads if t.height <= CUT_HEIGHT]
    rest = [t for t in stairs.treads if t.height > CUT_HEIGHT]
    marks = [title(f"{stairs.name or stairs.id}: {describe_stairs(stairs)}")]
    marks += _treads(view, rest, stroke=GREY, stroke_width=FINE, stroke_dasharray=DASHES)
    marks += _treads(view, solid, stroke=INK, stroke_width=LINE, fill=WHITE)
    if solid and rest:
        marks.append(_cut(view, rest[0]))
    middle = _along(stairs, _get_tread_share(stairs, rest[0]) if rest else 1.0)
    marks.append(_arrow(view, middle))
    return group(marks)


def _upper(view: PaperView, stairs: Stairs, floors: Sequence[shapely.Polygon]) -> Mark:
    """The well with the steps seen in it, the railing, and the arrow as far as the head."""
    well = well_of(stairs)
    marks = [title(f"{stairs.name or stairs.id}: {describe_stairs(stairs)}")]
    rings = [to_paper(view, part.exterior.coords[:-1]) for part in shapely.get_parts(well)]
    marks.append(shape(rings, fill=WHITE, stroke=GREY, stroke_width=FINE))
    seen = [t for t in stairs.treads if well.covers(shapely.Polygon(t.outline).centroid)]
    marks += _treads(view, seen, stroke=INK, stroke_width=FINE)
    for rail in railing_lines(stairs, floors):
        marks.append(
            line(to_paper(view, rail.coords), fill="none", stroke=INK, stroke_width=2 * LINE)
        )
    first = _get_tread_share(stairs, seen[0]) if seen else 0.0
    marks.append(_arrow(view, _along(stairs, 1.0, first)))
    return group(marks)


def _treads(view: PaperView, treads: Sequence[Tread], **pen: str | float) -> Iterator[Mark]:
    for tread in treads:
        yield shape([to_paper(view, tread.outline)], **({"fill": "none"} | pen))


def _cut(view: PaperView, tread: Tread) -> Mark:
    """The cut line: across the first step above the cut, with a zigzag in its middle."""
    a, b = tread.outline[0], tread.outline[1]
    across = b - a
    along = np.array([-across[1], across[0]]) / max(float(np.hypot(*across)), 1e-9) * BREAK
    slant = 0.5 * along
    points = [
        a - 0.06 * across - slant,
        a + 0.42 * across,
        a + 0.46 * across - along,
        a + 0.54 * across + along,
        a + 0.58 * across,
        b + 0.06 * across + slant,
    ]
    return line(to_paper(view, np.array(points)), fill="none", stroke=INK, stroke_width=LINE)


def _get_tread_share(stairs: Stairs, tread: Tread) -> float:
    """The share of the line one walks at which a tread begins."""
    walk = shapely.LineString(stairs.walk)
    nosing = shapely.Point(tread.outline[:2].mean(0))
    return float(walk.project(nosing, normalized=True))


def _along(stairs: Stairs, share: float, start: float = 0.0) -> Floats:
    """The line one walks, from one share of its length to another."""
    walk = shapely.LineString(stairs.walk)
    part = substring(walk, start, max(share, start + 0.15), normalized=True)
    return np.asarray(shapely.get_coordinates(part), np.float64)


def _arrow(view: PaperView, path: Floats) -> Mark:
    """A line with a ring where it sets out and a head where it leads."""
    points = to_paper(view, path)
    head = arrow_head(points[-1], points[-1] - points[-2], HEAD)
    ring = disc(points[0], 0.45, fill=WHITE, stroke=INK, stroke_width=LINE)
    return group(
        [
            line(points, fill="none", stroke=INK, stroke_width=LINE),
            shape([head], fill=INK, stroke="none"),
            ring,
        ]
    )
