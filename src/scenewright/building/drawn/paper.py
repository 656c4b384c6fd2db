"""A page as painted: paths with pens and fills, words; what is dark on it, and its arcs."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Sequence
from itertools import groupby
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.drawn.drawing import Arc, Word
from scenewright.building.drawn.sheet import Layer, Sheet, is_near

DARK = 0.55
"""The lightness below which a fill is that of a wall cut through."""
QUARTER, ROUND = (70.0, 110.0), 0.02
"""Degrees of the arcs that leaves sweep; how far their points may lie off, in radii."""
LEAST_POINTS = 6
"""Points of a polyline that may be an arc."""
FRAME = (0.8, 0.12)
"""A line of the page's frame: its least share of the page's side, and how far from the edge."""
MOST_PARTS, LETTER = 300, 0.01
"""Dark parts of a page that are no letters, and the largest letter by the page's diagonal."""
PLAIN = 1e-4
"""How far corners of what is dark may lie off lines to be left out, by the page's diagonal: paint
over the end of a curved wall leaves steps as small."""
WHITE, FLOOR = 0.99, 0.02
"""The lightness of white; the side of the least floor by the page's diagonal."""
DARK_FILLS, LIGHT_FILLS, PAGE_FRAME = "dark fills", "light fills", "page frame"
Vector = NDArray[np.float64]


class Run(NamedTuple):
    """Points (n, 2) of a path, joined by lines, and whether they follow a curve."""

    points: Vector
    curved: bool


class Shape(NamedTuple):
    """A path: its subpaths, each of runs that begin where the last one ended; the lightness of its
    fill and the width of its pen (``None``: none), and the layer it says to lie on."""

    subpaths: tuple[tuple[Run, ...], ...]
    fill: float | None
    pen: float | None
    layer: str = ""


class Paper(NamedTuple):
    """A page: shapes in the order they are painted, words, its corners (low, high), the metres a
    unit of it is on paper, and whether it has a size on paper at all. y is upwards."""

    shapes: tuple[Shape, ...]
    words: tuple[Word, ...]
    low: Vector
    high: Vector
    metres: float
    printed: bool


def sheet_of(paper: Paper) -> tuple[Sheet, dict[str, float]]:
    """What a page paints as a sheet of layers, one a pen (and a layer it names), one of all that is
    dark; and the widths of the pens."""
    layers: dict[str, Layer] = {}
    pens: dict[str, float] = {}
    shapes = _list_seen(paper.shapes)
    for shape in paper.shapes:
        layers.setdefault(_layer_name(shape), Layer()).count("PATH")
    for shape in shapes:
        name = _layer_name(shape)
        if shape.pen is not None:
            pens[name] = shape.pen
        _add_shape(layers[name], shape)
    if paper.printed:
        _take_frame(layers, paper)
    solid = layers.setdefault(DARK_FILLS, Layer())
    tolerance = PLAIN * float(np.hypot(*(paper.high - paper.low)))
    dark = shapely.simplify(_without_letters(dark_area(shapes), paper), tolerance)
    for ring in _rings_of(dark):
        solid.add_path(ring.tolist())
    words = layers.setdefault("words", Layer())
    for word in paper.words:
        words.count("TEXT")
        words.add_word(word)
    return Sheet(layers, None, (), dark, tuple(_coloured(paper))), pens


def _layer_name(shape: Shape) -> str:
    if shape.pen is None:
        return DARK_FILLS if shape.fill is not None and shape.fill < DARK else LIGHT_FILLS
    pen = f"pen {shape.pen:.2f}"
    return f"{shape.layer} ({pen})" if shape.layer else pen


def _list_seen(shapes: Sequence[Shape]) -> list[Shape]:
    """Shapes in the order they are painted, of those that are the same the last, which is seen."""
    return list({_painted(shape): shape for shape in reversed(shapes)}.values())[::-1]


def _painted(shape: Shape) -> Hashable:
    """A key that is equal for shapes that look like one."""
    runs = (run for subpath in shape.subpaths for run in subpath)
    return shape.fill, shape.pen, shape.layer, tuple(run.points.tobytes() for run in runs)


def _add_shape(layer: Layer, shape: Shape) -> None:
    lettered = shape.pen is None and shape.fill is not None and shape.fill < DARK
    for run in (run for subpath in shape.subpaths for run in subpath):
        arc = None if lettered else arc_of(run)
        if arc is not None:
            layer.add_arc(arc)
        elif shape.pen is not None:
            layer.add_path(run.points.tolist())


def _take_frame(layers: dict[str, Layer], paper: Paper) -> None:
    """Move the frame of a printed page to a layer of its own: lines along its edges, unless more
    is joined to them than they are long, as to the outer walls of a plan that fills the page."""
    homes = [(layer, row) for layer in layers.values() for row in layer.lines]
    lines = np.array([row for _, row in homes]).reshape(-1, 2, 2)
    framed = _along_edges(lines, paper)
    if not framed.any():
        return
    drawn = shapely.linestrings(lines)
    longest = shapely.length(drawn[framed]).sum()
    reached, new = framed.copy(), framed
    tree = shapely.STRtree(drawn)
    while new.any() and shapely.length(drawn[reached & ~framed]).sum() < longest:
        touched = np.unique(tree.query(drawn[new], predicate="intersects")[1])
        new = np.zeros_like(reached)
        new[touched] = ~reached[touched]
        reached |= new
    if shapely.length(drawn[reached & ~framed]).sum() < longest:
        frame = layers.setdefault(PAGE_FRAME, Layer())
        frame.lines += [row for (_, row), within in zip(homes, framed, strict=True) if within]
        gone = set(frame.lines)
        for layer in {id(home): home for home, _ in homes}.values():
            layer.lines = [row for row in layer.lines if row not in gone]


def _along_edges(lines: Vector, paper: Paper) -> NDArray[np.bool_]:
    """Which lines run along an edge of the page, nearly as long as the page is."""
    sides = paper.high - paper.low
    found = np.zeros(len(lines), dtype=bool)
    for along, across in ((0, 1), (1, 0)):
        way = np.abs(lines[:, 1] - lines[:, 0])
        place = lines[:, 0, across]
        edge = np.minimum(place - paper.low[across], paper.high[across] - place)
        straight = way[:, across] < 1e-3 * sides[across]
        long = way[:, along] >= FRAME[0] * sides[along]
        found |= straight & long & (edge <= FRAME[1] * sides[across])
    return found


def dark_area(shapes: Sequence[Shape]) -> shapely.Geometry:
    """What is dark once all is painted: light fills cover the dark ones below them."""
    area: shapely.Geometry = shapely.Polygon()
    filled = [shape for shape in shapes if shape.fill is not None]
    for dark, group in groupby(filled, key=lambda s: bool(s.fill is not None and s.fill < DARK)):
        if not dark and area.is_empty:
            continue
        painted = shapely.union_all([_filled(shape) for shape in group])
        area = area.union(painted) if dark else area.difference(painted)
    return area


def _coloured(paper: Paper) -> Iterator[shapely.Polygon]:
    """Areas painted neither dark nor white that are large enough for a room."""
    least = (FLOOR * float(np.hypot(*(paper.high - paper.low)))) ** 2
    for shape in paper.shapes:
        if shape.fill is not None and DARK <= shape.fill < WHITE:
            parts = shapely.get_parts(_filled(shape))
            yield from (p for p in parts if p.geom_type == "Polygon" and p.area >= least)


def _without_letters(area: shapely.Geometry, paper: Paper) -> shapely.Geometry:
    """What is dark without its small parts where these are as many as letters drawn as shapes."""
    parts = shapely.get_parts(area)
    if len(parts) <= MOST_PARTS:
        return area
    box = shapely.bounds(parts)
    sides = np.maximum(box[:, 2] - box[:, 0], box[:, 3] - box[:, 1])
    return shapely.multipolygons(parts[sides > LETTER * float(np.hypot(*(paper.high - paper.low)))])


def _filled(shape: Shape) -> shapely.Geometry:
    """The area of a shape, holes by the even-odd rule."""
    rings = [np.vstack([run.points for run in subpath]) for subpath in shape.subpaths if subpath]
    rings = [ring for ring in rings if len(ring) >= 3 and is_near(*ring.ravel().tolist())]
    faces = [shapely.make_valid(shapely.Polygon(ring)) for ring in rings]
    area: shapely.Geometry = shapely.Polygon()
    for face in faces:
        area = area.symmetric_difference(face)
    return area


def _rings_of(area: shapely.Geometry) -> Iterable[Vector]:
    for part in shapely.get_parts(area):
        if part.geom_type == "Polygon":
            yield from (np.asarray(ring.coords) for ring in (part.exterior, *part.interiors))


def arc_of(run: Run) -> Arc | None:
    """The quarter circle that a run of points is, if it is one.

    >>> turn = np.linspace(0.0, np.pi / 2, 9)
    >>> arc_of(Run(np.stack([np.cos(turn), np.sin(turn)], 1), True)).radius
    1.0
    """
    points = run.points
    if len(points) < LEAST_POINTS or not is_near(*points.ravel().tolist()):
        return None
    middle, radius = _circle(points)
    if not 0.0 < radius < 1e9:
        return None
    away = points - middle
    if np.abs(np.hypot(*away.T) - radius).max() > ROUND * radius:
        return None
    turns = np.unwrap(np.arctan2(away[:, 1], away[:, 0]))
    if not QUARTER[0] <= abs(np.degrees(turns[-1] - turns[0])) <= QUARTER[1]:
        return None
    start, end = ((float(x), float(y)) for x, y in points[[0, -1]])
    return Arc((float(middle[0]), float(middle[1])), round(radius, 9), start, end)


def _circle(points: Vector) -> tuple[Vector, float]:
    """The middle and radius of the circle nearest to points (by algebraic distance)."""
    mean = points.mean(0)
    near = points - mean
    size = float(np.abs(near).max()) or 1.0
    near = near / size
    columns = np.column_stack([2 * near, np.ones(len(near))])
    found, *_ = np.linalg.lstsq(columns, (near**2).sum(1), rcond=None)
    radius = float(np.sqrt(max(found[2] + found[:2] @ found[:2], 0.0)))
    return mean + size * found[:2], size * radius
