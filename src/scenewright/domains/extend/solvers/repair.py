"""Coverage repaired: free ground filled in line with its surroundings, excess taken away."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.domains.extend.problem import Floats
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.domains.extend.solvers.neighbours import worth_of
from scenewright.ground.buildings.built import from_frames, to_frames

STEP, MOST = 3.0, 240
"""Metres between the places tried, and how many at most."""
TURNS = 16
"""Buildings of the sources tried at each place, in all."""
CLOSER = ((1.0, 1), (0.7, 1), (0.4, 0))
"""Shares of the least gaps of the sources that are kept where too little fits, and the class of
size from which any number may stand then."""
ALIGN = 5.0
"""Metres from which a building is drawn into line with the nearest."""


def repair_coverage(canvas: Canvas, rng: np.random.Generator) -> int:
    """Fill free ground; where too little fits, with more large buildings, the largest first, then
    nearer and nearer together (:data:`CLOSER`); how many buildings were added."""
    made = fill_free(canvas, rng)
    for share, least in CLOSER:
        if canvas.enough():
            break
        canvas.loosen(share, least)
        made += fill_free(canvas, rng, large_first=True)
    return made


def fill_free(canvas: Canvas, rng: np.random.Generator, large_first: bool = False) -> int:
    """Add buildings on free ground, turned as the nearest is and in line with it, while more is
    wanted; how many were added."""
    made, failed = 0, 0
    while not canvas.full() and failed < 2 - large_first:
        added = _fill_once(canvas, rng, large_first)
        made += added
        failed = 0 if added else failed + 1
    return made


def _fill_once(canvas: Canvas, rng: np.random.Generator, large_first: bool) -> int:
    pattern = canvas.problem.pattern
    places = free_places(canvas, rng)
    if not len(places):
        return 0
    tries = min(TURNS, 4 * len(pattern.boxes))
    chosen = rng.choice(len(pattern.boxes), size=tries, p=_shares(canvas))
    if large_first:
        area = -pattern.boxes[chosen, 3] * pattern.boxes[chosen, 4]
        chosen = chosen[np.argsort(area, kind="stable")]
    made, hopeless = 0, set[int]()
    for origin in chosen.tolist():
        if canvas.full():
            break
        kind = int(pattern.kind[origin])
        if kind in hopeless or not canvas.room_for(origin):
            continue
        poses = align(canvas, places, origin, rng)
        rows = np.full(len(poses), origin)
        good = np.flatnonzero(canvas.legal(poses, rows))
        if not len(good):
            hopeless.add(kind)
            continue
        worth = [worth_of(canvas, poses[k], origin) for k in good.tolist()]
        best = int(good[int(np.argmax(np.round(worth, 6)))])
        canvas.add(poses[best], origin, "filled")
        made += 1
    return made


def _shares(canvas: Canvas) -> Floats:
    """How often each building of the sources is tried."""
    weight = canvas.problem.pattern.weight
    return np.asarray(weight / weight.sum())


def free_places(canvas: Canvas, rng: np.random.Generator) -> Floats:
    """Points (n, 2) of a shaken grid on the floor that nothing stands on."""
    west, south, east, north = canvas.problem.floor.bounds
    step = max(STEP, float(np.sqrt(canvas.problem.floor.area / (4 * MOST))))
    x = np.arange(west, east, step) + rng.uniform(0, step)
    y = np.arange(south, north, step) + rng.uniform(0, step)
    grid = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    grid = grid[shapely.contains_xy(canvas.floor, grid[:, 0], grid[:, 1])]
    standing = canvas.shapes[canvas.there]
    if len(standing) and len(grid):
        near = shapely.STRtree(standing).query(
            shapely.points(grid), predicate="dwithin", distance=2.0
        )[0]
        grid = np.delete(grid, np.unique(near), axis=0)
    return grid[rng.permutation(len(grid))[:MOST]]


def align(canvas: Canvas, places: Floats, origin: int, rng: np.random.Generator) -> Floats:
    """Poses (n, 3) at places (n, 2), turned as the nearest building is and drawn into its line
    ahead or to the side where that is near."""
    there = np.flatnonzero(canvas.there)
    own = canvas.problem.pattern.boxes[origin]
    poses = np.concatenate([places, np.full((len(places), 1), own[2])], 1)
    if not len(there):
        return poses
    step = places[:, None] - canvas.boxes[None, there, :2]
    nearest = there[np.hypot(step[..., 0], step[..., 1]).argmin(1)]
    boxes = canvas.boxes[nearest]
    local = to_frames(places, boxes)
    front = (boxes[:, 4] - own[4]) / 2
    in_row = np.abs(local[:, 1] - front) < ALIGN
    in_file = ~in_row & (np.abs(local[:, 0]) < ALIGN)
    local[in_row, 1] = front[in_row]
    local[in_file, 0] = 0.0
    poses[:, :2] = from_frames(local, boxes)
    poses[:, 2] = boxes[:, 2] + rng.choice([0.0, 0.0, 0.0, np.pi], len(poses))
    return poses


def take_away(canvas: Canvas) -> int:
    """Take away what agrees least with its neighbours while too much is built; how many."""
    gone = 0
    slack = 1 + 3 * canvas.problem.settings.slack
    while canvas.problem.number is None and canvas.covered > canvas.wanted * slack:
        rows = canvas.find_added()
        over = canvas.covered - canvas.wanted
        small = [k for k in rows.tolist() if canvas.shapes[k].area <= 1.5 * over]
        if not small:
            break
        worth = [worth_of(canvas, canvas.boxes[k, :3], int(canvas.origin[k]), k) for k in small]
        canvas.remove(small[int(np.argmin(worth))])
        gone += 1
    return gone
