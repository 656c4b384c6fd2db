"""Houses over polygons: wings cover their footprint, roofs stay on it, everything fills the box."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from scenewright.catalog.assets import shipped
from scenewright.catalog.assets.buildings.house_shapes import (
    hips,
    inset,
    list_rectangles,
    saddle,
    split_wings,
)
from scenewright.catalog.assets.buildings.rural_houses import build_house
from scenewright.core.footprint import Footprint, read_footprint
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, volume

ELL = [(0, 0), (22, 0), (22, 8), (9, 8), (9, 18), (0, 18)]
YOU = [(0, 0), (22, 0), (22, 16), (15, 16), (15, 8), (7, 8), (7, 16), (0, 16)]
TEE = [(0, 0), (20, 0), (20, 7), (13, 7), (13, 15), (7, 15), (7, 7), (0, 7)]
STEP = [(0, 0), (15, 0), (15, 6.5), (10.5, 6.5), (10.5, 9.5), (0, 9.5)]
ODD = [(0, 0), (14, 2), (15, 9), (6, 12), (-1, 7)]
FORMS = {"ell": ELL, "you": YOU, "tee": TEE, "step": STEP}
TURNS = (1, 2, 3)


def footprint(points: list[tuple[float, float]], turn: int = 0):
    turned = np.array(points, float) @ np.linalg.matrix_power(np.array([[0, 1], [-1, 0]]), turn)
    wide, deep = np.ptp(turned, axis=0)
    return read_footprint(turned.tolist(), float(wide), float(deep)), float(wide), float(deep)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("turn", [0, *TURNS])
def test_wings_cover_the_footprint_and_no_more(form: str, turn: int) -> None:
    local, _, _ = footprint(FORMS[form], turn)
    wings = split_wings(local)
    covered = shapely.union_all([shapely.box(w.x[0], w.y[0], w.x[1], w.y[1]) for w in wings])
    assert covered.symmetric_difference(shapely.Polygon(local)).area < 1e-6
    assert max(w.span for w in wings) == wings[0].span < 10.6
    assert all(w.span <= min(w.x[1] - w.x[0], w.y[1] - w.y[0]) + 8 for w in wings)


def test_what_is_not_square_has_no_wings_but_a_saddle_that_covers_it() -> None:
    local, _, _ = footprint(ODD)
    assert split_wings(local) == ()
    made = saddle(local, 3.0, 6.0)
    assert sum(volume(mesh) for mesh in made) > 0.4 * shapely.Polygon(local).area * 3.0
    tops = np.concatenate([mesh.vertices for mesh in made])
    assert tops[:, 2].max() == pytest.approx(6.0)
    assert tops[:, 2].min() == pytest.approx(3.0)


def test_an_inset_is_smaller_on_all_sides() -> None:
    local, _, _ = footprint(ELL)
    inner = shapely.Polygon(inset(local, 0.5))
    assert shapely.Polygon(local).exterior.distance(inner) == pytest.approx(0.5)
    assert inset(local, 50.0) == local


@pytest.mark.parametrize("asset", [a.id for a in shipped().of("house")])
@pytest.mark.parametrize("form", [*FORMS, "odd", "box"])
def test_houses_fill_their_box_and_stay_on_their_footprint(asset: str, form: str) -> None:
    points = {**FORMS, "odd": ODD, "box": [(0, 0), (12, 0), (12, 10), (0, 10)]}[form]
    local, wide, deep = footprint(points)
    size = Size(wide, deep, 8.0)
    drawn = shipped().assets[asset]
    parts = drawn.over(size, local) if drawn.over else ()
    corners = np.concatenate([part.vertices for part in parts])
    assert corners.min(0) == pytest.approx([-wide / 2, -deep / 2, 0.0], abs=1e-6)
    assert corners.max(0) == pytest.approx([wide / 2, deep / 2, 8.0], abs=1e-6)
    covered = shapely.Polygon(
        local
        or [
            (-wide / 2, -deep / 2),
            (wide / 2, -deep / 2),
            (wide / 2, deep / 2),
            (-wide / 2, deep / 2),
        ]
    )
    outside = shapely.distance(covered, shapely.points(corners[:, :2]))
    assert outside.max() < 0.45
    assert sum(len(part.faces) for part in parts) < 6000


def _cross(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    return one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]


def _height(meshes: list[Mesh], x: float, y: float) -> float:
    """The highest point of some meshes above (x, y), by every triangle."""
    best = -np.inf
    for mesh in meshes:
        a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
        area = _cross(b - a, c - a)
        at = np.array([x, y, 0.0])
        a, b, c, area = (row[np.abs(area) > 1e-9] for row in (a, b, c, area))
        v, w = _cross(at - a, c - a) / area, _cross(b - a, at - a) / area
        inside = (v >= -1e-9) & (w >= -1e-9) & (v + w <= 1 + 1e-9)
        z = a[:, 2] + v * (b[:, 2] - a[:, 2]) + w * (c[:, 2] - a[:, 2])
        best = max(best, *z[inside].tolist()) if inside.any() else best
    return best


@pytest.mark.parametrize(
    "outline",
    [
        ((0.0, 0.0), (14.0, 0.0), (14.0, 7.0), (8.0, 7.0), (8.0, 15.0), (0.0, 15.0)),
        ((0.0, 0.0), (20.0, 0.0), (20.0, 14.0), (14.0, 14.0), (14.0, 8.0), (0.0, 8.0)),
        ((0.0, 0.0), (12.0, 1.0), (13.0, 9.0), (6.0, 13.0), (-1.0, 8.0)),
    ],
)
def test_hips_rise_as_far_as_the_nearest_side_is(outline: Footprint) -> None:
    """Over right angles the distance is along the axes (no point of a square round the spot lies
    outside); over a convex footprint it is to the nearest side."""
    shape = shapely.Polygon(outline)
    roofs = hips(outline, 3.0, 0.5)
    straight = bool(list_rectangles(outline))
    rng = np.random.default_rng(0)
    west, south, east, north = shape.bounds
    for x, y in rng.uniform((west, south), (east, north), (200, 2)):
        if not shape.contains(shapely.Point(x, y)):
            continue
        away = shape.exterior.distance(shapely.Point(x, y))
        if straight:
            halves = np.linspace(0, 20, 2001)
            fits = shapely.covers(
                shape, shapely.box(x - halves, y - halves, x + halves, y + halves)
            )
            away = float(halves[fits].max())
        assert _height(roofs, x, y) == pytest.approx(3.0 + 0.5 * away, abs=0.02)


def test_a_footprint_neither_straight_nor_convex_has_no_hips() -> None:
    assert hips(((0.0, 0.0), (12.0, 1.0), (13.0, 9.0), (6.0, 5.0), (-1.0, 8.0)), 3.0, 0.5) == []


def test_no_gable_of_a_narrower_wing_stands_within_the_roof_of_the_main_one() -> None:
    ring = [(-9, -6.5), (9, -6.5), (9, 0.5), (-3, 0.5), (-3, 6.5), (-9, 6.5)]
    corners = read_footprint([(float(x), float(y)) for x, y in ring], 18.0, 13.0)
    size = Size(18.0, 13.0, 8.0)
    points = np.concatenate([p.vertices for p in build_house(size, corners, "hui", "gabled")])
    within = (np.abs(points[:, 0]) < 8.0) & (np.abs(points[:, 1] + 3.0) < 3.0)
    assert points[:, 2].max() == pytest.approx(8.0)
    assert points[within][:, 2].max(initial=0.0) < 7.6
