"""Photographs by Blender's path tracer Cycles: our scene, cameras and light, our film.

Blender is a program of its own, run once for all views. It is handed the scene as ``.nodes.glb``
and a list of views, and hands back linear light, colours and normals of each, which are denoised
and developed as our own are.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from scenewright.core.catalog import Catalog
from scenewright.core.errors import InputError
from scenewright.formats.glb import encode_scene
from scenewright.render.observations.world import VisibleWorld
from scenewright.render.photo.denoising import take_out_noise
from scenewright.render.photo.developing import develop
from scenewright.render.photo.following import PANE, Exposure
from scenewright.render.photo.photograph import Photo, View, views_of

PROGRAM, INSTALL = (
    "blender",
    "install it (Debian: apt-get install blender python3-numpy), or leave --photo out",
)
SCRIPT = Path(__file__).with_name("cycles_script.py")
DONE = "scenewright view "
"""What the script prints before the number of a view that is done."""
Json = dict[str, Any]


def photograph_by_cycles(
    world: VisibleWorld,
    catalog: Catalog,
    rooms: frozenset[str],
    hour: str,
    size: tuple[int, int],
    samples: int,
    seed: int,
) -> Iterator[Photo]:
    """As :func:`scenewright.render.photo.photograph.photograph`, by Blender. Raises
    :class:`InputError` where Blender is not there or gives up."""
    program = find_program()
    views = [*views_of(world, catalog, rooms, hour, size, seed)]
    with tempfile.TemporaryDirectory(prefix="scenewright-") as name:
        folder = Path(name)
        scene = folder / "scene.glb"
        scene.write_bytes(encode_scene(world.scene, catalog, batched=False))
        job = folder / "job.json"
        job.write_text(json.dumps(job_of(views, scene, samples, seed)), encoding="utf-8")
        for number in _run(program, job) if views else ():
            planes = [np.load(folder / f"{number}-{plane}.npy") for plane in Exposure._fields]
            film = Exposure(*(np.ascontiguousarray(plane[..., :3]) for plane in planes))
            yield Photo(views[number].space, develop(take_out_noise(film)))


def find_program() -> str:
    """Where Blender is; :class:`InputError` with the line that installs it."""
    found = shutil.which(PROGRAM)
    if found is None:
        raise InputError("--photo cycles needs the program Blender, which is not found", INSTALL)
    return found


def job_of(views: Sequence[View], scene: Path, samples: int, seed: int) -> Json:
    """What Blender is asked: metres, z up, kilolux and kilocandela."""
    listed = [_view(view) for view in views]
    return {"scene": str(scene), "samples": samples, "seed": seed, "views": listed}


def _view(view: View) -> Json:
    camera, light = view.camera, view.sources
    lamps = light.sources[light.sources[:, 5] > 0]
    panes = light.sources[light.sources[:, 5] <= 0]
    left, top, step = (float(value) for value in camera.frame)
    return {
        "size": [camera.width, camera.height],
        "eye": camera.eye.tolist(),
        "axes": camera.axes.tolist(),
        "wide": 2 * float(np.arctan(-left)),
        "shift": (top / (camera.height * step) - 0.5) * camera.height / camera.width,
        "sun": {"to": light.sun[2].tolist(), "light": light.sun[3].tolist()},
        "sky": light.sky.tolist(),
        "pane": PANE,
        "lamps": [{"at": r[2:5], "radius": r[5], "light": r[6:9]} for r in lamps.tolist()],
        "portals": [{"at": r[2:5], "out": r[6:8], "size": r[8:10]} for r in panes.tolist()],
    }


def _run(program: str, job: Path) -> Iterator[int]:
    """The numbers of views as Blender ends them."""
    words = ["-b", "--factory-startup", "-noaudio", "--python-exit-code", "1"]
    command = [program, *words, "--python", str(SCRIPT), "--", str(job)]
    told: list[str] = []
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
    ) as running:
        try:
            for line in running.stdout or ():
                if line.startswith(DONE):
                    yield int(line.removeprefix(DONE))
                told = [*told[-20:], line.strip()]
        finally:
            if running.poll() is None and running.stdout and not running.stdout.closed:
                running.terminate()
    if running.returncode:
        fault = next((line for line in reversed(told) if "Error" in line), f"{running.returncode}")
        raise InputError(f"Blender gave up: {fault}", "try another version of it, 3.4 or later")
