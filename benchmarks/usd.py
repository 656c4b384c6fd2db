"""USD of generated homes and halls: valid, whole, and how long it takes. ``scenewright bench usd``.

Every scene is written as ``.usdc``, opened again by OpenUSD, judged by all its validators
(``pxr.UsdValidation``) and counted: bodies, joints, lamps and materials against those of the scene.
Times are processor seconds of writing a scene that is arranged, all compiled.
"""

from __future__ import annotations

import statistics
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from time import process_time
from typing import NamedTuple

from pxr import Usd, UsdLux, UsdPhysics, UsdShade, UsdValidation

from benchmarks.generated_scenes import Progress, Record, measure_scenes
from scenewright.catalog.loading import catalog_of
from scenewright.core.solution import Solution
from scenewright.domains import scene_of
from scenewright.formats import write
from scenewright.formats.simulation.masses import is_free
from scenewright.render.bodies import split_bodies
from scenewright.render.items import things
from scenewright.render.lamps import lamps_of
from scenewright.render.observations.ceilings import ceilings

STEPS = 200
COUNTED = ("bodies", "joints", "lamps", "materials")
AIM = {"homes": 3.0, "halls": None}
"""Seconds that writing a home may take."""


class WrittenScene(NamedTuple):
    """A scene as written: seconds, kilobytes, what the validators found, and the counts of the
    scene and of the file."""

    seconds: float
    kilobytes: float
    faults: int
    wanted: Counter[str]
    found: Counter[str]


def records(
    quick: bool = False, progress: Progress | None = None, count: int | None = None
) -> Iterator[Record]:
    """Records of homes and of halls; ``count`` homes and a fifth as many halls."""
    return measure_scenes(measure, _tally, STEPS, quick, progress, count)


def measure(solution: Solution) -> WrittenScene:
    """Write a scene twice, the second time by the clock, and look at what was written."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.usdc"
        write(solution, path)
        before = process_time()
        write(solution, path)
        seconds = process_time() - before
        stage = Usd.Stage.Open(str(path))
        registry = UsdValidation.ValidationRegistry()
        context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
        faults = len(context.Validate(stage))
        kilobytes = path.stat().st_size / 1024
        return WrittenScene(seconds, kilobytes, faults, count_scene(solution), count_stage(stage))


def count_scene(solution: Solution) -> Counter[str]:
    """What a scene has."""
    scene, catalog = scene_of(solution), catalog_of(solution.brief.catalogs)
    items = [one for one in (*things(scene, catalog), *ceilings(scene)) if one.parts]
    joints = sum(len(split_bodies(item.parts)[1]) for item in items)
    free = sum(is_free(item, catalog) for item in items)
    materials = len({part.material for item in items for part in item.parts})
    lamps = len([*lamps_of(items, catalog)])
    return Counter(bodies=joints + free, joints=joints, lamps=lamps, materials=materials)


def count_stage(stage: Usd.Stage) -> Counter[str]:
    """What a stage has, by the library that engines load scenes with where it knows of it."""
    loaded = UsdPhysics.UsdPhysicsLoadStageFromPrimRange(stage, ["/"])
    number = {str(kind).rpartition(".")[2]: len(found[0]) for kind, found in loaded.items()}
    prims = [*stage.Traverse()]
    return Counter(
        bodies=number.get("RigidBody", 0),
        joints=number.get("RevoluteJoint", 0) + number.get("PrismaticJoint", 0),
        lamps=sum(prim.IsA(UsdLux.SphereLight) for prim in prims),
        materials=sum(prim.IsA(UsdShade.Material) for prim in prims),
    )


def _tally(case: str, written: list[WrittenScene]) -> Iterator[Record]:
    runs, aim = len(written), AIM[case]
    seconds = [one.seconds for one in written]
    yield _row(case, "validators' errors", "", sum(one.faults for one in written), 0, runs)
    for name in COUNTED:
        found = sum(one.found[name] for one in written)
        yield _row(case, name, "", found, sum(one.wanted[name] for one in written), runs)
    differ = sum(one.found != one.wanted for one in written)
    yield _row(case, "scenes whose counts differ", "", differ, 0, runs)
    median = round(statistics.median(seconds), 2)
    yield _row(case, "writing, median", "s of processor", median, aim, runs)
    yield _row(case, "writing, slowest", "s of processor", round(max(seconds), 2), aim, runs)
    size = round(statistics.median(one.kilobytes for one in written))
    yield _row(case, "size, median", "kB", size, None, runs)


def _row(
    case: str, metric: str, unit: str, ours: float, baseline: float | None, runs: int
) -> Record:
    ratio = None if not baseline else round(ours / baseline, 2)
    name = "" if baseline is None else "aim" if unit or not baseline else "of the scenes"
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": ours,
        "baseline": baseline,
        "baseline_name": name,
        "ratio": ratio,
        "runs": runs,
    }
