"""The grammar of a source as growth unfolds it: its rows as strings, what is grouped with them."""

from __future__ import annotations

from collections import defaultdict
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.extend.problem import ExtendProblem, Floats, Indices
from scenewright.domains.extend.solvers.continued_rows import setback_of, union_streets
from scenewright.geometry.folding import Folded, fold
from scenewright.ground.buildings.built import BuiltFrames, from_frames, to_frames
from scenewright.ground.buildings.grammar import find_features
from scenewright.ground.buildings.rows import BuildingRow, string_of

ALONG = float(np.deg2rad(20.0))
"""How far a row may turn from the longer rows and still run along them."""
GROUPED = 25.0
"""Metres within which a lone building belongs to the group of an element of a row."""


class UnfoldedRow(NamedTuple):
    """A feature as it is unfolded: its folded string, the buildings of the sources that each of its
    symbols was read off, how far their fronts stand ``before`` the row's line and from the street,
    the gaps (metres) from one symbol to another, and its frame (5,): the left end of its line,
    heading, length, depth."""

    elements: Folded
    origins: dict[str, tuple[int, ...]]
    before: dict[int, float]
    setbacks: dict[int, float]
    gaps: dict[tuple[str, str], float]
    frame: Floats

    @property
    def usual(self) -> float:
        """The median gap."""
        return float(np.median(list(self.gaps.values()))) if self.gaps else 0.0


class SceneGrammar(NamedTuple):
    """A source as it is unfolded: rows along its longer rows; what is ``grouped`` with an element
    of them, as numbers of buildings and poses (3,) in its frame; the ``others``; its ``frame`` (5,)
    about all, x along the rows; and the gap between features."""

    rows: tuple[UnfoldedRow, ...]
    grouped: dict[int, tuple[tuple[int, Floats], ...]]
    others: tuple[int, ...]
    frame: Floats
    between: float


def read_grammar(problem: ExtendProblem, source: int) -> SceneGrammar:
    """The grammar of one source."""
    pattern = problem.pattern
    members = np.flatnonzero(pattern.source == source)
    boxes = pattern.boxes[members]
    frames = BuiltFrames(boxes, pattern.shapes[members], np.ones(len(members)))
    letters = [pattern.kinds[k].letter for k in pattern.kind[members]]
    features = find_features(frames)
    usual = _longer_rows(boxes, [row for _, row in features if row is not None])
    rows, others = list[UnfoldedRow](), list[int]()
    streets = union_streets(problem.source_roads[source])
    for numbers, row in features:
        if row is not None and abs(np.sin(row.heading - usual)) < np.sin(ALONG):
            rows.append(_read_row(boxes, row, letters, members, streets))
        else:
            others += members[list(numbers)].tolist()
    frame = _frame_about(boxes, usual)
    grouped, alone = _group_others(problem, rows, others)
    return SceneGrammar(tuple(rows), grouped, alone, frame, _gap_across(rows, frame, problem))


def _group_others(
    problem: ExtendProblem, rows: list[UnfoldedRow], others: list[int]
) -> tuple[dict[int, tuple[tuple[int, Floats], ...]], tuple[int, ...]]:
    """Each of some buildings with the nearest element of a row, and those far from all."""
    boxes, shapes = problem.pattern.boxes, problem.pattern.shapes
    elements = np.array([number for row in rows for number in row.before], np.int64)
    found = defaultdict[int, list[tuple[int, Floats]]](list)
    alone = list[int]()
    for number in others:
        away = np.asarray(shapely.distance(shapes[elements], shapes[number]))
        if not len(away) or away.min() > GROUPED:
            alone.append(number)
            continue
        owner = int(elements[away.argmin()])
        spot = to_frames(boxes[number, None, :2], boxes[owner, None])[0]
        pose = np.array([*spot, boxes[number, 2] - boxes[owner, 2]])
        found[owner].append((number, pose))
    return {owner: tuple(held) for owner, held in found.items()}, tuple(alone)


def _longer_rows(boxes: Floats, rows: list[BuildingRow]) -> float:
    """The heading that most buildings of rows have, up to half turns; of all where none is."""
    if not rows:
        return float(np.angle(np.exp(4j * boxes[:, 2]).mean())) / 4
    weight = np.array([len(row.members) for row in rows])
    heading = np.array([row.heading for row in rows])
    near = np.abs(np.sin(heading[:, None] - heading)) < np.sin(ALONG)
    best = int(np.argmax(near @ weight))
    mean = (weight * np.exp(2j * heading))[near[best]].sum()
    return float(np.angle(mean)) / 2


def _frame_about(boxes: Floats, heading: float) -> Floats:
    """The box (5,) about all boxes (n, 5), its front at a heading."""
    frame = np.array([*boxes[:, :2].mean(0), heading, 1.0, 1.0])
    turn = boxes[:, 2] - heading
    half = np.stack(
        [
            np.abs(boxes[:, 3] * np.cos(turn)) + np.abs(boxes[:, 4] * np.sin(turn)),
            np.abs(boxes[:, 3] * np.sin(turn)) + np.abs(boxes[:, 4] * np.cos(turn)),
        ],
        1,
    )
    local = to_frames(boxes[:, :2], frame)
    low, high = (local - half / 2).min(0), (local + half / 2).max(0)
    return np.array([*from_frames((low + high) / 2, frame), heading, *(high - low)])


def _read_row(
    boxes: Floats, row: BuildingRow, letters: list[str], members: Indices, streets: shapely.Geometry
) -> UnfoldedRow:
    rows = list(row.members)
    own = boxes[rows]
    frame = np.array([*own[0, :2], row.heading, 1.0, 1.0])
    local = to_frames(own[:, :2], frame)
    fronts = local[:, 1] + own[:, 4] / 2
    line, left = float(np.median(fronts)), float(local[0, 0] - own[0, 3] / 2)
    right = float(local[-1, 0] + own[-1, 3] / 2)
    origins, gaps = (
        defaultdict[str, list[int]](list),
        defaultdict[tuple[str, str], list[float]](list),
    )
    for number in rows:
        origins[letters[number]].append(int(members[number]))
    for (a, b), gap in zip(pairwise(rows), row.gaps, strict=True):
        gaps[letters[a], letters[b]].append(gap)
    before = {int(members[a]): float(f - line) for a, f in zip(rows, fronts, strict=True)}
    start = from_frames(np.array([left, line]), frame)
    return UnfoldedRow(
        fold(string_of(row, letters)),
        {letter: tuple(numbers) for letter, numbers in origins.items()},
        before,
        {int(members[a]): setback_of(boxes[a], streets) for a in rows},
        {pair: float(np.median(values)) for pair, values in gaps.items()},
        np.array([*start, row.heading, right - left, float(own[:, 4].max())]),
    )


def _gap_across(rows: list[UnfoldedRow], frame: Floats, problem: ExtendProblem) -> float:
    """The usual gap between features that run side by side; the least before a front if none."""
    spans = []
    for row in rows:
        at = to_frames(row.frame[None, :2], frame)[0, 1]
        same = np.cos(row.frame[2] - frame[2]) > 0
        spans.append((at - row.frame[4], at) if same else (at, at + row.frame[4]))
    spans.sort()
    gaps = [b[0] - a[1] for a, b in pairwise(spans) if b[0] > a[1]]
    return float(np.median(gaps)) if gaps else max(problem.pattern.gaps.front, 1.0)
