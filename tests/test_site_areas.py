"""Squares, parking, forecourts and closed courts: laid out as asked for, and missed by name."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

import scenewright as sw
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Pose
from scenewright.core.solution import Solution
from scenewright.domains import check, plan_of, scene_of
from scenewright.domains.site.parks import lay_parks
from scenewright.domains.site.plan import site_plan
from scenewright.domains.site.planting import green
from scenewright.domains.site.writing import cityjson, geojson
from scenewright.formats import solution_json
from scenewright.ground.streetside.lots import keep_open_lots, list_frontages, list_lots
from scenewright.ground.ways.junctions import paint
from scenewright.ground.ways.lane_ends import LONG, TURN, find_dead_ends, list_streets
from scenewright.ground.ways.surfaces import list_zebras, surfaces
from scenewright.ground.works import GroundWorks
from sites import building, site


@pytest.fixture(scope="module")
def solved() -> Solution:
    return sw.solve(sw.read("sample:site-square"))


def kinds_of(solution: Solution) -> set[str]:
    return {found.kind for found in check(solution).findings}


def move(solution: Solution, number: int, x: float, y: float) -> Solution:
    """The solution with one of its buildings elsewhere."""
    pieces = list(solution.pieces)
    rows = [k for k, p in enumerate(pieces) if p.category == "building" and not p.fixed]
    chosen = pieces[rows[number]]
    pieces[rows[number]] = replace(chosen, pose=Pose(x, y, 0.0, chosen.pose.heading))
    return replace(solution, pieces=tuple(pieces))


def test_the_sample_has_all_it_asks_for(solved: Solution) -> None:
    report = check(solved)
    assert report.valid, [str(found) for found in report.findings]
    figures = report.figures["sites"]["square"]
    assert figures["bays"] == 44
    assert figures["squares"] == pytest.approx(900, abs=1)
    assert figures["courts_closed"] == 1.0
    assert not solved.left_out
    scene = scene_of(solved)
    assert {"square", "parking", "court", "marking"} <= {row.kind for row in scene.surfaces}
    again = solution_json.loads(solution_json.dumps(solved))
    assert again.detail == solved.detail


def test_every_long_dead_end_has_its_head_or_goes_on(solved: Solution) -> None:
    plan, rows = plan_of(solved.brief).detail[0], solved.detail[0].pathways
    lanes = [(shapely.LineString(r.line), r.width) for r in rows if r.kind == "lane"]
    heads = [line for line, width in lanes if width == 2.0 * TURN]
    usual = [line for line, width in lanes if width < 2.0 * TURN]
    dead = find_dead_ends([*usual, *heads], list_streets(plan), 2.0)
    long = [usual[k] for k in dead if k < len(usual) and usual[k].length > LONG]
    assert all(min(head.distance(lane) for head in heads) <= 0.1 for lane in long)
    assert heads


def test_ways_have_round_corners_and_crossings_off_walls(solved: Solution) -> None:
    plan = plan_of(solved.brief).detail[0]
    zebras = list_zebras(plan)
    assert len(zebras) == 4
    outlines = [outline_of(p) for p in solved.pieces if p.category == "building"]
    walls = shapely.union_all([shapely.Polygon(o) for o in outlines])
    lanes = []
    for solids in ([shapely.Polygon(plan.outline)], [walls]):
        laid = surfaces((plan,), solved.detail, solids)
        shapes = {r.kind: shapely.union_all([shapely.Polygon(*a) for a in r.areas]) for r in laid}
        paved = shapely.union_all([shapes[kind] for kind in ("asphalt", "kerb", "pavement")])
        assert shapely.covers(paved.buffer(0.1), paint(zebras))
        lanes.append(shapes["lane"])
    corners = lanes[1].difference(lanes[0].buffer(0.01))
    assert corners.area > 20.0
    assert corners.distance(walls) > 0.2
    points = [f for f in geojson.document(solved)["features"] if f["geometry"]["type"] == "Point"]
    assert [f["properties"]["highway"] for f in points] == ["crossing"] * 4


def test_ground_far_from_any_building_is_a_park_with_a_walk_and_trees() -> None:
    ground = site(200.0, 120.0, roads=[{"line": [(-5, 10), (205, 10)], "width": 8}])
    houses = [building(f"s/{k}", 15.0 + 25.0 * k, 25.0, space="s") for k in range(3)]
    plan, rings = site_plan(ground), [outline_of(house) for house in houses]
    (park,), walks = lay_parks(plan, (), (), rings)
    shape, built = shapely.Polygon(park.outline), shapely.union_all(shapely.polygons(rings))
    assert park.kind == "park"
    assert shape.distance(built) >= 7.3
    far = shapely.Polygon(plan.outline).difference(built.buffer(25.0))
    assert shape.intersection(far).area > 0.7 * far.area
    assert shapely.LineString(walks[0].line).within(shape)
    assert len(walks) == 2
    works = GroundWorks("s", walks, (park,))
    trees = green(plan, works, houses, shipped(), np.random.default_rng(0))
    inside = [shape.contains(shapely.Point(t.pose[:2])) for t in trees if t.category == "tree"]
    assert sum(inside) >= 12
    assert not lay_parks(plan, (), (), [np.array(plan.outline)])[0]
    around = [
        np.array([(x, y), (x + 9, y), (x + 9, y + 9), (x, y + 9)]) for x, y in ((95, 60), (9, 9))
    ]
    parks = [shapely.Polygon(row.outline) for row in lay_parks(plan, (), (), around)[0]]
    assert all(row.distance(shapely.Polygon(ring)) > 7.0 for row in parks for ring in around)
    assert len(parks) > 1


def test_a_quad_round_a_named_object_closes_with_its_fronts_to_it() -> None:
    chapel = {"id": "chapel", "model": "pavilion", "at": [80, 72], "quad": 14}
    ground = site(
        160.0,
        130.0,
        setback=3.0,
        spacing=6.0,
        roads=[{"line": [[-10, 10], [170, 12]], "width": 8}],
        landmarks=[chapel],
        buildings=[{"model": "row_houses", "count": 6}, {"model": "villa", "count": 3}],
    )
    found = sw.solve(Brief(domain="site", name="Close", sites=[ground]))
    assert check(found).valid
    middle = np.array([80.0, 72.0])
    near = [p for p in found.pieces if p.asset == "row_houses"]
    near = sorted(near, key=lambda p: float(np.hypot(*(middle - p.pose[:2]))))[:4]
    for piece in near:
        ahead = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
        step = middle - piece.pose[:2]
        assert step @ ahead > 0.9 * np.hypot(*step)
    gone = replace(found, pieces=tuple(p for p in found.pieces if p is not near[0]))
    assert "open_court" in kinds_of(gone)


def test_what_is_missing_or_built_over_is_named(solved: Solution) -> None:
    (works,) = solved.detail

    def without(kind: str) -> Solution:
        areas = tuple(area for area in works.areas if area.kind != kind)
        return replace(solved, detail=(works._replace(areas=areas),))

    assert kinds_of(without("parking")) == {"lack_of_parking"}
    assert kinds_of(without("square")) >= {"lack_of_square"}
    assert kinds_of(without("forecourt")) == {"blocked_forecourt"}
    drives = tuple(path for path in works.pathways if path.kind != "drive")
    cut = replace(solved, detail=(works._replace(pathways=drives),))
    assert kinds_of(cut) == {"lack_of_parking"}
    few = [
        area._replace(bays=area.bays * 3) if area.kind == "parking" else area
        for area in works.areas
    ]
    grown = [area._replace(bays=1) if area.kind == "parking" else area for area in works.areas]
    assert not check(replace(solved, detail=(works._replace(areas=tuple(few)),))).of(
        "lack_of_parking"
    )
    assert check(replace(solved, detail=(works._replace(areas=tuple(grown)),))).of(
        "lack_of_parking"
    )
    middle = np.mean(next(area.outline for area in works.areas if area.kind == "square"), axis=0)
    assert {"blocked_area", "lack_of_square"} <= kinds_of(move(solved, 0, *middle))
    assert {"blocked_forecourt", "blocked_view"} <= kinds_of(move(solved, 0, 190.0, 94.0))


def test_a_court_with_a_building_taken_out_is_open(solved: Solution) -> None:
    (works,) = solved.detail
    courts = [shapely.Polygon(a.outline) for a in works.areas if a.kind == "court"]
    court = shapely.union_all(courts)
    around = [
        p
        for p in solved.pieces
        if p.category == "building" and shapely.Point(p.pose[:2]).distance(court) < 10
    ]
    assert len(around) >= 4
    taken = {p.id for p in around[::2]}
    less = tuple(p for p in solved.pieces if p.id not in taken)
    assert "open_court" in kinds_of(replace(solved, pieces=less))


@pytest.mark.parametrize("form", ["peripheral", None])
def test_courts_close_only_where_a_perimeter_block_is_asked_for(form: str | None) -> None:
    ground = site(
        roads=[{"line": [(0, -1), (0, 81)], "width": 6}],
        buildings=[{"model": "row_houses", "size": [24, 10, 9], "count": 10}],
        form=form,
        court_gap=9,
        spacing=4,
    )
    found = sw.solve(Brief(domain="site", name="Court", sites=[ground]))
    areas = [area.kind for area in found.detail[0].areas]
    assert areas == (["court"] if form else [])
    assert not check(found).of("open_court")


def test_a_site_without_room_is_told_what_is_missing() -> None:
    ground = site(
        roads=[{"line": [(60, -1), (60, 81)], "width": 6}],
        buildings=[{"model": "villa", "count": 4}],
        parking={"bays": 2000},
        squares=[{"area": 9000}],
    )
    brief = Brief(domain="site", name="Full", sites=[ground])
    found = sw.solve(brief)
    names = {out.what for out in found.left_out}
    assert any("parking bays" in name for name in names)
    assert any("square" in name for name in names)
    assert {"lack_of_parking", "lack_of_square"} <= kinds_of(found)


BENT = [[-2, 8], [30, 8.5], [60, 11], [90, 15.5], [122, 22]]


@pytest.mark.parametrize(
    "roads",
    [
        [{"line": BENT, "width": 6}],
        [
            {"line": [[-1, 0], [121, 0]], "width": 3.5},
            {"line": [[0, -1], [0, 81]], "width": 6, "kind": "path"},
        ],
        [{"line": [[-1, 40], [121, 40]], "width": 2.5, "kind": "path"}],
        [],
    ],
    ids=["a bent street", "a road and a wide path", "a narrow path", "no street"],
)
def test_every_lot_that_is_laid_out_has_its_drive(roads: list[dict[str, Any]]) -> None:
    """The solver and the referee mean the same by what cars come by."""
    ground = site(
        roads=roads, buildings=[{"model": "villa", "count": 1}], parking={"bays": 40}, squares=[]
    )
    found = sw.solve(Brief(domain="site", name="Lots", sites=[ground]))
    assert sum(area.bays for area in found.detail[0].areas if area.kind == "parking") == 40
    assert not check(found).of("lack_of_parking")


def test_parking_is_stated_once() -> None:
    for parking in ({}, {"bays": 4, "per_building": 1}):
        with pytest.raises(InputError, match="one of bays and per_building"):
            plan_of(Brief(domain="site", name="P", sites=[site(parking=parking)]))


def test_nothing_is_set_apart_where_nothing_is_asked_for() -> None:
    plan = site_plan(site())
    assert plan.areas == ()
    assert plan.drives == ()


@given(st.integers(0, 10_000))
def test_lots_lie_beside_streets_on_open_ground(seed: int) -> None:
    rng = np.random.default_rng(seed)
    line = np.cumsum(rng.uniform([10, -15], [40, 15], (4, 2)), axis=0)
    ground = shapely.box(-20, -80, 180, 120)
    street = shapely.LineString(line).buffer(4, cap_style="flat", join_style="mitre")
    free = shapely.difference(ground, street)
    lots = list_lots(list_frontages([(line, 8.0)], np.zeros((0, 2))), 9.0, 12.0, 4.0)
    kept = keep_open_lots(lots, [free])
    for lot in shapely.polygons(kept):
        assert lot.exterior.is_ccw
        assert lot.area == pytest.approx(108)
        assert lot.distance(street) < 1.0
        assert lot.difference(free).area < 0.7
    exact = [shapely.covers(free.buffer(0.01), lot) for lot in shapely.polygons(lots)]
    assert len(kept) == sum(exact)


def test_maps_hold_what_is_laid_out(solved: Solution) -> None:
    (works,) = solved.detail
    placed = solved.brief.part.sites[0].model_copy(update={"origin": (11.5, 48.1)})
    brief = solved.brief.model_copy(
        update={"part": solved.brief.part.model_copy(update={"sites": [placed]})}
    )
    told = [f["properties"] for f in geojson.document(replace(solved, brief=brief))["features"]]
    laid = [row["laid_out"] for row in told if "laid_out" in row]
    assert Counter(laid) == Counter(row.kind for row in (*works.pathways, *works.areas))
    assert sum(row.get("capacity", 0) for row in told) == 44
    objects = cityjson.document(solved)["CityObjects"].values()
    classes = Counter((row["type"], row["attributes"].get("class")) for row in objects)
    assert classes["Road", "walk"] == sum(path.kind == "walk" for path in works.pathways)
    assert classes["TransportSquare", "parking"] == 2
    assert classes["LandUse", "court"] == sum(a.kind == "court" for a in works.areas) > 0
