"""Problems for the kernel tests: a room that has everything a term can ask about."""

from __future__ import annotations

import numpy as np

from scenewright.domains.home.encodings.boxes import gene_bounds, to_boxes
from scenewright.domains.home.problem import Ground, Problem, empty_items
from scenewright.domains.home.terms.table import default_weights

OUTLINE = np.array([[0, 0], [6, 0], [6, 3.5], [4, 3.5], [4, 5.5], [0, 5.5]], float)
PATH = np.array([[0, 4.5], [5.2, 0], [6, 0], [6, 0.7], [1.2, 4.9], [0, 5.2]], float)
COLUMN = np.array([[2.0, 2.0], [2.0, 2.4], [2.4, 2.4], [2.4, 2.0]])


def ring(points):
    """Directed edges (k, 4) of a closed outline."""
    return np.hstack([points, np.roll(points, -1, axis=0)])


def room() -> Ground:
    """An L-shaped room with a column, doors, a window, a corridor, a slope and a fixed piece."""
    edges = np.concatenate([ring(OUTLINE), ring(COLUMN)])
    return Ground(
        edges=edges,
        walls=ring(OUTLINE),
        keep_free=np.array([[5.4, 0.5, 0.0, 0.9, 1.0], [0.5, 5.0, 0.0, 0.9, 0.9]]),
        use_space=np.array([[3.0, 2.8, 2.4, 0.8, 5.0]]),
        obstacles=np.array([[0.3, 1.0, 0.0, 0.8, 0.5]]),
        windows=np.array([[2.0, 5.3, -np.pi / 2, 1.6, 0.4, 0.9]]),
        doors=np.array([[6.1, 0.6, np.pi, 0.9, 0.4], [-0.1, 4.8, 0.0, 0.8, 0.4]]),
        main_wall=np.array([[6.0, 0.0, 6.0, 3.5]]),
        bounds=np.array([0.0, 0.0, 6.0, 5.5]),
        area=29.0 - 0.16,
        slopes=np.array([[0.0, 0.0, 0.0, 1.0, 1.6, 1.4]]),
        paths=ring(PATH),
        strips=np.array([[2, 5.35, -np.pi / 2, 1.6, 0.3, 1], [5.85, 2, np.pi, 2.0, 0.3, 0]]),
    )


def full_problem(printed: bool = False) -> Problem:
    """Four items that ask for everything, every term weighed by its default."""
    items = empty_items(4)._replace(
        low=np.array([[1.6, 0.8], [1.2, 0.4], [0.8, 0.5], [0.9, 0.9]]),
        high=np.array([[2.4, 1.0], [1.8, 0.5], [1.4, 0.7], [0.9, 0.9]]),
        wish=np.array([[2.0, 0.9], [np.nan, 0.4], [1.0, np.nan], [np.nan, np.nan]]),
        height=np.array([0.8, 1.8, 2.0, 0.7]),
        back_to_wall=np.array([1.0, 1.0, 0.5, 0.0]),
        main_wall=np.array([1.0, -1.0, 0.0, 0.0]),
        clear=np.array([[0.5, 0, 0, 0], [0.7, 0.2, 0, 0.2], [0.6, 0, 0, 0], [0.4] * 4], float),
        access=np.array([[1, 0, 0, 0], [1, 0, 0, 0], [1, 0, 0, 0], [1, 1, 1, 1]], float),
        inset=np.array([[0.2, 0, 0, 0], [0] * 4, [0.1, 0.1, 0, 0], [0] * 4], float),
        daylight=np.array([0.0, 0.0, 1.0, 0.5]),
        nestle=np.array([0.0, 0.0, 1.0, 0.0]),
        shades=np.array([1.0, 0.5, 1.0, 0.0]),
        symmetry=np.array([0.0, 0.0, 1.0, 0.5]),
        pairs=np.array([[0, 1], [0, 3], [2, 3]], np.int64),
        pair_targets=np.array([[2.5, np.pi, 0.0], [1.2, np.nan, np.nan], [np.nan, np.pi / 2, 1.0]]),
        pair_weights=np.array([1.0, 0.5, 2.0]),
        placed=np.array([2, 0, 2], np.int64),
        places=np.array(
            [[0, 2, 0, 0.5, 0, 0.1], [2, 3, 1.2, np.inf, 1, 0.2], [1, 3, 0, 0.2, -1, 0.1]]
        ),
        spots=np.array([[6, 1, 6, 2.5], [0, 2, 0, 2], [1, 5.5, 3, 5.5]], float),
    )
    names = ("seating", "screen", "shelf", "reading")
    return Problem(room(), items, names, default_weights(printed), printed)


def random_layouts(problem: Problem, count: int, seed: int = 0) -> np.ndarray:
    """Layouts (count, n, 5) anywhere within the bounds."""
    low, high = gene_bounds(problem)
    return to_boxes(np.random.default_rng(seed).uniform(low, high, (count, *low.shape)))


def turned_points(points, angle, shift):
    """Points (..., 2) turned about the origin, then moved."""
    cos, sin = np.cos(angle), np.sin(angle)
    return points @ np.array([[cos, sin], [-sin, cos]]) + shift


def turned_boxes(boxes, angle, shift):
    """Boxes (..., n, 5 or more) turned about the origin, then moved."""
    moved = boxes.copy()
    moved[..., :2] = turned_points(boxes[..., :2], angle, shift)
    moved[..., 2] += angle
    return moved


def turned_segments(segments, angle, shift):
    """Segments (k, 4) turned about the origin, then moved."""
    return turned_points(segments.reshape(-1, 2, 2), angle, shift).reshape(-1, 4)


def turned_problem(problem: Problem, angle: float, shift) -> Problem:
    """The same room elsewhere, turned; its span is kept, bounds being a box round it."""
    old, shift = problem.ground, np.asarray(shift, float)
    boxes = {
        name: turned_boxes(getattr(old, name), angle, shift)
        for name in ("keep_free", "use_space", "obstacles", "windows", "doors", "strips")
    }
    segments = {
        name: turned_segments(getattr(old, name), angle, shift)
        for name in ("edges", "walls", "main_wall", "paths")
    }
    items = problem.items._replace(spots=turned_segments(problem.items.spots, angle, shift))
    slopes = old.slopes.copy()
    slopes[:, :2] = turned_points(slopes[:, :2], angle, shift)
    slopes[:, 2:4] = turned_points(slopes[:, 2:4], angle, np.zeros(2))
    corners = segments["edges"].reshape(-1, 2)
    bounds = np.concatenate([corners.min(axis=0), corners.max(axis=0)])
    ground = old._replace(**boxes, **segments, bounds=bounds, slopes=slopes)
    return problem._replace(ground=ground, items=items)
