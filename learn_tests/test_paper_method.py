"""The networks of Zhu, Jiang and Li (2022): sizes, losses, both passes, and trainings that stop."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
from test_pose_training import blocks, rows_of

from scenewright.cli.commands import run
from scenewright.domains.village.learning.paper import batches, nets, training
from scenewright.domains.village.learning.paper.batches import Feed, PaperBatch
from scenewright.domains.village.paper import nets_file, passes
from scenewright.domains.village.paper.nets_file import (
    ASKED,
    PRINTED,
    SMALL,
    NetSizes,
    read_paper_nets,
    shapes_of_nets,
)

torch = pytest.importorskip("torch")


def feed_of(count: int, sizes: NetSizes, epochs: int, names: tuple[str, ...] = ASKED) -> Feed:
    schedule = batches.PaperSchedule(batches.PRINTED.batch, dict.fromkeys(names, epochs))
    return Feed(blocks(count), sizes, schedule, 1)


def firsts(feed: Feed) -> Iterator[tuple[str, PaperBatch]]:
    """The first batch of each network."""
    for name in ASKED:
        step = batches.PaperStep(name, 0, 0)
        yield name, next(batches.make_batches(feed, iter([step])))


def test_the_printed_continue_net_is_resnet34() -> None:
    """21.28 million weights without the classifier (He and others 2016), 12 channels for 3."""
    made = nets.continue_net(torch, PRINTED)
    count = sum(p.numel() for p in made.parameters())
    head = 512 * 128 + 128 + 128 + 1
    assert count - head == 21_284_672 + 64 * 49 * 9


@pytest.mark.parametrize("sizes", [SMALL, PRINTED])
def test_a_file_holds_every_layer(sizes: NetSizes) -> None:
    made = nets.make_nets(torch, sizes)
    found = {
        f"{name}/{layer}": tuple(value.shape)
        for name, net in made.items()
        for layer, value in net.state_dict().items()
        if not layer.endswith("num_batches_tracked")
    }
    assert dict(shapes_of_nets(sizes)) == found


def test_the_small_form_is_small_and_every_loss_is_finite() -> None:
    made = nets.make_nets(torch, SMALL)
    assert sum(p.numel() for net in made.values() for p in net.parameters()) < 450_000
    for name, batch in firsts(feed_of(3, SMALL, 1)):
        loss = training.loss_of_net(torch, name, made[name], batch)
        assert loss.ndim == 0
        assert torch.isfinite(loss)


def test_location_learns_where_the_only_free_place_is() -> None:
    feed, losses = feed_of(12, SMALL, 12, ("location",)), list[float]()

    def done(_step: batches.PaperStep, loss: float) -> bool:
        losses.append(loss)
        return False

    state = training.start_nets(torch, feed, "cpu")
    assert training.train_nets(torch, state, feed, "cpu", 0, done)
    assert np.mean(losses[-5:]) < np.log(64 * 64) - 1.5


@pytest.mark.parametrize("sizes", [SMALL, PRINTED])
def test_both_passes_say_the_same(sizes: NetSizes) -> None:
    """Trained a few steps, so that the means and variances of the norms are not those at first."""
    feed = feed_of(4, sizes, 1)
    state = training.start_nets(torch, feed, "cpu")
    for name, batch in firsts(feed):
        for _ in range(2):
            training.loss_of_net(torch, name, state.nets[name], batch).backward()
            state.wheels[name].step()
        state.nets[name].eval()
    plain = nets_file.PaperNets(sizes, nets.weights_of(state.nets), {})
    seen = dict(firsts(feed))
    view, counts = seen["area"].planes[:1], seen["area"].counts[:1]
    places, way = seen["location"].planes[:1], seen["orientation"]
    asked = way.planes[:1], way.shapes[:1], way.noise[:1]
    with torch.no_grad():
        odds = torch.sigmoid(state.nets["continue"](torch.from_numpy(view))).item()
        told = {
            name: state.nets[name](torch.from_numpy(view), torch.from_numpy(counts))[0].numpy()
            for name in nets_file.CLASSES
        }
        where = state.nets["location"](torch.from_numpy(places))[0].numpy()
        cosine = state.nets["orientation"].draw(*map(torch.from_numpy, asked)).item()
    assert passes.odds_of_another(plain, view[0]) == pytest.approx(odds, abs=1e-4)
    for name, values in told.items():
        found = passes.odds_of_classes(plain, name, view[0], counts[0])
        assert found == pytest.approx(values, abs=1e-4)
    assert passes.odds_of_places(plain, places[0]) == pytest.approx(where, abs=1e-4)
    drawn = passes.draw_cosine(plain, asked[0][0], asked[1][0], asked[2][0])
    assert drawn == pytest.approx(cosine, abs=1e-4)


def test_workers_make_the_same_batches() -> None:
    feed = feed_of(4, SMALL, 1)
    done = dict.fromkeys(ASKED, 0)
    alone = list(islice(batches.feed_batches(feed, done, 0), 7))
    served = batches.feed_batches(feed, done, 2)
    for ours, theirs in zip(alone, islice(served, 7), strict=True):
        assert all(np.array_equal(a, b) for a, b in zip(ours, theirs, strict=True))
    served.close()  # type: ignore[attr-defined]


def _words(folder: Path, name: str, *more: str) -> list[str]:
    data = folder / "data" / "blocks.json"
    data.parent.mkdir(exist_ok=True)
    data.write_text(json.dumps(rows_of(blocks(16))))
    return ["learn", "village", str(data.parent), "-o", str(folder / name), "--paper", "-q", *more]


def test_the_same_seed_gives_the_same_file_and_arrange_takes_it(tmp_path: Path) -> None:
    """With and without workers; more epochs go on from what is kept."""
    small = ("--size", "small", "--epochs")
    assert run(_words(tmp_path, "one.npz", *small, "1", "--jobs", "0")) == 0
    assert run(_words(tmp_path, "one.npz", *small, "2", "--jobs", "0")) == 0
    assert run(_words(tmp_path, "two.npz", *small, "2", "--jobs", "2")) == 0
    assert (tmp_path / "one.npz").read_bytes() == (tmp_path / "two.npz").read_bytes()
    assert set(read_paper_nets(tmp_path / "two.npz").card["epochs"].values()) == {2.0}
    scene = ["-o", str(tmp_path / "h.json"), "-q"]
    words = ["arrange", "sample:village-hamlet", "--nets", str(tmp_path / "two.npz"), *scene]
    assert run([*words, "--preset", "paper"]) in (0, 1)
    assert run(words) == 2


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_a_training_that_was_ended_goes_on_as_if_it_had_not_been(
    tmp_path: Path, number: int
) -> None:
    small = ("--size", "small", "--epochs", "3", "--jobs", "1")
    assert run(_words(tmp_path, "whole.npz", *small)) == 0
    words, kept = _words(tmp_path, "ended.npz", *small), tmp_path / "ended.training.pt"
    code = (
        "import sys; from scenewright.domains.village.learning.paper import learn;"
        "learn.KEPT_EVERY = 0.0;"
        "from scenewright.cli.commands import run; sys.exit(run(sys.argv[1:]))"
    )
    begun = subprocess.Popen([sys.executable, "-c", code, *words])
    while not kept.exists() and begun.poll() is None:
        time.sleep(0.05)
    os.kill(begun.pid, number)
    begun.wait(60)
    assert kept.exists()
    assert not (tmp_path / "ended.npz").exists()
    assert run(words) == 0
    assert (tmp_path / "ended.npz").read_bytes() == (tmp_path / "whole.npz").read_bytes()


def test_the_printed_form_takes_steps_and_its_file_is_used(tmp_path: Path) -> None:
    words = _words(tmp_path, "printed.npz", "--budget", "0.01", "--jobs", "0")
    assert run(words) == 0
    made = read_paper_nets(tmp_path / "printed.npz")
    assert made.sizes == PRINTED
    assert sum(value.size for value in made.weights.values()) > 20_000_000
    assert 0 < made.card["epochs"]["continue"] < 1


@pytest.mark.parametrize(
    "more", [("--size", "huge"), ("--device", "tpu"), ("--look", "hui")], ids=lambda row: row[0]
)
def test_what_is_wrong_is_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], more: tuple[str, ...]
) -> None:
    assert run(_words(tmp_path, "x.npz", *more)) == 2
    assert capsys.readouterr().err.strip().count("\n") == 0
