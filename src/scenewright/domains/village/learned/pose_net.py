"""The net that says how likely poses are, as a pass forward over plain arrays.

A relational transformer: the house itself, the six nearest houses and the four nearest sides are
one token each; a query about the house attends to all. Layers are as Vaswani and others (2017) with
the norm before (Xiong and others 2020) and GELU in its tanh form (Hendrycks and Gimpel 2016); the
last layer asks for the first token only. Trained by ``learning.pose_training`` in PyTorch, whose
pass is the same formula (a test compares them).
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.village.learned.tokens import HOUSE, SELF, SIDE, PoseTokens

Weights = Mapping[str, NDArray[np.float32]]
"""Arrays of a net by name."""

WIDTH, HEADS, LAYERS = 64, 4, 2
HIDDEN = 128
"""Width of what a token is turned into, heads, layers, and the width inside a layer."""
FAR_OFF = -1e9


def shapes_of_net() -> dict[str, tuple[int, ...]]:
    """The names of all weights of the net and their shapes.

    >>> sum(int(np.prod(shape)) for shape in shapes_of_net().values()) < 400_000
    True
    """
    found: dict[str, tuple[int, ...]] = {}
    for name, size in (("own", SELF), ("house", HOUSE), ("side", SIDE)):
        found |= {f"{name}.w": (size, WIDTH), f"{name}.b": (WIDTH,)}
    for layer in range(LAYERS):
        at = f"layer{layer}"
        found |= {f"{at}.norm1.g": (WIDTH,), f"{at}.norm1.b": (WIDTH,)}
        found |= {f"{at}.{part}.w": (WIDTH, WIDTH) for part in ("ask", "key", "value", "out")}
        found |= {f"{at}.{part}.b": (WIDTH,) for part in ("ask", "value", "out")}
        found |= {f"{at}.norm2.g": (WIDTH,), f"{at}.norm2.b": (WIDTH,)}
        found |= {f"{at}.up.w": (WIDTH, HIDDEN), f"{at}.up.b": (HIDDEN,)}
        found |= {f"{at}.down.w": (HIDDEN, WIDTH), f"{at}.down.b": (WIDTH,)}
    return found | {"last.g": (WIDTH,), "last.b": (WIDTH,), "score.w": (WIDTH, 1)}


def score_poses(weights: Weights, tokens: PoseTokens) -> NDArray[np.float64]:
    """Log weights (k,) of poses, up to a constant: how much likelier each is than proposals say."""
    x = np.concatenate(
        [
            _linear(weights, "own", tokens.own.astype(np.float32))[:, None],
            _linear(weights, "house", tokens.houses.astype(np.float32)),
            _linear(weights, "side", tokens.sides.astype(np.float32)),
        ],
        1,
    )
    known = np.concatenate([np.ones((len(x), 1), bool), tokens.known], 1)
    for layer in range(LAYERS):
        x = _layer(weights, f"layer{layer}", x, known, layer == LAYERS - 1)
    found = _norm(weights, "last", x[:, 0]) @ weights["score.w"]
    return np.asarray(found[:, 0], float)


def _linear(weights: Weights, name: str, x: NDArray[np.float32]) -> NDArray[np.float32]:
    flat = x.reshape(-1, x.shape[-1]) @ weights[f"{name}.w"]
    bias = weights.get(f"{name}.b")
    return (flat if bias is None else flat + bias).reshape(*x.shape[:-1], -1)


def _norm(weights: Weights, name: str, x: NDArray[np.float32]) -> NDArray[np.float32]:
    x = x - x.mean(-1, keepdims=True)
    scale = np.sqrt((x * x).mean(-1, keepdims=True) + np.float32(1e-5))
    return x / scale * weights[f"{name}.g"] + weights[f"{name}.b"]


def _layer(
    weights: Weights, name: str, x: NDArray[np.float32], known: NDArray[np.bool_], last: bool
) -> NDArray[np.float32]:
    seen = _norm(weights, f"{name}.norm1", x)
    asking = seen[:, :1] if last else seen
    ask, key, value = (
        _heads(_linear(weights, f"{name}.{part}", of))
        for part, of in (("ask", asking), ("key", seen), ("value", seen))
    )
    odds = ask @ key.swapaxes(-1, -2) / np.float32(np.sqrt(WIDTH / HEADS))
    odds = np.where(known[:, None, None], odds, np.float32(FAR_OFF))
    odds = np.exp(odds - odds.max(-1, keepdims=True))
    mixed = (odds / odds.sum(-1, keepdims=True)) @ value
    mixed = mixed.swapaxes(1, 2).reshape(len(x), -1, WIDTH)
    x = (x[:, :1] if last else x) + _linear(weights, f"{name}.out", mixed)
    inner = _linear(weights, f"{name}.up", _norm(weights, f"{name}.norm2", x))
    return x + _linear(weights, f"{name}.down", _gelu(inner))


def _heads(x: NDArray[np.float32]) -> NDArray[np.float32]:
    return x.reshape(*x.shape[:2], HEADS, -1).swapaxes(1, 2)


def _gelu(x: NDArray[np.float32]) -> NDArray[np.float32]:
    c = np.float32(np.sqrt(2 / np.pi))
    return np.float32(0.5) * x * (1 + np.tanh(c * (x + np.float32(0.044715) * x * x * x)))
