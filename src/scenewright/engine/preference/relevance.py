"""Which features a person cares about: few do, and the evidence says which.

Automatic relevance determination (MacKay 1994; Neal 1996): the slope and the bend of every feature
have a variance of their own. Variances have an inverse gamma prior, so that weights have Student's
t (Tipping 2001), most of them small and a few large; expectation and maximisation by turns.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.preference.kernel import Kernel, bend
from scenewright.engine.preference.laplace import Posterior, Seen, fit_posterior

Floats = NDArray[np.float64]
FREEDOM = 1.0
"""Degrees of freedom of the prior of weights: 1 is Cauchy's, with the heaviest tails."""


def fit_relevance(seen: Seen, kernel: Kernel, rounds: int) -> Posterior:
    """The posterior of what was said, with the variance of each slope and bend found in ``rounds``
    rounds, from those of ``kernel``; 0 leaves them as they are.

    v ← (ν s + E[w²]) / (ν + 1) with s what the variance of a weight w was at first.
    """
    count = seen.points.shape[1]
    first = [np.broadcast_to(part, count) for part in (kernel.linear, kernel.bent)]
    found = fit_posterior(seen, kernel)
    for _ in range(rounds):
        now, given = found.kernel, (seen.points, bend(seen.points))
        parts = [np.broadcast_to(part, count) for part in (now.linear, now.bent)]
        linear, bent = (
            (FREEDOM * begun + _second_moment(found, values, part)) / (FREEDOM + 1.0)
            for begun, values, part in zip(first, given, parts, strict=True)
        )
        found = fit_posterior(seen, now._replace(linear=linear, bent=bent), found.slope)
    return found


def _second_moment(found: Posterior, values: Floats, variance: Floats) -> Floats:
    """E[w²] (D,) under the posterior, of weights w of ``values`` (n, D) with prior ``variance``
    (D,); all times D, as variances of a kernel are."""
    own = variance / max(values.shape[1], 1)
    mean = own * (values.T @ found.slope)
    taken = own**2 * np.einsum("ni,nm,mi->i", values, found.shrink, values, optimize=True)
    moment: Floats = mean**2 + np.maximum(own - taken, 0.0)
    return moment * values.shape[1]
