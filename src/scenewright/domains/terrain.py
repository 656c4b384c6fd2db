"""Terrain of any domain with open ground: its heights shaped for a solution, its scene on them.

What shapes ground is compiled, and imported only where a brief states terrain.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import shapely

from scenewright.check.terrain import JudgedTerrain, judge_terrain
from scenewright.core.brief import Brief
from scenewright.core.brief.terrain import TerrainBrief
from scenewright.core.plan import Plan
from scenewright.core.registry import domain_of
from scenewright.core.report import Report
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution
from scenewright.drawing.contours import contours_mark, water_mark
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.marks import is_blank
from scenewright.ground.buildings.built import BuiltRoad

if TYPE_CHECKING:
    from scenewright.ground.terrain.shaping import ShapedGround


def terrain_of(brief: Brief) -> TerrainBrief | None:
    """The terrain a brief states; none where its ground is flat."""
    found: TerrainBrief | None = getattr(brief.part, "terrain", None)
    return found


def ground_shape(solution: Solution, plan: Plan) -> ShapedGround | None:
    """The ground of a solution as built on; none where it is flat."""
    terrain = terrain_of(solution.brief)
    if terrain is None:
        return None
    from scenewright.ground.terrain.lifting import shape_for

    ways = domain_of(solution.brief.domain).verb("ways")(solution, plan)
    return shape_for(terrain, plan.spaces, ways, solution.pieces, shift_of(solution.brief))


def shift_of(brief: Brief) -> tuple[float, float]:
    """The coordinates of (0, 0) in the map a brief was read from."""
    sites = getattr(brief.part, "sites", ())
    found: tuple[float, float] = sites[0].shift if sites else (0.0, 0.0)
    return found


def lay_on_terrain(scene: Scene, solution: Solution, plan: Plan) -> Scene:
    """The scene of a solution on its terrain; as it is where that is flat."""
    shaped = ground_shape(solution, plan)
    if shaped is None:
        return scene
    from scenewright.ground.terrain.lifting import lift_scene

    return lift_scene(scene, shaped)


def judge_ground(solution: Solution, plan: Plan, report: Report) -> Report:
    """The report on a solution with what the referee says of its terrain."""
    terrain, shaped = terrain_of(solution.brief), ground_shape(solution, plan)
    if terrain is None or shaped is None:
        return report
    rows = domain_of(solution.brief.domain).verb("ways")(solution, plan)
    driven = [(way.name or f"way {k}", way.line) for k, way in enumerate(rows, 1) if is_driven(way)]
    judged = JudgedTerrain(terrain, *shaped[:3], shaped.floors, driven)
    findings, notes, figures = judge_terrain(judged, solution.pieces)
    told = {**report.figures, "terrain": figures}
    findings, notes = [*report.findings, *findings], [*report.notes, *notes]
    return replace(report, findings=tuple(findings), notes=tuple(notes), figures=told)


def is_driven(way: BuiltRoad) -> bool:
    """Whether cars use a way."""
    return way.kind in ("road", "lane", "drive")


def describe_ground(solution: Solution, plan: Plan) -> str:
    """What was made of the ground, in a sentence; nothing where it is flat."""
    shaped = ground_shape(solution, plan)
    if shaped is None:
        return ""
    high = list(shaped.floors.values())
    rise = f", floors from {min(high):+.1f} to {max(high):+.1f} m" if high else ""
    return f" Ground: {shaped.cut:,.0f} m³ cut and {shaped.fill:,.0f} m³ filled{rise}."


def check_terrain(brief: Brief, plan: Plan) -> None:
    """InputError where the terrain of a brief cannot be read or does not cover its ground."""
    terrain = terrain_of(brief)
    if terrain is not None:
        from scenewright.ground.terrain.lifting import extent
        from scenewright.ground.terrain.reading import natural_ground, waters_of

        floor = extent(plan.spaces, ())
        waters_of(terrain.water, natural_ground(terrain, floor, shift_of(brief)))


def lay_city_on_terrain(
    document: dict[str, Any], solution: Solution, plan: Plan | None
) -> dict[str, Any]:
    """A CityJSON document of a solution on its terrain; as it is where that is flat."""
    if terrain_of(solution.brief) is None:
        return document
    made: Plan = plan or domain_of(solution.brief.domain).verb("plan")(solution.brief)
    shaped = ground_shape(solution, made)
    if shaped is None:
        return document
    from scenewright.ground.terrain.city_relief import lay_on_relief

    return lay_on_relief(document, shaped)


def draw_ground(drawing: PlanDrawing, solution: Solution, plan: Plan) -> PlanDrawing:
    """A plan with the contours of its finished ground and its water, where it is not flat and all
    of it is drawn as one."""
    shaped = ground_shape(solution, plan)
    view = drawing.view
    if shaped is None or view is None:
        return drawing
    floor = shapely.union_all([shapely.Polygon(s.outline, s.holes) for s in plan.spaces])
    waters = [shapely.get_coordinates(water.shape)[:-1] for water in shaped.waters]
    made = [
        PlanLayer("Water", water_mark(view, waters, floor)),
        PlanLayer("Contours", contours_mark(view, shaped.finished, floor)),
    ]
    names = [layer.name for layer in drawing.layers]
    at = names.index("Ground") + 1 if "Ground" in names else len(names)
    layers = (*drawing.layers[:at], *made, *drawing.layers[at:])
    return drawing._replace(layers=tuple(row for row in layers if not is_blank(row.mark)))
