"""How any layout of a site is made to stand, scored, and answered with.

Scores by name: every term, ``energy``, ``ratio`` of (5), and ``use``, ``shown``, ``texture``,
``height`` and ``value`` of (22) in Zhang, Yang 2023; ours are ``sun``, hours on fronts,
``seen``, the quality that walkers see, and ``even``, how far off the middle of blocks all stands.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, Ints, SiteProblem, sides_of
from scenewright.domains.site.solvers.aims import uneven_of
from scenewright.domains.site.solvers.outcome import SiteFound, SiteLayout
from scenewright.domains.site.terms.measure import (
    SitePrepared,
    SiteState,
    energy_of,
    lay,
    lay_all,
    look,
    make_site_state,
    prepare_site,
    put,
    stands,
)
from scenewright.domains.site.terms.table import QUALITY, SITE_TERMS, printed_ratio
from scenewright.domains.site.terms.value import FULL, OMEGA, make_worth, value_parts
from scenewright.engine.solve import Found
from scenewright.geometry.boxes import make_frame
from scenewright.geometry.buckets import remove
from scenewright.geometry.compiled import compiled
from scenewright.geometry.sun import sun_hours, sun_path
from scenewright.geometry.walker import RAYS, seen

LOOSE = 1e-4
"""Tolerated area of a building outside or too near, in m²: a right corner by a centimetre."""


class Measure(NamedTuple):
    """A problem made ready once, to judge many layouts."""

    p: SitePrepared
    s: SiteState

    def energies(self, population: Floats) -> Floats:
        """Energies (P,) of layouts (P, n, 5) by the repaired sum."""
        terms = np.empty((len(population), len(SITE_TERMS)))
        lay_all(self.p, self.s, population, terms)
        lost = self.p.weights[QUALITY] * len(self.p.buildings)
        energies: Floats = terms @ self.p.weights - lost
        return energies


def make_measure(problem: SiteProblem) -> Measure:
    """Ready to judge layouts of a problem."""
    return Measure(prepare_site(problem), make_site_state(problem))


@compiled
def stand_up(
    p: SitePrepared, s: SiteState, boxes: Floats, order: Ints, loose: float, present: Flags
) -> None:
    """Mark which of ``boxes`` (n, 5), taken in ``order``, stand clear of those before them."""
    for i in range(boxes.shape[0]):
        remove(s.buckets, i)
        present[i] = False
    for k in range(order.shape[0]):
        i = order[k]
        frame = make_frame(boxes[i, 0], boxes[i, 1], boxes[i, 2], boxes[i, 3], boxes[i, 4])
        if stands(p, s, i, frame, loose):
            put(p, s, i, frame)
            present[i] = True


@compiled
def own_costs(p: SitePrepared, s: SiteState, boxes: Floats, costs: Floats) -> None:
    """Write what each building costs where it stands, its pairs included; (n,)."""
    lay(p, s, boxes)
    for i in range(boxes.shape[0]):
        frame = make_frame(boxes[i, 0], boxes[i, 1], boxes[i, 2], boxes[i, 3], boxes[i, 4])
        look(p, s, i, frame, s.new)
        costs[i] = 0.0
        for k in range(s.new.shape[0]):
            costs[i] += p.weights[k] * s.new[k]


def standing(measure: Measure, boxes: Floats) -> Flags:
    """Which of boxes (n, 5) may stay: those in the blocks, at their spacing from each other; of
    two too near each other the one that costs less."""
    costs, present = np.empty(len(boxes)), np.zeros(len(boxes), np.bool_)
    own_costs(measure.p, measure.s, boxes, costs)
    order = np.argsort(costs, kind="stable")
    stand_up(measure.p, measure.s, boxes, order, LOOSE, present)
    return present


def score(problem: SiteProblem, boxes: Floats, present: Flags) -> dict[str, float]:
    """Every term of a layout by name, its energy, the paper's ratio and value, and ours.

    ``boxes`` (n, 5) x, y, heading, width, depth in metres and radians, ``present`` (n,).
    """
    measure, parts = make_measure(problem), np.empty(len(OMEGA))
    placed = np.where(present[:, None], boxes, 0.0)
    lay(measure.p, measure.s, placed)
    value_parts(measure.s, make_worth(problem), parts)
    looks = seen_of(problem, boxes[present], present)
    if problem.form == "repaired":
        parts[1] = min(looks / FULL, 1.0)
    found = {row.name: float(measure.s.sums[row.number]) for row in SITE_TERMS}
    found["energy"] = energy_of(measure.p, measure.s)
    found["ratio"] = float(printed_ratio(measure.s.sums, np.abs(measure.p.weights)))
    found.update(zip(("use", "shown", "texture", "height"), parts.tolist(), strict=True))
    found["value"] = float(parts @ np.array(OMEGA))
    found["sun"] = sun_of(problem, boxes[present], problem.buildings.sizes[present, 2])
    found["seen"] = looks
    found["even"] = uneven_of(problem, boxes[present])
    return found


def sun_of(problem: SiteProblem, boxes: Floats, heights: Floats) -> float:
    """Mean hours of sun on the fronts of buildings (k, 5) on the day of the problem; landmarks
    throw shadows too. 0 without buildings."""
    if not len(boxes):
        return 0.0
    ground, path = problem.ground, sun_path(problem.latitude, problem.day)
    marks = (ground.landmarks, ground.landmark_heights)
    return float(sun_hours(boxes, heights, path, marks)[:, 0].mean())


def seen_of(problem: SiteProblem, boxes: Floats, present: Flags) -> float:
    """Mean visual quality that walkers at the eyes of the problem see, landmarks included.

    ``boxes`` (n, 5) x, y, heading, width, depth in metres and radians, ``present`` (n,).
    """
    return float(views_of(problem, boxes, present).mean()) if len(problem.ground.eyes) else 0.0


def views_of(
    problem: SiteProblem, boxes: Floats, present: Flags, most: int = 0, rays: int = RAYS
) -> Floats:
    """Visual quality (k,) that walkers see at each eye of the problem, or about ``most`` of them
    (0: all), of buildings (m, 5) that stand and of landmarks."""
    ground, made = problem.ground, problem.buildings
    eyes = ground.eyes[:: max(len(ground.eyes) // most, 1) if most else 1]
    every = np.concatenate([boxes, np.asarray(ground.landmarks).reshape(-1, 5)])
    if not len(every):
        return np.zeros(len(eyes))
    heights = np.concatenate([made.sizes[present, 2], ground.landmark_heights])
    sides = np.concatenate(
        [
            sides_of(made.sides, made.quality)[present],
            sides_of(ground.landmark_sides, ground.landmark_quality),
        ]
    )
    return seen(eyes, every, heights, sides, best=1.0, rays=rays).points


def answer(problem: SiteProblem, boxes: Floats, evaluations: int, generations: int) -> SiteFound:
    """The answer for a layout (n, 5) of a search: what cannot stand is left out."""
    layout = stand(problem, boxes)
    scored = score(problem, layout.boxes, layout.present)
    return Found((layout._replace(score=scored, generations=generations),), evaluations)


def stand(problem: SiteProblem, boxes: Floats) -> SiteLayout:
    """A layout (n, 5) of a search, not yet scored, without what cannot stand."""
    present = standing(make_measure(problem), np.ascontiguousarray(boxes))
    placed = np.column_stack([boxes[:, :3], problem.buildings.sizes[:, :2]])
    placed[:, 2] %= 2.0 * np.pi
    return SiteLayout(placed, present, {})
