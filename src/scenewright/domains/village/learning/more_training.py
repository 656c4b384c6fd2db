"""Learning when a block is full: full blocks against those that lack half their houses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scenewright.domains.village.learned.fullness import MoreLaw, figures_of_state
from scenewright.domains.village.learned.style import VillageStyle, style_in_region
from scenewright.domains.village.learned.surroundings import survey
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.standing import Floats

REMOVED = 0.5
"""The chance of each house to be taken away (Zhu, Jiang and Li 2022)."""
TIMES, RIDGE, ROUNDS = 3, 3.0, 12


def learn_more(blocks: Sequence[RealBlock], style: VillageStyle, seed: int) -> MoreLaw:
    """The law that tells full blocks from others, by Newton's method with a ridge."""
    rows, label = states_of(blocks, style, seed, TIMES)
    mean, spread = rows.mean(0), np.maximum(rows.std(0), 1e-6)
    whole = np.column_stack([(rows - mean) / spread, np.ones(len(rows))])
    weights = np.zeros(whole.shape[1])
    ridge = np.append(np.full(len(mean), RIDGE), 1e-6)
    for _ in range(ROUNDS):
        odds = 1.0 / (1.0 + np.exp(-np.clip(whole @ weights, -30, 30)))
        bend = (whole * (odds * (1 - odds))[:, None]).T @ whole + np.diag(ridge)
        weights -= np.linalg.solve(bend, whole.T @ (odds - label) + ridge * weights)
    return MoreLaw(mean, spread, weights[:-1], float(weights[-1]))


def states_of(
    blocks: Sequence[RealBlock], style: VillageStyle, seed: int, times: int
) -> tuple[Floats, Floats]:
    """Figures of states (n, FIGURES), half of them full blocks, and whether houses are missing."""
    rng = np.random.default_rng([seed, 3])
    rows, label = [], []
    for block in [block for _ in range(times) for block in blocks]:
        whole, law = block.standing, style_in_region(style, block.region).manner.count_law
        kept = rng.random(len(whole.shapes)) >= REMOVED
        if kept.all():
            kept[rng.integers(len(kept))] = False
        for standing, more in ((whole.take(kept), 1.0), (whole, 0.0)):
            seen = survey(block.floor, block.streets, block.street_share, 1, standing)
            rows.append(figures_of_state(seen, law))
            label.append(more)
    return np.array(rows), np.array(label)
