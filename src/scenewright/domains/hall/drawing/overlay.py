"""The plan of a hall to print: its rooms with zones, groups, tours, and a legend of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from shapely import Geometry

from scenewright.building.shell import scene_of_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution
from scenewright.domains.hall.drawing.legend_rows import legend_rows
from scenewright.domains.hall.drawing.plan import (
    Halls,
    floor_layers,
    halls_of,
    list_labelled_spaces,
    part_of,
    route_of,
    solid_of,
    ways_layers,
)
from scenewright.drawing.labels import polygon_of
from scenewright.drawing.layers import PlanDrawing
from scenewright.drawing.legend import LegendRow
from scenewright.drawing.rooms import Overlay, Storey, count_words, plan, split_levels
from scenewright.drawing.sheet import TitleBlock, number_sheets, title_of
from scenewright.drawing.wordings import area_words


def draw(solution: Solution, made: Plan, judge: Callable[[], Report]) -> PlanDrawing:
    """The plan of a laid out hall; it shows nothing of the referee's report."""
    del judge
    return _draw_scene(scene_of_rooms(solution, made), solution, title_of(solution.brief))


def draw_levels(
    solution: Solution, made: Plan, judge: Callable[[], Report]
) -> tuple[PlanDrawing, ...]:
    """A sheet for each level."""
    del judge
    levels = split_levels(scene_of_rooms(solution, made))
    blocks = number_sheets(title_of(solution.brief), len(levels))
    return tuple(
        _draw_scene(level, solution, title) for level, title in zip(levels, blocks, strict=True)
    )


def _draw_scene(scene: Scene, solution: Solution, title: TitleBlock) -> PlanDrawing:
    catalog = catalog_of(solution.brief.catalogs)
    halls, ids = halls_of(solution), {space.id for space in scene.spaces}
    added = overlay_of(part_of(halls, ids), catalog) if halls else Overlay()
    return plan(scene, catalog, added._replace(title=title))


def overlay_of(halls: Halls, catalog: Catalog) -> Overlay:
    """Additions of halls to a plan: zones, groups, tours, and a legend of them."""

    def mine(storey: Storey) -> Halls:
        return part_of(halls, {space.id for space in storey.scene.spaces})

    def solid(storey: Storey) -> Geometry:
        return solid_of(storey.walls, storey.scene.pieces, catalog)

    def legend(scene: Scene, storeys: Sequence[Storey]) -> Sequence[LegendRow]:
        solids = {space.id: solid(s) for s in storeys for space in s.scene.spaces}
        return legend_rows(halls, scene, solids)

    return Overlay(
        floor=lambda view, s: floor_layers(view, mine(s), s.walls, s.scene.pieces),
        ways=lambda view, s: ways_layers(view, mine(s), solid(s)),
        keep_off=lambda view, s: [route_of(mine(s)).buffer(2.0 / view.scale)],
        labels=lambda s: list_labelled_spaces(mine(s), s.scene.spaces),
        legend=legend,
        summary=lambda scene: hall_summary(scene, halls),
        inward=True,
    )


def hall_summary(scene: Scene, halls: Halls) -> str:
    """The line below the title: floor area, zones, groups, objects."""
    objects = sum(piece.category != "partition" for piece in scene.pieces)
    counts = (len(halls.graph.zones), "zone"), (len(halls.graph.groups), "group")
    words = [count_words(*count) for count in (*counts, (objects, "object"))]
    total = area_words(sum(polygon_of(space).area for space in scene.spaces))
    return " · ".join(["Hall plan", total, *words])
