"""How fast the kernels of sites are: steps and whole evaluations against shapely, and saliency.

A step of annealing looks only at the building that moved and its neighbours, here as with shapely
(:mod:`.shapely_site`, neighbours from a tree); a whole layout is all of it. Saliency of 100,000
triangles is held against its definition written down with a k-d tree and one loop over vertices.
All in one thread, warm.
"""

from __future__ import annotations

import statistics
import time
from functools import partial
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from benchmarks.shapely_home import BASELINE, rate, record
from benchmarks.shapely_site import shapely_site, site_terms
from benchmarks.site_instances import example_site
from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.solvers.anneal import run_site_chain
from scenewright.domains.site.solvers.random_search import drop_buildings, lines_of
from scenewright.domains.site.terms.measure import (
    energy_of,
    evaluate,
    lay,
    lay_all,
    make_site_state,
    prepare_site,
)
from scenewright.engine.draws import streams
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.saliency import UNIT, saliency

Row = dict[str, Any]
SIZES = (15, 120)
ROWS = 224
"""A ball of so many rows and columns of faces has about 100,000 triangles."""
SECONDS = 1.0
"""What saliency of 100,000 triangles may take."""


def speed_records(runs: int) -> list[Row]:
    """Steps, evaluations and saliency."""
    found = [dict(kind(size, runs)) for size in SIZES for kind in (bench_steps, bench_evaluations)]
    return found + bench_saliency(runs)


def start_of(problem: SiteProblem) -> Floats:
    """Boxes (n, 5) dropped at random where there is room."""
    p, s, boxes = (
        prepare_site(problem),
        make_site_state(problem),
        np.zeros((len(problem.names), 5)),
    )
    order = np.arange(len(boxes), dtype=np.int64)
    tries, stream = problem.settings.random.tries, streams(0, 1)[0]
    drop_buildings(p, s, order, tries, lines_of(problem), stream, boxes)
    return boxes


def bench_steps(size: int, runs: int, steps: int = 50_000) -> Row:
    """Annealing steps a second, one chain."""
    problem = example_site(size)
    p, s, start = prepare_site(problem), make_site_state(problem), start_of(problem)
    lay(p, s, start)
    best, lines, stream = s.frames.copy(), lines_of(problem), streams(0, 1)[0]
    tally = np.full(2, energy_of(p, s))
    schedule = np.array([1.0, 0.1, 0.0, 1.0, 0.0, *problem.settings.chain.drawn])

    def ours() -> None:
        run_site_chain(p, s, lines, schedule, steps, stream, best, tally)

    ours()
    slow, moved = shapely_site(problem, start), start + np.array([1.0, 1.0, 0.1, 0.0, 0.0])
    numbers = np.flatnonzero(start[:, 3] > 0.0).tolist()

    def theirs() -> None:
        for k in numbers:
            slow.change(k, start[k], moved[k])

    return dict(
        record(
            f"site of {size} buildings",
            "annealing steps, one thread",
            "1/s",
            [rate(ours, steps, 1) for _ in range(runs)],
            [rate(theirs, len(numbers), 1) for _ in range(runs)],
            BASELINE,
        )
    )


def bench_evaluations(size: int, runs: int) -> Row:
    """Whole layouts a second, in populations of 40."""
    problem = example_site(size)
    p, s, start = prepare_site(problem), make_site_state(problem), start_of(problem)
    population, terms = np.repeat(start[None], 40, 0), np.empty((40, 6))
    assert np.allclose(evaluate(problem, population[:1])[0], site_terms(problem, start), atol=1e-6)
    ours = partial(lay_all, p, s, population, terms)
    theirs = partial(site_terms, problem, start)
    return dict(
        record(
            f"site of {size} buildings",
            "whole layouts, one thread",
            "1/s",
            [rate(ours, 40, 20) for _ in range(runs)],
            [rate(theirs, 1, 3) for _ in range(runs)],
            BASELINE,
        )
    )


def bench_saliency(runs: int, rows: int = ROWS) -> list[Row]:
    """Seconds of the saliency of a mesh, of the wall and of the processor, and vertices a second
    against the plain way."""
    mesh = bumpy_ball(rows)
    saliency(mesh)
    walls, used = [], []
    for _ in range(runs):
        begun, spent = time.perf_counter(), time.process_time()
        saliency(mesh)
        walls.append(time.perf_counter() - begun)
        used.append(time.process_time() - spent)
    case, number = f"{len(mesh.faces)} triangles", len(mesh.vertices)
    plain = [plain_rate(mesh) for _ in range(min(runs, 3))]
    found = [
        {
            "case": case,
            "metric": f"saliency, {name}",
            "unit": "s",
            "ours": round(statistics.median(taken), 4),
            "baseline": SECONDS,
            "baseline_name": "aim",
            "ratio": round(SECONDS / statistics.median(taken), 4),
            "runs": runs,
        }
        for name, taken in (("wall", walls), ("processor", used))
    ]
    fast = [number / seconds for seconds in used]
    return [
        *found,
        dict(record(case, "saliency, vertices", "1/s", fast, plain, "k-d tree and a loop")),
    ]


def bumpy_ball(rows: int) -> Mesh:
    """A ball with bumps, of ``2 · rows · rows`` triangles."""
    turn = np.linspace(0.0, 2.0 * np.pi, rows, endpoint=False)
    tilt = np.linspace(0.01, np.pi - 0.01, rows + 1)
    t, u = np.meshgrid(tilt, turn, indexing="ij")
    radius = 1.0 + 0.08 * np.sin(7.0 * t) * np.cos(9.0 * u)
    points = np.stack([np.sin(t) * np.cos(u), np.sin(t) * np.sin(u), np.cos(t)], -1)
    number = np.arange((rows + 1) * rows).reshape(rows + 1, rows)
    a, b = number[:-1], np.roll(number[:-1], -1, axis=1)
    c, d = np.roll(number[1:], -1, axis=1), number[1:]
    faces = np.concatenate([np.stack([a, d, c], -1), np.stack([a, c, b], -1)]).reshape(-1, 3)
    return Mesh((radius[..., None] * points).reshape(-1, 3), faces)


def plain_rate(mesh: Mesh, number: int = 400) -> float:
    """Vertices a second of |G(2 sigma) - G(sigma)| at five scales, some curvature being given:
    the nearest vertices from a k-d tree, weighted one vertex at a time."""
    points, rng = mesh.vertices, np.random.default_rng(0)
    size = 2.0 * float(np.linalg.norm(points - points.mean(0), axis=1).max())
    bends, scales = rng.random(len(points)), UNIT * size * np.arange(2, 7)
    begun, tree, levels = time.process_time(), cKDTree(points), []
    for k in rng.integers(len(points), size=number):
        near = np.array(tree.query_ball_point(points[k], 4.0 * scales[-1]))
        squares = ((points[near] - points[k]) ** 2).sum(1)
        means = []
        for sigma in (*scales, *(2.0 * scales)):
            weights = np.where(squares <= 4.0 * sigma**2, np.exp(-squares / (2.0 * sigma**2)), 0.0)
            means.append(weights @ bends[near] / weights.sum())
        levels.append(np.abs(np.subtract(means[:5], means[5:])))
    return number / (time.process_time() - begun)
