"""What steers how a village is filled, beside presets: how houses stand to each other and to the
street, as tables that a style is made of.

The shipped table was measured on blocks of villages and hamlets of Franconia, Liechtenstein,
Lower Austria and the Riviera (© OpenStreetMap contributors, ODbL), the largest house first: so
are gaps and angles of a house to those placed before it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

Row = tuple[float, ...]


class Relations(NamedTuple):
    """Shares of houses by the value of a relation: ``edges`` (k + 1,) of the bins, ``small`` and
    ``large`` (k,) of houses below 50 m² and of the others."""

    edges: Row
    small: Row
    large: Row


_ANGLES = tuple(math.radians(v) for v in (0, 1, 2, 3, 5, 8, 12, 20, 30, 46))


class Manner(NamedTuple):
    """How houses stand: ``gap`` to the nearest house in metres, ``turn`` from it (mod 90 degrees,
    in radians), distance to the ``street`` and ``street_turn``; ``count_law`` (a, b, c, spread):
    log n = a + b log area + c (share of the outline that is street); shares of small, medium and
    large houses."""

    gap: Relations
    turn: Relations
    street: Relations
    street_turn: Relations
    count_law: tuple[float, float, float, float]
    sizes: tuple[float, float, float]


OURS = Manner(
    Relations(
        (0, 0.05, 0.5, 1, 2, 3, 4, 6, 8, 10, 13, 17, 22, 30, 50, 1e9),
        (
            0.434,
            0.024,
            0.045,
            0.089,
            0.073,
            0.056,
            0.079,
            0.067,
            0.033,
            0.039,
            0.025,
            0.017,
            0.016,
            0.002,
            0.001,
        ),
        (
            0.157,
            0.012,
            0.020,
            0.053,
            0.048,
            0.054,
            0.126,
            0.167,
            0.128,
            0.110,
            0.063,
            0.032,
            0.022,
            0.006,
            0.004,
        ),
    ),
    Relations(
        _ANGLES,
        (0.367, 0.145, 0.094, 0.093, 0.079, 0.067, 0.072, 0.038, 0.045),
        (0.285, 0.164, 0.104, 0.107, 0.094, 0.071, 0.077, 0.050, 0.049),
    ),
    Relations(
        (0, 0.5, 1, 2, 3, 4, 6, 8, 10, 13, 17, 22, 30, 50, 1e9),
        (
            0.006,
            0.020,
            0.041,
            0.041,
            0.041,
            0.093,
            0.081,
            0.090,
            0.047,
            0.065,
            0.075,
            0.111,
            0.175,
            0.114,
        ),
        (
            0.003,
            0.008,
            0.025,
            0.037,
            0.050,
            0.133,
            0.160,
            0.163,
            0.025,
            0.048,
            0.058,
            0.090,
            0.137,
            0.064,
        ),
    ),
    Relations(
        _ANGLES,
        (0.094, 0.087, 0.062, 0.101, 0.116, 0.104, 0.164, 0.136, 0.137),
        (0.150, 0.109, 0.077, 0.104, 0.109, 0.099, 0.136, 0.105, 0.111),
    ),
    (-3.99, 0.661, 1.043, 0.518),
    (0.22, 0.18, 0.60),
)


class GrowSettings(NamedTuple):
    """Filling: poses proposed for each house, legal ones looked at, the shares of those beside a
    house, along a street and anywhere; how much chance has a say (0: the best pose is taken, 1:
    poses are drawn as often as their weight says); how often a house may find no place before
    another is tried; least and greatest spread in radians of a house that stands beside another."""

    proposed: int = 320
    judged: int = 72
    shares: tuple[float, float, float] = (0.5, 0.25, 0.25)
    temperature: float = 0.8
    retries: int = 3
    askew: tuple[float, float] = (0.02, 0.14)


class VillageSettings(NamedTuple):
    """How blocks are filled; ``composed``: lanes first where ground is deep, dwellings by ways,
    fronts about the square, outbuildings behind them (else by what was learned alone)."""

    grow: GrowSettings = GrowSettings()
    composed: bool = False
