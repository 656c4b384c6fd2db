"""Measuring halls: what one object, one unit, one border says. The sums are written once, here."""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import NUMBER, SINGLE, WALL
from scenewright.domains.hall.terms.state import STATE_STEP, Floats, PreparedHall, Scratch, State
from scenewright.domains.hall.terms.table import access_cost, proportion_cost
from scenewright.geometry.boxes import (
    Frame,
    apart,
    area_in_polygon,
    common_area,
    part_of,
    read_frame,
)
from scenewright.geometry.buckets import Buckets, column_of, row_of
from scenewright.geometry.compiled import compiled, inlined

SLACK = 1e-4
"""Overlap in square metres that rounding may leave."""


@inlined
def clear_of(frame: Frame, clear: Floats, i: int) -> Frame:
    """A footprint grown by its clear depths at front, left, back and right.

    ``clear`` (n, 4) in metres, row ``i``.
    """
    front, left, back, right = clear[i, 0], clear[i, 1], clear[i, 2], clear[i, 3]
    w, d = frame[4] + 0.5 * (left + right), frame[5] + 0.5 * (front + back)
    return part_of(frame, 0.5 * (right - left), 0.5 * (front - back), w, d)


@inlined
def write_row(frames: Floats, i: int, frame: Frame) -> None:
    """Set row ``i`` of frames (n, 8)."""
    frames[i, 0], frames[i, 1], frames[i, 2], frames[i, 3] = frame[0], frame[1], frame[2], frame[3]
    frames[i, 4], frames[i, 5], frames[i, 6], frames[i, 7] = frame[4], frame[5], frame[6], frame[7]


@inlined
def within(frame: Frame, p: PreparedHall, zone: int) -> bool:
    """True if a footprint lies in a zone."""
    edges = p.zone_edges[p.zone_spans[zone, 0] : p.zone_spans[zone, 1]]
    area = 4.0 * frame[4] * frame[5]
    return area_in_polygon(frame, edges) >= area - SLACK - 1e-6 * area


@inlined
def meets(frame: Frame, solids: Floats) -> bool:
    """True if a footprint meets one of the frames (k, 8)."""
    for k in range(solids.shape[0]):
        if solids[k, 4] > 0.0 and common_area(frame, read_frame(solids, k)) > SLACK:
            return True
    return False


@inlined
def wall_covered(clear: Frame, p: PreparedHall, walls: Floats) -> float:
    """α_W of one object: clearance beyond the hall, on obstacles, in door zones, on partitions.

    Square metres; ``walls`` (p, 8) frames of the partitions.
    """
    covered = 4.0 * clear[4] * clear[5] - area_in_polygon(clear, p.edges)
    for k in range(p.obstacles.shape[0]):
        covered += common_area(clear, read_frame(p.obstacles, k))
    for k in range(p.keep_free.shape[0]):
        covered += common_area(clear, read_frame(p.keep_free, k))
    for k in range(walls.shape[0]):
        if walls[k, 4] > 0.0:
            covered += common_area(clear, read_frame(walls, k))
    return covered


@inlined
def crowd(
    p: PreparedHall,
    s: State,
    work: Scratch,
    i: int,
    frame: Frame,
    clear: Frame,
    sign: float,
    strict: bool,
) -> float:
    """Shared clearance of object ``i`` with all others that are filed: what its own unit
    shares is returned, what other units share goes to ``delta`` with a sign.

    Returns -1 if the footprint meets another one, where ``strict``.
    """
    b: Buckets = s.buckets
    unit, own, large = p.unit_of[i], 0.0, b.columns * b.rows
    far = clear[6] + b.reach
    x0, x1 = column_of(b, clear[0] - far), column_of(b, clear[0] + far)
    y0, y1 = row_of(b, clear[1] - far), row_of(b, clear[1] + far)
    wide = x1 - x0 + 1
    for turn in range(wide * (y1 - y0 + 1) + 1):
        place = large
        if turn > 0:
            place = (y0 + (turn - 1) // wide) * b.columns + x0 + (turn - 1) % wide
        j = b.heads[place]
        while j >= 0:
            other = read_frame(s.clears, j)
            mine = p.unit_of[j] == unit
            if j != i and not (mine and sign < 0.0) and not apart(clear, other):
                if strict and common_area(frame, read_frame(s.frames, j)) > SLACK:
                    return -1.0
                area = common_area(clear, other)
                if mine:
                    own += area
                elif area > 0.0:
                    note(work, p.unit_of[j], sign * area)
                    note(work, unit, sign * area)
            j = b.after[j]
    return own


@inlined
def note(work: Scratch, unit: int, change: float) -> None:
    """Remember that α_M of a unit changes."""
    g = work.marks.shape[0]
    if work.marks[unit] == 0:
        work.marks[unit] = 1
        work.touched[work.touched[g]] = unit
        work.touched[g] += 1
        work.delta[unit] = 0.0
    work.delta[unit] += change


@inlined
def used_area(p: PreparedHall, s: State, unit: int) -> float:
    """Area of a unit's extent in its zone: its pattern's box, or the clearances of wall rows and
    single objects; as printed, footprints and clearances wherever they stand."""
    if p.constant[unit] >= 0.0:
        return p.constant[unit]
    first, last = p.spans[unit, 0], p.spans[unit, 1]
    zone = p.zones[unit]
    edges = p.zone_edges[p.zone_spans[zone, 0] : p.zone_spans[zone, 1]]
    if s.code[unit] in (SINGLE, WALL):
        total = 0.0
        for i in range(first, last):
            total += area_in_polygon(read_frame(s.clears, i), edges)
        return total
    return area_in_polygon(extent_of(s, unit, first, last), edges)


@inlined
def extent_of(s: State, unit: int, first: int, last: int) -> Frame:
    """The box with the unit's heading round all its clearances."""
    c, n = math.cos(s.pose[unit, 2]), math.sin(s.pose[unit, 2])
    u0, u1, v0, v1 = math.inf, -math.inf, math.inf, -math.inf
    for i in range(first, last):
        x, y = s.clears[i, 0], s.clears[i, 1]
        u, v = x * n - y * c, x * c + y * n
        turn_c = abs(s.clears[i, 2] * c + s.clears[i, 3] * n)
        turn_s = abs(s.clears[i, 3] * c - s.clears[i, 2] * n)
        w = turn_c * s.clears[i, 4] + turn_s * s.clears[i, 5]
        d = turn_s * s.clears[i, 4] + turn_c * s.clears[i, 5]
        u0, u1, v0, v1 = min(u0, u - w), max(u1, u + w), min(v0, v - d), max(v1, v + d)
    u, v, w, d = 0.5 * (u0 + u1), 0.5 * (v0 + v1), 0.5 * (u1 - u0), 0.5 * (v1 - v0)
    return (u * n + v * c, -u * c + v * n, c, n, w, d, math.sqrt(w * w + d * d), s.pose[unit, 2])


@inlined
def gap_between(a: Frame, b: Frame) -> float:
    """Distance between two boxes along the line of their centres, edge to edge."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    far = math.sqrt(dx * dx + dy * dy)
    if far < 1e-9:
        return 0.0
    dx, dy = dx / far, dy / far
    reach = abs(dx * a[3] - dy * a[2]) * a[4] + abs(dx * a[2] + dy * a[3]) * a[5]
    reach += abs(dx * b[3] - dy * b[2]) * b[4] + abs(dx * b[2] + dy * b[3]) * b[5]
    return far - reach


@inlined
def proportion_of(p: PreparedHall, s: State, unit: int) -> float:
    """E_p of a unit: neighbours in each layer, and the first objects of layers in turn."""
    if s.code[unit] in (SINGLE, WALL):
        return 0.0
    total, i, row = 0.0, p.spans[unit, 0], p.layer_spans[unit, 0]
    for k in range(s.used[unit]):
        number = int(s.layers[row + k, NUMBER])
        for j in range(number):
            after = i + number if j == 0 and k + 1 < s.used[unit] else -1
            for other in (i + j + 1 if j + 1 < number else -1, after):
                if other >= 0:
                    gap = gap_between(read_frame(s.frames, i + j), read_frame(s.frames, other))
                    total += proportion_cost(gap, p.iota[i + j] + p.iota[other] + 1.0)
        i += number
    return total


@inlined
def span_in_strip(frame: Frame, border: Floats, half: float) -> tuple[float, float]:
    """Part of a border (metres from its start) that a box covers within ``half`` of it.

    ``border`` (r,) begins with x0, y0, x1, y1 in metres.
    """
    dx, dy = border[2] - border[0], border[3] - border[1]
    length = math.sqrt(dx * dx + dy * dy)
    dx, dy = dx / length, dy / length
    low, high = math.inf, -math.inf
    for side in range(4):
        c0, c1 = 1.0 if side in (0, 3) else -1.0, 1.0 if side in (0, 1) else -1.0
        e0, e1 = 1.0 if side in (3, 2) else -1.0, 1.0 if side in (0, 3) else -1.0
        ax = frame[0] + c0 * frame[3] * frame[4] + c1 * frame[2] * frame[5] - border[0]
        ay = frame[1] - c0 * frame[2] * frame[4] + c1 * frame[3] * frame[5] - border[1]
        bx = frame[0] + e0 * frame[3] * frame[4] + e1 * frame[2] * frame[5] - border[0]
        by = frame[1] - e0 * frame[2] * frame[4] + e1 * frame[3] * frame[5] - border[1]
        u0, v0, u1, v1 = ax * dx + ay * dy, ay * dx - ax * dy, bx * dx + by * dy, by * dx - bx * dy
        if max(v0, v1) < -half or min(v0, v1) > half:
            continue
        if v0 != v1:
            t0, t1 = (-half - v0) / (v1 - v0), (half - v0) / (v1 - v0)
            t0, t1 = max(min(t0, t1), 0.0), min(max(t0, t1), 1.0)
            u0, u1 = u0 + t0 * (u1 - u0), u0 + t1 * (u1 - u0)
        low, high = min(low, u0, u1), max(high, u0, u1)
    return low, high


@inlined
def block(work: Scratch, cells: int, low: float, high: float) -> None:
    """Mark the cells of a border between two distances from its start."""
    if low <= high:
        first, last = math.floor(low / STATE_STEP + 1e-6), math.ceil(high / STATE_STEP - 1e-6)
        for k in range(max(first, 0), min(last, cells)):
            work.cells[k] = 1


@compiled
def passage(p: PreparedHall, s: State, work: Scratch, link: int) -> float:
    """d of one link: the longest free stretch of its borders, in metres."""
    half, best = p.links[link, 2], 0
    b: Buckets = s.buckets
    for k in range(p.borders.shape[0]):
        if int(p.borders[k, 4]) != link:
            continue
        first, cells = p.border_cells[k, 0], p.border_cells[k, 1]
        for c in range(cells):
            work.cells[c] = p.blocked[first + c]
        for h in range(s.walls.shape[0]):
            if s.walls[h, 4] > 0.0:
                low, high = span_in_strip(read_frame(s.walls, h), p.borders[k], half)
                block(work, cells, low, high)
        far = half + b.reach
        x0 = column_of(b, min(p.borders[k, 0], p.borders[k, 2]) - far)
        x1 = column_of(b, max(p.borders[k, 0], p.borders[k, 2]) + far)
        y0 = row_of(b, min(p.borders[k, 1], p.borders[k, 3]) - far)
        y1 = row_of(b, max(p.borders[k, 1], p.borders[k, 3]) + far)
        wide = x1 - x0 + 1
        for turn in range(wide * (y1 - y0 + 1) + 1):
            place = b.columns * b.rows
            if turn > 0:
                place = (y0 + (turn - 1) // wide) * b.columns + x0 + (turn - 1) % wide
            j = b.heads[place]
            while j >= 0:
                low, high = span_in_strip(read_frame(s.frames, j), p.borders[k], half)
                block(work, cells, low, high)
                j = b.after[j]
        run = 0
        for c in range(cells):
            run = 0 if work.cells[c] else run + 1
            best = max(best, run)
    return best * STATE_STEP


@compiled
def block_solids(p: PreparedHall, border: int, half: float, edges: Floats, work: Scratch) -> None:
    """Mark the cells of a border that walls (frames ``edges``) and obstacles block, in
    ``cells``.

    ``edges`` (k, 8) frames; ``half`` in metres.
    """
    cells = p.border_cells[border, 1]
    for solids in (edges, p.obstacles):
        for k in range(solids.shape[0]):
            low, high = span_in_strip(read_frame(solids, k), p.borders[border], half)
            block(work, cells, low, high)


@inlined
def access_of(p: PreparedHall, s: State, work: Scratch, link: int) -> float:
    """E_a of one link."""
    return access_cost(p.links[link, 2], passage(p, s, work, link))
