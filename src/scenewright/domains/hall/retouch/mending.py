"""How a touch is made: its proposals are weighed, and the best that harms no other is taken."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np

from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.make_room import find_yielding, make_room
from scenewright.domains.hall.solvers.chains import HallChain, begin_chain, layout_of
from scenewright.domains.hall.solvers.guided_metropolis import bring_back
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.solvers.start import copy_frames
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.engine.draws import streams

WEIGHT, LEAST, LOOKED, WALKED = 6.0, 0.05, 24, 16
"""What a metre of fault costs beside the energy, metres not worth a change, how many proposals are
held against the other touches at most, and how many are walked through."""
ALIKE = 0.02
"""By how much the cost of two proposals differs at least that are both looked at."""
BARRED, WORTH, APART = 6, 0.4, 0.9
"""For how many proposals at most that run into others room is made, by how many metres their fault
has to be less than that of the best that gains, and how far they lie from one another."""


class Retouch(NamedTuple):
    """One touch: what it has to know of a problem (``look``), its ``fault`` of boxes (n, 5) in
    metres, the layouts it proposes, what of the energy of a measured state it does not count
    (``forgive``), the units it has put in their ``place``, which make no room for others, and
    whether others ``make_room`` for what it moves."""

    look: Callable[[HallProblem], Any]
    fault: Callable[[Any, Kept, Floats], float]
    propose: Callable[[Any, Kept, Floats], Iterable[Kept]]
    forgive: Callable[[Any, Kept, Floats, PreparedHall, State], float] | None = None
    place: Callable[[Any, Kept], list[int]] | None = None
    make_room: bool = True


class SeenTouch(NamedTuple):
    """A touch, and what it knows of a problem."""

    touch: Retouch
    seen: Any

    def fault(self, layout: MeasuredLayout) -> float:
        """The fault of a layout, in metres."""
        return self.touch.fault(self.seen, layout.kept, layout.boxes)


class Proposal(NamedTuple):
    """A layout, what it costs with its fault (infinite: it breaks a hard rule), and the fault."""

    kept: Kept
    cost: float
    fault: float


def mend(
    problem: HallProblem, layout: MeasuredLayout, touches: list[SeenTouch], number: int
) -> MeasuredLayout:
    """The layout with one of the touches, or as it is. Those before it keep what they placed."""
    chain = begin_chain(problem, layout.kept, streams(0, 1)[0])
    mine, upto = touches[number : number + 1], touches[: number + 1]
    now = weigh_layout(chain, mine, layout.kept)
    found = weigh_proposals(chain, touches[number], layout, _placed(touches[:number], layout.kept))
    better = sorted((p for p in found if p.cost < now.cost - LEAST), key=lambda p: p.cost)
    whole = weigh_layout(chain, upto, layout.kept).cost if better else 0.0
    looked = _differing(better)[:LOOKED]
    gaining = (p for p in looked if weigh_layout(chain, upto, p.kept).cost < whole - LEAST)
    for _, proposal in zip(range(WALKED), gaining, strict=False):
        tried = layout_of(chain._replace(best=proposal.kept))
        if tried.missed <= layout.missed and tried.lacking <= layout.lacking + 1e-9:
            return tried
    return layout


def weigh_proposals(
    chain: HallChain, one: SeenTouch, layout: MeasuredLayout, firm: list[int]
) -> list[Proposal]:
    """What a touch proposes for a layout, and the same with room made for what runs into others but
    the ``firm`` ones."""
    now = weigh_layout(chain, [one], layout.kept)
    proposed = one.touch.propose(one.seen, layout.kept, layout.boxes)
    found = [weigh_layout(chain, [one], kept) for kept in proposed]
    least = min((p.fault for p in found if p.cost < now.cost), default=now.fault)
    if one.touch.make_room:
        for barred, yielding in _barred(chain, found, layout.kept, least - WORTH, firm):
            made = make_room(chain, layout.kept, barred.kept, yielding)
            found += [weigh_layout(chain, [one], kept) for kept in made]
    return found


def _differing(proposals: list[Proposal]) -> list[Proposal]:
    """Proposals by rising cost less those that cost the same as the one before: most are alike."""
    costs = np.array([-np.inf, *(one.cost for one in proposals)])
    return [one for one, more in zip(proposals, np.diff(costs), strict=True) if more > ALIKE]


def weigh_layout(chain: HallChain, touches: list[SeenTouch], kept: Kept) -> Proposal:
    """What a layout costs with the faults that some touches mend; only the last of them may charge
    more than the energy."""
    energy, total = bring_back(chain.p, chain.s, chain.work, kept), 0.0
    boxes = np.zeros((len(chain.p.sizes), 5))
    copy_frames(chain.s, boxes)
    for touch, seen in touches:
        total += touch.fault(seen, kept, boxes)
        if touch.forgive is not None and np.isfinite(energy):
            forgiven = touch.forgive(seen, kept, boxes, chain.p, chain.s)
            energy -= forgiven if touch is touches[-1].touch else max(forgiven, 0.0)
    return Proposal(kept, energy + WEIGHT * total, total)


def _placed(touches: list[SeenTouch], kept: Kept) -> list[int]:
    """The units that some touches have put in their place."""
    rows = (touch.place(seen, kept) for touch, seen in touches if touch.place is not None)
    return [unit for row in rows for unit in row]


def _barred(
    chain: HallChain, found: list[Proposal], before: Kept, most: float, firm: list[int]
) -> list[tuple[Proposal, list[int]]]:
    """Proposals of less than the ``most`` fault worth making room for, the best first and none
    near another, each with the units in its way, none of them ``firm``."""
    chosen: list[tuple[Proposal, list[int]]] = []
    for one in sorted((one for one in found if one.fault < most), key=lambda one: one.fault):
        moved = (one.kept.pose != before.pose).any(1)
        off = (np.abs(one.kept.pose - other.kept.pose)[moved, :3].max() for other, _ in chosen)
        if moved.any() and all(far > APART for far in off):
            bring_back(chain.p, chain.s, chain.work, one.kept)
            if yielding := find_yielding(chain, before, one.kept, firm):
                chosen.append((one, yielding))
        if len(chosen) == BARRED:
            break
    return chosen
