"""Growing from neighbour to neighbour: where a building of the sources has one, its copy gets one.

Every building that stands is like some of the sources; each neighbour of these proposes a copy of
itself at the same place in the frame of the one that stands. The proposal that agrees best with
all that stands about it is built first, and proposes in turn. So rows go on at their pitch,
courts close and fronts stay in line (texture synthesis, Efros and Leung 1999; of discrete
elements, Ma, Wei and Tong 2011).
"""

from __future__ import annotations

import heapq

import numpy as np

from scenewright.domains.extend.problem import Floats, Indices
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.ground.buildings.built import from_frames, to_frames

Proposal = tuple[float, int, int, tuple[float, float, float]]
"""Its worth (negative), a ticket, the building of the sources, and the pose."""
SAME = 0.2
"""Metres within which two proposals of one building are one."""
OFTEN = 5
"""Proposals looked at between two words on how far it is."""
LEAST_WORTH = -0.2
"""Least worth of a proposal that is built."""


def grow_neighbours(canvas: Canvas, rng: np.random.Generator) -> int:
    """Add what neighbours propose until enough is built or nothing more fits; how many were
    added."""
    heap: list[Proposal] = []
    seen: set[tuple[int, int, int]] = set()
    ticket = 0
    for number in np.flatnonzero(canvas.there & (canvas.origin >= 0)).tolist():
        ticket = _propose(canvas, number, rng, heap, ticket, seen)
    made = 0
    popped = 0
    while heap and not canvas.full():
        worth, _, origin, at = heapq.heappop(heap)
        popped += 1
        if popped % OFTEN == 0:
            canvas.tell()
        pose = np.array(at)
        if not canvas.room_for(origin):
            continue
        if not canvas.legal(pose[None], np.array([origin]))[0]:
            continue
        now = -worth_of(canvas, pose, origin)
        if heap and now > max(worth, heap[0][0]) + 0.25:
            ticket += 1
            heapq.heappush(heap, (now, ticket, origin, at))
            continue
        if -now < LEAST_WORTH:
            continue
        number = canvas.add(pose, origin, "neighbour")
        made += 1
        ticket = _propose(canvas, number, rng, heap, ticket, seen)
    return made


def _propose(
    canvas: Canvas,
    number: int,
    rng: np.random.Generator,
    heap: list[Proposal],
    ticket: int,
    seen: set[tuple[int, int, int]],
) -> int:
    """Push what the neighbours of buildings like ``number`` propose and nobody before them (in
    ``seen``); the next ticket."""
    poses, origins = proposals_of(canvas, number)
    places = np.round(poses[:, :2] / SAME).astype(int)
    keys = list(zip(origins.tolist(), *places.T.tolist(), strict=True))
    fresh = [k for k, key in enumerate(keys) if key not in seen]
    seen.update(keys)
    poses, origins = poses[fresh], origins[fresh]
    if not len(poses):
        return ticket
    good = np.flatnonzero(canvas.legal(poses, origins))
    noise = rng.normal(0.0, canvas.problem.settings.noise, len(poses))
    for k in good.tolist():
        worth = worth_of(canvas, poses[k], int(origins[k])) + noise[k]
        ticket += 1
        x, y, heading = poses[k].tolist()
        heapq.heappush(heap, (-worth, ticket, int(origins[k]), (x, y, heading)))
    return ticket


def proposals_of(canvas: Canvas, number: int) -> tuple[Floats, Indices]:
    """Poses (m, 3) and origins (m,) that the neighbours of buildings like one propose."""
    pattern = canvas.problem.pattern
    alike = pattern.alike[canvas.origin[number]]
    near = pattern.near[alike]
    known = near >= 0
    relative = pattern.relative[alike][known]
    box = canvas.boxes[number]
    poses = np.empty((len(relative), 3))
    poses[:, :2] = from_frames(relative[:, :2], box[None])
    poses[:, 2] = box[2] + relative[:, 2]
    return poses, near[known]


def worth_of(canvas: Canvas, pose: Floats, origin: int, skip: int = -1) -> float:
    """How well a copy at a pose agrees with its surroundings: neighbours where the original
    has one count up to 1 each, those where it has none cost ``missing``."""
    pattern, settings = canvas.problem.pattern, canvas.problem.settings
    step = canvas.boxes[:, :2] - pose[:2]
    close = (np.hypot(step[:, 0], step[:, 1]) < pattern.reach) & canvas.there
    if skip >= 0:
        close[skip] = False
    if not close.any():
        return 0.0
    box = np.array([*pose, 1.0, 1.0])
    local = to_frames(canvas.boxes[close, :2], box[None])
    known = pattern.near[origin] >= 0
    expected = pattern.relative[origin][known][:, :2]
    if not len(expected):
        return 0.0
    gap = local[:, None] - expected[None]
    least = np.hypot(gap[..., 0], gap[..., 1]).min(1)
    match = np.exp(-((least / settings.spread) ** 2))
    return float(match.sum() - settings.missing * (least > 3 * settings.spread).sum())
