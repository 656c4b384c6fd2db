"""Streets, plots and fronts of villages and extensions, and of real places rebuilt.

Shares over all scenes: fronts to the way, dead ends, walks, plots, the rims of squares,
outbuildings, roofs that crash, walls that lead nowhere; coverage beside the real one for ten places
(each filled by a style that has not learned from it, told its streets alone) and for halves of real
towns that are continued.
Time is the processor's.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

import numpy as np
import shapely

import scenewright as sw
from benchmarks.extend_seams import SeamFigures, add_figures, seam_figures
from benchmarks.facades import BLANK, COUNT, count_blank_models, count_faults
from benchmarks.ground_faults import fault_counts
from benchmarks.ground_measures import Ground, counts_of, read_ground
from benchmarks.ground_places import Place, extension_places, village_places
from benchmarks.real_data import skipped
from scenewright.catalog.assets.buildings.house_looks import LOOKS
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.core.scene import GroundSurface, Piece
from scenewright.domains import plan_of, scene_of

Record = dict[str, Any]
Progress = Callable[[float, str], None]
VILLAGES = ("village-hamlet", "village-street", "village-dense")
GROWN = ("extend-terrace", "extend-court", "extend-village")
QUICK_FACADES = 20
CLOSE = 0.2
"""By which share coverage may differ from the real one and be like it."""


def records(quick: bool, progress: Progress | None = None) -> Iterator[Record]:
    """Records of facades, of samples, of real places, and of extensions."""
    heard = progress or (lambda _share, _words: None)
    yield from _facades(quick, heard)
    samples = [Place(name, sw.read(f"sample:{name}"), None) for name in VILLAGES]
    yield from _records("villages", samples, heard)
    samples = [Place(name, sw.read(f"sample:{name}"), None) for name in GROWN]
    yield from _records("extensions", samples, heard)
    try:
        yield from _records("real villages", village_places(quick), heard)
        yield from _records("real extensions", extension_places(quick), heard)
    except InputError as fault:
        yield skipped("real places", fault)


def _facades(quick: bool, heard: Progress) -> Iterator[Record]:
    """Facades with a fault over random footprints, of every style; wide models that are blank."""
    for number, style in enumerate(LOOKS):
        heard(0.5 * number / len(LOOKS), f"facades: {style}")
        count = QUICK_FACADES if quick else COUNT
        faults = count_faults(style, count=count)
        for name, value in faults._asdict().items():
            yield _record(f"facades, {style}", name.replace("_", " "), float(value), None, count)
    blank, of = count_blank_models()
    yield _record("facades", f"models blank at {BLANK:g} m", float(blank), None, of)


def _records(group: str, places: Iterable[Place], heard: Progress) -> Iterator[Record]:
    """The measures of a group, and of every place whose real coverage is known."""
    sums: dict[str, np.ndarray] = {}
    halves: list[tuple[SeamFigures, SeamFigures]] = []
    took, faults, like, told, number = 0.0, 0, 0, 0, 0
    for place in places:
        number += 1
        heard(0.5, f"{group}: {place.name}")
        begun = time.process_time()
        try:
            solution = sw.solve(place.brief, preset="quick")
        except Exception as crash:  # a crash is a record, and the rest is still measured
            faults += 1
            yield _record(f"{group}, {place.name}", f"crash: {crash!r}"[:160], 1.0, 0.0, 1)
            continue
        took += time.process_time() - begun
        faults += not sw.check(solution).valid
        counts = measure(solution)
        for name, row in counts.items():
            sums[name] = sums.get(name, np.zeros(2)) + row
        if solution.brief.domain == "extend":
            halves.append(seam_figures(solution))
        if place.coverage is not None:
            share = counts["coverage"][0] / counts["coverage"][1]
            told += 1
            like += abs(share / place.coverage - 1) <= CLOSE
            yield _record(f"{group}, {place.name}", "coverage", share, place.coverage, 1)
    for name, (part, whole) in sums.items():
        yield _record(group, name, part / whole if whole else float("nan"), None, int(whole))
    if halves:
        old, new = (add_figures(side) for side in zip(*halves, strict=True))
        for name, real in old.items():
            yield _record(group, name, new[name], real, len(halves))
    if told:
        yield _record(group, "places of like coverage", like / told, None, told)
    yield _record(group, "scenes with faults", float(faults), None, number)
    yield _record(group, "processor seconds", took, None, number)


def measure(solution: sw.Solution) -> dict[str, tuple[float, float]]:
    """Every measure and fault of a solved village or extension as how many of how many."""
    surfaces = scene_of(solution, plan_of(solution.brief)).surfaces
    _, stood = _split_houses(solution)
    ground = ground_of(solution, surfaces)
    return {**counts_of(ground), **fault_counts(ground, stood, surfaces)}


def _split_houses(solution: sw.Solution) -> tuple[list[Piece], list[Piece]]:
    """The houses that are new in a scene, and those of a source."""
    old = {"source"} if solution.brief.domain == "extend" else set()
    houses = [p for p in solution.pieces if p.category == "building"]
    return [p for p in houses if p.space not in old], [p for p in houses if p.space in old]


def ground_of(solution: sw.Solution, surfaces: Sequence[GroundSurface]) -> Ground:
    """The ground of a solved village or extension, of what is new there."""
    houses, _ = _split_houses(solution)
    squares = [shapely.Polygon(corners(np.array([one.box]))[0]) for one in solution.patches]
    return read_ground(
        houses, surfaces, squares, lanes_of(solution), plots_of(solution), _floors(solution.brief)
    )


def lanes_of(solution: sw.Solution) -> list[tuple[shapely.LineString, float]]:
    """The lanes that were laid, as lines with widths."""
    rows = [row for row in solution.detail or () if hasattr(row, "line")]
    return [(shapely.LineString(row.line), row.width) for row in rows]


def plots_of(solution: sw.Solution) -> dict[str, shapely.Polygon]:
    """The plots by the house they are of."""
    return {row.house: shapely.Polygon(row.outline) for row in sw.plots_of(solution)}


def _floors(brief: Brief) -> list[shapely.Polygon]:
    rows = brief.part.blocks if brief.domain == "village" else brief.part.areas
    return [shapely.Polygon(row.outline) for row in rows]


def _record(case: str, metric: str, value: float, real: float | None, runs: int) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": "s" if "seconds" in metric else "1",
        "ours": round(value, 4),
        "baseline": None if real is None else round(real, 4),
        "baseline_name": "" if real is None else "real",
        "ratio": round(value / real, 3) if real else None,
        "runs": runs,
    }
