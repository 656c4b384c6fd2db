"""Oriented boxes against polygons, boxes, segments and points: exact areas and distances.

A *frame* is a box ready for arithmetic: ``(x, y, cos, sin, half width, half depth, radius,
heading)``. In its own axes u runs to the right and v to the front, the centre is the origin.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]
Frame = tuple[float, float, float, float, float, float, float, float]
Sides = tuple[float, float, float, float]


@compiled
def make_frame(x: float, y: float, heading: float, width: float, depth: float) -> Frame:
    """The frame of a box; ``radius`` is that of the circle round its corners.

    >>> make_frame(1.0, 2.0, 0.0, 3.0, 4.0)
    (1.0, 2.0, 1.0, 0.0, 1.5, 2.0, 2.5, 0.0)
    """
    w, d = 0.5 * width, 0.5 * depth
    return (x, y, math.cos(heading), math.sin(heading), w, d, math.sqrt(w * w + d * d), heading)


@inlined
def read_frame(frames: Floats, i: int) -> Frame:
    """Row ``i`` of frames ``(n, 8)``."""
    return (
        frames[i, 0],
        frames[i, 1],
        frames[i, 2],
        frames[i, 3],
        frames[i, 4],
        frames[i, 5],
        frames[i, 6],
        frames[i, 7],
    )


@inlined
def read_sides(sides: Floats, i: int) -> Sides:
    """Row ``i`` of ``sides`` (n, 4): something for the front, left, back and right side."""
    return sides[i, 0], sides[i, 1], sides[i, 2], sides[i, 3]


@compiled
def part_of(frame: Frame, u: float, v: float, w: float, d: float) -> Frame:
    """The frame of a box with the same heading whose centre lies ``u`` right and ``v`` ahead of
    this one's, with half width ``w`` and half depth ``d``."""
    x, y, c, s = frame[0], frame[1], frame[2], frame[3]
    return (x + u * s + v * c, y - u * c + v * s, c, s, w, d, math.sqrt(w * w + d * d), frame[7])


@compiled
def beyond(frame: Frame, side: int, depth: float) -> Frame:
    """The zone of ``depth`` metres outside one side (0 front, 1 left, 2 back, 3 right)."""
    w, d, half = frame[4], frame[5], 0.5 * depth
    if side == 0:
        return part_of(frame, 0.0, d + half, w, half)
    if side == 2:
        return part_of(frame, 0.0, -d - half, w, half)
    if side == 1:
        return part_of(frame, -w - half, 0.0, half, d)
    return part_of(frame, w + half, 0.0, half, d)


@inlined
def area_under(u0: float, v0: float, u1: float, v1: float, w: float, d: float) -> float:
    """Signed share of one directed edge in the area common to a polygon and a box.

    With the box's lower left corner as origin of v, the edge clipped to |u| <= w runs from
    height s0 to s1. Clamped to the box's depth it lies at mean height m, and contributes
    (u_start - u_end) m. Sums over a closed outline, inside on the left, to the exact area;
    holes are just more edges. No antiderivative, so nothing cancels on near-level edges.
    """
    low, high = (u0, u1) if u0 < u1 else (u1, u0)
    if high <= -w or low >= w or (v0 <= -d and v1 <= -d):
        return 0.0
    a, b = min(max(u0, -w), w), min(max(u1, -w), w)
    h = 2.0 * d
    if v0 >= d and v1 >= d:
        return (a - b) * h
    if high <= low:
        return 0.0
    slope = (v1 - v0) / (u1 - u0)
    s0 = (v0 + (a - u0) * slope if abs(a - u0) <= abs(a - u1) else v1 + (a - u1) * slope) + d
    s1 = (v1 + (b - u1) * slope if abs(b - u1) <= abs(b - u0) else v0 + (b - u0) * slope) + d
    c0, c1 = min(max(s0, 0.0), h), min(max(s1, 0.0), h)
    middle = 0.5 * (c0 + c1)
    share = (c1 - c0) / (s1 - s0) if s1 != s0 else 0.0
    return (a - b) * (middle + share * (0.5 * (s0 + s1) - middle))


@compiled
def area_in_polygon(frame: Frame, edges: Floats) -> float:
    """Area of box ∩ polygon, square metres; ``edges`` (e, 4) directed, inside on the left.

    >>> square = np.array([[0, 0, 2, 0], [2, 0, 2, 2], [2, 2, 0, 2], [0, 2, 0, 0]], float)
    >>> area_in_polygon(make_frame(2.0, 1.0, 0.3, 1.0, 1.0), square)
    0.5
    """
    x, y, c, s, w, d = frame[0], frame[1], frame[2], frame[3], frame[4], frame[5]
    total = 0.0
    for e in range(edges.shape[0]):
        x0, y0, x1, y1 = edges[e, 0] - x, edges[e, 1] - y, edges[e, 2] - x, edges[e, 3] - y
        total += area_under(
            x0 * s - y0 * c, x0 * c + y0 * s, x1 * s - y1 * c, x1 * c + y1 * s, w, d
        )
    return min(max(total, 0.0), 4.0 * w * d)


@inlined
def apart(a: Frame, b: Frame) -> bool:
    """True if the circles round two boxes do not meet, so the boxes do not."""
    dx, dy, reach = b[0] - a[0], b[1] - a[1], a[6] + b[6]
    return dx * dx + dy * dy >= reach * reach


@compiled
def common_area(a: Frame, b: Frame) -> float:
    """Area of box ∩ box, square metres.

    >>> common_area(make_frame(0.0, 0.0, 0.0, 2.0, 2.0), make_frame(1.0, 1.0, 0.0, 2.0, 2.0))
    1.0
    """
    if apart(a, b):
        return 0.0
    dx, dy, c, s = b[0] - a[0], b[1] - a[1], a[2], a[3]
    u, v = dx * s - dy * c, dx * c + dy * s
    c, s = b[2] * c + b[3] * s, b[3] * c - b[2] * s  # b's front in the frame of a is (-s, c)
    ru, rv, fu, fv = c * b[4], s * b[4], -s * b[5], c * b[5]
    u0, v0, u1, v1 = u + ru - fu, v + rv - fv, u + ru + fu, v + rv + fv
    u2, v2, u3, v3 = u - ru + fu, v - rv + fv, u - ru - fu, v - rv - fv
    w, d = a[4], a[5]
    total = area_under(u0, v0, u1, v1, w, d) + area_under(u1, v1, u2, v2, w, d)
    total += area_under(u2, v2, u3, v3, w, d) + area_under(u3, v3, u0, v0, w, d)
    return min(max(total, 0.0), 4.0 * min(w * d, b[4] * b[5]))


@inlined
def square_to_segment(x: float, y: float, x0: float, y0: float, x1: float, y1: float) -> float:
    """Squared distance of a point to a segment, square metres."""
    ex, ey, px, py = x1 - x0, y1 - y0, x - x0, y - y0
    length = ex * ex + ey * ey
    t = min(max((px * ex + py * ey) / length, 0.0), 1.0) if length > 0.0 else 0.0
    dx, dy = px - t * ex, py - t * ey
    return dx * dx + dy * dy


@compiled
def distance_to_segment(x: float, y: float, x0: float, y0: float, x1: float, y1: float) -> float:
    """Distance of a point to a segment, metres.

    >>> distance_to_segment(3.0, 4.0, 0.0, 0.0, 0.0, 0.0)
    5.0
    """
    return math.sqrt(square_to_segment(x, y, x0, y0, x1, y1))


@inlined
def nearest_segment(x: float, y: float, segments: Floats) -> tuple[int, float]:
    """Index of and distance to the nearest of segments (w, 4); -1 and infinity if there is none."""
    found, least = -1, np.inf
    for k in range(segments.shape[0]):
        far = square_to_segment(
            x, y, segments[k, 0], segments[k, 1], segments[k, 2], segments[k, 3]
        )
        if far < least:
            found, least = k, far
    return found, math.sqrt(least)


@compiled
def distance_to_box(x: float, y: float, frame: Frame) -> float:
    """Distance of a point to a box, 0 inside, metres.

    >>> distance_to_box(3.0, 0.0, make_frame(0.0, 0.0, 0.0, 1.0, 2.0))
    2.0
    """
    dx, dy, c, s = x - frame[0], y - frame[1], frame[2], frame[3]
    u = max(abs(dx * s - dy * c) - frame[4], 0.0)
    v = max(abs(dx * c + dy * s) - frame[5], 0.0)
    return math.sqrt(u * u + v * v)


@compiled
def wrap(angle: float) -> float:
    """The angle brought into [-π, π].

    >>> round(wrap(2 * np.pi + 0.25), 6)
    0.25
    """
    return angle - 2.0 * math.pi * math.floor((angle + math.pi) / (2.0 * math.pi))


@compiled
def fill_frames(boxes: Floats, frames: Floats) -> None:
    """Write the frames ``(n, 8)`` of boxes ``(n, 5)``."""
    for i in range(boxes.shape[0]):
        f = make_frame(boxes[i, 0], boxes[i, 1], boxes[i, 2], boxes[i, 3], boxes[i, 4])
        for k in range(8):
            frames[i, k] = f[k]


def frames_of(boxes: Floats) -> Floats:
    """Frames ``(n, 8)`` of boxes ``(n, 5)``."""
    frames = np.empty((boxes.shape[0], 8))
    fill_frames(boxes, frames)
    return frames
