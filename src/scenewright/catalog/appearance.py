"""How models look: visual quality, tone and symmetry of the facade, what each side shows.

Shipped styles have their facts in a table (``appearance.csv``, written by
``python -m benchmarks.appearance``). Those of other models are computed when they are first used
(a second each) and kept in the user's cache folder, by what the model consists of.
"""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from functools import cache
from hashlib import blake2b
from importlib.resources import files
from pathlib import Path
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.assets import shipped
from scenewright.catalog.assets.buildings.building_styles import facade
from scenewright.core.atomic_file import write_atomically
from scenewright.core.catalog import Asset, Part
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.relief import measure_all_round, relief
from scenewright.geometry.saliency import relative_quality, saliency, sum_over_vertices
from scenewright.geometry.walker_meshes import SaliencyModel, side_densities

Floats = NDArray[np.float64]
Measure = Literal["relief", "printed"]
OnProgress = Callable[[float, str], None]

VERSION = b"2"
"""Facts kept by another version of what is measured are not used."""


class Facts(NamedTuple):
    """What a model looks like. ``relief`` and ``printed`` are its visual quality by our measure
    (:mod:`scenewright.geometry.relief`, in [0, 1]) and by that of Zhang and Yang (2023); ``tone``
    and ``symmetry`` of the front in [0, 1]; ``sides`` (5,) what front, left, back, right side and
    roof show of the relief, over that side of the box, times the variety of the model."""

    relief: float
    printed: float
    tone: float
    symmetry: float
    sides: tuple[float, ...]


PLAIN = Facts(0.0, 0.0, 0.5, 1.0, (0.0,) * 5)
"""A model with no surface to speak of."""


def facts_of(parts: Sequence[Part]) -> Facts:
    """The facts of a model, from its triangles.

    >>> pavilion = shipped().assets["pavilion"]
    >>> 0.1 < facts_of(pavilion.mesh(pavilion.usual)).relief < 0.4
    True
    """
    mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
    try:
        found = relief(mesh)
    except ValueError:
        return PLAIN
    seen, (tone, symmetry) = measure_all_round(mesh, found), facade(parts)
    sides = side_densities(SaliencyModel(mesh, found.faces)) * seen.variety
    return Facts(
        seen.quality, sum_over_vertices(saliency(mesh)), tone, symmetry, tuple(sides.tolist())
    )


@cache
def shipped_facts() -> dict[str, Facts]:
    """The facts of the shipped styles at their usual sizes, by id.

    >>> shipped_facts()["pagoda"].relief > shipped_facts()["warehouse"].relief
    True
    """
    text = files("scenewright.catalog").joinpath("appearance.csv").read_text(encoding="utf-8")
    rows = list(csv.reader(text.splitlines()))[1:]
    return {row[0]: _facts([float(value) for value in row[1:]]) for row in rows}


def table(rows: dict[str, Facts]) -> str:
    """The text of ``appearance.csv``."""
    head = "id,relief,printed,tone,symmetry,front,left,back,right,roof"
    lines = [
        ",".join([name, *(f"{value:.4f}" for value in (*row[:4], *row.sides))])
        for name, row in rows.items()
    ]
    return "\n".join([head, *lines, ""])


def facts(assets: Iterable[Asset], on_progress: OnProgress | None = None) -> dict[str, Facts]:
    """The facts of some assets by id: looked up, or computed and kept; ``on_progress`` gets the
    share done and the name of what is computed."""
    every = {asset.id: asset for asset in assets}
    known = shipped_facts()
    ours = {k for k, a in every.items() if k in known and shipped().assets.get(k) is a}
    others = [name for name in every if name not in ours]
    found = {name: known[name] for name in ours}
    for number, name in enumerate(others):
        if on_progress is not None:
            on_progress(number / len(others), every[name].name)
        found[name] = _load_or_compute(every[name].mesh(every[name].usual))
    return found


def qualities(rows: Sequence[Facts], measure: Measure = "relief") -> tuple[Floats, Floats]:
    """Visual qualities τ ``(n,)`` in (0, 1] and what the sides show ``(n, 5)`` of some models.

    By our measure a share of the best shipped style, so that sites can be compared; as printed
    (equation 8) of the best of the models given. Sides are always by ours.
    """
    best = max(row.relief for row in shipped_facts().values())
    side = max(float(np.mean(row.sides[:4])) for row in shipped_facts().values())
    shown = np.array([row.sides for row in rows]).reshape(-1, 5) / side
    if measure == "printed":
        return relative_quality([row.printed for row in rows]), np.minimum(shown, 1.0)
    own = np.array([row.relief for row in rows]) / best
    return np.clip(own, 1e-6, 1.0), np.minimum(shown, 1.0)


def cache_folder() -> Path:
    """Where facts are kept: ``XDG_CACHE_HOME`` or the user's cache folder."""
    root = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(root) / "scenewright" / "appearance"


def _load_or_compute(parts: Sequence[Part]) -> Facts:
    """Facts read from the cache folder, or computed and left there if it can be written to."""
    digest = blake2b(VERSION, digest_size=16)
    for part in parts:
        for array in (part.vertices, part.faces, np.array(part.material.color, np.float64)):
            digest.update(np.ascontiguousarray(array).tobytes())
    path = cache_folder() / f"{digest.hexdigest()}.json"
    try:
        return _facts(json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, TypeError):
        found = facts_of(parts)
    with suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(path, json.dumps([*found[:4], *found.sides]), own=True)
    return found


def _facts(row: Sequence[float]) -> Facts:
    """Facts from nine numbers; ValueError for anything else."""
    values = np.array(row, np.float64)
    if values.shape != (9,) or not np.isfinite(values).all() or (values < 0.0).any():
        raise ValueError("no facts of a model")
    relieved, printed, tone, symmetry, *sides = values.tolist()
    return Facts(relieved, printed, tone, symmetry, tuple(sides))
