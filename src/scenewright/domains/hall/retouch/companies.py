"""Companies: lounge seats in rows or in a ring, all looking one way or away from each other, stand
round low tables.

Who sits in a lounge reads or talks: seats look at each other there, unless a brief asks for a
pattern.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.patterns import AROUND, CHAIN, GRID, RADIATION
from scenewright.domains.hall.patterns.around import BETWEEN, COMPANY, CORNERS, KNEES
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import count_objects, find_layers
from scenewright.domains.hall.retouch.places import all_over, stand_at
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import LOUNGE

FEWEST, MOST, EACH = 3, 6, 1.5
"""Seats that are set round tables at least, those of one company at most, and what each beyond
two counts, up to ``MOST``, in metres."""


def measure_apart(problem: HallProblem, kept: Kept, boxes: Floats) -> float:  # noqa: ARG001
    """What lounge seats in rows and rings among ``boxes`` (n, 5) count, in metres."""
    seats = count_objects(problem)[_find_apart(problem, kept)]
    return EACH * float((np.minimum(seats, MOST) - 2).sum())


def _find_apart(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of lounge seats with a front in rows or rings, which look at nothing and are
    allowed several patterns: a brief that states one has it."""
    units, roles = problem.units, problem.visitors.roles.astype(int)
    return [
        unit
        for unit, number in enumerate(count_objects(problem))
        if number >= FEWEST
        and roles[unit] & LOUNGE
        and int(kept.rows[unit, 0]) in (CHAIN, GRID, RADIATION)
        and units.choices[unit].sum() > 1
        and units.targets[unit] < 0
        and not units.access[units.spans[unit, 0]].all()
    ]


def propose_companies(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the seats of one unit among ``boxes`` (n, 5) in companies round tables, all over
    its zone, along or across it."""
    for unit in _find_apart(problem, kept):
        middle = boxes[slice(*problem.units.spans[unit]), :2].mean(0)
        heading = float(kept.pose[unit, 2])
        here = (np.array([*middle, heading + 0.5 * np.pi * turn]) for turn in range(4))
        places = [np.append(one, 0.0) for one in (*here, *all_over(problem, unit, heading))]
        for form in _forms(problem, kept, unit):
            yield from stand_at(form, unit, places)


def _forms(problem: HallProblem, kept: Kept, unit: int) -> Iterator[Kept]:
    """Layouts with a unit in one company, where it is small, or in several as large as one another
    (:mod:`..patterns.around`)."""
    first, number = find_layers(problem, unit)[0], int(count_objects(problem)[unit])
    row = int(problem.units.spans[unit, 0])
    wide, deep = problem.units.sizes[slice(*problem.units.spans[unit])].max(0)
    clear = float(problem.units.clear[row, 0])
    far = max(KNEES, 0.5 * float(wide) + max(CORNERS, clear)) + 0.5 * float(deep)
    for sizes in sorted(_share(number)):
        layers, rows = kept.layers.copy(), kept.rows.copy()
        for k, each in enumerate(sizes):
            layers[first + k] = (float(each), max(2.0 * clear, BETWEEN), far, AROUND, 0.0)
        rows[unit] = AROUND, len(sizes)
        yield kept._replace(layers=layers, rows=rows)


def _share(number: int) -> set[tuple[int, ...]]:
    """So many seats in one company, where they are few, and in several, the larger ones first or
    last.

    >>> sorted(_share(5))
    [(2, 3), (3, 2), (5,)]
    """
    several = -(-number // COMPANY)
    even = tuple(number // several + (1 if k < number % several else 0) for k in range(several))
    return {even, even[::-1], *({(number,)} if number <= MOST else set())}
