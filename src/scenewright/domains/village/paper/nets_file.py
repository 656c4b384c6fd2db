"""The networks of Zhu, Jiang and Li (2022) as a file: their sizes, every array by name, a card.

The file is a plain ``.npz``. Its card states as JSON the sizes of the networks and how they
were trained; the arrays must be of these sizes. Nothing in it is run.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.array_archive import read_arrays
from scenewright.core.errors import InputError
from scenewright.core.stored_file import MEBIBYTE, report_damage
from scenewright.domains.village.paper.views import AREAS, CHANNELS, COUNTED, MATERIALS, SHAPES

Values = NDArray[np.float32]
Shapes = Iterator[tuple[str, tuple[int, ...]]]
PaperWeights = Mapping[str, Values]
"""Arrays of all networks by ``network/layer``, as PyTorch calls the layers."""

SHIPPED = Path(__file__).parent / "small.npz"
CLASSES = {"material": MATERIALS, "shape": SHAPES, "area": AREAS}
ASKED = ("continue", *CLASSES, "location", "orientation")
FORMAT, LARGEST, WIDEST, MOST_PIXELS = 1, 512 * MEBIBYTE, 4096, 1024
REMEDY = "give a file that scenewright learn village --paper has written"


class NetSizes(NamedTuple):
    """Sizes: pixels of a view, channels and blocks of each stage of *continue*, channels of the
    CNNs, of the MLPs, and hidden values of *orientation*."""

    pixels: int
    stages: tuple[tuple[int, int], ...]
    channels: tuple[int, ...]
    mlp: int
    hidden: int


PRINTED = NetSizes(256, ((64, 3), (128, 4), (256, 6), (512, 3)), (32, 64, 128, 256), 128, 40)
SMALL = NetSizes(64, ((16, 1), (32, 1), (64, 1)), (16, 32, 64), 64, 16)


class PaperNets(NamedTuple):
    """All networks: their sizes, their arrays and what the card tells of them."""

    sizes: NetSizes
    weights: PaperWeights
    card: dict[str, Any]


@lru_cache(maxsize=1)
def shipped_nets() -> PaperNets:
    """The small form that ships.

    >>> sum(v.size for v in shipped_nets().weights.values()) < 400_000
    True
    """
    return read_paper_nets(SHIPPED)


def read_paper_nets(path: Path) -> PaperNets:
    """The networks of a file, of any sizes; InputError, in one line, for anything that is none."""
    with report_damage(path, "a file of the paper's networks", REMEDY):
        arrays = read_arrays(path, LARGEST)
        card = _card(arrays)
        sizes = _sizes(card)
        found = {name: _array(arrays, name, shape) for name, shape in shapes_of_nets(sizes)}
        return PaperNets(sizes, found, card)


def write_paper_nets(path: Path, nets: PaperNets) -> None:
    """Write networks, in half precision; the same networks give the same bytes."""
    found = {name: value.astype(np.float16) for name, value in nets.weights.items()}
    card = {"format": FORMAT, **nets.card, **nets.sizes._asdict()}
    document = json.dumps(card, sort_keys=True, ensure_ascii=False)
    found["card"] = np.frombuffer(document.encode(), np.uint8)
    with path.open("wb") as file:
        np.savez(file, allow_pickle=False, **found)


def shapes_of_nets(sizes: NetSizes) -> Shapes:
    """Every array by name, and its shape."""
    before = sizes.stages[0][0]
    yield from _convolution("continue/0", before, CHANNELS, 7, False)
    yield from _norm("continue/1", before)
    for number, width, stride in blocks_of(sizes):
        at = f"continue/{number}"
        yield from _convolution(f"{at}.main.0", width, before, 3, False)
        yield from _norm(f"{at}.main.1", width)
        yield from _convolution(f"{at}.main.3", width, width, 3, False)
        yield from _norm(f"{at}.main.4", width)
        if stride > 1 or before != width:
            yield from _convolution(f"{at}.round.0", width, before, 1, False)
            yield from _norm(f"{at}.round.1", width)
        before = width
    head = head_of(sizes)
    yield from _linear(f"continue/{head}", sizes.mlp, before)
    yield from _linear(f"continue/{head + 2}", 1, sizes.mlp)
    seen = 4 * sizes.channels[-1]
    for name, count in CLASSES.items():
        yield from _encoder(name, sizes)
        yield from _linear(f"{name}/head.0", sizes.mlp, seen + COUNTED)
        yield from _linear(f"{name}/head.2", count, sizes.mlp)
    yield from _shapes_of_location(sizes)
    yield from _encoder("orientation", sizes)
    yield from _linear("orientation/inner.0", sizes.mlp, seen + SHAPES + 1)
    yield from _linear("orientation/mean", sizes.hidden, sizes.mlp)
    yield from _linear("orientation/spread", sizes.hidden, sizes.mlp)
    yield from _linear("orientation/outer.0", sizes.mlp, seen + SHAPES + sizes.hidden)
    yield from _linear("orientation/outer.2", 1, sizes.mlp)


def blocks_of(sizes: NetSizes) -> list[tuple[int, int, int]]:
    """Number, channels and stride of each block of *continue*; the first stage strides no more."""
    rows = [
        (width, 2 if stage and not k else 1)
        for stage, (width, blocks) in enumerate(sizes.stages)
        for k in range(blocks)
    ]
    return [(4 + number, *row) for number, row in enumerate(rows)]


def head_of(sizes: NetSizes) -> int:
    """The number of the first layer of the MLP of *continue*.

    >>> head_of(SMALL), head_of(PRINTED)
    (9, 22)
    """
    return 6 + sum(blocks for _, blocks in sizes.stages)


def widths_up(sizes: NetSizes) -> tuple[int, ...]:
    """Channels of *location* on its way up to the pixels again."""
    return (*sizes.channels[-2::-1], sizes.channels[0])


def _shapes_of_location(sizes: NetSizes) -> Shapes:
    before, at = CHANNELS + COUNTED, 0
    for width in sizes.channels:
        yield from _convolution(f"location/{at}", width, before, 3)
        yield from _norm(f"location/{at + 1}", width)
        before, at = width, at + 3
    for width in widths_up(sizes):
        yield from _convolution(f"location/{at + 1}", width, before, 3)
        yield from _norm(f"location/{at + 2}", width)
        before, at = width, at + 4
    yield from _convolution(f"location/{at}", 1, before, 1)


def _encoder(name: str, sizes: NetSizes) -> Shapes:
    before = CHANNELS
    for k, width in enumerate(sizes.channels):
        yield from _convolution(f"{name}/seen.{3 * k}", width, before, 3)
        yield from _norm(f"{name}/seen.{3 * k + 1}", width)
        before = width


def _convolution(name: str, out: int, into: int, side: int, biased: bool = True) -> Shapes:
    yield f"{name}.weight", (out, into, side, side)
    if biased:
        yield f"{name}.bias", (out,)


def _norm(name: str, width: int) -> Shapes:
    for part in ("weight", "bias", "running_mean", "running_var"):
        yield f"{name}.{part}", (width,)


def _linear(name: str, out: int, into: int) -> Shapes:
    yield f"{name}.weight", (out, into)
    yield f"{name}.bias", (out,)


def _card(arrays: Mapping[str, NDArray[Any]]) -> dict[str, Any]:
    if "card" not in arrays:
        raise InputError("holds no networks of the paper: its card is missing", REMEDY)
    card = json.loads(bytes(arrays["card"].astype(np.uint8)).decode())
    if not isinstance(card, dict) or card.get("format") != FORMAT or "pixels" not in card:
        raise InputError("holds no networks of the paper: its card tells no sizes", REMEDY)
    return card


def _sizes(card: Mapping[str, Any]) -> NetSizes:
    stages = tuple((int(width), int(blocks)) for width, blocks in card["stages"])
    channels = tuple(int(width) for width in card["channels"])
    mlp, hidden = int(card["mlp"]), int(card["hidden"])
    sizes = NetSizes(int(card["pixels"]), stages, channels, mlp, hidden)
    every = [mlp, hidden, *channels, *(value for stage in stages for value in stage)]
    known = 0 < len(stages) <= 8 and 0 < len(channels) <= 8
    if not known or not 0 < min(every) <= max(every) <= WIDEST:
        raise InputError("holds no networks of the paper: its sizes are none", REMEDY)
    least = 2 ** (max(len(channels), len(stages)) + 1)
    if sizes.pixels % least or not 0 < sizes.pixels <= MOST_PIXELS:
        fault = f"has views of {sizes.pixels} pixels, not of a multiple of {least}"
        raise InputError(f"{fault} up to {MOST_PIXELS}", REMEDY)
    return sizes


def _array(arrays: Mapping[str, NDArray[Any]], name: str, shape: tuple[int, ...]) -> Values:
    value = arrays.get(name)
    if value is None or value.shape != shape or value.dtype.kind != "f":
        form = "x".join(map(str, shape))
        raise InputError(f"is no whole file of networks: '{name}' is not {form} numbers", REMEDY)
    if not np.isfinite(value).all():
        raise InputError(f"is no whole file of networks: '{name}' is not finite", REMEDY)
    return np.asarray(value, np.float32)
