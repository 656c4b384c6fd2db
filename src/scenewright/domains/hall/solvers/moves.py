"""Moves of halls: what a proposal changes. The paper's guided four, and a designer's few more.

Cao, Cheng, Zhang 2024, 3.3: expand or shrink, translate or rotate, extend or shorten a wall,
change the pattern. Each writes the new pattern of one unit; nothing is judged here.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import (
    ACROSS,
    ALONG,
    AROUND,
    CHAIN,
    CIRCULATION,
    FAN,
    GRID,
    SINGLE,
    WALL,
)
from scenewright.domains.hall.patterns.chain import seed_chain
from scenewright.domains.hall.patterns.expand import seed, stretch
from scenewright.domains.hall.patterns.fan import ROW, STAGE
from scenewright.domains.hall.terms.state import PreparedHall, State
from scenewright.domains.hall.terms.visitors import LANE
from scenewright.engine.draws import Stream, bell, below, uniform
from scenewright.geometry.boxes import square_to_segment
from scenewright.geometry.compiled import compiled, inlined

QUARTER = 0.5 * math.pi


@inlined
def wall_angle(p: PreparedHall, zone: int, x: float, y: float) -> float:
    """Direction of the edge of a zone nearest to a point."""
    least, angle = math.inf, 0.0
    for e in range(p.zone_spans[zone, 0], p.zone_spans[zone, 1]):
        x0, y0, x1, y1 = (
            p.zone_edges[e, 0],
            p.zone_edges[e, 1],
            p.zone_edges[e, 2],
            p.zone_edges[e, 3],
        )
        far = square_to_segment(x, y, x0, y0, x1, y1)
        if far < least:
            least, angle = far, math.atan2(y1 - y0, x1 - x0)
    return angle


@inlined
def drawn_edge(p: PreparedHall, zone: int, stream: Stream) -> float:
    """Direction of an edge of a zone, drawn by length."""
    first, last = p.zone_spans[zone, 0], p.zone_spans[zone, 1]
    total = 0.0
    for e in range(first, last):
        total += math.hypot(
            p.zone_edges[e, 2] - p.zone_edges[e, 0], p.zone_edges[e, 3] - p.zone_edges[e, 1]
        )
    rest = uniform(stream) * total
    for e in range(first, last):
        dx, dy = p.zone_edges[e, 2] - p.zone_edges[e, 0], p.zone_edges[e, 3] - p.zone_edges[e, 1]
        rest -= math.hypot(dx, dy)
        if rest <= 0.0 or e + 1 == last:
            return math.atan2(dy, dx)
    return 0.0


@inlined
def drawn_code(p: PreparedHall, unit: int, stream: Stream) -> int:
    """One of the patterns a unit may take."""
    total = 0
    for k in range(p.choices.shape[1]):
        total += p.choices[unit, k]
    rest = below(stream, total)
    for k in range(p.choices.shape[1]):
        rest -= p.choices[unit, k]
        if rest < 0:
            return k
    return SINGLE


@compiled
def reseed(p: PreparedHall, s: State, unit: int, code: int, shape: float, tight: float) -> None:
    """Give a unit a pattern in its seeded form; gaps are what clearances need times ``tight``.
    Tills with lanes between them stand one behind another."""
    row, end = p.layer_spans[unit, 0], p.layer_spans[unit, 1]
    wide, deep = p.largest[unit, 0], p.largest[unit, 1]
    along, across = tight * p.gaps[unit, 0], tight * p.gaps[unit, 1]
    number, near = p.spans[unit, 1] - p.spans[unit, 0], STAGE
    if code == FAN:
        across = tight * max(p.gaps[unit, 1], ROW)
        near = max(min(tight, 1.0) * p.near[unit], STAGE)
    if code == CHAIN and p.roles[unit] & LANE:
        used, extra = seed_chain(s.layers[row:end], 0, number, number, along, across, 0), 0.0
    else:
        used, extra = seed(code, number, shape, wide, deep, along, across, near, s.layers[row:end])
    s.code[unit], s.used[unit] = code, used
    s.pose[unit, 3] = along if code == WALL else extra


@inlined
def drawn_alignment(stream: Stream) -> float:
    """How a wall row is aligned: mostly to the middle or an end."""
    if uniform(stream) < 0.7:
        return float(below(stream, 3) - 1)
    return 2.0 * uniform(stream) - 1.0


@compiled
def scatter(p: PreparedHall, s: State, unit: int, stream: Stream) -> None:
    """Put a unit anywhere in its zone, parallel to one of its edges."""
    zone = p.zones[unit]
    b = p.zone_bounds
    s.pose[unit, 0] = b[zone, 0] + uniform(stream) * (b[zone, 2] - b[zone, 0])
    s.pose[unit, 1] = b[zone, 1] + uniform(stream) * (b[zone, 3] - b[zone, 1])
    s.pose[unit, 2] = drawn_edge(p, zone, stream) + QUARTER * below(stream, 4)
    if s.code[unit] == WALL:
        s.pose[unit, 0], s.pose[unit, 1] = uniform(stream) * 1000.0, drawn_alignment(stream)


@inlined
def spread(p: PreparedHall, s: State, unit: int, step: float, stream: Stream) -> None:
    """Expand (positive step) or shrink a unit, along, across or both.

    Objects that want no clearance at their sides, as shelves and seats, stay side by side.
    """
    close = p.gaps[unit, 0] == 0.0
    if s.code[unit] == WALL:
        s.pose[unit, 3] = 0.0 if close else max(s.pose[unit, 3] + step, 0.0)
        return
    row, way = p.layer_spans[unit, 0], below(stream, 3)
    layers = s.layers[row : row + s.used[unit]]
    along, across = step if way != 1 else 0.0, step if way != 0 else 0.0
    if close:
        along = 0.0
        across = 0.0 if s.code[unit] in (CIRCULATION, FAN) else step
    if s.code[unit] == AROUND:
        across = 0.0
    s.pose[unit, 3] = stretch(s.code[unit], layers, s.pose[unit, 3], along, across)


@inlined
def slide(s: State, unit: int, reach: float, stream: Stream) -> None:
    """Move a unit by about ``reach`` metres; a wall row to another wall or end of its walls."""
    if s.code[unit] == WALL:
        if uniform(stream) < 0.5:
            s.pose[unit, 0] += 4.0 * bell(stream)
        s.pose[unit, 1] = drawn_alignment(stream)
    else:
        s.pose[unit, 0] += reach * bell(stream)
        s.pose[unit, 1] += reach * bell(stream)


@inlined
def turn(p: PreparedHall, s: State, unit: int, stream: Stream) -> None:
    """Turn a unit so that a side of its box is parallel to the nearest edge of its zone, or
    towards what it looks at."""
    target = p.targets[unit]
    if target >= 0 and uniform(stream) < 0.5:
        first = p.spans[target, 0]
        dx, dy = s.frames[first, 0] - s.pose[unit, 0], s.frames[first, 1] - s.pose[unit, 1]
        s.pose[unit, 2] = math.atan2(dy, dx)
        return
    angle = wall_angle(p, p.zones[unit], s.pose[unit, 0], s.pose[unit, 1])
    s.pose[unit, 2] = angle + QUARTER * below(stream, 4)


@inlined
def snap(p: PreparedHall, s: State, unit: int, stream: Stream) -> None:
    """Bring the centre of a unit in line with the middle of its zone or with another unit."""
    zone, other = p.zones[unit], below(stream, p.zones.shape[0])
    x, y = p.middles[zone, 0], p.middles[zone, 1]
    if p.zones[other] == zone and other != unit and s.code[other] != WALL:
        x, y = s.pose[other, 0], s.pose[other, 1]
    c, n = math.cos(s.pose[unit, 2]), math.sin(s.pose[unit, 2])
    dx, dy = x - s.pose[unit, 0], y - s.pose[unit, 1]
    if uniform(stream) < 0.5:
        far = dx * c + dy * n
        s.pose[unit, 0], s.pose[unit, 1] = s.pose[unit, 0] + far * c, s.pose[unit, 1] + far * n
    else:
        far = dx * n - dy * c
        s.pose[unit, 0], s.pose[unit, 1] = s.pose[unit, 0] + far * n, s.pose[unit, 1] - far * c


@inlined
def change_pattern(p: PreparedHall, s: State, unit: int, stream: Stream) -> None:
    """Another pattern, or another form of the same: few or many rows, rings, sector angles."""
    code = drawn_code(p, unit, stream)
    reseed(p, s, unit, code, uniform(stream), 1.0)


@inlined
def change_form(p: PreparedHall, s: State, unit: int, stream: Stream) -> None:
    """As :func:`change_pattern`, but rows that stay rows keep their gaps, or leave just enough
    between rows to pass, where that is more than clearances ask for: more or fewer rows."""
    row, code = p.layer_spans[unit, 0], s.code[unit]
    along, across = s.layers[row, ALONG], s.layers[row, ACROSS]
    change_pattern(p, s, unit, stream)
    if code == s.code[unit] and code in (CHAIN, GRID):
        if uniform(stream) < 0.5:
            across = ROW
        for k in range(row, row + s.used[unit]):
            s.layers[k, ALONG] = max(s.layers[k, ALONG], along)
            s.layers[k, ACROSS] = max(s.layers[k, ACROSS], across)
