"""Strings of repeated things folded to the shortest expression, and unfolded to longer ones.

A facade, a row of houses or a tower is a string of elements; repeated neighbours fold under a star
(Zhang and Fei 2017, section 3): E1 E1 E2 E1 E2 E2 E1 E3 E1 E3 E2 → E1 (E1 E2)* E2 (E1 E3)* E2. The
paper does not say how. Here a symbol costs 1 and (w)* costs cost(w) + c with 0 < c < 2, and

    cost(i, j) = min( min over k of cost(i, k) + cost(k, j),
                      min over periods p of cost(i, i + p) + c )

is exact by dynamic programming over intervals: O(n³) for n symbols. It gives the printed expression
as the only optimum; folding greedily from the left does not (it begins with E1*).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

STAR = 1.0
"""Cost of a star; anything between 0 and 2 folds the paper's example as printed."""
MOST = 2000
"""Symbols that are folded at most."""


class Repeat(NamedTuple):
    """A part that occurs ``times`` in a row."""

    body: Folded
    times: int


Folded: TypeAlias = "tuple[str | Repeat, ...]"
"""A folded string: symbols and repeats, in order."""


def fold(symbols: Sequence[str], star: float = STAR) -> Folded:
    """The cheapest expression of a string; of several the one with the earliest, shortest parts.

    >>> show(fold("E1 E1 E2 E1 E2 E2 E1 E3 E1 E3 E2".split()))
    'E1 (E1 E2)^2 E2 (E1 E3)^2 E2'
    >>> show(fold("ABABABC"))
    '(A B)^3 C'
    """
    names = list(symbols)
    if not names:
        return ()
    if len(names) > MOST:
        raise ValueError(f"{len(names)} symbols: at most {MOST} are folded")
    _, choice = _tables(names, star)
    return _build(names, choice, 0, len(names))


def cost_of(folded: Folded, star: float = STAR) -> float:
    """The cost of an expression: its symbols, and ``star`` for each repeat.

    >>> cost_of(fold("ABABABC"))
    4.0
    """
    return sum(
        cost_of(part.body, star) + star if isinstance(part, Repeat) else 1.0 for part in folded
    )


def _tables(names: list[str], star: float) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Costs (n + 1, n + 1) of intervals, and how each is made: k > 0 cut at k, -p period p, 0 a
    symbol."""
    count = len(names)
    same = _common_runs(names)
    cost = np.full((count + 1, count + 1), np.inf)
    choice = np.zeros((count + 1, count + 1), np.int64)
    starts = np.arange(count)
    cost[starts, starts + 1] = 1.0
    for length in range(2, count + 1):
        periods = [p for p in range(1, length // 2 + 1) if length % p == 0]
        for i in range(count - length + 1):
            j = i + length
            sums = cost[i, i + 1 : j] + cost[i + 1 : j, j]
            k = int(np.argmin(sums))
            best, made = float(sums[k]), i + 1 + k
            for p in periods:
                if same[i, i + p] >= length - p and cost[i, i + p] + star < best - 1e-9:
                    best, made = float(cost[i, i + p]) + star, -p
            cost[i, j], choice[i, j] = best, made
    return cost, choice


def _common_runs(names: list[str]) -> NDArray[np.int64]:
    """How many symbols from i on equal those from j on: (n, n)."""
    known = {name: k for k, name in enumerate(dict.fromkeys(names))}
    row = np.array([known[name] for name in names])
    count = len(row)
    found = np.zeros((count + 1, count + 1), np.int64)
    for i in range(count - 1, -1, -1):
        equal = row[i] == row
        found[i, :count] = np.where(equal, found[i + 1, 1:] + 1, 0)
    return found


def _build(names: list[str], choice: NDArray[np.int64], i: int, j: int) -> Folded:
    if j - i == 1:
        return (names[i],)
    made = int(choice[i, j])
    if made < 0:
        return (Repeat(_build(names, choice, i, i - made), (j - i) // -made),)
    return (*_build(names, choice, i, made), *_build(names, choice, made, j))


def unfold(folded: Folded) -> tuple[str, ...]:
    """The string an expression stands for.

    >>> "".join(unfold(parse("(A B)^2 C")))
    'ABABC'
    """
    found: list[str] = []
    for part in folded:
        found += unfold(part.body) * part.times if isinstance(part, Repeat) else (part,)
    return tuple(found)


def stretch(folded: Folded, length: int) -> Folded:
    """The same expression with its repeats turning more often (or less), so that it unfolds to
    about ``length`` symbols: one more of the outer repeat that is shortest by its share, as long
    as that comes nearer. Without a repeat the whole is repeated.

    >>> show(stretch(fold("ABABABC"), 11))
    '(A B)^5 C'
    """
    if not any(isinstance(part, Repeat) for part in folded):
        times = max(round(length / max(len(folded), 1)), 1)
        return folded if times == 1 or not folded else (Repeat(folded, times),)
    now = list(folded)
    while True:
        size = len(unfold(tuple(now)))
        step = 1 if size < length else -1
        open_ = [
            k for k, part in enumerate(now) if isinstance(part, Repeat) and part.times + step >= 1
        ]
        if not open_:
            return tuple(now)
        k = min(open_, key=lambda k: _share(now[k], folded[k]) * step)
        part = now[k]
        assert isinstance(part, Repeat)
        change = len(unfold(part.body))
        if abs(size + step * change - length) >= abs(size - length):
            return tuple(now)
        now[k] = part._replace(times=part.times + step)


def _share(now: str | Repeat, before: str | Repeat) -> float:
    if isinstance(now, Repeat) and isinstance(before, Repeat):
        return now.times / before.times
    return 1.0


def show(folded: Folded) -> str:
    """An expression as text: ``(A B)^3 C``."""
    return " ".join(
        f"({show(part.body)})^{part.times}" if isinstance(part, Repeat) else part for part in folded
    )


TOKEN = re.compile(r"\s*(\(|\)|\^\s*\d+|\*|[^\s()^*]+)")


def parse(text: str) -> Folded:
    """The expression of a text; ``*`` is twice. ValueError, with the place, for what is none.

    >>> show(parse("A (B (C D)^2)^3")), show(parse("(A)* B"))
    ('A (B (C D)^2)^3', '(A)^2 B')
    """
    stack: list[list[str | Repeat]] = [[]]
    closed: Folded | None = None
    at = 0
    while at < len(text.rstrip()):
        match = TOKEN.match(text, at)
        if match is None:
            raise ValueError(f"'{text[at : at + 10].strip()}' at character {at + 1} is no symbol")
        token, at = match[1], match.end()
        if closed is not None:
            times = 2 if token == "*" else int(token[1:]) if token.startswith("^") else 0
            if times < 1 or times > MOST:
                raise ValueError(f"a number of times is missing before character {at}")
            stack[-1].append(Repeat(closed, times))
            closed = None
        elif token == "(":
            stack.append([])
        elif token == ")":
            if len(stack) == 1 or not stack[-1]:
                raise ValueError(f"nothing is closed at character {at}")
            closed = tuple(stack.pop())
        elif token == "*" or token.startswith("^"):
            raise ValueError(f"'{token}' at character {at} follows no ')'")
        else:
            stack[-1].append(token)
    if len(stack) > 1 or closed is not None:
        raise ValueError("a bracket is not closed, or '^' and a number are missing after it")
    return tuple(stack[0])
