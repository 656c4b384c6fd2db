"""Bodies of houses over polygons: wings under gables, hips and saddles, stepped gables, courts.

A footprint whose sides run along its box is taken apart into wings, rectangles each with a ridge
along its longer side; the roof of a narrower wing runs into that of the widest. Any other
footprint is roofed by a saddle: two slopes from a ridge along its longest side.
"""

from __future__ import annotations

from itertools import combinations
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.roofs import hip
from scenewright.core.footprint import Footprint
from scenewright.core.space import Points
from scenewright.geometry.mesh import Mesh, extrude, rotate_mesh
from scenewright.geometry.solids import Interval, profile

STRAIGHT = 1e-3
"""Metres by which a side may miss its axis."""


class Wing(NamedTuple):
    """A rectangle of a footprint and the axis its ridge runs along."""

    x: Interval
    y: Interval
    along: str

    @property
    def span(self) -> float:
        """The width that the roof spans, in metres."""
        across = self.y if self.along == "x" else self.x
        return across[1] - across[0]


def split_wings(footprint: Footprint) -> tuple[Wing, ...]:
    """The wings of a footprint, the widest first, narrower ones run into it; none if its sides do
    not run along its box.

    >>> ell = ((-5.0, -4.0), (5.0, -4.0), (5.0, 2.0), (0.0, 2.0), (0.0, 4.0), (-5.0, 4.0))
    >>> [(wing.along, wing.span) for wing in split_wings(ell)]
    [('x', 6.0), ('y', 5.0)]
    """
    wings = list_wings(footprint)
    return (*wings[:1], *(_run_into(wing, wings[0]) for wing in wings[1:]))


def list_wings(footprint: Footprint) -> tuple[Wing, ...]:
    """The same as they are, each with its ridge along its longer side: they overlap where they
    cross."""
    ring = np.array(footprint)
    step = np.abs(np.roll(ring, -1, axis=0) - ring).min(1)
    if step.max() > STRAIGHT:
        return ()
    shape = shapely.Polygon(ring)
    rooms = [box for box in _rectangles(ring) if shape.buffer(STRAIGHT).covers(shapely.box(*box))]
    left, chosen = shape, list[tuple[float, ...]]()
    while left.area > STRAIGHT and rooms:
        gains = [shapely.intersection(left, shapely.box(*box)).area for box in rooms]
        areas = [(c - a) * (d - b) for a, b, c, d in rooms]
        best = max(range(len(rooms)), key=lambda k: (round(gains[k], 6), areas[k], rooms[k]))
        if gains[best] <= STRAIGHT:
            break
        chosen.append(rooms[best])
        left = shapely.difference(left, shapely.box(*rooms[best]))
    return tuple(sorted((_wing(box) for box in chosen), key=lambda wing: -wing.span))


def list_rectangles(footprint: Footprint) -> list[tuple[float, float, float, float]]:
    """The greatest rectangles (west, south, east, north) within a footprint whose sides run along
    its box; none of another footprint.

    >>> ell = ((0.0, 0.0), (9.0, 0.0), (9.0, 4.0), (5.0, 4.0), (5.0, 8.0), (0.0, 8.0))
    >>> sorted(list_rectangles(ell))
    [(0.0, 0.0, 5.0, 8.0), (0.0, 0.0, 9.0, 4.0)]
    """
    ring = np.array(footprint)
    if np.abs(np.roll(ring, -1, axis=0) - ring).min(1).max() > STRAIGHT:
        return []
    shape = shapely.buffer(shapely.Polygon(ring), STRAIGHT)
    within = [box for box in _rectangles(ring) if shape.covers(shapely.box(*box))]
    return [
        one
        for one in within
        if not any(
            other != one
            and other[0] <= one[0]
            and other[1] <= one[1]
            and other[2] >= one[2]
            and other[3] >= one[3]
            for other in within
        )
    ]


def _rectangles(ring: Points) -> list[tuple[float, float, float, float]]:
    xs, ys = (np.unique(np.round(ring[:, k], 6)).tolist() for k in (0, 1))
    return [(a, c, b, d) for a, b in combinations(xs, 2) for c, d in combinations(ys, 2)]


def _wing(box: tuple[float, ...]) -> Wing:
    wide, deep = box[2] - box[0], box[3] - box[1]
    return Wing((box[0], box[2]), (box[1], box[3]), "x" if wide >= deep else "y")


def _run_into(wing: Wing, main: Wing) -> Wing:
    """A wing that leaves the main one sideways has its ridge that way, from the main ridge on; one
    that goes on from its end has it as the main one; one that stands apart keeps its own."""
    across = "y" if main.along == "x" else "x"
    own, theirs = getattr(wing, across), getattr(main, across)
    if own[1] < theirs[0] - STRAIGHT or own[0] > theirs[1] + STRAIGHT:
        return wing
    before, beyond = own[0] < theirs[0] - STRAIGHT, own[1] > theirs[1] + STRAIGHT
    if not before and not beyond:
        return wing._replace(along=main.along)
    ridge = (theirs[0] + theirs[1]) / 2
    low, high = (own[0] if before else ridge), (own[1] if beyond else ridge)
    return wing._replace(**{across: (low, high)}, along=across)


def inset(footprint: Footprint, by: float) -> Footprint:
    """A footprint shrunk on all sides, by less than 0 grown; itself where nothing would be left."""
    if by == 0:
        return footprint
    inner = shapely.buffer(shapely.Polygon(footprint), -by, join_style="mitre", mitre_limit=5.0)
    if inner.geom_type != "Polygon" or inner.is_empty:
        return footprint
    ring = shapely.get_coordinates(shapely.orient_polygons(inner).exterior)[:-1]
    return tuple((float(x), float(y)) for x, y in ring)


def gabled_walls(
    wing: Wing, eave: float, rise: float, by: float, ends: float | None = None
) -> Mesh:
    """The walls of a wing with its gables: as high as the underside of a roof that rises by
    ``rise`` over the half span from ``eave`` at the edge; set in by ``by``, gables by ``ends``."""
    at_ends = by if ends is None else ends
    across, length = (wing.y, wing.x) if wing.along == "x" else (wing.x, wing.y)
    low, high = across[0] + by, across[1] - by
    middle, pitch = (low + high) / 2, rise / max((across[1] - across[0]) / 2, 1e-6)
    side, top = eave + pitch * by, eave + rise
    ring = [(low, 0.0), (high, 0.0), (high, side), (middle, top), (low, side)]
    return _along(ring, (length[0] + at_ends, length[1] - at_ends), wing.along)


def gabled_roof(
    wing: Wing, eave: float, rise: float, thick: float, ends: float = 0.0, sides: float = 0.0
) -> Mesh:
    """Two slopes ``thick`` over the walls, drawn in by ``ends`` at both gables and by ``sides``
    along the eaves."""
    across, length = (wing.y, wing.x) if wing.along == "x" else (wing.x, wing.y)
    across = across[0] + sides, across[1] - sides
    middle = (across[0] + across[1]) / 2
    ring = [
        (across[0], eave),
        (middle, eave + rise),
        (across[1], eave),
        (across[1], eave + thick),
        (middle, eave + rise + thick),
        (across[0], eave + thick),
    ]
    return _along(ring, (length[0] + ends, length[1] - ends), wing.along)


def _along(ring: list[tuple[float, float]], length: Interval, along: str) -> Mesh:
    """A polygon over (across, height) drawn out along x or y."""
    if along == "x":
        return profile(ring, length)
    flipped = [(-across, high) for across, high in reversed(ring)]
    return rotate_mesh(profile(flipped, length), "z", np.pi / 2)


def hips(footprint: Footprint, eave: float, pitch: float) -> list[Mesh]:
    """Hips of one slope over a footprint whose sides run along its box, or over a convex one; none
    of another. Of the first kind the roof is the highest of hips over the greatest rectangles
    within, for the straight skeleton of such a polygon (Aichholzer and others 1995) is that of
    distances to its sides along the axes."""
    rectangles = list_rectangles(footprint)
    if rectangles:
        made = []
        for west, south, east, north in rectangles:
            rise = pitch * min(east - west, north - south) / 2
            made.append(hip((west, east), (south, north), (eave, eave + rise)))
        return made
    if not is_convex(footprint):
        return []
    rows = cells_of(np.array(footprint))
    return [_slope_over(cell, at, inward, eave, pitch) for cell, at, inward in rows]


def is_convex(footprint: Footprint) -> bool:
    """Whether a footprint is its own convex hull."""
    shape = shapely.Polygon(footprint)
    return bool(
        shapely.equals_exact(
            shapely.convex_hull(shape).normalize(),
            shapely.orient_polygons(shape).normalize(),
            STRAIGHT,
        )
    )


def cells_of(ring: Points) -> list[tuple[Points, Points, Points]]:
    """What is nearest to each side of a convex ring (n, 2), with a point of that side and the
    direction inwards from it."""
    step = np.roll(ring, -1, axis=0) - ring
    inward = np.stack([-step[:, 1], step[:, 0]], 1) / np.hypot(*step.T)[:, None]
    offset = (ring * inward).sum(1)
    found = []
    for side in range(len(ring)):
        cell = ring
        for other in range(len(ring)):
            if other != side:
                normal, away = inward[other] - inward[side], offset[other] - offset[side]
                cell = _clip(cell, normal, away)
        found.append((cell, ring[side], inward[side]))
    return found


def _slope_over(cell: Points, at: Points, inward: Points, eave: float, pitch: float) -> Mesh:
    """The slope over a part of the plan that rises from a side inwards."""
    body = extrude(cell, eave - 0.05, eave)
    vertices = body.vertices.copy()
    upper = vertices[:, 2] > eave - 0.02
    rise = vertices[upper, :2] @ inward - float((at * inward).sum())
    vertices[upper, 2] = eave + pitch * np.maximum(rise, 0.0)
    return Mesh(vertices, body.faces)


def _clip(ring: Points, normal: Points, away: float) -> Points:
    """The part of a convex ring (n, 2) with normal · p >= away."""
    off = ring @ normal - away
    found = []
    for k in range(len(ring)):
        after = (k + 1) % len(ring)
        if off[k] >= 0:
            found.append(ring[k])
        if (off[k] < 0) != (off[after] < 0):
            found.append(ring[k] + (ring[after] - ring[k]) * off[k] / (off[k] - off[after]))
    return np.array(found)


def tallest(footprint: Footprint) -> float:
    """How far the middle of a footprint is from its sides, in metres: half the span of its hips."""
    boxes = list_rectangles(footprint)
    if boxes:
        return max(min(c - a, d - b) for a, b, c, d in boxes) / 2
    circle = shapely.maximum_inscribed_circle(shapely.Polygon(footprint), tolerance=0.01)
    return float(shapely.length(circle))


def saddle(footprint: Footprint, eave: float, top: float) -> list[Mesh]:
    """Two slopes over any footprint, from a ridge along its longest side through its middle."""
    halves, reach = saddle_sides(footprint)
    return [_slope(part, at, inward, reach, (eave, top)) for part, at, inward in halves]


def saddle_sides(
    footprint: Footprint,
) -> tuple[list[tuple[shapely.Polygon, Points, Points]], float]:
    """The parts of a footprint on both sides of a ridge along its longest side through its middle,
    each with a point of its eave and the direction inwards, and half the span of the roof."""
    ring = np.array(footprint)
    step = np.roll(ring, -1, axis=0) - ring
    way = step[int(np.argmax(np.hypot(*step.T)))]
    way = way / np.hypot(*way)
    left = np.array([-way[1], way[0]])
    off = ring @ left
    middle, reach = (off.min() + off.max()) / 2, (off.max() - off.min()) / 2
    far = 1e3
    made = []
    for side in (1.0, -1.0):
        at = middle * left
        half = [at - far * way, at + far * way, at + far * way + side * far * left]
        half.append(at - far * way + side * far * left)
        for part in shapely.get_parts(
            shapely.intersection(shapely.Polygon(ring), shapely.Polygon(half))
        ):
            if part.geom_type == "Polygon" and part.area > STRAIGHT:
                made.append((part, at + side * reach * left, -side * left))
    return made, float(reach)


def _slope(part: shapely.Polygon, at: Points, inward: Points, reach: float, z: Interval) -> Mesh:
    ring = shapely.get_coordinates(shapely.orient_polygons(part).exterior)[:-1]
    body = extrude(ring, z[0], z[1])
    vertices = body.vertices.copy()
    upper = vertices[:, 2] > z[0] + 1e-9
    share = (vertices[upper, :2] - at) @ inward / max(reach, 1e-9)
    vertices[upper, 2] = z[0] + 0.08 + (z[1] - z[0] - 0.08) * share
    return Mesh(vertices, body.faces)


def stepped_gable(
    across: Interval, at: Interval, eave: float, top: float, along: str, steps: int = 3
) -> tuple[Mesh, list[Mesh]]:
    """A gable wall that rises above the roof in steps, and the copings on its steps; ``at`` is
    the interval of its thickness."""
    middle, half = (across[0] + across[1]) / 2, (across[1] - across[0]) / 2
    ring = [(across[0], 0.0), (across[1], 0.0)]
    right, copings = [], []
    for k in range(steps):
        share = 1.0 - k / steps
        high = eave + (top - eave) * (k + 1) / steps
        right += [(middle + half * share, high)]
        inner = 1.0 - (k + 1) / steps
        if k < steps - 1:
            right.append((middle + half * inner, high))
        spans = [(inner, share)] if k < steps - 1 else [(-share, share)]
        for a, b in spans:
            for sign in (1, -1) if k < steps - 1 else (1,):
                ends = sorted((middle + sign * half * a, middle + sign * half * b))
                cap = [
                    (ends[0] - 0.12, high),
                    (ends[1] + 0.12, high),
                    (ends[1] + 0.12, high + 0.14),
                    (ends[0] - 0.12, high + 0.14),
                ]
                copings.append(_along(cap, (at[0] - 0.1, at[1] + 0.1), along))
    left = [(2 * middle - a, z) for a, z in reversed(right)]
    return _along([*ring, *right, *left], at, along), copings
