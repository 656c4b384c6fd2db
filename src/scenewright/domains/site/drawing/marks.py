"""Marks of a site plan: ground, roads, buildings by storeys, hatched landmarks, trees, faults."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
import shapely

from scenewright.core.report import Finding
from scenewright.core.space import Points
from scenewright.domains.site.shapes import StandingBuilding
from scenewright.drawing.houses import FAULT, GROUND
from scenewright.drawing.marks import (
    FINE,
    GREY,
    INK,
    LINE,
    NOTHING,
    OUTLINE,
    FillPattern,
    Mark,
    MeantMark,
    PaperView,
    group,
    line,
    plate,
    shape,
    text_width,
    title,
    to_paper,
)
from scenewright.drawing.meanings import PieceMeaning
from scenewright.ground.plan import SitePlan, Way
from scenewright.ground.streetside.bays import list_bay_lines
from scenewright.ground.streetside.border import cover_beside
from scenewright.ground.works import GREEN, GroundWorks

ASPHALT, PAVING = "#d9d9d6", "#ece3d0"
LANE, SQUARE, LOT, COURT = "#e2ded6", "#e3d6bd", "#d3d3d0", "#dcead0"
PAVEMENT, KERB, PARK = "#e9e7e2", "#b5b2ac", "#cfe3bd"
FILLS = {
    "walk": PAVING,
    "lane": LANE,
    "path": PAVING,
    "pavement": PAVEMENT,
    "kerb": KERB,
    "asphalt": ASPHALT,
    "marking": "#ffffff",
}
STREETS = ("path", "pavement", "kerb", "asphalt", "marking")
"""What streets and paths are drawn of, one over the other."""
HATCH = "url(#hatch)"
FAINT, FULL = np.array([236.0, 226.0, 240.0]), np.array([106.0, 27.0, 130.0])
"""Colours of what walkers see: nothing, and most."""
MUCH, BAND = 0.3, 1.1
"""Visual quality V drawn as most, and how wide the band along the ways is in millimetres."""

STOREYS = ((3, "#fbe9d3"), (6, "#f5cfa3"), (11, "#e9ac73"), (18, "#cf8850"), (10_000, "#a8643a"))
"""Most storeys, and the fill of buildings up to it."""

LABEL, SMALLEST = 2.1, 1.15
"""Height of labels in millimetres, and the least at which they are still written."""


def tint(floors: int) -> str:
    """The fill of a building.

    >>> tint(1) == tint(3) != tint(4)
    True
    """
    return next(colour for most, colour in STOREYS if floors <= most)


def hatch() -> FillPattern:
    """The pattern of landmarks, defined once."""
    stroke = line([(0, 0), (0, 1.4)], stroke=INK, stroke_width=0.22)
    return FillPattern("hatch", 1.4, 1.4, 45.0, "#ffffff", (stroke,))


def ground_mark(view: PaperView, plan: SitePlan) -> Mark:
    """The ground, its outline as a border of dashes and dots, its holes white."""
    rings = [to_paper(view, ring) for ring in (plan.outline, *plan.holes)]
    return shape(
        rings,
        fill=GROUND,
        fill_rule="evenodd",
        stroke=INK,
        stroke_width=OUTLINE,
        stroke_dasharray="5 1 0.6 1",
    )


def setback_mark(view: PaperView, plan: SitePlan, setback: float) -> Mark:
    """The line up to which may be built, dashed."""
    floor = shapely.Polygon(plan.outline, plan.holes)
    inner = shapely.buffer(floor, -setback, join_style="mitre", mitre_limit=2.0)
    rings = (
        [
            shape([to_paper(view, shapely.get_coordinates(ring)[:-1])])
            for part in shapely.get_parts(inner)
            for ring in (part.exterior, *part.interiors)
        ]
        if setback > 0
        else []
    )
    return group(rings, fill="none", stroke=GREY, stroke_width=LINE, stroke_dasharray="1.6 1")


def beside_mark(view: PaperView, ways: Sequence[Way]) -> Mark:
    """Streets and paths beside the site, with their middle line."""
    areas, middles = [], []
    for way in sorted(ways, key=lambda way: way.kind != "path"):
        fill = ASPHALT if way.kind == "road" else PAVING
        for part in shapely.get_parts(cover_beside(way)):
            around = [shapely.get_coordinates(ring) for ring in (part.exterior, *part.interiors)]
            rings = [to_paper(view, ring) for ring in around]
            areas.append(shape(rings, fill=fill, fill_rule="evenodd"))
        if way.kind == "road" and way.width * view.scale > 2.0:
            middles += [line(to_paper(view, part)) for part in way.beside]
    dashed = group(
        middles, fill="none", stroke="#ffffff", stroke_width=0.25, stroke_dasharray="2.4 1.6"
    )
    return group([*areas, dashed])


def way_names_mark(view: PaperView, ways: Sequence[Way]) -> Mark:
    """The names of ways along their longest piece, to be read over whatever is drawn on them."""
    return group([_name(view, way) for way in ways])


def _name(view: PaperView, way: Way) -> Mark:
    """The name of a way on its longest straight piece in the drawing, if it fits there."""
    steps = [(a, b) for part in (*way.inside, *way.beside) for a, b in pairwise(part)]
    size = min(LABEL, 0.7 * way.width * view.scale)
    if not way.name or not steps or size < SMALLEST:
        return NOTHING
    a, b = max(steps, key=lambda step: float(np.hypot(*(step[1] - step[0]))))
    if np.hypot(*(b - a)) * view.scale < text_width(way.name, size) + 2:
        return NOTHING
    turn = float(np.degrees(np.arctan2(b[1] - a[1], b[0] - a[0])))
    turn = (turn + 90.0) % 180.0 - 90.0
    return plate(way.name, to_paper(view, (a + b) / 2), size, turn=turn, fill=INK)


def buildings_mark(view: PaperView, rows: Sequence[StandingBuilding]) -> Mark:
    """Buildings by their storeys with a mark at the middle of the front, landmarks hatched."""
    marks = []
    for row in rows:
        words = model_of(row)
        fill = HATCH if row.landmark else tint(row.floors)
        body = shape([to_paper(view, row.footprint)], fill=fill)
        drawn = group([title(words), body, NOTHING if row.landmark else _front(view, row)])
        marks.append(MeantMark(drawn, _mean_building(view, row, words)))
    return group(marks, stroke=INK, stroke_width=LINE, stroke_linejoin="round")


def _mean_building(view: PaperView, row: StandingBuilding, words: str) -> PieceMeaning:
    """What a building is: placed by the middle of its footprint, as large as its box."""
    middle = row.footprint.mean(0)
    ahead = np.array([np.cos(row.heading), np.sin(row.heading)])
    deep, wide = (
        float(np.ptp(row.footprint @ way)) for way in (ahead, np.array([ahead[1], -ahead[0]]))
    )
    x, y = to_paper(view, middle).tolist()
    local = np.round((row.footprint - middle) @ np.array([ahead, (-ahead[1], ahead[0])]).T, 3)
    alike = ("building", row.floors, row.landmark, tuple(map(tuple, local.tolist())))
    kind, turn = "landmark" if row.landmark else "building", 90.0 - float(np.degrees(row.heading))
    size = wide, deep, row.high - row.low
    return PieceMeaning(row.id, kind, words, row.model, size, (x, y), turn, alike)


def _front(view: PaperView, row: StandingBuilding) -> Mark:
    """A small triangle at the middle of the side farthest ahead, pointing out."""
    ahead = np.array([np.cos(row.heading), np.sin(row.heading)])
    ends = np.stack([row.footprint, np.roll(row.footprint, -1, axis=0)], 1)
    start, end = ends[int(np.argmax((ends @ ahead).sum(1)))]
    middle = np.stack([start, end]).mean(0)
    size = min(1.3 / view.scale, 0.25 * float(np.hypot(*(end - start))))
    side = np.array([-ahead[1], ahead[0]]) * size
    corners = [
        middle + side - ahead * size * 0.2,
        middle - side - ahead * size * 0.2,
        middle + ahead * size,
    ]
    return shape([to_paper(view, np.array(corners))], fill=INK, stroke="none")


def labels_mark(
    view: PaperView, rows: Sequence[StandingBuilding], letters: Mapping[str, str]
) -> Mark:
    """The letter of each building's model (by :func:`model_of`) and its storeys, the name and
    height of landmarks, where there is room."""
    marks = []
    for row in rows:
        words = [row.name, f"{row.high - row.low:.0f} m"]
        if not row.landmark:
            words = [letters.get(model_of(row), ""), f"{row.floors} st"]
        marks.append(_label(view, row.footprint, words))
    return group(marks, fill=INK)


def model_of(row: StandingBuilding) -> str:
    """What tells the models of a plan apart: name, storeys and height."""
    return f"{row.name} · {row.floors} storeys · {row.high - row.low:.1f} m"


def areas_mark(view: PaperView, works: GroundWorks) -> Mark:
    """Squares, forecourts, car parks with their bays, and courts; squares with their names."""
    fills = {"square": SQUARE, "forecourt": SQUARE, "parking": LOT, "court": COURT, "park": PARK}
    shapes, words = [], []
    for area in sorted(works.areas, key=lambda row: row.kind not in GREEN):
        ring = np.array(area.outline)
        caption = f"{area.kind} {area.about}".strip()
        caption += (
            f" · {area.bays} bays" if area.bays else f" · {shapely.Polygon(ring).area:.0f} m²"
        )
        shapes.append(group([title(caption), shape([to_paper(view, ring)], fill=fills[area.kind])]))
        shapes += [line(to_paper(view, ends)) for ends in list_bay_lines(area)]
        if area.kind in ("square", "parking"):
            name = f"P {area.bays}" if area.kind == "parking" else area.about or "Square"
            words.append(_area_name(view, ring, name))
    return group([group(shapes, stroke=GREY, stroke_width=FINE), *words])


def park_names_mark(view: PaperView, works: GroundWorks) -> Mark:
    """The names of parks, to be read over their trees."""
    marks = []
    for area in (row for row in works.areas if row.kind == "park"):
        circle = shapely.maximum_inscribed_circle(shapely.Polygon(area.outline), tolerance=0.5)
        middle = shapely.get_coordinates(circle)[0]
        marks.append(plate(area.about, to_paper(view, middle), LABEL, fill=INK))
    return group(marks)


def _area_name(view: PaperView, ring: Points, name: str) -> Mark:
    """The name of an area in its middle, where it fits."""
    wide = min(float(np.hypot(*(ring[1] - ring[0]))), float(np.hypot(*(ring[2] - ring[1]))))
    size = min(LABEL, 0.9 * wide * view.scale / max(text_width(name, 1.0), 1e-9))
    return plate(name, to_paper(view, ring.mean(0)), size) if size >= SMALLEST else NOTHING


def _label(view: PaperView, footprint: Points, words: list[str]) -> Mark:
    """Two short lines, or one joined, as large as fits upright in the footprint."""
    polygon = shapely.Polygon(footprint)
    circle = shapely.maximum_inscribed_circle(polygon, tolerance=0.1)
    radius = float(circle.length)
    x0, y0, x1, y1 = map(float, polygon.bounds)
    central = polygon.centroid.within(shapely.buffer(polygon, -0.8 * radius))
    middle = shapely.get_coordinates(polygon.centroid if central else circle)[0]
    wide, high = (max(2 * radius, 0.7 * (b - a)) * view.scale for a, b in ((x0, x1), (y0, y1)))
    for lines in (words, [" · ".join(words)], words[:1]):
        longest = max(text_width(line_, 1.0) for line_ in lines)
        size = min(LABEL, 0.9 * wide / longest, 0.8 * high / (1.25 * len(lines)))
        if size >= SMALLEST:
            at = to_paper(view, middle)
            offsets = (np.arange(len(lines)) - (len(lines) - 1) / 2) * 1.25 * size
            return group(
                [
                    plate(line_, (at[0], at[1] + off), size)
                    for line_, off in zip(lines, offsets, strict=True)
                ]
            )
    return NOTHING


def faults_mark(
    view: PaperView, rows: Sequence[StandingBuilding], findings: Sequence[Finding]
) -> Mark:
    """What the referee found, in red: the gap between buildings too close with its length, all
    else as an outline of the building."""
    known = {row.id: shapely.Polygon(row.footprint) for row in rows}
    marks, ringed, words = [], set(), []
    for found in findings:
        first, second = known.get(found.piece), known.get(found.other)
        if found.kind == "spacing" and first is not None and second is not None:
            ends = shapely.get_coordinates(shapely.shortest_line(first, second))
            gap = float(np.hypot(*(ends[1] - ends[0])))
            points = to_paper(view, ends)
            marks.append(group([title(found.message), line(points, stroke_width=0.5)]))
            x, y = points.mean(0)
            words.append(plate(f"{gap:.1f}", (x + 2.6, y), 1.8, fill=FAULT))
        elif first is not None and found.piece not in ringed:
            ringed.add(found.piece)
            body = shape([to_paper(view, shapely.get_coordinates(first)[:-1])])
            marks.append(group([title(found.message), body]))
    return group([*marks, *words], fill="none", stroke=FAULT, stroke_width=0.5)


def entrances_mark(view: PaperView, plan: SitePlan) -> Mark:
    """Where roads and paths come in: a triangle pointing inwards."""
    floor = shapely.Polygon(plan.outline, plan.holes)
    marks = []
    for entrance in plan.entrances:
        at = np.array([entrance.x, entrance.y])
        way = plan.roads[entrance.way]
        near = way.line - at
        along = near[int(np.argmax(np.hypot(*near.T)))]
        along = along / max(float(np.hypot(*along)), 1e-9)
        if not floor.intersects(shapely.Point(at + along * 0.5)):
            along = -along
        tip, side = at + along * 1.6 / view.scale, np.array([-along[1], along[0]]) / view.scale
        foot = at - along * 1.2 / view.scale
        marks.append(shape([to_paper(view, np.array([tip, foot + side * 1.4, foot - side * 1.4]))]))
    return group(marks, fill="#007a4d", stroke="#ffffff", stroke_width=FINE)


def views_mark(view: PaperView, points: Points, values: Points) -> Mark:
    """What walkers see, a band along the ways: the deeper the violet, the more. ``points`` (n, 2)
    that follow each other closely are joined; ``values`` (n,) are visual qualities V."""
    places, marks = to_paper(view, points), []
    shades = np.clip(values / MUCH, 0.0, 1.0)
    gaps = np.hypot(*np.diff(points, axis=0).T) if len(points) > 1 else np.zeros(0)
    near = gaps <= 1.5 * float(np.median(gaps)) if len(gaps) else gaps
    for k in range(len(places)):
        first, last = k > 0 and bool(near[k - 1]), k < len(near) and bool(near[k])
        start = (places[k - 1] + places[k]) / 2 if first else places[k]
        end = (places[k] + places[k + 1]) / 2 if last else places[k]
        ends = [tuple(map(float, point)) for point in (start, places[k], end)]
        marks.append(line(ends, stroke=view_colour(float(shades[k]))))
    return group(marks, stroke_width=BAND, stroke_linecap="round", fill="none")


def view_colour(share: float) -> str:
    """The colour of a place with a ``share`` (0 to 1) of the best view.

    >>> view_colour(0.0), view_colour(1.0)
    ('#ece2f0', '#6a1b82')
    """
    mixed = (1 - share) * FAINT + share * FULL
    return "#" + "".join(f"{round(part):02x}" for part in mixed.tolist())
