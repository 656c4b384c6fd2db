"""Moves: changes a designer would try. Each returns a new frame for one item.

A box is mostly handled by the middle of its back edge: a back that lies flush to a wall stays
flush when the item is resized, swapped or slid along the wall.
"""

from __future__ import annotations

import math

from scenewright.domains.home.terms.assemble import PreparedHome
from scenewright.domains.home.terms.orientation import inward
from scenewright.engine.draws import Stream, bell, below, uniform
from scenewright.geometry.boxes import (
    Floats,
    Frame,
    make_frame,
    nearest_segment,
    part_of,
    read_frame,
)
from scenewright.geometry.compiled import inlined

QUARTER = 0.5 * math.pi


@inlined
def from_back(x: float, y: float, heading: float, w: float, d: float) -> Frame:
    """The frame with half width ``w``, half depth ``d`` whose back edge has its middle at x, y."""
    return make_frame(
        x + math.cos(heading) * d, y + math.sin(heading) * d, heading, 2.0 * w, 2.0 * d
    )


@inlined
def back_of(frame: Frame) -> tuple[float, float]:
    """The middle of the back edge."""
    return frame[0] - frame[2] * frame[5], frame[1] - frame[3] * frame[5]


@inlined
def nudge(frame: Frame, scale: float, stream: Stream) -> Frame:
    """Shift along both axes of the box, or one."""
    only, u, v = uniform(stream), 0.0, 0.0
    if only >= 0.35:
        v = scale * bell(stream)
    if only < 0.35 or only >= 0.7:
        u = scale * bell(stream)
    return part_of(frame, u, v, frame[4], frame[5])


@inlined
def jump(frame: Frame, bounds: Floats, stream: Stream) -> Frame:
    """Anywhere within the bounds, heading kept.

    ``bounds`` (4,) x0, y0, x1, y1 in metres.
    """
    x = bounds[0] + uniform(stream) * (bounds[2] - bounds[0])
    y = bounds[1] + uniform(stream) * (bounds[3] - bounds[1])
    return (x, y, frame[2], frame[3], frame[4], frame[5], frame[6], frame[7])


@inlined
def turn(frame: Frame, scale: float, stream: Stream) -> Frame:
    """Quarter turns about the centre, or a small angle."""
    angle = scale * bell(stream)
    if uniform(stream) < 0.6:
        angle = QUARTER * (1 + int(3.0 * uniform(stream)))
    return make_frame(frame[0], frame[1], frame[7] + angle, 2.0 * frame[4], 2.0 * frame[5])


@inlined
def align(frame: Frame, p: PreparedHome, stream: Stream) -> Frame:
    """Square to the nearest wall or the main wall, by the nearest quarter turn or any."""
    k = nearest_segment(frame[0], frame[1], p.walls)[0]
    heading = inward(p.walls[k]) if k >= 0 else 0.0
    if not math.isnan(p.normal) and (k < 0 or uniform(stream) < 0.5):
        heading = p.normal
    steps = 1.0 * math.floor((frame[7] - heading) / QUARTER + 0.5)
    if uniform(stream) < 0.3:
        steps = float(int(4.0 * uniform(stream)))
    return make_frame(frame[0], frame[1], heading + steps * QUARTER, 2.0 * frame[4], 2.0 * frame[5])


@inlined
def at_wall(frame: Frame, wall: Floats, along: float) -> Frame:
    """Back flush to a wall, its middle ``along`` metres from the wall's start, kept on the wall if
    it is long enough.

    ``wall`` (4,) x0, y0, x1, y1 in metres.
    """
    dx, dy = wall[2] - wall[0], wall[3] - wall[1]
    length = math.sqrt(dx * dx + dy * dy)
    if length < 1e-9:
        return frame
    low = min(frame[4], 0.5 * length)
    along = min(max(along, low), length - low) / length
    return from_back(wall[0] + along * dx, wall[1] + along * dy, inward(wall), frame[4], frame[5])


@inlined
def to_wall(frame: Frame, walls: Floats, stream: Stream) -> Frame:
    """Snap the back to a wall: the nearest, keeping its place along it, or any, anywhere on it or
    into one of its corners.

    ``walls`` (w, 4) x0, y0, x1, y1 in metres.
    """
    kind = uniform(stream)
    if kind < 0.3:
        x, y = back_of(frame)
        wall = walls[nearest_segment(x, y, walls)[0]]
        dx, dy = wall[2] - wall[0], wall[3] - wall[1]
        length = max(math.sqrt(dx * dx + dy * dy), 1e-9)
        return at_wall(frame, wall, ((x - wall[0]) * dx + (y - wall[1]) * dy) / length)
    wall = walls[below(stream, walls.shape[0])]
    length = math.sqrt((wall[2] - wall[0]) ** 2 + (wall[3] - wall[1]) ** 2)
    if kind < 0.65:
        return at_wall(frame, wall, uniform(stream) * length)
    return at_wall(frame, wall, 0.0 if kind < 0.825 else length)


@inlined
def resize(frame: Frame, limits: Floats, scale: float, stream: Stream) -> Frame:
    """Another width or depth within the limits (4,); the back and one side edge keep their
    place."""
    w, d, kind = 2.0 * frame[4], 2.0 * frame[5], uniform(stream)
    if kind < 0.5:
        w = min(max(w + scale * (limits[2] - limits[0]) * bell(stream), limits[0]), limits[2])
    if kind > 0.35:
        d = min(max(d + scale * (limits[3] - limits[1]) * bell(stream), limits[1]), limits[3])
    shift = (0.5 * w - frame[4]) * (int(3.0 * uniform(stream)) - 1.0)
    return part_of(frame, shift, 0.5 * d - frame[5], 0.5 * w, 0.5 * d)


@inlined
def beside(frame: Frame, other: Frame, stream: Stream) -> Frame:
    """At the left or right of another item, touching it, backs in one line, same heading."""
    x, y = back_of(other)
    shift = (frame[4] + other[4]) * (1.0 if uniform(stream) < 0.5 else -1.0)
    return from_back(x + other[3] * shift, y - other[2] * shift, other[7], frame[4], frame[5])


@inlined
def relate(frame: Frame, other: Frame, first: bool, target: Floats, stream: Stream) -> Frame:
    """Where a relation wants this item, given the other: distance, angle, bearing.

    ``first`` if this is the item the bearing is measured from; what is left open in ``target`` (3,)
    (NaN) is drawn.
    """
    distance = abs(target[0]) if not math.isnan(target[0]) else 1.0 + 2.0 * uniform(stream)
    angle = target[1] if not math.isnan(target[1]) else QUARTER * int(4.0 * uniform(stream))
    bearing = target[2]
    if math.isnan(bearing):
        bearing = 0.0 if uniform(stream) < 0.5 else 2.0 * math.pi * uniform(stream)
    heading = other[7] + (angle if uniform(stream) < 0.5 else -angle)
    way = heading + bearing + math.pi if first else other[7] + bearing
    return make_frame(
        other[0] + distance * math.cos(way),
        other[1] + distance * math.sin(way),
        heading,
        2.0 * frame[4],
        2.0 * frame[5],
    )


@inlined
def visit(frame: Frame, i: int, p: PreparedHome, stream: Stream) -> Frame:
    """Back to the wall at a spot the item wants to be at, or square to the room looking at it."""
    row = p.places[p.place_start[i] + below(stream, p.place_start[i + 1] - p.place_start[i])]
    if row[3] == math.inf and row[4] == 0.0:
        return jump(frame, p.bounds, stream)
    spot = p.spots[int(row[0]) + below(stream, int(row[1] - row[0]))]
    part = uniform(stream)
    x, y = spot[0] + part * (spot[2] - spot[0]), spot[1] + part * (spot[3] - spot[1])
    if row[4] != 0.0:
        ahead = math.atan2(y - frame[1], x - frame[0]) + (0.0 if row[4] > 0.0 else math.pi)
        steps = 1.0 * math.floor((ahead - frame[7]) / QUARTER + 0.5)
        heading = frame[7] + steps * QUARTER
        return make_frame(frame[0], frame[1], heading, 2.0 * frame[4], 2.0 * frame[5])
    wall = p.walls[max(nearest_segment(x, y, p.walls)[0], 0)]
    dx, dy = wall[2] - wall[0], wall[3] - wall[1]
    length = max(math.sqrt(dx * dx + dy * dy), 1e-9)
    along = ((x - wall[0]) * dx + (y - wall[1]) * dy) / length
    return at_wall(frame, wall, along + frame[4] * bell(stream))


@inlined
def propose(frames: Floats, i: int, p: PreparedHome, heat: float, stream: Stream) -> Frame:
    """A move of one item; ``heat`` from 1 (start) to 0 (end) sets how far small moves go.

    ``frames`` (n, 8).
    """
    frame, n, scale = read_frame(frames, i), frames.shape[0], 0.004 + 0.6 * heat * heat
    kind = uniform(stream)
    if kind < 0.36:
        return nudge(frame, scale, stream)
    if kind < 0.44:
        return turn(frame, scale, stream)
    if kind < 0.50:
        return align(frame, p, stream)
    if kind < 0.66 and p.walls.shape[0] > 0:
        return to_wall(frame, p.walls, stream)
    if kind < 0.80:
        return resize(frame, p.limits[i], 0.02 + heat, stream)
    count = p.related_start[i + 1] - p.related_start[i]
    if kind < 0.90 and count > 0:
        r = p.related[p.related_start[i] + below(stream, count)]
        first = p.pairs[r, 0] == i
        other = read_frame(frames, p.pairs[r, 1] if first else p.pairs[r, 0])
        return relate(frame, other, first, p.targets[r], stream)
    if kind < 0.95 and n > 1:
        return beside(frame, read_frame(frames, (i + 1 + below(stream, n - 1)) % n), stream)
    if p.place_start[i + 1] > p.place_start[i] and p.walls.shape[0] > 0 and uniform(stream) < 0.7:
        return visit(frame, i, p, stream)
    return jump(frame, p.bounds, stream)
