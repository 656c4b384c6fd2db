"""Blocks filled as somebody chose, instead of the best of many layouts: what layouts are bred of.

Where what was chosen leaves buildings over, less of it is done; so nearly every choice is a layout
of all buildings, and like choices are like layouts. Like choices also share blocks, and what they
fall back to: who fills one site often remembers both (:func:`remember_fillings`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.domains.site.solvers.blocks.block import (
    FORMS,
    BlockLayout,
    headings,
    list_forms,
    loosen_layout,
)
from scenewright.domains.site.solvers.blocks.schemes import QUEUES, order_queue
from scenewright.domains.site.solvers.blocks.shares import (
    list_edges,
    list_ground,
    order_blocks,
    share_out,
)
from scenewright.domains.site.solvers.outcome import SiteFound, SiteLayout
from scenewright.engine.solve import Found

TURNS = (0.0, math.pi / 2, -math.pi / 2)
"""How far fronts may be turned off the preferred heading, in radians: square to it, for rows aslant
in a block that is not look like a mistake."""
AXES = len(TURNS) + 2
"""Headings to choose from: turned ones, and those along the two longest edges of a block."""
GAPS = (3.0, 2.0, 1.5, 1.2, 1.0)
"""How many times the least distance gaps may be, to choose from."""
ORDERS = 8
"""Orders in which models are taken."""
REMEMBERED = 8192
"""Fillings of a site that are remembered, and as many of its blocks."""


class BlockChoice(NamedTuple):
    """How a block is filled: numbers of its form (0: the usual one), of :data:`AXES`,
    :data:`QUEUES` and :data:`GAPS`."""

    form: int = 0
    axis: int = 0
    queue: int = 0
    gaps: int = 0


class SiteChoice(NamedTuple):
    """How a site is filled: a choice for each block (the last for all further ones), in which
    order models are taken (0: low ones first) and which block comes first (0: the sunniest)."""

    blocks: tuple[BlockChoice, ...]
    ranks: int = 0
    first: int = 0


Fill = Callable[[SiteChoice], SiteLayout]
LayBlock = Callable[[bytes, tuple[int, ...], float, str, float], BlockLayout]


def fill_chosen(problem: SiteProblem, choice: SiteChoice, fill: Fill | None = None) -> SiteFound:
    """A site filled as chosen; the same choice gives the same layout. ``fill`` is one that
    remembers (:func:`remember_fillings`), if there is one."""
    fill = fill or partial(_fill, problem, partial(_lay_block, problem))
    best = fill(_tighten(choice))
    taken = choice
    for plainer in _list_plainer(choice):
        if best.present.all():
            break
        found = fill(_tighten(plainer))
        if found.present.sum() > best.present.sum():
            best, taken = found, plainer
    wide = fill(taken)
    if wide.present.sum() >= best.present.sum():
        best = wide
    return Found((best,), len(problem.ground.block_areas))


def remember_fillings(problem: SiteProblem) -> Fill:
    """How a site is filled as a choice says, step by step of :func:`fill_chosen`, remembering
    fillings and blocks; several threads may call it, none may change what it gives."""
    lay = lru_cache(REMEMBERED)(partial(_lay_block, problem))
    return lru_cache(REMEMBERED)(partial(_fill, problem, lay))


def _tighten(choice: SiteChoice) -> SiteChoice:
    """A choice with the least gaps."""
    blocks = tuple(one._replace(gaps=len(GAPS) - 1) for one in choice.blocks)
    return choice._replace(blocks=blocks)


def _list_plainer(choice: SiteChoice) -> Iterator[SiteChoice]:
    """Less and less of a choice: what takes most room is given up first, models are taken in
    other orders."""
    for given, orders in (({"axis": 0}, 3), ({"axis": 0, "form": 0}, 4)):
        blocks = tuple(one._replace(**given) for one in choice.blocks)
        for k in range(orders):
            yield choice._replace(blocks=blocks, ranks=(choice.ranks + k) % ORDERS)


def _fill(problem: SiteProblem, lay: LayBlock, choice: SiteChoice) -> SiteLayout:
    """One filling, block by block; what finds no place in its block goes on to the next, in the
    end to any."""
    n = len(problem.buildings.sizes)
    boxes, present, forms = np.zeros((n, 5)), np.zeros(n, bool), [""] * n
    order = order_blocks(problem)
    order = order[choice.first % len(order) :] + order[: choice.first % len(order)] if order else []
    left = rank_buildings(problem, choice.ranks)
    for last in (False, True):
        for count, b in enumerate(order if left else []):
            if last and problem.court_gap > 0.0 and problem.block_forms[b] == "peripheral":
                continue  # what is left would fill the court
            share = left if last else share_out(problem, left, order[count:])
            taken = choice.blocks[min(b, len(choice.blocks) - 1)]
            taken = taken._replace(gaps=len(GAPS) - 1) if last else taken
            found = _fill_block(problem, lay, b, boxes, present, share, taken)
            numbers = list(found.numbers)
            boxes[numbers], present[numbers] = found.boxes, True
            for i in numbers:
                forms[i] = found.form
            left = [i for i in left if not present[i]]
    return SiteLayout(boxes, present, {}, tuple(forms))


def _fill_block(
    problem: SiteProblem,
    lay: LayBlock,
    block: int,
    boxes: Floats,
    present: Flags,
    share: list[int],
    taken: BlockChoice,
) -> BlockLayout:
    """A block filled as chosen, beside the buildings that stand already."""
    edges = list_ground(problem, block, boxes, present, share)
    form = choose_form(problem, share, block, taken.form)
    queue = order_queue(problem, share, QUEUES[taken.queue])
    axis = choose_axis(problem, list_edges(problem, block), taken.axis)
    return lay(edges.tobytes(), tuple(queue), axis, form, GAPS[taken.gaps])


def _lay_block(
    problem: SiteProblem, ground: bytes, queue: tuple[int, ...], axis: float, form: str, gaps: float
) -> BlockLayout:
    """A layout of the block whose edges (e, 4) are kept in ``ground``, so that equal blocks are
    known again."""
    edges = np.frombuffer(ground).reshape(-1, 4).copy()
    return loosen_layout(problem, edges, list(queue), axis, form, gaps)


def choose_form(problem: SiteProblem, share: list[int], block: int, form: int) -> str:
    """A planar form by its number: of all, unless some are asked for."""
    asked = bool(problem.block_forms[block : block + 1] and problem.block_forms[block])
    asked = asked or any(problem.buildings.forms[i] for i in share if problem.buildings.forms)
    allowed = tuple(list_forms(problem, share, block)) if asked else FORMS
    return allowed[(form - 1) % len(allowed)] if form else allowed[0]


def choose_axis(problem: SiteProblem, edges: Floats, axis: int) -> float:
    """A heading for a block of ``edges`` (e, 4) by its number, in radians."""
    if axis < len(TURNS):
        return problem.facing + TURNS[axis]
    return headings(problem, edges)[1 + (axis - len(TURNS)) % 2]


def rank_buildings(problem: SiteProblem, ranks: int) -> list[int]:
    """Buildings model by model: the lowest models first, or the models in an order drawn."""
    models, sizes = problem.buildings.models, problem.buildings.sizes
    names = np.unique(models).tolist()
    tall = {m: float(sizes[models == m, 2].max()) for m in names}
    if ranks:
        drawn = np.random.default_rng(ranks).permutation(len(names)).tolist()
        tall = dict(zip(names, drawn, strict=True))
    return sorted(range(len(sizes)), key=lambda i: (tall[int(models[i])], int(models[i]), i))
