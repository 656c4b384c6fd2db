"""Grown buildings settled: no footprint twice that the sources have once, no slits between walls.

What the sources have once is copied as a variant, and so is what would be there more often than
in them: mirrored, wider or deeper, its front where it was; or another of about its width comes.
What stands a slit from its neighbour moves or widens up to its wall where the sources have party
walls, else it leaves a passage. Of all candidates for a building the one with the fewest slits and
repeats is taken, changed least; none comes nearer to another than it was, unless up to its wall.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.extend.pattern import SourcePattern, pair_kind
from scenewright.domains.extend.problem import (
    ExtendProblem,
    Floats,
    GrownLayout,
    Indices,
    boxes_at,
    shapes_at,
)
from scenewright.domains.extend.solvers.canvas import TOUCH, measure_thickness

SLIT, WALL = 1.5, 0.05
"""Metres between two walls below which nobody walks, where the sources have no such gaps, and below
which they are one."""
PASSAGE, WIDEST = 2.0, 6.0
"""Metres of a passage where the sources have none, and of the widest that is one."""
SEEN, DIFFERENT, ALIKE = 50.0, 0.62, 0.04
"""Metres within which a repeat is seen, by which two sizes differ to the eye, and by how much two
footprints that look alike may differ in how they fill their boxes."""
TIMES = (0.97, 1.03, 0.94, 1.06, 0.91, 1.1, 0.88, 1.14)
VARIANTS = (
    (1.0, 1.0),
    *((1.0, times) for times in TIMES),
    *((times, 1.0) for times in TIMES),
    *((times, 1 / times) for times in TIMES[2:]),
)
"""How many times as wide and as deep variants are."""
MOST = 1.15
"""How many times as wide or deep as its original a building may become."""
SIMILAR, OTHERS = 0.3, 8
"""Logarithm of the ratio of depths of two buildings of which one may take the other's place, and
how many are tried."""
TERRACED = 0.15
"""The share of buildings with a wall at another's from which walls may touch, and of those with a
gap below :data:`SLIT` from which that is no slit."""
TURNED = float(np.deg2rad(8.0))
"""How far a building may turn to stand along the wall of its neighbour."""
REPEATED, CHANGED = 0.7, 1.0
"""What a repeat costs, in slits, and the logarithm of a stretch with the metres moved."""
JOINT = 0.04
"""Metres of the joint between two walls."""
ROUNDS = 2


class SettledState(NamedTuple):
    """Grown buildings while they are settled, before those that stand: poses (n, 3), origins (n,)
    and forms (n, 2), shapes (n + m,) and boxes (n + m, 5), and how they fill these."""

    poses: Floats
    origin: Indices
    form: Floats
    shapes: NDArray[np.object_]
    boxes: Floats
    fill: Floats


class Candidate(NamedTuple):
    """How a building may stand: its pose (3,), form (2,), and which of the sources it is like."""

    pose: Floats
    form: Floats
    origin: int


class SettlingRules(NamedTuple):
    """What is learned of the sources: which share of their buildings each kind is (n,), 0 for one
    that is there once, infinite for one whose model cannot be varied; the least and most width
    and depth (2, 2), whether walls may touch, the widths of a slit at most and of a passage."""

    shares: Floats
    sides: Floats
    touching: bool
    slit: float
    passage: float


class SettlingGround(NamedTuple):
    """A problem with its rules and its floor, ready to be asked."""

    problem: ExtendProblem
    rules: SettlingRules
    floor: shapely.Geometry


def read_settling(problem: ExtendProblem) -> SettlingRules:
    """The rules of the sources of a problem."""
    pattern = problem.pattern
    copies = np.array([kind.copies for kind in pattern.kinds], float)
    copies[copies == 1] = 0.0
    copies[[bool(kind.model) for kind in pattern.kinds]] = np.inf
    tree = shapely.STRtree(pattern.shapes)
    _, away = tree.query_nearest(
        pattern.shapes, exclusive=True, return_distance=True, all_matches=False
    )
    narrow = away[(away > WALL) & (away < SLIT)]
    slit = SLIT if len(narrow) < TERRACED * len(away) else float(np.quantile(narrow, 0.1)) * 0.98
    wide = away[(away >= slit) & (away <= WIDEST)]
    return SettlingRules(
        copies / len(pattern.boxes),
        np.quantile(pattern.boxes[:, 3:], (0.05, 0.95), axis=0),
        bool((away <= WALL).mean() > TERRACED),
        slit,
        float(np.quantile(wide, 0.25)) if len(wide) else PASSAGE,
    )


def settle(
    problem: ExtendProblem, rules: SettlingRules, layout: GrownLayout, rng: np.random.Generator
) -> GrownLayout:
    """The layout with variants in place of repeats, and without slits as far as there is room."""
    free = np.array([how != "row" for how in layout.how], bool)
    if not free.any():
        return layout
    state = _begin(problem, layout)
    floor = problem.floor.buffer(1e-3, join_style="mitre")
    shapely.prepare(floor)
    ground = SettlingGround(problem, rules, floor)
    varied = free & _exceed(problem.pattern, rules, layout.origin)
    for turn in range(ROUNDS):
        for k in np.flatnonzero(free).tolist():
            near, slits = _find_near(rules, state, k)
            if len(slits):
                _take_best(ground, state, k, near, _list_beside(ground, state, k, slits))
            if varied[k] and not turn:
                mirror = (float(rng.choice((-1.0, 1.0))), 1.0)
                variants = [*_list_variants(state, k, mirror), *_list_others(ground, state, k)]
                _take_best(ground, state, k, near, variants, REPEATED)
    return layout._replace(poses=state.poses, origin=state.origin, form=state.form)


def _exceed(pattern: SourcePattern, rules: SettlingRules, origin: Indices) -> NDArray[np.bool_]:
    """Which copies (n,) are more of their kind than there would be in the sources."""
    kinds = pattern.kind[origin]
    before = np.array([np.count_nonzero(kinds[:k] == kind) for k, kind in enumerate(kinds)])
    return np.asarray(before >= np.round(rules.shares[kinds] * len(kinds)))


def _begin(problem: ExtendProblem, layout: GrownLayout) -> SettledState:
    pattern, standing = problem.pattern, problem.standing
    told = pattern, layout.poses, layout.origin, layout.form
    shapes = np.concatenate([shapes_at(*told), standing.shapes])
    boxes = np.concatenate([boxes_at(*told), standing.boxes])
    return SettledState(
        layout.poses.copy(),
        layout.origin.copy(),
        np.ones((len(layout.poses), 2)) if layout.form is None else layout.form.copy(),
        shapes,
        boxes,
        np.asarray(shapely.area(shapes)) / boxes[:, 3:].prod(1),
    )


def _find_near(rules: SettlingRules, state: SettledState, k: int) -> tuple[Indices, Indices]:
    """The buildings about one, and those of them a slit away."""
    half = np.hypot(state.boxes[:, 3], state.boxes[:, 4]) / 2
    step = state.boxes[:, :2] - state.boxes[k, :2]
    near = np.flatnonzero(np.hypot(*step.T) < half + half[k] * MOST + rules.passage + rules.slit)
    near = near[near != k]
    gaps = np.asarray(shapely.distance(state.shapes[near], state.shapes[k]))
    return near, near[(gaps > WALL) & (gaps < rules.slit)]


def _take_best(
    ground: SettlingGround,
    state: SettledState,
    k: int,
    near: Indices,
    listed: Sequence[Candidate],
    repeated: float = 0.0,
) -> None:
    """Take for a building among those ``near`` the best of those ``listed``, or leave it; a repeat
    costs ``repeated``."""
    pattern, others = ground.problem.pattern, state.shapes[near]
    every = [Candidate(state.poses[k], state.form[k], int(state.origin[k])), *listed]
    poses, forms = np.array([one.pose for one in every]), np.array([one.form for one in every])
    origin = np.array([one.origin for one in every])
    shapes = shapes_at(pattern, poses, origin, forms)
    boxes = boxes_at(pattern, poses, origin, forms)
    away = np.asarray(shapely.distance(shapes[:, None], others[None]))
    good = shapely.covers(ground.floor, shapes)
    good &= _keep_sides(ground.rules, boxes[:, 3:], pattern.boxes[origin, 3:])
    good &= _keep_apart(ground, away, boxes, state.boxes[near]).all(1)
    c, j = np.nonzero((away <= 0) & good[:, None])
    good[c[_overlap(shapes[c], others[j])]] = False
    good[0] = True
    cost = ((away > WALL) & (away < ground.rules.slit)).sum(1) + _change(poses, forms)
    cost = cost + repeated * _count_repeats(pattern, state, k, origin, boxes) if repeated else cost
    best = int(np.argmin(np.where(good, np.round(cost, 6), np.inf)))
    state.poses[k], state.form[k], state.origin[k] = every[best]
    state.shapes[k], state.boxes[k] = shapes[best], boxes[best]


def _change(poses: Floats, forms: Floats) -> Floats:
    """What candidates (n,) cost by how far they are from the first, as it is."""
    moved = np.hypot(*(poses[:, :2] - poses[0, :2]).T)
    return CHANGED * (0.1 * moved + np.abs(np.log(np.abs(forms))).sum(1))


def _keep_sides(rules: SettlingRules, sides: Floats, original: Floats) -> NDArray[np.bool_]:
    """Which widths and depths (n, 2) are among the sources', or as the ``original`` (n, 2), and no
    more than :data:`MOST` times it."""
    low, high = np.minimum(rules.sides[0], original), np.maximum(rules.sides[1], original)
    within = (sides >= low - 1e-6) & (sides <= high + 1e-6)
    return np.asarray(within.all(1) & is_variant(sides / original))


def is_variant(times: Floats) -> NDArray[np.bool_]:
    """Whether a building ``times`` (..., 2) as wide and as deep as another may be its variant.

    >>> is_variant(np.array([[1.1, 0.9], [1.0, 1.2]])).tolist()
    [True, False]
    """
    return np.asarray(((times < MOST) & (times > 1 / MOST)).all(-1))


def _keep_apart(
    ground: SettlingGround, away: Floats, boxes: Floats, others: Floats
) -> NDArray[np.bool_]:
    """Which gaps (n, m) of candidates are not less than of the first or than in the sources, but
    for walls that touch."""
    how = pair_kind(np.repeat(boxes, len(others), 0), np.tile(others, (len(boxes), 1)))
    least = np.maximum(
        np.array(ground.problem.pattern.gaps)[how].reshape(away.shape), ground.rules.slit
    )
    kept = away >= np.minimum(least, away[0]) - 1e-6
    walls = (away <= WALL) & (ground.rules.touching | (away[0] <= WALL))
    return np.asarray(kept | walls)


def _overlap(shapes: NDArray[np.object_], others: NDArray[np.object_]) -> NDArray[np.bool_]:
    """Whether candidates (m,) share ground with others (m,) by more than rounding."""
    return measure_thickness(shapely.intersection(shapes, others)) > TOUCH


def _count_repeats(
    pattern: SourcePattern, state: SettledState, k: int, origin: Indices, boxes: Floats
) -> Floats:
    """How many footprints within :data:`SEEN` of a building look like candidates (n,) for it, of
    some ``origin`` (n,); the original counts half wherever it stands."""
    near = np.hypot(*(state.boxes[:, :2] - state.boxes[k, :2]).T) < SEEN
    near[k] = False
    originals, sides = pattern.boxes[origin, 3:], boxes[:, 3:]
    fill = np.asarray(shapely.area(pattern.shapes[origin])) / originals.prod(1)
    like = np.abs(state.fill[near][None] - fill[:, None]) < ALIKE
    theirs = state.boxes[near, 3:]
    turned = np.minimum(_differ(theirs, sides), _differ(theirs[:, ::-1], sides))
    own = np.abs(sides - originals).max(1) < DIFFERENT
    return np.asarray((like & (turned < DIFFERENT)).sum(1) + 0.5 * own)


def _differ(one: Floats, other: Floats) -> Floats:
    """By how many metres sides (m, 2) differ from others (n, 2): (n, m)."""
    return np.asarray(np.abs(one[None] - other[:, None]).max(2))


def _list_variants(state: SettledState, k: int, mirror: tuple[float, float]) -> Iterator[Candidate]:
    """A building wider or deeper, its front where it was, mirrored or not (-1 or 1)."""
    form, deep, origin = state.form[k] * mirror, state.boxes[k, 4], int(state.origin[k])
    for times in VARIANTS:
        yield Candidate(_put_back(state.poses[k], deep, deep * times[1]), form * times, origin)


def _list_others(ground: SettlingGround, state: SettledState, k: int) -> Iterator[Candidate]:
    """Others of the sources in the place of a building, as wide as it, their fronts where its
    was: those of its use that are nearest to it in size, the least copied first."""
    pattern, (wide, deep) = ground.problem.pattern, state.boxes[k, 3:]
    own, told = int(state.origin[k]), pattern.told or ((),) * len(pattern.boxes)
    ratio = np.abs(np.log(pattern.boxes[:, 3:] / (wide, deep)))
    free = np.isfinite(ground.rules.shares[pattern.kind]) & (ratio[:, 0] < np.log(MOST))
    free &= (ratio[:, 1] < SIMILAR) & (pattern.kind != pattern.kind[own])
    copied = np.bincount(state.origin, minlength=len(free))
    rows = [o for o in np.flatnonzero(free).tolist() if told[o] == told[own]]
    for o in sorted(rows, key=lambda o: (copied[o], float(ratio[o].sum())))[:OTHERS]:
        form = np.array([wide / pattern.boxes[o, 3], 1.0])
        pose = _put_back(state.poses[k], float(deep), float(pattern.boxes[o, 4]))
        yield Candidate(pose, form, o)


def _put_back(pose: Floats, before: float, deep: float) -> Floats:
    """A pose for another depth in metres, the front where it was."""
    ahead = np.array([np.cos(pose[2]), np.sin(pose[2]), 0.0])
    return pose + ahead * (before - deep) / 2


def _list_beside(
    ground: SettlingGround, state: SettledState, k: int, slits: Indices
) -> list[Candidate]:
    """How a building may settle beside those that stand a slit from it: moved or widened up to a
    wall, or away from it, turned along with it or not."""
    pattern, rules, found = ground.problem.pattern, ground.rules, list[Candidate]()
    pose, form, sides = state.poses[k], state.form[k], state.boxes[k, 3:]
    origin = state.origin[k : k + 1]
    rigid = bool(np.isinf(rules.shares[pattern.kind[origin[0]]]))
    for j in slits.tolist():
        off = float((state.boxes[j, 2] - pose[2] + np.pi / 4) % (np.pi / 2) - np.pi / 4)
        for turn in (0.0, off) if 1e-3 < abs(off) < TURNED else (0.0,):
            turned = pose + np.array([0.0, 0.0, turn])
            shape = shapes_at(pattern, turned[None], origin, form[None])[0]
            line = shapely.get_coordinates(shapely.shortest_line(shape, state.shapes[j]))
            gap = float(np.hypot(*(line[1] - line[0])))
            way = (line[1] - line[0]) / max(gap, 1e-9)
            reaches = (gap - JOINT, gap - rules.passage)
            for reach in reaches if rules.touching else reaches[1:]:
                moved = turned + np.array([*(way * reach), 0.0])
                found.append(Candidate(moved, form, int(origin[0])))
                if not rigid:
                    found += _widen(found[-1]._replace(pose=turned), sides, way, reach)
    return found


def _widen(one: Candidate, sides: Floats, way: Floats, reach: float) -> Iterator[Candidate]:
    """A building whose side towards ``way`` (2,) is moved by ``reach`` metres, the other not."""
    right = np.array([np.sin(one.pose[2]), -np.cos(one.pose[2])])
    if abs(float(way @ right)) > 0.9 and sides[0] + reach > 1.0:
        times = np.array([(sides[0] + reach) / sides[0], 1.0])
        yield Candidate(
            one.pose + np.array([*(way * reach / 2), 0.0]), one.form * times, one.origin
        )
