"""A few of many that are good and differ: maximal marginal relevance.

Taken first is the best, then again and again the one with the most of its worth and of its least
difference from all taken (Carbonell and Goldstein 1998, with differences in place of one less
similarities). Each pair is compared once.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def choose_diverse(
    worth: Floats,
    differ: Callable[[int, int], float],
    count: int,
    weight: float,
    *,
    first: int | None = None,
    again: bool = False,
) -> list[int]:
    """The numbers of at most ``count`` of n, in the order taken.

    ``worth`` (n,), more is better; ``differ(i, j)`` how far two differ, from 0; ``weight`` what
    that counts against worth. ``first`` is taken first (left out: what is worth most); ``again``
    lets one be taken more than once, where no other is worth as much.

    >>> places, worth = [0.0, 0.1, 5.0, 5.2], np.array([1.0, 0.9, 0.5, 0.6])
    >>> choose_diverse(worth, lambda i, j: abs(places[i] - places[j]), 3, 1.0)
    [0, 3, 1]
    """
    worth, taken = np.asarray(worth, np.float64), list[int]()
    nearest = np.zeros(len(worth))
    while len(worth) and len(taken) < (count if again else min(count, len(worth))):
        scores = worth + weight * nearest
        if not again:
            scores[taken] = -np.inf
        best = int(np.argmax(scores)) if taken or first is None else first
        off = np.array([differ(k, best) if k != best else 0.0 for k in range(len(worth))])
        nearest = np.minimum(nearest, off) if taken else off
        taken.append(best)
    return taken
