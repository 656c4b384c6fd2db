"""Plots of villages: whose ground is what, and what encloses it."""

from __future__ import annotations

import json

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains.village.check.judge import door_of
from scenewright.ground.streetside.fences import fence_lines
from scenewright.ground.streetside.plots import lay_plots, share_ground

BOX = shapely.box


@pytest.fixture(scope="module")
def dense() -> sw.Solution:
    return sw.solve(sw.read("sample:village-dense"), preset="quick")


def test_every_house_lies_on_one_plot_alone(dense: sw.Solution) -> None:
    plots = sw.plots_of(dense)
    houses = {p.id: s for p, s in zip(dense.pieces, polygons_of(dense.pieces), strict=True)}
    named = [name for plot in plots for name in (plot.house, *plot.outbuildings)]
    assert sorted(named) == sorted(p.id for p in dense.pieces if p.category == "building")
    for plot in plots:
        ground = shapely.Polygon(plot.outline)
        assert ground.is_valid
        assert ground.exterior.is_ccw
        for name in (plot.house, *plot.outbuildings):
            assert ground.intersection(houses[name]).area > 0.99 * houses[name].area


def test_plots_do_not_overlap_nor_lie_on_squares(dense: sw.Solution) -> None:
    shapes = [shapely.Polygon(plot.outline) for plot in sw.plots_of(dense)]
    whole = shapely.union_all(shapes).area
    assert sum(shape.area for shape in shapes) == pytest.approx(whole, rel=0.003)
    (square,) = dense.patches
    x, y, _, width, _ = square.box
    assert shapely.union_all(shapes).intersection(shapely.Point(x, y).buffer(width / 3)).area < 0.1


def test_ground_is_shared_in_the_middle_of_a_gap() -> None:
    shapes = np.array([BOX(0, 0, 10, 10), BOX(14, 0, 24, 10)], object)
    left, right = share_ground(BOX(-5, -5, 29, 15), shapes)
    assert left.bounds[2] == pytest.approx(12.0, abs=0.2)
    assert right.bounds[0] == pytest.approx(12.0, abs=0.2)


def test_a_house_about_a_narrow_court_has_its_ground() -> None:
    corners = (
        "55.50734049076722 32.65877863751646, 71.41040319651667 30.9002006389617, "
        "73.82844794452946 52.7669118593672, 57.92538523878001 54.52548985792196, "
        "57.21096292686714 48.064870633711244, 65.16249427974186 47.185581634433866, "
        "64.17329415555481 38.240108862449794, 56.22176280268009 39.11939786172717, "
        "55.50734049076722 32.65877863751646"
    )
    house = shapely.from_wkt(f"POLYGON (({corners}))")
    wide = shapely.buffer(house, 24.0, quad_segs=2, join_style="mitre", mitre_limit=1.5)
    assert not wide.is_valid  # or the court is no longer one that GEOS stumbles over
    floor = shapely.box(45, 0, 95, 62)
    (part,) = share_ground(floor, np.array([house], object))
    assert part.is_valid
    assert part.covers(shapely.intersection(floor, house.buffer(20.0)).buffer(-0.01))


def test_a_shed_belongs_to_the_nearest_dwelling() -> None:
    shapes = np.array([BOX(0, 0, 10, 10), BOX(30, 0, 40, 10), BOX(24, 12, 27, 15)], object)
    plots = lay_plots(BOX(-5, -5, 50, 30), "abc", shapes, np.array([False, False, True]))
    assert [(plot.house, plot.outbuildings) for plot in plots] == [("a", ()), ("b", ("c",))]


def test_no_fence_stands_in_a_passage_or_before_a_gate() -> None:
    shapes = np.array([BOX(0, 0, 10, 10), BOX(12, 0, 22, 10), BOX(40, 0, 50, 10)], object)
    plots = lay_plots(BOX(-5, -5, 60, 20), "abc", shapes, np.zeros(3, bool))
    gate = BOX(30, -10, 33, 30)
    street, other = fence_lines(plots, shapes, BOX(-5, -9, 60, -5), gate, 0.1)
    assert street.length > 50
    assert other.length > 60
    assert not shapely.union(street, other).intersects(BOX(10.1, 1, 11.9, 9))
    assert street.intersection(gate).length + other.intersection(gate).length < 0.01


def test_every_end_of_a_fence_is_on_a_house_another_fence_or_a_gate() -> None:
    shapes = np.array([BOX(0, 0, 10, 8), BOX(20, 1, 30, 9), BOX(31.2, 1, 40, 9)], object)
    plots = lay_plots(BOX(-5, -2.6, 46, 24), "abc", shapes, np.zeros(3, bool))
    gates = shapely.union_all([BOX(4, -3, 6, 0), BOX(24, -3, 26, 1), BOX(35, -3, 37, 1)])
    lines = shapely.union_all(fence_lines(plots, shapes, BOX(-5, -6, 46, -2.6), gates, 0.1))
    edges = shapely.get_parts(shapely.line_merge(lines))
    ends = [shapely.Point(e.coords[k]) for e in edges if not e.is_closed for k in (0, -1)]
    assert len(ends) >= 6
    for k, end in enumerate(ends):
        others = [end.distance(other) for other in ends[:k] + ends[k + 1 :]]
        held = [end.distance(one) for one in (gates, shapely.union_all(shapes))]
        assert min(*held, *others) < 0.06


def test_no_wall_stands_before_a_door(dense: sw.Solution) -> None:
    rows = sw.scene_of(dense).surfaces
    walls = [shapely.Polygon(*a) for s in rows if s.kind == "white_wall" for a in s.areas]
    assert sum(wall.length for wall in walls) > 500
    for piece in (p for p in dense.pieces if p.category == "building"):
        door, ahead = door_of(piece)
        before = shapely.LineString([door + 0.1 * ahead, door + 1.5 * ahead])
        assert all(not before.intersects(wall) for wall in walls)


def test_plots_are_written_and_drawn(dense: sw.Solution, tmp_path) -> None:
    count = len(sw.plots_of(dense))
    sw.write(dense, tmp_path / "a.city.json")
    city = json.loads((tmp_path / "a.city.json").read_text())["CityObjects"]
    assert sum(one["attributes"].get("class") == "plot" for one in city.values()) == count
    sw.write(dense, tmp_path / "a.svg")
    assert (tmp_path / "a.svg").read_text().count("plot of ") == count
    kinds = {row.kind for row in sw.scene_of(dense).surfaces}
    assert {"white_wall", "coping", "walk"} <= kinds


@pytest.mark.parametrize("tag", ["block", "extend"])
def test_of_drawn_plots_those_with_a_building_that_is_kept_are_laid_anew(
    tag: str, tmp_path
) -> None:
    def area(name: str, box: tuple[float, ...], **tags: str) -> dict[str, object]:
        ring = [[x * 1e-5, y * 1e-5] for x, y in BOX(*box).exterior.coords]
        shape = {"type": "Polygon", "coordinates": [ring]}
        return {"type": "Feature", "id": name, "properties": tags, "geometry": shape}

    rows = [
        area("ground", (0, 0, 90, 60), **{tag: "yes"}),
        area("house", (5, 5, 15, 15), building="yes"),
        area("barn", (60, 30, 75, 40), building="yes"),
        area("held", (0, 0, 20, 20), place="plot", area="500"),
        area("empty", (30, 0, 50, 20), place="plot"),
    ]
    path = tmp_path / "map.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": rows}))
    report = sw.read(path).input_report
    found = {row.outcome: row.examples for row in report.rows if row.kind == "plot"}
    assert found == {"changed": ["held"], "left out": ["empty"]}


def test_a_use_in_the_brief_decides_what_serves() -> None:
    row = {"name": "Hut", "footprint": [[0, 0], [6, 0], [6, 5], [0, 5]], "levels": 1}
    block = {"outline": [[0, 0], [60, 0], [60, 40], [0, 40]], "streets": [0], "count": 9}
    number = {}
    for use in ("dwelling", "outbuilding"):
        brief = {"domain": "village", "blocks": [block], "houses": [row | {"use": use}]}
        house = {"name": "House", "footprint": [[0, 0], [11, 0], [11, 9], [0, 9]]}
        brief["houses"] = [row | {"use": use}, house]
        brief["blocks"] = [block | {"classes": {"small": 0.4, "medium": 0.6}}]
        solution = sw.solve(sw.Brief.model_validate(brief), preset="quick")
        number[use] = len(sw.plots_of(solution)) / len(
            [p for p in solution.pieces if p.category == "building"]
        )
    assert number["dwelling"] == 1.0 > number["outbuilding"]
