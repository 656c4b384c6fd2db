"""Moves that bring order into a hall: groups in line with others, and gaps like theirs. Ours."""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import ACROSS, ALONG, CHAIN, GRID, WALL
from scenewright.domains.hall.terms.state import PreparedHall, State
from scenewright.engine.draws import Stream, below
from scenewright.geometry.compiled import inlined

LOOKS = 6
"""Objects looked at for the nearest line."""


@inlined
def line_up(p: PreparedHall, s: State, unit: int, stream: Stream) -> None:
    """Move a unit along or across the hall until one of its objects stands in line with an
    object of another: the nearest line of a few drawn."""
    first, last = p.spans[unit, 0], p.spans[unit, 1]
    i, axis, least = first + below(stream, last - first), below(stream, 2), math.inf
    x, y = p.axes[axis, 0], p.axes[axis, 1]
    for _look in range(LOOKS):
        j = below(stream, s.frames.shape[0])
        far = (s.frames[j, 0] - s.frames[i, 0]) * x + (s.frames[j, 1] - s.frames[i, 1]) * y
        if p.unit_of[j] != unit and abs(far) > 1e-6 and abs(far) < abs(least):
            least = far
    if least < math.inf:
        s.pose[unit, 0], s.pose[unit, 1] = s.pose[unit, 0] + least * x, s.pose[unit, 1] + least * y


@inlined
def match_pitch(p: PreparedHall, s: State, unit: int, stream: Stream) -> None:
    """Give the rows or columns of a unit the pitch of another unit's, so that they can line up."""
    other = below(stream, p.spans.shape[0])
    mine, theirs = below(stream, 2), below(stream, 2)
    if mine == 0 and p.gaps[unit, 0] == 0.0:
        mine = 1
    rows = s.code[unit] in (CHAIN, GRID) and s.code[other] in (CHAIN, GRID)
    if not rows or other == unit or s.code[unit] == WALL:
        return
    pitch = p.largest[other, theirs] + s.layers[p.layer_spans[other, 0], ALONG + theirs]
    gap = pitch - p.largest[unit, mine]
    for _turn in range(3):
        gap += pitch if gap < 0.0 else 0.0
    row = p.layer_spans[unit, 0]
    for k in range(row, row + s.used[unit]):
        s.layers[k, ALONG if mine == 0 else ACROSS] = max(gap, 0.0)
