"""The default solver of sites: blocks filled row by row, forms chosen block by block.

Every block gets its share of the buildings and tries forms (rows parallel or staggered, around
its rim, both), headings and orders (low models first, or those that look best); gaps widen until
the block is just filled. Placed buildings keep their distances by construction, so the search only
chooses among valid layouts, and the work grows with the number of blocks and rows, not with pairs
of buildings.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.domains.site.solvers.aims import Around, around, lacking
from scenewright.domains.site.solvers.blocks.block import (
    USUAL,
    BlockBorder,
    BlockLayout,
    choose_heading,
    headings,
    lay_out_block,
    list_forms,
    loosen_layout,
)
from scenewright.domains.site.solvers.blocks.closed_court import close_court
from scenewright.domains.site.solvers.blocks.distances import list_reserved_edges
from scenewright.domains.site.solvers.blocks.front import (
    inside,
    list_square_lines,
    on_square,
    set_back,
)
from scenewright.domains.site.solvers.blocks.perimeter_block import list_front_lines, rim
from scenewright.domains.site.solvers.blocks.schemes import (
    QUEUES,
    Scheme,
    choose_scheme,
    find_void,
    list_open_edges,
    order_queue,
    spread_points,
)
from scenewright.domains.site.solvers.blocks.shares import (
    list_edges,
    list_ground,
    list_low_first,
    order_blocks,
    share_out,
)
from scenewright.domains.site.solvers.improve import improve_layout
from scenewright.domains.site.solvers.interlock import interlock
from scenewright.domains.site.solvers.loosen import loosen_buildings
from scenewright.domains.site.solvers.outcome import SiteFound, SiteLayout
from scenewright.domains.site.solvers.podiums import join_podiums
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress

ALIKE = 1e-6
"""Square metres of floor that rounding may be off."""
FALLBACK, MISSING, KNOWN = 4, 40.0, 12
"""Every how many layouts of a block one is in a usual form instead of the scheme's; what a block
costs that holds nothing of its share; layouts after which orders and shares are drawn."""


def fill_site(
    problem: SiteProblem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> SiteFound:
    """Fill all blocks of a site from the sunny side on; what finds no place in its block goes on
    to the next. If anything is left over, gaps may widen less, in the end not at all. ``steps`` are
    layouts tried for each block. Deterministic by seed unless the budget is in seconds."""
    watch = BudgetWatch(budget._replace(steps=None), progress, cancel)
    rule, begun = problem.settings.fill, 0.0
    tried = max(budget.steps or rule.tried, 1)
    ends = np.linspace(rule.filled, rule.most, len(rule.loosest)).tolist()
    best: SiteLayout | None = None
    done, rng = 0, np.random.default_rng(seed)
    for loosest, until in zip(rule.loosest, ends, strict=True):
        filling = Filling(watch, begun, until, best)
        found, more = _fill_blocks(problem, loosest, tried, choose_scheme(seed), rng, filling)
        done, begun = done + more, until
        if best is None or found.present.sum() > best.present.sum():
            best = found
        if best.present.all() or watch.share(0) >= 1.0 or watch.cancelled():
            break
    assert best is not None
    set_in, tries = interlock(problem, best, watch, rng, begun)
    best = set_in if set_in is best else loosen_buildings(problem, set_in, watch, rng)
    best, joined = join_podiums(problem, best)
    better, more = improve_layout(problem, best, seed, watch, begun, joined)
    return Found((better,), done + tries + more)


class Filling(NamedTuple):
    """One filling of all blocks as a part of a run: the shares of the run done before and after
    it, and the best layout of those before."""

    watch: BudgetWatch
    begun: float
    until: float
    before: SiteLayout | None

    def over(self, share: float, boxes: Floats, present: Flags, forms: list[str]) -> bool:
        """Report the layout, ``share`` of this filling being done; true if it should end."""

        def best() -> SiteLayout:
            if self.before is not None and self.before.present.sum() >= present.sum():
                return self.before
            return SiteLayout(boxes.copy(), present.copy(), {}, tuple(forms))

        return self.watch.reached(self.begun + (self.until - self.begun) * share, best)


def _fill_blocks(
    problem: SiteProblem,
    loosest: float,
    tried: int,
    scheme: Scheme,
    rng: np.random.Generator,
    filling: Filling,
) -> tuple[SiteLayout, int]:
    """One filling of all blocks, gaps at most ``loosest`` times the least, and the layouts tried;
    at 1 each block takes all it can, not its share."""
    n = len(problem.buildings.sizes)
    boxes, present, forms = np.zeros((n, 5)), np.zeros(n, bool), [""] * n
    order, done = order_blocks(problem), 0
    left = _line_squares(problem, boxes, present, forms)
    for count, b in enumerate(order):
        if filling.over(count / len(order), boxes, present, forms) and count:
            break
        share = left if loosest == 1.0 else share_out(problem, left, order[count:])
        ground = list_ground(problem, b, boxes, present, share)
        about = around(problem, list_edges(problem, b), boxes, present)
        effort = Effort(tried if loosest > 1.0 else 4 * tried, loosest, scheme, loosest > 1.0)
        over = partial(_over_in_block, filling, count, len(order), boxes, present, forms)
        found = _best(problem, about, b, ground, share, effort, rng, over)
        done += tried
        left = _record_block(found, left, boxes, present, forms)
    for b in order if left else []:
        if filling.watch.cancelled():
            break
        if problem.court_gap > 0.0 and problem.block_forms[b] == "peripheral":
            continue  # what is left would fill the court
        ground = list_ground(problem, b, boxes, present, left)
        form = list_forms(problem, left, b)[0]
        found = lay_out_block(problem, ground, left, problem.facing, form, 1.0)
        left = _record_block(found, left, boxes, present, forms)
    if left and loosest > 1.0:
        done += _refill_blocks(problem, tried, scheme, rng, filling, (boxes, present, forms))
    return SiteLayout(boxes, present, {}, tuple(forms)), done


def _refill_blocks(
    problem: SiteProblem,
    tried: int,
    scheme: Scheme,
    rng: np.random.Generator,
    filling: Filling,
    standing: tuple[Floats, Flags, list[str]],
) -> int:
    """Fill blocks anew with what they hold and what is left over, those with most free ground
    first, until nothing is; the rest stays as the scheme has it. How many layouts were tried."""
    boxes, present, forms = standing
    floor, done = problem.buildings.sizes[:, :2].prod(1), 0
    spans = range(len(problem.ground.block_areas))
    lots = [inside(list_edges(problem, b), boxes[:, :2]) & present for b in spans]
    if len(problem.ground.squares):
        lots = [lot & ~on_square(problem, boxes) for lot in lots]
    free = [problem.ground.block_areas[b] - floor[lots[b]].sum() for b in spans]
    for b in sorted(spans, key=lambda b: -free[b]):
        left = [i for i in list_low_first(problem) if not present[i]]
        if not left or filling.watch.cancelled():
            break
        if problem.court_gap > 0.0 and problem.block_forms[b] == "peripheral":
            continue
        others = present & ~lots[b]
        share = [i for i in list_low_first(problem) if not others[i]]
        ground = list_ground(problem, b, boxes, others, share)
        about = around(problem, list_edges(problem, b), boxes, others)
        effort = Effort(tried, 1.0, scheme, True)
        found = _best(problem, about, b, ground, share, effort, rng)
        done += tried
        if floor[list(found.numbers)].sum() > floor[lots[b]].sum() + ALIKE:
            present[lots[b]] = False
            _record_block(found, left, boxes, present, forms)
    return done


def _line_squares(
    problem: SiteProblem, boxes: Floats, present: Flags, forms: list[str]
) -> list[int]:
    """Set buildings along the squares, as near to each other as may be, before all else; those that
    are still left, the lowest models first."""
    left = list_low_first(problem)
    if not len(problem.ground.squares):
        return left
    sizes, given = problem.buildings.sizes, problem.buildings.forms
    wide = sorted(left, key=lambda i: -float(sizes[i, 0]))
    for b in range(len(problem.ground.block_areas)):
        queue = [i for i in wide if not present[i] and not (given and given[i])]
        lines = list_square_lines(problem, list_front_lines(list_edges(problem, b)))
        ground = list_ground(problem, b, boxes, present, queue)
        numbers, places = rim(ground, sizes, queue, problem.spacing, 1.0, None, lines)
        if problem.court_gap > 0.0 and problem.block_forms[b] == "peripheral" and numbers:
            tall = float(sizes[:, 2].max())
            taken = list_reserved_edges(problem, places, sizes[numbers, 2], tall)
            rest = [i for i in left if i not in set(numbers)]
            if not close_court(problem, np.concatenate([ground, taken]), rest, problem.spacing):
                continue
        left = _record_block(
            BlockLayout(tuple(numbers), places, "mixed"), left, boxes, present, forms
        )
    return left


def _over_in_block(
    filling: Filling,
    count: int,
    blocks: int,
    boxes: Floats,
    present: Flags,
    forms: list[str],
    share: float,
) -> bool:
    """Report a share of the layouts of one block after ``count`` of ``blocks`` blocks."""
    return filling.over((count + share) / blocks, boxes, present, forms)


def _record_block(
    found: BlockLayout, left: list[int], boxes: Floats, present: Flags, forms: list[str]
) -> list[int]:
    """Write the buildings of a block down; those that are still left."""
    for i, box in zip(found.numbers, found.boxes, strict=True):
        boxes[i], present[i], forms[i] = box, True, found.form
    return [i for i in left if not present[i]]


class Effort(NamedTuple):
    """How a block is looked at: layouts ``tried``, how many times the least gaps may be, the scheme
    of the site, and whether most layouts are ``composed`` as it says."""

    tried: int
    loosest: float
    scheme: Scheme
    composed: bool


def _best(
    problem: SiteProblem,
    about: Around,
    block: int,
    edges: Floats,
    share: list[int],
    effort: Effort,
    rng: np.random.Generator,
    over: Callable[[float], bool] | None = None,
) -> BlockLayout:
    """The best of several layouts of one block: most floor placed, then what it lacks in the aims
    and how far fronts are turned away. Aims are looked at only where they may decide."""
    lines = list_edges(problem, block)
    ways, allowed = headings(problem, lines), list_forms(problem, share, block)
    points, rule = spread_points(lines), problem.settings.fill
    scheme, free = effort.scheme, allowed == list(USUAL)
    along = choose_heading(ways, scheme.axis) if free else ways[scheme.axis]
    park = list_open_edges(lines, problem.ground.block_areas[block], along, scheme)
    aside = rule.aside if len(problem.ground.roads) else 0.0
    lines = np.roll(list_front_lines(lines), scheme.order, axis=0)
    best, least = BlockLayout((), np.zeros((0, 5)), "parallel"), math.inf
    deep = _find_building_line(problem, share)
    for k in range(effort.tried if share else 0):
        if k and over and over(k / effort.tried):
            break
        composed = free and effort.composed and k % FALLBACK < FALLBACK - 1
        form = scheme.form if composed else allowed[(k + scheme.order) % len(allowed)]
        heading = along if composed else ways[k // len(allowed) % len(ways)]
        queue = order_queue(problem, share, QUEUES[(k + scheme.order) % len(QUEUES)])
        opened = effort.loosest > 1.0 and k % 3 < 2
        part = rule.parts[k % len(rule.parts)]
        if (k and effort.loosest == 1.0) or k >= KNOWN:
            queue = _shuffle_buildings(problem, share, rng)
            part = float(rng.uniform(min(rule.parts), 1.0))
        ground = np.concatenate([edges, park]) if opened else edges
        back = rule.backs[k % len(rule.backs)] if free and effort.loosest > 1.0 else 0.0
        moved, kept = set_back(problem, lines, back * deep) if back else (lines, lines[:0])
        ground = np.concatenate([ground, kept])
        border = BlockBorder(moved)
        if composed:
            border = BlockBorder(moved, part, rule.widest, aside)
        found = loosen_layout(problem, ground, queue, heading, form, effort.loosest, border)
        cost = _cost(problem, found, share) + rule.variety * float(rng.random())
        cost += rule.void * find_void(points, found.boxes) if effort.loosest > 1.0 else 0.0
        cost += rule.forward * (1.0 - back)
        cost += rule.other * (float(free and not composed) + 0.5 * (not opened))
        cost += lacking(problem, about, found, least - cost) if cost < least else 0.0
        if cost < least:
            best, least = found, cost
    return best


def _find_building_line(problem: SiteProblem, share: list[int]) -> float:
    """Metres from the sides of a block along the border to the line that buildings keep behind."""
    times, least, most = problem.settings.fill.back
    if not share:
        return 0.0
    return float(np.clip(times * np.median(problem.buildings.sizes[share, 2]), least, most))


def _shuffle_buildings(
    problem: SiteProblem, share: list[int], rng: np.random.Generator
) -> list[int]:
    """The buildings model by model, the models in any order."""
    models = problem.buildings.models
    drawn = rng.permutation(np.unique(models[share])).tolist()
    return sorted(share, key=lambda i: (drawn.index(int(models[i])), i))


def _cost(problem: SiteProblem, found: BlockLayout, share: list[int]) -> float:
    """Share of the floor not placed, and how far fronts are turned from the preferred heading."""
    area = problem.buildings.sizes[:, :2].prod(1)
    missing = 1.0 - area[list(found.numbers)].sum() / max(float(area[share].sum()), 1e-9)
    turns = np.abs((found.boxes[:, 2] - problem.facing + math.pi) % (2 * math.pi) - math.pi)
    turned = float(turns.mean() if len(turns) else 0.0) / math.pi
    rule = problem.settings.fill
    return float(missing) * MISSING + rule.askew * turned + (rule.unclosed if found.open else 0.0)
