"""Classes of vectors: Ward's linkage and k-means offline, a leader with a threshold online.

Ward 1963 by the recurrence of Lance and Williams 1967; Lloyd 1982 with the seeding of Arthur and
Vassilvitskii 2007. The leader puts a vector into the class whose members are nearest on average, if
nearer than the threshold, else founds one, and asks those before again: so the result hardly
depends on the order.
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
    for turn in range(ROUNDS):
        away = ((vectors[:, None] - centres[None]) ** 2).sum(2)
        now = away.argmin(1)
        if (now == label).all() and turn:
            break
        label = now
        for k in range(len(centres)):
            if (label == k).any():
                centres[k] = vectors[label == k].mean(0)
    return label, float(away.min(1).sum())


def leader(vectors: Floats, threshold: float) -> Indices:
    """The class (n,) of each vector (n, d), taken one after the other. After each, those taken
    before are asked again: members nearer on average to another class join it, those
    farther than the threshold from all leave.

    >>> leader(np.array([[0.0], [4.0], [0.3], [4.1]]), 1.0).tolist()
    [0, 1, 0, 1]

    A first member that lies between two classes does not keep them together:

    >>> leader(np.array([[1.0], [0.0], [2.0], [2.1], [-0.2]]), 1.2).tolist()
    [0, 1, 0, 0, 1]
    """
    count = len(vectors)
    gaps = np.linalg.norm(vectors[:, None] - vectors[None], axis=2)
    label = np.full(count, -1)
    sums, sizes = np.zeros((count, count)), np.zeros(count)
    for k in range(count):
        _join(k, _choose(k, label, sums, sizes, threshold), label, gaps, sums, sizes)
        for member in _unhappy(k + 1, label, sums, sizes, threshold):
            wanted = _choose(member, label, sums, sizes, threshold)
            if wanted != label[member]:
                _join(member, wanted, label, gaps, sums, sizes)
    return _by_occurrence(label)


def _join(k: int, to: int, label: Indices, gaps: Floats, sums: Floats, sizes: Floats) -> None:
    """Move a vector to a class; ``sums`` (n, c) are the distances of all to each class."""
    if label[k] >= 0:
        sums[:, label[k]] -= gaps[k]
        sizes[label[k]] -= 1
    label[k] = to
    sums[:, to] += gaps[k]
    sizes[to] += 1


def _means(rows: Indices, label: Indices, sums: Floats, sizes: Floats) -> Floats:
    """The mean distance (r, c) of vectors to the others of each class; infinite for none."""
    others = sizes - (label[rows, None] == np.arange(len(sizes)))
    return np.where(others > 0, sums[rows] / np.maximum(others, 1), np.inf)


def _choose(k: int, label: Indices, sums: Floats, sizes: Floats, threshold: float) -> int:
    """The nearest class if it is near enough, else one of its own."""
    mean = _means(np.array([k]), label, sums, sizes)[0]
    near = int(mean.argmin())
    if mean[near] < threshold:
        return near
    alone = label[k] >= 0 and sizes[label[k]] == 1
    return int(label[k]) if alone else int(np.argmin(sizes))


def _unhappy(
    count: int, label: Indices, sums: Floats, sizes: Floats, threshold: float
) -> list[int]:
    """Which of the first vectors would be in another class."""
    rows = np.arange(count)
    mean = _means(rows, label, sums, sizes)
    own, best = mean[rows, label[:count]], mean.min(1)
    moved = (best < own) & (best < threshold) | (own >= threshold) & np.isfinite(own)
    return np.flatnonzero(moved).tolist()


def _by_occurrence(label: Indices) -> Indices:
    """Classes numbered in the order in which they occur."""
    known: dict[int, int] = {}
    return np.array([known.setdefault(int(v), len(known)) for v in label], np.int64)
