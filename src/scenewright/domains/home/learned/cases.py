"""Groups found in several rooms made one case each, with what was seen of it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.learned.learning import GroupOccurrence

Floats = NDArray[np.float64]

ONE_CASE = 0.2  # cases nearer in width and depth than this are one, metres


class LearnedCase(NamedTuple):
    """A case with what was seen of it: the range of each member's size, room areas (least, most),
    median distances to wall and door, and the homes it was found in."""

    case: Group
    smallest: tuple[tuple[float, float, float], ...]
    largest: tuple[tuple[float, float, float], ...]
    areas: tuple[float, float]
    wall: float
    door: float
    seen: int
    homes: tuple[str, ...]


def merge_similar_cases(found: Sequence[GroupOccurrence]) -> tuple[LearnedCase, ...]:
    """Like cases as one: of the same function and pieces, and nearly the same width and depth.

    The middle one of them stands for all.
    """
    clusters: list[list[GroupOccurrence]] = []
    for one in sorted(found, key=lambda f: (f.case.function, f.case.width * f.case.depth)):
        near = [c for c in clusters if _alike(c[0].case, one.case)]
        if near:
            near[0].append(one)
        else:
            clusters.append([one])
    return tuple(_merge_cluster(cluster) for cluster in clusters)


def _alike(a: Group, b: Group) -> bool:
    kinds = [sorted(m.category for m in case.members) for case in (a, b)]
    near = abs(a.width - b.width) < ONE_CASE and abs(a.depth - b.depth) < ONE_CASE
    return a.function == b.function and kinds[0] == kinds[1] and near


def _merge_cluster(cluster: Sequence[GroupOccurrence]) -> LearnedCase:
    size = np.array([(f.case.width, f.case.depth) for f in cluster])
    middle = cluster[int(np.argmin(((size - np.median(size, axis=0)) ** 2).sum(1)))].case
    ranges = [_sizes(f.case, middle) for f in cluster]
    areas = [f.area for f in cluster]
    doors = [f.door for f in cluster if np.isfinite(f.door)]
    return LearnedCase(
        middle,
        _rows(np.min(ranges, axis=0)),
        _rows(np.max(ranges, axis=0)),
        (min(areas), max(areas)),
        float(np.median([f.wall for f in cluster])),
        float(np.median(doors)) if doors else float("nan"),
        len(cluster),
        tuple(sorted({f.home for f in cluster})),
    )


def _sizes(case: Group, like: Group) -> list[tuple[float, float, float]]:
    """Sizes of a case's members in the order of another's of the same kinds."""
    left = list(case.members)
    found = []
    for member in like.members:
        same = next(m for m in left if m.category == member.category)
        left.remove(same)
        found.append((same.size.width, same.size.depth, same.size.height))
    return found


def _rows(table: Floats) -> tuple[tuple[float, float, float], ...]:
    return tuple((float(w), float(d), float(h)) for w, d, h in table)
