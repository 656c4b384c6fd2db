"""A folder of observations: pictures and arrays of every camera, and one JSON document of them.

All files appear together or none does.
"""

from __future__ import annotations

import json
import zipfile
from collections.abc import Iterable
from contextlib import suppress
from math import degrees
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from scenewright._version import __version__
from scenewright.core.atomic_file import TEMPORARY, whole_together
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.render.observations.views import Lens, Observation, Viewpoint, pose_of
from scenewright.render.observations.world import VisibleWorld

DOCUMENT = "observations.json"
FARTHEST = 65_535
"""Millimetres that a picture of depth holds at most."""
CONVENTIONS = {
    "units": "metres, degrees, pixels",
    "world": "right-handed, z up, levels at their elevation",
    "pose": "camera to world, 4 x 4 by rows; camera as in OpenCV: x right, y down, z ahead",
    "pixel": "u = fx X / Z + cx, v = fy Y / Z + cy; the middle of the first pixel is 0.5, 0.5",
    "depth": "along z of the camera, 0 where nothing is met; .npz metres, .png millimetres",
    "instance": "what a ray meets first, glass too; 0 nothing",
    "normals": "of the faces met, in the world, towards the camera",
}


class Taken(NamedTuple):
    """Cameras in a world, their lens, what is observed, the seed, and the solution it is of."""

    world: VisibleWorld
    viewpoints: tuple[Viewpoint, ...]
    lens: Lens
    kinds: tuple[str, ...]
    seed: int
    solution: Solution


def file_names(number: int, kinds: Iterable[str]) -> dict[str, str]:
    """The files of a camera: a picture of each kind, and the arrays.

    >>> file_names(7, ["rgb", "depth"])
    {'rgb': '0007.rgb.png', 'depth': '0007.depth.png', 'arrays': '0007.npz'}
    >>> file_names(7, ["rgb"])
    {'rgb': '0007.rgb.png'}
    """
    found = {kind: f"{number:04}.{kind}.png" for kind in kinds}
    return found | ({"arrays": f"{number:04}.npz"} if set(found) - {"rgb"} else {})


def check_folder(folder: Path, kinds: Iterable[str], count: int) -> None:
    """Raise :class:`InputError` unless a folder is new, empty, or holds only files that would be
    replaced."""
    listed = set[str]()
    try:
        listed.update(entry.name for entry in folder.iterdir())
    except FileNotFoundError:
        return
    except NotADirectoryError:
        raise InputError("is not a folder", "give the name of a folder", file=str(folder)) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"cannot be read: {reason}", "choose another", file=str(folder)) from None
    ours = {DOCUMENT, *(n for k in range(count) for n in file_names(k, kinds).values())}
    if others := sorted(n for n in listed - ours if not TEMPORARY.fullmatch(n)):
        fault = f"holds other files, such as {others[0][:80]}"
        raise InputError(fault, "give the name of a new folder", file=str(folder))


def write_observations(folder: Path, taken: Taken, views: Iterable[Observation]) -> None:
    """Write a folder: what each camera sees, and the document. ``views`` are in the order of the
    cameras; they are written as they come."""
    fresh = not folder.exists()
    names = [file_names(k, taken.kinds) for k in range(len(taken.viewpoints))]
    paths = [folder / name for row in names for name in row.values()]
    try:
        with whole_together([*paths, folder / DOCUMENT]) as partials:
            left = iter(partials)
            for view, row in zip(views, names, strict=True):
                for kind, partial in zip(row, left, strict=False):
                    _write_kind(view, kind, partial)
            partials[-1].write_text(_text(document_of(taken)), encoding="utf-8")
    except OSError as error:
        reason = error.strerror or str(error)
        raise InputError(
            f"cannot be written: {reason}", "choose another place", file=str(folder)
        ) from None
    finally:
        if fresh:
            with suppress(OSError):  # it is not empty: all went well
                folder.rmdir()


def _write_kind(view: Observation, kind: str, path: Path) -> None:
    """One file of a camera."""
    if kind == "arrays":
        _write_arrays(view, path)
    else:
        Image.fromarray(picture_of(view, kind)).save(path, format="png", compress_level=1)


def picture_of(view: Observation, kind: str) -> NDArray[Any]:
    """What a person sees of one kind: colours; depth in whole millimetres, 16 bits; a colour for
    each instance or class; normals from -1 … 1 to 0 … 255."""
    values: NDArray[Any] = getattr(view, kind)
    if kind == "depth":
        return np.minimum(np.rint(values * 1000.0), FARTHEST).astype(np.uint16)
    if kind == "normals":
        return np.rint((values + 1.0) * 127.5).astype(np.uint8)
    if kind in ("instance", "semantic"):
        mixed = np.arange(int(values.max()) + 1)[:, None] * (73, 151, 199)
        colours = (40 + mixed % 211).astype(np.uint8)
        colours[0] = 0
        return np.asarray(colours[values])
    return values


def _write_arrays(view: Observation, path: Path) -> None:
    """All but colour as a ``.npz``; the same arrays, the same bytes."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for kind in ("depth", "instance", "semantic", "normals"):
            values = getattr(view, kind)
            if values is not None:
                entry = zipfile.ZipInfo(f"{kind}.npy")
                entry.compress_type = zipfile.ZIP_DEFLATED
                with archive.open(entry, "w", force_zip64=True) as stream:
                    np.lib.format.write_array(stream, values, allow_pickle=False)


def document_of(taken: Taken) -> dict[str, Any]:
    """Intrinsics, poses and the table of instances as plain values."""
    lens, solution = taken.lens, taken.solution
    instances = taken.world.instances
    return {
        "format": "scenewright/observations",
        "version": 1,
        "made_by": __version__,
        "seed": taken.seed,
        "scene": {
            "name": solution.brief.name,
            "made_by": solution.version,
            "preset": solution.preset,
            "seed": solution.seed,
            "brief_hash": solution.brief_hash,
        },
        "conventions": CONVENTIONS,
        "kinds": list(taken.kinds),
        "intrinsics": {
            "width": lens.width,
            "height": lens.height,
            "fx": lens.focal,
            "fy": lens.focal,
            "cx": lens.width / 2,
            "cy": lens.height / 2,
        },
        "cameras": [_camera(k, one, taken.kinds) for k, one in enumerate(taken.viewpoints)],
        "classes": {
            str(one.semantic): one.category
            for one in sorted(instances, key=lambda one: (one.semantic, one.category))
        },
        "instances": [one._asdict() for one in instances],
    }


def _camera(number: int, one: Viewpoint, kinds: Iterable[str]) -> dict[str, Any]:
    return {
        "camera": number,
        "pose": (pose_of(one).round(9) + 0.0).tolist(),
        "yaw": round(degrees(one.yaw), 4),
        "pitch": round(degrees(one.pitch), 4),
        "room": one.room,
        "level": one.level,
        "clearance": one.clearance,
        "files": file_names(number, kinds),
    }


def _text(document: dict[str, Any]) -> str:
    """JSON with one camera or instance a line."""
    lines = []
    for key, value in document.items():
        if isinstance(value, list) and value and isinstance(value[0], dict):
            rows = ",\n".join(json.dumps(row, ensure_ascii=False) for row in value)
            lines.append(f'"{key}": [\n{rows}\n]')
        else:
            lines.append(f'"{key}": {json.dumps(value, ensure_ascii=False)}')
    return "{\n" + ",\n".join(lines) + "\n}\n"
