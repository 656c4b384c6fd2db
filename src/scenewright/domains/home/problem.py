"""The problem: one space and its items as plain arrays, ready for compiled code.

Everything here is a NamedTuple of C-contiguous float64 / int64 arrays, so compiled functions take
it whole. A *box* is ``(x, y, heading, width, depth)`` as in :mod:`scenewright.core.layout`.
Sides are numbered 0 front, 1 left, 2 back, 3 right (quarter turns from the heading).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.same import once
from scenewright.domains.home.settings import HomeSettings

FLUSH = 0.02
Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


class Ground(NamedTuple):
    """The space to fill.

    ``edges`` (e, 4): every directed edge x0, y0, x1, y1 of the outline (counter-clockwise) and of
    the holes (clockwise): the inside is on the left. ``walls`` (w, 4): what a back may stand
    against, same direction: the edges of the outline, then chords of its curves. ``keep_free`` (k,
    5): boxes nothing may enter (door swings and thresholds). ``use_space`` (c, 5): the floor before
    fixed pieces, better left free. ``obstacles`` (o, 5): footprints of fixed pieces. ``windows``
    (q, 6): box in front of the glass and the sill height. ``doors`` (d, 5): box of each way in,
    from the outer face of the wall to a little inside; routes start there. ``main_wall`` (m, 4) has
    one row or none. ``bounds`` (4,) is x0, y0, x1, y1 and ``area`` the free area in square metres.
    ``slopes`` (k, 6) are what lowers the ceiling, as in :mod:`scenewright.building.ceiling`.
    ``fronts`` (r, 5): boxes before radiators in which nothing is put, though one may walk there.
    ``paths`` (m, 4): directed edges of the united ways from door to door, better left free.
    ``strips`` (k, 6): the floor before windows (1 in the last column) and before doors and passages
    without a leaf that are wider than need stay free (0). ``hearths`` (h, 4): middle of the front
    and heading (cos, sin) of each fireplace that stands. ``leaves`` (f, 6): each leaf that opens
    into the space, at a right angle, and the number of its door. ``entrances`` (n, 5): those of
    ``doors`` with a leaf by which one comes in from outside. ``pipes`` (w, 5): walls to rooms with
    water, as boxes in them that look into the space.
    """

    edges: Floats
    walls: Floats
    keep_free: Floats
    use_space: Floats
    obstacles: Floats
    windows: Floats
    doors: Floats
    main_wall: Floats
    bounds: Floats
    area: float
    slopes: Floats = np.zeros((0, 6))
    fronts: Floats = np.zeros((0, 5))
    paths: Floats = np.zeros((0, 4))
    strips: Floats = np.zeros((0, 6))
    hearths: Floats = np.zeros((0, 4))
    leaves: Floats = np.zeros((0, 6))
    entrances: Floats = np.zeros((0, 5))
    pipes: Floats = np.zeros((0, 5))


class KnownGround:
    """A ground that is recognized by what it holds: what is made of it once is found again."""

    __slots__ = ("ground", "key")

    def __init__(self, ground: Ground) -> None:
        """``ground`` with all its numbers as the key."""
        self.ground = ground
        self.key = tuple(np.asarray(field, np.float64).tobytes() for field in ground)

    def __hash__(self) -> int:
        """Of the numbers."""
        return hash(self.key)

    def __eq__(self, other: object) -> bool:
        """Whether all numbers are the same."""
        return isinstance(other, KnownGround) and self.key == other.key


@once(256)
def known_ground(ground: Ground) -> KnownGround:
    """The ground with what it is recognized by; of the same value this is made once."""
    return KnownGround(ground)


class Items(NamedTuple):
    """What is to be placed, ``n`` items.

    ``low``, ``high``, ``wish`` (n, 2): least, greatest and preferred width and depth. ``height``
    (n,). ``back_to_wall`` (n,): 1 if the back edge belongs to a wall, 0 if free. ``main_wall``
    (n,): +1 faces the main wall, -1 backs it, 0 free. ``clear`` (n, 4): free depth wished for
    beyond each side (front, left, back, right), outside the box. ``access`` (n, 4): 1 for
    sides, at least one of which the route must reach. ``inset`` (n, 4): depth inside the box
    at each side that can be walked on (the aisle beside a bed, the place of a chair): the route
    term takes the box less its insets as the solid part, and access boxes start at that solid
    part; all other terms take the whole box. ``daylight`` (n,): how much it wants a window near,
    ``nestle`` (n,): how much it wants a side against something (a corner), ``shades`` (n,): how
    much it takes from the light of a window it stands before, ``symmetry`` (n,): how much its axis
    belongs to the middle of the floor beside it.
    ``pairs`` (p, 2): indices i, j of related items; ``pair_targets`` (p, 3): distance between
    centres in metres (below zero: at least as much), angle between headings, and bearing of j from
    the front of i (NaN: any); ``pair_weights`` (p,).
    ``placed`` (s,): indices of items that want a place; ``places`` (s, 6): the first of the
    ``spots`` it may be at and the one after the last (one at least), least and greatest distance
    in metres (inf: any), +1 to look at it, -1 to turn the back to it, 0 any heading, and weight.
    ``spots`` (k, 4) are segments x0, y0, x1, y1 of the room.
    """

    low: Floats
    high: Floats
    wish: Floats
    height: Floats
    back_to_wall: Floats
    main_wall: Floats
    clear: Floats
    access: Floats
    inset: Floats
    daylight: Floats
    nestle: Floats
    shades: Floats
    symmetry: Floats
    pairs: Ints
    pair_targets: Floats
    pair_weights: Floats
    placed: Ints
    places: Floats
    spots: Floats


class Problem(NamedTuple):
    """One space to solve: ground, items, names of the items, the weight of each term by name and
    whether terms take the ``printed`` or the ``repaired`` form; ``route_width`` in metres;
    ``settings`` steer the solvers; a back at most ``flush`` metres off its wall is at it (of the
    repaired form)."""

    ground: Ground
    items: Items
    names: tuple[str, ...]
    weights: dict[str, float]
    printed: bool = False
    route_width: float = 0.6
    settings: HomeSettings = HomeSettings()
    flush: float = FLUSH


def empty_items(n: int) -> Items:
    """Items that ask for nothing: 1 by 1 metre, free to stand anywhere; fill in with _replace."""
    ones, none = np.ones((n, 2)), np.zeros(n)
    return Items(
        low=ones.copy(),
        high=ones.copy(),
        wish=np.full((n, 2), np.nan),
        height=np.ones(n),
        back_to_wall=none.copy(),
        main_wall=none.copy(),
        clear=np.zeros((n, 4)),
        access=np.zeros((n, 4)),
        inset=np.zeros((n, 4)),
        daylight=none.copy(),
        nestle=none.copy(),
        shades=none.copy(),
        symmetry=none.copy(),
        pairs=np.zeros((0, 2), np.int64),
        pair_targets=np.zeros((0, 3)),
        pair_weights=np.zeros(0),
        placed=np.zeros(0, np.int64),
        places=np.zeros((0, 6)),
        spots=np.zeros((0, 4)),
    )
