"""Learning a style from real blocks: clean, split by place, train, report, write."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from scenewright.catalog.assets.buildings.house_looks import LOOKS, RURAL
from scenewright.core.atomic_file import atomic_write, check_targets
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.domains.village.blocks import VillagePlan
from scenewright.domains.village.learned.fullness import odds_of_figures
from scenewright.domains.village.learned.style import (
    SUFFIX,
    VillageStyle,
    bare_style,
    is_file,
    write_style,
)
from scenewright.domains.village.learning.interrupted_run import (
    checkpoint_path,
    resume_training,
    save_training,
)
from scenewright.domains.village.learning.more_training import learn_more, states_of
from scenewright.domains.village.learning.pose_training import (
    EPOCHS,
    TrainingState,
    mean_loss,
    rounds_of,
    start_training,
    train_poses,
)
from scenewright.domains.village.learning.real_blocks import blocks_of_plan, read_blocks
from scenewright.domains.village.learning.tables import (
    RealBlock,
    learn_manner,
    learn_mix,
    learn_regions,
)

FEWEST = 12
"""Blocks to learn from, at least."""
HELD = 0.2
"""The share of the blocks that is held out, whole places, where none are named."""

Tell = Callable[[float, str], None]
Cancel = Callable[[], bool]


class LearnOptions(NamedTuple):
    """How a style is learned: the ``seed``; places ``held`` out (none: about a fifth of the
    blocks); ``kinds`` of places (none: all); ``epochs`` of the net; a ``budget`` of processor
    seconds that stops earlier; ``look`` of houses built in the style; ``licence`` of the data, for
    the card."""

    seed: int = 0
    held: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()
    epochs: int = EPOCHS
    budget: float | None = None
    look: str = "rural"
    licence: str = ""


class LearnedStyle(NamedTuple):
    """What came of it: the style's card, the processor seconds its training took, and whether it
    was written (False: stopped before; the same command goes on)."""

    card: dict[str, Any]
    seconds: float
    written: bool


def learn_style(
    sources: Sequence[Path],
    output: Path,
    given: Mapping[str, Any],
    read_plan: Callable[[Path], Plan],
    tell: Tell,
    cancel: Cancel,
) -> LearnedStyle:
    """Learn a style from files of blocks and write it to ``output``; ``given`` are
    :class:`LearnOptions`.

    A run that was stopped goes on where it was if its data and options are the same; a budget
    that has run out ends the training, and the style is written as it is by then.
    """
    options = LearnOptions(**given)
    check_learning(output, options.look)
    blocks = read_sources(sources, options.kinds, read_plan)
    train, test = split_by_place(blocks, options.held, options.seed)
    tell(0.0, f"{len(train)} blocks to learn from, {len(test)} held out")
    bare = bare_style(learn_manner(train))
    state, seconds, whole = _train(train, bare, output, options, tell, cancel)
    if not whole:
        return LearnedStyle({"rounds": state.rounds}, seconds, False)
    tell(0.99, "looking at what was held out")
    style = tell_blocks(bare._replace(poses=state.weights), train, options.seed)
    style = style._replace(card=_card(style, train, test, state, options))
    with atomic_write(output) as partial:
        write_style(partial, style)
    checkpoint_path(output).unlink(missing_ok=True)
    return LearnedStyle(style.card, seconds, True)


def tell_blocks(style: VillageStyle, train: Sequence[RealBlock], seed: int) -> VillageStyle:
    """The style with what is learned of whole blocks: which houses stand together, what differs
    between regions, and when a block is full. (The net is of all regions: among proposals of one
    it prefers what it would among all.)"""
    regions = learn_regions(train, style.manner)
    style = style._replace(mix=learn_mix(train), regions=regions)
    return style._replace(more=learn_more(train, style, seed))


def check_learning(output: Path, look: str = RURAL) -> None:
    """InputError unless what is learned can be written, and PyTorch is there."""
    if not is_file(str(output)):
        raise InputError(
            f"styles are not written as '{output.suffix}'", f"use {SUFFIX}", file=str(output)
        )
    check_targets([output])
    if look not in LOOKS:
        raise InputError(f"unknown look '{look[:40]}'", f"use one of: {', '.join(LOOKS)}")
    try:
        import torch  # noqa: F401
    except ImportError:
        raise InputError(
            "learning needs the package torch, which is not installed",
            "install it with: pip install 'scenewright[learn]'",
        ) from None


def read_sources(
    sources: Sequence[Path], kinds: Sequence[str], read_plan: Callable[[Path], Plan]
) -> list[RealBlock]:
    """The blocks of files, and of all in folders that may hold some."""
    files = [
        file
        for path in sources
        for file in (sorted(path.iterdir()) if path.is_dir() else [path])
        if not path.is_dir() or file.suffix in (".json", ".geojson", ".gpkg")
    ]
    return [block for path in files for block in _blocks(path, kinds, read_plan)]


def _blocks(
    path: Path, kinds: Sequence[str], read_plan: Callable[[Path], Plan]
) -> tuple[RealBlock, ...]:
    """Blocks of a list as JSON, else the standing houses of a village in any file we read."""
    if path.suffix == ".json" and path.is_file():
        with path.open("rb") as file:
            listed = file.read(200).lstrip().startswith(b"[")
        if listed:
            return read_blocks(path, kinds)
    plan = read_plan(path)
    if not isinstance(plan.detail, VillagePlan):
        remedy = "tag the outlines of blocks block=yes in a map, or give a list of blocks (.json)"
        raise InputError("is no village with blocks", remedy, file=str(path))
    return blocks_of_plan(plan, path.stem)


def split_by_place(
    blocks: Sequence[RealBlock], held: Sequence[str], seed: int
) -> tuple[list[RealBlock], list[RealBlock]]:
    """Blocks to learn from and blocks held out, never of one place; InputError for too few."""
    places = sorted({block.place for block in blocks})
    unknown = [name for name in held if name not in places]
    if unknown:
        raise InputError(
            f"no block is of the place '{unknown[0]}'", f"the places are: {', '.join(places)[:300]}"
        )
    out = set(held)
    if not held and len(places) > 1:
        for number in np.random.default_rng([seed, 4]).permutation(len(places)).tolist():
            more = out | {places[number]}
            if sum(block.place in more for block in blocks) <= HELD * len(blocks):
                out = more
    train = [block for block in blocks if block.place not in out]
    if len(train) < FEWEST:
        raise InputError(
            f"only {len(train)} blocks are left to learn from, {FEWEST} are needed",
            "give more blocks with their houses, or hold out fewer places",
        )
    return train, [block for block in blocks if block.place in out]


def _train(
    train: Sequence[RealBlock],
    bare: VillageStyle,
    output: Path,
    options: LearnOptions,
    tell: Tell,
    cancel: Cancel,
) -> tuple[TrainingState, float, bool]:
    """The trained state, the processor seconds it took, and whether it is whole or the budget
    ended it (False: it was interrupted)."""
    path, key = checkpoint_path(output), _key(train, options)
    state, before = resume_training(path, key, start_training(options.seed))
    total, begun = rounds_of(train, options.epochs), time.process_time()
    if state.rounds:
        tell(state.rounds / total, f"going on from round {state.rounds} of {total}")

    def took() -> float:
        return before + time.process_time() - begun

    def spent() -> bool:
        return options.budget is not None and took() >= options.budget

    def done(now: TrainingState) -> bool:
        save_training(path, key, now, took())
        tell(now.rounds / total, f"round {now.rounds} of {total}: loss {now.losses[-1]:.3f}")
        return cancel() or spent()

    if not spent():
        state = train_poses(state, train, bare, options.seed, total, done)
    return state, took(), state.rounds == total or spent()


def _key(train: Sequence[RealBlock], options: LearnOptions) -> str:
    """What tells one training from another: its blocks, seed and length."""
    digest = hashlib.sha256(f"{options.seed} {options.epochs}".encode())
    for block in train:
        digest.update(block.name.encode())
        for ring in block.houses:
            digest.update(np.round(ring, 3).tobytes())
    return digest.hexdigest()


def _card(
    style: VillageStyle,
    train: Sequence[RealBlock],
    test: Sequence[RealBlock],
    state: TrainingState,
    options: LearnOptions,
) -> dict[str, Any]:
    """What a style tells of itself."""
    card: dict[str, Any] = {
        "look": options.look,
        "licence": options.licence or "that of its data",
        "seed": options.seed,
        "blocks": len(train),
        "houses": sum(len(block.houses) for block in train),
        "places": sorted({block.place for block in train}),
        "regions": sorted(style.regions),
        "held_out": sorted({block.place for block in test}),
        "rounds": state.rounds,
        "steps": state.steps,
    }
    if len(test) > 1:
        card["figures"] = _figures(style, test, options.seed)
    return card


def _figures(style: VillageStyle, test: Sequence[RealBlock], seed: int) -> dict[str, float]:
    """Figures of what was held out: the mean log odds of the real pose among legal proposals, by
    the net and by chance, and how well full blocks are recognized (area under the curve)."""
    loss, even = mean_loss(style, test, seed)
    rows, label = states_of(test, style, seed, 1)
    odds = odds_of_figures(style.more, rows)
    wins = (odds[label > 0][:, None] > odds[label == 0][None]).mean()
    return {
        "pose_loss": round(loss, 4),
        "pose_loss_by_chance": round(even, 4),
        "continue_auc": round(float(wins), 4),
    }
