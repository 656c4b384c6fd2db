"""How many houses a block is to have, and which: as real blocks like it have them."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.domains.village.house import class_of_area
from scenewright.domains.village.learned.mix import draw_sizes, fetch_houses
from scenewright.domains.village.problem import VillageProblem
from scenewright.domains.village.standing import Floats, Indices, stand
from scenewright.domains.village.uses import meet_uses

MOST = 500
"""Most houses of a block."""
TYPICAL = (25.0, 75.0, 150.0)
"""Square metres of a house of each class, where no real one is known."""
DRAWN = 12
"""Real blocks of which the most usual one is taken."""
JITTER = 0.12
"""How far chance may change the order of houses by area."""


def choose_houses(problem: VillageProblem, rng: np.random.Generator) -> list[int]:
    """The numbers of the houses to place besides those that stand, the largest first."""
    if problem.asked is None and problem.coverage is not None:
        found = _choose_area(problem, rng)
    else:
        found = _choose_count(problem, problem.asked, rng)
    if problem.uses:
        found = meet_uses(problem.houses, found, dict(problem.uses), rng)
    order = np.array([problem.houses[k].area for k in found])
    order = order * np.exp(rng.normal(0.0, JITTER, len(found)))
    return [found[k] for k in np.argsort(-order, kind="stable")]


def _choose_area(problem: VillageProblem, rng: np.random.Generator) -> list[int]:
    """Houses that cover, with those that stand, the share asked for."""
    left = (problem.coverage or 0.0) * problem.floor.area
    left -= float(shapely.area(problem.fixed.shapes).sum())
    found: list[int] = []
    while left > 0 and len(found) < MOST:
        for number in _choose_count(problem._replace(fixed=stand([], [])), None, rng):
            if left <= 0 or len(found) == MOST:
                break
            found.append(number)
            left -= problem.houses[number].area
    return found


def _choose_count(
    problem: VillageProblem, count: int | None, rng: np.random.Generator
) -> list[int]:
    """So many houses (None: as many as such blocks have) less those that stand: of the sizes of a
    real block like it, the classes asked for kept."""
    mix, standing = problem.style.mix, len(problem.fixed.shapes)
    sizes = _draw_typical(problem, count, rng)
    sizes = sizes[: max(min(len(sizes), MOST) - standing, 0)]
    library = np.array([(h.area, h.extent[0] / h.extent[1]) for h in problem.houses])
    share = np.array([house.share for house in problem.houses])
    if problem.sizes is None:
        return fetch_houses(sizes, library, share, rng)
    held = np.array([house.size for house in problem.houses])
    found: list[int] = []
    for size, number in enumerate(_draw_classes(problem.sizes, held, len(sizes), rng)):
        if number:
            those = np.flatnonzero(held == size)
            wanted = _sizes_of_class(sizes, mix.houses, size, number, rng)
            found += those[fetch_houses(wanted, library[those], share[those], rng)].tolist()
    return found


def _draw_typical(problem: VillageProblem, count: int | None, rng: np.random.Generator) -> Floats:
    """Sizes of a real block like one; where a village is composed, of several drawn that whose
    houses cover most nearly what all do on average: places are like their region, blocks vary."""
    drawn = [
        draw_sizes(problem.style.mix, problem.floor.area, problem.street_share, count, rng)
        for _ in range(DRAWN if problem.settings.composed else 1)
    ]
    built = np.array([rows[:, 0].sum() for rows in drawn])
    return drawn[int(np.argmin(np.abs(built - built.mean())))]


def _draw_classes(
    asked: tuple[float, float, float], held: Indices, count: int, rng: np.random.Generator
) -> list[int]:
    """How many houses of each class; a class that the library has not goes to the others."""
    there = np.bincount(held, minlength=3) > 0
    odds = np.where(there, asked, 0.0)
    odds = odds if odds.sum() else there.astype(float)
    return [int(v) for v in rng.multinomial(count, odds / odds.sum())]


def _sizes_of_class(
    own: Floats, every: Floats, size: int, count: int, rng: np.random.Generator
) -> Floats:
    """So many sizes of a class: of those of the block itself if it has any, else of all blocks."""
    for rows in (own, every):
        those = rows[[class_of_area(area) == size for area in rows[:, 0]]]
        if len(those):
            return np.asarray(those[rng.integers(len(those), size=count)])
    return np.tile((TYPICAL[size], 1.3), (count, 1))
