"""How a hall is retouched: one verdict of its energy and of all rows of faults, one loop.

The verdict on a layout: what its route misses is lost, metres that passages lack are findings, and
its energy, less what rows forgive, costs as well as :data:`WEIGHT` for each metre of a row's fault.
A layout of infinite energy breaks a hard rule.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import NamedTuple

import numpy as np

from scenewright.arranging.repair import Repair, Repaired, Step, repair
from scenewright.arranging.verdict import Verdict
from scenewright.core.layout import Boxes
from scenewright.core.passes import PassChange, PassRun
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch.mending import LEAST, WEIGHT, SeenTouch, list_likely, stand
from scenewright.domains.hall.solvers.chains import HallChain, begin_chain
from scenewright.domains.hall.solvers.guided_metropolis import bring_back, count_missed
from scenewright.domains.hall.solvers.outcome import ENERGY, PASSAGE, lacking
from scenewright.domains.hall.terms.state import Kept
from scenewright.engine.draws import streams

Touches = Mapping[str, SeenTouch]
Show = Callable[[str, Callable[[], Boxes]], None]
BUDGET, ROUNDS, GAIN = 400, 6, 0.5
"""Layouts judged at most, how often a row is looked at, and what a change has to gain."""
LAST = ("bare", "spread")
"""The rows that fill the floor that others leave."""


class Mended(NamedTuple):
    """What the loop found, the costs of the rows at its beginning, and the processor's seconds of
    its thread that each took."""

    found: Repaired[Kept]
    begun: Mapping[str, float]
    seconds: Mapping[str, float]


def mend_layout(
    problem: HallProblem,
    kept: Kept,
    touches: Touches,
    stopped: Callable[[], bool] = lambda: False,
    show: Show | None = None,
) -> Mended:
    """The layout with the touches made that gain, the worst row first; those that fill the floor
    only then. A row is not looked at again until its fault is another; none is once ``stopped``.
    ``show`` gets the row of each step, and what makes the boxes that stand then."""
    chain = begin_chain(problem, kept, streams(0, 1)[0])
    tried, seconds = {name: list[float]() for name in touches}, dict.fromkeys(touches, 0.0)
    propose = partial(_propose, chain, touches, tried, seconds)
    moves = {name: lambda kept, row: [] if stopped() else propose(kept, row) for name in touches}
    rows = {name: (name,) for name in touches} | {ENERGY: (), PASSAGE: ()}
    begun, steps = judge_layout(chain, touches, kept).cost, list[Step]()
    told = None if show is None else partial(_tell, show, chain)
    for some in ({name: touches[name] for name in touches if name not in LAST}, touches):
        by = Repair(partial(judge_layout, chain, some), moves, rows, _identify, GAIN)
        found = repair(by, kept, BUDGET, stopped, told)
        kept, steps = found.state, [*steps, *found.steps]
    return Mended(found._replace(steps=tuple(steps)), begun, seconds)


def _tell(show: Show, chain: HallChain, step: Step) -> None:
    show(step.row, partial(stand, chain))


def list_runs(mended: Mended, space: str) -> Iterator[PassRun]:
    """A run of each row: what its steps gained, and metres of its fault less in the end."""
    found, begun, seconds = mended
    for row, spent in seconds.items():
        gained = [step.gained[3] for step in found.steps if step.row == row]
        less = (begun[row] - found.verdict.cost[row]) / WEIGHT
        changes = (PassChange(space, sum(gained), less, 0),) if gained else ()
        yield PassRun(row, spent, changes)


def judge_layout(chain: HallChain, touches: Touches, kept: Kept) -> Verdict:
    """The verdict on a layout; see the module."""
    energy = bring_back(chain.p, chain.s, chain.work, kept)
    if not np.isfinite(energy):
        return Verdict(broken=1)
    boxes, p, s, bits = stand(chain), chain.p, chain.s, chain.bits
    forgiven = sum(one.forgiven(kept, boxes, p, s) for one in touches.values())
    faults = {name: WEIGHT * one.fault(kept, boxes) for name, one in touches.items()}
    found = {PASSAGE: lacking(p, s)}
    missed = count_missed(p, s, chain.grid, bits[0], bits[1], bits[2], chain.inset)
    return Verdict(missed, 0, found, {ENERGY: energy - forgiven} | faults)


def _propose(
    chain: HallChain,
    touches: Touches,
    tried: dict[str, list[float]],
    seconds: dict[str, float],
    kept: Kept,
    row: str,
) -> list[Kept]:
    """The layouts that the touch of a row proposes, unless it was ``tried`` at the same fault."""
    begun = time.thread_time()
    bring_back(chain.p, chain.s, chain.work, kept)
    fault = touches[row].fault(kept, stand(chain))
    known = any(abs(fault - other) < LEAST for other in (0.0, *tried[row]))
    if known or len(tried[row]) == ROUNDS:
        return []
    tried[row].append(fault)
    found = list_likely(chain, touches[row], kept, _find_placed(touches, kept, row))
    seconds[row] += time.thread_time() - begun
    return found


def _find_placed(touches: Touches, kept: Kept, row: str) -> list[int]:
    """The units that touches of other rows have put in their place."""
    others = (one for name, one in touches.items() if name != row)
    placed = (one.touch.place(one.seen, kept) for one in others if one.touch.place is not None)
    return [unit for units in placed for unit in units]


def _identify(kept: Kept) -> bytes:
    return b"".join(part.tobytes() for part in kept)
