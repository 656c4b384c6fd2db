"""The paper's method with the person, TIGA and the simple genetic algorithm, generation by
generation, over the matrix code of sites.

TIGA is the traditional interactive one: the rater rates every new layout. The paper's estimates
most of them from preferences of alleles, (7) to (10), and lets an ART1 network rate where it is
trusted, (24) and (25). An allele is a kind of building anchored at a cell. Both breed by
the repaired operators, which lose no building: by the printed ones TIGA is stuck after 34 layouts.
SGA asks nobody: F_eva alone.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.papers_site_raters import SiteRater, like
from scenewright.domains.site.encodings.cells import KIND, PART, SiteLattice
from scenewright.domains.site.encodings.refill import make_amount
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers.genetic import MatrixGenetic
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import make_judge
from scenewright.domains.site.solvers.seed_layouts import seed_layouts
from scenewright.engine.preference.alleles.art1 import (
    STAGES,
    Art1Settings,
    learn_ratings,
    may_take_over,
    rate_pattern,
)
from scenewright.engine.preference.interactive.estimates import (
    MIDDLE,
    RatedLayouts,
    estimate_by_alleles,
    mark_alleles,
)
from scenewright.engine.preference.interactive.methods import method_named
from scenewright.engine.preference.interactive.takeover import ALONE, REMEMBERED

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Name = Literal["vp", "tiga", "sga"]
ASKED = method_named("vp").asked


class Generation(NamedTuple):
    """After a generation: layouts searched and ratings given so far, how much the best layout so
    far is truly liked (for SGA: its F_eva), and the champion's boxes (n, 5), the best rated."""

    searched: int
    ratings: int
    best: float
    champion: Floats


def search(
    problem: SiteProblem, name: Name, rater: SiteRater, seed: int, generations: int, ratings: int
) -> list[Generation]:
    """A run of at most so many generations and ratings."""
    cells, rng = make_cells(problem), np.random.default_rng([93, seed])
    solver, judge = _solver(problem, cells, name, seed), make_judge(problem, cells)
    width = solver.cells.fits.shape[2] * 3
    state = solver.init(rng, np.zeros(width), np.zeros(width))
    assess = _make_assessor(problem, cells, rater, rng) if name == "vp" else None
    found: list[Generation] = []
    best, top, champion, searched = -np.inf, -np.inf, np.zeros((0, 5)), 0
    while len(found) < generations and rater.rated < ratings:
        genes, state = solver.ask(state, rng)
        if not len(genes):
            break
        boxes = judge.boxes(genes)
        if name == "sga":
            told = -judge.energies(genes)
            truth = told
        else:
            told = assess(genes, boxes) if assess else rater.rate(boxes)
            truth = np.array([like(rater.taste, one) for one in boxes])
        state, searched = solver.tell(state, genes, -told), searched + len(genes)
        best = max(best, float(truth.max()))
        if told.max() > top:
            top, champion = float(told.max()), boxes[int(told.argmax())].copy()
        found.append(Generation(searched, rater.rated, best, champion))
    return found


def _solver(problem: SiteProblem, cells: SiteLattice, name: Name, seed: int) -> MatrixGenetic:
    quality = problem.buildings.quality
    amount = make_amount(problem.target, cells, problem.buildings.floors)
    if name == "vp":
        parents = seed_layouts(problem, cells, problem.settings.matrix.templates, seed)
        return MatrixGenetic(cells, quality, amount=amount, parents=parents)
    if name == "tiga":
        return MatrixGenetic(
            cells, quality, selection="roulette", led=0.0, local=False, amount=amount
        )
    return MatrixGenetic(
        cells, quality, selection="roulette", points=1, keep=0, led=0.0, local=False, amount=amount
    )


def _make_assessor(
    problem: SiteProblem, cells: SiteLattice, rater: SiteRater, rng: np.random.Generator
) -> Callable[[Floats, Floats], Floats]:
    """What the paper's method tells of new layouts: ratings, estimates, or the network's."""
    rated: list[Ints] = []
    told: list[float] = []
    kinds, settings = len(cells.counts()), Art1Settings()
    quality = np.array(
        [problem.buildings.quality[cells.members[k : k + 1]].sum() for k in cells.firsts[:-1]]
    )
    stage = alone = 0

    def guess(rows: Ints) -> Floats:
        last = np.array(rated[-REMEMBERED:])
        bits = mark_alleles(np.concatenate([last, rows]), kinds)
        network = learn_ratings(bits[: len(last)], np.array(told[-REMEMBERED:]), settings)
        return np.array([rate_pattern(network, row, MIDDLE, settings) for row in bits[len(last) :]])

    def assess(genes: Floats, boxes: Floats) -> Floats:
        nonlocal stage, alone
        rows = read_alleles(genes)
        if alone:
            alone -= 1
            return guess(rows)
        count = len(rows) if not rated else min(ASKED, len(rows))
        given = rater.rate(boxes[:count])
        if (
            stage < len(STAGES)
            and rated
            and may_take_over(given, guess(rows[:count]), STAGES[stage])
        ):
            alone, stage = min(STAGES[stage].generations, ALONE), stage + 1
        rated.extend(rows[:count])
        told.extend(given.tolist())
        known = RatedLayouts(np.array(rated), np.array(told), quality)
        rest = [estimate_by_alleles(known, row, rng) for row in rows[count:]]
        return np.array([*given, *rest])

    return assess


def read_alleles(genes: Floats) -> Ints:
    """The kind anchored at each cell (k, cells), 0 for none, of chromosomes (k, cells · 3)."""
    whole = genes.reshape(len(genes), -1, 3).astype(np.int64)
    found: Ints = np.where(whole[:, :, PART] == 0, whole[:, :, KIND], 0)
    return found
