"""What kernels for halls read (:class:`PreparedHall`) and what they change (:class:`State`)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.whole_terms import TermData
from scenewright.geometry.buckets import Buckets

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bytes = NDArray[np.uint8]

_NONE: Floats = np.zeros(0)

STATE_STEP = 0.05
"""Length of a border's cells in metres."""
LINE = 0.01
"""Cell size, in metres: objects whose centres share a cell stand in one line."""


class PreparedHall(NamedTuple):
    """A problem ready for compiled code; see :class:`scenewright.domains.hall.problem.HallProblem`.

    ``obstacles``, ``keep_free`` as frames (k, 8). ``standing`` (k, 8) locked objects that must stay
    within reach at one of their sides of use, ``standing_access`` (k, 4). ``least`` (z,) share of
    each zone that should be in use, ``middles`` (z, 2) centroids. ``border_cells`` (b, 2) start and
    number of the
    cells of each border, ``blocked`` (cells,) 1 where walls or obstacles block one.
    ``stretches`` (s, 7): x0, y0, unit direction, length, zone and what to leave free at its start
    in corners (1 or 0); the last 2 p rows are the two sides of the p hosts, without length.
    ``loops`` lists the stretches of zone z at rows ``loop_spans[z]``. ``unit_of`` (n,);
    ``beta`` (g,) clearance demanded, which covered clearance is divided by, ``constant`` (g,)
    floor a unit uses wherever it stands (as printed; negative: its extent), ``iota`` (n,) greatest
    clear depth, ``largest`` (g, 2) width and depth of the largest object, ``gaps`` (g, 2) along and
    across that keep
    clearances apart, ``near`` (g,) least radius of a fan, ``targets`` (g,) units looked at;
    ``layer_spans`` (g, 2). ``axes`` (2, 3) directions along and across the hall, and where its
    lines begin. ``host_spans`` (p, 2) the longest partition a host may carry, ``host_shifts``
    (p, 2) how far off it may stand, ``wall_needs``
    (z,) metres of wall the objects of a zone need, ``uneven`` the mean over zones of
    abs(U_a of the zone - U_a), which no move changes. ``strolled`` (n,) 1 for objects used from
    several sides, between which ``passage`` metres are wished for. ``entrances``, ``exits``,
    ``ways_out`` (k, 2) points before doors, ``inward`` (1, 2) the way in at the main entrance,
    ``hiding`` (h, 8) frames of what hides and does not move, ``tall`` (n,) 1 for objects that hide,
    ``roles`` (g,) bits of :mod:`.visitors`, ``main`` the unit that is the main exhibit (-1: none);
    ``wall_bound`` (g,) 1 for units that can stand at walls only; ``own`` the numbers of the terms
    with data of their own.
    """

    edges: Floats
    standing: Floats
    standing_access: Floats
    obstacles: Floats
    keep_free: Floats
    zone_edges: Floats
    zone_spans: Ints
    zone_areas: Floats
    zone_bounds: Floats
    least: Floats
    middles: Floats
    borders: Floats
    border_cells: Ints
    blocked: Bytes
    links: Floats
    hosts: Floats
    stretches: Floats
    loops: Ints
    loop_spans: Ints
    sizes: Floats
    clear: Floats
    access: Floats
    strolled: Ints
    unit_of: Ints
    spans: Ints
    zones: Ints
    choices: Ints
    beta: Floats
    constant: Floats
    iota: Floats
    largest: Floats
    gaps: Floats
    near: Floats
    targets: Ints
    layer_spans: Ints
    axes: Floats
    host_spans: Floats
    host_shifts: Floats
    wall_needs: Floats
    uneven: float
    thickness: float
    passage: float
    weights: Floats
    entrances: Floats
    exits: Floats
    ways_out: Floats
    inward: Floats
    hiding: Floats
    tall: Floats
    roles: Ints
    main: int
    wall_bound: Ints
    own: TermData


class State(NamedTuple):
    """One layout and every part of its energy, changed in place.

    ``code`` (g,) pattern of each unit, ``pose`` (g, 4) x, y, heading and extra measure (wall
    rows: where along the walls of the zone they start, alignment, -, gap); ``layers`` (L, 5),
    ``used`` (g,).
    ``frames``, ``clears`` (n, 8) footprints and clearances, ``partitions`` (p, 2) start and end
    of the wall on each host (none if equal), ``offsets`` (p,) metres it stands off to the left,
    ``walls`` (p, 8) its frame, ``stretches`` as in
    Prepared with those of partitions filled in. ``covered`` (g, 3) α_S, α_M, α_W; ``extent``
    (g, 3) used area and middle; ``costs`` (terms, max(g, z, l)) by term; ``lines`` (2, c)
    objects in each cell along the axes, ``shade`` (g + 1,) the lines of sight to the main exhibit
    that each unit hides, as bits, and what does not move.
    """

    code: Ints
    pose: Floats
    layers: Floats
    used: Ints
    frames: Floats
    clears: Floats
    partitions: Floats
    offsets: Floats
    walls: Floats
    stretches: Floats
    covered: Floats
    extent: Floats
    costs: Floats
    lines: Ints
    shade: Ints
    buckets: Buckets


class Kept(NamedTuple):
    """What makes a layout: patterns of the units, nothing derived. ``pose`` (g, 4), ``layers``
    (L, 5), ``rows`` (g, 2) code and number of layers, ``walls`` (p, 2), ``offsets`` (p,)."""

    pose: Floats
    layers: Floats
    rows: Floats
    walls: Floats
    offsets: Floats = _NONE


class Scratch(NamedTuple):
    """Room to try a move: local places (n, 3), old frames and clears (n, 8), old layers (L, 5)
    and pose (4,), ``delta`` (g,) change of α_M, ``touched`` (g + 1,) with its count last, marks
    (g,), ``cells`` of the longest border, ``shade`` (g + 1,) old masks, ``fresh``
    (4, g or l) costs as they would be, ``old`` (16,) other old values."""

    local: Floats
    frames: Floats
    clears: Floats
    layers: Floats
    pose: Floats
    delta: Floats
    touched: Ints
    marks: Ints
    cells: Bytes
    shade: Ints
    fresh: Floats
    old: Floats


def make_scratch(p: PreparedHall) -> Scratch:
    """Scratch for one chain."""
    n, g = len(p.sizes), len(p.spans)
    rows = int(p.layer_spans[-1, 1]) if g else 0
    longest = int(p.border_cells[:, 1].max(initial=1))
    many = max(g, len(p.zone_areas), len(p.links), 1)
    return Scratch(
        np.zeros((n, 3)),
        np.zeros((n, 8)),
        np.zeros((n, 8)),
        np.zeros((rows, 5)),
        np.zeros(4),
        np.zeros(g),
        np.zeros(g + 1, np.int64),
        np.zeros(g, np.int64),
        np.zeros(longest + 2, np.uint8),
        np.zeros(g + 1, np.int64),
        np.zeros((4, many)),
        np.zeros(16),
    )
