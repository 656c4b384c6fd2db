"""The paper's Tables 2 and 3 on Hui-style blocks of our own (:mod:`.hui_blocks`; extra ``learn``).

Blocks of two made-up villages are held out; on the others the small form is trained, and at each
number of epochs it fills the held-out blocks with houses of the others. *Real* is the one half of
the held-out blocks against the other (KL), *shuffled* the same houses moved by chance; *ours* is
the solver ``grow`` with the style that ships, which has learned no Hui village. Then one step of
each network at 256² is timed, and an epoch of the paper's 5,393 samples extrapolated from it.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from benchmarks.hui_blocks import make_hui_blocks
from benchmarks.village_table3 import ToldBlock, shuffle_block, tell_table2, tell_table3
from scenewright.core.extras import require
from scenewright.domains.village.house import House
from scenewright.domains.village.learned.style import shipped_style
from scenewright.domains.village.learning.examples import problem_of_block
from scenewright.domains.village.learning.paper import batches, training
from scenewright.domains.village.learning.paper.learn import learn_nets
from scenewright.domains.village.learning.paper.samples import paper_houses
from scenewright.domains.village.learning.real_blocks import clean_blocks, library_of
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.paper.filling import fill_as_paper
from scenewright.domains.village.paper.nets_file import ASKED, PRINTED, PaperNets, read_paper_nets
from scenewright.domains.village.settings import VillageSettings
from scenewright.domains.village.solvers import VILLAGE_SOLVERS
from scenewright.domains.village.standing import place
from scenewright.engine.solve import Budget

Record = dict[str, Any]
Progress = Callable[[float, str], None]
HELD = ("village 0", "village 1")
SIZES = {"quick": (22, (1, 4, 16)), "usual": (40, (1, 4, 16, 64)), "full": (100, (1, 4, 16, 400))}
"""Blocks, and epochs of each network after which blocks are filled (at most as printed)."""
SAMPLES = 5393
"""Training samples of the paper."""
PRINTED_SECONDS = 69.0


def records(quick: bool, progress: Progress | None = None, full: bool = False) -> Iterator[Record]:
    """Records of every method and measure, then those of single steps at the printed size."""
    require("torch")
    count, points = SIZES["quick" if quick else "full" if full else "usual"]
    rows = make_hui_blocks(count, 0)
    test = clean_blocks(row for row in rows if row["place"] in HELD)
    train = clean_blocks(row for row in rows if row["place"] not in HELD)
    real, houses = [tell_block(block) for block in test], library_of(train)
    half = len(real) // 2
    yield from _records("real", real, real[:half], real[half:], None)
    rng = np.random.default_rng(1)
    yield from _records("shuffled", real, real, [shuffle_block(one, rng) for one in real], None)
    yield from _filled("ours", real, test, _by_ours, houses)
    with TemporaryDirectory() as folder:
        for number, epochs in enumerate(points):
            if progress is not None:
                progress(number / len(points), f"{epochs} epochs")
            nets = _train(rows, Path(folder), epochs)
            name = f"paper's small form, {epochs} epochs"
            yield from _filled(name, real, test, _by_paper(nets), houses)
    yield from time_steps(train)


def tell_block(block: RealBlock) -> ToldBlock:
    """A real block as the measures take it."""
    classes = np.column_stack(paper_houses(block)[3:])
    return ToldBlock(block.floor, block.houses, np.array(block.doors), classes)


def _train(rows: Sequence[Record], folder: Path, epochs: int) -> PaperNets:
    """The networks after so many epochs: the training that is kept goes on. (A run does not write
    over a file that it has read, so each is moved.)"""
    data, output = folder / "blocks.json", folder / "nets.npz"
    data.write_text(json.dumps(rows), encoding="utf-8")
    given = {"held": HELD, "size": "small", "epochs": epochs, "jobs": 0}

    def no_plan(path: Path) -> Any:
        raise ValueError(path)

    learn_nets([data], output, given, no_plan, lambda _share, _text: None, lambda: False)
    return read_paper_nets(output.rename(folder / f"{epochs}.npz"))


def _by_paper(nets: PaperNets) -> Callable[[RealBlock, Sequence[House], int], ToldBlock]:
    def fill(block: RealBlock, houses: Sequence[House], seed: int) -> ToldBlock:
        problem = problem_of_block(block, houses, shipped_style(), VillageSettings())
        found = fill_as_paper(nets, problem, np.random.default_rng(seed))
        chosen = [houses[k] for k in found.houses]
        doors = [
            place(np.array([house.door]), pose[None])[0, 0]
            for house, pose in zip(chosen, found.poses, strict=True)
        ]
        return _told(block, chosen, found.poses, doors)

    return fill


def _by_ours(block: RealBlock, houses: Sequence[House], seed: int) -> ToldBlock:
    problem = problem_of_block(block, houses, shipped_style(), VillageSettings())
    layout = VILLAGE_SOLVERS["grow"].run(problem, Budget(steps=1), seed).layouts[0]
    chosen = [houses[k] for k in layout.houses]
    doors = []
    for house, pose, side in zip(chosen, layout.poses, layout.doors.tolist(), strict=True):
        ring = place(house.outline, pose[None])[0]
        doors.append((ring[side] + ring[(side + 1) % len(ring)]) / 2)
    return _told(block, chosen, layout.poses, doors)


def _told(
    block: RealBlock, chosen: Sequence[House], poses: Sequence[Any], doors: Sequence[Any]
) -> ToldBlock:
    rings = [place(h.outline, p[None])[0] for h, p in zip(chosen, poses, strict=True)]
    classes = np.array([(h.material, h.shape, h.size) for h in chosen], int).reshape(-1, 3)
    return ToldBlock(block.floor, tuple(rings), np.array(doors).reshape(-1, 2), classes)


def _filled(
    name: str,
    real: Sequence[ToldBlock],
    test: Sequence[RealBlock],
    fill: Callable[[RealBlock, Sequence[House], int], ToldBlock],
    houses: Sequence[House],
) -> Iterator[Record]:
    """The records of a method that fills the held-out blocks."""
    begun = time.process_time()
    made = [fill(block, houses, seed) for seed, block in enumerate(test)]
    took = (time.process_time() - begun) / len(test)
    yield from _records(name, real, real, made, took)


def _records(
    name: str,
    real: Sequence[ToldBlock],
    one: Sequence[ToldBlock],
    made: Sequence[ToldBlock],
    seconds: float | None,
) -> Iterator[Record]:
    told = tell_table3(real)
    for metric, value in tell_table2(one, made).items():
        yield _record(name, metric, "nats", value, None, "", len(made))
    for metric, value in tell_table3(real if name == "real" else made).items():
        yield _record(name, metric, "1", value, told[metric], "real", len(made))
    share = sum(len(block.rings) for block in made) / sum(len(block.rings) for block in one)
    yield _record(name, "houses against real", "1", share, 1.0, "real", len(made))
    if seconds is not None:
        row = _record(name, "CPU s a block", "s", seconds, PRINTED_SECONDS, "printed", len(made))
        yield row


def time_steps(blocks: Sequence[RealBlock]) -> Iterator[Record]:
    """One step of each network at 256² on one core of this machine, in processor seconds, and hours
    of an epoch and of all epochs of the paper's samples extrapolated from them."""
    import torch

    feed = batches.Feed(blocks, PRINTED, batches.PRINTED, 0)
    torch.set_num_threads(1)
    state, hours, whole = training.start_nets(torch, feed, "cpu"), 0.0, 0.0
    for name in ASKED:
        begun = time.process_time()
        batch = next(batches.make_batches(feed, iter([batches.PaperStep(name, 0, 0)])))
        training.loss_of_net(torch, name, state.nets[name], batch).backward()
        state.wheels[name].step()
        took = time.process_time() - begun
        each = took * feed.schedule.steps_each(name, SAMPLES) / 3600
        hours, whole = hours + each, whole + each * feed.schedule.epochs[name]
        yield _record(f"256², {name}", "CPU s a step", "s", took, None, "", 1)
    case = "256², all, extrapolated"
    yield _record(case, "CPU hours an epoch", "h", hours, None, "", 1)
    yield _record(case, "CPU hours of all epochs", "h", whole, None, "", 1)


def _record(
    case: str, metric: str, unit: str, value: float, base: float | None, base_name: str, runs: int
) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(value, 3),
        "baseline": None if base is None else round(base, 3),
        "baseline_name": base_name,
        "ratio": round(value / base, 3) if base else None,
        "runs": runs,
    }


def markdown_lines(found: Sequence[Record]) -> list[str]:
    """A row a method and a column a measure; then the steps at the printed size."""
    filled = [row for row in found if not row["case"].startswith("256²")]
    metrics = list(dict.fromkeys(row["metric"] for row in filled))
    lines = [f"| | {' | '.join(metrics)} |", "|---" * (len(metrics) + 1) + "|"]
    for case in dict.fromkeys(row["case"] for row in filled):
        cells = {row["metric"]: row["ours"] for row in filled if row["case"] == case}
        lines.append(f"| {case} | {' | '.join(str(cells.get(m, '–')) for m in metrics)} |")
    steps = [row for row in found if row["case"].startswith("256²")]
    lines += ["", "| at 256² | | |", "|---|---|---|"] if steps else []
    return lines + [f"| {row['case'][6:]} | {row['metric']} | {row['ours']} |" for row in steps]
