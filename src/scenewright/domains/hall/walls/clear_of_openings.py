"""Walls that are built keep off the floor before doors and windows, and off fixed objects."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.walls.partitions import SHORTEST, Host

OFF_OPENING = 0.005
"""How far a wall stays off that floor, in metres."""


def clear_hosts(hosts: tuple[Host, ...], taken: Floats, thickness: float) -> tuple[Host, ...]:
    """Hosts whose walls, ``thickness`` metres thick, meet no box ``taken`` (n, 5): each on the
    longest stretch that is free, its wall moved or shortened to stand there; without those on which
    no wall has room.

    >>> host = Host((0.0, 0.0, 9.0, 0.0, 0.0, 1.0), (0.0, 4.0), (0.0, 9.0))
    >>> window = np.array([[1.0, 0.0, 0.0, 1.0, 2.0]])
    >>> [(one.span, one.most) for one in clear_hosts((host,), window, 0.19)]
    [((2.1, 6.1), (2.1, 9.0))]
    """
    closed = shapely.union_all(shapely.polygons(corners(taken)))
    closed = closed.buffer(0.5 * thickness + OFF_OPENING, join_style="mitre")
    found = (_clear_host(host, closed) for host in hosts)
    return tuple(host for host in found if host is not None)


def _clear_host(host: Host, closed: shapely.Geometry) -> Host | None:
    """A host on which a wall keeps off some floor; itself where it does, None where none can."""
    start, end = np.array(host.row[:2]), np.array(host.row[2:4])
    way = (end - start) / np.hypot(*(end - start))
    line = shapely.LineString([start + at * way for at in host.most])
    if not line.intersects(closed):
        return host
    parts = shapely.get_parts(line.difference(closed))
    longest = max(parts.tolist(), key=lambda part: part.length)
    if longest.length < SHORTEST:
        return None
    low, high = sorted(float(np.dot(np.array(p) - start, way)) for p in longest.coords)
    length = min(host.span[1] - host.span[0], high - low)
    begin = min(max(host.span[0], low), high - length)
    return host._replace(span=(begin, begin + length), most=(low, high))
