"""Stairs and the railings round their wells as meshes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import inf

import numpy as np
import shapely

from scenewright.catalog.assets.materials import BLACK, OAK, WALNUT, WHITE
from scenewright.core.catalog import Part
from scenewright.core.layout import corners
from scenewright.core.stairs import EYE, Stairs, Tread
from scenewright.geometry.mesh import Floats, Mesh, merge
from scenewright.geometry.prisms import prism
from scenewright.geometry.solids import rod

PLATE = 0.04
"""Thickness of a tread, metres."""
BOARD = 0.02
NOSING = 0.035
"""Depth of the dark edge of a tread, by which steps are told apart from above, metres."""
STRING = 0.28
"""Height of the strings at the sides, metres."""
RAIL = 0.9
"""Height of a railing above noses and floors, metres."""
HAIR = 1e-3
BARS = 0.13
"""Between the bars of a railing, metres."""
AT_WALL = 0.12
"""An edge nearer to a wall than this needs no railing, metres."""


def well_of(stairs: Stairs) -> shapely.Geometry:
    """The opening in the upper floor."""
    if stairs.shape == "spiral":
        return shapely.union_all([shapely.Polygon(t.outline).buffer(0.01) for t in stairs.treads])
    boxes = [shapely.Polygon(corners(np.array([box]))[0]) for box in stairs.open]
    return shapely.union_all([box.buffer(HAIR, join_style="mitre") for box in boxes])


def wells(stairs: Iterable[Stairs], level: str) -> shapely.Geometry:
    """The openings in the floor of a level."""
    return shapely.union_all([well_of(one) for one in stairs if one.upper == level])


def flight_parts(stairs: Stairs, above: float = 0.0, upto: float = inf) -> tuple[Part, ...]:
    """The steps, strings and handrails, above the lower floor; only treads ``above`` a height and
    ``upto`` another."""
    treads = [t for t in stairs.treads if above < t.height <= upto]
    if not treads:
        return ()
    plates = [prism(t.outline, t.height - PLATE, t.height) for t in treads]
    white = [mesh for t in treads for mesh in _below(t.outline, t.height, stairs)]
    if stairs.shape == "spiral":
        post = _post(stairs)
        low = max(above - stairs.rise, 0.0)
        top = min(stairs.rises * stairs.rise, upto) + RAIL
        white.append(rod((*post, low), (*post, top), EYE, sides=12))
    edges = [_nosing(tread) for tread in treads]
    rails, bars = _rails(stairs, treads)
    return (
        Part(OAK, *merge([*plates, *rails])),
        Part(WALNUT, *merge(edges)),
        Part(WHITE, *merge(white)),
        Part(BLACK, *merge(bars)),
    )


def _post(stairs: Stairs) -> Floats:
    """The middle of a spiral: the inner corners lie on a circle round it."""
    ring = shapely.MultiPoint([t.outline[0] for t in stairs.treads])
    circle = shapely.minimum_bounding_circle(ring)
    return np.array(circle.centroid.coords[0])


def _below(outline: Floats, height: float, stairs: Stairs) -> Iterator[Mesh]:
    """The board under a nosing, and the strings at both sides of a straight tread."""
    yield _wall(outline[0], outline[1], max(height - stairs.rise, 0.0), height - PLATE)
    if len(outline) == 4:
        low = max(height - STRING, 0.0)
        for start, end in ((outline[1], outline[2]), (outline[3], outline[0])):
            yield _wall(start, end, low, height - 1e-3)


def _wall(start: Floats, end: Floats, low: float, high: float, deep: float = BOARD) -> Mesh:
    """A thin board on an edge, on its left."""
    along = (end - start) / max(float(np.hypot(*(end - start))), 1e-9)
    inward = deep * np.array([-along[1], along[0]])
    return prism(np.array([start, end, end + inward, start + inward]), low, high)


def _nosing(tread: Tread) -> Mesh:
    """The dark edge of a tread, a hair out of it on all sides that are seen."""
    start, end = np.asarray(tread.outline[0]), np.asarray(tread.outline[1])
    along = (end - start) / max(float(np.hypot(*(end - start))), 1e-9)
    out = HAIR * np.array([along[1], -along[0]])
    low, high = tread.height - PLATE - HAIR, tread.height + HAIR
    wide = HAIR * along
    return _wall(start - wide + out, end + wide + out, low, high, NOSING)


def _rails(stairs: Stairs, treads: Sequence[Tread]) -> tuple[list[Mesh], list[Mesh]]:
    """Handrails on the open sides of some treads, and their bars."""
    open_side = 1 if (stairs.turn == "right") != (stairs.shape == "spiral") else 0
    sides = (0, 1) if stairs.shape == "straight" else (open_side,)
    rails, bars = [], []
    for side in sides:
        spots = [
            (*_inset(t.outline, side), t.height) for t in treads if not _landing(t.outline, stairs)
        ]
        if len(spots) > 1:
            tops = [(x, y, z + RAIL) for x, y, z in spots]
            rails += [rod(a, b, 0.022) for a, b in pairwise(tops)]
        bars += [rod((x, y, z - PLATE), (x, y, z + RAIL), 0.009, sides=5) for x, y, z in spots]
    return rails, bars


def _landing(outline: Floats, stairs: Stairs) -> bool:
    """Whether a tread is the landing of a half turn, along which no rail runs."""
    return stairs.shape == "half" and float(np.hypot(*(outline[1] - outline[0]))) > (
        1.5 * stairs.foot.width
    )


def _inset(outline: Floats, side: int) -> Floats:
    """A spot on a nosing, a hand from its end."""
    one, other = outline[side], outline[1 - side]
    return np.asarray(one + (other - one) * 0.04 / max(float(np.hypot(*(other - one))), 0.04))


def railing_parts(stairs: Stairs, floors: Sequence[shapely.Polygon]) -> tuple[Part, ...]:
    """The railing round the well on the upper floor, but at walls and where one steps off."""
    rails: list[Mesh] = []
    bars: list[Mesh] = []
    for line in railing_lines(stairs, floors):
        points = shapely.get_coordinates(line)
        rails += [rod((*a, RAIL), (*b, RAIL), 0.022) for a, b in pairwise(points.tolist())]
        count = max(1, round(line.length / BARS))
        for share in np.linspace(0.0, 1.0, count + 1).tolist():
            x, y = line.interpolate(share, normalized=True).coords[0]
            bars.append(rod((x, y, -0.05), (x, y, RAIL), 0.009, sides=5))
    return (Part(OAK, *merge(rails)), Part(BLACK, *merge(bars))) if rails else ()


def railing_lines(
    stairs: Stairs, floors: Sequence[shapely.Polygon]
) -> Iterator[shapely.LineString]:
    """Where the railing runs: the edges of the well that are neither at a wall nor the head."""
    well, head = well_of(stairs), stairs.head
    across = np.array([-np.sin(head.heading), np.cos(head.heading)]) * head.width / 2
    edge = shapely.LineString([np.array(head[:2]) - across, np.array(head[:2]) + across])
    floor = shapely.union_all(list(floors))
    walls = floor.boundary.buffer(AT_WALL, cap_style="flat")
    beside = shapely.union_all([edge.buffer(0.06), walls])
    left = well.boundary.intersection(floor).difference(beside)
    merged = shapely.line_merge(left) if left.geom_type == "MultiLineString" else left
    merged = shapely.simplify(merged, HAIR)
    for line in shapely.get_parts(merged):
        if isinstance(line, shapely.LineString) and line.length > BARS:
            yield line
