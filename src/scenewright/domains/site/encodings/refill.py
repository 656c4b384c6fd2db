"""Repaired operators of matrix codes: what crossover and mutation take away is set again.

As printed (Zhang, Yang 2023, IV-A), exchanged genes cut buildings in two and leave others out, and
half of all single-point mutations hit ground where they change nothing. Here missing buildings are
set where there is room, and a mutation is drawn again until it changes something.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.domains.site.encodings.cell_moves import TRIES, mutate
from scenewright.domains.site.encodings.cells import (
    KIND,
    PART,
    Floats,
    Ints,
    SiteLattice,
    clear_building,
    is_free,
    set_building,
    strew,
)
from scenewright.geometry.compiled import compiled

AGAIN = 12
"""How often a mutation that changes nothing is drawn again."""


class Amount(NamedTuple):
    """How much is to stand: ground covered and floor area in square metres (0: all buildings),
    and the storeys of each kind (kinds + 1,)."""

    covered: float
    floors: float
    storeys: Ints


def count_kinds(cells: SiteLattice, genes: Ints) -> Ints:
    """How many buildings of each kind (kinds + 1,) stand; none of the empty one."""
    anchors = (genes[:, KIND] > 0) & (genes[:, PART] == 0)
    return np.bincount(genes[anchors, KIND], minlength=len(cells.counts())).astype(np.int64)


def refill(cells: SiteLattice, genes: Ints, amount: Amount, rng: np.random.Generator) -> None:
    """Set the buildings that are missing, in place, as far as there is room: those asked for, or
    as many as the amount says; where more stand, some are taken away. ``genes`` (cells, 3)."""
    if amount.covered > 0.0:
        trim(cells, genes, amount, rng)
    missing = _list_missing(cells, genes, amount, rng)
    if not len(missing):
        return
    before = count_kinds(cells, genes)
    turns = rng.integers(0, 4, (len(missing), TRIES))
    anchors = np.zeros((len(missing), TRIES), np.int64)
    for kind in np.unique(missing):
        places = np.flatnonzero(cells.fits[kind].any(0))
        rows = np.flatnonzero(missing == kind)
        if len(places):
            anchors[rows] = rng.choice(places, (len(rows), TRIES))
    strew(cells, genes, missing, turns, anchors)
    left = np.bincount(missing, minlength=len(before)) - (count_kinds(cells, genes) - before)
    for kind in np.flatnonzero(left > 0):
        places = rng.permutation(np.flatnonzero(cells.fits[kind].any(0))).astype(np.int64)
        set_anywhere(cells, genes, int(kind), int(left[kind]), places, int(rng.integers(4)))


def _list_missing(
    cells: SiteLattice, genes: Ints, amount: Amount, rng: np.random.Generator
) -> Ints:
    """Kinds of the buildings that are missing, the largest first; where an amount is to stand, as
    many in random order as bring it."""
    lacking = cells.counts() - count_kinds(cells, genes)
    missing = np.repeat(np.arange(len(lacking)), np.maximum(lacking, 0))
    area = cells.sizes.prod(1)
    if amount.covered <= 0.0:
        order = np.argsort(-(area[missing] + 1e-3 * rng.random(len(missing))), kind="stable")
        return missing[order]
    covered, floors = measure_amount(cells, genes, amount)
    chosen = []
    for kind in rng.permutation(missing).tolist():
        ground, floor = area[kind], area[kind] * amount.storeys[kind]
        if covered + ground / 2 <= amount.covered and floors + floor / 2 <= amount.floors:
            chosen.append(kind)
            covered, floors = covered + ground, floors + floor
    return np.array(chosen, np.int64)


def measure_amount(cells: SiteLattice, genes: Ints, amount: Amount) -> tuple[float, float]:
    """Ground covered and floor area of the buildings, square metres."""
    area = cells.sizes.prod(1) * count_kinds(cells, genes)
    return float(area.sum()), float((area * amount.storeys).sum())


def trim(cells: SiteLattice, genes: Ints, amount: Amount, rng: np.random.Generator) -> None:
    """Take buildings away, in place and in random order, while more than the amount stands."""
    anchors = np.flatnonzero((genes[:, KIND] > 0) & (genes[:, PART] == 0))
    area = cells.sizes.prod(1)
    covered, floors = measure_amount(cells, genes, amount)
    for anchor in rng.permutation(anchors).tolist():
        kind = int(genes[anchor, KIND])
        ground, floor = float(area[kind]), float(area[kind] * amount.storeys[kind])
        if covered - ground / 2 > amount.covered or floors - floor / 2 > amount.floors:
            clear_building(cells, genes, anchor)
            covered, floors = covered - ground, floors - floor


@compiled
def set_anywhere(
    cells: SiteLattice, genes: Ints, kind: int, count: int, places: Ints, first: int
) -> None:
    """Set ``count`` buildings of a kind at the first of some places (k,) that are free, turns from
    ``first`` on; ``genes`` (cells, 3), changed in place."""
    for k in range(places.shape[0]):
        for quarter in range(4):
            turn = (first + quarter) % 4
            if count > 0 and is_free(cells, genes, kind, turn, places[k]):
                set_building(cells, genes, kind, turn, places[k])
                count -= 1


def mutate_surely(
    cells: SiteLattice, genes: Ints, amount: Amount, rng: np.random.Generator
) -> None:
    """Single-point mutation in place that changes something and loses no building for which there
    is room; ``genes`` (cells, 3)."""
    before, held = genes.copy(), count_kinds(cells, genes).sum()
    for _ in range(AGAIN):
        mutate(cells, genes, rng)
        if not np.array_equal(genes, before):
            refill(cells, genes, amount, rng)
            kept = amount.covered > 0.0 or count_kinds(cells, genes).sum() >= held
            if kept and not np.array_equal(genes, before):
                return
        genes[:] = before


def make_amount(target: tuple[float, float], cells: SiteLattice, floors: Floats | Ints) -> Amount:
    """The amount of a target (ground covered, floor area); ``floors`` (n,) storeys of buildings."""
    storeys = np.zeros(len(cells.counts()), np.int64)
    storeys[1:] = np.asarray(floors)[cells.members[cells.firsts[1:-1]]]
    return Amount(target[0], target[1], storeys)
