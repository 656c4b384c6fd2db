"""Rows that the brief draws: strings of kinds laid along a line, their fronts on it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.errors import InputError
from scenewright.domains.extend.brief import DrawnRow
from scenewright.domains.extend.pattern import GapRules, SourcePattern
from scenewright.domains.extend.problem import Floats
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.geometry.folding import parse, unfold
from scenewright.ground.buildings.rows import PASSAGE

TOUCHING = GapRules(0.0, 0.0, 0.0)
"""The gap rules of drawn rows: they may stand as near as drawn."""
WIDE = 3.0
"""Metres of a passage."""


class RowToLay(NamedTuple):
    """A row to lay: the numbers of buildings of the sources in order (-1: a passage), the line
    their fronts stand on, and the gap between them in metres."""

    origins: tuple[int, ...]
    line: Floats
    gap: float


def read_row(row: DrawnRow, pattern: SourcePattern, place: str) -> RowToLay:
    """A row of the brief as numbers of buildings; InputError, with its place, for a text that is
    no string, or a kind there is not."""
    try:
        symbols = unfold(parse(row.pattern))
    except ValueError as error:
        raise InputError(str(error), 'write it as "(A B)^3 C"', place=place) from None
    first = {
        kind.letter: int(np.flatnonzero(pattern.kind == k)[0])
        for k, kind in enumerate(pattern.kinds)
    }
    for symbol in symbols:
        if symbol != PASSAGE and symbol not in first:
            known = ", ".join(list(first)[:20])
            raise InputError(f"there is no kind '{symbol}'", f"use one of: {known}", place=place)
    origins = tuple(-1 if s == PASSAGE else first[s] for s in symbols)
    gap = max(pattern.gaps.side, 0.0) if row.gap is None else row.gap
    return RowToLay(origins, np.array(row.line, float), gap)


def lay_rows(canvas: Canvas) -> int:
    """Lay all rows of the problem; how many buildings they came to."""
    made = 0
    for row in canvas.problem.rows:
        line, at = shapely.LineString(row.line), 0.0
        for origin in row.origins:
            if origin < 0:
                at += WIDE
                continue
            wide = float(canvas.problem.pattern.boxes[origin, 3])
            if at + wide > line.length + 1e-6:
                break
            pose = pose_on(line, at + wide / 2, float(canvas.problem.pattern.boxes[origin, 4]))
            if canvas.legal(pose[None], np.array([origin]), gaps=TOUCHING)[0]:
                canvas.add(pose, origin, "row")
                made += 1
            at += wide + row.gap
    return made


def pose_on(line: shapely.LineString, at: float, deep: float) -> Floats:
    """The pose (3,) of a building ``deep`` metres deep whose front stands on a line, ``at`` metres
    from its start; it stands to the left of the line and looks to the right.

    >>> pose_on(shapely.LineString([(0, 0), (20, 0)]), 5.0, 8.0).round(3).tolist()
    [5.0, 4.0, -1.571]
    """
    ends = [line.interpolate(max(at - 0.5, 0.0)), line.interpolate(at + 0.5)]
    step = np.diff(shapely.get_coordinates(ends), axis=0)[0]
    way = step / max(float(np.hypot(*step)), 1e-9)
    left = np.array([-way[1], way[0]])
    spot = shapely.get_coordinates(line.interpolate(at))[0] + left * deep / 2
    return np.array([*spot, np.arctan2(-left[1], -left[0])])
