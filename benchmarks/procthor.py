"""Homes as houses of ProcTHOR: ``scenewright bench procthor``.

Generated homes are written as ``.procthor.json``, read back and compared: outlines of rooms, doors
and windows, and where objects stand; then the house that was read is arranged again.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from time import process_time
from typing import Any, NamedTuple

import numpy as np
import shapely

from benchmarks.generated_plans import asked_of
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution, unfurnished
from scenewright.domains import check, scene_of, solve
from scenewright.formats import read, write
from scenewright.workflow.generate import generate

Record = dict[str, Any]
Progress = Callable[[float, str], None]
USUAL, QUICK, STEPS = 50, 3, 200
AIM = 10.0
"""Millimetres."""
LOST = 1e6


class ReadBack(NamedTuple):
    """How far rooms, openings and objects are from where they were, in millimetres (:data:`LOST`
    where one is missing), the seconds writing takes, and whether the home arranged again is
    valid."""

    rooms: float
    openings: float
    objects: float
    seconds: float
    valid: bool


def records(
    quick: bool = False, progress: Progress | None = None, count: int | None = None
) -> Iterator[Record]:
    """The greatest differences over all homes, the share arranged again that is valid."""
    number = count or (QUICK if quick else USUAL)
    found = []
    for seed in range(number):
        if progress is not None:
            progress(seed / number, f"home {seed + 1} of {number}")
        found.append(measure(solve(generate("home", seed=seed, **asked_of(seed)), steps=STEPS)))
    for name in ("rooms", "openings", "objects"):
        worst = max(getattr(one, name) for one in found)
        yield _row(f"{name}, greatest difference", "mm", round(worst, 2), AIM, number)
    valid = 100 * sum(one.valid for one in found) / number
    yield _row("arranged again, valid", "%", round(valid, 1), 100.0, number)
    seconds = float(np.median([one.seconds for one in found]))
    yield _row("writing, median", "s of processor", round(seconds, 3), None, number)


def measure(solution: Solution) -> ReadBack:
    """Write a home, read it with its objects and compare; read it without and arrange it again."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "home.procthor.json"
        before = process_time()
        write(solution, path)
        seconds = process_time() - before
        kept = read(path, keep=True)
        again = solve(read(path), steps=STEPS)
    there = scene_of(unfurnished(kept))
    rooms, openings = compare_shells(scene_of(solution), there)
    placed = {item.id: item for room in kept.rooms for item in room.fixed}
    objects = max((_away(piece, placed) for piece in solution.pieces), default=0.0)
    return ReadBack(1000 * rooms, 1000 * openings, 1000 * objects, seconds, check(again).valid)


def compare_shells(one: Scene, two: Scene) -> tuple[float, float]:
    """How far outlines of rooms and how far openings are apart, in metres."""
    spaces = {space.id: space for space in two.spaces}
    rooms = [
        shapely.hausdorff_distance(
            shapely.Polygon(space.outline), shapely.Polygon(spaces[space.id].outline)
        )
        if space.id in spaces
        else LOST
        for space in one.spaces
    ]
    known = {opening.id: opening for opening in two.openings}
    apart = [
        max(
            abs(getattr(opening, side) - getattr(known[opening.id], side))
            for side in ("x", "y", "width", "sill", "head")
        )
        if opening.id in known
        else LOST
        for opening in one.openings
    ]
    return max(rooms), max(apart, default=0.0)


def _away(piece: Any, placed: dict[str, Any]) -> float:
    item = placed.get(piece.id)
    if item is None:
        return 0.0 if piece.function == "stairs" else LOST
    return float(np.abs(np.subtract((*item.at, item.z), piece.pose[:3])).max())


def _row(metric: str, unit: str, ours: float, baseline: float | None, runs: int) -> Record:
    return {
        "case": "homes",
        "metric": metric,
        "unit": unit,
        "ours": ours,
        "baseline": baseline,
        "baseline_name": "" if baseline is None else "aim",
        "ratio": None if not baseline else round(ours / baseline, 4),
        "runs": runs,
    }
