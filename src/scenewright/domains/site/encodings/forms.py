"""Planar forms of building groups: rows, courtyards, towers, in a rectangle of their own.

A form places boxes ``(k, 5)`` for ``sizes`` (k, 3) in a rectangle ``target`` (width, depth) whose
middle is the origin: x to the right, fronts to +y unless the form turns them. Neighbours keep
``spacing``; behind a row stays ``behind`` times its greatest height if that is more. Buildings
that find no room have no width. Zhang, Yang 2023, Figs. 8-11.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
FRONT, TURNED = 0.5 * math.pi, math.pi / 6
Target = tuple[float, float]
Place = Callable[[Floats, float, Target, float], Floats]


class FormRow(NamedTuple):
    """One form: its name, what it is, where it comes from, and what places it."""

    name: str
    about: str
    source: str
    place: Place


def _row(sizes: Floats, row: list[int], spacing: float) -> float:
    """Length of a row at its spacing."""
    return float(sizes[row, 0].sum()) + spacing * (len(row) - 1)


def split_rows(sizes: Floats, spacing: float, target: Target, behind: float) -> list[list[int]]:
    """The fewest rows that hold all buildings in their order, or as many as there is room for.

    >>> split_rows(np.full((5, 3), 10.0), 2.0, (34.0, 40.0), 0.0)
    [[0, 1, 2], [3, 4]]
    """
    rows: list[list[int]] = []
    left = [i for i in range(len(sizes)) if sizes[i, 0] <= target[0] + 1e-9]
    deep = 0.0
    while left:
        row: list[int] = []
        for i in left:
            fits = deep + float(sizes[i, 1]) <= target[1] + 1e-9
            if fits and _row(sizes, [*row, i], spacing) <= target[0] + 1e-9:
                row.append(i)
            elif row and fits:
                break
        if not row:
            break
        rows.append(row)
        left = [i for i in left if i not in row]
        tall = float(sizes[row, 2].max())
        deep += float(sizes[row, 1].max()) + max(spacing, behind * tall)
    return rows


def _set_rows(
    sizes: Floats,
    rows: list[list[int]],
    spacing: float,
    target: Target,
    behind: float,
    shift: float,
) -> Floats:
    """Rows from the front back, each spread over the width by at most twice the spacing; every
    other one moved by ``shift`` of half a place, as far as there is room."""
    boxes = np.zeros((len(sizes), 5))
    needs = [max(spacing, behind * float(sizes[row, 2].max())) for row in rows]
    used = sum(float(sizes[row, 1].max()) for row in rows) + sum(needs[:-1])
    more = min(max(target[1] - used, 0.0) / max(len(rows) - 1, 1), spacing)
    y = 0.5 * (used + more * (len(rows) - 1))
    for number, row in enumerate(rows):
        slack = target[0] - _row(sizes, row, spacing)
        gap = spacing + (0.0 if shift else min(slack / max(len(row) - 1, 1), spacing))
        length = _row(sizes, row, gap)
        place = 0.5 * float(sizes[row, 0].mean() + gap)
        off = shift * (0.5 if number % 2 else -0.5) * min(place, target[0] - length)
        x = -0.5 * length + off
        for i in row:
            w, d = float(sizes[i, 0]), float(sizes[i, 1])
            boxes[i] = x + 0.5 * w, y - 0.5 * d, FRONT, w, d
            x += w + gap
        y -= float(sizes[row, 1].max()) + needs[number] + more
    return boxes


def parallel(sizes: Floats, spacing: float, target: Target, behind: float = 0.0) -> Floats:
    """Rows one behind another, all facing the front.

    Boxes (k, 5) for ``sizes`` (k, 3), metres.
    """
    rows = split_rows(sizes, spacing, target, behind)
    return _set_rows(sizes, rows, spacing, target, behind, 0.0)


def lay_staggered(sizes: Floats, spacing: float, target: Target, behind: float = 0.0) -> Floats:
    """Rows, every other one shifted by half a place, so that each building looks between two.

    Boxes (k, 5) for ``sizes`` (k, 3), metres.
    """
    half = target[0] - 0.25 * float(sizes[:, 0].mean() + spacing) if len(sizes) else target[0]
    narrow = (max(half, float(sizes[:, 0].max(initial=0.0))), target[1])
    rows = split_rows(sizes, spacing, narrow, behind)
    return _set_rows(sizes, rows, spacing, target, behind, 1.0)


def rotate_boxes(boxes: Floats, angle: float, x: float, y: float) -> Floats:
    """Boxes turned about the origin and moved; those of no width stay so.

    ``boxes`` (k, 5), ``angle`` in radians, ``x`` and ``y`` in metres.
    """
    c, s = math.cos(angle), math.sin(angle)
    found = boxes.copy()
    found[:, 0] = boxes[:, 0] * c - boxes[:, 1] * s + x
    found[:, 1] = boxes[:, 0] * s + boxes[:, 1] * c + y
    found[:, 2] += angle
    return np.where(boxes[:, 3:4] > 0.0, found, 0.0)


def lay_rotated(sizes: Floats, spacing: float, target: Target, behind: float = 0.0) -> Floats:
    """Rows whose buildings are each turned by 30 degrees in their place.

    Boxes (k, 5) for ``sizes`` (k, 3), metres.
    """
    c, s = math.cos(TURNED), math.sin(TURNED)
    wide, deep = sizes[:, 0] * c + sizes[:, 1] * s, sizes[:, 0] * s + sizes[:, 1] * c
    boxes = parallel(np.column_stack([wide, deep, sizes[:, 2]]), spacing, target, behind)
    turned = np.column_stack([boxes[:, :2], boxes[:, 2] + TURNED, sizes[:, :2]])
    return np.where(boxes[:, 3:4] > 0.0, turned, 0.0)


def _join_parts(parts: list[tuple[NDArray[np.int64], Floats]], count: int) -> Floats:
    """One array of boxes from parts with their numbers."""
    boxes = np.zeros((count, 5))
    for numbers, part in parts:
        boxes[numbers] = part
    return boxes


def _halves(weights: Floats) -> tuple[NDArray[np.int64], NDArray[np.int64], float]:
    """The first and the last numbers, about half the weight each, and the share of the first."""
    total = np.cumsum(weights)
    cut = int(np.searchsorted(total, 0.5 * total[-1])) + 1
    cut = min(cut, len(weights) - 1) if len(weights) > 1 else len(weights)
    share = float(total[cut - 1] / total[-1])
    return np.arange(cut), np.arange(cut, len(weights)), share


def lay_spliced(sizes: Floats, spacing: float, target: Target, behind: float = 0.0) -> Floats:
    """Two groups of rows side by side, one of them turned by a quarter to face outwards.

    Boxes (k, 5) for ``sizes`` (k, 3), metres.
    """
    if not len(sizes):
        return np.zeros((0, 5))
    one, two, share = _halves((sizes[:, 0] + spacing) * (sizes[:, 1] + spacing))
    left = (target[0] - spacing) * share
    right = target[0] - spacing - left
    first = parallel(sizes[one], spacing, (left, target[1]), behind)
    second = parallel(sizes[two], spacing, (target[1], right), behind)
    return _join_parts(
        [
            (one, rotate_boxes(first, 0.0, 0.5 * (left - target[0]), 0.0)),
            (two, rotate_boxes(second, -FRONT, 0.5 * (target[0] - right), 0.0)),
        ],
        len(sizes),
    )


def _round(sizes: Floats, spacing: float, target: Target, sides: int) -> Floats:
    """Buildings along the sides of the target, fronts out: back, left and right, then front."""
    width, depth = target
    boxes, left = np.zeros((len(sizes), 5)), list(range(len(sizes)))
    deepest = float(sizes[:, 1].max(initial=0.0)) + spacing
    across = depth - 2.0 * deepest if sides == 4 else depth - deepest
    off = 0.0 if sides == 4 else 0.5 * deepest
    runs = [
        (width, math.pi, 0.0, -0.5 * depth),
        (across, FRONT, -0.5 * width, off),
        (across, -FRONT, 0.5 * width, off),
        (width, 0.0, 0.0, 0.5 * depth),
    ]
    if width < 2.0 * deepest - spacing or depth < 2.0 * deepest - spacing:
        return boxes
    around = sum(run[0] for run in runs[:sides])
    share = float((sizes[:, 0] + spacing).sum()) / max(around, 1e-9)
    for length, angle, x, y in runs[:sides]:
        row: list[int] = []
        for i in list(left):
            more = _row(sizes, [*row, i], spacing)
            enough = row and more > min(share, 1.0) * length + 0.5 * float(sizes[i, 0])
            if more > length + 1e-9 or enough:
                break
            row.append(i)
            left.remove(i)
        if row:
            boxes[row] = rotate_boxes(_along(sizes[row], spacing, length), angle, x, y)
    return boxes


def _along(sizes: Floats, spacing: float, length: float) -> Floats:
    """A row with its fronts on y = 0, facing +y, spread evenly over a length."""
    gap = spacing
    if len(sizes) > 1:
        gap += max(length - _row(sizes, list(range(len(sizes))), spacing), 0.0) / (len(sizes) - 1)
    boxes, x = np.zeros((len(sizes), 5)), -0.5 * _row(sizes, list(range(len(sizes))), gap)
    for i, (w, d) in enumerate(sizes[:, :2]):
        boxes[i] = x + 0.5 * w, -0.5 * d, FRONT, w, d
        x += w + gap
    return boxes


def peripheral(sizes: Floats, spacing: float, target: Target, behind: float = 0.0) -> Floats:  # noqa: ARG001
    """A closed courtyard: all round the target, fronts out.

    Boxes (k, 5) for ``sizes`` (k, 3), metres.
    """
    return _round(sizes, spacing, target, 4)


def half_closed(sizes: Floats, spacing: float, target: Target, behind: float = 0.0) -> Floats:  # noqa: ARG001
    """A courtyard open to the front: back and both sides.

    Boxes (k, 5) for ``sizes`` (k, 3), metres.
    """
    return _round(sizes, spacing, target, 3)


def point(sizes: Floats, spacing: float, target: Target, behind: float = 0.0) -> Floats:
    """Free-standing towers, each in the middle of its share of the target; in as many columns as
    let most of them fit, as near to square as may be.

    Boxes (k, 5) for ``sizes`` (k, 3), metres.
    """
    count = len(sizes)
    square = math.sqrt(count * target[0] / target[1])
    tried = sorted(range(1, count + 1), key=lambda columns: abs(columns - square))
    best = np.zeros((count, 5))
    for columns in tried:
        boxes = _towers(sizes, spacing, target, behind, columns)
        if (boxes[:, 3] > 0.0).sum() > (best[:, 3] > 0.0).sum():
            best = boxes
    return best


def _towers(sizes: Floats, spacing: float, target: Target, behind: float, columns: int) -> Floats:
    """Towers in ``columns`` columns, the last row in the middle."""
    count = len(sizes)
    boxes, rows = np.zeros((count, 5)), -(-count // columns)
    cell = np.array([target[0] / columns, target[1] / rows])
    gaps = np.column_stack([np.full(count, spacing), np.maximum(spacing, behind * sizes[:, 2])])
    fits = (sizes[:, :2] + gaps * [columns > 1, rows > 1] <= cell + 1e-9).all(1)
    for i in np.flatnonzero(fits):
        row, column = divmod(int(i), columns)
        last = count - columns * (rows - 1) if row == rows - 1 else columns
        x = (column - 0.5 * (last - 1)) * cell[0]
        y = (0.5 * (rows - 1) - row) * cell[1]
        boxes[i] = x, y, FRONT, *sizes[i, :2]
    return boxes


def lay_mixed(sizes: Floats, spacing: float, target: Target, behind: float = 0.0) -> Floats:
    """Low buildings in rows in front, the tall half as towers behind them.

    Boxes (k, 5) for ``sizes`` (k, 3), metres.
    """
    if not len(sizes):
        return np.zeros((0, 5))
    order = np.argsort(sizes[:, 2], kind="stable")
    areas = (sizes[order, 0] + spacing) * (sizes[order, 1] + spacing)
    one, two, share = _halves(areas)
    low, tall = order[one], order[two]
    between = max(spacing, behind * float(sizes[low, 2].max()))
    front = (target[1] - between) * share
    rear = target[1] - between - front
    rows = parallel(sizes[low], spacing, (target[0], front), behind)
    towers = point(sizes[tall], spacing, (target[0], max(rear, 1e-6)), behind)
    return _join_parts(
        [
            (low, rotate_boxes(rows, 0.0, 0.0, 0.5 * (target[1] - front))),
            (tall, rotate_boxes(towers, 0.0, 0.0, 0.5 * (rear - target[1]))),
        ],
        len(sizes),
    )


_PAPER = "Zhang, Yang 2023, "
_ROWS = (
    FormRow(
        "parallel", "rows one behind another, aligned", _PAPER + "Fig. 8, determinant", parallel
    ),
    FormRow(
        "staggered", "rows moved by half a place", _PAPER + "Fig. 9, determinant", lay_staggered
    ),
    FormRow(
        "spliced", "rows and rows turned by a quarter side by side", _PAPER + "Fig. 9", lay_spliced
    ),
    FormRow(
        "rotated", "rows of buildings turned in place", _PAPER + "Fig. 9, determinant", lay_rotated
    ),
    FormRow(
        "peripheral", "a closed courtyard, fronts to the streets", _PAPER + "Fig. 11", peripheral
    ),
    FormRow("half-closed", "a courtyard open to the front", _PAPER + "III-A", half_closed),
    FormRow("point", "free-standing towers", _PAPER + "III-A, point group", point),
    FormRow("mixed", "low rows in front, towers behind", _PAPER + "III-A", lay_mixed),
)
FORMS: dict[str, FormRow] = {row.name: row for row in _ROWS}
