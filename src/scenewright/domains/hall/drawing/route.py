"""The visitor's route in plan: a smooth dashed line with its stops and its narrow places."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.hall.drawing.narrow import Narrow, run_of, select_narrowest
from scenewright.domains.hall.hall_layout import Tour
from scenewright.drawing.marks import (
    LINE,
    NOTHING,
    ROUTE,
    WARNING,
    CurveMark,
    Mark,
    PaperView,
    arrow_head,
    group,
    plate,
    shape,
    text_width,
    to_paper,
)
from scenewright.drawing.signs import (
    BUBBLE,
    CASING,
    HEAD,
    PEN,
    bubble,
    end_mark,
    narrow_mark,
    start_mark,
)

FIGURE, WORD, EVERY, APART, MOST, HEADS = 1.8, 2.1, 38.0, 14.0, 12, 300
"""Text heights; millimetres from arrow head to arrow head and between narrow places; most
narrow places, and most heads."""

Vector = NDArray[np.float64]


def route_mark(
    view: PaperView, tour: Tour, numbers: Mapping[str, int], places: Sequence[Narrow]
) -> Mark:
    """The route of one tour; ``numbers`` of the groups it stops at, ``places`` where it is
    narrow."""
    points = to_paper(view, tour.points)
    if len(points) < 2:
        return NOTHING
    run = run_of(points)
    path = curve(points)
    tight = [
        _narrow(points, run, place, to_paper(view, place.ends), view.scale)
        for place in select_narrowest(places, APART / view.scale, MOST)
    ]
    busy = [spot for _, spots in tight for spot in spots]
    stops = _stops(points, run, tour, numbers, busy)
    taken = np.array([points[0], points[-1], *busy, *(at for _, at in stops)])
    marks = [
        CurveMark(path, {"stroke": "#ffffff", "stroke_width": CASING}),
        CurveMark(path, {"stroke": ROUTE, "stroke_width": PEN, "stroke_dasharray": "2.4 1.1"}),
        *_heads(points, run, taken),
        *(mark for mark, _ in tight),
        _word(points, run, taken),
        *_ends(points),
        *(bubble(number_, at, filled=True) for number_, at in stops),
    ]
    return group(marks, fill="none", stroke_linecap="round", stroke_linejoin="round")


def curve(points: Vector) -> Vector:
    """Ends and handles (3 n - 2, 2) of a smooth curve through paper points (n, 2): cubic pieces
    whose tangents follow the neighbours (Catmull and Rom, 1974)."""
    padded = np.vstack([points[:1], points, points[-1:]])
    slope = (padded[2:] - padded[:-2]) / 6
    steps = np.hstack([points[:-1] + slope[:-1], points[1:] - slope[1:], points[1:]])
    return np.vstack([points[:1], steps.reshape(-1, 2)])


def _narrow(
    points: Vector, run: Vector, place: Narrow, ends: Vector, scale: float
) -> tuple[Mark, list[Vector]]:
    """The mark of a narrow place, and the paper points it takes."""
    words = f"{place.width:.2f}"
    at = int(np.searchsorted(run, place.run * scale - 1e-6).clip(0, len(points) - 1))
    ahead = _direction(points, at)
    reach = np.abs(ahead) @ np.array([text_width(words, FIGURE) / 2, FIGURE / 2]) + 0.9
    figure = ends.mean(axis=0) + reach * ahead
    mark = plate(words, figure, FIGURE, fill=WARNING, font_weight="bold")
    return group([narrow_mark(ends), mark]), [points[at], figure]


def _away(points: Vector, taken: Vector) -> Vector:
    """Distance of each point to the nearest of those taken."""
    away: Vector = shapely.distance(shapely.points(points), shapely.multipoints(taken))
    return away


def _direction(points: Vector, at: int) -> Vector:
    step: Vector = points[min(at + 1, len(points) - 1)] - points[max(at - 1, 0)]
    return step / max(float(np.hypot(*step)), 1e-9)


def _heads(points: Vector, run: Vector, taken: Vector) -> list[Mark]:
    """Arrow heads at about even distances, away from what is drawn on the route already."""
    count = int(np.clip(run[-1] / EVERY, 1, HEADS))
    away = _away(points, taken)
    found = []
    for wanted in ((np.arange(count) + 0.5) * run[-1] / count).tolist():
        at = int(np.argmin(np.abs(run - wanted) + 20.0 * (away < BUBBLE + HEAD)))
        ahead = _direction(points, at)
        corners = arrow_head(points[at] + HEAD / 2 * ahead, ahead, HEAD)
        found.append(shape([corners], fill=ROUTE, stroke="#ffffff", stroke_width=LINE))
    return found


def _ends(points: Vector) -> list[Mark]:
    """The start, and an arrow head before the end."""
    ahead = _direction(points, len(points) - 1)
    head = arrow_head(points[-1] - 1.0 * ahead, ahead, HEAD)
    tip = shape([head], fill=ROUTE, stroke="#ffffff", stroke_width=LINE)
    return [start_mark(points[0]), tip, end_mark(points[-1])]


def _stops(
    points: Vector, run: Vector, tour: Tour, numbers: Mapping[str, int], busy: list[Vector]
) -> list[tuple[int, Vector]]:
    """Number and place of every stop, moved along the route where it would cover another mark."""
    placed: list[tuple[int, Vector]] = []
    for stop in tour.stops:
        if stop.group not in numbers:
            continue
        order = np.argsort(np.abs(run - run[stop.at]), kind="stable")
        taken = np.array([points[0], points[-1], *busy, *(at for _, at in placed)])
        clear = np.flatnonzero(_away(points[order], taken) > 2.3 * BUBBLE)
        placed.append((numbers[stop.group], points[order[clear[0] if len(clear) else 0]]))
    return placed


def _word(points: Vector, run: Vector, taken: Vector) -> Mark:
    """The word "route" over the straightest and levellest stretch free of other marks."""
    need = text_width("route", WORD) + 2.0
    best, found = -np.inf, None
    ends = np.searchsorted(run, run + need)
    away = _away(points, taken)
    for k, end in enumerate(ends[ends < len(points)].tolist()):
        middle, way = (points[k] + points[end]) / 2, points[end] - points[k]
        straight = float(np.hypot(*way)) / (run[end] - run[k])
        free = min(float(away[(k + end) // 2]), 10.0) / 10.0
        score = 20.0 * straight + 2.0 * free + abs(way[0]) / max(float(np.hypot(*way)), 1e-9)
        if score > best:
            best, found = score, (middle, way)
    if found is None:
        return NOTHING
    middle, way = found
    turn = (float(np.degrees(np.arctan2(-way[1], way[0]))) + 90 - 1e-6) % 180 - 90 + 1e-6
    up = np.array([-np.sin(np.radians(turn)), -np.cos(np.radians(turn))])
    style: dict[str, str | float] = {"fill": ROUTE, "font_weight": "bold"}
    return plate("route", middle + (WORD / 2 + 1.1) * up, WORD, turn=turn, **style)
