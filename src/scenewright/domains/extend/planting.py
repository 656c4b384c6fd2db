"""Trees and lamps of extensions: those of the sources stay, new ground has them as densely.

They are dressing, placed after the buildings, clear of them, of their doors, of walks and streets.
Sources that draw none get none.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import shapely

from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, AreaPlan, ExtendPlan
from scenewright.domains.extend.works import lay_walks, sound_buildings
from scenewright.ground.buildings.built import BuiltScene, Floats, ground_of
from scenewright.ground.planting.density import (
    PlantedGround,
    Planting,
    add_planting,
    count_planting,
    split_ground,
)
from scenewright.ground.planting.filling import plant_alike
from scenewright.ground.planting.pieces import lamp_piece, tree_piece
from scenewright.ground.planting.streets import TakenGround, keep_sight
from scenewright.ground.ways.walks import find_doors
from scenewright.text import quantity

AROUND = 8.0
"""Metres about the ground of a source within which its streets and trees still count."""
TALL = (0.5, 0.58, 0.66, 0.75)
"""Sizes of trees as shares of the usual one, few so that files can share their meshes."""
OTHERS = 0.12
"""The share of trees that are of another form."""


def plant_extension(
    plan: ExtendPlan, pieces: Sequence[Piece], catalog: Catalog, seed: int
) -> tuple[Piece, ...]:
    """The trees and lamps of what stood before, and those of all areas with their buildings."""
    rng, like = np.random.default_rng([seed, 1]), measure_sources(plan)
    found = [*_stand_old(plan, catalog, rng)]
    if not (like.trees or like.along or like.lamps):
        return tuple(found)
    taken = _take_ground(plan, pieces)
    for area in plan.areas:
        ground = _ground_of_area(area, pieces)
        trees, lamps = plant_alike(ground, area.roads, taken, like, rng)
        found += _make_pieces(area.id, trees, lamps, catalog, rng)
    return tuple(found)


def measure_sources(plan: ExtendPlan) -> Planting:
    """How densely the sources are planted and lit, each followed in its share."""
    return add_planting([_measure_source(scene) for scene in plan.sources], plan.shares)


def measure_planting(plan: ExtendPlan, pieces: Sequence[Piece]) -> dict[str, dict[str, Any]]:
    """The figures of the trees and lamps of each area, by its id, and of the sources: trees per
    hectare of green, trees and lamps per 100 m of street."""
    like, found = measure_sources(plan), {}
    for area in plan.areas:
        here = [piece for piece in pieces if piece.space == area.id]
        ground = _ground_of_area(area, pieces)
        own = count_planting(ground, _places(here, "tree"), _places(here, "lamp_post"))
        found[area.id] = {
            "trees": round(own.trees + own.along),
            "lamps": round(own.lamps),
            "trees_per_hectare": round(own.trees_per_hectare, 2),
            "source_trees_per_hectare": round(like.trees_per_hectare, 2),
            "street_trees_per_100_m": round(own.trees_along, 2),
            "source_street_trees_per_100_m": round(like.trees_along, 2),
            "lamps_per_100_m": round(own.lamps_along, 2),
            "source_lamps_per_100_m": round(like.lamps_along, 2),
        }
    return found


def describe_planting(solution: Solution, whole: Plan) -> str:
    """What there is of trees and lamps, new beside the sources, in a sentence; which sources draw
    none."""
    plan: ExtendPlan = whole.detail
    lines = []
    if any(scene.trees or scene.lamps for scene in plan.sources):
        rows = measure_planting(plan, solution.pieces).values()
        for area, row in zip(plan.areas, rows, strict=True):
            trees, lamps = quantity(row["trees"], "tree"), quantity(row["lamps"], "lamp")
            lines.append(
                f"{area.name}: {trees}, {row['trees_per_hectare']:.1f} per ha of green"
                f" (source {row['source_trees_per_hectare']:.1f}) and"
                f" {row['street_trees_per_100_m']:.1f} per 100 m of street"
                f" ({row['source_street_trees_per_100_m']:.1f}); {lamps},"
                f" {row['lamps_per_100_m']:.1f} per 100 m ({row['source_lamps_per_100_m']:.1f})"
            )
    for number, scene in enumerate(plan.sources, 1):
        name = scene.name or f"source {number}"
        lines += [f"{name} {words}" for words in _list_unused(plan, scene)]
    return f" Trees and lamps: {'; '.join(lines)}." if lines else ""


def _list_unused(plan: ExtendPlan, scene: BuiltScene) -> Iterator[str]:
    """What a source lacks of trees and lamps, and what of them does not count or gives way."""
    lacking = [word for word, rows in (("tree", scene.trees), ("lamp", scene.lamps)) if not rows]
    if lacking:
        yield f"draws no {' and no '.join(lacking)}: none is put in after it"
    counted = _measure_source(scene)
    trees = len(scene.trees) - round(counted.trees + counted.along)
    lamps = len(scene.lamps) - round(counted.lamps)
    if trees or lamps:
        off = f"{quantity(trees, 'tree')} off its ground and {quantity(lamps, 'lamp')}"
        yield f"draws {off} off its streets: not counted"
    spots, kept = _spots((*scene.trees, *scene.lamps)), _old_ground(plan)
    cleared = int((~shapely.contains_xy(kept, spots[:, 0], spots[:, 1])).sum())
    if cleared:
        yield f"draws {cleared} of its trees and lamps on new ground or on none: not kept"


def _old_ground(plan: ExtendPlan) -> shapely.Geometry:
    """The ground about the sources that stand, without that of the areas."""
    whole = shapely.Polygon(plan.ground.outline, plan.ground.holes)
    return shapely.difference(whole, shapely.union_all([area.outline for area in plan.areas]))


def _measure_source(scene: BuiltScene) -> Planting:
    floor = shapely.buffer(ground_of(scene), AROUND, join_style="mitre")
    built = shapely.union_all([shapely.Polygon(one.outline) for one in scene.buildings])
    ground = split_ground(floor, scene.roads, built)
    return count_planting(ground, *(_spots(rows) for rows in (scene.trees, scene.lamps)))


def _ground_of_area(area: AreaPlan, pieces: Sequence[Piece]) -> PlantedGround:
    built = [p for p in sound_buildings(pieces) if p.space == area.id]
    shapes = shapely.union_all(polygons_of(built)) if built else shapely.Polygon()
    ground = split_ground(area.outline, area.roads, shapes)
    return ground._replace(green=shapely.intersection(ground.green, area.floor))


def _take_ground(plan: ExtendPlan, pieces: Sequence[Piece]) -> TakenGround:
    houses = sound_buildings(pieces)
    walks = lay_walks(plan, pieces).pathways
    covered = [shapely.LineString(row.line).buffer(row.width / 2) for row in walks]
    ways = [shapely.Polygon(a.outline, a.holes) for way in plan.ground.roads for a in way.areas]
    waters = [shapely.Polygon(outline) for outline in plan.ground.waters]
    doors = find_doors([outline_of(p) for p in houses], np.array([p.pose.heading for p in houses]))
    return TakenGround(
        shapely.STRtree(polygons_of(houses) if houses else []),
        shapely.STRtree([*ways, *waters]),
        shapely.STRtree(covered),
        shapely.STRtree(shapely.points(doors.places)),
        *keep_sight(plan.ground),
    )


def _stand_old(plan: ExtendPlan, catalog: Catalog, rng: np.random.Generator) -> Iterator[Piece]:
    """The trees and lamps of the sources that stand, on their ground."""
    ground = _old_ground(plan)
    kept = [scene for scene, there in zip(plan.sources, plan.stands, strict=True) if there]
    trees, lamps = (
        np.vstack([np.zeros((0, 2)), *(_spots(getattr(scene, what)) for scene in kept)])
        for what in ("trees", "lamps")
    )
    trees, lamps = (at[shapely.contains_xy(ground, at[:, 0], at[:, 1])] for at in (trees, lamps))
    roads = [road for scene in kept for road in scene.roads if road.kind == "road"]
    turned = np.column_stack([lamps, _face_roads(lamps, roads)])
    yield from _make_pieces(OLD, trees, turned, catalog, rng)


def _face_roads(lamps: Floats, roads: Sequence[Any]) -> Floats:
    """Headings (n,) of lamps (n, 2) towards the nearest road."""
    if not roads or not len(lamps):
        return np.zeros(len(lamps))
    lines = shapely.union_all([shapely.LineString(road.line) for road in roads])
    ends = shapely.get_coordinates(shapely.shortest_line(shapely.points(lamps), lines))
    steps = ends[1::2] - ends[::2]
    return np.asarray(np.arctan2(steps[:, 1], steps[:, 0]))


def _make_pieces(
    space: str, trees: Floats, lamps: Floats, catalog: Catalog, rng: np.random.Generator
) -> Iterator[Piece]:
    kinds, posts = catalog.of("tree"), catalog.of("lamp_post")
    for k, at in enumerate(trees.tolist() if kinds else (), 1):
        other, scale = int(rng.random() < OTHERS), TALL[int(rng.integers(len(TALL)))]
        asset = kinds[other % len(kinds)]
        yield tree_piece(f"{space}/tree_{k}", space, asset, at, scale, rng)
    for k, at in enumerate(lamps.tolist() if posts else (), 1):
        yield lamp_piece(f"{space}/lamp_{k}", space, posts[0], at)


def _spots(rows: Sequence[tuple[float, float]]) -> Floats:
    return np.array(rows, float).reshape(-1, 2)


def _places(pieces: Sequence[Piece], category: str) -> Floats:
    return _spots([piece.pose[:2] for piece in pieces if piece.category == category])
