"""Maximal marginal relevance: as the plain definition says, each pair compared once."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from scenewright.engine.diversity import choose_diverse


def plain(worth: np.ndarray, apart: np.ndarray, count: int, weight: float, again: bool) -> list:
    taken: list[int] = []
    while len(taken) < count and (again or len(taken) < len(worth)):
        scores = [
            -np.inf
            if k in taken and not again
            else worth[k] + weight * min((apart[k, t] for t in taken), default=0.0)
            for k in range(len(worth))
        ]
        taken.append(int(np.argmax(scores)))
    return taken


@given(st.integers(0, 10_000), st.integers(1, 12), st.integers(1, 8), st.booleans())
def test_it_takes_what_the_definition_takes(seed: int, n: int, count: int, again: bool) -> None:
    rng = np.random.default_rng(seed)
    worth, apart = rng.random(n), rng.random((n, n))
    np.fill_diagonal(apart, 0.0)
    asked = []

    def differ(i: int, j: int) -> float:
        asked.append((i, j))
        return float(apart[i, j])

    found = choose_diverse(worth, differ, count, 0.7, again=again)
    assert found == plain(worth, apart, count, 0.7, again)
    assert again or len(asked) == len(set(asked)) <= n * len(found)
    assert choose_diverse(worth, differ, 1, 0.7, first=n - 1) == [n - 1]
    assert choose_diverse(worth[:0], differ, 3, 0.7) == []
