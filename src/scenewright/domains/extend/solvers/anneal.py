"""Annealing at the end, by moves that keep rows: on statistics alone rows would break.

A whole row slides along itself, a building slides along its row, another of about its width takes
its place with the front where it was, the one that agrees least with its neighbours goes and a
proposal of others comes. A move counts by the whole layout, its coverage and the W₁ of its
features; Kirkpatrick, Gelatt and Vecchi 1983, with a temperature that falls to nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from scenewright.domains.extend.prepared import prepared_of
from scenewright.domains.extend.problem import Floats, GrownLayout
from scenewright.domains.extend.rating import measure_grown, misfit_of
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.domains.extend.solvers.neighbours import proposals_of, worth_of
from scenewright.ground.buildings.built import BuiltFrames, from_frames
from scenewright.ground.buildings.rows import find_rows

LARGEST = 160
"""Buildings up to which a layout is annealed: each move measures all of them."""
HOT = 0.02
"""Energy that is given up at the start as often as not."""
ROWS = 0.1
"""What a neighbour at its place counts against the misfit of features."""
SLIDE = 3.0
"""Metres a row or a building slides at most, as a standard deviation."""


class UndoneMove(NamedTuple):
    """What takes a move back: buildings that were elsewhere, that were removed and added."""

    moved: tuple[tuple[int, Floats, int], ...] = ()
    removed: tuple[int, ...] = ()
    added: tuple[int, ...] = ()


Move = Callable[[Canvas, np.random.Generator], "UndoneMove | None"]


def anneal(
    canvas: Canvas,
    rng: np.random.Generator,
    steps: int,
    cancelled: Callable[[], bool] = lambda: False,
    hear: Callable[[GrownLayout], None] = lambda _: None,
) -> GrownLayout:
    """The best layout of ``steps`` moves, or of those made until ``cancelled``; ``hear`` is given
    each that is better than all before."""
    best = canvas.layout()
    if len(canvas.movable()) < 3 or len(best.poses) > LARGEST:
        return best
    source = prepared_of(canvas.problem).measured
    energy = least = _energy(canvas, source, best)
    moves: tuple[Move, ...] = (slide_row, slide_one, replace_one, move_worst, move_worst)
    for step in range(steps):
        if cancelled():
            break
        undo = moves[int(rng.integers(len(moves)))](canvas, rng)
        if undo is None:
            continue
        made = canvas.layout()
        now = _energy(canvas, source, made)
        heat = HOT * (1 - step / steps) + 1e-9
        if now <= energy or rng.random() < np.exp(-(now - energy) / heat):
            energy = now
            if now < least:
                best, least = made, now
                hear(best)
        else:
            take_back(canvas, undo)
    return best


def _energy(canvas: Canvas, source: Mapping[str, Floats], layout: GrownLayout) -> float:
    """Misfit of features and coverage missed, less how well neighbours agree."""
    problem = canvas.problem
    rows = canvas.movable()
    worth = [worth_of(canvas, canvas.boxes[k, :3], int(canvas.origin[k]), int(k)) for k in rows]
    short = abs(canvas.covered - canvas.wanted) / max(canvas.wanted, 1.0)
    short = short if problem.number is None else 0.0
    return (
        misfit_of(source, measure_grown(problem, layout))
        + 2.0 * short
        - ROWS * float(np.mean(worth))
    )


def take_back(canvas: Canvas, undo: UndoneMove) -> None:
    """Undo a move."""
    for number in undo.added:
        canvas.remove(number)
    for number in undo.removed:
        canvas.restore(number)
    for number, pose, origin in undo.moved:
        canvas.move(number, pose, origin)


def slide_row(canvas: Canvas, rng: np.random.Generator) -> UndoneMove | None:
    """All buildings of a row move along it by the same distance."""
    rows = canvas.movable()
    frames = BuiltFrames(canvas.boxes[rows], canvas.shapes[rows], np.ones(len(rows)))
    found = find_rows(frames)
    if not found:
        return None
    row = found[int(rng.integers(len(found)))]
    members = rows[list(row.members)].tolist()
    step = np.array([rng.normal(0, SLIDE), 0.0])
    before = tuple((k, canvas.boxes[k, :3].copy(), int(canvas.origin[k])) for k in members)
    for number, pose, origin in before:
        moved = pose.copy()
        moved[:2] = from_frames(step, np.array([*pose[:2], row.heading, 1.0, 1.0]))
        canvas.move(number, moved, origin)
    if all(_stands(canvas, number) for number in members):
        return UndoneMove(moved=before)
    take_back(canvas, UndoneMove(moved=before))
    return None


def slide_one(canvas: Canvas, rng: np.random.Generator) -> UndoneMove | None:
    """A building moves along its front."""
    rows = canvas.movable()
    number = int(rng.choice(rows))
    box, origin = canvas.boxes[number].copy(), int(canvas.origin[number])
    moved = box[:3].copy()
    moved[:2] = from_frames(np.array([rng.normal(0, SLIDE), 0.0]), box)
    if not canvas.legal(moved[None], np.array([origin]), number)[0]:
        return None
    canvas.move(number, moved, origin)
    return UndoneMove(moved=((number, box[:3], origin),))


def replace_one(canvas: Canvas, rng: np.random.Generator) -> UndoneMove | None:
    """Another building takes the place of one, its front on the same line."""
    pattern = canvas.problem.pattern
    number = int(rng.choice(canvas.movable()))
    box, origin = canvas.boxes[number].copy(), int(canvas.origin[number])
    width = pattern.boxes[:, 3]
    near = np.flatnonzero(np.abs(np.log(width / width[origin])) < 0.35)
    other = int(rng.choice(near))
    if pattern.kind[other] == pattern.kind[origin]:
        return None
    step = np.array([0.0, (pattern.boxes[origin, 4] - pattern.boxes[other, 4]) / 2])
    moved = np.array([*from_frames(step, box), box[2]])
    if not canvas.legal(moved[None], np.array([other]), number)[0]:
        return None
    canvas.move(number, moved, other)
    return UndoneMove(moved=((number, box[:3], origin),))


def move_worst(canvas: Canvas, rng: np.random.Generator) -> UndoneMove | None:
    """One of those that agree least with their neighbours goes; what another proposes comes."""
    rows = canvas.movable()
    few = rng.choice(rows, min(4, len(rows)), replace=False).tolist()
    worth = [worth_of(canvas, canvas.boxes[k, :3], int(canvas.origin[k]), k) for k in few]
    number = few[int(np.argmin(worth))]
    canvas.remove(number)
    asking = int(rng.choice(np.flatnonzero(canvas.there & (canvas.origin >= 0))))
    poses, origins = proposals_of(canvas, asking)
    good = [
        k
        for k in np.flatnonzero(canvas.legal(poses, origins)).tolist()
        if canvas.room_for(int(origins[k]))
    ]
    if not good:
        canvas.restore(number)
        return None
    values = [worth_of(canvas, poses[k], int(origins[k])) for k in good]
    best = good[int(np.argmax(values))]
    added = canvas.add(poses[best], int(origins[best]), "neighbour")
    return UndoneMove(removed=(number,), added=(added,))


def _stands(canvas: Canvas, number: int) -> bool:
    pose, origin = canvas.boxes[number, :3], canvas.origin[number : number + 1]
    return bool(canvas.legal(pose[None], origin, number)[0])
