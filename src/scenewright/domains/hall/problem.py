"""The problem of a hall as plain arrays, ready for compiled code.

Where :mod:`scenewright.domains.home.problem` places boxes, this places *units*: a unit is a group
of objects laid out by one pattern inside one zone. NamedTuples of C-contiguous float64 / int64
arrays. Sides are numbered 0 front, 1 left, 2 back, 3 right.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.hall.settings import HallSettings

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
_NONE: Floats = np.zeros(0)
THICKNESS = 0.15
"""Metres of the walls that are built."""


class HallGround(NamedTuple):
    """The hall and its zones.

    ``edges`` (e, 4): directed edges x0, y0, x1, y1 of outline and holes, the inside on the left.
    ``obstacles`` (o, 5) boxes of fixed objects, ``keep_free`` (k, 5) boxes before
    doors, ``doors`` (d, 5) boxes of the ways in through the wall.
    ``zone_edges`` (f, 4) the directed edges of all zones, zone z owning rows ``zone_spans[z]``
    (start, end); ``zone_areas`` (z,) in square metres, ``zone_bounds`` (z, 4).
    ``zone_least`` (z,) the share of each zone that should be in use, δ_min.
    ``stretches`` (s, 6): wall a row may stand along: x0, y0, x1, y1 with the zone on the left, the
    zone's number, and 1 if it starts in a corner of walls; no doors in it.
    ``borders`` (b, 5): x0, y0, x1, y1 of the straight pieces of border between two linked zones,
    and the number of the link; ``links`` (l, 3): zones i, j and the least clear width.
    ``hosts`` (p, 6): borders on which a partition may be built: x0, y0, x1, y1 and the zones to
    the left and to the right. ``bounds`` (4,). ``host_spans`` (p, 2): start and end of the longest
    partition each may carry (left out: all of the border), ``host_shifts`` (p, 2) how far to its
    right and left it may stand off (left out: nowhere), ``zone_walls`` (z,) metres of wall that the
    objects of a zone need (left out: none). ``standing`` (k, 5) locked objects that must stay
    within reach, ``standing_access`` (k, 4) 1 for sides; at least one must be reached.
    """

    edges: Floats
    obstacles: Floats
    keep_free: Floats
    doors: Floats
    zone_edges: Floats
    zone_spans: Ints
    zone_areas: Floats
    zone_bounds: Floats
    zone_least: Floats
    stretches: Floats
    borders: Floats
    links: Floats
    hosts: Floats
    bounds: Floats
    host_spans: Floats = _NONE
    host_shifts: Floats = _NONE
    zone_walls: Floats = _NONE
    standing: Floats = _NONE
    standing_access: Floats = _NONE
    thickness: float = THICKNESS


class Units(NamedTuple):
    """The ``n`` objects to be placed, in ``g`` units.

    ``sizes`` (n, 2) width and depth; ``clear`` (n, 4) free depth wished for beyond each side;
    ``access`` (n, 4) 1 for sides any of which will do, 2 for those that must be reached. Unit u
    owns objects ``spans[u]`` (start, end) and stands in zone ``zones[u]``. ``walls`` (g,) 1 for a
    row along walls. ``choices`` (g, 8) 1 for each pattern (row of the pattern table) the unit may
    take. ``demands`` (g,) the number of the demand each unit serves, ``targets`` (g,) the unit each
    one looks at, -1: none.
    """

    sizes: Floats
    clear: Floats
    access: Floats
    spans: Ints
    zones: Ints
    choices: Ints
    demands: Ints
    targets: Ints


class VisitorPlan(NamedTuple):
    """What terms about visitors read. ``entrances`` (e, 2) points inside the doors people come in
    by, the main one first, ``exits`` (x, 2) those visitors leave by, ``ways_out`` (w, 2) all they
    may leave by; ``hiding`` (h, 5) boxes as high as the eyes that do not move; ``tall`` (n,) 1 for
    objects as high; ``roles`` (g,) of the units, as bits: 1 seen first, 2 a till, 4 the main
    exhibit, 8 tills in lanes, 16 ropes, 32 lecterns, 64 what keeps off columns, 128 lounge seats,
    256 low tables, 512 stages, 1024 tables to sit at; ``inward`` (1, 2) the unit direction in at
    the main entrance; ``served`` (d, 5) boxes of desks that do not move. Empty arrays: nobody
    comes."""

    entrances: Floats = _NONE
    exits: Floats = _NONE
    ways_out: Floats = _NONE
    hiding: Floats = _NONE
    tall: Floats = _NONE
    roles: Floats = _NONE
    inward: Floats = _NONE
    served: Floats = np.zeros((0, 5))


class HallProblem(NamedTuple):
    """One hall to solve. ``names`` of the units and ``zone_names``, ``weights`` by name of the
    term, ``route`` the width of the route every object must be reached by, ``passage`` what is
    wished for between objects people walk round (0: nothing), in metres; ``settings`` steer the
    solvers."""

    ground: HallGround
    units: Units
    names: tuple[str, ...]
    zone_names: tuple[str, ...]
    weights: dict[str, float]
    route: float
    settings: HallSettings = HallSettings()
    visitors: VisitorPlan = VisitorPlan()
    passage: float = 0.0
