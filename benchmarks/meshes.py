"""Models of generated homes and halls against each other. ``scenewright bench meshes``.

Every scene is arranged and judged as it is drawn, furniture alone and, in homes, as it is lived in
(:mod:`scenewright.workflow.meshes`): pairs of models more than 5 mm in each other, doors and
drawers that do not open all the way, small objects by room and how many of them stand
(:mod:`scenewright.clutter.stability`). The shipped models are looked at once, at their usual
size: their triangles, and which of their meshes are open.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from statistics import mean, median
from typing import NamedTuple

from benchmarks.generated_scenes import Progress, Record, measure_scenes
from scenewright.catalog.assets import shipped
from scenewright.catalog.loading import catalog_of
from scenewright.check.solids import is_closed
from scenewright.clutter.stability import measure_standing
from scenewright.core.scene import CLUTTER
from scenewright.core.solution import Solution
from scenewright.domains import scene_of
from scenewright.domains.hall.furnishing.varied import ALIKE
from scenewright.workflow.meshes import MeshReport, check_meshes

STEPS = 300
GROUNDS = ("building", "house")
"""Kinds that are no furniture."""
LEAST = 3
"""Pieces on the floor from which a room counts as furnished."""
WORDS = ("pieces", "solids", "bodies that open")


class JudgedScene(NamedTuple):
    """A scene as furnished and as lived in, its small objects by furnished room, how many of them
    stand, and how often its commonest model is placed in a hall, seats and tables apart."""

    bare: MeshReport
    full: MeshReport | None
    by_room: tuple[int, ...]
    standing: int
    most: int = 0


def records(
    quick: bool = False, progress: Progress | None = None, count: int | None = None
) -> Iterator[Record]:
    """Records of the models, of homes and of halls; ``count`` homes and a fifth as many halls."""
    yield from _models()
    yield from measure_scenes(judge, _tally, STEPS, quick, progress, count)


def judge(solution: Solution) -> JudgedScene:
    """The models of a solution's scene, bare and lived in."""
    bare = check_meshes(solution)
    if solution.brief.domain != "home":
        return JudgedScene(bare, None, (), 0, commonest(solution))
    full = replace(solution, clutter="lived-in")
    scene = scene_of(full)
    small = [piece for piece in scene.pieces if piece.function == CLUTTER]
    furnished = Counter(piece.space for piece in solution.pieces if piece.pose.z < 0.01)
    on = Counter(piece.space for piece in small)
    by_room = tuple(on[space] for space, pieces in furnished.items() if pieces >= LEAST)
    catalog = catalog_of(solution.brief.catalogs)
    standing = sum(one.stable for one in measure_standing(scene, catalog))
    return JudgedScene(bare, check_meshes(full), by_room, standing)


def commonest(solution: Solution) -> int:
    """How often one model is placed in one room at most, but for what stands in rows of its like
    (seats, desks, tables)."""
    placed = Counter(
        (piece.space, piece.asset) for piece in solution.pieces if piece.category not in ALIKE
    )
    return max(placed.values(), default=0)


def _models() -> Iterator[Record]:
    """The shipped models of furniture at their usual size."""
    triangles, unclosed = [], 0
    for asset in shipped().assets.values():
        if asset.category in GROUNDS:
            continue
        parts = asset.mesh(asset.usual)
        triangles.append(sum(len(part.faces) for part in parts))
        unclosed += not all(is_closed(part.vertices, part.faces) for part in parts)
    yield _record("models", "shipped", "", len(triangles), None, 1)
    yield _record("models", "with an open mesh", "", unclosed, 0, 1)
    yield _record("models", "triangles, median", "", round(median(triangles)), None, 1)


def _tally(case: str, judged: list[JudgedScene]) -> Iterator[Record]:
    count = len(judged)
    for name, reports in (
        ("furniture", [one.bare for one in judged]),
        ("lived in", [one.full for one in judged if one.full is not None]),
    ):
        if not reports:
            continue
        for word, values in zip(WORDS, zip(*(r[2:5] for r in reports), strict=True), strict=True):
            yield _record(f"{case}, {name}", word, "", sum(values), None, count)
        pairs = sum(len(report.findings) for report in reports)
        yield _record(f"{case}, {name}", "pairs deeper than 5 mm", "", pairs, 0, count)
        said = sum(len(report.said) for report in reports)
        yield _record(f"{case}, {name}", "bodies that do not open, said", "", said, None, count)
        unclosed = sum(len(report.open) for report in reports)
        yield _record(f"{case}, {name}", "pieces with an open mesh", "", unclosed, 0, count)
    most = [one.most for one in judged if one.most]
    if most:
        yield _record(case, "one model in a hall, most", "", max(most), 6, count)
        above = sum(number > 6 for number in most)
        yield _record(case, "halls with a model more than 6 times", "", above, 0, count)
    rooms = [number for one in judged for number in one.by_room]
    if rooms:
        whole = sum(rooms)
        standing = sum(one.standing for one in judged) / max(sum(_small(one) for one in judged), 1)
        yield _record(case, "small objects a furnished room, mean", "", mean(rooms), 40, count)
        yield _record(case, "furnished rooms with 40 or more", "%", _share(rooms), None, count)
        yield _record(case, "small objects", "", whole, None, count)
        yield _record(case, "small objects that stand", "%", 100 * standing, 100, count)


def _share(rooms: list[int]) -> float:
    return 100 * sum(number >= 40 for number in rooms) / len(rooms)


def _small(one: JudgedScene) -> int:
    return one.full.pieces - one.bare.pieces if one.full is not None else 0


def _record(case: str, metric: str, unit: str, ours: float, aim: float | None, runs: int) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(ours, 1),
        "baseline": aim,
        "baseline_name": "aim" if aim is not None else "",
        "ratio": None,
        "runs": runs,
    }
