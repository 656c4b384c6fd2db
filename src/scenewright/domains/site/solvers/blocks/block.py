"""Layouts of one block: buildings of a queue in some form, gaps as wide as all still fit.

Rows stand in strips of the ground that no edge crosses, so they are inside by construction.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.solvers.blocks.closed_court import close_court
from scenewright.domains.site.solvers.blocks.distances import list_reserved_edges, mark_shaded, noon
from scenewright.domains.site.solvers.blocks.front import (
    list_front_margins,
    list_side_margins,
    turned_in,
)
from scenewright.domains.site.solvers.blocks.perimeter_block import (
    list_front_lines,
    rim,
    spread_out,
)
from scenewright.domains.site.solvers.blocks.rows import StripRule, rows
from scenewright.domains.site.solvers.blocks.strips import back, rotate_block

FORMS = (
    "parallel",
    "staggered",
    "peripheral",
    "mixed",
    "half-closed",
    "spliced",
    "rotated",
    "point",
)
USUAL = FORMS[:4]
"""Forms tried where none is asked for."""
COURTS = {"peripheral": 1.0, "half-closed": 1.0, "mixed": 0.65}
"""Forms with buildings along the rim, and what share of the buildings."""
ALIKE = math.radians(15.0)
"""Radians within which headings are about the same."""
TURNED = math.pi / 6
"""How far each building of the form ``rotated`` is turned in its row, in radians."""


class BlockLayout(NamedTuple):
    """Buildings of a block: their numbers and boxes (k, 5), the form, how many stand round a
    court, and whether that is open though it is to be closed."""

    numbers: tuple[int, ...]
    boxes: Floats
    form: str
    around: int = 0
    open: bool = False


def list_forms(problem: SiteProblem, share: list[int], block: int = -1) -> list[str]:
    """The form asked for a block, else those all buildings of it may take, else the usual ones."""
    if 0 <= block < len(problem.block_forms) and problem.block_forms[block]:
        return [problem.block_forms[block]]
    asked = [problem.buildings.forms[i] for i in share] if problem.buildings.forms else []
    named = [one for one in asked if one]
    allowed = [form for form in FORMS if named and all(form in one for one in named)]
    return allowed or list(USUAL)


def headings(problem: SiteProblem, edges: Floats) -> list[float]:
    """The preferred heading, and those along the two longest edges nearest to it.

    ``edges`` (e, 4) x0, y0, x1, y1 in metres; radians.
    """
    way = edges[:, 2:] - edges[:, :2]
    longest = np.argsort(-np.hypot(way[:, 0], way[:, 1]), kind="stable")[:2]
    found = [problem.facing]
    for k in longest.tolist():
        along = math.atan2(way[k, 1], way[k, 0])
        turns = [along + q * math.pi / 2 for q in range(4)]
        found.append(min(turns, key=lambda a: abs(wrap_angle(a - problem.facing))))
    return found


def choose_heading(ways: list[float], axis: int) -> float:
    """The heading of :func:`headings` along an ``axis`` of a block; square to the others where
    all are about the same, as in blocks with right angles.

    >>> choose_heading([0.0, 0.1, 0.1], 2) - choose_heading([0.0, 0.1, 0.1], 1) == math.pi / 2
    True
    """
    square = axis == len(ways) - 1 and abs(wrap_angle(ways[axis] - ways[axis - 1])) < ALIKE
    return ways[axis] + (math.pi / 2 if square else 0.0)


class BlockBorder(NamedTuple):
    """How the border of a block is followed: along which ``lines`` (m, 4), by what ``part`` of the
    buildings that its form has there, how many metres gaps may widen where there is room, and how
    many metres ``aside`` rows keep their ends from it."""

    lines: Floats
    part: float = 1.0
    widest: float = 12.0
    aside: float = 0.0


class BlockFront(NamedTuple):
    """Buildings along the edges of a block: their numbers and boxes (k, 5), the ``ring`` (4, 2) of
    the court they close (``None``: none), and whether that is open though it is to be closed."""

    numbers: list[int]
    boxes: Floats
    ring: Floats | None = None
    open: bool = False


def loosen_layout(
    problem: SiteProblem,
    edges: Floats,
    queue: list[int],
    heading: float,
    form: str,
    loosest: float,
    border: BlockBorder | None = None,
) -> BlockLayout:
    """A layout of a block with gaps as wide as still hold all that the least gaps hold.

    ``edges`` (e, 4) of the block in metres, ``heading`` in radians; ``border`` is how
    its border is followed (all of its edges unless given).
    """
    margins = list_front_margins(problem, edges, heading)
    if border is not None and border.aside > 0.0:
        sides = list_side_margins(border.lines, heading, border.aside)
        margins = np.concatenate([margins, sides])
    front = lay_front(problem, edges, queue, heading, form, loosest > 1.0, border)
    tight = lay_out_block(problem, edges, queue, heading, form, 1.0, margins, front)
    if front.ring is not None or front.open:
        return tight
    steps = problem.settings.fill.steps if loosest > 1.0 else 0
    gaps, best, closer = [*spread_out(loosest, 1.0, steps + 1)[:steps]], tight, 1.0
    while gaps:
        loose = gaps.pop(0)
        found = lay_out_block(problem, edges, queue, heading, form, loose, margins, front)
        if len(found.numbers) >= len(tight.numbers):
            best, gaps = found, [loose * closer**0.5] if closer > 1.0 else []
            closer = 1.0
        else:
            closer = loose / gaps[0] if gaps else 1.0
    return best


def lay_front(
    problem: SiteProblem,
    edges: Floats,
    queue: list[int],
    heading: float,
    form: str,
    widen: bool = False,
    border: BlockBorder | None = None,
) -> BlockFront:
    """The buildings along the edges of a block, none unless its ``form`` is one with a rim; spread
    over all of it where gaps may ``widen``."""
    wanted = form == "peripheral" and problem.court_gap > 0.0
    closed = close_court(problem, edges, queue, problem.spacing) if wanted else None
    if closed is not None:
        return BlockFront(closed.numbers, turned_in(problem, closed.boxes), closed.ring)
    if form not in COURTS:
        return BlockFront([], np.zeros((0, 5)))
    border = BlockBorder(list_front_lines(edges)) if border is None else border
    gap, widest = max(problem.spacing, problem.fire_access), border.widest if widen else 0.0
    open_to = heading if form == "half-closed" else None
    sizes = problem.buildings.sizes
    share = border.part * COURTS[form]
    numbers, boxes = rim(edges, sizes, queue, gap, share, open_to, border.lines, widest)
    return BlockFront(numbers, turned_in(problem, boxes), None, wanted)


def lay_out_block(
    problem: SiteProblem,
    edges: Floats,
    queue: list[int],
    heading: float,
    form: str,
    loose: float,
    margins: Floats | None = None,
    front: BlockFront | None = None,
) -> BlockLayout:
    """One layout of a block.

    ``edges`` (e, 4) of the block in metres, ``heading`` in radians; ``margins`` (m, 4) are those of
    :func:`list_front_margins`, ``front`` that of :func:`lay_front` (both found unless given).
    """
    margins = list_front_margins(problem, edges, heading) if margins is None else margins
    front = lay_front(problem, edges, queue, heading, form) if front is None else front
    sizes, spacing = problem.buildings.sizes, problem.spacing
    if form == "point" and loose > 1.0 and queue:
        tall = float(np.median(sizes[queue, 2]))
        spacing = max(spacing, problem.settings.fill.apart * tall)
    rule = StripRule(
        spacing, problem.fire_access, problem.sun_spacing, loose, form == "staggered", True
    )
    numbers, boxes = front.numbers, front.boxes
    left = [i for i in queue if i not in set(numbers)]
    edges = _reserve(problem, edges, numbers, boxes, left)
    if front.ring is not None:
        ring = front.ring[::-1]
        edges = np.concatenate([edges, np.hstack([ring, np.roll(ring, -1, axis=0)])])
    parts = [(edges, left, heading)]
    if form == "spliced":
        parts = _splice(problem, edges, left, heading)
    for ground, waiting, ahead in parts:
        kept = margins if ahead == heading else list_front_margins(problem, edges, ahead)
        placed, found = _set_rows(
            problem, np.concatenate([ground, kept]), waiting, ahead, rule, form
        )
        numbers, boxes = numbers + placed, np.concatenate([boxes, found])
    around = len(front.numbers)
    return _in_sun(problem, BlockLayout(tuple(numbers), boxes, form, around, front.open))


def _reserve(
    problem: SiteProblem, edges: Floats, numbers: list[int], boxes: Floats, waiting: list[int]
) -> Floats:
    """Edges of a block less what the buildings that stand keep from those that wait."""
    if not len(boxes):
        return edges
    sizes = problem.buildings.sizes
    ahead = float(sizes[waiting, 2].max()) if waiting else 0.0
    taken = list_reserved_edges(problem, boxes, sizes[numbers, 2], ahead)
    return np.concatenate([edges, taken])


def _set_rows(
    problem: SiteProblem,
    edges: Floats,
    waiting: list[int],
    heading: float,
    rule: StripRule,
    form: str,
) -> tuple[list[int], Floats]:
    """Rows in a block: the numbers of the buildings placed, and their boxes (k, 5)."""
    sizes, turn = problem.buildings.sizes, TURNED if form == "rotated" else 0.0
    block = rotate_block(edges, heading)
    placed = rows(block, _widen(sizes, turn), waiting, rule)
    found, numbers = np.zeros((len(placed), 5)), [i for i, _, _ in placed]
    if placed:
        at = np.array([(x, y) for _, x, y in placed])
        found[:, 0], found[:, 1] = back(at[:, 0], at[:, 1], heading)
        found[:, 2] = heading + turn
        found[:, 3:] = sizes[numbers, :2]
    return numbers, found


def _widen(sizes: Floats, turn: float) -> Floats:
    """Sizes (n, 3) of the boxes along a row about buildings that are turned in it."""
    if turn == 0.0:
        return sizes
    c, s = abs(math.cos(turn)), abs(math.sin(turn))
    wide, deep = sizes[:, 0] * c + sizes[:, 1] * s, sizes[:, 0] * s + sizes[:, 1] * c
    return np.column_stack([wide, deep, sizes[:, 2]])


def _splice(
    problem: SiteProblem, edges: Floats, queue: list[int], heading: float
) -> list[tuple[Floats, list[int], float]]:
    """Two parts side by side with their share of the buildings, the second with its rows turned
    by a quarter."""
    sizes = problem.buildings.sizes
    floor = np.cumsum([(sizes[i, :2] + problem.spacing).prod() for i in queue])
    cut = int(np.searchsorted(floor, 0.5 * floor[-1])) + 1 if len(queue) else 0
    share = float(floor[cut - 1] / floor[-1]) if cut else 0.5
    block = rotate_block(edges, heading).edges
    low, high = block.reshape(-1, 2).min(0), block.reshape(-1, 2).max(0)
    middle, gap = (
        low[0] + share * (high[0] - low[0]),
        0.5 * max(problem.spacing, problem.fire_access),
    )
    found = []
    for x0, x1 in ((middle - gap, high[0] + 1.0), (low[0] - 1.0, middle + gap)):
        y0, y1 = low[1] - 1.0, high[1] + 1.0
        px, py = np.array([x0, x0, x1, x1]), np.array([y0, y1, y1, y0])
        ring = np.stack(back(px, py, heading), -1)
        taken = np.hstack([ring, np.roll(ring, -1, axis=0)])
        found.append(np.concatenate([edges, taken]))
    return [(found[0], queue[:cut], heading), (found[1], queue[cut:], heading - math.pi / 2)]


def _in_sun(problem: SiteProblem, found: BlockLayout) -> BlockLayout:
    """A layout without the buildings that stand too near behind another one of it."""
    if problem.sun_spacing <= 0.0 or len(found.numbers) < 2:
        return found
    heights, dark = (
        problem.buildings.sizes[list(found.numbers), 2],
        np.empty(len(found.boxes), bool),
    )
    work = np.empty((len(dark), 5))
    mark_shaded(found.boxes, heights, noon(problem), problem.sun_spacing, work, dark)
    if not dark.any():
        return found
    kept = np.flatnonzero(~dark)
    numbers = tuple(found.numbers[k] for k in kept)
    return found._replace(numbers=numbers, boxes=found.boxes[kept])


def wrap_angle(angle: float) -> float:
    """An angle in [-π, π)."""
    return (angle + math.pi) % (2 * math.pi) - math.pi
