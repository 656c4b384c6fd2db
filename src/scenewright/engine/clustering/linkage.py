"""Classes of vectors: Ward's linkage and k-means offline, a leader with a threshold online.

Ward 1963 by the recurrence of Lance and Williams 1967; Lloyd 1982 with the seeding of Arthur and
Vassilvitskii 2007. The leader puts a vector into the class whose members are nearest on average, if
nearer than the threshold, else founds one: unlike a leader by first member it hardly depends on the
order.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
ROUNDS = 50


def ward(vectors: Floats, classes: int) -> Indices:
    """The class (n,) of each vector (n, d) in ``classes`` classes of least variance; O(n³) in
    NumPy, well up to a thousand vectors.

    >>> ward(np.array([[0.0], [0.1], [5.0], [5.2], [9.0]]), 3).tolist()
    [0, 0, 1, 1, 2]
    """
    count = len(vectors)
    gap = ((vectors[:, None] - vectors[None]) ** 2).sum(2) / 2
    np.fill_diagonal(gap, np.inf)
    sizes, label = np.ones(count), np.arange(count)
    for _ in range(count - max(classes, 1)):
        a, b = sorted(divmod(int(np.argmin(gap)), count))
        total = sizes[a] + sizes[b] + sizes
        joined = (
            (sizes[a] + sizes) * gap[a] + (sizes[b] + sizes) * gap[b] - sizes * gap[a, b]
        ) / total
        joined[[a, b]] = np.inf
        gap[a], gap[:, a] = joined, joined
        gap[b], gap[:, b] = np.inf, np.inf
        sizes[a] += sizes[b]
        label[label == b] = a
    return _by_occurrence(label)


def k_means(vectors: Floats, classes: int, seed: int = 0) -> Indices:
    """The class (n,) of each vector (n, d) by k-means, the best of five starts.

    >>> k_means(np.array([[0.0], [0.1], [5.0], [5.2]]), 2).tolist()
    [0, 0, 1, 1]
    """
    rng = np.random.default_rng(seed)
    best, found = np.inf, np.zeros(len(vectors), np.int64)
    for _ in range(5):
        label, cost = _lloyd(vectors, _start(vectors, classes, rng))
        if cost < best:
            best, found = cost, label
    return _by_occurrence(found)


def _start(vectors: Floats, classes: int, rng: np.random.Generator) -> Floats:
    chosen = [int(rng.integers(len(vectors)))]
    while len(chosen) < min(classes, len(vectors)):
        away = ((vectors[:, None] - vectors[None, chosen]) ** 2).sum(2).min(1)
        if away.sum() <= 0:
            break
        chosen.append(int(rng.choice(len(vectors), p=away / away.sum())))
    return vectors[chosen].copy()


def _lloyd(vectors: Floats, centres: Floats) -> tuple[Indices, float]:
    label = np.zeros(len(vectors), np.int64)
    for _ in range(ROUNDS):
        away = ((vectors[:, None] - centres[None]) ** 2).sum(2)
        now = away.argmin(1)
        if (now == label).all() and _:
            break
        label = now
        for k in range(len(centres)):
            if (label == k).any():
                centres[k] = vectors[label == k].mean(0)
    return label, float(away.min(1).sum())


def leader(vectors: Floats, threshold: float) -> Indices:
    """The class (n,) of each vector (n, d), taken one after the other.

    >>> leader(np.array([[0.0], [4.0], [0.3], [4.1]]), 1.0).tolist()
    [0, 1, 0, 1]
    """
    found = np.zeros(len(vectors), np.int64)
    for k, row in enumerate(vectors):
        away = np.linalg.norm(vectors[:k] - row, axis=1)
        mean = np.bincount(found[:k], away) / np.maximum(np.bincount(found[:k]), 1)
        near = int(np.argmin(mean)) if k else -1
        found[k] = near if k and mean[near] < threshold else len(mean) if k else 0
    return found


def _by_occurrence(label: Indices) -> Indices:
    """Classes numbered in the order in which they occur."""
    known: dict[int, int] = {}
    return np.array([known.setdefault(int(v), len(known)) for v in label], np.int64)
