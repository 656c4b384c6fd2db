"""The scene graph of a hall: zones and how they connect, groups in them, objects in patterns.

SG = (V, E) of Cao, Cheng, Zhang 2024: V the functional zones (corner points, walls, groups), E
which zones must be mutually reachable; a group S = (T, B) is a pattern T with its parameters and
its objects B, each with its place in the pattern (the index in ``objects``).
"""

from __future__ import annotations

from typing import NamedTuple

from scenewright.core.space import Points


class Zone(NamedTuple):
    """A functional zone: ``outline`` (k, 2) counter-clockwise, ``holes`` clockwise."""

    id: str
    name: str
    space: str
    outline: Points
    holes: tuple[Points, ...] = ()


class ZoneLink(NamedTuple):
    """Two zones of a space that must be mutually reachable through a passage ``width`` wide."""

    space: str
    first: str
    second: str
    width: float


class Layer(NamedTuple):
    """One layer of a pattern: how many objects, and its two measures in metres.

    Rows (chain, grid): ``along`` the gap between neighbours, ``across`` the gap to the row
    before. Rings (radiation, circulation, fan): ``across`` the radius to the middle of the
    objects, ``along`` unused.
    """

    number: int
    along: float
    across: float


class PatternPart(NamedTuple):
    """One pattern with its parameters; ``sector`` is the angle of a fan in radians, else 0, and
    ``aisle`` the width of the aisles through the rows of a chain in metres, 0 without."""

    pattern: str
    layers: tuple[Layer, ...]
    sector: float = 0.0
    aisle: float = 0.0


class PlacedGroup(NamedTuple):
    """A group as laid out: the id of its demand, where, by which ``pattern`` (a row of
    :data:`scenewright.domains.hall.patterns.PATTERNS`; ``single`` for independent objects).

    ``pose`` is centre x, y and heading of the pattern. ``parts`` has one row, more for a mixture.
    ``objects`` are the ids of the pieces in pattern order.
    """

    id: str
    demand: str
    space: str
    zone: str
    pattern: str
    pose: tuple[float, float, float]
    parts: tuple[PatternPart, ...]
    objects: tuple[str, ...]


class HallLayout(NamedTuple):
    """All of it; ``partitions`` are the ids of the pieces that are generated walls."""

    zones: tuple[Zone, ...]
    links: tuple[ZoneLink, ...]
    groups: tuple[PlacedGroup, ...]
    partitions: tuple[str, ...] = ()


class Stop(NamedTuple):
    """A group the visitor passes: its id and the index of the tour's point nearest to it."""

    group: str
    at: int


class Tour(NamedTuple):
    """The visitor's route through a space: ``points`` (k, 2) from an entrance past every group
    to an exit, and the clear width (k,) at each point, in metres."""

    space: str
    points: Points
    widths: Points
    stops: tuple[Stop, ...]


class HallDetail(NamedTuple):
    """What only a solution of halls holds: the layout of zones and groups, the visitors' tours, one
    a space, the ``floors``: each space and the least its energy could be, and the ``shifts``: a
    space, the zones on both sides of a line of borders and the metres it was moved to its left."""

    layout: HallLayout
    tours: tuple[Tour, ...] = ()
    floors: tuple[tuple[str, float], ...] = ()
    shifts: tuple[tuple[str, str, float], ...] = ()
