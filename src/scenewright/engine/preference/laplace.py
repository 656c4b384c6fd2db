"""A Gaussian process under choices and ratings, by Laplace's method.

The posterior of the values f at the points seen is taken as normal about its mode (Rasmussen,
Williams 2006, section 3.4; for choices Chu, Ghahramani 2005). The likelihood ties points to each
other, so its curvature W is a full matrix and the equations are written without its root.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.preference.choices import Choice, Rating, choice_slopes, rating_slopes
from scenewright.engine.preference.kernel import Kernel, kernel_diagonal, kernel_matrix

Floats = NDArray[np.float64]
OFFSET = 0.5
"""Variance of a screen's offset."""
NEWTON, STILL = 30, 1e-6
"""Most steps of Newton's method, and a step below which it ends."""
JITTER = 1e-6


class Seen(NamedTuple):
    """What was said: ``points`` (n, D) in standard deviations, what each is worth beforehand
    (n,), choices and ratings among them."""

    points: Floats
    worth: Floats
    choices: tuple[Choice, ...] = ()
    ratings: tuple[Rating, ...] = ()


class Posterior(NamedTuple):
    """Values at ``points`` (n, D): the mode's ``slope`` (n,) = K⁻¹ f, ``shrink`` (n, n) =
    (K + W⁻¹)⁻¹, and the log of the evidence."""

    points: Floats
    kernel: Kernel
    slope: Floats
    shrink: NDArray[Any]
    evidence: float


def fit_posterior(seen: Seen, kernel: Kernel, begun: Floats | None = None) -> Posterior:
    """The mode by Newton's method, damped so that no step lowers the posterior, from the slope
    ``begun`` (n,) of a posterior of the same points, if there is one."""
    count = len(seen.points)
    prior = kernel_matrix(kernel, seen.points, seen.points) + JITTER * np.eye(count)
    screens = 1 + max((row.screen for row in seen.ratings), default=-1)
    wide = np.zeros((count + screens, count + screens))
    wide[:count, :count] = prior
    wide[count:, count:] = OFFSET * np.eye(screens)
    slope = np.zeros(len(wide))
    slope[:count] = 0.0 if begun is None else begun
    height, gradient, curvature = _slopes(seen, wide @ slope)
    height -= 0.5 * float(slope @ wide @ slope)
    for _ in range(NEWTON):
        now = wide @ slope
        aim = np.linalg.solve(np.eye(len(wide)) + curvature @ wide, curvature @ now + gradient)
        slope, height, moved = _step(seen, wide, slope, aim, height)
        _, gradient, curvature = _slopes(seen, wide @ slope)
        if moved < STILL:
            break
    inner = np.eye(len(wide)) + curvature @ wide
    shrink = np.linalg.solve(inner, curvature)
    evidence = height - 0.5 * float(np.linalg.slogdet(inner)[1])
    return Posterior(seen.points, kernel, slope[:count], shrink[:count, :count], evidence)


def _slopes(seen: Seen, values: Floats) -> tuple[float, Floats, Floats]:
    count = len(seen.points)
    chosen = choice_slopes(seen.choices, values[:count] + seen.worth)
    rated = rating_slopes(seen.ratings, values[:count] + seen.worth, values[count:])
    gradient, curvature = rated.gradient, rated.curvature
    gradient[:count] += chosen.gradient
    curvature[:count, :count] += chosen.curvature
    return chosen.value + rated.value, gradient, curvature


def _step(
    seen: Seen, wide: Floats, slope: Floats, aim: NDArray[Any], height: float
) -> tuple[Floats, float, float]:
    """The step towards ``aim`` that is as long as it may be, the log posterior there and how far
    the values moved."""
    share = 1.0
    while share > 1e-3:
        trial = slope + share * (aim - slope)
        values = wide @ trial
        reached = _slopes(seen, values)[0] - 0.5 * float(trial @ values)
        if reached >= height - 1e-9 or not np.isfinite(height):
            return trial, reached, float(np.abs(wide @ (trial - slope)).max(initial=0.0))
        share *= 0.5
    return slope, height, 0.0


def predict(posterior: Posterior, points: Floats) -> tuple[Floats, Floats]:
    """Mean (m,) and covariance (m, m) of the values at ``points`` (m, D)."""
    cross = kernel_matrix(posterior.kernel, points, posterior.points)
    own = kernel_matrix(posterior.kernel, points, points)
    return cross @ posterior.slope, own - cross @ posterior.shrink @ cross.T


def predict_each(posterior: Posterior, points: Floats) -> tuple[Floats, Floats]:
    """Mean and variance (m,) of the value at each of ``points`` (m, D) separately."""
    cross = kernel_matrix(posterior.kernel, points, posterior.points)
    taken = np.einsum("ij,ij->i", cross @ posterior.shrink, cross)
    return cross @ posterior.slope, kernel_diagonal(posterior.kernel, points) - taken
