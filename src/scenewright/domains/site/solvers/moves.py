"""Moves of buildings: where a building might go next."""

from __future__ import annotations

import math

from scenewright.domains.site.terms.measure import SitePrepared, SiteState
from scenewright.engine.draws import Stream, bell, below, uniform
from scenewright.geometry.boxes import Floats, Frame, make_frame, part_of, read_frame
from scenewright.geometry.compiled import inlined

QUARTER = 0.5 * math.pi


@inlined
def drawn_heading(lines: Floats, stream: Stream) -> float:
    """Any heading, or where ``lines`` (base heading, 1 if free) says so one of four."""
    if lines[1] > 0.5 and uniform(stream) < 0.5:
        return 2.0 * math.pi * uniform(stream)
    return lines[0] + QUARTER * below(stream, 4)


@inlined
def in_block(p: SitePrepared, i: int, lines: Floats, stream: Stream) -> Frame:
    """Somewhere within the bounds of a block, blocks drawn by their area, headed as
    ``lines`` (2,) say."""
    b, rest = 0, uniform(stream)
    while b + 1 < p.blocks.shape[0] and p.blocks[b, 6] <= rest:
        b += 1
    x = p.blocks[b, 0] + uniform(stream) * (p.blocks[b, 2] - p.blocks[b, 0])
    y = p.blocks[b, 1] + uniform(stream) * (p.blocks[b, 3] - p.blocks[b, 1])
    heading = drawn_heading(lines, stream)
    return make_frame(x, y, heading, p.buildings[i, 0], p.buildings[i, 1])


@inlined
def beside(p: SitePrepared, frame: Frame, other: Frame, stream: Stream) -> Frame:
    """At a side of another building, at the spacing, in line with its front, back or middle."""
    side, gap = below(stream, 4), 2.0 * p.measures[0] + 1e-3
    w, d, line = frame[4], frame[5], below(stream, 3) - 1.0
    if side % 2 == 0:
        v = (other[5] + gap + d) * (1.0 - side)
        return part_of(other, line * (other[4] - w), v, w, d)
    u = (other[4] + gap + w) * (2.0 - side)
    return part_of(other, u, line * (other[5] - d), w, d)


@inlined
def propose(
    p: SitePrepared, s: SiteState, i: int, heat: float, lines: Floats, drawn: Floats, stream: Stream
) -> Frame:
    """A move of building ``i``; ``heat`` from 1 to 0 sets how far small moves go, ``lines`` (2,)
    are as in :func:`drawn_heading`, ``drawn`` (7,) a :class:`BuildingMoveSettings`."""
    frame, n, kind = read_frame(s.frames, i), s.frames.shape[0], uniform(stream)
    if frame[4] <= 0.0:
        frame = in_block(p, i, lines, stream)
        if kind < drawn[1] or kind >= drawn[2]:
            return frame
    if kind < drawn[0]:
        far, only = drawn[4] + drawn[5] * heat * heat, uniform(stream)
        u = far * bell(stream) if only < 0.7 else 0.0
        v = far * bell(stream) if only > 0.3 else 0.0
        return part_of(frame, u, v, frame[4], frame[5])
    if kind < drawn[1]:
        heading = drawn_heading(lines, stream)
        if lines[1] > 0.5 and uniform(stream) < 0.5:
            heading = frame[7] + drawn[6] * heat * bell(stream)
        return make_frame(frame[0], frame[1], heading, 2.0 * frame[4], 2.0 * frame[5])
    if kind < drawn[2] and n > 1:
        other = read_frame(s.frames, (i + 1 + below(stream, n - 1)) % n)
        if other[4] > 0.0:
            return beside(p, frame, other, stream)
    if kind < drawn[3]:
        return in_block(p, i, lines, stream)
    return make_frame(0.0, 0.0, 0.0, 0.0, 0.0)
