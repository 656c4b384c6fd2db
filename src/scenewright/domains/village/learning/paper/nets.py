"""The networks of Zhu, Jiang and Li (2022) in PyTorch, at their printed sizes and in a small form.

*Continue* is ResNet34 (He and others 2016) with an MLP of 128; the three *category* networks are
small CNNs with an MLP of 128 that also gets how many houses of each class stand; *location* is
fully convolutional (its text is lost; after Ritchie, Wang and Lin 2019) and gives the log odds of
the base point at every pixel; *orientation* is a conditional variational autoencoder of the cosine
of the door angle, with 40 hidden values.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from scenewright.domains.village.paper.nets_file import CLASSES, NetSizes, blocks_of, widths_up
from scenewright.domains.village.paper.views import CHANNELS, COUNTED, SHAPES


def make_nets(torch: Any, sizes: NetSizes) -> dict[str, Any]:
    """All networks by name."""
    found = {"continue": continue_net(torch, sizes), "location": location_net(torch, sizes)}
    for name, count in CLASSES.items():
        found[name] = category_net(torch, sizes, count)
    return found | {"orientation": orientation_net(torch, sizes)}


def continue_net(torch: Any, sizes: NetSizes) -> Any:
    """View (b, 12, s, s) -> the log odds (b, 1) that another house follows."""
    nn = torch.nn
    before = sizes.stages[0][0]
    parts = [
        nn.Conv2d(CHANNELS, before, 7, 2, 3, bias=False),
        nn.BatchNorm2d(before),
        nn.ReLU(),
        nn.MaxPool2d(3, 2, 1),
    ]
    for _, width, stride in blocks_of(sizes):
        parts.append(_residual(torch, before, width, stride))
        before = width
    head = [nn.Linear(before, sizes.mlp), nn.ReLU(), nn.Linear(sizes.mlp, 1)]
    return nn.Sequential(*parts, nn.AdaptiveAvgPool2d(1), nn.Flatten(), *head)


def _residual(torch: Any, before: int, width: int, stride: int) -> Any:
    """Two convolutions beside a way round them."""
    nn = torch.nn

    class Residual(nn.Module):  # type: ignore[name-defined]
        def __init__(self) -> None:
            super().__init__()
            self.main = nn.Sequential(
                nn.Conv2d(before, width, 3, stride, 1, bias=False),
                nn.BatchNorm2d(width),
                nn.ReLU(),
                nn.Conv2d(width, width, 3, 1, 1, bias=False),
                nn.BatchNorm2d(width),
            )
            plain = stride == 1 and before == width
            self.round = (
                nn.Identity()
                if plain
                else nn.Sequential(
                    nn.Conv2d(before, width, 1, stride, bias=False), nn.BatchNorm2d(width)
                )
            )

        def forward(self, x: Any) -> Any:
            return torch.relu(self.main(x) + self.round(x))

    return Residual()


def _encoder(torch: Any, sizes: NetSizes) -> tuple[Any, int]:
    """A small CNN: view -> features (b, n), and n."""
    nn, before = torch.nn, CHANNELS
    parts: list[Any] = []
    for width in sizes.channels:
        parts += [nn.Conv2d(before, width, 3, 2, 1), nn.BatchNorm2d(width), nn.ReLU()]
        before = width
    return nn.Sequential(*parts, nn.AdaptiveAvgPool2d(2), nn.Flatten()), before * 4


def category_net(torch: Any, sizes: NetSizes, classes: int) -> Any:
    """View and count vector (b, COUNTED) -> log odds (b, classes)."""
    nn = torch.nn

    class Category(nn.Module):  # type: ignore[name-defined]
        def __init__(self) -> None:
            super().__init__()
            self.seen, width = _encoder(torch, sizes)
            self.head = nn.Sequential(
                nn.Linear(width + COUNTED, sizes.mlp), nn.ReLU(), nn.Linear(sizes.mlp, classes)
            )

        def forward(self, view: Any, counts: Any) -> Any:
            return self.head(torch.cat([self.seen(view), counts], 1))

    return Category()


def location_net(torch: Any, sizes: NetSizes) -> Any:
    """View and classes of the house painted as planes (b, 12 + COUNTED, s, s) -> log odds of the
    base point (b, s, s)."""
    nn, before = torch.nn, CHANNELS + COUNTED
    down: list[Any] = []
    for width in sizes.channels:
        down += [nn.Conv2d(before, width, 3, 2, 1), nn.BatchNorm2d(width), nn.ReLU()]
        before = width
    up: list[Any] = []
    for width in widths_up(sizes):
        up += [nn.Upsample(scale_factor=2, mode="nearest")]
        up += [nn.Conv2d(before, width, 3, 1, 1), nn.BatchNorm2d(width), nn.ReLU()]
        before = width
    return nn.Sequential(*down, *up, nn.Conv2d(before, 1, 1), _drop_channel(torch))


def _drop_channel(torch: Any) -> Any:
    class DropChannel(torch.nn.Module):
        def forward(self, x: Any) -> Any:
            return x[:, 0]

    return DropChannel()


def orientation_net(torch: Any, sizes: NetSizes) -> Any:
    """A conditional VAE: ``forward(view, shape, cosine, noise)`` -> cosine again, mean and log
    variance of the hidden values; ``draw(view, shape, hidden)`` -> cosine (b,)."""
    nn = torch.nn

    class Orientation(nn.Module):  # type: ignore[name-defined]
        def __init__(self) -> None:
            super().__init__()
            self.seen, width = _encoder(torch, sizes)
            known = width + SHAPES
            self.inner = nn.Sequential(nn.Linear(known + 1, sizes.mlp), nn.ReLU())
            self.mean = nn.Linear(sizes.mlp, sizes.hidden)
            self.spread = nn.Linear(sizes.mlp, sizes.hidden)
            self.outer = nn.Sequential(
                nn.Linear(known + sizes.hidden, sizes.mlp), nn.ReLU(), nn.Linear(sizes.mlp, 1)
            )

        def draw(self, view: Any, shape: Any, hidden: Any) -> Any:
            known = torch.cat([self.seen(view), shape, hidden], 1)
            return torch.tanh(self.outer(known))[:, 0]

        def forward(self, view: Any, shape: Any, cosine: Any, noise: Any) -> Any:
            known = torch.cat([self.seen(view), shape], 1)
            inner = self.inner(torch.cat([known, cosine[:, None]], 1))
            mean, spread = self.mean(inner), self.spread(inner)
            hidden = mean + noise * torch.exp(spread / 2)
            again = torch.tanh(self.outer(torch.cat([known, hidden], 1)))[:, 0]
            return again, mean, spread

    return Orientation()


def weights_of(nets: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """The arrays of networks by ``network/layer``."""
    return {
        f"{name}/{layer}": value.detach().cpu().numpy()
        for name, net in nets.items()
        for layer, value in net.state_dict().items()
        if not layer.endswith("num_batches_tracked")
    }
