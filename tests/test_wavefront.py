"""Quickest ways by buckets take as long as those by a heap, whatever the ground is like."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from scenewright.geometry.travel import make_search, spread
from scenewright.geometry.wavefront import find_quickest


@given(
    st.integers(0, 10_000), st.integers(1, 30), st.integers(1, 30), st.sampled_from((0.0, 0.3, 0.6))
)
def test_buckets_find_the_times_a_heap_finds(
    seed: int, rows: int, columns: int, barred: float
) -> None:
    rng = np.random.default_rng(seed)
    slow = rng.choice([1.0, 0.45, 1.7, rng.uniform(0.2, 9.0)], (rows, columns))
    slow[rng.random((rows, columns)) < barred] = np.inf
    starts = np.unique(rng.integers(rows * columns, size=3)).astype(np.int32)
    slow.reshape(-1)[starts] = 1.0
    times, before = find_quickest(slow, 0.7, starts)
    search = make_search(slow.size)
    spread(search, slow, 0.7, starts, -1)
    assert np.allclose(times, search.times, rtol=1e-12)
    reached = np.flatnonzero(np.isfinite(times) & (times > 0.0))
    steps = times[reached] - times[before[reached]]
    assert (before[starts] == -1).all()
    assert (steps > 0.0).all()
    near = np.abs(np.subtract(np.divmod(reached, columns), np.divmod(before[reached], columns)))
    assert (near.max(0, initial=0) == 1).all()


def test_nothing_is_reached_without_starts_or_ground() -> None:
    for slow, starts in ((np.ones((3, 4)), []), (np.full((3, 4), np.inf), [0])):
        times, before = find_quickest(slow, 1.0, np.array(starts, np.int32))
        assert np.isinf(times).all()
        assert (before == -1).all()
