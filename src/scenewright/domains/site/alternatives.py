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
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Site
from scenewright.domains.site.plan import plan_sites
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.problem import Floats
from scenewright.domains.site.settings import SiteVarietySettings
from scenewright.domains.site.solving import solve
from scenewright.domains.site.variants import Variant
from scenewright.engine.diversity import choose_diverse
from scenewright.engine.rows import preset_named
from scenewright.ground.plan import SitePlan

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

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
    rule = preset_named(PRESETS, options.get("preset", "default")).settings.variety
    variants = list_variants(brief.part.sites, rule.tried * count + rule.spare)
    found: list[Solution] = []
    for k, variant in enumerate(variants):
        if cancel is not None and cancel() and found:
            break
        found.append(
            solve(brief, plan=made, cancel=cancel, seed=seed + k, variant=variant, **options)
        )
        if progress:
            progress((k + 1) / len(variants), f"plan {k + 1} of {len(variants)}")
    return tuple(sorted(choose(found, made, count, rule), key=_rank))


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


def choose(
    found: list[Solution],
    plan: Plan,
    count: int,
    rule: SiteVarietySettings = PRESETS["default"].settings.variety,
) -> list[Solution]:
    """The best, then those that add most."""
    left = sorted(found, key=_rank)
    looks = [_look_at(solution, plan) for solution in left]
    energies = np.array([_rank(solution)[1] for solution in left])
    worth = -(energies - energies.min()) / max(float(np.ptp(energies)), 1e-9) if left else energies
    worth = rule.good * worth - rule.lost * np.array([_rank(solution)[0] for solution in left])
    taken = choose_diverse(
        worth, lambda k, t: _differ(looks[k], looks[t]), count, rule.different, first=0
    )
    return [left[k] for k in taken]


class SiteLook(NamedTuple):
    """What layouts of a site are compared by: the ground built on, shares of it by the eighth of
    the circle fronts look to (8,), the middle (2,) of the largest open circle, and the site's
    diagonal in metres."""

    built: shapely.Geometry
    headings: Floats
    open: Floats
    span: float


def compare(one: Solution, other: Solution, plan: Plan | None = None) -> float:
    """How much two layouts differ, 0 to 1: the mean of the share of built ground that is not built
    on by both, of how far headings differ, and of how far apart their largest open circles lie, in
    halves of the site's diagonal (at most 1). Of several sites the mean."""
    made = plan or plan_sites(one.brief)
    return _differ(_look_at(one, made), _look_at(other, made))


def _look_at(solution: Solution, plan: Plan) -> list[SiteLook]:
    """The figures layouts are compared by, site by site."""
    return [
        SiteLook(
            _built(solution, site),
            _headings(solution, site),
            find_open_circle(solution, site),
            float(np.hypot(*np.ptp(site.outline, axis=0))),
        )
        for site in plan.detail
    ]


def _differ(one: list[SiteLook], other: list[SiteLook]) -> float:
    pairs = zip(one, other, strict=True)
    return float(np.mean([_differ_on_site(a, b) for a, b in pairs])) if one else 0.0


def _differ_on_site(a: SiteLook, b: SiteLook) -> float:
    union = shapely.union(a.built, b.built).area
    shared = shapely.intersection(a.built, b.built).area
    moved = 1.0 - shared / union if union > 0.0 else 0.0
    apart = np.hypot(*(a.open - b.open)) / (0.5 * a.span)
    turned = 0.5 * float(np.abs(a.headings - b.headings).sum())
    return (moved + turned + min(float(apart), 1.0)) / 3.0


def _built(solution: Solution, site: SitePlan) -> shapely.Geometry:
    here = [p for p in solution.pieces if p.space == site.id and p.category == "building"]
    return shapely.union_all(polygons_of([p for p in here if p.function != "landmark"]))


def _headings(solution: Solution, site: SitePlan) -> Floats:
    """Share of built ground by eighths of the circle that fronts look to."""
    shares = np.zeros(8)
    for piece in solution.pieces:
        if piece.space == site.id and piece.category == "building" and piece.function != "landmark":
            eighth = round(piece.pose.heading / (math.pi / 4)) % 8
            shares[eighth] += piece.size.width * piece.size.depth
    return shares / max(float(shares.sum()), 1e-9)


def find_open_circle(solution: Solution, site: SitePlan) -> Floats:
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
