"""How fast cameras see, and how exactly: ``scenewright bench observations``.

Ten views (three if quick) of 640 by 480 pixels are taken in a flat, a house of two floors and a
hall. Seconds are of the processor. The baseline is the caster of trimesh on the same triangles and
rays; pixels that differ from it by more than a millimetre, or see another thing, are counted. So
are those that differ from a search of all triangles in double precision, on views of 32 by 24.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks import stages
from benchmarks.slow_rays import meet_slowly
from scenewright.render.observations.views import (
    Lens,
    Viewpoint,
    camera_view,
    observe_view,
    pose_of,
)
from scenewright.render.observations.world import VisibleWorld
from scenewright.workflow.observe import Observations, observe

Record = dict[str, Any]
Floats = NDArray[np.float64]
SCENES = ("home-flat", "home-house", "hall-exhibition")
MASKS = frozenset(("depth", "instance", "semantic", "normals"))
COLOUR = MASKS | {"rgb"}
VIEWS, QUICK, STEPS, SEED = 10, 3, 500, 3
FOV = float(np.deg2rad(75.0))
LARGE, SMALL = Lens(640, 480, FOV), Lens(32, 24, FOV)
MILLIMETRE = 1e-3


def records(quick: bool = False, progress: stages.Progress | None = None) -> Iterator[Record]:
    """Views a second of one core, and differences, scene by scene."""
    named = [(name, partial(of_scene, name, QUICK if quick else VIEWS)) for name in SCENES]
    return stages.run_stages(named, progress)


def page_lines(records: list[Record]) -> Iterator[str]:
    """A row a scene."""
    yield "| | depth, masks, normals | with colour | trimesh, depth | other than it | than all |"
    yield "|---|---|---|---|---|---|"
    for case in dict.fromkeys(row["case"] for row in records):
        fast, colour, other, slow = (row for row in records if row["case"] == case)
        yield (
            f"| {case} | {fast['ours']:.1f} | {colour['ours']:.1f} | {fast['baseline']:.1f} "
            f"| {other['ours']:g} % | {slow['ours']:g} % |"
        )


def of_scene(name: str, count: int) -> Iterator[Record]:
    """The records of one scene."""
    made = observe(f"sample:{name}", cameras=count, steps=STEPS, seed=SEED)
    world = made.world
    observe_view(world, made.viewpoints[0], SMALL)  # what is compiled is not measured
    cast = _caster_of_trimesh(world)
    theirs = _rate(made, lambda one: cast(one, LARGE))
    for what, kinds in (("depth, masks, normals", MASKS), ("with colour", COLOUR)):
        ours = _rate(made, lambda one, k=kinds: observe_view(world, one, LARGE, k))  # type: ignore[misc]
        yield _record(
            name, f"{what}, 640 x 480", "views/s", ours, theirs, "trimesh (embree), depth", count
        )
    differ = [_differ(world, one, LARGE, *cast(one, LARGE)) for one in made.viewpoints]
    yield _record(name, "other than trimesh", "% of pixels", np.mean(differ), 0.1, "goal", count)
    differ = [_differ(world, one, SMALL, *_slowly(world, one)) for one in made.viewpoints]
    yield _record(
        name, "other than all triangles", "% of pixels", np.mean(differ), 0.1, "goal", count
    )


def _record(
    case: str, metric: str, unit: str, ours: Any, baseline: float, name: str, runs: int
) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(float(ours), 3),
        "baseline": round(baseline, 3),
        "baseline_name": name,
        "ratio": round(float(ours) / baseline, 2),
        "runs": runs,
        "seeds": str(SEED),
    }


def _rate(made: Observations, take: Callable[[Viewpoint], Any]) -> float:
    """Views a second of the processor."""
    begun = time.process_time()
    for one in made.viewpoints:
        take(one)
    return len(made.viewpoints) / (time.process_time() - begun)


Seen = tuple[Floats, NDArray[np.int64]]


def _caster_of_trimesh(world: VisibleWorld) -> Callable[[Viewpoint, Lens], Seen]:
    """Depth and instances of a view as trimesh finds them."""
    import trimesh
    from trimesh.ray.ray_pyembree import RayMeshIntersector

    corners = world.measured.corners.astype(np.float64).reshape(-1, 3)
    faces = np.arange(len(corners)).reshape(-1, 3)
    caster = RayMeshIntersector(trimesh.Trimesh(corners, faces, process=False))

    def cast(one: Viewpoint, lens: Lens) -> Seen:
        ways = _ways(one, lens)
        starts = np.broadcast_to(one.eye, ways.shape)
        points, rays, met = caster.intersects_location(starts, ways, multiple_hits=False)
        depth, seen = np.zeros(len(ways)), np.zeros(len(ways), np.int64)
        depth[rays] = (points - one.eye) @ pose_of(one)[:3, 2]
        seen[rays] = world.measured.keys[met]
        return depth, seen

    return cast


def _slowly(world: VisibleWorld, one: Viewpoint) -> Seen:
    """The same by trying every triangle (T. Moeller and B. Trumbore 1997)."""
    corners = world.measured.corners.astype(np.float64)
    away, met = meet_slowly(corners, np.array(one.eye), _ways(one, SMALL))
    return np.where(met >= 0, away, 0.0), np.where(met >= 0, world.measured.keys[met], 0)


def _ways(one: Viewpoint, lens: Lens) -> Floats:
    """Directions through all pixels, 1 long along the axis, as the renderer's rays."""
    axes = camera_view(one, lens).axes.astype(np.float64)
    u, v = np.meshgrid(np.arange(lens.width) + 0.5, np.arange(lens.height) + 0.5)
    x, y = (u - lens.width / 2) / lens.focal, (lens.height / 2 - v) / lens.focal
    ways: Floats = np.stack([x, y, np.ones_like(x)], -1).reshape(-1, 3) @ axes
    return ways


def _differ(
    world: VisibleWorld, one: Viewpoint, lens: Lens, depth: Floats, seen: NDArray[np.int64]
) -> float:
    """Percent of pixels whose depth differs by more than a millimetre or that see another thing."""
    found = observe_view(world, one, lens, MASKS)
    assert found.depth is not None
    assert found.instance is not None
    far = np.abs(found.depth.ravel() - depth) > MILLIMETRE
    return 100.0 * float((far | (found.instance.ravel() != seen)).mean())
