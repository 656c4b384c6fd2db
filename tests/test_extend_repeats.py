"""Steps at which a source repeats itself: against every pair, and where nothing does."""

from __future__ import annotations

import numpy as np
import pytest

from deadline import HANGS, within
from scenewright.domains.extend.repeats import LEAST, SAME, SHARE, Floats, repeat_steps

HOUSE = (0.0, 9.0, 6.0)


def houses(middles: Floats) -> Floats:
    return np.concatenate([middles, np.tile(HOUSE, (len(middles), 1))], 1)


def repeats(middles: Floats, step: Floats) -> bool:
    """Whether alike houses repeat at a step, by looking at every pair."""
    low, high = middles.min(0) - SAME, middles.max(0) + SAME
    moved = middles + step
    inside = ((moved > low) & (moved < high)).all(1)
    away = np.hypot(*(moved[:, None] - middles[None]).transpose(2, 0, 1))
    np.fill_diagonal(away, np.inf)
    met = int(((away.min(1) <= SAME) & inside).sum())
    return met >= max(LEAST, SHARE * inside.sum())


@pytest.mark.parametrize("seed", range(8))
def test_a_jittered_grid_repeats_at_its_steps(seed: int) -> None:
    rng = np.random.default_rng(seed)
    wide, deep = rng.uniform(12, 30, 2)
    grid = np.stack(np.meshgrid(np.arange(5) * wide, np.arange(4) * deep), -1).reshape(-1, 2)
    middles = grid + rng.normal(0, 0.3, grid.shape)
    found = repeat_steps(houses(middles))
    assert all(repeats(middles, step) for step in found)
    for unit in ((wide, 0.0), (0.0, deep)):
        assert np.hypot(*(np.abs(found) - unit).T).min() < 1.0


@pytest.mark.parametrize(("count", "apart"), [(40, 3.0), (60, 12.0), (600, 12.0), (3000, 30.0)])
def test_alike_houses_anywhere_are_looked_at_in_bounded_time(count: int, apart: float) -> None:
    """Some stand nearer than a step can be told from none."""
    middles = np.random.default_rng(3).uniform(0, apart * count**0.5, (count, 2))
    with within(HANGS):
        found = repeat_steps(houses(middles))
    assert np.isfinite(found).all()
    if count <= 60:
        assert all(np.hypot(*step) >= SAME for step in found)


def test_one_house_or_two_repeat_nowhere() -> None:
    for count in (1, 2):
        assert repeat_steps(houses(np.arange(2.0 * count).reshape(-1, 2) * 20)).shape == (0, 2)
