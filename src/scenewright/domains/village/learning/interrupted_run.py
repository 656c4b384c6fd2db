"""A training that may be stopped: its state, beside the style until that is written."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from scenewright.core.array_archive import read_arrays
from scenewright.core.atomic_file import atomic_write
from scenewright.domains.village.learning.pose_training import TrainingState

GROUPS = ("weights", "first", "second")
LARGEST = 64_000_000
"""Bytes of the state of a training at most."""


def checkpoint_path(output: Path) -> Path:
    """Where the state of a training is kept.

    >>> checkpoint_path(Path("mine.npz")).name
    'mine.training.npz'
    """
    return output.with_suffix(f".training{output.suffix}")


def save_training(path: Path, key: str, state: TrainingState, seconds: float) -> None:
    """Keep a state: ``key`` identifies the training, ``seconds`` is what it took."""
    arrays = {
        f"{group}/{name}": value
        for group, values in zip(GROUPS, state[:3], strict=True)
        for name, value in values.items()
    }
    record = json.dumps(
        {
            "key": key,
            "steps": state.steps,
            "rounds": state.rounds,
            "losses": state.losses,
            "seconds": seconds,
        }
    )
    arrays["told"] = np.frombuffer(record.encode(), np.uint8)
    with atomic_write(path) as partial, partial.open("wb") as file:
        np.savez(file, allow_pickle=False, **arrays)


def resume_training(path: Path, key: str, fresh: TrainingState) -> tuple[TrainingState, float]:
    """The state kept of this very training and the seconds it took; else a fresh one."""
    try:
        arrays = read_arrays(path, LARGEST)
        record = json.loads(bytes(arrays["told"]).decode())
        if record["key"] != key:
            return fresh, 0.0
        groups = [
            {name: _like(arrays[f"{group}/{name}"], value) for name, value in fresh.weights.items()}
            for group in GROUPS
        ]
        losses = tuple(float(v) for v in record["losses"])
        steps, rounds = int(record["steps"]), int(record["rounds"])
        state = TrainingState(groups[0], groups[1], groups[2], steps, rounds, losses)
        return state, float(record["seconds"])
    except Exception:  # whatever was kept and is damaged is trained again
        return fresh, 0.0


def _like(value: np.ndarray, fresh: np.ndarray) -> np.ndarray:
    """An array that was kept, of the shape and kind of a ``fresh`` one and finite."""
    if value.shape != fresh.shape or not np.isfinite(value).all():
        raise ValueError("not of this training")
    return value.astype(fresh.dtype)
