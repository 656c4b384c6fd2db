"""What a touch proposes, weighed by the energy and its own fault, the likeliest first."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import takewhile
from typing import Any, NamedTuple

import numpy as np

from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.make_room import find_yielding, make_room
from scenewright.domains.hall.solvers.chains import HallChain
from scenewright.domains.hall.solvers.guided_metropolis import bring_back
from scenewright.domains.hall.solvers.start import copy_frames
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State

WEIGHT, LEAST, LOOKED = 6.0, 0.05, 12
"""What a metre of fault costs beside the energy, metres not worth a change, and how many proposals
of a touch are judged at most."""
ALIKE = 0.02
"""By how much the cost of two proposals differs at least that are both looked at."""
BARRED, WORTH, APART = 6, 0.4, 0.9
"""For how many proposals at most that run into others room is made, by how many metres their fault
has to be less than that of the best that gains, and how far they lie from one another."""


class Retouch(NamedTuple):
    """One row of faults: what it has to know of a problem (``look``), the ``fault`` of boxes (n, 5)
    in metres, the layouts it proposes, what of the energy of a measured state it does not count
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

    def fault(self, kept: Kept, boxes: Floats) -> float:
        """The fault of a layout and its boxes (n, 5), in metres."""
        return self.touch.fault(self.seen, kept, boxes)

    def forgiven(self, kept: Kept, boxes: Floats, p: PreparedHall, s: State) -> float:
        """The part of the energy of a measured state that does not count."""
        forgive = self.touch.forgive
        return 0.0 if forgive is None else forgive(self.seen, kept, boxes, p, s)


class Proposal(NamedTuple):
    """A layout, what it costs with its fault (infinite: it breaks a hard rule), and the fault."""

    kept: Kept
    cost: float
    fault: float


def list_likely(chain: HallChain, one: SeenTouch, kept: Kept, firm: list[int]) -> list[Kept]:
    """What a touch proposes that costs less by its own fault, the cheapest first."""
    now = weigh_layout(chain, one, kept)
    found = weigh_proposals(chain, one, now, firm, now.cost - LEAST)
    return [p.kept for p in _differing(sorted(found, key=lambda p: p.cost))[:LOOKED]]


def weigh_proposals(
    chain: HallChain,
    one: SeenTouch,
    now: Proposal,
    firm: list[int],
    most: float = np.inf,
    stopped: Callable[[], bool] = lambda: False,
) -> list[Proposal]:
    """What a touch proposes for a layout, and the same with room made for what runs into others but
    the ``firm`` ones: those that cost less than ``most``; no more once ``stopped``."""
    bring_back(chain.p, chain.s, chain.work, now.kept)
    proposed = list(one.touch.propose(one.seen, now.kept, stand(chain)))
    found, barred = list[Proposal](), list[tuple[Kept, Floats]]()
    for kept in takewhile(lambda _: not stopped(), proposed):
        energy = bring_back(chain.p, chain.s, chain.work, kept)
        other = _weigh(chain, one, kept, energy, most)
        if other.cost < most:
            found.append(other)
        else:
            barred.append((kept, stand(chain)))
    least = min((p.fault for p in found if p.cost < now.cost), default=now.fault) - WORTH
    if one.touch.make_room and least > 0.0:
        faults = [Proposal(kept, np.inf, one.fault(kept, boxes)) for kept, boxes in barred]
        for other, yielding in _barred(chain, faults, now.kept, least, firm, stopped):
            made = make_room(chain, now.kept, other.kept, yielding)
            found += [weigh_layout(chain, one, kept) for kept in made]
    return [other for other in found if other.cost < most]


def _differing(proposals: list[Proposal]) -> list[Proposal]:
    """Proposals by rising cost less those that cost the same as the one before: most are alike."""
    costs = np.array([-np.inf, *(one.cost for one in proposals)])
    return [one for one, more in zip(proposals, np.diff(costs), strict=True) if more > ALIKE]


def weigh_layout(chain: HallChain, one: SeenTouch, kept: Kept) -> Proposal:
    """The cost of a layout with the fault that a touch mends."""
    return _weigh(chain, one, kept, bring_back(chain.p, chain.s, chain.work, kept), np.inf)


def _weigh(chain: HallChain, one: SeenTouch, kept: Kept, energy: float, most: float) -> Proposal:
    """What the layout of an ``energy`` that stands in a chain costs, without its fault if that is
    more than the ``most`` already."""
    boxes = stand(chain)
    if np.isfinite(energy):
        energy -= one.forgiven(kept, boxes, chain.p, chain.s)
    if energy >= most:
        return Proposal(kept, energy, np.inf)
    fault = one.fault(kept, boxes)
    return Proposal(kept, energy + WEIGHT * fault, fault)


def stand(chain: HallChain) -> Floats:
    """The boxes (n, 5) of the layout that stands in a chain."""
    boxes = np.zeros((len(chain.p.sizes), 5))
    copy_frames(chain.s, boxes)
    return boxes


def _barred(
    chain: HallChain,
    found: list[Proposal],
    before: Kept,
    most: float,
    firm: list[int],
    stopped: Callable[[], bool],
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
        if len(chosen) == BARRED or stopped():
            break
    return chosen
