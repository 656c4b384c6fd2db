"""Grown halves have no slits between walls, and no footprint over and over that is there once."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains.extend.streets import continue_streets
from scenewright.ground.buildings.built import BuiltRoad

WIDTHS = (5.0, 6.2, 7.4, 5.6, 8.0, 6.8, 9.2, 7.0)


def _street(equal: bool) -> Brief:
    """A row of terraced houses on either side of a street, all different or all equal."""
    buildings: list[dict[str, Any]] = []
    for side in (0, 1):
        at = 0.0
        for k, width in enumerate(WIDTHS[::-1] if side else WIDTHS):
            wide, deep = (7.0, 10.0) if equal else (width, 8.6 + 0.7 * ((3 * k + side) % 6))
            low, high = (8.0, 8.0 + deep) if side else (-8.0 - deep, -8.0)
            ring = [[at, low], [at + wide, low], [at + wide, high], [at, high]]
            buildings.append({"outline": ring, "height": 8.0})
            at += wide
    road = {"line": [[-5.0, 0.0], [56.0, 0.0]], "width": 8.0}
    area = {"outline": [[57.0, -22.0], [130.0, -22.0], [130.0, 22.0], [57.0, 22.0]]}
    source = {"buildings": buildings, "roads": [road]}
    return Brief.model_validate({"domain": "extend", "sources": [source], "areas": [area]})


def _grown(solution: sw.Solution) -> tuple[list[sw.Piece], list[sw.Piece]]:
    built = [p for p in solution.pieces if p.category == "building"]
    return [p for p in built if p.space == "source"], [p for p in built if p.space != "source"]


def test_what_the_source_has_once_is_copied_as_a_variant() -> None:
    old, new = _grown(sw.solve(_street(equal=False), preset="quick"))
    before, after = (np.array([p.size[:2] for p in half]) for half in (old, new))
    apart = np.abs(after[:, None] - before[None]).max(2).min(1)
    assert len(new) >= 10
    assert (apart < 0.1).mean() <= 0.5


def test_rows_of_equal_houses_stay_rows_of_equal_houses() -> None:
    _, new = _grown(sw.solve(_street(equal=True), preset="quick"))
    sides = np.array([sorted(p.size[:2]) for p in new])
    assert (np.abs(sides - (7.0, 10.0)).max(1) < 0.2).mean() >= 0.7


def test_no_slit_is_left_between_the_walls_of_a_terrace() -> None:
    solution = sw.solve(_street(equal=False), preset="quick", seed=3)
    old, new = _grown(solution)
    shapes = polygons_of([*old, *new])
    away = np.asarray(shapely.distance(shapes[:, None], shapes[None])) + 99.0 * np.eye(len(shapes))
    gaps = away[len(old) :].min(1)
    assert ((gaps > 0.05) & (gaps < 1.5)).mean() <= 0.1
    assert sw.check(solution).valid


def test_streets_bend_and_branch_as_those_of_the_source() -> None:
    bent = [[-80.0, 0.0], [-60.0, 0.0], [-40.0, 4.0], [-20.0, 11.0], [-2.0, 21.0]]
    side = [[-40.0, 4.0], [-47.0, 50.0]]
    roads = [BuiltRoad(np.array(line), 6.0) for line in (bent, side)]
    found = continue_streets(roads, shapely.box(0.0, -40.0, 70.0, 110.0), [], [])
    main, *others = found
    steps = np.diff(main.line, axis=0)
    bearing = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    assert (np.diff(bearing) >= 0.0).all()
    assert bearing[-1] - bearing[0] > np.radians(15.0)
    assert others
    for road in others:
        start = shapely.Point(road.line[0])
        assert shapely.LineString(main.line).distance(start) < 1.0
