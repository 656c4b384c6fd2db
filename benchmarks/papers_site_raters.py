"""Simulated raters of sites: no panel was at hand, and every figure made with them says so.

A rater likes a layout by F_eva of (22) with weights of their own, has a liking for each model and
for spots of the ground that no measure sees, and rates in stars with noise that grows as they
tire, a drifting scale and anchoring, as the simulated persons of :mod:`.person_raters`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.person_raters import ANCHOR, DRIFT, FRESH, HIDDEN, NOISE, TIRING
from scenewright.domains.site.encodings.cell_moves import random_genes
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import MatrixJudge, make_judge
from scenewright.domains.site.terms.measure import lay
from scenewright.domains.site.terms.value import value_parts

Floats = NDArray[np.float64]
LOOKED_AT = 40
"""Layouts by chance that a scale of liking is measured on."""
LEADING = (2.0, 5.0, 1.0, 2.0)
"""How the weights of raters are drawn (Dirichlet): about the printed ones, M leading."""


class SiteTaste(NamedTuple):
    """What somebody likes: a judge with their likings of models, weights of R, M, C and H, that of
    spots, the scale of these, and mean and spread over layouts by chance."""

    judge: MatrixJudge
    omega: Floats
    spots: float
    unit: float
    middle: float = 0.0
    spread: float = 1.0


def make_taste(problem: SiteProblem, seed: int) -> SiteTaste:
    """A rater by number."""
    rng, cells = np.random.default_rng([91, seed]), make_cells(problem)
    kinds = np.unique(problem.buildings.models, return_inverse=True)[1]
    liked = rng.random(int(kinds.max()) + 1)[kinds]
    judge = make_judge(problem, cells, liked)
    unit = float(np.ptp(problem.ground.bounds.reshape(2, 2), axis=0).max()) / 3.0
    taste = SiteTaste(judge, rng.dirichlet(LEADING), HIDDEN * rng.choice([-1.0, 1.0]), unit)
    chance = np.random.default_rng(5)
    rows = [random_genes(cells, chance, problem.buildings.quality, 0.0) for _ in range(LOOKED_AT)]
    boxes = judge.boxes(np.array(rows, float).reshape(LOOKED_AT, -1))
    plain = np.array([_measure(taste, one)[0] for one in boxes])
    taste = taste._replace(middle=float(plain.mean()), spread=max(float(plain.std()), 1e-9))
    values = np.array([like(taste, one) for one in boxes])
    return taste._replace(middle=taste.middle + taste.spread * float(values.mean()))


def like(taste: SiteTaste, boxes: Floats) -> float:
    """How much a layout (n, 5) is truly liked: 0 as one by chance, 1 a standard deviation more."""
    value, spot = _measure(taste, boxes)
    return (value - taste.middle) / taste.spread + taste.spots * spot


def _measure(taste: SiteTaste, boxes: Floats) -> tuple[float, float]:
    """F_eva with a rater's weights, and how well what stands is spotted, -1 to 1."""
    (p, s), parts = taste.judge.measure, np.empty(4)
    lay(p, s, boxes)
    value_parts(s, taste.judge.worth, parts)
    if taste.judge.seen is not None:
        parts[1] = taste.judge.seen(boxes)
    here = boxes[boxes[:, 3] > 0.0, :2] / taste.unit
    spot = float(np.sin(2.1 * here[:, 0] + 1.3 * here[:, 1]).mean()) if len(here) else 0.0
    return float(taste.omega @ parts), spot


class SiteRater:
    """Somebody who rates in stars, and tires of it."""

    def __init__(self, problem: SiteProblem, seed: int) -> None:
        self.taste, self._rng = make_taste(problem, seed), np.random.default_rng([92, seed])
        self.rated, self._strict = 0, 0.0

    def rate(self, layouts: Floats) -> Floats:
        """Stars, 1 to 5, of layouts (k, n, 5) one after the other."""
        return self.rate_liked([like(self.taste, boxes) for boxes in layouts])

    def rate_liked(self, liked: Sequence[float]) -> Floats:
        """Stars of layouts by how much each is truly liked."""
        self._strict += DRIFT * float(self._rng.standard_normal())
        given: list[float] = []
        for truth in liked:
            self.rated += 1
            noise = NOISE * (1.0 + max(self.rated - FRESH, 0) / TIRING)
            felt = 3.0 + truth / 2.5 + self._strict
            felt += noise / 1.5 * float(self._rng.standard_normal())
            felt += ANCHOR * (float(np.mean(given)) - felt) if given else 0.0
            given.append(float(np.clip(np.round(2.0 * felt) / 2.0, 1.0, 5.0)))
        return np.array(given)
