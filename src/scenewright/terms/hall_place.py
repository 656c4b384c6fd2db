"""From patterns to places: the footprints and clearances of one unit, wall rows included."""

from __future__ import annotations

import math

from scenewright.encodings.patterns import WALL
from scenewright.encodings.patterns.expand import expand
from scenewright.geometry.boxes import make_frame, read_frame
from scenewright.geometry.compiled import compiled, inlined
from scenewright.terms.hall_measure import clear_of, write_row
from scenewright.terms.hall_state import Prepared, Scratch, State

FLUSH = 0.003
"""How far backs stand off their wall, in metres."""
CORNER = 0.1
"""What is left free behind a corner beyond the depth of the row, in metres."""


@inlined
def walk_walls(p: Prepared, s: State, unit: int) -> bool:
    """Place a wall row: objects one after another along the walls of the zone, gap by gap.

    It starts at a stretch; an object that no longer fits on one goes to the next, behind a corner
    after the depth of the row. The run on each stretch is then aligned: ``pose`` 1 of -1 to its
    start, 0 to its middle, 1 to its end. False if the walls are too short.
    """
    zone, gap = p.zones[unit], s.pose[unit, 3]
    first, last = p.loop_spans[zone, 0], p.loop_spans[zone, 1]
    k = find_start(p, s, unit)
    if k < 0:
        return False
    corner, i, end = p.largest[unit, 1] + CORNER, p.spans[unit, 0], p.spans[unit, 1]
    for _turn in range(last - first):
        row = p.loops[k]
        start = s.stretches[row, 6] * corner
        room, j, wide = s.stretches[row, 4] - start, i, -gap
        while j < end and wide + gap + p.sizes[j, 0] <= room + 1e-9:
            wide += gap + p.sizes[j, 0]
            j += 1
        t = start + (room - wide) * 0.5 * (1.0 + min(max(s.pose[unit, 1], -1.0), 1.0))
        while i < j:
            stand_at_wall(p, s, i, row, t + 0.5 * p.sizes[i, 0])
            t += p.sizes[i, 0] + gap
            i += 1
        if i == end:
            return True
        k = k + 1 if k + 1 < last else first
    return False


@inlined
def stand_at_wall(p: Prepared, s: State, i: int, row: int, along: float) -> None:
    """Put object ``i`` with its back at a stretch, its middle ``along`` metres from the start."""
    dx, dy = s.stretches[row, 2], s.stretches[row, 3]
    off = 0.5 * p.sizes[i, 1] + FLUSH
    frame = make_frame(
        s.stretches[row, 0] + dx * along - dy * off, s.stretches[row, 1] + dy * along + dx * off,
        math.atan2(dx, -dy), p.sizes[i, 0], p.sizes[i, 1],
    )  # fmt: skip
    write_row(s.frames, i, frame)
    write_row(s.clears, i, clear_of(frame, p.clear, i))


@inlined
def find_start(p: Prepared, s: State, unit: int) -> int:
    """The stretch (place in ``loops``) in which a wall row starts; -1 if the zone has no wall."""
    zone = p.zones[unit]
    total = 0.0
    for k in range(p.loop_spans[zone, 0], p.loop_spans[zone, 1]):
        total += s.stretches[p.loops[k], 4]
    if total <= 0.0:
        return -1
    rest = s.pose[unit, 0] - math.floor(s.pose[unit, 0] / total) * total
    for k in range(p.loop_spans[zone, 0], p.loop_spans[zone, 1]):
        rest -= s.stretches[p.loops[k], 4]
        if rest < 0.0:
            return k
    return p.loop_spans[zone, 0]


@compiled
def unfold(p: Prepared, s: State, work: Scratch, unit: int) -> bool:
    """Write the footprints and clearances of a unit; false if a wall row finds no room."""
    if s.code[unit] == WALL:
        return walk_walls(p, s, unit)
    first, row = p.spans[unit, 0], p.layer_spans[unit, 0]
    layers = s.layers[row : row + s.used[unit]]
    count = expand(s.code[unit], layers, s.pose[unit, 3], p.sizes, first, work.local)
    x, y, heading = s.pose[unit, 0], s.pose[unit, 1], s.pose[unit, 2]
    c, n = math.cos(heading), math.sin(heading)
    for k in range(count):
        u, v, i = work.local[k, 0], work.local[k, 1], first + k
        frame = make_frame(
            x + u * n + v * c, y - u * c + v * n, heading + work.local[k, 2],
            p.sizes[i, 0], p.sizes[i, 1],
        )  # fmt: skip
        write_row(s.frames, i, frame)
        write_row(s.clears, i, clear_of(frame, p.clear, i))
    return True


@compiled
def build(p: Prepared, s: State, host: int) -> None:
    """Write the frame of a host's partition and the stretches on its two sides."""
    low, high = s.partitions[host, 0], s.partitions[host, 1]
    x0, y0, x1, y1 = p.hosts[host, 0], p.hosts[host, 1], p.hosts[host, 2], p.hosts[host, 3]
    length = math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2)
    dx, dy = (x1 - x0) / length, (y1 - y0) / length
    middle, off = 0.5 * (low + high), 0.5 * p.thickness
    frame = make_frame(
        x0 + dx * middle, y0 + dy * middle, math.atan2(dx, -dy), max(high - low, 0.0), p.thickness
    )
    write_row(s.walls, host, frame)
    row = s.stretches.shape[0] - 2 * s.walls.shape[0] + 2 * host
    for side in range(2):
        way = 1.0 if side == 0 else -1.0
        start = low if side == 0 else high
        s.stretches[row + side, 0] = x0 + dx * start - dy * off * way
        s.stretches[row + side, 1] = y0 + dy * start + dx * off * way
        s.stretches[row + side, 2], s.stretches[row + side, 3] = dx * way, dy * way
        s.stretches[row + side, 4] = max(high - low, 0.0)


@inlined
def middle_of(s: State, first: int, last: int) -> tuple[float, float]:
    """Mean of the centres of some objects."""
    x, y = 0.0, 0.0
    for i in range(first, last):
        frame = read_frame(s.frames, i)
        x, y = x + frame[0], y + frame[1]
    return x / (last - first), y / (last - first)
