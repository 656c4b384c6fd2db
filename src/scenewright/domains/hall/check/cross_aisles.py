"""Whether rows are broken by the aisles across that a brief asks for."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from scenewright.core.brief import Room
from scenewright.core.brief.zones import AisleBrief
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.hall.demands.checked import ids_of

SLACK = 0.05
"""Metres by which an aisle may be narrower than asked for."""
ASKEW = 0.05
"""Sine of the angle up to which two pieces of a row look the same way."""


def find_unbroken_rows(
    pieces: tuple[Piece, ...], spaces: tuple[Space, ...], asked: Mapping[str, Room]
) -> list[Finding]:
    """A finding for each demand with an ``aisle`` that has more pieces in an unbroken row than
    allowed; its size is how many metres the widest gap of the row is too narrow."""
    found = []
    for space in spaces:
        demands = asked[space.id].demands if space.id in asked else []
        for demand, name in zip(demands, ids_of(demands), strict=True):
            mine = [p for p in pieces if p.space == space.id and p.function == name]
            if demand.aisle is None or not mine:
                continue
            long = _longest_run(mine, demand.aisle)
            if len(long.pieces) > demand.aisle.every:
                text = f"{name}: {len(long.pieces)} stand in a row with no aisle of "
                ends = long.pieces[0].id, long.pieces[-1].id
                text += f"{demand.aisle.width:g} m in it"
                missing = round(demand.aisle.width - long.widest, 4)
                found.append(Finding("narrow_passage", space.level, space.id, *ends, text, missing))
    return found


class _Run(NamedTuple):
    """Pieces side by side, and the widest gap between two neighbours in metres."""

    pieces: tuple[Piece, ...]
    widest: float


def _longest_run(pieces: list[Piece], aisle: AisleBrief) -> _Run:
    """The most pieces in line without a gap as wide as an aisle."""
    poses = np.array([p.pose for p in pieces], float)
    sizes = np.array([p.size for p in pieces], float)
    left, best = np.arange(len(pieces)), _Run((), 0.0)
    while len(left):
        x, y, _, heading = poses[left[0]]
        c, s = np.cos(heading), np.sin(heading)
        off = poses[left, :2] - (x, y)
        parallel = np.abs(np.sin(poses[left, 3] - heading)) < ASKEW
        line = parallel & (np.abs(off @ (c, s)) < 0.5 * sizes[left[0], 1])
        line[0] = True
        along = off[line] @ (s, -c)
        order = np.argsort(along, kind="stable")
        rows, half = left[line][order], 0.5 * sizes[left[line][order], 0]
        gaps = (along[order][1:] - half[1:]) - (along[order][:-1] + half[:-1])
        cuts = [0, *(np.flatnonzero(gaps >= aisle.width - SLACK) + 1).tolist(), len(rows)]
        for a, b in pairwise(cuts):
            if b - a > len(best.pieces):
                widest = float(gaps[a : b - 1].max(initial=0.0))
                best = _Run(tuple(pieces[k] for k in rows[a:b]), widest)
        left = left[~line]
    return best
