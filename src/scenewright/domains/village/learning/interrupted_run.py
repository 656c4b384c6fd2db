"""A training that may be stopped: its state, beside the style until that is written."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import numpy as np

from scenewright.core.atomic_file import atomic_write
from scenewright.domains.village.learning.pose_training import TrainingState

GROUPS = ("weights", "first", "second")


def checkpoint_path(output: Path) -> Path:
    """Where the state of a training is kept.

    >>> checkpoint_path(Path("mine.npz")).name
    'mine.training.npz'
    """
    return output.with_suffix(f".training{output.suffix}")


def save_training(path: Path, key: str, state: TrainingState, seconds: float) -> None:
    """Keep a state: ``key`` says of which training it is, ``seconds`` what it took."""
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
        with np.load(path, allow_pickle=False) as file:
            record = json.loads(bytes(file["told"]).decode())
            if record["key"] != key:
                return fresh, 0.0
            groups = [{name: file[f"{group}/{name}"] for name in fresh.weights} for group in GROUPS]
    except (OSError, ValueError, KeyError, TypeError, EOFError, zipfile.BadZipFile):
        return fresh, 0.0
    losses = tuple(float(v) for v in record["losses"])
    state = TrainingState(
        groups[0], groups[1], groups[2], int(record["steps"]), int(record["rounds"]), losses
    )
    return state, float(record["seconds"])
