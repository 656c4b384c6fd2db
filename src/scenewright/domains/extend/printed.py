"""The paper's growth as it is printed: layouts as matrices of buildings on a grid of plots.

Zhang and Fei (2017), sections 4 and 5. A layout is an m × n matrix of genes: which building of the
sources stands on a plot, 0 for none. Its fitness (22) is F = ω1 H + ω2 S + ω3 G + ω4 L, Σω = 1. The
paper gives H, S, G and L no formulas; ours are

* H, space utilisation: 1 − |built − wanted| / wanted of the ground covered, at least 0;
* S, symmetry: the best share of plots that equal their mirror image, left-right or front-back;
* G, golden-ratio degree: 1 − |r − φ| / φ, r long by short side of the box of what is built;
* L, path optimality: the shortest tree over built plots against the length of a row of as many.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Genes = NDArray[np.int64]
GOLDEN = (1 + 5**0.5) / 2
AIMS = ("H", "S", "G", "L")


class PlotGrid(NamedTuple):
    """Plots: middles (m, n, 2) in metres, whether each may be built on (m, n), the floor areas of
    the kinds (k,), where gene g > 0 is kind g − 1, and the square metres to build."""

    middles: Floats
    free: NDArray[np.bool_]
    areas: Floats
    wanted: float


def aims_of(grid: PlotGrid, genes: Genes) -> Floats:
    """H, S, G and L (4,) of a matrix (m, n), each in [0, 1].

    >>> x, y = np.meshgrid(np.arange(4.0) * 20, np.arange(2.0) * 20)
    >>> grid = PlotGrid(np.stack([x, y], -1), np.ones((2, 4), bool), np.array([100.0]), 800.0)
    >>> aims_of(grid, np.ones((2, 4), int)).round(3).tolist()
    [1.0, 1.0, 0.764, 1.0]
    """
    built = (genes > 0) & grid.free
    if not built.any():
        return np.zeros(4)
    area = float(grid.areas[genes[built] - 1].sum())
    use = max(1.0 - abs(area - grid.wanted) / max(grid.wanted, 1e-9), 0.0)
    shown = np.where(built, genes, 0)
    mirror = max(float((shown == shown[:, ::-1]).mean()), float((shown == shown[::-1]).mean()))
    points = grid.middles[built]
    sides = np.sort(np.ptp(points, axis=0) + 1e-9)
    pitch = _pitch(grid)
    ratio = (sides[1] + pitch) / (sides[0] + pitch)
    golden = max(1.0 - abs(ratio - GOLDEN) / GOLDEN, 0.0)
    path = (len(points) - 1) * pitch / max(tree_length(points), 1e-9) if len(points) > 1 else 1.0
    return np.array([use, mirror, golden, min(path, 1.0)])


def _pitch(grid: PlotGrid) -> float:
    """The least distance between neighbouring plots."""
    rows = [np.hypot(*np.diff(grid.middles, axis=k).reshape(-1, 2).T) for k in (0, 1)]
    known = [row.min() for row in rows if len(row)]
    return float(min(known)) if known else 1.0


def tree_length(points: Floats) -> float:
    """The length of the shortest tree over points (n, 2) (Prim 1957).

    >>> tree_length(np.array([[0.0, 0], [3, 0], [3, 4]]))
    7.0
    """
    away = np.hypot(*(points - points[0]).T)
    left = np.ones(len(points), np.bool_)
    left[0] = False
    total = 0.0
    while left.any():
        k = int(np.argmin(np.where(left, away, np.inf)))
        total += float(away[k])
        left[k] = False
        away = np.minimum(away, np.hypot(*(points - points[k]).T))
    return total


def fitness(grid: PlotGrid, genes: Genes, weights: Floats) -> float:
    """F (22): the weighted sum of the four aims."""
    return float(aims_of(grid, genes) @ weights)


def allele_values(elites: Genes, values: Floats, kinds: int, as_printed: bool = False) -> Floats:
    """The value (m, n, kinds + 1) of each allele (23): the mean fitness of the past elites
    (e, m, n) that carry it, 0 where none does. Printed it is 0 for those who carry it: the
    indicator is the wrong way round, so that an allele is worth the elites that do *not* have
    it.

    >>> elites = np.array([[[1]], [[1]], [[2]]])
    >>> allele_values(elites, np.array([0.4, 0.6, 0.9]), 2)[0, 0].tolist()
    [0.0, 0.5, 0.9]
    """
    carried = elites[..., None] == np.arange(kinds + 1)
    carried = ~carried if as_printed else carried
    total = (carried * values[:, None, None, None]).sum(0)
    return np.asarray(total / np.maximum(carried.sum(0), 1))


def fitness_of_alleles(genes: Genes, worth: Floats, weights: Floats) -> float:
    """F(x) (21): Σ_n ω_n F(U_n) over the genes of a matrix (m, n), each worth what its allele is in
    ``worth`` (m, n, k), by the weights ω (m, n) of the genes. So a layout that nobody has rated is
    judged by those that were.

    >>> worth = np.array([[[0.0, 1.0], [0.5, 0.2]]])
    >>> fitness_of_alleles(np.array([[1, 0]]), worth, np.full((1, 2), 0.5))
    0.75
    """
    own = np.take_along_axis(worth, genes[..., None], axis=-1)[..., 0]
    return float((weights * own).sum())


def attract(points: Floats, spots: Floats, pulls: Floats, mix: Floats) -> Floats:
    """f(x) (14): Σ_σ ω_σ (κ|x − x_σ| + λ|y − y_σ| + μ|z − z_σ|) for points (n, 3), spots (s, 3),
    pulls ω (s,) that sum to 1 (below 0: it repels) and the mix κ, λ, μ (3,), which sums to 1.

    >>> attract(np.array([[3.0, 4.0, 0.0]]), np.zeros((1, 3)), np.ones(1), np.array([0.5, 0.5, 0]))
    array([3.5])
    """
    return np.asarray((np.abs(points[:, None] - spots[None]) @ mix) @ pulls)


def next_evaporation(rate: float, step: int, a: float, b: float, least: float) -> float:
    """ρ(t) (16) with c (17): ρ²(t − 1) / c down to ρ_min, c = 2a / (1 + e^(−bt)) − a.

    c grows from 0 at t = 0 to a. While c < ρ the rate grows, without bound; once c > ρ it falls to
    ρ_min. Where it could stay, at ρ = c, it is unstable: nothing between is ever held.

    >>> [round(next_evaporation(0.5, t, 0.6, 1.0, 0.1), 3) for t in (1, 4)]
    [0.902, 0.432]
    """
    c = 2 * a / (1 + np.exp(-b * step)) - a
    return float(max(rate**2 / c, least)) if c > 0 else rate
