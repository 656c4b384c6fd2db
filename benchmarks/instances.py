"""The two measuring instances of the home problem, read into a :class:`Problem`.

A benchmark's format, not a shipped one: see the README beside the instances.
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.real_data import instance
from scenewright.domains.home.problem import Ground, Problem, empty_items

Floats = NDArray[np.float64]
NAMES = ("boundary", "overlap", "keep_free", "main_wall", "against_wall", "pairs", "size")


def _box(rectangle: Floats) -> list[float]:
    """Four corners in order to centre, heading, width, depth."""
    along, across = rectangle[1] - rectangle[0], rectangle[3] - rectangle[0]
    x, y = rectangle.mean(axis=0)
    heading = np.arctan2(across[1], across[0])
    return [x, y, heading, float(np.hypot(*along)), float(np.hypot(*across))]


def _ground(record: dict[str, Any]) -> Ground:
    room = np.array(record["room"], float)
    edges = np.hstack([room, np.roll(room, -1, axis=0)])
    none = np.zeros((0, 5))
    low, high = room.min(axis=0), room.max(axis=0)
    return Ground(
        edges=edges,
        walls=edges.copy(),
        keep_free=np.array([_box(np.array(r, float)) for r in record["keep_free"]]),
        use_space=none.copy(),
        obstacles=none.copy(),
        windows=np.zeros((0, 6)),
        doors=none.copy(),
        # The instances turn the local x axis; the main wall runs along +x, so its normal is +y.
        main_wall=np.array([[low[0], low[1], high[0], low[1]]]),
        bounds=np.concatenate([low, high]),
        area=float(0.5 * (edges[:, 0] * edges[:, 3] - edges[:, 2] * edges[:, 1]).sum()),
    )


def read_instance(name: str) -> Problem:
    """``living`` (3 patches) or ``big`` (20 rectangles), the paper's seven costs as printed."""
    text = instance(f"home-{name}.json").read_text(encoding="utf-8")
    record = json.loads(text)
    low, high = np.array(record["low"], float), np.array(record["high"], float)
    targets = np.array(record["pair_target_distance_angle"], float)
    items = empty_items(len(low))._replace(
        low=low[:, 3:].copy(),
        high=high[:, 3:].copy(),
        back_to_wall=np.array(record["back_to_wall"], float),
        main_wall=np.array(record["main_wall_role"], float),
        pairs=np.array(record["pairs"], np.int64),
        pair_targets=np.column_stack([targets, np.full(len(targets), np.nan)]),
        pair_weights=np.ones(len(targets)),
    )
    weights = dict(zip(NAMES, (float(w) for w in record["weights"]), strict=True))
    names = tuple(f"item {k + 1}" for k in range(len(low)))
    return Problem(_ground(record), items, names, weights, printed=True)
