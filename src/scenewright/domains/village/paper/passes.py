"""The pass forward of the paper's networks, of any sizes, over plain arrays.

The same layers as ``learning.paper.nets`` builds in PyTorch, by the names that it gives them, for
one view at a time: convolutions as products of unfolded windows, batch normalization by the means
and variances of training (Ioffe and Szegedy 2015).
"""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from scenewright.domains.village.paper.nets_file import (
    PaperNets,
    PaperWeights,
    Values,
    blocks_of,
    head_of,
    widths_up,
)


def odds_of_another(nets: PaperNets, view: Values) -> float:
    """The chance in [0, 1] that another house follows, by *continue*; ``view`` (12, s, s)."""
    weights, head = nets.weights, head_of(nets.sizes)
    x = np.maximum(_norm(weights, "continue/1", _conv(weights, "continue/0", view, 2, 3)), 0)
    x = _pool(x)
    for number, _, stride in blocks_of(nets.sizes):
        at = f"continue/{number}"
        inner = _step(weights, f"{at}.main.0", f"{at}.main.1", x, stride)
        inner = _norm(weights, f"{at}.main.4", _conv(weights, f"{at}.main.3", inner, 1, 1))
        if f"{at}.round.0.weight" in weights:
            x = _norm(weights, f"{at}.round.1", _conv(weights, f"{at}.round.0", x, stride, 0))
        x = np.maximum(inner + x, 0)
    inner = np.maximum(_linear(weights, f"continue/{head}", x.mean((1, 2))), 0)
    score = float(_linear(weights, f"continue/{head + 2}", inner)[0])
    return float(1.0 / (1.0 + np.exp(-np.clip(score, -30, 30))))


def odds_of_classes(nets: PaperNets, name: str, view: Values, counts: Values) -> Values:
    """Log odds of the classes of the next house, by the *category* network ``name``."""
    seen = np.concatenate([_encode(nets, f"{name}/seen", view), counts])
    inner = np.maximum(_linear(nets.weights, f"{name}/head.0", seen), 0)
    return _linear(nets.weights, f"{name}/head.2", inner)


def odds_of_places(nets: PaperNets, planes: Values) -> Values:
    """Log odds (s, s) of the base point, by *location*; ``planes`` (20, s, s)."""
    x, at, weights = planes, 0, nets.weights
    for _ in nets.sizes.channels:
        x, at = _step(weights, f"location/{at}", f"location/{at + 1}", x, 2), at + 3
    for _ in widths_up(nets.sizes):
        x = x.repeat(2, axis=1).repeat(2, axis=2)
        x, at = _step(weights, f"location/{at + 1}", f"location/{at + 2}", x, 1), at + 4
    return _conv(weights, f"location/{at}", x, 1, 0)[0]


def draw_cosine(nets: PaperNets, view: Values, shape: Values, hidden: Values) -> float:
    """The cosine of the door angle, by *orientation*, for hidden values (h,)."""
    seen = np.concatenate([_encode(nets, "orientation/seen", view), shape, hidden])
    inner = np.maximum(_linear(nets.weights, "orientation/outer.0", seen), 0)
    return float(np.tanh(_linear(nets.weights, "orientation/outer.2", inner)[0]))


def _encode(nets: PaperNets, name: str, view: Values) -> Values:
    x = view
    for k in range(len(nets.sizes.channels)):
        x = _step(nets.weights, f"{name}.{3 * k}", f"{name}.{3 * k + 1}", x, 2)
    half = x.shape[1] // 2
    return x.reshape(len(x), 2, half, 2, half).mean((2, 4)).ravel()


def _step(nets: PaperWeights, conv: str, norm: str, x: Values, stride: int) -> Values:
    return np.maximum(_norm(nets, norm, _conv(nets, conv, x, stride, 1)), 0)


def _conv(nets: PaperWeights, name: str, x: Values, stride: int, pad: int) -> Values:
    """A convolution of x (c, h, w) with padding: (o, h', w')."""
    weight = nets[f"{name}.weight"]
    size = weight.shape[-1]
    wide = np.pad(x, ((0, 0), (pad, pad), (pad, pad)))
    seen = sliding_window_view(wide, (size, size), axis=(1, 2))[:, ::stride, ::stride]
    high, across = seen.shape[1:3]
    rows = seen.transpose(0, 3, 4, 1, 2).reshape(-1, high * across)
    found = (weight.reshape(len(weight), -1) @ rows).reshape(-1, high, across)
    bias = nets.get(f"{name}.bias")
    return found if bias is None else found + bias[:, None, None]


def _norm(nets: PaperWeights, name: str, x: Values) -> Values:
    scale = nets[f"{name}.weight"] / np.sqrt(nets[f"{name}.running_var"] + np.float32(1e-5))
    shift = nets[f"{name}.bias"] - nets[f"{name}.running_mean"] * scale
    return x * scale[:, None, None] + shift[:, None, None]


def _pool(x: Values) -> Values:
    """The largest of 3 x 3, every second."""
    wide = np.pad(x, ((0, 0), (1, 1), (1, 1)), constant_values=-np.inf)
    return np.asarray(sliding_window_view(wide, (3, 3), axis=(1, 2))[:, ::2, ::2].max((3, 4)))


def _linear(nets: PaperWeights, name: str, x: Values) -> Values:
    return np.asarray(nets[f"{name}.weight"] @ x + nets[f"{name}.bias"], np.float32)
