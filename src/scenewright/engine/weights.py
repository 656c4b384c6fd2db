"""Weights by name, as users give them, read into the vectors that compiled terms take."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from scenewright.core.errors import InputError


def vector_of(
    weights: Mapping[str, float], places: Mapping[str, int], vector: NDArray[np.float64], what: str
) -> NDArray[np.float64]:
    """``vector`` with the named weights at their ``places``; a name that has none is reported as no
    ``what``.

    ``vector`` (k,).

    >>> vector_of({"fill": 2.0}, {"space": 0, "fill": 1}, np.zeros(2), "term").tolist()
    [0.0, 2.0]
    """
    found = vector.copy()
    for name, weight in weights.items():
        if name not in places:
            raise InputError(f"no {what} is called {name!r}", f"the terms are {', '.join(places)}")
        found[places[name]] = weight
    return found
