"""Real compounds laid out anew: the designer's buildings on the designer's ground, side by side.

The 91 compounds of :mod:`.site_reco` (CC BY-NC-SA 4.0: measured here, never shipped). Both layouts
are looked at by the same exact tests on the footprints as they were drawn. Ours is solved with the
least rectangles of those that nearly fill them, and with the footprints of all others.
The rules are the designer's own: setback and spacing as the nearest pair keeps them, at most the
usual 3 m and 6 m, so that nothing is asked of ours that was not possible there.
"""

from __future__ import annotations

import math
import statistics
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely
from shapely import affinity

from benchmarks.comparison import ratio
from benchmarks.real_data import data_set, skipped
from benchmarks.site_reco import STOREY, Designed, asked, compounds, find_bent, name_bent, sizes_of
from benchmarks.site_rules import measure_rules
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.footprint import read_footprint
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Site
from scenewright.domains.site.check.access import find_reached_bodies, find_unreachable
from scenewright.domains.site.check.bodies import SiteBodies, bodies_of, grounds_of
from scenewright.domains.site.check.figures import SOUTHERLY
from scenewright.domains.site.check.rules import (
    find_near_edges,
    find_outside,
    find_overlaps,
    find_too_close,
)
from scenewright.domains.site.check.sun import sample_rows, sun_hours
from scenewright.domains.site.plan import site_plan, site_plans
from scenewright.domains.site.solving import solve
from scenewright.ground.fit import fits

Row = dict[str, Any]
MODEL = "modern_residential"
SETBACK, SPACING = 3.0, 6.0
SUNNY = 2.0
"""Hours of sun that a front should have on the day of the site."""
FIGURES = (
    ("coverage", "share", "median"),
    ("least_spacing", "m", "median"),
    ("spacing", "m", "median"),
    ("south", "share", "mean"),
    ("sun", "h", "median"),
    ("sunny", "share", "mean"),
    ("overlaps", "1", "sum"),
    ("outside", "1", "sum"),
    ("near", "1", "sum"),
    ("unreached", "1", "sum"),
    ("doors", "share", "mean"),
    ("lanes", "share", "mean"),
    ("courts", "1", "sum"),
    ("parking", "share", "mean"),
    ("valid", "share", "mean"),
    ("left_out", "1", "sum"),
    ("unplaceable", "1", "sum"),
)
"""What is told of a compound, its unit, and how all compounds are put together."""
TOGETHER: dict[str, Callable[[Sequence[float]], float]] = {
    "median": statistics.median,
    "mean": statistics.fmean,
    "sum": sum,
}


class Pair(NamedTuple):
    """A compound as designed and as laid out anew, each measured; ours as a solution too."""

    site: Site
    designed: Designed
    theirs: Row
    ours: Row
    solution: Solution


def file() -> Path:
    """Where the compounds are."""
    return data_set("site_reco_sample/reco_sample.json")


def pairs(most: int | None = None, seed: int = 0, **more: Any) -> list[Pair]:
    """Every compound (the first ``most``) laid out anew; ``more`` are further fields of sites."""
    return [compare(site, designed, seed) for site, designed in compounds(file(), **more)[:most]]


def compare(site: Site, designed: Designed, seed: int = 0) -> Pair:
    """One compound laid out anew by its designer's own distances."""
    ruled = site.model_copy(update=own_rules(site, designed))
    wishes = asked(ruled, designed, MODEL)
    brief = Brief.model_validate({"domain": "site", "name": site.name, "sites": [wishes]})
    begun = time.perf_counter(), time.process_time()
    solution = solve(brief, seed=seed)
    took = {"seconds": time.perf_counter() - begun[0], "cpu": time.process_time() - begun[1]}
    placed = [p for p in solution.pieces if p.category == "building"]
    given = pieces_of(wishes, designed)
    theirs = measured(wishes, given, designed.footprints) | measure_rules(wishes, given)
    ours = measured(wishes, placed, moved_footprints(designed, placed)) | took
    ours |= measure_rules(wishes, placed)
    ours["left_out"] = len(designed.boxes) - len(placed)
    ours["unplaceable"] = unplaceable(wishes)
    none = {"left_out": 0, "unplaceable": 0}
    return Pair(wishes, designed, theirs | none, ours, solution)


def compound_records(most: int | None = None) -> list[Row]:
    """The designer's layouts and ours over all compounds, figure by figure; a word without."""
    try:
        file()
    except InputError as fault:
        return [skipped("compounds", fault)]
    found = pairs(most)
    built = sum(len(pair.designed.boxes) for pair in found)
    case = f"{len(found)} compounds, {built} buildings"
    rows = [_record(case, found, *figure) for figure in FIGURES]
    whole = [pair for pair in found if not pair.ours["left_out"]]
    if whole:
        part = f"{len(whole)} of them in which ours places all"
        rows += [_record(part, whole, *figure) for figure in FIGURES[:6]]
    seconds = {
        "case": case,
        "metric": "processor seconds of all",
        "unit": "s",
        "ours": round(sum(pair.ours["cpu"] for pair in found), 3),
        "baseline": None,
        "baseline_name": "",
        "ratio": None,
        "runs": len(found),
    }
    return [*rows, seconds]


def _record(case: str, found: list[Pair], name: str, unit: str, how: str) -> Row:
    """One figure of all compounds; those with a single building have no spacing."""
    both = [
        (pair.ours[name], pair.theirs[name])
        for pair in found
        if not math.isnan(pair.ours[name]) and not math.isnan(pair.theirs[name])
    ]
    ours, theirs = (TOGETHER[how](values) for values in zip(*both, strict=True))
    return {
        "case": case,
        "metric": f"{name.replace('_', ' ')}, {how}",
        "unit": unit,
        "ours": round(ours, 4),
        "baseline": round(theirs, 4),
        "baseline_name": "designer",
        "ratio": ratio(ours, theirs, unit),
        "runs": len(both),
    }


def unplaceable(site: Site) -> int:
    """How many of the boxes asked for stand nowhere on the ground even alone."""
    plan = site_plan(site)
    return sum(row.count for row in site.buildings if row.size and not fits(plan, *row.size[:2]))


def own_rules(site: Site, designed: Designed) -> dict[str, float]:
    """The setback and spacing that the designer's layout keeps, at most the usual ones."""
    shapes = np.array(designed.footprints, object)
    border = shapely.Polygon(site.outline).exterior
    setback = float(shapely.distance(shapes, border).min(initial=SETBACK))
    gap = float(gaps(shapes).min(initial=SPACING))
    return {"setback": math.floor(setback * 100) / 100, "spacing": math.floor(gap * 100) / 100}


def pieces_of(site: Site, designed: Designed) -> list[Piece]:
    """The designer's buildings as boxes, those that are no rectangles with their footprints."""
    bent = find_bent(designed)
    return [
        Piece(
            f"b{k}",
            "building",
            MODEL,
            site.id,
            Pose(x, y, 0.0, heading),
            Size(w, d, height),
            footprint=read_footprint(bent[k], w, d) if k in bent else (),
        )
        for k, ((x, y, heading, w, d), height) in enumerate(
            zip(designed.boxes.tolist(), designed.heights.tolist(), strict=True)
        )
    ]


def moved_footprints(designed: Designed, placed: list[Piece]) -> tuple[shapely.Geometry, ...]:
    """The designer's footprints where ours stand: each moved with the box about it."""
    free: dict[tuple[float, float, int], list[int]] = defaultdict(list)
    named = {name_bent(number): number for number in find_bent(designed)}
    for number, size in enumerate(sizes_of(designed)):
        if name_bent(number) not in named:
            free[size].append(number)
    found = []
    for piece in placed:
        floors = round(piece.size.height / STOREY)
        size = round(piece.size.width, 1), round(piece.size.depth, 1), floors
        number = named[piece.function] if piece.function in named else free[size].pop()
        x, y, heading = designed.boxes[number, :3]
        shape = affinity.rotate(
            designed.footprints[number], piece.pose.heading - heading, (x, y), use_radians=True
        )
        found.append(affinity.translate(shape, piece.pose.x - x, piece.pose.y - y))
    return tuple(found)


def gaps(shapes: Any) -> Any:
    """The distance of each footprint to the nearest other, (n,); empty with fewer than two."""
    if len(shapes) < 2:
        return np.zeros(0)
    tree = shapely.STRtree(shapes)
    (_, _), found = tree.query_nearest(
        shapes, exclusive=True, all_matches=False, return_distance=True
    )
    return found


def measured(site: Site, pieces: list[Piece], footprints: tuple[shapely.Geometry, ...]) -> Row:
    """What the referee's tests say of some buildings with footprints of any shape."""
    ground = grounds_of([site], site_plans([site]))[0]
    bodies = bodies_of(ground, pieces)[0]
    shapes = np.empty(len(footprints), object)
    shapes[:] = footprints
    bodies = bodies._replace(footprints=shapes)
    got = find_reached_bodies(ground, bodies)
    tests = (find_overlaps, find_outside, find_near_edges, find_too_close)
    found = [finding for test in tests for finding in test(ground, bodies)]
    kinds = Counter(f.kind for f in [*found, *find_unreachable(ground, bodies, got)])
    return figures(site, bodies, ground.floor) | {
        "overlaps": kinds["collision"],
        "outside": kinds["out_of_bounds"],
        "near": kinds["setback"] + kinds["spacing"],
        "unreached": kinds["unreachable_building"],
        "valid": float(not kinds),
    }


def figures(site: Site, bodies: SiteBodies, floor: Any) -> Row:
    """Coverage, spacing, share of fronts within 30 degrees of south, hours of winter sun."""
    covered = shapely.union_all(bodies.footprints).intersection(floor).area / floor.area
    apart = gaps(bodies.footprints)
    off = np.abs(np.angle(np.exp(1j * (bodies.heading - site.facing))))
    rows = sample_rows(len(bodies.ids))
    hours = sun_hours(bodies, site.latitude, site.day, rows) if len(rows) else np.zeros(0)
    return {
        "buildings": len(bodies.ids),
        "coverage": float(covered),
        "least_spacing": float(apart.min()) if len(apart) else math.nan,
        "spacing": float(np.median(apart)) if len(apart) else math.nan,
        "south": float((off <= SOUTHERLY + 1e-9).mean()) if len(off) else 1.0,
        "sun": float(hours.mean()) if len(hours) else 0.0,
        "sunny": float((hours >= SUNNY - 1e-6).mean()) if len(hours) else 1.0,
    }
