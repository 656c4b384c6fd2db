"""How orderly a hall stands: the lines its objects share, and the gaps between neighbours. Ours.

Both are what the measures of Cao, Cheng and Zhang (2024, eqs. 7 and 9) see of a layout, as the
search can follow them move by move.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import FAN, NUMBER, SINGLE, WALL
from scenewright.domains.hall.terms.measure import gap_between
from scenewright.domains.hall.terms.state import LINE, Floats, PreparedHall, State
from scenewright.domains.hall.terms.table import PASS, aisle_cost
from scenewright.geometry.boxes import read_frame
from scenewright.geometry.compiled import inlined

OPPOSED = -0.99
"""Cosine of the angle between two objects below which they stand back to back or face to face."""


@inlined
def count_lines(
    p: PreparedHall, s: State, frames: Floats, first: int, last: int, sign: int
) -> float:
    """Enter (sign 1) or strike out (-1) the middles of objects ``first`` to ``last`` - 1 of
    ``frames`` (n, 8) in the lines along both axes of the hall; how many more lines there are than
    before."""
    change = 0
    for i in range(first, last):
        for axis in range(2):
            along = frames[i, 0] * p.axes[axis, 0] + frames[i, 1] * p.axes[axis, 1]
            k = math.floor((along - p.axes[axis, 2]) / LINE)
            k = min(max(k, 0), s.lines.shape[1] - 1)
            if sign > 0 and s.lines[axis, k] == 0:
                change += 1
            s.lines[axis, k] += sign
            if sign < 0 and s.lines[axis, k] == 0:
                change -= 1
    return float(change)


@inlined
def all_lines(p: PreparedHall, s: State) -> float:
    """n_vap + n_hap of eq. 7 in cells of 1 cm, counted afresh."""
    for axis in range(2):
        for k in range(s.lines.shape[1]):
            s.lines[axis, k] = 0
    return count_lines(p, s, s.frames, 0, s.frames.shape[0], 1)


@inlined
def back_to_back(s: State, first: int, last: int) -> float:
    """Metres that gaps lack between objects ``first`` to ``last`` - 1 on both sides of a wall: the
    less of them, the more hangs on walls that have one side."""
    total = 0.0
    for i in range(first, last):
        for j in range(i + 2, last):
            dx, dy = s.frames[j, 0] - s.frames[i, 0], s.frames[j, 1] - s.frames[i, 1]
            near = PASS + s.frames[i, 6] + s.frames[j, 6]
            turned = s.frames[i, 2] * s.frames[j, 2] + s.frames[i, 3] * s.frames[j, 3]
            if turned < OPPOSED and dx * dx + dy * dy < near * near:
                gap = gap_between(read_frame(s.frames, i), read_frame(s.frames, j))
                total += aisle_cost(gap, 0.0)
    return total


@inlined
def aisles_of(p: PreparedHall, s: State, unit: int) -> float:
    """Metres that gaps lack: neighbours of each layer, and layers in turn, as often as the layer
    has objects. The seats of a curved row stand side by side though their corners alone meet.
    Between objects that people walk round a whole passage is wished for."""
    if s.code[unit] == SINGLE:
        return 0.0
    first, last, row = p.spans[unit, 0], p.spans[unit, 1], p.layer_spans[unit, 0]
    total, i = 0.0, first
    wide = p.passage if p.strolled[first] == 1 and s.code[unit] != WALL else 0.0
    if s.code[unit] == WALL:
        for j in range(first, last - 1):
            gap = gap_between(read_frame(s.frames, j), read_frame(s.frames, j + 1))
            total += aisle_cost(gap, wide)
        return total + (back_to_back(s, first, last) if p.hosts.shape[0] > 0 else 0.0)
    for k in range(s.used[unit]):
        number = int(s.layers[row + k, NUMBER])
        beside = 0 if s.code[unit] == FAN else number - 1
        for j in range(i, i + beside):
            gap = gap_between(read_frame(s.frames, j), read_frame(s.frames, j + 1))
            total += aisle_cost(gap, wide)
        i += number
        if k + 1 < s.used[unit]:
            before = read_frame(s.frames, i - number)
            total += number * aisle_cost(gap_between(before, read_frame(s.frames, i)), wide)
    return total
