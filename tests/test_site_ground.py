"""What lies and grows on a site: roads in one piece, walks to doors, trees clear of everything."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.catalog.assets import shipped
from scenewright.catalog.assets.tints import TINTS
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.solution import Solution
from scenewright.domains import scene_of
from scenewright.domains.site.plan import plans_of
from scenewright.formats.glb import encode_scene
from scenewright.ground.ways.junctions import STREET_RADIUS
from scenewright.ground.ways.kerbs import LET_DOWN, STONE
from scenewright.ground.ways.surfaces import list_zebras
from scenewright.render.draping import lay_surface

CROSSING = [
    {"line": [[-5, 40], [60, 30], [125, 45]], "width": 10},
    {"line": [[60, -5], [60, 95]], "width": 8},
    {"line": [[-5, 70], [125, 70]], "width": 3, "kind": "path"},
]
BUILDINGS = [{"model": "villa", "count": 7}, {"model": "row_houses", "count": 2}]


def solved(roads: list[dict[str, object]], **more: object) -> Solution:
    ground = {"id": "s", "outline": [[0, 0], [120, 0], [120, 90], [0, 90]], "roads": roads}
    return sw.solve(Brief.model_validate({"domain": "site", "sites": [ground | more]}))


@pytest.fixture(scope="module")
def street() -> Solution:
    return solved(CROSSING, buildings=BUILDINGS, landmarks=[{"model": "pavilion", "at": [20, 12]}])


def shapes_of(solution: Solution) -> dict[str, shapely.Geometry]:
    return {
        row.kind: shapely.union_all([shapely.Polygon(*area) for area in row.areas])
        for row in scene_of(solution).surfaces
    }


def footprints(solution: Solution) -> list[shapely.Polygon]:
    boxes = [
        (p.pose.x, p.pose.y, p.pose.heading, p.size.width, p.size.depth)
        for p in solution.pieces
        if p.category == "building"
    ]
    return [shapely.Polygon(ring) for ring in corners(np.array(boxes))]


def test_roads_are_one_piece_and_cover_what_the_plan_says(street: Solution) -> None:
    found = shapes_of(street)
    plan = plans_of(street.brief)[0]
    roads = shapely.union_all(
        [
            shapely.Polygon(a.outline, a.holes)
            for way in plan.roads
            if way.kind == "road"
            for a in way.areas
        ]
    )
    assert found["asphalt"].geom_type == "Polygon"
    parts = [found[kind] for kind in ("asphalt", "pavement", "kerb")]
    paved = shapely.union_all(parts)
    assert paved.area == pytest.approx(sum(part.area for part in parts), rel=1e-4)
    assert roads.difference(paved).area < 0.2
    assert 0.0 < paved.difference(roads).area < STREET_RADIUS**2
    for one, other in (("asphalt", "pavement"), ("path", "asphalt"), ("walk", "path")):
        assert found[one].intersection(found[other]).area < 0.1
    assert found["asphalt"].buffer(1e-3).contains(found["marking"])
    crossing = found["marking"].intersection(shapely.Point(60, 30).buffer(4.0))
    assert crossing.area == 0.0


def test_kerbs_edge_carriageways_and_are_let_down_where_people_cross_and_cars_drive_on(
    street: Solution,
) -> None:
    found = shapes_of(street)
    assert found["asphalt"].distance(found["pavement"]) >= STONE - 0.01
    edge = found["asphalt"].boundary.intersection(found["pavement"].buffer(2.0 * STONE))
    assert edge.difference(found["kerb"].buffer(0.01)).length < 0.01 * edge.length
    (row,) = (one for one in scene_of(street).surfaces if one.kind == "kerb")
    mesh = lay_surface(row)
    stones = mesh.vertices[mesh.vertices[:, 2] > 0.0]
    at = shapely.points(stones[:, :2])
    zebras = list_zebras(plans_of(street.brief)[0])
    crossed = [one._replace(wide=one.wide + 5.0).area() for one in zebras]
    lanes = [row.line for row in street.detail[0].pathways if row.kind == "lane"]
    driven = [shapely.Point(end) for line in lanes for end in (line[0], line[-1])]
    on_edge = shapely.distance(at, found["asphalt"]) < 0.01
    for places, near in ((crossed, 0.1), (driven, 2.5)):
        low = on_edge & (shapely.distance(at, shapely.union_all(places)) < near)
        assert low.any()
        assert np.isclose(stones[low, 2].min(), LET_DOWN, atol=1e-3)
    far = shapely.distance(at, shapely.union_all([*crossed, *driven])) > 6.0
    assert np.isclose(stones[far & on_edge, 2], row.top, atol=1e-3).all()


def test_a_site_without_roads_has_only_lanes_and_walks_on_the_ground() -> None:
    assert {"walk"} <= set(shapes_of(solved([], buildings=BUILDINGS))) <= {"lane", "walk", "park"}


def test_walks_lead_from_doors_to_ways_past_all_buildings(street: Solution) -> None:
    (works,) = street.detail
    walks = [shapely.LineString(row.line) for row in works.pathways if row.kind == "walk"]
    paved = [shapely.LineString(r.line).buffer(r.width / 2) for r in works.pathways]
    plan = plans_of(street.brief)[0]
    ways = [shapely.Polygon(a.outline) for w in plan.roads for a in w.areas]
    parts = shapely.get_parts(shapely.union_all([*paved, *ways]))
    assert all(part.intersects(shapely.union_all(ways)) for part in parts)
    floor = shapely.Polygon(plan.outline).buffer(1e-6)
    assert all(floor.covers(walk) for walk in walks)
    for shape in footprints(street):
        door = shape.buffer(1.5)
        assert min(walk.difference(door).distance(shape) for walk in walks) > 0.75


def test_trees_and_lamps_keep_clear(street: Solution) -> None:
    found = shapes_of(street)
    drive = shapely.union_all([found[kind] for kind in ("asphalt", "path", "walk")])
    built = shapely.union_all(footprints(street))
    trees = [p for p in street.pieces if p.category == "tree"]
    assert len(trees) > 20
    for tree in trees:
        stem = shapely.Point(tree.pose.x, tree.pose.y)
        assert stem.distance(drive) > 1.0
        assert stem.distance(built) > tree.size.width / 2
    lamps = [p for p in street.pieces if p.category == "lamp_post"]
    assert lamps
    assert all(found["pavement"].contains(shapely.Point(p.pose.x, p.pose.y)) for p in lamps)


def test_trees_line_wide_streets_off_crossings_corners_and_lamps() -> None:
    roads = [{"line": [[-5, 45], [125, 45]], "width": 14}, {"line": [[60, -5], [60, 95]]}]
    wide = solved([roads[0], roads[1] | {"width": 12}], buildings=[{"model": "row_houses"}] * 6)
    found, (plan,) = shapes_of(wide), plans_of(wide.brief)
    street = shapely.union_all([shapely.Polygon(a.outline) for w in plan.roads for a in w.areas])
    stems, posts = (
        shapely.points([p.pose[:2] for p in wide.pieces if p.category == category])
        for category in ("tree", "lamp_post")
    )
    rows = stems[shapely.contains(street, stems)]
    assert len(rows) >= 8
    assert shapely.distance(rows, found["asphalt"]).min() > 0.5
    crossings = shapely.union_all([one.area() for one in list_zebras(plan)])
    assert shapely.distance(rows, crossings).min() > 5.0
    assert shapely.distance(rows, shapely.MultiPoint(posts)).min() > 2.0
    corners_seen = shapely.box(60 - 6 - 10, 45 - 7 - 10, 60 + 6 + 10, 45 + 7 + 10).buffer(-5.1)
    assert not shapely.contains(corners_seen, stems).any()


def test_like_buildings_differ_in_colour_and_landmarks_do_not(street: Solution) -> None:
    data = encode_scene(scene_of(street), shipped())
    document = json.loads(data[20 : 20 + struct.unpack("<I", data[12:16])[0]])

    def is_shared(node: dict[str, Any], prefix: str) -> bool:
        return prefix.strip("-_s") in node["name"] and "instances" in node["extras"]

    def colours(prefix: str) -> list[set[str]]:
        used = [
            document["meshes"][node["mesh"]]["primitives"]
            for node in document["nodes"]
            if node["name"].startswith(prefix) or is_shared(node, prefix)
            if "mesh" in node
        ]
        names = [{document["materials"][row["material"]]["name"] for row in rows} for rows in used]
        return [set(row) for row in {frozenset(row) for row in names}]

    assert len(colours("s-villa_")) > 1
    (landmark,) = colours("s-landmark-1")
    plain = {material.name for material in TINTS}
    others = {tint.name for row in TINTS.values() for tint in row[1:]}
    assert landmark & plain
    assert not landmark & others
    assert encode_scene(scene_of(street), shipped()) == data
