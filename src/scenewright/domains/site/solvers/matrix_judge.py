"""What judges matrix codes of sites without a person: F_eva of (22), less what positions cost."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from scenewright.domains.site.encodings.cells import SiteLattice, decode_genes
from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.settings import MatrixSettings
from scenewright.domains.site.solvers.answer import Measure, make_measure, views_of
from scenewright.domains.site.terms.measure import lay
from scenewright.domains.site.terms.table import LEFT, QUALITY
from scenewright.domains.site.terms.value import FULL, OMEGA, Worth, make_worth, value_parts


class MatrixJudge(NamedTuple):
    """What judges chromosomes without a person: -F_eva of (22), and ``position`` times the mean
    position costs of (5), which are none as printed. ``seen`` is M of boxes (n, 5) (left out: as
    printed)."""

    cells: SiteLattice
    measure: Measure
    worth: Worth
    omega: tuple[float, ...] = OMEGA
    position: float = MatrixSettings().position
    seen: Callable[[Floats], float] | None = None

    def energies(self, genes: Floats) -> Floats:
        """Energies (P,) of chromosomes (P, cells · 3), about -1 … 0; lower is better."""
        p, s = self.measure
        parts, found = np.empty(len(OMEGA)), np.empty(len(genes))
        weights = p.weights.copy()
        weights[[QUALITY, LEFT]] = 0.0
        for k, boxes in enumerate(self.boxes(genes)):
            lay(p, s, boxes)
            value_parts(s, self.worth, parts)
            if self.seen is not None:
                parts[1] = self.seen(boxes)
            position = float(weights @ s.sums) / max(len(boxes), 1)
            found[k] = self.position * position - float(parts @ np.array(self.omega))
        return found

    def boxes(self, genes: Floats) -> Floats:
        """Boxes (P, n, 5) of chromosomes; of no width: left out."""
        found = np.empty((len(genes), len(self.cells.members), 5))
        used = np.zeros_like(self.cells.counts())
        for k, row in enumerate(genes):
            whole = np.ascontiguousarray(row.reshape(-1, 3).astype(np.int64))
            decode_genes(self.cells, whole, used, found[k])
        return found


def make_judge(
    problem: SiteProblem, cells: SiteLattice, liked: Floats | None = None
) -> MatrixJudge:
    """A judge of a problem's chromosomes; ``liked`` (n,) a person's preference of buildings."""
    judge = MatrixJudge(cells, make_measure(problem), make_worth(problem, liked))
    if problem.form == "printed" or not len(problem.ground.eyes):
        return judge
    return judge._replace(seen=partial(measure_seen, problem))


def measure_seen(problem: SiteProblem, boxes: Floats) -> float:
    """M of (22) in the repaired form: what walkers see of boxes (n, 5), of no width: left out."""
    present, rule = boxes[:, 3] > 0.0, problem.settings.matrix
    views = views_of(problem, boxes[present], present, rule.eyes, rule.rays)
    return min(float(views.mean()) / FULL, 1.0)
