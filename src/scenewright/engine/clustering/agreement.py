"""How well classes found agree with classes known: AMI, nearest neighbours, k-entropy impurity.

Adjusted mutual information (Vinh, Epps and Bailey 2010) is 0 for labels at random whatever their
number; the plain normalised one is not (.46 for 28 classes). The impurity is the paper's: over the
k nearest of each model, −Σ P log₂ P of their classes (Zhang and Fei 2017, section 1).
"""

from __future__ import annotations

from math import lgamma

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


def adjusted_mutual_information(one: Indices, other: Indices) -> float:
    """AMI of two labellings (n,): 1 the same classes, 0 as chance has it.

    >>> adjusted_mutual_information(np.array([0, 0, 1, 1]), np.array([5, 5, 3, 3]))
    1.0
    """
    _, a = np.unique(one, return_inverse=True)
    _, b = np.unique(other, return_inverse=True)
    table = np.zeros((a.max() + 1, b.max() + 1))
    np.add.at(table, (a, b), 1.0)
    total, rows, columns = len(a), table.sum(1), table.sum(0)
    share = table[table > 0] / total
    expected = (rows[:, None] * columns[None] / total**2)[table > 0]
    mutual = float((share * np.log(share / expected)).sum())
    by_chance = _expected_information(rows, columns, total)
    upper = (_entropy(rows / total) + _entropy(columns / total)) / 2
    return round((mutual - by_chance) / max(upper - by_chance, 1e-12), 12)


def _entropy(share: Floats) -> float:
    return float(-(share[share > 0] * np.log(share[share > 0])).sum())


def _expected_information(rows: Floats, columns: Floats, total: int) -> float:
    """The mean mutual information of tables with these margins."""
    found = 0.0
    logs = [lgamma(k + 1) for k in range(total + 1)]
    for a in rows.astype(int).tolist():
        for b in columns.astype(int).tolist():
            for n in range(max(a + b - total, 1), min(a, b) + 1):
                chance = (
                    logs[a] + logs[b] + logs[total - a] + logs[total - b] - logs[total] - logs[n]
                )
                chance -= logs[a - n] + logs[b - n] + logs[total - a - b + n]
                found += n / total * np.log(total * n / (a * b)) * np.exp(chance)
    return float(found)


def nearest_share(vectors: Floats, classes: Indices) -> float:
    """The share of vectors (n, d) whose nearest other is of their class.

    >>> nearest_share(np.array([[0.0], [0.1], [5.0]]), np.array([0, 0, 1])).__round__(3)
    0.667
    """
    away = ((vectors[:, None] - vectors[None]) ** 2).sum(2)
    np.fill_diagonal(away, np.inf)
    return float((classes[away.argmin(1)] == classes).mean())


def k_entropy(vectors: Floats, classes: Indices, k: int = 4) -> float:
    """The mean k-entropy impurity of descriptors (n, d), in bits: 0 if the k nearest of every
    model are of one class (n,).

    >>> k_entropy(np.array([[0.0], [0.1], [5.0], [5.1]]), np.array([0, 0, 1, 1]), 1)
    0.0
    """
    away = ((vectors[:, None] - vectors[None]) ** 2).sum(2)
    np.fill_diagonal(away, np.inf)
    near = np.argsort(away, axis=1, kind="stable")[:, :k]
    found = []
    for row in classes[near]:
        share = np.unique(row, return_counts=True)[1] / k
        found.append(float(-(share * np.log2(share)).sum()) + 0.0)
    return float(np.mean(found))
