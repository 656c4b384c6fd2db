"""Several layouts of one site that differ: by planar form, by axis, by where the open ground lies.

Candidates are solved with another form, with fronts turned off the preferred heading, or with the
buildings drawn to one side of the site. The best is taken first, then again and again the one that
adds most, judged by what is left out, by energy and by how much it differs from all taken (maximal
marginal relevance, Carbonell and Goldstein 1998).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import cycle, islice
from typing import Any

import numpy as np
import shapely

from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Site
from scenewright.domains.site.plan import plan_sites
from scenewright.domains.site.solving import solve
from scenewright.domains.site.variants import Variant
from scenewright.ground.plan import SitePlan

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

TRIED = 2
"""Candidates for every plan asked for, and two more."""
DIFFERENT, LOST = 0.6, 0.05
"""Weight of differing against being good, and what a building left out costs."""
FORMS = ("peripheral", "parallel", "half-closed", "staggered", "mixed", "spliced", "point")
TURNS = (0.0, 0.3, -0.3)
SIDES = (None, math.pi / 2, -math.pi / 2, 0.0, math.pi)
NAMES = ("east", "north-east", "north", "north-west", "west", "south-west", "south", "south-east")


def alternatives(
    brief: Brief,
    count: int,
    *,
    plan: Plan | None = None,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    **options: Any,
) -> tuple[Solution, ...]:
    """``count`` layouts that differ, best first; ``options`` are those of
    :func:`scenewright.domains.site.solving.solve`."""
    made = plan or plan_sites(brief)
    variants = list_variants(brief.part.sites, TRIED * count + 2)
    found: list[Solution] = []
    for k, variant in enumerate(variants):
        if cancel is not None and cancel() and found:
            break
        found.append(
            solve(brief, plan=made, cancel=cancel, seed=seed + k, variant=variant, **options)
        )
        if progress:
            progress((k + 1) / len(variants), f"plan {k + 1} of {len(variants)}")
    return tuple(sorted(choose(found, made, count), key=_rank))


def list_variants(sites: Sequence[Site], count: int) -> list[Variant]:
    """The first as asked for, then other forms, axes and sides; forms only where the brief leaves
    them open.

    >>> [v.form for v in list_variants([], 3)]
    ['', 'peripheral', 'parallel']
    """
    allowed = [
        form
        for form in FORMS
        if all(
            not site.form and all(not row.forms or form in row.forms for row in site.buildings)
            for site in sites
        )
    ] or [""]
    forms, turns = islice(cycle(allowed), count - 1), islice(cycle(TURNS), count - 1)
    sides = islice(cycle(SIDES[1:] + SIDES[:1]), count - 1)
    return [Variant(), *(Variant(*row) for row in zip(forms, turns, sides, strict=True))]


def choose(found: list[Solution], plan: Plan, count: int) -> list[Solution]:
    """The best, then those that add most."""
    left = sorted(found, key=_rank)
    energies = np.array([_rank(solution)[1] for solution in left])
    worth = -(energies - energies.min()) / max(float(np.ptp(energies)), 1e-9)
    worth = 0.3 * worth - LOST * np.array([_rank(solution)[0] for solution in left])
    taken = [0] if left else []
    while len(taken) < min(count, len(left)):
        scores = [
            -np.inf
            if k in taken
            else worth[k] + DIFFERENT * min(compare(left[k], left[t], plan) for t in taken)
            for k in range(len(left))
        ]
        taken.append(int(np.argmax(scores)))
    return [left[k] for k in taken]


def compare(one: Solution, other: Solution, plan: Plan | None = None) -> float:
    """How much two layouts differ, 0 to 1: the mean of the share of built ground that is not built
    on by both, of how far headings differ, and of how far apart their largest open circles lie, in
    halves of the site's diagonal (at most 1). Of several sites the mean."""
    made = (plan or plan_sites(one.brief)).detail
    return float(np.mean([_compare_site(one, other, site) for site in made])) if made else 0.0


def _compare_site(one: Solution, other: Solution, site: SitePlan) -> float:
    a, b = _built(one, site), _built(other, site)
    union = shapely.union(a, b).area
    moved = 1.0 - shapely.intersection(a, b).area / union if union > 0.0 else 0.0
    span = float(np.hypot(*np.ptp(site.outline, axis=0)))
    apart = np.hypot(*(find_open_circle(one, site) - find_open_circle(other, site))) / (0.5 * span)
    turned = 0.5 * float(np.abs(_headings(one, site) - _headings(other, site)).sum())
    return (moved + turned + min(float(apart), 1.0)) / 3.0


def _built(solution: Solution, site: SitePlan) -> shapely.Geometry:
    here = [p for p in solution.pieces if p.space == site.id and p.category == "building"]
    return shapely.union_all(polygons_of([p for p in here if p.function != "landmark"]))


def _headings(solution: Solution, site: SitePlan) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Share of built ground by eighths of the circle that fronts look to."""
    shares = np.zeros(8)
    for piece in solution.pieces:
        if piece.space == site.id and piece.category == "building" and piece.function != "landmark":
            eighth = round(piece.pose.heading / (math.pi / 4)) % 8
            shares[eighth] += piece.size.width * piece.size.depth
    return shares / max(float(shares.sum()), 1e-9)


def find_open_circle(solution: Solution, site: SitePlan) -> np.ndarray[Any, np.dtype[np.float64]]:
    """The middle (2,) of the largest circle without buildings or ways."""
    ways = [shapely.Polygon(a.outline, a.holes) for way in site.roads for a in way.areas]
    marks = [shapely.Polygon(row.footprint) for row in site.landmarks]
    floor = shapely.Polygon(site.outline, site.holes)
    free = shapely.difference(floor, shapely.union_all([_built(solution, site), *ways, *marks]))
    parts = [p for p in shapely.get_parts(free) if p.geom_type == "Polygon" and p.area > 1.0]
    circles = [shapely.maximum_inscribed_circle(part, tolerance=0.5) for part in parts]
    if not circles:
        return np.asarray(site.outline.mean(0))
    best = max(circles, key=lambda line: float(line.length))
    return np.asarray(shapely.get_coordinates(best)[0])


def describe(solution: Solution, plan: Plan | None = None) -> str:
    """Where fronts look and where the largest open ground lies: ``fronts south 80 %, open in the
    north-west``."""
    words = []
    for site in (plan or plan_sites(solution.brief)).detail:
        shares = _headings(solution, site)
        main, off = int(np.argmax(shares)), find_open_circle(solution, site)
        x, y = off - shapely.get_coordinates(shapely.Polygon(site.outline).centroid)[0]
        side = NAMES[round(math.atan2(y, x) / (math.pi / 4)) % 8]
        words.append(f"fronts {NAMES[main]} {shares[main]:.0%}, open in the {side}")
    return "; ".join(words)


def _rank(solution: Solution) -> tuple[int, float]:
    return len(solution.left_out), sum(solution.energies.values())
