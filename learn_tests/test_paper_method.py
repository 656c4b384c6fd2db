"""The networks of Zhu, Jiang and Li (2022): sizes, losses, and both passes of the small form."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from test_pose_training import blocks

from scenewright.domains.village.learning.paper import nets, samples, training
from scenewright.domains.village.learning.paper.export import write_paper_nets
from scenewright.domains.village.paper import passes
from scenewright.domains.village.paper.views import class_planes

torch = pytest.importorskip("torch")


def test_the_printed_continue_net_is_resnet34() -> None:
    """21.28 million weights without the classifier (He and others 2016), 12 channels for 3."""
    made = nets.continue_net(torch, nets.PRINTED)
    count = sum(p.numel() for p in made.parameters())
    head = 512 * 128 + 128 + 128 + 1
    assert count - head == 21_284_672 + 64 * 49 * 9


def test_the_small_form_is_small_and_all_shapes_fit() -> None:
    made = nets.make_nets(torch, nets.SMALL)
    assert sum(p.numel() for net in made.values() for p in net.parameters()) < 450_000
    rng = np.random.default_rng(0)
    told = [samples.tell_block(block, 64) for block in blocks(3)]
    for name in passes.ASKED:
        rows = [samples.sample_of(one, rng, name) for one in told]
        loss = training.loss_of_net(torch, name, made[name], rows)
        assert loss.ndim == 0
        assert torch.isfinite(loss)


def test_location_learns_where_the_only_free_place_is() -> None:
    losses: list[float] = []
    training.train_paper(
        blocks(12),
        nets.SMALL,
        training.PaperSchedule({"location": 8}, {"location": 6}),
        1,
        lambda _name, _step, loss: losses.append(loss),
        ("location",),
    )
    assert np.mean(losses[-5:]) < np.log(64 * 64) - 1.5


def test_both_passes_say_the_same(tmp_path: Path) -> None:
    made = blocks(6)
    schedule = training.PaperSchedule(training.BRIEF.batch, dict.fromkeys(passes.ASKED, 1))
    trained = training.train_paper(made, nets.SMALL, schedule, 2)
    for net in trained.values():
        net.half().float()  # files hold half precision
    write_paper_nets(tmp_path / "nets.npz", trained, {})
    plain = passes.read_paper_nets(tmp_path / "nets.npz")
    rng = np.random.default_rng(0)
    sample = samples.sample_of(samples.tell_block(made[0], 64), rng, "location")
    planes = np.concatenate([sample.view, class_planes(sample.classes, 64)])
    counts, shape = sample.counts.astype(np.float32), np.eye(2, dtype=np.float32)[0]
    hidden = rng.normal(size=passes.HIDDEN).astype(np.float32)

    def seen(value: np.ndarray) -> object:
        return torch.from_numpy(value[None])

    with torch.no_grad():
        odds = torch.sigmoid(trained["continue"](seen(sample.view))).item()
        area = trained["area"](seen(sample.view), seen(counts))[0].numpy()
        places = trained["location"](seen(planes))[0].numpy()
        cosine = trained["orientation"].draw(seen(sample.view), seen(shape), seen(hidden)).item()
    assert passes.odds_of_another(plain, sample.view) == pytest.approx(odds, abs=1e-5)
    assert passes.odds_of_classes(plain, "area", sample.view, counts) == pytest.approx(
        area, abs=1e-4
    )
    assert passes.odds_of_places(plain, planes) == pytest.approx(places, abs=1e-4)
    assert passes.draw_cosine(plain, sample.view, shape, hidden) == pytest.approx(cosine, abs=1e-5)
