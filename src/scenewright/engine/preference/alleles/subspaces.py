"""Local models of what a person would rate, over parts of the search space: Zhang, Yang 2023, (13)
and (15) to (21), with the symmetric Latin hypercube they sample by (Ye, Li, Sudjianto 2000).

Individuals are rows (n, d); ratings (n,).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.preference.alleles.preference import Form

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


def count_members(parts: Ints, count: int) -> Ints:
    """η of (13): how many individuals lie in each of ``count`` sub-spaces, by the part (n,) of
    each. A model is made of a part with more than S_min.

    >>> count_members(np.array([0, 2, 0]), 3).tolist()
    [2, 0, 1]
    """
    return np.bincount(parts, minlength=count)


def centre_variable(values: Floats) -> Floats:
    """D(x') of (17): a variable (n,) less its mean."""
    return values - values.mean()


def centre_ratings(ratings: Floats, form: Form = "repaired") -> Floats:
    """D(f) of (18): ratings (n,) less their mean. As printed the mean is divided by n once more.

    >>> centre_ratings(np.array([2.0, 4.0]), "printed").tolist()
    [0.5, 2.5]
    """
    again = len(ratings) if form == "printed" else 1
    return ratings - ratings.mean() / again


def measure_deviation(centred: Floats) -> float:
    """γ of (15) and (16): the root of the squares of centred values (n,) over n - 1."""
    return float(np.sqrt((centred**2).sum() / max(len(centred) - 1, 1)))


def correlate_variable(values: Floats, ratings: Floats, form: Form = "repaired") -> float:
    """κ of (19): the correlation of a variable (n,) with the ratings (n,); 0 where one does not
    vary.

    As printed it divides by n where (15) and (16) divide by n - 1, so a perfect correlation is
    (n - 1) / n, and takes (18) as it is. Repaired: Pearson's.

    >>> round(correlate_variable(np.array([1.0, 2.0, 3.0]), np.array([2.0, 4.0, 6.0])), 12)
    1.0
    """
    one, other = centre_variable(values), centre_ratings(ratings, form)
    both = measure_deviation(one) * measure_deviation(other)
    count = len(values) if form == "printed" else len(values) - 1
    return float(one @ other) / both / count if both > 0.0 and count > 0 else 0.0


def choose_split(points: Floats, ratings: Floats, form: Form = "repaired") -> int:
    """The variable the space of points (n, d) is divided along: that which goes with the ratings
    (n,) the most. As printed the greatest κ, so one that lowers them by as much is never chosen;
    repaired: |κ|.

    >>> choose_split(np.array([[0.0, 1.0], [1.0, 0.0], [2.0, 0.5]]), np.array([3.0, 2.0, 1.0]))
    0
    """
    correlations = np.array([correlate_variable(column, ratings, form) for column in points.T])
    return int(np.argmax(correlations if form == "printed" else np.abs(correlations)))


def divide_space(points: Floats, along: int, parts: int) -> Ints:
    """The part (n,) of every point: ``parts`` equal spans of one variable.

    >>> divide_space(np.array([[0.0], [0.4], [1.0]]), 0, 2).tolist()
    [0, 0, 1]
    """
    values = points[:, along]
    low, span = values.min(), max(float(np.ptp(values)), 1e-12)
    return np.minimum((parts * (values - low) / span).astype(np.int64), parts - 1)


def measure_distances(point: Floats, members: Floats) -> tuple[float, float]:
    """H_min and H̄ of (20): the least and the mean distance of a point (d,) to the members (m, d) of
    a sub-space.

    >>> measure_distances(np.zeros(2), np.array([[3.0, 4.0], [0.0, 1.0]]))
    (1.0, 3.0)
    """
    far = np.sqrt(((members - point) ** 2).sum(1))
    return float(far.min()), float(far.mean())


def combine_models(
    estimates: Sequence[float],
    least: Sequence[float],
    mean: Sequence[float],
    form: Form = "repaired",
) -> float:
    """f̂* of (21) from what the models of the sub-spaces say and the distances of (20).

    As printed Σ H̄ · Σ f̂ / H_min: no average, it grows with the number of models and with how far
    their members are spread. Repaired: Σ f̂ / H_min over Σ 1 / H_min (Shepard 1968); a model with
    a member where the point is decides alone.

    >>> combine_models([2.0, 4.0], [1.0, 1.0], [3.0, 3.0], "printed")
    36.0
    >>> combine_models([2.0, 4.0], [1.0, 3.0], [3.0, 3.0])
    2.5
    """
    values, near = np.asarray(estimates, np.float64), np.asarray(least, np.float64)
    if form == "printed":
        with np.errstate(divide="ignore"):
            return float(np.sum(mean) * (values / near).sum())
    if (near <= 0.0).any():
        return float(values[near <= 0.0].mean())
    return float((values / near).sum() / (1.0 / near).sum())


def draw_symmetric_hypercube(count: int, dims: int, rng: np.random.Generator) -> Floats:
    """A symmetric Latin hypercube of ``count`` points (count, dims) in [0, 1]: each variable takes
    each of ``count`` levels once, and with every point its mirror image is there.

    >>> points = draw_symmetric_hypercube(6, 2, np.random.default_rng(0))
    >>> (points + points[::-1]).tolist() == np.ones((6, 2)).tolist()
    True
    """
    half = count // 2
    levels = np.zeros((count, dims), np.int64)
    for k in range(dims):
        low = rng.permutation(half)
        mirrored = np.where(rng.random(half) < 0.5, low, count - 1 - low)
        levels[:half, k] = mirrored
        levels[count - half :, k] = count - 1 - mirrored[::-1]
        if count % 2:
            levels[half, k] = half
    return (levels + 0.5) / count


LEAST_MEMBERS = 3
"""S_min of (13): a sub-space with as many individuals or fewer has no model. Our figure."""


def fit_plane(points: Floats, ratings: Floats) -> tuple[float, Floats, Floats]:
    """The approximate model of a sub-space: a plane through its points (m, d) and ratings (m,) by
    least squares, shrunk by a ridge of 1. Mean rating, mean point (d,) and slopes (d,).

    The paper leaves the kind of model open; a plane is the least that tells two points apart.

    >>> mean, middle, slopes = fit_plane(np.array([[0.0], [1.0]]), np.array([1.0, 3.0]))
    >>> mean, middle.tolist(), slopes.round(3).tolist()
    (2.0, [0.5], [0.667])
    """
    middle, mean = points.mean(0), float(ratings.mean())
    off = points - middle
    slopes = np.linalg.solve(off.T @ off + np.eye(points.shape[1]), off.T @ (ratings - mean))
    return mean, middle, slopes


def estimate_locally(
    points: Floats,
    ratings: Floats,
    point: Floats,
    usual: float,
    parts: int = 2,
    form: Form = "repaired",
) -> float:
    """What a point (d,) would be rated, from points (n, d) that were, with ratings (n,): (13) to
    (21), the space split in ``parts`` along its most telling variable; ``usual`` where no part has
    more than S_min members. As printed the answer has no scale of ratings; repaired it keeps within
    1 to 5.

    >>> row = np.arange(8.0)[:, None]
    >>> round(estimate_locally(row, 1.0 + row[:, 0] / 2, np.array([6.5]), 3.0), 2)
    4.12
    """
    split = divide_space(points, choose_split(points, ratings, form), parts)
    usable = [part for part, held in enumerate(count_members(split, parts)) if held > LEAST_MEMBERS]
    if not usable:
        return usual
    models = [fit_plane(points[split == part], ratings[split == part]) for part in usable]
    estimates = [mean + float(slopes @ (point - middle)) for mean, middle, slopes in models]
    far = [measure_distances(point, points[split == part]) for part in usable]
    found = combine_models(estimates, [one[0] for one in far], [one[1] for one in far], form)
    return found if form == "printed" else float(np.clip(found, 1.0, 5.0))
