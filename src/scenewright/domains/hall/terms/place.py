"""From patterns to places: the footprints and clearances of one unit, wall rows included."""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import CHAIN, CODE, NUMBER, WALL
from scenewright.domains.hall.patterns.expand import expand
from scenewright.domains.hall.terms.measure import clear_of, write_row
from scenewright.domains.hall.terms.state import PreparedHall, Scratch, State
from scenewright.geometry.boxes import make_frame, part_of, read_frame
from scenewright.geometry.compiled import compiled, inlined

FLUSH = 0.003
"""How far backs stand off their wall, in metres."""
CORNER = 0.1
"""Metres left free behind a corner beyond the depth of the row."""


@inlined
def run_from(p: PreparedHall, s: State, unit: int, i: int, k: int) -> tuple[int, float, float]:
    """How many objects from ``i`` on fit on the stretch at place ``k`` of the loops, from where on
    they may stand there, and the room in metres."""
    row = p.loops[k]
    start = s.stretches[row, 6] * (p.largest[unit, 1] + CORNER)
    room, wide, j = s.stretches[row, 4] - start, -s.pose[unit, 3], i
    while j < p.spans[unit, 1] and wide + s.pose[unit, 3] + p.sizes[j, 0] <= room + 1e-9:
        wide += s.pose[unit, 3] + p.sizes[j, 0]
        j += 1
    return j - i, start, room


@inlined
def walk_walls(p: PreparedHall, s: State, unit: int) -> bool:
    """Place a wall row: objects side by side along the walls of the zone, gap by gap.

    It starts at a stretch and goes on to as many as it needs, behind a corner after the depth of
    the row; each gets its share of the objects. The run on each stretch is then aligned: ``pose``
    1 of -1 to its start, 0 to its middle, 1 to its end. False if the walls are too short.
    """
    zone, end = p.zones[unit], p.spans[unit, 1]
    first, last = p.loop_spans[zone, 0], p.loop_spans[zone, 1]
    begin = find_start(p, s, unit)
    if begin < 0:
        return False
    i, k, used = p.spans[unit, 0], begin, 0
    while i < end and used < last - first:
        i, used = i + run_from(p, s, unit, i, k)[0], used + 1
        k = k + 1 if k + 1 < last else first
    return i == end and share_walls(p, s, unit, begin, used)


@inlined
def share_walls(p: PreparedHall, s: State, unit: int, begin: int, used: int) -> bool:
    """Spread a wall row over some stretches from a place of the loops on, by their length."""
    zone, gap, end = p.zones[unit], s.pose[unit, 3], p.spans[unit, 1]
    first, last = p.loop_spans[zone, 0], p.loop_spans[zone, 1]
    total, k = 0.0, begin
    for _turn in range(used):
        total += max(run_from(p, s, unit, p.spans[unit, 0], k)[2], 0.0)
        k = k + 1 if k + 1 < last else first
    i, k = p.spans[unit, 0], begin
    for turn in range(used):
        fits, start, room = run_from(p, s, unit, i, k)
        share = math.ceil((end - i) * max(room, 0.0) / max(total, 1e-9) - 1e-6)
        take = fits if turn + 1 == used else min(fits, share)
        total -= max(room, 0.0)
        wide = -gap
        for j in range(i, i + take):
            wide += gap + p.sizes[j, 0]
        t = start + (room - wide) * 0.5 * (1.0 + min(max(s.pose[unit, 1], -1.0), 1.0))
        for j in range(i, i + take):
            stand_at_wall(p, s, j, p.loops[k], t + 0.5 * p.sizes[j, 0])
            t += p.sizes[j, 0] + gap
        i += take
        k = k + 1 if k + 1 < last else first
    return i == end


@inlined
def stand_at_wall(p: PreparedHall, s: State, i: int, row: int, along: float) -> None:
    """Put object ``i`` with its back at a stretch, its middle ``along`` metres from the start."""
    dx, dy = s.stretches[row, 2], s.stretches[row, 3]
    off = 0.5 * p.sizes[i, 1] + FLUSH
    frame = make_frame(
        s.stretches[row, 0] + dx * along - dy * off,
        s.stretches[row, 1] + dy * along + dx * off,
        math.atan2(dx, -dy),
        p.sizes[i, 0],
        p.sizes[i, 1],
    )
    write_row(s.frames, i, frame)
    behind = 0.5 * p.clear[i, 2]
    clear = clear_of(frame, p.clear, i)
    write_row(s.clears, i, part_of(clear, 0.0, behind, clear[4], clear[5] - behind))


@inlined
def find_start(p: PreparedHall, s: State, unit: int) -> int:
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
def unfold(p: PreparedHall, s: State, work: Scratch, unit: int) -> bool:
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
            x + u * n + v * c,
            y - u * c + v * n,
            heading + work.local[k, 2],
            p.sizes[i, 0],
            p.sizes[i, 1],
        )
        write_row(s.frames, i, frame)
        write_row(s.clears, i, clear_of(frame, p.clear, i))
    clear_ends(p, s, unit)
    return True


@inlined
def clear_ends(p: PreparedHall, s: State, unit: int) -> None:
    """Rows of a chain whose objects stand side by side need a way round their ends: there the
    outer side asks for as much as the object's greatest clearance."""
    i, row = p.spans[unit, 0], p.layer_spans[unit, 0]
    for k in range(row, row + s.used[unit]):
        number = int(s.layers[k, NUMBER])
        if number > 1 and int(s.layers[k, CODE]) == CHAIN:
            for j, side in ((i, 1), (i + number - 1, 3)):
                if p.clear[j, side] == 0.0:
                    clear, more = read_frame(s.clears, j), 0.5 * p.iota[j]
                    off = -more if side == 1 else more
                    wider = part_of(clear, off, 0.0, clear[4] + more, clear[5])
                    write_row(s.clears, j, wider)
        i += number


@compiled
def build(p: PreparedHall, s: State, host: int) -> None:
    """Write the frame of a host's partition and the stretches on its two sides."""
    low, high = s.partitions[host, 0], s.partitions[host, 1]
    x0, y0, x1, y1 = p.hosts[host, 0], p.hosts[host, 1], p.hosts[host, 2], p.hosts[host, 3]
    length = math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2)
    dx, dy = (x1 - x0) / length, (y1 - y0) / length
    x0, y0 = x0 - dy * s.offsets[host], y0 + dx * s.offsets[host]
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
