"""Slicing trees over rectangles: where their rooms lie, and what is wrong with them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.measures import HAIR
from scenewright.engine.draws import bell, below, uniform
from scenewright.geometry.compiled import compiled

Floats = NDArray[np.float64]
Whole = NDArray[np.int64]
SIDE_BY_SIDE, STACKED = -1, -2
"""Operators of a Polish expression: a cut across x, a cut across y."""
LEAST_WEIGHT, MOST_WEIGHT = 0.5, 2.0
"""Bounds of a room's weight, of the area it wants."""


@compiled
def place_rooms(
    parts: Floats, tokens: Whole, lengths: Whole, weights: Floats, nodes: Floats, boxes: Floats
) -> None:
    """Rectangles ``boxes`` (n, 4) of the rooms of the trees of all ``parts`` (k, 4), each x0, y0,
    x1, y1.

    ``tokens`` (k, m) are the trees in postfix order, ``lengths`` (k,) their lengths; a cut
    divides its rectangle by the summed ``weights`` (n,) on either side. ``nodes`` (m, 7) is
    scratch: the weight below a token, its left child, its rectangle, its first token.
    """
    for p in range(len(parts)):
        last = lengths[p] - 1
        for i in range(last + 1):
            token = tokens[p, i]
            if token >= 0:
                nodes[i, 0], nodes[i, 1] = weights[token], i
            else:
                left = int(nodes[i - 1, 6]) - 1
                nodes[i, 0] = nodes[i - 1, 0] + nodes[left, 0]
                nodes[i, 1] = left
            nodes[i, 6] = i if token >= 0 else nodes[int(nodes[i, 1]), 6]
        for c in range(4):
            nodes[last, 2 + c] = parts[p, c]
        for i in range(last, -1, -1):
            token = tokens[p, i]
            if token >= 0:
                for c in range(4):
                    boxes[token, c] = nodes[i, 2 + c]
                continue
            left = int(nodes[i, 1])
            share = nodes[left, 0] / nodes[i, 0]
            for c in range(2, 6):
                nodes[left, c] = nodes[i - 1, c] = nodes[i, c]
            axis = 0 if token == SIDE_BY_SIDE else 1
            cut = nodes[i, 2 + axis] + share * (nodes[i, 4 + axis] - nodes[i, 2 + axis])
            nodes[left, 4 + axis] = cut
            nodes[i - 1, 2 + axis] = cut


@compiled
def measure_contacts(boxes: Floats, contacts: Floats, sides: Floats) -> None:
    """Metres of border (n, n) that rooms share, and of each room's ``sides`` (n, 4: west, south,
    east, north) those along no other room."""
    count = len(boxes)
    contacts[:] = 0.0
    for i in range(count):
        for axis in range(2):
            length = boxes[i, 3 - axis] - boxes[i, 1 - axis]
            sides[i, axis] = length
            sides[i, axis + 2] = length
    for i in range(count):
        for j in range(count):
            if i == j:
                continue
            for axis in range(2):  # j lies on the high side of i along this axis
                if abs(boxes[i, axis + 2] - boxes[j, axis]) > HAIR:
                    continue
                low = max(boxes[i, 1 - axis], boxes[j, 1 - axis])
                high = min(boxes[i, 3 - axis], boxes[j, 3 - axis])
                if high - low > HAIR:
                    contacts[i, j] = contacts[j, i] = high - low
                    sides[i, axis + 2] -= high - low
                    sides[j, axis] -= high - low


@compiled
def judge(
    boxes: Floats,
    wanted: Floats,
    rooms: Floats,
    joins: Whole,
    lit_sides: Floats,
    contacts: Floats,
    sides: Floats,
) -> tuple[float, float]:
    """The cost of a plan, and what of it breaks a rule (0: a plan that can be lived in).

    ``rooms`` (n, 5) holds each room's least width between middle lines, the most its length is to
    its width, the metres of outer wall it needs for light and, of an entrance hall, for its door,
    and those of border it must share with one of the rooms of ``joins`` (n, 2; -1: none).
    ``lit_sides`` (4,) is 1 where the outline may have windows.
    """
    cost, broken = 0.0, 0.0
    measure_contacts(boxes, contacts, sides)
    for i in range(len(boxes)):
        width, depth = boxes[i, 2] - boxes[i, 0], boxes[i, 3] - boxes[i, 1]
        narrow, long = min(width, depth), max(width, depth)
        cost += 4.0 * (width * depth / wanted[i] - 1.0) ** 2
        cost += 2.0 * max(0.0, long / narrow - rooms[i, 1])
        broken += max(0.0, rooms[i, 0] - narrow) / rooms[i, 0]
        broken += 0.5 * max(0.0, long / narrow - 1.5 * rooms[i, 1])
        lit, outer = 0.0, 0.0
        for side in range(4):
            lit = max(lit, sides[i, side] * lit_sides[side])
            outer = max(outer, sides[i, side])
        if rooms[i, 2] > 0.0:
            broken += max(0.0, rooms[i, 2] - lit) / rooms[i, 2]
        if rooms[i, 3] > 0.0:
            broken += max(0.0, rooms[i, 3] - outer) / rooms[i, 3]
        if joins[i, 0] >= 0:
            shared = contacts[i, joins[i, 0]]
            if joins[i, 1] >= 0:
                cost += 1.5 * (shared < rooms[i, 4])
                shared = max(shared, contacts[i, joins[i, 1]])
            broken += max(0.0, rooms[i, 4] - shared) / rooms[i, 4]
    return cost + 30.0 * broken, broken


@compiled
def propose(
    tokens: Whole, lengths: Whole, weights: Floats, wanted: Floats, stream: NDArray[np.uint64]
) -> None:
    """Change trees in place: two rooms change places, a cut turns, a room and a cut change places
    where the expression stays normal, or a room takes more or less of the floor."""
    p = below(stream, len(lengths))
    i = below(stream, lengths[p])
    kind = uniform(stream)
    if kind < 0.35:
        q = below(stream, len(lengths))
        j = below(stream, lengths[q])
        if tokens[p, i] >= 0 and tokens[q, j] >= 0:
            tokens[p, i], tokens[q, j] = tokens[q, j], tokens[p, i]
    elif kind < 0.55:
        if tokens[p, i] < 0:
            tokens[p, i] = SIDE_BY_SIDE + STACKED - tokens[p, i]
    elif kind < 0.75:
        if i + 1 < lengths[p] and (tokens[p, i] < 0) != (tokens[p, i + 1] < 0):
            tokens[p, i], tokens[p, i + 1] = tokens[p, i + 1], tokens[p, i]
            pending = 0
            for k in range(lengths[p]):
                pending += 1 if tokens[p, k] >= 0 else -1
                if pending < 1:
                    tokens[p, i], tokens[p, i + 1] = tokens[p, i + 1], tokens[p, i]
                    break
    else:
        room = below(stream, len(weights))
        weight = weights[room] * np.exp(0.25 * bell(stream))
        weights[room] = min(max(weight, LEAST_WEIGHT * wanted[room]), MOST_WEIGHT * wanted[room])
