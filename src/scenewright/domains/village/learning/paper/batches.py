"""Batches of samples, each by its own random numbers, made by worker processes if any are asked.

A step of a network is drawn by the seed and its own number alone, so that neither the number of
workers nor where a training was stopped changes what is learned.
"""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache, partial
from itertools import islice
from multiprocessing.connection import Connection
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.errors import InputError
from scenewright.domains.village.learning.paper.samples import PaperSample, sample_of, tell_block
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.paper.nets_file import ASKED, NetSizes
from scenewright.domains.village.paper.views import SHAPES, class_planes

Values = NDArray[np.float32]


class PaperSchedule(NamedTuple):
    """Samples of a step and epochs of each network; an epoch is one sample of every house."""

    batch: Mapping[str, int]
    epochs: Mapping[str, int]

    def steps_each(self, name: str, houses: int) -> int:
        """Steps of an epoch of a network.

        >>> PRINTED.steps_each("orientation", 5393)
        1349
        """
        return -(-houses // self.batch[name])


PRINTED = PaperSchedule(
    dict(zip(ASKED, (8, 16, 16, 16, 16, 4), strict=True)),
    dict(zip(ASKED, (120, 300, 300, 300, 300, 400), strict=True)),
)


class PaperStep(NamedTuple):
    """A step of a network: its epoch, and its number in that."""

    name: str
    epoch: int
    number: int


class PaperBatch(NamedTuple):
    """What a step sees: ``planes`` (b, 12 or 20, s, s), the count vectors (b, 8), classes of the
    next house (b, 3), the number of its base point's pixel (b,), its shape (b, 2), the cosine of
    its door angle (b,), whether houses are missing (b,), and normal noise (b, hidden)."""

    planes: Values
    counts: Values
    classes: NDArray[np.int64]
    pixels: NDArray[np.int64]
    shapes: Values
    cosines: Values
    more: Values
    noise: Values


class Feed(NamedTuple):
    """What batches are made of: blocks, sizes of the networks, the schedule and the seed."""

    blocks: Sequence[RealBlock]
    sizes: NetSizes
    schedule: PaperSchedule
    seed: int

    @property
    def houses(self) -> int:
        """How many samples an epoch has."""
        return sum(len(block.houses) for block in self.blocks)


def steps_left(feed: Feed, done: Mapping[str, int]) -> Iterator[PaperStep]:
    """The steps that are left of a training: epoch by epoch, all networks in turn."""
    epochs = feed.schedule.epochs
    for epoch in range(max(epochs.values(), default=0)):
        for name in (name for name in epochs if epoch < epochs[name]):
            each = feed.schedule.steps_each(name, feed.houses)
            for number in range(max(done[name] - epoch * each, 0), each):
                yield PaperStep(name, epoch, number)


def make_batches(feed: Feed, steps: Iterator[PaperStep]) -> Iterator[PaperBatch]:
    """The batch of each step, one after the other."""
    told = lru_cache(maxsize=None)(lambda k: tell_block(feed.blocks[k], feed.sizes.pixels))
    owner = np.repeat(np.arange(len(feed.blocks)), [len(block.houses) for block in feed.blocks])
    for step in steps:
        number, each = ASKED.index(step.name), feed.schedule.steps_each(step.name, len(owner))
        order = np.random.default_rng([feed.seed, number, step.epoch]).permutation(owner)
        rng = np.random.default_rng([feed.seed, number, step.epoch, step.number])
        rows = np.array_split(order, each)[step.number].tolist()
        samples = [sample_of(told(k), rng, step.name) for k in rows]
        yield _stack(samples, step.name, rng.normal(size=(len(rows), feed.sizes.hidden)))


def _stack(samples: Sequence[PaperSample], name: str, noise: NDArray[np.float64]) -> PaperBatch:
    planes = [one.view for one in samples]
    if name == "location":
        size = planes[0].shape[-1]
        planes = [np.concatenate([s.view, class_planes(s.classes, size)]) for s in samples]
    classes = np.array([one.classes for one in samples])
    single = partial(np.array, dtype=np.float32)
    return PaperBatch(
        np.stack(planes),
        single([one.counts for one in samples]),
        classes,
        np.array([one.pixel for one in samples]),
        np.eye(SHAPES, dtype=np.float32)[classes[:, 1]],
        single([one.cosine for one in samples]),
        single([one.more for one in samples]),
        noise.astype(np.float32),
    )


def feed_batches(feed: Feed, done: Mapping[str, int], workers: int) -> Iterator[PaperBatch]:
    """The batch of each step that is left, made by ``workers`` processes (0: by this one)."""
    if not workers:
        yield from make_batches(feed, steps_left(feed, done))
        return
    context = multiprocessing.get_context("spawn")
    ends = [context.Pipe(duplex=False) for _ in range(workers)]
    served = [
        context.Process(target=_serve, args=(end, feed, dict(done), k, workers), daemon=True)
        for k, (_, end) in enumerate(ends)
    ]
    try:
        for process, (_, end) in zip(served, ends, strict=True):
            process.start()
            end.close()
        for number, _ in enumerate(steps_left(feed, done)):
            yield _receive(ends[number % workers][0])
    finally:
        for process in served:
            process.kill()
            process.join()


def _receive(end: Connection) -> PaperBatch:
    try:
        batch: PaperBatch = end.recv()
    except EOFError:
        raise InputError("a worker that makes views was ended", "give fewer --jobs") from None
    return batch


def _serve(end: Connection, feed: Feed, done: dict[str, int], first: int, every: int) -> None:
    """Send each ``every``-th batch until nobody receives; Ctrl-C is left to the parent."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        for batch in make_batches(feed, islice(steps_left(feed, done), first, None, every)):
            end.send(batch)
    except (BrokenPipeError, ConnectionResetError):
        return
