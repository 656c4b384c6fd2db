"""The default solver of sites: blocks filled row by row, forms chosen block by block.

Every block gets its share of the buildings and tries forms (rows parallel or staggered, around
its rim, both), headings and orders; gaps widen until the block is just filled. Placed buildings
keep their distances by construction, so the search only chooses among valid layouts, and the work
grows with the number of blocks and rows, not with pairs of buildings.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.layout import corners
from scenewright.site_problem import Flags, Floats, SiteProblem
from scenewright.solve import Budget, Cancel, Progress, Watch
from scenewright.solvers.site_found import SiteFound
from scenewright.solvers.site_rim import rim
from scenewright.solvers.site_strips import Rule, back, rows, turned

FORMS = ("parallel", "staggered", "peripheral", "mixed")
TRIED = 6
LOOSEST, HALVINGS = (3.0, 1.5, 1.0, 1.0, 1.0), 5
VARIETY = 0.15  # how much chance has a say among forms about as good
ASKEW = 0.5  # what half a turn off the preferred heading costs, in shares of a block's buildings


class Placed(NamedTuple):
    """Buildings of a block: their numbers and boxes (k, 5), and the form."""

    numbers: tuple[int, ...]
    boxes: Floats
    form: str


def fill_site(
    problem: SiteProblem, budget: Budget, seed: int, progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> SiteFound:  # fmt: skip
    """Fill all blocks of a site from the sunny side on; what finds no place in its block goes on
    to the next. If anything is left over, gaps may widen less, in the end not at all. ``steps`` are
    layouts tried for each block. Deterministic by seed unless the budget is in seconds."""
    watch = Watch(budget._replace(steps=None), None, cancel)
    tried = max((budget.steps or TRIED), 1)
    best: SiteFound | None = None
    done, rng = 0, np.random.default_rng(seed)
    for loosest in LOOSEST:
        if progress is not None:
            progress(done / (done + 1.0), 0.0)
        found = _filled(problem, loosest, tried, rng, watch, done)
        done += found.evaluations
        if best is None or found.present.sum() > best.present.sum():
            best = found
        if best.present.all() or watch.over(done, 0.0):
            break
    assert best is not None
    return best._replace(evaluations=done)


def _filled(
    problem: SiteProblem, loosest: float, tried: int, rng: np.random.Generator, watch: Watch,
    before: int,
) -> SiteFound:  # fmt: skip
    """One filling of all blocks, gaps at most ``loosest`` times the least; at 1 each block takes
    all it can, not its share."""
    n = len(problem.buildings.sizes)
    boxes, present, forms = np.zeros((n, 5)), np.zeros(n, bool), [""] * n
    order = _southern_first(problem)
    left, done = _low_first(problem), 0
    for count, b in enumerate(order):
        if watch.over(before + done, 0.0) and count:
            break
        share = left if loosest == 1.0 else _share(problem, left, order[count:])
        ground = _ground(problem, b, boxes, present, share)
        found = _best(problem, ground, share, (tried if loosest > 1.0 else 4 * tried, loosest), rng)
        done += tried
        left = _settled(found, left, boxes, present, forms)
    for b in order if left else []:
        ground = _ground(problem, b, boxes, present, left)
        found = _laid(problem, ground, left, problem.facing, "parallel", 1.0)
        left = _settled(found, left, boxes, present, forms)
    return SiteFound(boxes, present, {}, done, 1, tuple(forms))


def _settled(
    found: Placed, left: list[int], boxes: Floats, present: Flags, forms: list[str]
) -> list[int]:
    """Write the buildings of a block down; those that are still left."""
    for i, box in zip(found.numbers, found.boxes, strict=True):
        boxes[i], present[i], forms[i] = box, True, found.form
    return [i for i in left if not present[i]]


def _southern_first(problem: SiteProblem) -> list[int]:
    """Blocks from the side the fronts look to."""
    front = np.array([math.cos(problem.facing), math.sin(problem.facing)])
    middles = [_edges(problem, b)[:, :2].mean(0) @ front for b in range(len(_areas(problem)))]
    return np.argsort(-np.array(middles), kind="stable").tolist()


def _low_first(problem: SiteProblem) -> list[int]:
    """Buildings by model, the lowest models first: like ones together, tall ones where their
    shadow falls on few."""
    sizes, models = problem.buildings.sizes, problem.buildings.models
    tall = {m: float(sizes[models == m, 2].max()) for m in np.unique(models).tolist()}
    return sorted(range(len(sizes)), key=lambda i: (tall[int(models[i])], int(models[i]), i))


def _areas(problem: SiteProblem) -> Floats:
    return np.asarray(problem.ground.block_areas, np.float64)


def _share(problem: SiteProblem, left: list[int], blocks: list[int]) -> list[int]:
    """The buildings the first of some blocks takes of those that are left: the next ones, up to
    its share of the ground."""
    areas, sizes = _areas(problem), problem.buildings.sizes
    share = float(areas[blocks[0]] / areas[blocks].sum())
    floor = np.array([_ground_of(problem, sizes[i]) for i in left])
    if not len(floor):
        return []
    count = int(np.searchsorted(np.cumsum(floor) - 0.5 * floor, share * floor.sum()))
    return left[:count]


def _ground_of(problem: SiteProblem, size: Floats) -> float:
    """Ground a building needs with its distances."""
    behind = max(problem.spacing, problem.sun_spacing * float(size[2]))
    return float((size[0] + problem.spacing) * (size[1] + behind))


def _edges(problem: SiteProblem, b: int) -> Floats:
    first, last = problem.ground.block_spans[b]
    return problem.ground.block_edges[first:last]


def _ground(
    problem: SiteProblem, b: int, boxes: Floats, present: Flags, waiting: list[int]
) -> Floats:
    """Edges of a block less what stands near with its distances."""
    edges, sizes = _edges(problem, b), problem.buildings.sizes
    low, high = edges.reshape(-1, 2).min(0), edges.reshape(-1, 2).max(0)
    standing = np.concatenate([boxes[present], problem.ground.landmarks])
    heights = np.concatenate([sizes[present, 2], problem.ground.landmark_heights])
    ahead = float(sizes[waiting, 2].max()) if waiting else 0.0
    far = (
        problem.spacing
        + problem.sun_spacing * np.maximum(heights, ahead)
        + standing[:, 3:].max(1, initial=0.0)
    )
    near = ((standing[:, :2] + far[:, None] > low) & (standing[:, :2] - far[:, None] < high)).all(1)
    if not near.any():
        return edges
    return np.concatenate([edges, _kept(problem, standing[near], heights[near], ahead)])


def _kept(problem: SiteProblem, boxes: Floats, heights: Floats, ahead: float) -> Floats:
    """Edges (clockwise) of the ground that buildings keep from others: the spacing all around;
    behind, away from the sun, as many of their heights as asked for, and ahead as many of the
    heights of those to come."""
    heading = noon(problem)
    c, s = math.cos(heading), math.sin(heading)
    rings = corners(boxes)
    x = rings[..., 0] * s - rings[..., 1] * c
    y = rings[..., 0] * c + rings[..., 1] * s
    gap, sun = problem.spacing, problem.sun_spacing
    x0, x1 = x.min(1) - gap, x.max(1) + gap
    y0, y1 = y.min(1) - np.maximum(gap, sun * heights), y.max(1) + max(gap, sun * ahead)
    px, py = np.stack([x0, x0, x1, x1], 1), np.stack([y0, y1, y1, y0], 1)
    ring = np.stack(back(px, py, heading), -1)
    edges: Floats = np.concatenate([ring, np.roll(ring, -1, axis=1)], axis=2).reshape(-1, 4)
    return edges


def noon(problem: SiteProblem) -> float:
    """The heading towards the sun at noon: south in the northern half of the world."""
    return -math.pi / 2 if problem.latitude >= 0.0 else math.pi / 2


def _in_sun(problem: SiteProblem, found: Placed) -> Placed:
    """A layout without the buildings that stand too near behind another one of it."""
    if problem.sun_spacing <= 0.0 or len(found.numbers) < 2:
        return found
    heading = noon(problem)
    c, s = math.cos(heading), math.sin(heading)
    rings = corners(found.boxes)
    x = rings[..., 0] * s - rings[..., 1] * c
    y = rings[..., 0] * c + rings[..., 1] * s
    reach = problem.sun_spacing * problem.buildings.sizes[list(found.numbers), 2]
    beside = (x.min(1)[:, None] < x.max(1)[None, :]) & (x.max(1)[:, None] > x.min(1)[None, :])
    gap = y.min(1)[:, None] - y.max(1)[None, :]
    behind = y.mean(1)[:, None] > y.mean(1)[None, :]
    dark = (beside & behind & (gap < reach[:, None] - 1e-6)).any(0)
    kept = np.flatnonzero(~dark)
    return Placed(tuple(found.numbers[k] for k in kept), found.boxes[kept], found.form)


def _headings(problem: SiteProblem, edges: Floats) -> list[float]:
    """The preferred heading, and those along the two longest edges nearest to it."""
    way = edges[:, 2:] - edges[:, :2]
    longest = np.argsort(-np.hypot(way[:, 0], way[:, 1]), kind="stable")[:2]
    found = [problem.facing]
    for k in longest.tolist():
        along = math.atan2(way[k, 1], way[k, 0])
        turns = [along + q * math.pi / 2 for q in range(4)]
        found.append(min(turns, key=lambda a: abs(_wrapped(a - problem.facing))))
    return found


def _best(
    problem: SiteProblem, edges: Floats, share: list[int], effort: tuple[int, float],
    rng: np.random.Generator,
) -> Placed:  # fmt: skip
    """The best of several layouts of one block: most floor placed, then least turned away."""
    headings = _headings(problem, edges)
    forms = _forms(problem, share)
    best, least = Placed((), np.zeros((0, 5)), "parallel"), math.inf
    for k in range(effort[0] if share else 0):
        heading = headings[0] if k < 4 else headings[int(rng.integers(len(headings)))]
        form, queue = forms[k % len(forms)], list(share)
        if k and effort[1] == 1.0:
            queue = _shuffled(problem, share, rng)
        found = _loosened(problem, edges, queue, heading, form, effort[1])
        cost = _cost(problem, found, share) + VARIETY * float(rng.random())
        if cost < least:
            best, least = found, cost
    return best


def _forms(problem: SiteProblem, share: list[int]) -> list[str]:
    """The forms that all buildings of a block may take; all, if there is none."""
    asked = [problem.buildings.forms[i] for i in share] if problem.buildings.forms else []
    allowed = [form for form in FORMS if all(form in one for one in asked if one)]
    return allowed or list(FORMS)


def _shuffled(problem: SiteProblem, share: list[int], rng: np.random.Generator) -> list[int]:
    """The buildings model by model, the models in any order."""
    models = problem.buildings.models
    drawn = rng.permutation(np.unique(models[share])).tolist()
    return sorted(share, key=lambda i: (drawn.index(int(models[i])), i))


def _cost(problem: SiteProblem, found: Placed, share: list[int]) -> float:
    """Share of the floor not placed, and how far fronts are turned from the preferred heading."""
    area = problem.buildings.sizes[:, :2].prod(1)
    missing = 1.0 - area[list(found.numbers)].sum() / max(float(area[share].sum()), 1e-9)
    turns = np.abs((found.boxes[:, 2] - problem.facing + math.pi) % (2 * math.pi) - math.pi)
    return float(missing) * 10.0 + ASKEW * float(turns.mean() if len(turns) else 0.0) / math.pi


def _loosened(
    problem: SiteProblem, edges: Floats, queue: list[int], heading: float, form: str,
    loosest: float,
) -> Placed:  # fmt: skip
    """A layout of a block with gaps as wide as still hold all that the least gaps hold."""
    tight = _laid(problem, edges, queue, heading, form, 1.0)
    low, high, best = 1.0, loosest, tight
    for _ in range(HALVINGS if loosest > 1.0 else 0):
        loose = 0.5 * (low + high)
        found = _laid(problem, edges, queue, heading, form, loose)
        if len(found.numbers) >= len(tight.numbers):
            low, best = loose, found
        else:
            high = loose
    return best


def _laid(
    problem: SiteProblem, edges: Floats, queue: list[int], heading: float, form: str, loose: float
) -> Placed:
    """One layout of a block."""
    sizes, way = problem.buildings.sizes, problem.fire_access
    rule = Rule(problem.spacing, way, problem.sun_spacing, loose, form == "staggered", True)
    numbers: list[int] = []
    boxes = np.zeros((0, 5))
    waiting = queue
    if form in ("peripheral", "mixed"):
        share = 0.5 if form == "mixed" else 1.0
        numbers, boxes = rim(edges, sizes, queue, max(rule.beside(), way), share)
        waiting = [i for i in queue if i not in set(numbers)]
    if len(boxes):
        ahead = float(sizes[waiting, 2].max()) if waiting else 0.0
        edges = np.concatenate([edges, _kept(problem, boxes, sizes[numbers, 2], ahead)])
    block = turned(edges, heading)
    placed = rows(block, sizes, waiting, rule)
    found = np.zeros((len(placed), 5))
    if placed:
        at = np.array([(x, y) for _, x, y in placed])
        found[:, 0], found[:, 1] = back(at[:, 0], at[:, 1], heading)
        found[:, 2] = heading
        found[:, 3:] = sizes[[i for i, _, _ in placed], :2]
    numbers += [i for i, _, _ in placed]
    return _in_sun(problem, Placed(tuple(numbers), np.concatenate([boxes, found]), form))


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi
