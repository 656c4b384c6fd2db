"""The plan of a site to print, to scale, north up, sites of a brief side by side.

Outline, setback, roads and paths, landmarks hatched, buildings tinted by storeys with a mark at
their front, trees, entrances; what the referee finds is drawn in red. Beside it the legend with
the figures of the referee.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from string import ascii_uppercase
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.core.plan import Plan
from scenewright.core.report import Finding, Report
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.domains.site.brief import Site
from scenewright.domains.site.drawing import marks as marks
from scenewright.domains.site.drawing.views import Views, views_of
from scenewright.domains.site.shapes import StandingBuilding, standing
from scenewright.domains.site.works import works_of
from scenewright.drawing import sheet as sheets
from scenewright.drawing.ground_sheet import paving_mark
from scenewright.drawing.houses import FAULT, LEAF, trees_mark
from scenewright.drawing.layers import PlanDrawing, PlanLayer, merge_layers
from scenewright.drawing.legend import LegendRow, arrange, legend_mark
from scenewright.drawing.marks import NOTHING, PaperView, clean, group, text
from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.border import cover_beside
from scenewright.ground.ways.surfaces import kerb, surfaces
from scenewright.ground.works import GroundWorks
from scenewright.text import quantity

MARGIN, CAPTION = 6.0, 7.0
"""Millimetres around a site, and below it for its name."""
LARGE, MODELS = 2000, 30
"""The scale from which papers above A3 are used; most models listed."""


class SiteSheet(NamedTuple):
    """One site with its buildings, the findings, and its bounds in metres."""

    site: Site
    plan: SitePlan
    rows: tuple[StandingBuilding, ...]
    trees: tuple[Piece, ...]
    works: GroundWorks
    findings: tuple[Finding, ...]
    figures: dict[str, Any]
    bounds: tuple[float, float, float, float]


def draw(solution: Solution, made: Plan, judge: Callable[[], Report]) -> PlanDrawing:
    """The plan of a solution's sites, with what walkers see along the ways;
    ``judge`` gives the referee's report."""
    return plan(solution, made.detail, judge(), views_of(solution, made.detail))


def plan(
    solution: Solution, plans: tuple[SitePlan, ...], report: Report, views: Views | None = None
) -> PlanDrawing:
    """The plan of all sites with what the referee reports of them; ``views`` adds
    what walkers see along the ways."""
    views = views or {}
    drawings = drawings_of(solution, plans, report)
    wide = sum(d.bounds[2] - d.bounds[0] for d in drawings)
    high = max(d.bounds[3] - d.bounds[1] for d in drawings)
    extra = (len(drawings) + 1) * MARGIN, 2 * MARGIN + CAPTION
    letters = letters_of(drawings)
    rows = legend(drawings, letters, views)
    arranged = arrange((wide, high), extra, rows, LARGE)
    sheet, (room_wide, room_high) = arranged.sheet, arranged.room
    scale = 1000 / sheet.scale
    spare = (room_wide - wide * scale) / (len(drawings) + 1)
    summary, title = _summary(drawings, views), sheets.title_of(solution.brief)
    title_strip = sheets.sheet_mark(sheet, solution.brief.name, summary, title)
    left, parts = sheets.EDGE, [[PlanLayer("Sheet", title_strip)]]
    views_on_sheet: list[PaperView] = []
    for drawing in drawings:
        west, south, east, north = drawing.bounds
        left += spare
        bottom = sheets.EDGE + (room_high - CAPTION + (north - south) * scale) / 2
        view = sheets.view_at(sheet, west, south, left, bottom)
        views_on_sheet.append(view)
        parts.append(_site_layers(view, drawing, letters, views.get(drawing.plan.id)))
        if len(drawings) > 1:
            middle = left + (east - west) * scale / 2
            caption = text(drawing.plan.name, (middle, bottom + MARGIN), 2.6)
            parts.append([PlanLayer("Names of sites", caption)])
        left += (east - west) * scale
    parts.append([PlanLayer("Legend", legend_mark(arranged))])
    only = views_on_sheet[0] if len(views_on_sheet) == 1 else None
    return PlanDrawing(solution.brief.name, sheet, (marks.hatch(),), merge_layers(parts), only)


def drawings_of(
    solution: Solution, plans: tuple[SitePlan, ...], report: Report
) -> tuple[SiteSheet, ...]:
    """The sheet of each site of a solution."""
    rows = standing(solution, plans)
    return tuple(
        _drawing(
            site,
            plan,
            tuple(row for row in rows if row.site == plan.id),
            tuple(p for p in solution.pieces if p.space == plan.id and p.category == "tree"),
            works,
            tuple(f for f in report.findings if f.space == plan.id),
            report.figures["sites"][plan.id],
        )
        for site, plan, works in zip(
            solution.brief.part.sites, plans, works_of(solution, plans), strict=True
        )
    )


def _drawing(
    site: Site,
    plan: SitePlan,
    rows: tuple[StandingBuilding, ...],
    trees: tuple[Piece, ...],
    works: GroundWorks,
    findings: tuple[Finding, ...],
    figures: dict[str, Any],
) -> SiteSheet:
    """Bounds take in the site, streets beside it and buildings no farther outside than it is
    long."""
    low, high = plan.outline.min(0), plan.outline.max(0)
    reach = float((high - low).max()) / 2
    inside = [
        row.footprint
        for row in rows
        if np.isfinite(row.footprint).all()
        and (row.footprint > low - reach).all()
        and (row.footprint < high + reach).all()
    ]
    streets = [shapely.get_coordinates(cover_beside(way)) for way in plan.roads]
    corners = np.vstack([plan.outline, *inside, *streets])
    (west, south), (east, north) = corners.min(0).tolist(), corners.max(0).tolist()
    drawn = tuple(row for row in rows if any(row.footprint is kept for kept in inside))
    return SiteSheet(site, plan, drawn, trees, works, findings, figures, (west, south, east, north))


def letters_of(drawings: Sequence[SiteSheet]) -> dict[str, str]:
    """A letter for every model, the most frequent first: A to Z, then A1 …"""
    counts = Counter(marks.model_of(r) for d in drawings for r in d.rows if not r.landmark)
    return {
        name: f"{ascii_uppercase[k % 26]}{k // 26 or ''}"
        for k, (name, _) in enumerate(counts.most_common())
    }


def _site_layers(
    view: PaperView,
    drawing: SiteSheet,
    letters: Mapping[str, str],
    seen: tuple[Points, Points] | None,
) -> list[PlanLayer]:
    """A site on paper, from the ground up."""
    plan, rows = drawing.plan, drawing.rows
    built = [shapely.Polygon(row.footprint) for row in rows]
    laid = surfaces((plan,), (drawing.works,), built)
    return [
        PlanLayer("Ground", marks.ground_mark(view, plan)),
        PlanLayer("Squares, parking and courts", marks.areas_mark(view, drawing.works)),
        PlanLayer("Lanes and walks", paving_mark(view, laid, marks.FILLS, "walk", "lane")),
        PlanLayer(
            "Roads and paths",
            group(
                [
                    marks.beside_mark(view, plan.roads),
                    paving_mark(view, laid, marks.FILLS, *marks.STREETS),
                ]
            ),
        ),
        PlanLayer("Views", marks.views_mark(view, *seen) if seen else NOTHING),
        PlanLayer("Names of ways", marks.way_names_mark(view, plan.roads)),
        PlanLayer("Setback", marks.setback_mark(view, plan, drawing.site.setback)),
        PlanLayer("Trees", trees_mark(view, drawing.trees)),
        PlanLayer("Buildings", marks.buildings_mark(view, rows)),
        PlanLayer(
            "Names",
            group(
                [marks.labels_mark(view, rows, letters), marks.park_names_mark(view, drawing.works)]
            ),
        ),
        PlanLayer("Ways in", marks.entrances_mark(view, plan)),
        PlanLayer("Violations", marks.faults_mark(view, rows, drawing.findings)),
    ]


def legend(
    drawings: Sequence[SiteSheet], letters: Mapping[str, str], views: Views
) -> tuple[LegendRow, ...]:
    """Signs that occur, the models with their numbers, then the figures of each site."""
    rows = [LegendRow("heading", "Legend")]
    used = {marks.tint(r.floors) for d in drawings for r in d.rows if not r.landmark}
    least = 1
    for most, colour in marks.STOREYS:
        storeys = f"{least}–{most} storeys" if most < 1000 else f"{least} storeys and more"
        rows += [LegendRow("swatch", storeys, value=colour)] if colour in used else []
        least = most + 1
    ways = {way.kind for d in drawings for way in d.plan.roads}
    laid = {path.kind for d in drawings for path in d.works.pathways}
    apart = {area.kind for d in drawings for area in d.works.areas}
    kerbed = any(kerb(way.width) for d in drawings for way in d.plan.roads if way.kind == "road")
    drawn = any(f.piece in {row.id for row in d.rows} for d in drawings for f in d.findings)
    signs = (
        (any(r.landmark for d in drawings for r in d.rows), "swatch", "Landmark", marks.HATCH),
        ("road" in ways, "swatch", "Road", marks.ASPHALT),
        (kerbed, "swatch", "Pavement", marks.PAVEMENT),
        ("lane" in laid, "swatch", "Lane", marks.LANE),
        ("path" in ways, "swatch", "Path", marks.PAVING),
        ("walk" in laid, "swatch", "Walk to a door", marks.PAVING),
        (bool(apart & {"square", "forecourt"}), "swatch", "Square, forecourt", marks.SQUARE),
        ("parking" in apart, "swatch", "Parking", marks.LOT),
        ("park" in apart, "swatch", "Park", marks.PARK),
        ("court" in apart, "swatch", "Closed court", marks.COURT),
        (any(d.trees for d in drawings), "swatch", "Tree", LEAF),
        (any(d.site.setback for d in drawings), "border", "Setback", ""),
        (bool(letters), "entrance", "Front of a building", ""),
        (any(d.plan.entrances for d in drawings), "exit", "Way in", ""),
        (bool(views), "swatch", "Little to see from the way", marks.view_colour(0.0)),
        (bool(views), "swatch", "Much to see", marks.view_colour(1.0)),
        (drawn, "swatch", "Violation, distance in metres", FAULT),
    )
    rows += [LegendRow(sign, words, value=value) for used_, sign, words, value in signs if used_]
    rows += _models(drawings, letters)
    for drawing in drawings:
        heading = drawing.plan.name if len(drawings) > 1 else "Figures"
        rows += _figures(drawing, heading, views.get(drawing.plan.id))
    return tuple(rows)


def _models(drawings: Sequence[SiteSheet], letters: Mapping[str, str]) -> list[LegendRow]:
    """The models by letter: how many there are, storeys and height."""
    counts = Counter(marks.model_of(r) for d in drawings for r in d.rows if not r.landmark)
    first = {marks.model_of(r): r for d in drawings for r in d.rows if not r.landmark}
    rows = [
        LegendRow(
            "letter",
            first[name].name,
            f"{counts[name]} × {first[name].floors} st, {first[name].high - first[name].low:.0f} m",
            letter,
        )
        for name, letter in list(letters.items())[:MODELS]
    ]
    more = len(letters) - MODELS
    if more > 0:
        rows.append(LegendRow("", f"and {more} more models"))
    return [LegendRow("heading", "Models"), *rows] if rows else []


def _figures(
    drawing: SiteSheet, heading: str, seen: tuple[Points, Points] | None
) -> list[LegendRow]:
    found, site = drawing.figures, drawing.site
    least, sun = found["least_spacing"], found["sun_mean"]
    figures = [
        ("Ground", f"{found['area']:,.0f} m²"),
        ("Buildings", f"{found['buildings']}"),
        ("Coverage", _against(f"{found['coverage']:.1%}", site.coverage, ".0%")),
        (
            "Floor area ratio",
            _against(f"{found['floor_area_ratio']:.2f}", site.floor_area_ratio, ".2f"),
        ),
        ("Least distance", "–" if least is None else f"{least:.1f} m of {site.spacing:g} m"),
        ("Fronts to the preferred side", f"{found['south_share']:.0%}"),
        (
            f"At least {site.sun_hours:g} h of winter sun" if sun is not None else "",
            f"{found['sun_share']:.0%}",
        ),
        ("Winter sun, mean" if sun is not None else "", f"{sun or 0.0:.1f} h"),
        (
            "Visual quality seen from the ways" if seen else "",
            f"{seen[1].mean():.3f}" if seen else "",
        ),
        (
            "Doors with a way to them" if "doors_served" in found else "",
            f"{found.get('doors_served', 1.0):.0%}",
        ),
        ("Reached by the fire brigade", f"{found['reached_share']:.0%}"),
        ("Faults", f"{sum(f.is_blamed for f in drawing.findings)}"),
    ]
    return [
        LegendRow("heading", clean(heading, 40)),
        *(LegendRow("", w, right) for w, right in figures if w),
    ]


def _against(value: str, wanted: float | None, form: str) -> str:
    return value if wanted is None else f"{value} of {wanted:{form}}"


def _summary(drawings: Sequence[SiteSheet], views: Views) -> str:
    buildings = sum(d.figures["buildings"] for d in drawings)
    area = sum(d.plan.area for d in drawings)
    faults = sum(f.is_blamed for d in drawings for f in d.findings)
    parts = [f"{area / 1e4:.2f} ha", quantity(buildings, "building")]
    hours = [d.figures["sun_mean"] for d in drawings if d.figures["sun_mean"] is not None]
    parts += [f"{float(np.mean(hours)):.1f} h of winter sun"] if hours else []
    parts += (
        [f"visual quality {np.concatenate([v for _, v in views.values()]).mean():.3f}"]
        if views
        else []
    )
    return " · ".join(["Site plan", *parts, *([quantity(faults, "violation")] if faults else [])])
