"""Where a house might stand: beside houses, along streets, anywhere; and which of that is legal.

Legal is exact: the footprint lies inside the block, overlaps no other (walls may be shared) and
keeps what is to stay free.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.house import House
from scenewright.domains.village.problem import VillageProblem
from scenewright.domains.village.settings import Relations
from scenewright.domains.village.standing import Flags, Floats, Shapes, StandingHouses, place

TOUCH = 0.005
"""Metres by which footprints may overlap unseen."""
SKEW = 0.02
"""Spread in radians of a house that stands parallel to a street."""
INSIDE = 1e-3


def propose(
    problem: VillageProblem, standing: StandingHouses, house: House, rng: np.random.Generator
) -> Floats:
    """Poses (k, 3) of a house: x, y, and the angle of its own frame."""
    settings = problem.settings.grow
    counts = rng.multinomial(settings.proposed, _shares(settings.shares, len(standing.shapes)))
    gap = problem.style.manner.gap
    return np.concatenate(
        [
            beside(standing, house, gap, settings.askew, int(counts[0]), rng),
            along_streets(problem, house, int(counts[1]), rng),
            anywhere(problem, standing, int(counts[2]), rng),
        ]
    )


def _shares(shares: tuple[float, float, float], houses: int) -> Floats:
    found = np.array(shares) * ((1.0, 1.0, 1.0) if houses else (0.0, 1.0, 1.0))
    return found / found.sum()


def beside(
    standing: StandingHouses,
    house: House,
    gap: Relations,
    askew: tuple[float, float],
    count: int,
    rng: np.random.Generator,
) -> Floats:
    """Poses beside houses that stand: a wall along a wall of one, a gap away, flush with an end of
    it or anywhere along it; what does not touch is as askew as real neighbours are. Longer walls
    are taken more often."""
    if not count:
        return np.zeros((0, 3))
    away = draw_values(gap, gap.small if house.size == 0 else gap.large, count, rng)
    start, way, length = _draw_walls(standing, count, rng)
    ring = house.outline
    step = np.roll(ring, -1, axis=0) - ring
    sides = np.hypot(step[:, 0], step[:, 1])
    own = rng.choice(len(ring), size=count, p=sides / sides.sum())
    turn = np.arctan2(way[:, 1], way[:, 0]) + np.pi - np.arctan2(step[own, 1], step[own, 0])
    ends = np.where(rng.random(count) < 0.5, sides[own], length)
    reach = rng.random(count) * (length + sides[own])
    along = np.where(rng.random(count) < 0.5, ends, reach)
    out = np.stack([way[:, 1], -way[:, 0]], 1)
    corner = start + along[:, None] * way + away[:, None] * out
    cos, sin = np.cos(turn), np.sin(turn)
    x = corner[:, 0] - cos * ring[own, 0] + sin * ring[own, 1]
    y = corner[:, 1] - sin * ring[own, 0] - cos * ring[own, 1]
    return np.stack([x, y, turn + draw_skew(askew, count, rng) * (away > 0)], 1)


def _draw_walls(
    standing: StandingHouses, count: int, rng: np.random.Generator
) -> tuple[Floats, Floats, Floats]:
    """Walls of houses, each house as likely: where they start (k, 2), where they lead as they run
    counter-clockwise (k, 2), and their length (k,)."""
    points, owner = shapely.get_coordinates(
        shapely.get_exterior_ring(shapely.orient_polygons(standing.shapes)), return_index=True
    )
    real = np.flatnonzero(owner[1:] == owner[:-1])
    step = points[real + 1] - points[real]
    length = np.hypot(step[:, 0], step[:, 1])
    around = np.bincount(owner[real], length, len(standing.shapes))
    odds = length / around[owner[real]] / len(standing.shapes)
    pick = rng.choice(len(real), size=count, p=odds / odds.sum())
    way = step[pick] / np.maximum(length[pick, None], 1e-9)
    return points[real[pick]], way, length[pick]


def draw_skew(askew: tuple[float, float], count: int, rng: np.random.Generator) -> Floats:
    """Angles (k,) in radians by which neighbours are askew: none is quite parallel, a few are by
    far."""
    low, high = np.log(askew)
    spread = np.exp(rng.uniform(low, high, count))
    return np.asarray(rng.normal(0.0, 1.0, count) * spread)


def along_streets(
    problem: VillageProblem, house: House, count: int, rng: np.random.Generator
) -> Floats:
    """Poses parallel to a street side, as far behind it as houses stand."""
    sides = problem.streets
    along = sides[:, 1] - sides[:, 0]
    length = np.hypot(along[:, 0], along[:, 1])
    pick = rng.choice(len(sides), size=count, p=length / length.sum())
    share = rng.random(count)
    way = along[pick] / length[pick, None]
    back = problem.style.manner.street
    away = draw_values(back, back.small if house.size == 0 else back.large, count, rng)
    quarter = rng.integers(4, size=count)
    deep = np.where(quarter % 2 == 0, house.extent[1], house.extent[0]) / 2
    inward = np.stack([-way[:, 1], way[:, 0]], 1) * _inward(problem)
    at = sides[pick, 0] + along[pick] * share[:, None] + inward * (away + deep)[:, None]
    turn = np.arctan2(way[:, 1], way[:, 0]) + quarter * np.pi / 2
    skew = rng.normal(0.0, SKEW, count) + rng.normal(0.0, 0.2, count) * (rng.random(count) < 0.4)
    return np.column_stack([at, turn + skew])


def _inward(problem: VillageProblem) -> float:
    """1 if the ground lies to the left of the street sides, as they run, else -1."""
    ring = shapely.get_coordinates(problem.floor.exterior)
    step = problem.streets[:, 1] - problem.streets[:, 0]
    middle = problem.streets.mean(1)
    left = middle + 0.1 * np.stack([-step[:, 1], step[:, 0]], 1) / np.hypot(*step.T)[:, None]
    inside = shapely.contains_xy(shapely.Polygon(ring), left[:, 0], left[:, 1])
    return 1.0 if inside.mean() >= 0.5 else -1.0


def anywhere(
    problem: VillageProblem, standing: StandingHouses, count: int, rng: np.random.Generator
) -> Floats:
    """Poses anywhere in the block, at the angle of the nearest house or street side, or any."""
    west, south, east, north = problem.floor.bounds
    at = rng.uniform((west, south), (east, north), (count, 2))
    sides = problem.streets
    along = sides[:, 1] - sides[:, 0]
    near = shapely.distance(shapely.points(at)[:, None], shapely.linestrings(sides)[None]).argmin(1)
    turn = np.arctan2(along[near, 1], along[near, 0])
    if len(standing.frames):
        gaps = np.hypot(*(at[:, None] - standing.frames[None, :, :2]).transpose(2, 0, 1))
        theirs = standing.frames[gaps.argmin(1), 2]
        turn = np.where(rng.random(count) < 0.6, theirs, turn)
    turn = np.where(rng.random(count) < 0.2, rng.uniform(0, np.pi / 2, count), turn)
    quarter = rng.integers(4, size=count) * np.pi / 2
    return np.column_stack(
        [at, turn + quarter + draw_skew(problem.settings.grow.askew, count, rng)]
    )


def draw_values(
    table: Relations, shares: tuple[float, ...], count: int, rng: np.random.Generator
) -> Floats:
    """Values of a relation as often as its table says; the last, open bin is left out."""
    edges, odds = np.array(table.edges[:-1]), np.array(shares[:-1])
    k = rng.choice(len(odds), size=count, p=odds / odds.sum())
    drawn = edges[k] + rng.random(count) * (edges[k + 1] - edges[k])
    return np.where(edges[k + 1] <= 0.05, 0.0, drawn)


def is_legal(
    ground: shapely.Polygon, taken: shapely.Geometry, shapes: Shapes, rings: Points
) -> Flags:
    """Which footprints (k,) lie inside the ground and overlap nothing taken; ``rings`` (k, n, 2)
    are their corners. Both geometries should be prepared."""
    inside = shapely.contains_xy(ground, rings[..., 0], rings[..., 1]).all(1)
    found = inside.copy()
    found[inside] = shapely.covers(ground, shapes[inside])
    found[found] = ~shapely.intersects(taken, shapes[found])
    return found


def shrink(shapes: Shapes) -> shapely.Geometry:
    """The houses standing, less the overlap tolerated; prepared."""
    taken = shapely.union_all(shapely.buffer(shapes, -TOUCH, join_style="mitre"))
    shapely.prepare(taken)
    return taken


def shapes_at(house: House, poses: Floats) -> tuple[Shapes, Points]:
    """The footprints (k,) of a house at poses (k, 3), and their corners (k, n, 2)."""
    rings = place(house.outline, poses)
    return np.asarray(shapely.polygons(rings)), rings
