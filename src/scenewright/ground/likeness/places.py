"""Two places compared: how far they differ beyond chance, beside a ruler, and in words.

The ruler is what the same measure says of the places themselves: halves drawn at random, halves on
either side of a line, and, from real compounds, other halves of one place and of another.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.ground.buildings.built import BuiltBuilding, BuiltScene, frames_of, to_frames
from scenewright.ground.likeness.excess import Excess, find_excess
from scenewright.ground.likeness.features import FAR, ROWS, measure_scene

Floats = NDArray[np.float64]
SAME_PLACE, OTHER_PLACE = 0.18, 0.39
"""The excess that three quarters of the halves of one real compound stay below, and the median of
two compounds (``scenewright bench extend``; 46 compounds of 16 buildings and more)."""
FEWEST = 4
"""Fewer buildings say nothing of a place."""
TOLD = 6
CONGRUENT, LEVEL = 0.97, 0.3
"""The share of two footprints, and the metres of height, from which one copies the other."""
RESTS = 8
"""Random halvings the ruler is a median of."""


class RulerMark(NamedTuple):
    """One mark of the ruler: what it is of, and its excess of what, how and both."""

    name: str
    what: float
    how: float

    @property
    def whole(self) -> float:
        """The mean of what and how."""
        return (self.what + self.how) / 2


class PlaceComparison(NamedTuple):
    """Two places compared: names, counts, the excess, the ruler, the share of the buildings of the
    second that copy one of the first, the verdict, and lines on what differs most."""

    names: tuple[str, str]
    counts: tuple[int, int]
    excess: Excess
    ruler: tuple[RulerMark, ...]
    copied: float
    verdict: str
    words: tuple[str, ...]


def compare_places(one: BuiltScene, other: BuiltScene, seed: int = 0) -> PlaceComparison:
    """Compare two scenes of at least :data:`FEWEST` buildings each."""
    first, second = measure_scene(one), measure_scene(other)
    excess = find_excess(first, second, seed)
    ruler = [*_ruler(one, first, seed), *_ruler(other, second, seed)]
    return PlaceComparison(
        (one.name or "first", other.name or "second"),
        (len(one.buildings), len(other.buildings)),
        excess,
        tuple(ruler),
        share_copied(one.buildings, other.buildings),
        judge_excess(excess),
        tell_differences(excess, first, second),
    )


def judge_excess(excess: Excess) -> str:
    """The excess in words.

    >>> judge_excess(Excess(0.0, 0.1, ())), judge_excess(Excess(0.9, 0.8, ()))
    ('as alike as two halves of one place', 'another place')
    """
    if excess.whole <= SAME_PLACE:
        return "as alike as two halves of one place"
    return "between one place and another" if excess.whole < OTHER_PLACE else "another place"


def _ruler(scene: BuiltScene, measured: dict[str, Floats], seed: int) -> list[RulerMark]:
    """Random halves, and halves on either side of a line, of one scene."""
    count = len(scene.buildings)
    if count < 2 * FEWEST:
        return []
    rng = np.random.default_rng(seed)
    halves = []
    for _ in range(RESTS):
        order = rng.permutation(count)
        halves.append(_between(measured, order[: count // 2], order[count // 2 :]))
    what, how = (float(np.median([getattr(h, side) for h in halves])) for side in ("what", "how"))
    a, b = split_halves(scene.buildings)
    parts = [
        measure_scene(scene._replace(buildings=tuple(scene.buildings[k] for k in rows)))
        for rows in (a, b)
    ]
    aside = find_excess(parts[0], parts[1], seed)
    name = scene.name or "scene"
    return [
        RulerMark(f"random halves of {name}", what, how),
        RulerMark(f"one side and the other of {name}", aside.what, aside.how),
    ]


def _between(measured: dict[str, Floats], a: NDArray[np.int64], b: NDArray[np.int64]) -> Excess:
    return find_excess(
        {name: values[a] for name, values in measured.items()},
        {name: values[b] for name, values in measured.items()},
    )


def split_halves(buildings: Sequence[BuiltBuilding]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The buildings on either side of a line across the longest extent of a place, halves.

    >>> row = [BuiltBuilding(str(k), "", np.array([[k, 0], [k + 1, 0], [k, 1.0]]), 3.0)
    ...        for k in range(6)]
    >>> [part.tolist() for part in split_halves(row)]
    [[0, 1, 2], [3, 4, 5]]
    """
    middles = np.array([one.outline.mean(0) for one in buildings])
    centred = middles - middles.mean(0)
    axis = np.linalg.svd(centred, full_matrices=False)[2][0]
    axis = axis * (1.0 if axis[int(np.argmax(np.abs(axis)))] > 0 else -1.0)
    order = np.argsort(np.round(centred @ axis, 9), kind="stable")
    half = len(order) // 2
    return np.sort(order[:half]), np.sort(order[half:])


def share_copied(one: Sequence[BuiltBuilding], other: Sequence[BuiltBuilding]) -> float:
    """The share of the buildings of ``other`` that have the footprint and height of one of
    ``one``, turned anyhow."""
    if not one or not other:
        return 0.0
    first, second = (_own_frames(rows) for rows in (one, other))
    copies = 0
    for shape, height, sides in zip(*second, strict=True):
        near = np.flatnonzero(
            (np.abs(first[2] - sides).max(1) < 0.4) & (np.abs(first[1] - height) < LEVEL)
        )
        copies += any(_congruent(shape, first[0][k]) for k in near.tolist())
    return copies / len(other)


def _own_frames(rows: Sequence[BuiltBuilding]) -> tuple[list[shapely.Polygon], Floats, Floats]:
    frames = frames_of([one._replace(heading=None) for one in rows])
    shapes, sides = [], []
    for row, box in zip(rows, frames.boxes, strict=True):
        local = to_frames(row.outline, box[None])
        if box[3] < box[4]:
            local = np.stack([local[:, 1], -local[:, 0]], 1)
        shapes.append(shapely.Polygon(local))
        sides.append(sorted(box[3:].tolist()))
    return shapes, frames.heights, np.array(sides)


def _congruent(one: shapely.Polygon, other: shapely.Polygon) -> bool:
    for sx, sy in ((1, 1), (-1, -1), (-1, 1), (1, -1)):
        turned = shapely.transform(other, lambda c, sx=sx, sy=sy: c * (sx, sy))
        shared = shapely.intersection(one, turned).area
        if shared >= CONGRUENT * max(one.area, other.area):
            return True
    return False


def tell_differences(
    excess: Excess, first: dict[str, Floats], second: dict[str, Floats]
) -> tuple[str, ...]:
    """What differs most beyond chance, in words with medians."""
    rows = {row.name: row for row in ROWS}
    found = sorted(excess.features, key=lambda one: -one.excess)
    lines = []
    for one in (f for f in found[:TOLD] if f.excess > SAME_PLACE):
        a, b = (float(np.nanmedian(measured[one.name])) for measured in (first, second))
        lines.append(_line(rows[one.name].words, rows[one.name].unit, a, b))
    return tuple(lines)


def _line(words: str, unit: str, a: float, b: float) -> str:
    if unit == "m":
        shown = [f"{v:.1f} m" if v < FAR else "none within 60 m" for v in (a, b)]
        if abs(b - a) < 0.05:
            return f"{words} spread differently (median {shown[0]} in both)"
        return f"{words} {abs(b - a):.1f} m {'more' if b > a else 'less'} ({shown[0]} → {shown[1]})"
    if unit == "log m²":
        return f"{words} {'larger' if b > a else 'smaller'} ({np.exp(a):.0f} → {np.exp(b):.0f} m²)"
    if unit == "share":
        return f"{words} {'more' if b > a else 'less'} ({a:.0%} → {b:.0%})"
    if unit == "rad":
        if round(np.rad2deg(a)) == round(np.rad2deg(b)):
            return f"{words} spread differently (median {np.rad2deg(a):.0f}° in both)"
        return f"{words} differ ({np.rad2deg(a):.0f}° → {np.rad2deg(b):.0f}°)"
    return f"{words} differ"
