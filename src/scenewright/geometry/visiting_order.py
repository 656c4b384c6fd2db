"""The order in which to visit places: a short path through all of them, ends fixed.

The travelling salesman's path problem by nearest neighbour, then 2-opt (Croes 1958) and Or-opt
(Or 1976) until neither helps.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import compiled, inlined

Order = NDArray[np.int64]
LEAST = 1e-9


@inlined
def turn(order: Order, i: int, j: int) -> None:
    """Reverse the places i to j of an order."""
    while i < j:
        order[i], order[j] = order[j], order[i]
        i, j = i + 1, j - 1


@compiled
def improve(order: Order, costs: Floats) -> None:
    """Shorten a path through ``order`` (n,) by 2-opt and Or-opt; its first and last stay.

    ``costs`` (n, n) symmetric. A run of at most three moves between two neighbours elsewhere,
    either way round: three reversals.
    """
    n, better = order.shape[0], True
    while better:
        better = False
        for i in range(1, n - 2):
            for j in range(i + 1, n - 1):
                a, b, c, d = order[i - 1], order[i], order[j], order[j + 1]
                if costs[a, c] + costs[b, d] < costs[a, b] + costs[c, d] - LEAST:
                    turn(order, i, j)
                    better = True
        for size in range(1, 4):
            for i in range(1, n - size):
                for k in range(i + size, n - 1):  # the run i … i+size-1 goes behind place k
                    better |= shift(order, costs, i, i + size, k)
                for k in range(i - 1):  # the run moves ahead, to behind place k
                    better |= shift(order, costs, k + 1, i, i + size - 1)


@inlined
def shift(order: Order, costs: Floats, i: int, m: int, k: int) -> bool:
    """Swap the neighbouring runs i … m-1 and m … k if that is shorter, either one turned round
    or not; true if done.

    ``order`` (n,), ``costs`` (n, n) symmetric.
    """
    a, b, c, d = order[i - 1], order[i], order[m - 1], order[m]
    e, f = order[k], order[k + 1]
    now = costs[a, b] + costs[c, d] + costs[e, f] - LEAST
    plain = costs[a, d] + costs[e, b] + costs[c, f]
    first = costs[a, d] + costs[e, c] + costs[b, f]
    second = costs[a, e] + costs[d, b] + costs[c, f]
    if min(plain, first, second) >= now:
        return False
    length = k - m + 1
    turn(order, i, k)  # now the second run turned round, then the first turned round
    if plain <= first and plain <= second:
        turn(order, i, i + length - 1)
        turn(order, i + length, k)
    elif first <= second:
        turn(order, i, i + length - 1)
    else:
        turn(order, i + length, k)
    return True


def shortest_path_through(costs: Floats) -> Order:
    """The order (n,) of a short path from place 0 through all others to place n - 1, ``costs``
    (n, n) symmetric: the better one of those begun at either end.

    >>> x = np.array([0.0, 5.0, 1.0, 3.0, 2.0, 6.0])
    >>> shortest_path_through(np.abs(x[:, None] - x)).tolist()
    [0, 2, 4, 3, 1, 5]
    """
    back = np.ascontiguousarray(costs[::-1, ::-1])
    tours = [_from_nearest(np.ascontiguousarray(costs)), len(costs) - 1 - _from_nearest(back)[::-1]]
    return min(tours, key=lambda order: float(costs[order[:-1], order[1:]].sum()))


def _from_nearest(costs: Floats) -> Order:
    """Always on to the nearest place left, the last one last; then improved."""
    n = len(costs)
    order, left = [0], list(range(1, n - 1))
    while left:
        nearest = left[int(np.argmin(costs[order[-1], left]))]
        order.append(nearest)
        left.remove(nearest)
    found = np.array([*order, n - 1], np.int64)
    improve(found, costs)
    return found
