"""Training the networks of Zhu, Jiang and Li (2022): printed schedules and brief ones.

Printed: *continue* cross entropy, 8 a step, 120 epochs, rate 0.001; *category* and *location* 16 a
step, 300 epochs, Adam; *orientation* 4 a step, 400 epochs, KL and the loss of the cosine. The rate
of the last three is not printed: 0.001 is taken. An epoch is one sample of every house.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from scenewright.domains.village.learning.paper.nets import CLASSES, NetSizes, make_nets
from scenewright.domains.village.learning.paper.samples import PaperSample, sample_of, tell_block
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.paper.views import SHAPES, class_planes

RATE = 1e-3
HIDDEN_LOSS = 0.05
"""What KL counts against the square of the cosine's error; the paper prints no weight."""


class PaperSchedule(NamedTuple):
    """Samples of a step and epochs of each network."""

    batch: dict[str, int]
    epochs: dict[str, int]


PRINTED = PaperSchedule(
    {"continue": 8, "material": 16, "shape": 16, "area": 16, "location": 16, "orientation": 4},
    {
        "continue": 120,
        "material": 300,
        "shape": 300,
        "area": 300,
        "location": 300,
        "orientation": 400,
    },
)
BRIEF = PaperSchedule(
    dict.fromkeys(PRINTED.batch, 16),
    {"continue": 4, "material": 1, "shape": 2, "area": 2, "location": 6, "orientation": 3},
)
"""What the shipped small form had: six minutes of one core."""


def train_paper(
    blocks: Sequence[RealBlock],
    sizes: NetSizes,
    schedule: PaperSchedule,
    seed: int,
    tell: Callable[[str, int, float], None] = lambda _name, _step, _loss: None,
    names: Sequence[str] = tuple(PRINTED.batch),
    device: str = "cpu",
) -> dict[str, Any]:
    """Networks trained on real blocks, one after another; ``tell`` gets every step's loss."""
    import torch

    torch.manual_seed(seed)
    nets = {name: net.to(device) for name, net in make_nets(torch, sizes).items() if name in names}
    prepared = [tell_block(block, sizes.pixels) for block in blocks]
    owner = np.repeat(np.arange(len(prepared)), [len(one.houses.footprints) for one in prepared])
    for number, (name, net) in enumerate(nets.items()):
        rng = np.random.default_rng([seed, number])
        wheel = torch.optim.Adam(net.parameters(), lr=RATE)
        net.train()
        size, step = schedule.batch[name], 0
        for _ in range(schedule.epochs[name]):
            for rows in np.array_split(rng.permutation(owner), -(-len(owner) // size)):
                samples = [sample_of(prepared[k], rng, name) for k in rows.tolist()]
                loss = loss_of_net(torch, name, net, samples, device)
                wheel.zero_grad()
                loss.backward()
                wheel.step()
                step += 1
                tell(name, step, loss.item())
        net.eval()
    return nets


def loss_of_net(
    torch: Any, name: str, net: Any, samples: Sequence[PaperSample], device: str = "cpu"
) -> Any:
    """The loss of one network on some samples."""
    functional = torch.nn.functional

    def tensor(values: Any) -> Any:
        return torch.from_numpy(np.asarray(values, np.float32)).to(device)

    if name == "continue":
        found = net(tensor([one.view for one in samples]))[:, 0]
        return functional.binary_cross_entropy_with_logits(
            found, tensor([one.more for one in samples])
        )
    if name in CLASSES:
        column = list(CLASSES).index(name)
        found = net(tensor([s.view for s in samples]), tensor([s.counts for s in samples]))
        wanted = torch.tensor([one.classes[column] for one in samples], device=device)
        return functional.cross_entropy(found, wanted)
    if name == "location":
        size = samples[0].view.shape[-1]
        rows = [np.concatenate([s.view, class_planes(s.classes, size)]) for s in samples]
        wanted = torch.tensor([one.pixel for one in samples], device=device)
        return functional.cross_entropy(net(tensor(rows)).flatten(1), wanted)
    cosine = tensor([one.cosine for one in samples])
    shape = tensor([np.eye(SHAPES)[one.classes[1]] for one in samples])
    again, mean, spread = net(tensor([one.view for one in samples]), shape, cosine)
    hidden = -0.5 * (1 + spread - mean**2 - spread.exp()).sum(1).mean()
    return ((again - cosine) ** 2).mean() + HIDDEN_LOSS * hidden
