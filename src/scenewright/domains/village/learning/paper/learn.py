"""``scenewright learn village --paper``: the paper's networks from any blocks, as a file."""

from __future__ import annotations

import hashlib
import os
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from scenewright.core.atomic_file import atomic_write
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.domains.village.learning.learn import (
    Cancel,
    LearnedStyle,
    Tell,
    check_learning,
    read_sources,
    split_by_place,
)
from scenewright.domains.village.learning.paper.batches import (
    PRINTED,
    Feed,
    PaperSchedule,
    PaperStep,
)
from scenewright.domains.village.learning.paper.nets import weights_of
from scenewright.domains.village.learning.paper.training import (
    NetsTraining,
    keep_nets,
    resume_nets,
    start_nets,
    train_nets,
)
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.paper import nets_file
from scenewright.domains.village.paper.nets_file import PaperNets, write_paper_nets

SIZES = {"printed": nets_file.PRINTED, "small": nets_file.SMALL}
DEVICES = ("cpu", "cuda")
KEPT_EVERY = 60.0
"""Seconds after which the state of a training is kept anew; it also is whenever it ends."""


class NetsOptions(NamedTuple):
    """How networks are learned: the ``seed``; places ``held`` out (none: about a fifth of the
    blocks); ``kinds`` of places (none: all); ``epochs`` of each network at most (None: as printed);
    a ``budget`` of processor seconds; the ``size``, ``device``, and worker processes that make
    views (``jobs``; None: one less than there are cores); ``licence`` of the data, for the card."""

    seed: int = 0
    held: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()
    epochs: int | None = None
    budget: float | None = None
    licence: str = ""
    size: str = "printed"
    device: str = "cpu"
    jobs: int | None = None


def learn_nets(
    sources: Sequence[Path],
    output: Path,
    given: Mapping[str, Any],
    read_plan: Callable[[Path], Plan],
    tell: Tell,
    cancel: Cancel,
) -> LearnedStyle:
    """Train the paper's networks on files or folders of blocks and write them to ``output``;
    ``given`` are :class:`NetsOptions`.

    The state stays beside the file until all printed epochs are done: the same command goes on
    after Ctrl-C or a kill, and one with more epochs or a larger budget goes on from there.
    """
    options = NetsOptions(**given)
    check_learning(output)
    torch = _torch(options)
    blocks = read_sources(sources, options.kinds, read_plan)
    train, test = split_by_place(blocks, options.held, options.seed)
    tell(0.0, f"{len(train)} blocks to learn from, {len(test)} held out")
    feed = Feed(train, SIZES[options.size], _schedule(options), options.seed)
    path, key = output.with_suffix(".training.pt"), _key(feed)
    state = resume_nets(
        torch, path, key, lambda: start_nets(torch, feed, options.device), options.device
    )
    took, whole = _train(torch, feed, state, options, (path, key), tell, cancel)
    if not whole:
        return LearnedStyle({"steps": sum(state.done.values())}, took, False)
    made = PaperNets(feed.sizes, weights_of(state.nets), _card(feed, state, test, options))
    with atomic_write(output) as partial:
        write_paper_nets(partial, made)
    if all(_epochs(feed, state)[name] >= PRINTED.epochs[name] for name in state.nets):
        path.unlink(missing_ok=True)
    return LearnedStyle(made.card, took, True)


def _torch(options: NetsOptions) -> Any:
    """PyTorch on one thread (so that the same seed gives the same bytes), its options checked."""
    import torch

    for what, value, known in (("size", options.size, SIZES), ("device", options.device, DEVICES)):
        if value not in known:
            raise InputError(f"unknown {what} '{value[:40]}'", f"use one of: {', '.join(known)}")
    if options.device == "cuda" and not torch.cuda.is_available():
        raise InputError("torch finds no GPU on this machine", "leave --device cuda out")
    torch.set_num_threads(1)
    return torch


def _schedule(options: NetsOptions) -> PaperSchedule:
    most = options.epochs or max(PRINTED.epochs.values())
    return PRINTED._replace(epochs={n: min(most, e) for n, e in PRINTED.epochs.items()})


def _train(
    torch: Any,
    feed: Feed,
    state: NetsTraining,
    options: NetsOptions,
    kept: tuple[Path, str],
    tell: Tell,
    cancel: Cancel,
) -> tuple[float, bool]:
    """The processor seconds all of it took, and whether it is whole or the budget ended it."""
    begun, saved = time.process_time(), [time.monotonic()]
    houses, epochs = feed.houses, feed.schedule.epochs
    total = sum(feed.schedule.steps_each(name, houses) * epochs[name] for name in epochs)

    def took() -> float:
        return state.seconds + time.process_time() - begun

    def spent() -> bool:
        return options.budget is not None and took() >= options.budget

    def done(step: PaperStep, loss: float) -> bool:
        count = sum(state.done.values())
        tell(count / total, f"{step.name} {step.epoch + 1}/{epochs[step.name]}: loss {loss:.3f}")
        if time.monotonic() - saved[0] > KEPT_EVERY:
            keep_nets(torch, *kept, state, took())
            saved[0] = time.monotonic()
        return cancel() or spent()

    workers = max((os.cpu_count() or 1) - 1, 0) if options.jobs is None else options.jobs
    if spent():
        return took(), True
    whole = train_nets(torch, state, feed, options.device, workers, done)
    keep_nets(torch, *kept, state, took())
    return took(), whole or spent()


def _epochs(feed: Feed, state: NetsTraining) -> dict[str, float]:
    """Epochs done of each network."""
    each = {name: feed.schedule.steps_each(name, feed.houses) for name in state.done}
    return {name: round(done / each[name], 2) for name, done in state.done.items()}


def _card(
    feed: Feed, state: NetsTraining, test: Sequence[RealBlock], options: NetsOptions
) -> dict[str, Any]:
    """What a file of networks tells of itself."""
    done = _epochs(feed, state)
    return {
        "licence": options.licence or "that of its data",
        "size": options.size,
        "seed": options.seed,
        "blocks": len(feed.blocks),
        "houses": feed.houses,
        "places": sorted({block.place for block in feed.blocks}),
        "held_out": sorted({block.place for block in test}),
        "doors": "known" if all(block.doors for block in feed.blocks) else "assumed",
        "materials": "known" if all(block.materials for block in feed.blocks) else "all of a kind",
        "epochs": done,
        "share_of_printed_epochs": round(sum(done.values()) / sum(PRINTED.epochs.values()), 4),
    }


def _key(feed: Feed) -> str:
    """What tells one training from another: its blocks, sizes and seed, not its length."""
    digest = hashlib.sha256(f"{feed.seed} {feed.sizes}".encode())
    for block in feed.blocks:
        digest.update(f"{block.name} {block.floor.wkt} {block.materials}".encode())
        for ring in (*block.houses, *block.doors):
            digest.update(np.round(ring, 3).tobytes())
    return digest.hexdigest()
