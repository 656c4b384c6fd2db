"""Training the networks of Zhu, Jiang and Li (2022) in PyTorch, by steps that can be kept.

Printed: cross entropy of *continue*, *category* and *location*, KL and the loss of the cosine added
up for *orientation* (of the cosine: its square, not printed); the rate 0.001; Adam for *category*
and *location*, here for all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from scenewright.core.atomic_file import atomic_write
from scenewright.domains.village.learning.paper.batches import (
    Feed,
    PaperBatch,
    PaperStep,
    feed_batches,
    steps_left,
)
from scenewright.domains.village.learning.paper.nets import make_nets
from scenewright.domains.village.paper.nets_file import CLASSES

RATE = 1e-3


class NetsTraining(NamedTuple):
    """Networks and their optimizers in PyTorch, by name, steps ``done`` of each, and the processor
    ``seconds`` they took until the state was read. They are changed in place."""

    nets: dict[str, Any]
    wheels: dict[str, Any]
    done: dict[str, int]
    seconds: float


def start_nets(torch: Any, feed: Feed, device: str) -> NetsTraining:
    """Networks of a schedule as they are before the first step, by the seed."""
    torch.manual_seed(feed.seed)
    made = make_nets(torch, feed.sizes)
    nets = {name: made[name].to(device).train() for name in feed.schedule.epochs}
    wheels = {name: torch.optim.Adam(net.parameters(), lr=RATE) for name, net in nets.items()}
    return NetsTraining(nets, wheels, dict.fromkeys(nets, 0), 0.0)


def train_nets(
    torch: Any,
    state: NetsTraining,
    feed: Feed,
    device: str,
    workers: int,
    done: Callable[[PaperStep, float], bool],
) -> bool:
    """Go through the steps that are left; ``done`` gets each with its loss and may end it (the
    answer is False then)."""
    steps: Iterator[PaperStep] = steps_left(feed, dict(state.done))
    batches = feed_batches(feed, dict(state.done), workers)
    try:
        for step, batch in zip(steps, batches, strict=True):
            loss = loss_of_net(torch, step.name, state.nets[step.name], batch, device)
            state.wheels[step.name].zero_grad()
            loss.backward()
            state.wheels[step.name].step()
            state.done[step.name] += 1
            if done(step, loss.item()):
                return False
    finally:
        batches.close()  # type: ignore[attr-defined]
    return True


def loss_of_net(torch: Any, name: str, net: Any, batch: PaperBatch, device: str = "cpu") -> Any:
    """The loss of one network on a batch."""
    functional = torch.nn.functional
    on = {
        key: torch.from_numpy(value).to(device, non_blocking=True)
        for key, value in batch._asdict().items()
    }
    if name == "continue":
        found = net(on["planes"])[:, 0]
        return functional.binary_cross_entropy_with_logits(found, on["more"])
    if name in CLASSES:
        wanted = on["classes"][:, list(CLASSES).index(name)]
        return functional.cross_entropy(net(on["planes"], on["counts"]), wanted)
    if name == "location":
        return functional.cross_entropy(net(on["planes"]).flatten(1), on["pixels"])
    again, mean, spread = net(on["planes"], on["shapes"], on["cosines"], on["noise"])
    hidden = -0.5 * (1 + spread - mean**2 - spread.exp()).sum(1).mean()
    return ((again - on["cosines"]) ** 2).mean() + hidden


def keep_nets(torch: Any, path: Path, key: str, state: NetsTraining, seconds: float) -> None:
    """Keep a state in a file: ``key`` identifies the training, ``seconds`` is what it took."""
    document = {
        "key": key,
        "done": state.done,
        "seconds": seconds,
        "nets": {name: net.state_dict() for name, net in state.nets.items()},
        "wheels": {name: wheel.state_dict() for name, wheel in state.wheels.items()},
    }
    with atomic_write(path) as partial:
        torch.save(document, partial)


def resume_nets(
    torch: Any, path: Path, key: str, fresh: Callable[[], NetsTraining], device: str
) -> NetsTraining:
    """The state kept of this very training; else, or where the file is damaged, a fresh one."""
    state = fresh()
    try:
        kept = torch.load(path, map_location=device, weights_only=True)
        if kept["key"] != key:
            return state
        for name, net in state.nets.items():
            net.load_state_dict(kept["nets"][name])
            state.wheels[name].load_state_dict(kept["wheels"][name])
        done = {name: int(kept["done"][name]) for name in state.nets}
        return state._replace(done=done, seconds=float(kept["seconds"]))
    except Exception:  # whatever was kept and is damaged is trained again
        return fresh()
