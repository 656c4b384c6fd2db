"""Generated homes and halls in MuJoCo: do they load, stand still and open? ``bench mujoco``.

Every scene is written as ``.mjcf.xml`` and loaded. It stands for five seconds in steps of 4 ms: how
many of its free bodies are then more than 2 cm or 3 degrees from where they were placed. Then,
from all shut, one joint after the other is pushed by what a hand can (leaves of doors by 25 N m,
hinges of furniture by 8 N m, slides by 40 N) for up to two seconds: leaves to 80 degrees, fronts of
furniture to 80 % of their travel. Times are processor seconds. Needs the extra ``mujoco``.
"""

from __future__ import annotations

import statistics
import tempfile
from collections.abc import Iterator
from pathlib import Path
from time import process_time
from typing import Any, NamedTuple

import numpy as np

import mujoco
from benchmarks.generated_scenes import Progress, Record, measure_scenes
from scenewright.core.solution import Solution
from scenewright.formats import write

STEPS = 200
"""Steps of the search for a layout."""
STAND, PUSH = 1250, 500
"""Steps of the simulation that a scene stands for, and that one joint is pushed for at most."""
FAR, TURNED = 0.02, np.deg2rad(3.0)
LEAF, SHARE = np.deg2rad(80.0), 0.8
PUSHED = 25.0
"""What a leaf is pushed by, in N m: 30 N at its handle."""
HAND = {mujoco.mjtJoint.mjJNT_HINGE: 8.0, mujoco.mjtJoint.mjJNT_SLIDE: 40.0}
FRONTS = ("door", "drawer", "flap", "panel")


class SimulatedScene(NamedTuple):
    """A scene in MuJoCo: seconds to write it and of simulation a second, free bodies and the names
    of those that moved, leaves and fronts and the names of those that did not open."""

    writing: float
    speed: float
    free: int
    moved: tuple[str, ...]
    leaves: int
    stuck_leaves: tuple[str, ...]
    fronts: int
    stuck_fronts: tuple[str, ...]


def records(
    quick: bool = False, progress: Progress | None = None, count: int | None = None
) -> Iterator[Record]:
    """Records of homes and of halls; ``count`` homes and a fifth as many halls."""
    return measure_scenes(simulate, _tally, STEPS, quick, progress, count)


def simulate(solution: Solution) -> SimulatedScene:
    """Write a scene twice, the second time by the clock; load it, let it stand, push what opens."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.mjcf.xml"
        write(solution, path)
        before = process_time()
        write(solution, path)
        writing = process_time() - before
        model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    free, moved, speed = _stand(model, data)
    leaves, fronts = list_joints(model)
    stuck = (
        tuple(_name(model, j) for j in js if not opens(model, data, j)) for js in (leaves, fronts)
    )
    stuck_leaves, stuck_fronts = stuck
    return SimulatedScene(
        writing, speed, free, moved, len(leaves), stuck_leaves, len(fronts), stuck_fronts
    )


def _stand(model: Any, data: Any) -> tuple[int, tuple[str, ...], float]:
    """The free bodies, those that moved, and seconds of simulation a second."""
    mujoco.mj_resetDataKeyframe(model, data, 0)
    loose = [j for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE]
    rows = np.array([model.jnt_qposadr[j] + np.arange(7) for j in loose], int).reshape(-1, 7)
    start, before = data.qpos[rows].copy(), process_time()
    for _ in range(STAND):
        mujoco.mj_step(model, data)
    speed = STAND * model.opt.timestep / max(process_time() - before, 1e-6)
    end = data.qpos[rows]
    away = np.linalg.norm(end[:, :3] - start[:, :3], axis=1)
    turned = 2 * np.arccos(np.clip(np.abs((end[:, 3:] * start[:, 3:]).sum(1)), 0, 1))
    moved = np.flatnonzero(~((away <= FAR) & (turned <= TURNED)))
    return len(loose), tuple(_name(model, loose[k]) for k in moved), speed


def list_joints(model: Any) -> tuple[list[int], list[int]]:
    """The joints of leaves of doors, and of fronts of furniture."""
    leaves, fronts = [], []
    for joint in range(model.njnt):
        words = _name(model, joint).split()
        if "leaf" in words:
            leaves.append(joint)
        elif any(word in words for word in FRONTS) and "free" not in words:
            fronts.append(joint)
    return leaves, fronts


def opens(model: Any, data: Any, joint: int) -> bool:
    """Whether a joint comes as far as it should, pushed from where all is shut."""
    mujoco.mj_resetDataKeyframe(model, data, 1)
    leaf = "leaf" in _name(model, joint).split()
    target = LEAF if leaf else SHARE * model.jnt_range[joint, 1]
    row, column = model.jnt_qposadr[joint], model.jnt_dofadr[joint]
    force = PUSHED if leaf else HAND[mujoco.mjtJoint(int(model.jnt_type[joint]))]
    for _ in range(PUSH):
        data.qfrc_applied[column] = force
        mujoco.mj_step(model, data)
        if data.qpos[row] >= target:
            return True
    return False


def _name(model: Any, joint: int) -> str:
    return str(model.joint(joint).name)


def _tally(case: str, found: list[SimulatedScene]) -> Iterator[Record]:
    runs = len(found)
    free, leaves, fronts = (
        sum(getattr(o, key) for o in found) for key in ("free", "leaves", "fronts")
    )
    moved = sum(len(one.moved) for one in found)
    stuck_leaves = sum(len(one.stuck_leaves) for one in found)
    stuck_fronts = sum(len(one.stuck_fronts) for one in found)
    yield _row(case, "loaded", "", runs, runs, runs)
    shares = (
        ("free bodies", "moved", moved, free, 1.0),
        ("leaves", "opened to 80 degrees", leaves - stuck_leaves, leaves, 99.0),
        ("fronts", "opened to 80 %", fronts - stuck_fronts, fronts, 99.0),
    )
    for what, share, part, whole, aim in shares:
        yield _row(case, what, "", whole, None, runs)
        if whole:
            yield _row(case, f"{what}: {share}", "%", round(100 * part / whole, 2), aim, runs)
    speed = round(statistics.median(one.speed for one in found), 1)
    yield _row(case, "simulated in a second, median", "s", speed, None, runs)
    writing = round(statistics.median(one.writing for one in found), 2)
    yield _row(case, "writing, median", "s of processor", writing, 2.0, runs)


def _row(
    case: str, metric: str, unit: str, ours: float, baseline: float | None, runs: int
) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": ours,
        "baseline": baseline,
        "baseline_name": "" if baseline is None else "aim",
        "ratio": None if not baseline else round(ours / baseline, 2),
        "runs": runs,
    }
