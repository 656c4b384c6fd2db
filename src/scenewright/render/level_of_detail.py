"""Scenes of heavy models made light enough for a picture: things beyond their share are thinned."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

import numpy as np

from scenewright.catalog.models.decimation import decimate
from scenewright.core.catalog import Part
from scenewright.render.items import RenderItem

MOST = 1_200_000
"""Triangles in a picture: about 0.6 gigabytes while it is drawn."""
LEAST = 12
"""Triangles that are left of a part."""


def affordable(shown: Sequence[RenderItem], most: int = MOST) -> tuple[RenderItem, ...]:
    """The things with about ``most`` triangles together; only the heaviest lose some, and things
    of one key stay alike."""
    counts = np.array([_faces(thing) for thing in shown], np.int64)
    if counts.sum() <= most:
        return tuple(shown)
    share = _share(counts, most)
    lighter: dict[Hashable, tuple[Part, ...]] = {}
    for thing, count in zip(shown, counts.tolist(), strict=True):
        if count > share and thing.key not in lighter:
            lighter[thing.key] = tuple(
                decimate(part, max(LEAST, int(len(part.faces) * share / count)))
                for part in thing.parts
            )
    return tuple(thing._replace(parts=lighter.get(thing.key, thing.parts)) for thing in shown)


def _faces(thing: RenderItem) -> int:
    return sum(len(part.faces) for part in thing.parts)


def _share(counts: np.typing.NDArray[np.int64], most: int) -> float:
    """The greatest s with the sum of min(count, s) at most ``most``.

    >>> _share(np.array([10, 100, 100]), 110)
    50.0
    """
    order = np.sort(counts)
    before = np.concatenate([[0], np.cumsum(order)[:-1]])
    left = np.arange(len(order), 0, -1)
    shares = (most - before) / left
    first = int(np.argmax(shares < order))
    return float(max(shares[first], 1.0))
