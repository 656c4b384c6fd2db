"""The grammar of a scene or a facade, after Zhang and Fei (2017, section 1.2), from geometry.

    LayoutConstruction → (Front)(Border){Group_0 … Group_N−1}(Back)
    OrgGroup → {Feature_0 … Feature_K−1}
    UnitFeature → {A_0 … A_S−1}
    Array A → {E_0 … E_T−1}

Of a scene: a feature is a row, or a lone building; groups are the leaves of the box
abstraction of features; a feature's arrays are its stretches between passages; the elements of an
array are kinds of buildings, folded under stars. Front and back are what bounds a scene along its
longer direction, the border what bounds it across. Of a tower: front and back are its lowest and
highest slab, what lies between is one group of one array. What is parsed can be unfolded again to
as many elements, or to more: sideways along a row, upwards by storeys.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.layout import corners
from scenewright.geometry.folding import Folded, fold, show, stretch, unfold
from scenewright.ground.buildings.abstraction import abstract_boxes, leaves_of, total_value
from scenewright.ground.buildings.built import BuiltFrames, from_frames, to_frames
from scenewright.ground.buildings.rows import PASSAGE, BuildingRow, find_rows, string_of

Floats = NDArray[np.float64]
OUTER = 0.15
"""The share of the extent from either end within which a building bounds a scene."""


class ElementArray(NamedTuple):
    """Array A → {E}: a folded string of elements without a passage."""

    elements: Folded


class UnitFeature(NamedTuple):
    """A row, or a lone building: arrays between passages."""

    arrays: tuple[ElementArray, ...]


class OrgGroup(NamedTuple):
    """A group of features that belong together."""

    features: tuple[UnitFeature, ...]


class LayoutConstruction(NamedTuple):
    """A layout: elements at the ``front``, along the ``border`` and at the ``back``; the groups;
    and the symmetry value (20) of its hierarchy (0 where it has none)."""

    front: tuple[str, ...]
    border: tuple[str, ...]
    groups: tuple[OrgGroup, ...]
    back: tuple[str, ...]
    symmetry: float = 0.0


def parse_scene(frames: BuiltFrames, letters: Sequence[str]) -> LayoutConstruction:
    """The layout of buildings (n,) with the letters of their kinds.

    >>> from scenewright.ground.buildings.built import BuiltBuilding, frames_of
    >>> ring = np.array([[0, 0], [8, 0], [8, 6], [0, 6.0]])
    >>> row = [BuiltBuilding("", "", ring + (11.0 * k, 0), 6.0) for k in range(4)]
    >>> show_layout(parse_scene(frames_of(row), "AABA"))[-1]
    'A0 → {A B A A}'
    """
    rows = find_features(frames)
    node = abstract_boxes(np.array([_box_about(frames, members) for members, _ in rows]))
    groups = []
    for part in leaves_of(node):
        strings = [_string(rows[k], letters) for k in part]
        groups.append(OrgGroup(tuple(map(_feature, strings))))
    front, border, back = _bounds(frames, letters)
    return LayoutConstruction(front, border, tuple(groups), back, total_value(node))


FeatureMembers = tuple[tuple[int, ...], BuildingRow | None]


def find_features(frames: BuiltFrames) -> list[FeatureMembers]:
    """The members of every row, each building in one at most, and lone buildings."""
    found, seen = list[FeatureMembers](), set[int]()
    for row in find_rows(frames):
        if not seen & set(row.members):
            seen |= set(row.members)
            found.append((row.members, row))
    return [*found, *(((k,), None) for k in range(len(frames.boxes)) if k not in seen)]


def _string(feature: FeatureMembers, letters: Sequence[str]) -> tuple[str, ...]:
    members, row = feature
    return tuple(letters[k] for k in members) if row is None else string_of(row, letters)


def _box_about(frames: BuiltFrames, members: Sequence[int]) -> Floats:
    """The box (5,) about some buildings, turned as the first is."""
    box = frames.boxes[members[0]]
    local = to_frames(corners(frames.boxes[list(members)]).reshape(-1, 2), box[None])
    low, high = local.min(0), local.max(0)
    return np.array([*from_frames((low + high) / 2, box), box[2], *(high - low)])


def _feature(symbols: Sequence[str]) -> UnitFeature:
    parts = [list(g) for passage, g in groupby(symbols, lambda s: s == PASSAGE) if not passage]
    return UnitFeature(tuple(ElementArray(fold(part)) for part in parts))


def _bounds(
    frames: BuiltFrames, letters: Sequence[str]
) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """The features at the front, along the border and at the back."""
    usual = float(np.angle(np.exp(4j * frames.boxes[:, 2]).mean())) / 4
    frame = np.array([*frames.boxes[:, :2].mean(0), usual, 1.0, 1.0])
    local = to_frames(frames.boxes[:, :2], frame)
    extent = np.maximum(np.ptp(local, axis=0), 1e-9)
    at = (local - local.min(0)) / extent
    along = int(extent[1] > extent[0])
    front, back = at[:, along] <= OUTER, at[:, along] >= 1 - OUTER
    side = ~front & ~back & ((at[:, 1 - along] <= OUTER) | (at[:, 1 - along] >= 1 - OUTER))
    order = np.lexsort((at[:, 1 - along], at[:, along]))
    a, b, c = (
        tuple(letters[k] for k in order.tolist() if mask[k])
        for mask in (front, side, back & ~front)
    )
    return a, b, c


def parse_slabs(symbols: Sequence[str]) -> LayoutConstruction:
    """The layout of a tower or a front, slab by slab.

    >>> layout = parse_slabs("abcbcba")
    >>> layout.front, layout.back, show(layout.groups[0].features[0].arrays[0].elements)
    (('a',), ('a',), 'b (c b)^2')
    """
    if len(symbols) < 3:
        return LayoutConstruction(tuple(symbols), (), (), ())
    middle = OrgGroup((UnitFeature((ElementArray(fold(symbols[1:-1])),)),))
    return LayoutConstruction((symbols[0],), (), (middle,), (symbols[-1],))


def grow_layout(layout: LayoutConstruction, share: float) -> LayoutConstruction:
    """The layout with every array unfolded to ``share`` times its elements: rows longer, towers
    taller.

    >>> grown = grow_layout(parse_slabs("abcbcba"), 2.0)
    >>> "".join(unfold(grown.groups[0].features[0].arrays[0].elements))
    'bcbcbcbcb'
    """

    def longer(array: ElementArray) -> ElementArray:
        count = len(unfold(array.elements))
        return ElementArray(stretch(array.elements, max(round(count * share), 1)))

    return layout._replace(
        groups=tuple(
            OrgGroup(tuple(UnitFeature(tuple(map(longer, f.arrays))) for f in group.features))
            for group in layout.groups
        )
    )


def show_layout(layout: LayoutConstruction) -> list[str]:
    """The productions as lines of text, each thing named once."""
    known: dict[OrgGroup, str] = {}
    groups = show(fold([known.setdefault(g, f"Group{len(known)}") for g in layout.groups]))
    ends = [" ".join(part) for part in (layout.front, layout.border, layout.back)]
    lines = [f"LayoutConstruction → ({ends[0]}) ({ends[1]}) {{{groups}}} ({ends[2]})"]
    units: dict[UnitFeature, str] = {}
    arrays: dict[ElementArray, str] = {}
    for group, name in known.items():
        names = [units.setdefault(f, f"Feature{len(units)}") for f in group.features]
        lines.append(f"{name} → {{{show(fold(names))}}}")
    for unit, name in units.items():
        own = [arrays.setdefault(a, f"A{len(arrays)}") for a in unit.arrays]
        lines.append(f"{name} → {{{show(fold(own))}}}")
    lines += [f"{name} → {{{show(array.elements)}}}" for array, name in arrays.items()]
    return lines
