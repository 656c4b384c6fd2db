"""Which candidates to show next: few enough to look at, and worth the look.

A screen holds the champion and a few favourites, those predicted best, some drawn by Thompson
sampling (each is the best under one draw of what the person may like; Thompson 1933) and some to
learn from: those whose worth is least known, each after the others. Screens begin with the latter
and end with the former. The first screen spreads over sane layouts.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.preference.taste import PersonTaste, judge, judge_each, standardise

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

SHORT = 200
"""Candidates with the best prospects that are drawn for, and those least known that are chosen
from."""


class ScreenMix(NamedTuple):
    """How many candidates a screen has. ``learning`` is how many choices and ratings it
    takes until no more than ``least`` of a screen are there to learn from, ``greedy`` the share of
    the others that are the predicted best; the rest is drawn by Thompson sampling. ``apart`` is
    how much more two of a screen differ at least, as a share of the mean distance of the
    archive; ``favourites`` how many of those liked besides the champion stay on it."""

    size: int = 12
    learning: int = 45
    least: int = 4
    greedy: float = 0.8
    apart: float = 0.35
    favourites: int = 3

    def wide(self, statements: int) -> int:
        """How many layouts of a screen are there to learn from, after ``statements`` statements.

        >>> [ScreenMix().wide(count) for count in (0, 12, 24, 36)]
        [11, 8, 5, 4]
        """
        left = 1.0 - statements / max(self.learning, 1)
        return max(round((self.size - 1) * left), self.least)


def spread_over(points: Floats, count: int, start: int) -> list[int]:
    """``count`` rows of ``points`` (n, D) that lie far from each other: after ``start`` always the
    one farthest from those taken (Gonzalez 1985).

    >>> spread_over(np.array([[0.0], [1.0], [9.0], [5.0]]), 3, 0)
    [0, 2, 3]
    """
    taken = [start]
    nearest = _distances(points, points[[start]])[:, 0]
    while len(taken) < min(count, len(points)):
        nearest[taken] = -1.0
        taken.append(int(np.argmax(nearest)))
        nearest = np.minimum(nearest, _distances(points, points[taken[-1:]])[:, 0])
    return taken


def first_screen(taste: PersonTaste, values: Floats, mix: ScreenMix) -> list[int]:
    """Rows of ``values`` (n, D) for the first screen: the most usual layout and those that differ
    most from it and from each other."""
    points = standardise(taste.scale, values)
    usual = int(np.argmin((points**2).sum(1)))
    return spread_over(points, mix.size, usual)


def choose_screen(
    taste: PersonTaste,
    values: Floats,
    shown: Flags,
    kept: Sequence[int],
    rng: np.random.Generator,
    mix: ScreenMix,
) -> list[int]:
    """Rows of ``values`` (n, D) for the next screen, those ``kept`` on it first: the champion and
    favourites; ``shown`` (n,) were seen before and, but for these, are not shown again while there
    are others."""
    if taste.posterior is None and not taste.start.any():
        return list(dict.fromkeys([*kept, *first_screen(taste, values, mix)]))[: mix.size]
    points = standardise(taste.scale, values)
    far = _distances(points, points)
    least = mix.apart * float(np.median(far)) if len(points) > 1 else 0.0
    taken = list(kept)
    open_ = ~shown
    open_[taken] = False
    liked = mix.size - len(taken) - mix.wide(taste.statements)
    for value in _rank_by_draws(taste, values, open_, rng, liked, round(mix.greedy * liked)):
        _take_best(value, open_, far, least, taken)
    _take_unknown(taste, values, open_, mix.size, taken)
    return taken


def _rank_by_draws(
    taste: PersonTaste,
    values: Floats,
    open_: Flags,
    rng: np.random.Generator,
    count: int,
    greedy: int,
) -> list[Floats]:
    """``count`` values (n,) by which to choose one after the other: ``greedy`` times the predicted
    means, then draws; those that have no prospect are left out."""
    if count <= 0:
        return []
    mean, deviation = judge_each(taste, values)
    hope = np.where(open_, mean + deviation, -np.inf)
    short = np.sort(np.argsort(-hope, kind="stable")[:SHORT])
    liking = judge(taste, values[short])
    ranked = []
    for drawn in _draw(liking.mean, liking.covariance, max(count - greedy, 0), rng):
        wide = np.full(len(mean), -np.inf)
        wide[short] = drawn
        ranked.append(wide)
    return [mean] * greedy + ranked


def _take_best(value: Floats, open_: Flags, far: Floats, least: float, taken: list[int]) -> None:
    """Take the row of the greatest value that is open and not too like one taken, if any."""
    free = open_ & ((far[:, taken] >= least).all(1) if taken else True)
    free = free & np.isfinite(value)
    free = free if free.any() else open_ & np.isfinite(value)
    if free.any():
        best = int(np.argmax(np.where(free, value, -np.inf)))
        taken.append(best)
        open_[best] = False


def _take_unknown(
    taste: PersonTaste, values: Floats, open_: Flags, size: int, taken: list[int]
) -> None:
    """Fill a screen with rows to learn from."""
    free = np.flatnonzero(open_)
    if len(taken) < size and len(free):
        _, deviation = judge_each(taste, values[free])
        short = free[np.sort(np.argsort(-deviation, kind="stable")[:SHORT])]
        rows = [*taken, *short.tolist()]
        more = find_unknown(taste, values[rows], size - len(taken), len(taken))
        taken += [rows[k] for k in more]


def find_unknown(taste: PersonTaste, values: Floats, count: int, beside: int = 0) -> list[int]:
    """``count`` rows of ``values`` (n, D) to learn from, besides the first few that are shown
    anyway: always the least known one, given the worth of those before it (the pivots
    of Cholesky's decomposition of the covariance; the entropy of Shewry, Wynn 1987)."""
    rest = judge(taste, values).covariance
    taken: list[int] = []
    while len(taken) < min(beside + count, len(values)):
        left = np.diag(rest).copy()
        left[taken] = -1.0
        best = len(taken) if len(taken) < beside else int(np.argmax(left))
        taken.append(best)
        row = rest[best] / np.sqrt(max(float(rest[best, best]), 1e-12))
        rest = rest - np.outer(row, row)
    return taken[beside:]


def _draw(mean: Floats, covariance: Floats, count: int, rng: np.random.Generator) -> Floats:
    """``count`` draws (count, n) of a normal vector."""
    values, vectors = np.linalg.eigh(covariance)
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    drawn: Floats = mean + rng.standard_normal((count, len(mean))) @ root.T
    return drawn


def _distances(one: Floats, other: Floats) -> Floats:
    """Distances (n, m) of rows."""
    squares = (one**2).sum(1)[:, None] + (other**2).sum(1)[None] - 2.0 * one @ other.T
    return np.sqrt(np.maximum(squares, 0.0))
