"""Training the net of poses in PyTorch (extra ``learn``): the real pose against legal proposals.

The loss is the cross entropy of the real pose among what was proposed, so that what is learned is
log p(real) - log p(proposed) (noise-contrastive in the form of van den Oord and others 2018): poses
drawn from the proposals by these weights stand as real houses do. Steps are AdamW (Loshchilov and
Hutter 2019), the rate rises, then falls as a cosine. Every round sees some blocks in fresh states;
its random numbers follow from the seed and its number alone, so a run that was stopped goes on as
if it had not been.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from scenewright.domains.village.learned.pose_net import (
    FAR_OFF,
    HEADS,
    LAYERS,
    WIDTH,
    score_poses,
    shapes_of_net,
)
from scenewright.domains.village.learned.style import VillageStyle
from scenewright.domains.village.learned.tokens import PoseTokens
from scenewright.domains.village.learning.examples import (
    CHOICES,
    PoseExample,
    examples_of,
    pad_examples,
)
from scenewright.domains.village.learning.tables import RealBlock

Arrays = dict[str, np.ndarray]

EPOCHS, BLOCKS, BATCH = 6, 64, 64
"""How often every block is seen, blocks of a round, houses of a step."""
RATE, RISE, DECAY, CLIP = 1.5e-3, 100, 0.05, 1.0
"""Greatest rate, steps until it is reached, weight decay, greatest length of a gradient."""
BETAS, TINY = (0.9, 0.98), 1e-8


class TrainingState(NamedTuple):
    """Training so far: weights, both moments of their gradients, steps and rounds done, and the
    mean loss of each round."""

    weights: Arrays
    first: Arrays
    second: Arrays
    steps: int
    rounds: int
    losses: tuple[float, ...]


def start_training(seed: int) -> TrainingState:
    """The state before the first step: uniform as Glorot and Bengio (2010), norms 1, biases 0."""
    rng = np.random.default_rng(seed)
    weights: Arrays = {}
    for name, shape in shapes_of_net().items():
        bound = np.sqrt(6.0 / sum(shape)) * (0.1 if name == "score.w" else 1.0)
        value = rng.uniform(-bound, bound, shape) if name.endswith(".w") else np.zeros(shape)
        weights[name] = (value + name.endswith(".g")).astype(np.float32)
    zeros = {name: np.zeros_like(value) for name, value in weights.items()}
    return TrainingState(weights, zeros, dict(zeros), 0, 0, ())


def rounds_of(blocks: Sequence[RealBlock], epochs: int = EPOCHS) -> int:
    """Rounds of a whole training."""
    return epochs * -(-len(blocks) // BLOCKS)


def train_poses(
    state: TrainingState,
    blocks: Sequence[RealBlock],
    style: VillageStyle,
    seed: int,
    total: int,
    done: Callable[[TrainingState], bool],
) -> TrainingState:
    """Go on from a state to ``total`` rounds; ``done`` follows every round and may end it."""
    import torch

    torch.set_num_threads(1)
    while state.rounds < total:
        rows = round_examples(blocks, style, seed, state.rounds)
        state = _round(torch, state, rows, total)
        if done(state):
            break
    return state


def round_examples(
    blocks: Sequence[RealBlock], style: VillageStyle, seed: int, number: int
) -> list[PoseExample]:
    """The examples of one round, shuffled."""
    each = -(-len(blocks) // BLOCKS)
    epoch, part = divmod(number, each)
    order = np.random.default_rng([seed, 1, epoch]).permutation(len(blocks))
    rng = np.random.default_rng([seed, 2, number])
    chosen = np.array_split(order, each)[part].tolist()
    found = [row for k in chosen for row in examples_of(blocks[k], style, rng)]
    return [found[k] for k in rng.permutation(len(found)).tolist()]


def _round(torch: Any, state: TrainingState, rows: list[PoseExample], total: int) -> TrainingState:
    tensors, first, second = (
        {name: torch.from_numpy(value.copy()) for name, value in group.items()}
        for group in state[:3]
    )
    losses, step = [], state.steps
    planned = total * max(1, round(len(rows) / BATCH))
    for at in range(0, len(rows), BATCH):
        if len(rows) - at < BATCH // 2 and at:
            break
        for value in tensors.values():
            value.requires_grad_(True)
        loss = loss_of(torch, tensors, rows[at : at + BATCH])
        slopes = torch.autograd.grad(loss, list(tensors.values()))
        losses.append(loss.item())
        step += 1
        rate = RATE * min(1.0, step / RISE) * 0.5 * (1 + np.cos(np.pi * min(1.0, step / planned)))
        tensors = _step(torch, tensors, slopes, (first, second), step, rate)
    weights, *moments = (
        {name: value.detach().numpy() for name, value in group.items()}
        for group in (tensors, first, second)
    )
    mean = float(np.mean(losses)) if losses else float("nan")
    return TrainingState(
        weights, moments[0], moments[1], step, state.rounds + 1, (*state.losses, mean)
    )


def _step(
    torch: Any,
    weights: dict[str, Any],
    slopes: Sequence[Any],
    moments: tuple[dict[str, Any], dict[str, Any]],
    step: int,
    rate: float,
) -> dict[str, Any]:
    """Weights after one step of AdamW; the moments are changed in place."""
    with torch.no_grad():
        length = float(torch.sqrt(sum((slope**2).sum() for slope in slopes)))
        scale = min(1.0, CLIP / (length + 1e-6))
        found = {}
        for (name, value), slope in zip(weights.items(), slopes, strict=True):
            first, second = moments[0][name], moments[1][name]
            first.mul_(BETAS[0]).add_(slope * scale, alpha=1 - BETAS[0])
            second.mul_(BETAS[1]).add_((slope * scale) ** 2, alpha=1 - BETAS[1])
            by = first / (1 - BETAS[0] ** step)
            by = by / (torch.sqrt(second / (1 - BETAS[1] ** step)) + TINY)
            kept = 1 - rate * DECAY if name.endswith(".w") else 1.0
            found[name] = (value * kept - rate * by).detach()
    return found


def loss_of(torch: Any, weights: dict[str, Any], rows: Sequence[PoseExample]) -> Any:
    """The mean cross entropy of the real poses of some examples."""
    tokens, there = pad_examples(rows, CHOICES)
    scores = score_tensors(torch, weights, to_tensors(torch, tokens)).reshape(len(rows), -1)
    scores = scores.masked_fill(~torch.from_numpy(there), FAR_OFF)
    first = torch.zeros(len(rows), dtype=torch.long)
    return torch.nn.functional.cross_entropy(scores, first)


def mean_loss(style: VillageStyle, blocks: Sequence[RealBlock], seed: int) -> tuple[float, float]:
    """The mean cross entropy of the real poses of some blocks by a style's net, and by chance."""
    rng = np.random.default_rng([seed, 5])
    losses, even = [], []
    for block in blocks:
        for row in examples_of(block, style, rng):
            scores = score_poses(style.poses, row.tokens)
            most = scores.max()
            losses.append(most + np.log(np.exp(scores - most).sum()) - scores[0])
            even.append(np.log(len(scores)))
    return float(np.mean(losses)), float(np.mean(even))


def to_tensors(torch: Any, tokens: PoseTokens) -> tuple[Any, ...]:
    """Features of poses (b, k, …) as tensors (b k, …)."""
    return tuple(torch.from_numpy(part.reshape(-1, *part.shape[2:])) for part in tokens)


def score_tensors(torch: Any, weights: dict[str, Any], tokens: tuple[Any, ...]) -> Any:
    """The pass of :func:`learned.pose_net.score_poses` over tensors (k, …)."""
    functional = torch.nn.functional
    own, houses, sides, known = tokens

    def linear(name: str, x: Any) -> Any:
        found = x @ weights[f"{name}.w"]
        return found + weights[f"{name}.b"] if f"{name}.b" in weights else found

    def norm(name: str, x: Any) -> Any:
        return functional.layer_norm(x, (WIDTH,), weights[f"{name}.g"], weights[f"{name}.b"])

    def heads(x: Any) -> Any:
        return x.reshape(len(x), x.shape[1], HEADS, -1).transpose(1, 2)

    x = torch.cat([linear("own", own)[:, None], linear("house", houses), linear("side", sides)], 1)
    known = torch.cat([torch.ones_like(known[:, :1]), known], 1)
    for layer in range(LAYERS):
        at, last = f"layer{layer}", layer == LAYERS - 1
        seen = norm(f"{at}.norm1", x)
        ask = heads(linear(f"{at}.ask", seen[:, :1] if last else seen))
        key, value = heads(linear(f"{at}.key", seen)), heads(linear(f"{at}.value", seen))
        odds = ask @ key.transpose(-1, -2) / (WIDTH / HEADS) ** 0.5
        odds = odds.masked_fill(~known[:, None, None], FAR_OFF).softmax(-1)
        mixed = (odds @ value).transpose(1, 2).reshape(len(x), -1, WIDTH)
        x = (x[:, :1] if last else x) + linear(f"{at}.out", mixed)
        inner = linear(f"{at}.up", norm(f"{at}.norm2", x))
        x = x + linear(f"{at}.down", functional.gelu(inner, approximate="tanh"))
    return (norm("last", x[:, 0]) @ weights["score.w"])[:, 0]
