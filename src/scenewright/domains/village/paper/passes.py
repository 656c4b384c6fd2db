"""The pass forward of the paper's networks in their small form, over plain arrays.

The same layers as ``learning.paper.nets`` builds in PyTorch, by the names that it gives them, for
one view at a time: convolutions as products of unfolded windows, batch normalization by the means
and variances of training (Ioffe and Szegedy 2015).
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

Values = NDArray[np.float32]
PaperWeights = Mapping[str, Values]
"""Arrays of all networks by ``network/layer``."""

PIXELS, HIDDEN = 64, 16
"""Pixels of a view and hidden values of *orientation* of the form that ships."""
STAGES = 3
"""Stages of *continue* and of the CNNs."""
SHIPPED = Path(__file__).parent / "small.npz"
ASKED = ("continue", "material", "shape", "area", "location", "orientation")


@lru_cache(maxsize=4)
def read_paper_nets(path: Path = SHIPPED) -> PaperWeights:
    """The networks of a file that ``benchmarks/village_paper_training.py`` has written.

    >>> sum(v.size for v in read_paper_nets().values()) < 400_000
    True
    """
    with np.load(path, allow_pickle=False) as file:
        return {name: np.asarray(file[name], np.float32) for name in file.files if name != "card"}


def odds_of_another(nets: PaperWeights, view: Values) -> float:
    """The chance in [0, 1] that another house follows, by *continue*; ``view`` (12, s, s)."""
    x = np.maximum(_norm(nets, "continue/1", _conv(nets, "continue/0", view, 2, 3)), 0)
    x = _pool(x)
    for stage in range(STAGES):
        at, stride = f"continue/{4 + stage}", 2 if stage else 1
        inner = np.maximum(
            _norm(nets, f"{at}.main.1", _conv(nets, f"{at}.main.0", x, stride, 1)), 0
        )
        inner = _norm(nets, f"{at}.main.4", _conv(nets, f"{at}.main.3", inner, 1, 1))
        if f"{at}.round.0.weight" in nets:
            x = _norm(nets, f"{at}.round.1", _conv(nets, f"{at}.round.0", x, stride, 0))
        x = np.maximum(inner + x, 0)
    head = STAGES + 6
    inner = np.maximum(_linear(nets, f"continue/{head}", x.mean((1, 2))), 0)
    score = float(_linear(nets, f"continue/{head + 2}", inner)[0])
    return float(1.0 / (1.0 + np.exp(-np.clip(score, -30, 30))))


def odds_of_classes(nets: PaperWeights, name: str, view: Values, counts: Values) -> Values:
    """Log odds of the classes of the next house, by the *category* network ``name``."""
    seen = np.concatenate([_encode(nets, f"{name}/seen", view), counts])
    return _linear(nets, f"{name}/head.2", np.maximum(_linear(nets, f"{name}/head.0", seen), 0))


def odds_of_places(nets: PaperWeights, planes: Values) -> Values:
    """Log odds (s, s) of the base point, by *location*; ``planes`` (20, s, s)."""
    x, at = planes, 0
    for _ in range(STAGES):
        x, at = _step(nets, f"location/{at}", f"location/{at + 1}", x, 2), at + 3
    for _ in range(STAGES):
        x = x.repeat(2, axis=1).repeat(2, axis=2)
        x, at = _step(nets, f"location/{at + 1}", f"location/{at + 2}", x, 1), at + 4
    return _conv(nets, f"location/{at}", x, 1, 0)[0]


def draw_cosine(nets: PaperWeights, view: Values, shape: Values, hidden: Values) -> float:
    """The cosine of the door angle, by *orientation*, for hidden values (HIDDEN,)."""
    seen = np.concatenate([_encode(nets, "orientation/seen", view), shape, hidden])
    inner = np.maximum(_linear(nets, "orientation/outer.0", seen), 0)
    return float(np.tanh(_linear(nets, "orientation/outer.2", inner)[0]))


def _encode(nets: PaperWeights, name: str, view: Values) -> Values:
    x = view
    for k in range(STAGES):
        x = _step(nets, f"{name}.{3 * k}", f"{name}.{3 * k + 1}", x, 2)
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
