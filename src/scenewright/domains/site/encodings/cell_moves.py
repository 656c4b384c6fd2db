"""Genetic operators on matrix codes: random layouts, tournament, two-point crossover, mutation.

Crossover 0.75 and mutation 0.04 are probabilities of a chromosome (Zhang, Yang 2023, IV-A). All
children are repaired, so every chromosome is a layout.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.site.encodings.cells import (
    KIND,
    PART,
    Ints,
    SiteLattice,
    clear_building,
    is_free,
    repair,
    set_building,
    strew,
)

Floats = NDArray[np.float64]
TRIES = 40
TURNS = 0.5
"""Share of mutations of a building that only turn it."""


def random_genes(
    cells: SiteLattice, rng: np.random.Generator, quality: Floats | None = None, led: float = 0.0
) -> Ints:
    """One layout: buildings in random order, each at the first of some random places that is free.

    ``led`` from 0 to 1 draws the order towards that of ``quality`` (n,), best first, and the
    fronts towards the preferred heading.
    """
    genes = np.zeros((cells.fits.shape[2], 3), np.int64)
    of = np.repeat(np.arange(len(cells.counts())), cells.counts())
    rank = rng.random(len(of))
    if quality is not None:
        rank = (1.0 - led) * rank - led * quality[cells.members]
    kinds = of[np.argsort(rank, kind="stable")]
    turns = rng.integers(0, 4, (len(kinds), TRIES))
    turns[rng.random(turns.shape) < led] = 0
    anchors = np.zeros((len(kinds), TRIES), np.int64)
    for kind in np.unique(kinds):
        open_cells = np.flatnonzero(cells.fits[kind].any(0))
        rows = np.flatnonzero(kinds == kind)
        if len(open_cells):
            anchors[rows] = rng.choice(open_cells, (len(rows), TRIES))
    strew(cells, genes, kinds, turns, anchors)
    return genes


def tournament(costs: Floats, count: int, rng: np.random.Generator, rivals: int = 2) -> Ints:
    """Indices (count,) of parents: the best of ``rivals`` drawn for each."""
    drawn = rng.integers(0, len(costs), (count, rivals))
    found: Ints = drawn[np.arange(count), costs[drawn].argmin(1)]
    return found


def roulette(costs: Floats, count: int, rng: np.random.Generator) -> Ints:
    """Indices (count,) drawn in proportion to how much less than the worst each costs."""
    rated = np.isfinite(costs)
    most = costs[rated].max() if rated.any() else 0.0
    wheel = np.cumsum(np.where(rated, most - costs, 0.0) + 1e-12)
    return wheel.searchsorted(rng.random(count) * wheel[-1], side="right")


def cross(a: Ints, b: Ints, rng: np.random.Generator, points: int = 2) -> tuple[Ints, Ints]:
    """Exchange the genes between two points of the strings, or behind one; not yet repaired.

    >>> zeros, ones = np.zeros((6, 3), np.int64), np.ones((6, 3), np.int64)
    >>> first, second = cross(zeros, ones, np.random.default_rng(1))
    >>> bool((first + second == 1).all())
    True
    """
    cuts = np.sort(rng.integers(0, len(a) + 1, 2))
    low, high = int(cuts[0]), int(cuts[1]) if points == 2 else len(a)
    first, second = a.copy(), b.copy()
    first[low:high], second[low:high] = b[low:high], a[low:high]
    return first, second


def repair_genes(cells: SiteLattice, genes: Ints, rng: np.random.Generator) -> Ints:
    """Genes as a layout; which of too many buildings stay is drawn.

    ``genes`` (cells, 3).
    """
    whole = genes.copy()
    order = rng.permutation(len(genes)).astype(np.int64)
    repair(cells, whole, order, np.empty_like(whole), np.zeros_like(cells.counts()))
    return whole


def mutate(cells: SiteLattice, genes: Ints, rng: np.random.Generator) -> None:
    """Single-point mutation in place: one open cell is emptied and gets a building of a random
    kind, or of its own, at a random turn, if that fits; or the building on it is only turned.

    If all of the kind stand already, one of them leaves its other place: so buildings move.
    ``genes`` (cells, 3).
    """
    if not len(cells.open_cells):
        return
    cell = int(cells.open_cells[rng.integers(len(cells.open_cells))])
    before, own, old = (int(number) for number in genes[cell])
    turn, kind = int(rng.integers(4)), int(rng.integers(len(cells.firsts) - 1))
    if before > 0 and rng.random() < TURNS:
        width = int(cells.spans[before, old % 2, 0])
        cell -= (own // width) * int(cells.shape[1]) + own % width
        kind = before
    clear_building(cells, genes, cell)
    kind = kind if kind > 0 else before
    if kind == 0 or not is_free(cells, genes, kind, turn, cell):
        return
    standing = np.flatnonzero((genes[:, KIND] == kind) & (genes[:, PART] == 0))
    if len(standing) == cells.counts()[kind]:
        clear_building(cells, genes, int(rng.choice(standing)))
    set_building(cells, genes, kind, turn, cell)


def spread(fitness: Floats, threshold: float) -> float:
    """ρ = Σ |F(x_i) - F(x)| / (|D| - 1) - δ, (12), F(x) the mean; at ρ <= 0 the individuals are
    alike and the global search ends.

    ``fitness`` (n,).

    >>> spread(np.array([0.5, 0.5, 0.5]), 0.01)
    -0.01
    """
    away = np.abs(fitness - fitness.mean()).sum()
    return float(away / max(len(fitness) - 1, 1) - threshold)
