"""What guidelines of interior design for single objects share (Merrell et al. 2011)."""

from __future__ import annotations

from scenewright.geometry.compiled import compiled

OVERLAP, CLEARANCE, BACK = 200.0, 20.0, 10.0


DISTANCE, ANGLE, ALIGNMENT, EMPHASIS, BALANCE, CIRCULATION = 5.0, 2.0, 1.0, 0.5, 2.0, 20.0


@compiled
def within_range(gap: float, least: float, most: float) -> float:
    """t(d, m, M): 1 between least and most, falling off as a square beyond (Merrell et al.).

    >>> within_range(0.5, 1.0, 2.0), within_range(1.5, 1.0, 2.0), within_range(4.0, 1.0, 2.0)
    (0.25, 1.0, 0.25)
    """
    if gap < least:
        return (max(gap, 0.0) / least) ** 2
    return 1.0 if gap <= most else (most / gap) ** 2
