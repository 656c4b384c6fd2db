"""Terms of sites (Zhang, Yang 2023, eqs. 1-6), as repaired, and their table.

The scalar functions say what one building costs; the sums over buildings and pairs are written
once, in :mod:`scenewright.domains.site.terms.measure`. The paper names its constraints without
formulas; what they measure here is ours.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from scenewright.core.errors import InputError
from scenewright.engine.rows import TermRow
from scenewright.engine.whole_terms import add_terms
from scenewright.geometry.boxes import wrap
from scenewright.geometry.compiled import inlined

Floats = NDArray[np.float64]

INSERT, OVERLAP, ROAD, FACING, QUALITY, LEFT = range(6)


_PAPER = "Zhang, Yang 2023, eq. "
_ROWS = (
    TermRow(
        "insert",
        INSERT,
        "building",
        60,
        "share of a building outside the blocks",
        _PAPER + "4, E_Insert",
    ),
    TermRow(
        "overlap",
        OVERLAP,
        "pair",
        60,
        "buildings nearer to each other than the spacing",
        _PAPER + "4, E_Overlap, by 3 with 'or' over the axes",
    ),
    TermRow(
        "road",
        ROAD,
        "building",
        4,
        "way round a building narrower than it must be",
        _PAPER + "5, E_Road",
    ),
    TermRow(
        "facing",
        FACING,
        "building",
        1,
        "front turned away from the preferred heading",
        _PAPER + "5, E_θ",
    ),
    TermRow(
        "quality",
        QUALITY,
        "building",
        1,
        "visual quality of the buildings; higher is better",
        _PAPER + "5, E_S",
    ),
    TermRow("left", LEFT, "building", 10, "buildings left out", "ours"),
)
SITE_TERMS: tuple[TermRow, ...] = add_terms("site", _ROWS)
"""All terms of sites, those of other packages last."""
SITE_AIMS: tuple[TermRow, ...] = (
    TermRow(
        "seen",
        0,
        "site",
        3,
        "visual quality that walkers on the ways see, 0.4 in a rich street; higher is better",
        "ours",
    ),
    TermRow(
        "sun",
        1,
        "site",
        3,
        "hours of sun on fronts on the day of the brief; higher is better",
        "ours",
    ),
    TermRow(
        "even",
        2,
        "site",
        0.5,
        "how far the centre of a block's buildings is off the block's",
        "ours",
    ),
)
"""What the default solver chooses by among layouts that hold as much; a weight of 0 switches an
aim off."""
MUCH = 0.4
"""Visual quality V that eyes in a rich street see."""
SITE_FIGURES: dict[str, str] = {
    "value": "F_eva, the paper's evaluation of a site (Zhang, Yang 2023, eq. 22); higher is better",
    "use": "use of the ground, part of F_eva",
    "shown": "visual quality of all facades that stand, part of F_eva",
    "texture": "tone and symmetry of facades, part of F_eva",
    "height": "volume that stands of all asked for, part of F_eva",
    "ratio": "the paper's energy, position costs over visual quality (eq. 5); lower is better",
    "generations": "generations until the layouts were alike (eq. 12), or all there were",
}
"""Figures of a site that are shown beside its terms."""
PRINTED = ("insert", "overlap", "road", "facing", "quality")


def read_site_weights(weights: Mapping[str, float]) -> Floats:
    """Weights by name to the vector ``(terms,)``; a name left out keeps its default.

    >>> read_site_weights({"road": 0.0}).tolist()
    [60.0, 60.0, 0.0, 1.0, 1.0, 10.0]
    """
    places = {row.name: row.number for row in SITE_TERMS}
    vector = np.array([float(row.weight) for row in SITE_TERMS])
    aims = {row.name for row in SITE_AIMS}
    for name, weight in weights.items():
        if name in aims:
            continue
        if name not in places:
            raise InputError(
                f"no term of sites is called {name!r}",
                f"the terms are {', '.join([*places, *aims])}",
            )
        vector[places[name]] = weight
    return vector


def read_site_aims(weights: Mapping[str, float]) -> Floats:
    """Weights by name to those of the aims ``(3,)``; a name left out keeps its default.

    >>> read_site_aims({"sun": 0.0}).tolist()
    [3.0, 0.0, 0.5]
    """
    return np.array([float(weights.get(row.name, row.weight)) for row in SITE_AIMS])


@inlined
def facing_cost(heading: float, preferred: float) -> float:
    """E_θ of one building: the angle between its front and the preferred heading over π, so 0,
    1/2, 1/2 and 1 for the four headings."""
    return abs(wrap(heading - preferred)) / math.pi


@inlined
def share_of(area: float, whole: float) -> float:
    """An area as a share of another, the paper's "normalised to [0, 1]"."""
    return area / max(whole, 1e-9)


def utilisation(sizes: Floats, margins: tuple[float, float], box: tuple[float, ...]) -> float:
    """Fit = Σ (l + Δl)(w + Δw) h / (L W H), (1): ``sizes`` (n, 3), ``margins`` Δl and Δw, ``box``
    L, W and H, in metres.

    >>> utilisation(np.array([[8.0, 8.0, 5.0]]), (2.0, 2.0), (20.0, 10.0, 10.0))
    0.25
    """
    grown = sizes[:, :2] + np.asarray(margins)
    return float((grown.prod(1) * sizes[:, 2]).sum() / np.prod(box))


def within_box(
    centres: Floats, sizes: Floats, margins: tuple[float, float], box: tuple[float, ...]
) -> NDArray[np.bool_]:
    """Which buildings (n,) keep their margins inside the bounding box, (2): ``centres`` (n, 3) of
    their bodies from a lower corner of the box. Heights have no margin."""
    half = 0.5 * (sizes + np.array([*margins, 0.0]))
    inside: NDArray[np.bool_] = ((centres >= half) & (centres <= np.asarray(box) - half)).all(1)
    return inside


def kept_apart(
    centres: Floats, sizes: Floats, margins: tuple[float, float, float]
) -> NDArray[np.bool_]:
    """Which pairs (n, n) lie apart, (3): it is enough that one axis parts them.

    As printed every axis must part them, so that no two buildings could stand on the ground.

    >>> centres, sizes = np.array([[0, 0, 2], [9, 0, 2.0]]), np.full((2, 3), 4.0)
    >>> bool(kept_apart(centres, sizes, (5, 5, 0))[0, 1])
    True
    """
    grown = sizes + np.asarray(margins)
    gaps = np.abs(centres[:, None] - centres[None]) - 0.5 * (grown[:, None] + grown[None])
    apart: NDArray[np.bool_] = (gaps >= 0.0).any(-1)
    return apart


def printed_ratio(terms: Floats, weights: Floats) -> Floats:
    """E_eval of (5) for terms (..., 6): weighted position costs over weighted visual quality.

    It explodes where the quality of the buildings is small and is infinite where there are none;
    for a given set of buildings, all placed, the divisor is constant and says nothing.
    """
    places = [INSERT, OVERLAP, ROAD, FACING]
    cost = terms[..., places] @ weights[places]
    quality = weights[QUALITY] * terms[..., QUALITY]
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio: Floats = np.where(quality > 0.0, cost / quality, np.inf)
    return ratio


def fitness_of_cost(ratio: Floats, greatest: float) -> Floats:
    """f_cost of (6) of ratios (n,): E_max - E_eval, but not below 0; higher is better, whatever its
    name.

    >>> fitness_of_cost(np.array([0.5, 3.0]), 2.0).tolist()
    [1.5, 0.0]
    """
    return np.maximum(greatest - ratio, 0.0)


def repaired_sum(terms: Floats, weights: Floats, count: int) -> Floats:
    """Our energy for terms (..., 6) of ``count`` buildings asked for: position costs + what the
    visual quality lacks to 1 each + buildings left out. Lower is better, least 0.

    A sum instead of (5)'s ratio: bounded, and each term can be weighed and explained separately.
    """
    signed = weights.copy()
    signed[QUALITY] = -weights[QUALITY]
    energy: Floats = terms @ signed + weights[QUALITY] * count
    return energy


TERM_ROWS = (*SITE_TERMS, *SITE_AIMS)
MEANINGS: dict[str, str] = {row.name: row.doc for row in TERM_ROWS} | SITE_FIGURES
"""The meaning of each term, aim and figure, in one line."""
