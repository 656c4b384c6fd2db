"""What visitors meet in a hall: what they see first, in which order, where they queue and how they
get out. Ours, but for the evenness, eq. 8 of Cao, Cheng and Zhang (2024).

Distances are straight lines: the route is only found afterwards.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.measures import QUEUE
from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.terms.state import Floats, PreparedHall, Scratch, State
from scenewright.domains.hall.terms.table import egress_cost
from scenewright.geometry.box_segment import crosses
from scenewright.geometry.boxes import Frame, apart, area_in_polygon, common_area, part_of
from scenewright.geometry.boxes import read_frame as frame_at
from scenewright.geometry.compiled import inlined

RAYS = 5
"""Lines of sight to the main exhibit, over four fifths of its width."""
FIRST, TILL, MAIN, LANE, GUIDE, SPEAKER, ALOOF, LOUNGE, LOW = 1, 2, 4, 8, 16, 32, 64, 128, 256
STAGE, TABLE, RECEPTION, MACHINE, WAITING = 512, 1024, 2048, 4096, 8192
"""Roles of groups: seen first, passed last, the main exhibit, tills with lanes between them, ropes
that guide people, lecterns, what keeps off columns, lounge seats, low tables before them, stages,
tables to sit at, desks to ask at, machines to get a ticket from, and seats to wait on."""
OFF_AXIS, FAR_OFF = 0.05, 5.0
"""What a metre of the main exhibit off the axis of the entrance costs, and the metres beyond which
more cost no more."""
TURNED = 0.2
"""What a desk costs at most half of whose visitors see its back, of what a group does that looks
away from its stage."""


@inlined
def ray_end(frame: Frame, k: int) -> tuple[float, float]:
    """Where line of sight ``k`` ends: on the middle line of the main exhibit, along its width."""
    along = frame[4] * 0.8 * (2.0 * k / (RAYS - 1) - 1.0)
    return frame[0] + along * frame[3], frame[1] - along * frame[2]


@inlined
def hides(frame: Frame, x0: float, y0: float, x1: float, y1: float) -> bool:
    """Whether a box stands between two points."""
    c, n = frame[2], frame[3]
    ax, ay, bx, by = x0 - frame[0], y0 - frame[1], x1 - frame[0], y1 - frame[1]
    u0, v0, u1, v1 = ax * n - ay * c, ax * c + ay * n, bx * n - by * c, bx * c + by * n
    return crosses(u0, v0, u1, v1, frame[4], frame[5])


@inlined
def wall_between(edges: Floats, x0: float, y0: float, x1: float, y1: float) -> bool:
    """Whether one of the directed edges (e, 4) crosses the line between two points."""
    for e in range(edges.shape[0]):
        ax, ay, bx, by = edges[e, 0], edges[e, 1], edges[e, 2], edges[e, 3]
        one = (bx - ax) * (y0 - ay) - (by - ay) * (x0 - ax)
        two = (bx - ax) * (y1 - ay) - (by - ay) * (x1 - ax)
        a = (x1 - x0) * (ay - y0) - (y1 - y0) * (ax - x0)
        b = (x1 - x0) * (by - y0) - (y1 - y0) * (bx - x0)
        if one * two < 0.0 and a * b < 0.0:
            return True
    return False


@inlined
def shade_of(p: PreparedHall, s: State, unit: int) -> int:
    """The lines of sight that a unit hides, as bits; for ``unit`` g those hidden by fixed objects,
    walls and partitions."""
    x, y, mask = p.entrances[0, 0], p.entrances[0, 1], 0
    main = frame_at(s.frames, p.spans[p.main, 0])
    for k in range(RAYS):
        ex, ey = ray_end(main, k)
        hidden = False
        if unit == p.spans.shape[0]:
            hidden = wall_between(p.edges, x, y, ex, ey)
            for h in range(p.hiding.shape[0]):
                hidden = hidden or hides(frame_at(p.hiding, h), x, y, ex, ey)
            for h in range(s.walls.shape[0]):
                solid = s.walls[h, 4] > 0.0
                hidden = hidden or (solid and hides(frame_at(s.walls, h), x, y, ex, ey))
        elif unit != p.main:
            for i in range(p.spans[unit, 0], p.spans[unit, 1]):
                hidden = hidden or (p.tall[i] > 0.0 and hides(frame_at(s.frames, i), x, y, ex, ey))
        if hidden:
            mask |= 1 << k
    return mask


@inlined
def sight_of(s: State) -> float:
    """Share of the lines of sight to the main exhibit that something hides, from the masks."""
    mask, count = 0, 0
    for u in range(s.shade.shape[0]):
        mask |= s.shade[u]
    for k in range(RAYS):
        count += (mask >> k) & 1
    return count / RAYS


@inlined
def off_axis(p: PreparedHall, s: State) -> float:
    """What the main exhibit costs for the metres it lies off the way in at the entrance."""
    if p.inward.shape[0] == 0:
        return 0.0
    i = p.spans[p.main, 0]
    dx, dy = s.frames[i, 0] - p.entrances[0, 0], s.frames[i, 1] - p.entrances[0, 1]
    return OFF_AXIS * min(abs(dx * p.inward[0, 1] - dy * p.inward[0, 0]), FAR_OFF)


@inlined
def look_again(p: PreparedHall, s: State, unit: int) -> float:
    """The share hidden after a unit moved (-1: after anything did), and what lies off the axis; its
    masks are written."""
    if unit >= 0 and unit != p.main:
        s.shade[unit] = shade_of(p, s, unit)
    else:
        for u in range(s.shade.shape[0]):
            s.shade[u] = shade_of(p, s, u)
    return sight_of(s) + off_axis(p, s)


@inlined
def nearest(points: Floats, x: float, y: float) -> float:
    """Metres to the nearest of some points (k, 2); infinite without any."""
    least = math.inf
    for k in range(points.shape[0]):
        least = min(least, math.hypot(points[k, 0] - x, points[k, 1] - y))
    return least


@inlined
def middle_as(s: State, unit: int, moved: int, x: float, y: float) -> tuple[float, float]:
    """The middle of a unit, where ``moved`` has another one than it had."""
    return (x, y) if unit == moved else (s.extent[unit, 1], s.extent[unit, 2])


@inlined
def order_of(p: PreparedHall, s: State, moved: int, x: float, y: float) -> float:
    """Mean metres by which other groups but ropes lie nearer to the entrance than those to be seen
    first, and nearer to the way out than tills; ``moved`` (-1: none) stands at x, y."""
    total, g = 0.0, p.spans.shape[0]
    for u in range(g):
        for role in (FIRST, TILL):
            doors = p.entrances[:1] if role == FIRST else p.exits
            if not p.roles[u] & role or doors.shape[0] == 0:
                continue
            ux, uy = middle_as(s, u, moved, x, y)
            mine, others, count = nearest(doors, ux, uy), 0.0, 0
            for v in range(g):
                if not p.roles[v] & (role | GUIDE):
                    vx, vy = middle_as(s, v, moved, x, y)
                    others, count = others + max(mine - nearest(doors, vx, vy), 0.0), count + 1
            total += others / max(count, 1)
    return total


@inlined
def welcome_of(p: PreparedHall, s: State, unit: int) -> float:
    """How far a free-standing desk is turned away from the main entrance and from the
    middle of its zone, 0 to 0.2; 0 for all others."""
    first, last = p.spans[unit, 0], p.spans[unit, 1]
    if not p.roles[unit] & FIRST or last - first > 1 or p.entrances.shape[0] == 0:
        return 0.0
    frame, zone, total = frame_at(s.frames, first), p.zones[unit], 0.0
    for turn in range(2):
        x = p.entrances[0, 0] if turn == 0 else p.middles[zone, 0]
        y = p.entrances[0, 1] if turn == 0 else p.middles[zone, 1]
        dx, dy = x - frame[0], y - frame[1]
        far = max(math.sqrt(dx * dx + dy * dy), 1e-9)
        total += 0.25 * (1.0 - (dx * frame[2] + dy * frame[3]) / far)
    return TURNED * total


@inlined
def to_exit(p: PreparedHall, frame: Frame) -> float:
    """Cosine of the angle between the right of a till and the way to the nearest exit; 0 without
    exits."""
    least, found = math.inf, 0.0
    for k in range(p.exits.shape[0]):
        dx, dy = p.exits[k, 0] - frame[0], p.exits[k, 1] - frame[1]
        far = math.hypot(dx, dy)
        if 1e-9 < far < least:
            least, found = far, (dx * frame[3] - dy * frame[2]) / far
    return found


@inlined
def queue_before(p: PreparedHall, frame: Frame, role: int) -> Frame:
    """The floor before a till on which people wait: before its front, or of tills with lanes at
    that end which is farther from the way out."""
    if role & LANE and p.exits.shape[0] > 0:
        side = -1.0 if to_exit(p, frame) > 0.0 else 1.0
        return part_of(frame, side * (frame[4] + 0.5 * QUEUE), 0.0, 0.5 * QUEUE, frame[5])
    return part_of(frame, 0.0, frame[5] + 0.5 * QUEUE, frame[4], 0.5 * QUEUE)


@inlined
def queues_of(p: PreparedHall, s: State, unit: int) -> float:
    """Mean share of the floor before the tills of a unit that is not free to queue on; of those
    with lanes between them also 1 - abs(cos) of the angle of their lanes to the way out."""
    if not p.roles[unit] & TILL:
        return 0.0
    first, last, total = p.spans[unit, 0], p.spans[unit, 1], 0.0
    for i in range(first, last):
        till = frame_at(s.frames, i)
        queue = queue_before(p, till, p.roles[unit])
        area = 4.0 * queue[4] * queue[5]
        taken = area - area_in_polygon(queue, p.edges)
        for solids in (p.obstacles, s.walls, s.frames):
            for k in range(solids.shape[0]):
                if solids[k, 4] > 0.0:
                    other = frame_at(solids, k)
                    if not apart(queue, other):
                        taken += common_area(queue, other)
        total += min(taken / area, 1.0)
        if p.roles[unit] & LANE and p.exits.shape[0] > 0:
            total += 1.0 - abs(to_exit(p, till))
    return total / (last - first)


@inlined
def in_queue(p: PreparedHall, s: State, work: Scratch, unit: int, till: int) -> bool:
    """Whether a unit is, or was, near enough to tills to be in their way."""
    if unit == till:
        return True
    for t in range(p.spans[till, 0], p.spans[till, 1]):
        queue = queue_before(p, frame_at(s.frames, t), p.roles[till])
        for i in range(p.spans[unit, 0], p.spans[unit, 1]):
            for frames in (s.frames, work.frames):
                dx, dy = frames[i, 0] - queue[0], frames[i, 1] - queue[1]
                if dx * dx + dy * dy < (frames[i, 6] + queue[6]) ** 2:
                    return True
    return False


@inlined
def egress_of(p: PreparedHall, unit: int, x: float, y: float) -> float:
    """What it costs a unit with its middle at x, y to be far from every way out: the share of the
    objects it has, times how far beyond 15 m it is."""
    if p.ways_out.shape[0] == 0:
        return 0.0
    share = (p.spans[unit, 1] - p.spans[unit, 0]) / p.unit_of.shape[0]
    return share * egress_cost(nearest(p.ways_out, x, y))


@inlined
def evenness_of(p: PreparedHall, s: State) -> float:
    """Eq. 8: mean over zones of abs(U_a of the zone - U_a), and over those with walls of
    abs(U_w of the zone - U_w), the lengths of the rows that stand at walls over the metres of
    wall."""
    total, taken, count = 0.0, 0.0, 0
    zones = p.zone_areas.shape[0]
    for z in range(zones):
        total, taken = total + wall_length(p, s, z), taken + row_length(p, s, z)
    if total <= 0.0:
        return p.uneven
    uneven = 0.0
    for z in range(zones):
        length = wall_length(p, s, z)
        if length > 0.0:
            uneven, count = uneven + abs(row_length(p, s, z) / length - taken / total), count + 1
    return uneven / count + p.uneven


@inlined
def zone_before(p: PreparedHall, s: State, row: int) -> int:
    """The zone before a stretch: both sides of a partition that stands off its border lie in the
    zone it stands in."""
    host = (row - s.stretches.shape[0] + 2 * p.hosts.shape[0]) // 2
    if host < 0 or abs(s.offsets[host]) <= 0.5 * p.thickness:
        return int(p.stretches[row, 5])
    return int(p.hosts[host, 4]) if s.offsets[host] > 0.0 else int(p.hosts[host, 5])


@inlined
def wall_length(p: PreparedHall, s: State, zone: int) -> float:
    """Metres of wall a zone has, partitions among them."""
    length = 0.0
    for row in range(s.stretches.shape[0]):
        if zone_before(p, s, row) == zone:
            length += s.stretches[row, 4]
    return length


@inlined
def row_length(p: PreparedHall, s: State, zone: int) -> float:
    """Metres of fronts of the objects of a zone that stand in rows at walls."""
    length = 0.0
    for u in range(p.zones.shape[0]):
        if p.zones[u] == zone and s.code[u] == WALL:
            for i in range(p.spans[u, 0], p.spans[u, 1]):
                length += p.sizes[i, 0]
    return length
