"""The referee on sites: findings and figures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import Flags, Floats
from scenewright.core.report import Finding
from scenewright.core.scene import Piece, Size
from scenewright.domains.site.brief import Site, rows_of
from scenewright.domains.site.check.access import find_reached_bodies, find_unreachable
from scenewright.domains.site.check.areas import find_missing_areas, measure_areas
from scenewright.domains.site.check.bodies import (
    JudgedSite,
    SiteBodies,
    bodies_of,
    fault_of,
    grounds_of,
)
from scenewright.domains.site.check.doors import find_served, find_unserved_doors
from scenewright.domains.site.check.rules import (
    find_near_edges,
    find_outside,
    find_overlaps,
    find_too_close,
)
from scenewright.domains.site.check.sun import find_sunless, sample_rows, sun_hours
from scenewright.ground.plan import SitePlan
from scenewright.ground.works import GroundWorks

SOUTHERLY = np.deg2rad(30.0)
"""How far a front may turn from the preferred heading and still count, in radians."""
STOREY = 3.0


class SiteVerdict(NamedTuple):
    """The report on all sites of an answer: findings, and figures by site."""

    findings: list[Finding]
    figures: dict[str, dict[str, Any]]


def judge_sites(
    sites: Sequence[Site],
    pieces: Sequence[Piece],
    plans: Sequence[SitePlan],
    works: Sequence[GroundWorks] = (),
    figures: bool = True,
) -> SiteVerdict:
    """Every violation on some sites, and their figures. Landmarks are known by their ids; what
    else is a building was placed. Broken pieces become findings. ``plans`` are those of the
    sites; ``works`` say what is laid out on them: doors of sites they do not name are not
    judged. Without ``figures`` there are findings only."""
    laid = {one.site: one for one in works}
    grounds = grounds_of(sites, plans)
    known = {ground.plan.id for ground in grounds}
    faults = [(piece, fault_of(piece, known)) for piece in pieces]
    verdict = SiteVerdict([], {})
    verdict.findings.extend(
        Finding("malformed", "", p.space, p.id, "", f"{p.id or 'a piece'} {fault}", given=p.fixed)
        for p, fault in faults
        if fault
    )
    sound = [piece for piece, fault in faults if not fault]
    for ground in grounds:
        here = [piece for piece in sound if piece.space == ground.plan.id]
        _judge(verdict, ground, here, laid.get(ground.plan.id), figures)
    return verdict


def _judge(
    verdict: SiteVerdict,
    ground: JudgedSite,
    pieces: list[Piece],
    works: GroundWorks | None,
    figures: bool,
) -> None:
    bodies, changed = bodies_of(ground, pieces)
    got = find_reached_bodies(ground, bodies)
    verdict.findings.extend(changed)
    for find in (find_overlaps, find_outside, find_near_edges, find_too_close):
        verdict.findings.extend(find(ground, bodies))
    verdict.findings.extend(find_unreachable(ground, bodies, got))
    if works:
        verdict.findings.extend(find_unserved_doors(ground, bodies, works))
        verdict.findings.extend(find_missing_areas(ground, bodies, works))
    verdict.findings.extend(find_sunless(ground, bodies) if ground.site.sun_required else ())
    if figures:
        served = _measure_service(ground, bodies, works) if works else {}
        verdict.figures[ground.plan.id] = _figures(ground, bodies, got) | served


def _measure_service(ground: JudgedSite, bodies: SiteBodies, works: GroundWorks) -> dict[str, Any]:
    """The share of doors with a walk and of buildings near a lane, and metres of lanes and walks
    laid out."""
    own = ~bodies.landmark
    served, near = find_served(ground, bodies, works)
    length = {"lane": 0.0, "drive": 0.0, "walk": 0.0}
    for row in works.pathways:
        length[row.kind] += float(np.hypot(*np.diff(np.array(row.line), axis=0).T).sum())
    return {
        "doors_served": _share(served[own]),
        "near_lane_share": _share(near[own]),
        "lanes": round(length["lane"], 1),
        "walks": round(length["walk"], 1),
        "drives": round(length["drive"], 1),
        **measure_areas(works, bodies, ground),
    }


def _figures(ground: JudgedSite, bodies: SiteBodies, got: Flags) -> dict[str, Any]:
    """Areas in square metres, distances in metres, hours; shares in [0, 1]. Coverage and
    floor area count landmarks too; shares and distances only what was placed."""
    own = ~bodies.landmark
    area = ground.floor.area
    covered = float(shapely.union_all(bodies.footprints).intersection(ground.floor).area)
    footprint = np.asarray(shapely.area(bodies.footprints))
    floor_area = float((footprint * count_storeys(ground, bodies)).sum())
    off = np.abs(np.angle(np.exp(1j * (bodies.heading[own] - ground.site.facing))))
    return {
        "buildings": int(own.sum()),
        "landmarks": int(bodies.landmark.sum()),
        "area": round(area, 2),
        "coverage": round(covered / area, 4),
        "floor_area": round(floor_area, 1),
        "floor_area_ratio": round(floor_area / area, 4),
        "roads": round(sum(float(way.area) for way in ground.ways) / area, 4),
        "highest": round(float(bodies.high[own].max(initial=0.0)), 2),
        "south_share": _share(off <= SOUTHERLY + 1e-9),
        "reached_share": _share(got[own]),
        **_distances(bodies),
        **_sun(ground.site, bodies),
    }


def _share(flags: Flags) -> float:
    return round(float(flags.mean()), 4) if len(flags) else 1.0


def count_storeys(ground: JudgedSite, bodies: SiteBodies) -> Floats:
    """Storeys: as the wish of the same model and nearest size says, else one for every 3 m."""
    floors = np.maximum(np.round((bodies.high - bodies.low) / STOREY), 1.0)
    known: dict[tuple[str, Size], int] = {}
    for row, piece in enumerate(bodies.pieces):
        key = piece.asset, piece.size
        if key not in known:
            known[key] = _storeys(ground, piece)
        floors[row] = known[key] or floors[row]
    return floors


def _storeys(ground: JudgedSite, piece: Piece) -> int:
    """The storeys of the wish a building answers; 0 if none tells."""
    rows = zip(rows_of(ground.site), ground.plan.models, strict=True)
    wishes = [wish for wish, model in rows if wish.floors and piece.asset == model]
    off = [np.abs(np.subtract(wish.size or piece.size, piece.size)).sum() for wish in wishes]
    return (wishes[int(np.argmin(off))].floors or 0) if wishes else 0


def _distances(bodies: SiteBodies) -> dict[str, float | None]:
    """The least distance between two bodies, at least one of them placed, and the mean over
    buildings of the distance to the nearest body."""
    own = np.flatnonzero(~bodies.landmark)
    if len(bodies.ids) < 2 or not len(own):
        return {"least_spacing": None, "mean_spacing": None}
    tree = shapely.STRtree(bodies.footprints)
    _, gaps = tree.query_nearest(
        bodies.footprints[own], exclusive=True, return_distance=True, all_matches=False
    )
    least, mean = float(gaps.min()), float(gaps.mean())
    return {"least_spacing": round(least, 3), "mean_spacing": round(mean, 3)}


def _sun(site: Site, bodies: SiteBodies) -> dict[str, Any]:
    """Hours of sun of up to 120 buildings, by id, and the share of them with as many as asked."""
    count = int((~bodies.landmark).sum())
    if not count:
        return {"sun_hours": {}, "sun_mean": None, "sun_share": 1.0}
    rows = sample_rows(count)
    hours = sun_hours(bodies, site.latitude, site.day, rows)
    return {
        "sun_hours": {bodies.ids[r]: round(float(h), 2) for r, h in zip(rows, hours, strict=True)},
        "sun_mean": round(float(hours.mean()), 3),
        "sun_share": _share(hours >= site.sun_hours - 1e-6),
    }
