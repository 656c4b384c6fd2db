"""Distances of boxes in plan, and what one sees of segments: for wishes, in plain arrays.

Boxes are (n, 5): x, y, heading, width, depth; segments (m, 4): x0, y0, x1, y1. Metres and radians.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.core.layout import corners

Floats = NDArray[np.float64]

STILL = 1e-12  # what a segment moves along a side of a box by rounding, metres


def sides_of(boxes: Floats) -> Floats:
    """The sides of boxes (n, 5) as segments ``(4 n, 4)``."""
    points = corners(boxes)
    return np.concatenate([points, np.roll(points, -1, axis=-2)], axis=-1).reshape(-1, 4)


def distance_to_segments(boxes: Floats, segments: Floats) -> float:
    """The least distance between boxes (n, 5) and segments (m, 4); infinite without any.

    In the frame of a box a segment meets it where both slabs |u| <= w/2 and |v| <= d/2 hold for a
    common part of it; else the nearest points are an end of the segment or a corner of the box.

    >>> distance_to_segments(np.array([[0, 0, np.pi / 2, 2, 1.0]]), np.array([[3.0, -9, 3, 9]]))
    2.0
    """
    if not len(boxes) or not len(segments):
        return float("inf")
    half = boxes[:, None, None, 3:5] / 2
    ends = _in_frames(segments.reshape(-1, 2), boxes).reshape(len(boxes), -1, 2, 2)
    if _meets(ends, half[:, :, 0]).any():
        return 0.0
    from_ends = np.hypot(*np.moveaxis(np.maximum(np.abs(ends) - half, 0.0), -1, 0)).min()
    start, along = segments[:, :2], segments[:, 2:] - segments[:, :2]
    off = corners(boxes).reshape(-1, 1, 2) - start
    share = (off * along).sum(-1) / np.maximum((along**2).sum(-1), 1e-18)
    foot = off - np.clip(share, 0.0, 1.0)[..., None] * along
    return float(min(from_ends, np.hypot(foot[..., 0], foot[..., 1]).min()))


def distance_between(boxes: Floats, others: Floats) -> float:
    """The least distance between boxes (n, 5) and others (m, 5); infinite without any.

    >>> far = np.array([[4.0, 0, 0, 1, 1]])
    >>> distance_between(np.array([[0, 0, 0, 1, 1.0]]), far), distance_between(far, far)
    (3.0, 0.0)
    """
    if not len(boxes) or not len(others):
        return float("inf")
    inside = np.abs(_in_frames(boxes[:, :2], others)) <= others[:, None, 3:5] / 2
    return 0.0 if inside.all(-1).any() else distance_to_segments(boxes, sides_of(others))


def sees_any(eye: Floats, look: float, within: float, segments: Floats) -> bool:
    """Whether part of a segment (m, 4) lies within an angle, less than a right one, of straight
    ahead of an eye (2,): on the inner side of both edges of the wedge.

    >>> wall = np.array([[2.0, -1.0, 2.0, 1.0]])
    >>> sees_any(np.zeros(2), 0.0, 0.5, wall), sees_any(np.zeros(2), np.pi, 0.5, wall)
    (True, False)
    """
    turned = look + np.array([within, -within])
    inward = np.stack([np.sin(turned), -np.cos(turned)], -1) * np.array([[1.0], [-1.0]])
    first, last = ((segments[:, k : k + 2] - eye) @ inward.T for k in (0, 2))
    cut = np.abs(first) / np.maximum(np.abs(first - last), 1e-300)
    low = np.where((first < 0) & (last >= 0), cut, 0.0).max(-1)
    high = np.where((first >= 0) & (last < 0), cut, 1.0).min(-1)
    outside = ((first < 0) & (last < 0)).any(-1)
    return bool((~outside & (low <= high)).any())


def _in_frames(points: Floats, boxes: Floats) -> Floats:
    """Points (m, 2) along the width and the depth of each of boxes (n, 5), ``(n, m, 2)``."""
    cos, sin = np.cos(boxes[:, None, 2]), np.sin(boxes[:, None, 2])
    x, y = np.moveaxis(points - boxes[:, None, :2], -1, 0)
    return np.stack([x * sin - y * cos, x * cos + y * sin], -1)


def _meets(ends: Floats, half: Floats) -> NDArray[np.bool_]:
    """Whether segments given by their ends (n, m, 2, 2) enter the boxes of half sizes (n, 1, 2)."""
    start, along = ends[:, :, 0], ends[:, :, 1] - ends[:, :, 0]
    still = np.abs(along) < STILL
    way = np.where(still, 1.0, along)
    cuts = np.stack([(-half - start) / way, (half - start) / way])
    inside = np.abs(start) <= half
    low = np.where(still, np.where(inside, -np.inf, np.inf), cuts.min(0)).max(-1)
    high = np.where(still, np.inf, cuts.max(0)).min(-1)
    return np.asarray(np.maximum(low, 0.0) <= np.minimum(high, 1.0), np.bool_)
