"""Terms of halls (Cao, Cheng, Zhang 2024, eqs. 1-5), as repaired, and their table.

Each is a scalar function; the sums over units, zones, links and neighbours are written once, in
:mod:`scenewright.domains.hall.terms.measure`. A new term of the whole
hall is one file with two functions (:mod:`scenewright.engine.whole_terms`) and one row here, or one
entry point of another package; terms measured again only for what moved have lines there, too.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.rows import TermRow
from scenewright.engine.weights import vector_of
from scenewright.engine.whole_terms import add_terms
from scenewright.geometry.compiled import compiled

TAU = 0.05
EPSILON = 1.5
NEAR = 1.0
"""Z of the proportion: what neighbours may stand apart beyond their clearances, in metres."""

PASS, ABUT = 0.6, 0.02
"""Gaps people get through, and gaps of objects that stand side by side, in metres."""
EASE = 0.5
"""Cost of a metre a wished passage lacks, relative to one that nobody gets through."""
NEAR_OUT = 15.0
"""Metres to a way out that nobody minds."""

SPACE, FILL, ACCESS, PROPORTION, REACH, BALANCE, FACING, ALIGNMENT, AISLES = range(9)
EVENNESS, SIGHT, ORDER, QUEUES, EGRESS = range(9, 14)


_PAPER = "Cao, Cheng, Zhang 2024, eq. "
_ROWS = (
    TermRow(
        "space",
        SPACE,
        "group",
        3,
        "clearance covered by others, by walls or by doors",
        _PAPER + "1 with its lost divisor",
    ),
    TermRow("fill", FILL, "zone", 1, "zone less used than it should be", _PAPER + "3"),
    TermRow("access", ACCESS, "link", 40, "passage between linked zones too narrow", _PAPER + "4"),
    TermRow(
        "proportion",
        PROPORTION,
        "group",
        3,
        "neighbours further apart than they need",
        _PAPER + "5",
    ),
    TermRow("reach", REACH, "hall", 30, "objects and doors that the route does not reach", "ours"),
    TermRow("balance", BALANCE, "zone", 4, "groups crowded at one side of their zone", "ours"),
    TermRow(
        "facing",
        FACING,
        "group",
        10,
        "groups turned away from what they look at, desks from who comes in",
        "ours",
    ),
    TermRow(
        "alignment",
        ALIGNMENT,
        "hall",
        0.3,
        "lines through the middles of objects, along and across the hall",
        "Ngo, Teo, Byrne 2003, as Cao, Cheng, Zhang 2024, eq. 7",
    ),
    TermRow(
        "aisles",
        AISLES,
        "group",
        4,
        "metres that gaps of neighbours lack for a person, half of those that objects people "
        "walk round lack for a passage, unless side by side",
        "Cao, Cheng, Zhang 2024, eq. 9",
    ),
    TermRow(
        "evenness",
        EVENNESS,
        "hall",
        100,
        "floor and walls of some zones fuller than those of others",
        "Cao, Cheng, Zhang 2024, eq. 8",
    ),
    TermRow(
        "sight",
        SIGHT,
        "hall",
        8,
        "main exhibit hidden from who stands in the entrance, or off its axis",
        "ours",
    ),
    TermRow(
        "order",
        ORDER,
        "hall",
        1.5,
        "metres that others lie nearer to the entrance than the information desk, or to the way "
        "out than the tills",
        "ours",
    ),
    TermRow(
        "queues",
        QUEUES,
        "group",
        6,
        "floor before tills not free to queue on, lanes not leading to the way out",
        "ours",
    ),
    TermRow("egress", EGRESS, "group", 10, "objects more than 15 m from every way out", "ours"),
)
HALL_TERMS: tuple[TermRow, ...] = add_terms("hall", _ROWS)
"""All terms of halls, those of other packages last."""
MEANINGS: dict[str, str] = {row.name: row.doc for row in HALL_TERMS}
"""The meaning of each term, in one line."""
PRINTED = ("space", "fill", "access", "proportion")


def read_hall_weights(weights: Mapping[str, float]) -> NDArray[np.float64]:
    """Weights by name to the vector ``(terms,)``; a name left out weighs nothing.

    >>> read_hall_weights({"fill": 2.0}).tolist()
    [0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    """
    places = {row.name: row.number for row in HALL_TERMS}
    return vector_of(weights, places, np.zeros(len(HALL_TERMS)), "term of halls")


@compiled
def barrier(x: float) -> float:
    """φ(x) = 1 / (x + √(x² + τ²)), τ = 0.05: 1/(2x) for large x, 20 at 0, steep below.

    >>> round(barrier(0.0), 6), round(barrier(1.0), 3)
    (20.0, 0.5)
    """
    root = math.sqrt(x * x + TAU * TAU)
    return 1.0 / (x + root) if x > 0.0 else (root - x) / (TAU * TAU)


@compiled
def space_cost(covered: float, demanded: float) -> float:
    """E_s of one group, φ(ε - 2ε σ(α / β)): α covered and β demanded clearance, square metres.

    The division by β is lost in print; β is defined right after. 20 for nothing covered.

    >>> round(space_cost(0.0, 1.0), 6)
    20.0
    """
    share = covered / max(demanded, 1e-9)
    return barrier(EPSILON - 2.0 * EPSILON / (1.0 + math.exp(-min(share, 50.0))))


@compiled
def fill_cost(least: float, used: float) -> float:
    """E_u of one zone, φ(1 - δ_min / δ): least and actual share of its floor in use.

    The paper's δ sums footprints and clearances, which no expansion changes, although expanding
    is its remedy for a high E_u; ours sums the extents of the patterns.

    >>> round(fill_cost(0.4, 0.4), 6)
    20.0
    """
    return barrier(1.0 - least / max(used, 1e-6))


@compiled
def access_cost(least: float, width: float) -> float:
    """E_a of one link, exp(max(0, d_min - d)) - 1, widths in metres.

    >>> access_cost(1.2, 1.5)
    0.0
    """
    return math.exp(max(least - width, 0.0)) - 1.0


@compiled
def proportion_cost(gap: float, most: float) -> float:
    """E_p of two neighbours, φ(1 - max(0, μ - μ_max) / μ_max): gap and greatest gap, metres.

    >>> round(proportion_cost(2.0, 1.0), 6)
    20.0
    """
    return barrier(1.0 - max(gap - most, 0.0) / most)


@compiled
def aisle_cost(gap: float, wide: float) -> float:
    """max(0, 0.6 - gap) + max(0, wide - gap) / 2 of two neighbours, in metres; 0 for those at most
    2 cm apart, which stand side by side. ``wide`` is the passage wished for between them.

    >>> round(aisle_cost(0.5, 0.0), 6), aisle_cost(0.01, 1.2), aisle_cost(0.7, 0.0)
    (0.1, 0.0, 0.0)
    >>> round(aisle_cost(1.0, 1.2), 6)
    0.1
    """
    return max(PASS - gap, 0.0) + EASE * max(wide - gap, 0.0) if gap > ABUT else 0.0


@compiled
def egress_cost(far: float) -> float:
    """max(0, d - 15 m) / 15 m: 1 at the 30 m that building codes let people walk to a way out.

    >>> egress_cost(12.0), egress_cost(30.0)
    (0.0, 1.0)
    """
    return max(far - NEAR_OUT, 0.0) / NEAR_OUT


@compiled
def facing_cost(x: float, y: float, heading: float, to_x: float, to_y: float) -> float:
    """1 - cos of the angle between a group's front and the way to what it looks at, 0 to 2, and
    a tenth of the metres it stands off the axis of what it looks at.

    >>> facing_cost(0.0, 0.0, 0.0, 5.0, 0.0)
    0.0
    """
    dx, dy = to_x - x, to_y - y
    far = max(math.sqrt(dx * dx + dy * dy), 1e-9)
    c, s = math.cos(heading), math.sin(heading)
    return 1.0 - (dx * c + dy * s) / far + 0.1 * abs(dy * c - dx * s)
