"""The networks of Zhu, Jiang and Li (2022): sizes, losses, and the loop on blocks made up here."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from test_pose_training import blocks

from scenewright.domains.village.learning.paper import nets, samples, training, views
from scenewright.domains.village.learning.paper.filling import candidates_of, fill_block

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
    rows = [samples.sample_of(one, rng) for one in told]
    for name in nets.ASKED:
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


def test_the_loop_puts_real_houses_legally() -> None:
    made = blocks(6)
    trained = training.train_paper(
        made,
        nets.SMALL,
        training.PaperSchedule(training.BRIEF.batch, dict.fromkeys(nets.ASKED, 1)),
        2,
    )
    candidates = candidates_of(made, [views.paper_houses(block) for block in made])
    block = made[0]
    rings = fill_block(trained, block, candidates, 64, nets.SMALL.hidden, np.random.default_rng(1))
    shapes = [shapely.Polygon(ring) for ring in rings]
    assert all(block.floor.buffer(1e-6).covers(shape) for shape in shapes)
    for k, one in enumerate(shapes):
        assert all(one.intersection(other).area < 2.0 for other in shapes[:k])
