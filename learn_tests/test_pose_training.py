"""Training in PyTorch: the same pass as the shipped one, resumed as if never stopped, hostile data.

Needs the extra ``learn``; run with ``make test-learn``.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import shapely

from scenewright.cli.commands import run
from scenewright.domains.village.learned.pose_net import score_poses
from scenewright.domains.village.learned.style import bare_style, read_style
from scenewright.domains.village.learning.interrupted_run import (
    checkpoint_path,
    resume_training,
    save_training,
)
from scenewright.domains.village.learning.pose_training import (
    TrainingState,
    pad_examples,
    round_examples,
    score_tensors,
    start_training,
    to_tensors,
    train_poses,
)
from scenewright.domains.village.learning.tables import RealBlock, learn_manner

torch = pytest.importorskip("torch")


def blocks(count: int = 14) -> list[RealBlock]:
    """Rows of houses behind a street, 3 m apart, each block somewhat longer."""
    found = []
    for number in range(count):
        wide = 60.0 + 3 * number
        rings = []
        for k in range(5):
            west = 4 + k * 12
            rings.append(np.array([[west, 5.0], [west + 9, 5], [west + 9, 12], [west, 12]]))
        street = np.array([[[0.0, 0.0], [wide, 0.0]]])
        floor = shapely.box(0, 0, wide, 30)
        found.append(RealBlock(f"b{number}", f"p{number % 5}", floor, street, tuple(rings)))
    return found


def test_the_pass_in_torch_is_the_shipped_one() -> None:
    made = blocks()
    state = start_training(3)
    rng = np.random.default_rng(0)
    weights = {
        name: (value + 0.1 * rng.normal(size=value.shape)).astype(np.float32)
        for name, value in state.weights.items()
    }
    rows = round_examples(made, bare_style(learn_manner(made)), 1, 0)
    tokens, there = pad_examples(rows)
    tensors = {name: torch.from_numpy(value) for name, value in weights.items()}
    scores = score_tensors(torch, tensors, to_tensors(torch, tokens)).numpy().reshape(there.shape)
    for row, one in zip(scores, rows, strict=True):
        ours = score_poses(weights, one.tokens)
        assert row[: len(ours)] == pytest.approx(ours, abs=2e-4)


def test_a_training_that_was_stopped_goes_on_as_if_it_had_not_been(tmp_path: Path) -> None:
    made = blocks()
    style = bare_style(learn_manner(made))
    whole = train_poses(start_training(5), made, style, 5, 4, lambda _state: False)
    path = checkpoint_path(tmp_path / "style.npz")

    def stop(state: TrainingState) -> bool:
        save_training(path, "this", state, 1.5)
        return state.rounds == 2

    train_poses(start_training(5), made, style, 5, 4, stop)
    state, seconds = resume_training(path, "this", start_training(5))
    assert (state.rounds, seconds) == (2, 1.5)
    again = train_poses(state, made, style, 5, 4, lambda _state: False)
    assert again.losses == pytest.approx(whole.losses, abs=0)
    for name, value in whole.weights.items():
        assert (value == again.weights[name]).all()
    other, _ = resume_training(path, "another", start_training(5))
    assert other.rounds == 0


def test_what_is_learned_is_what_the_blocks_show() -> None:
    made = blocks(30)
    state = train_poses(
        start_training(1), made, bare_style(learn_manner(made)), 1, 12, lambda _state: False
    )
    assert state.losses[-1] < state.losses[0] - 0.2


def rows_of(made: list[RealBlock]) -> list[dict[str, object]]:
    """Blocks as the rows of a file."""
    return [
        {
            "id": block.name,
            "place": block.place,
            "place_kind": "village",
            "outline": shapely.get_coordinates(block.floor.exterior)[:-1].tolist(),
            "outline_on_street": [
                bool(y == 0) for _, y in shapely.get_coordinates(block.floor.exterior)
            ][:-1],
            "houses": [{"polygon": ring.tolist()} for ring in block.houses],
        }
        for block in made
    ]


def test_the_same_seed_gives_the_same_style_and_arrange_takes_it(tmp_path: Path) -> None:
    data, out = tmp_path / "blocks.json", tmp_path / "style.npz"
    data.write_text(json.dumps(rows_of(blocks(24))))
    words = ["learn", "village", str(data), "-o", str(out), "--epochs", "1", "-q"]
    assert run(words) == 0
    first = out.read_bytes()
    assert run(words) == 0
    assert out.read_bytes() == first
    assert not checkpoint_path(out).exists()
    card = read_style(out).card
    assert set(card["places"]).isdisjoint(card["held_out"])
    scene = str(tmp_path / "hamlet.json")
    assert run(["arrange", "sample:village-hamlet", "--style", str(out), "-o", scene, "-q"]) == 0


def test_a_budget_ends_the_training_and_the_style_is_written(tmp_path: Path) -> None:
    data, out = tmp_path / "blocks.json", tmp_path / "style.npz"
    data.write_text(json.dumps(rows_of(blocks(24))))
    words = ["learn", "village", str(data), "-o", str(out), "--epochs", "50", "--budget", "0.001"]
    assert run([*words, "-q"]) == 0
    assert read_style(out).card["rounds"] == 1
