"""The plan of a home to print: its rooms, and where wheelchairs turn."""

from __future__ import annotations

from collections.abc import Callable

from scenewright.building.shell import scene_of_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.domains.home.drawing.turning import Turns, turning_mark, turning_of
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.marks import PaperView
from scenewright.drawing.rooms import Overlay, Storey, plan


def draw(solution: Solution, made: Plan, judge: Callable[[], Report]) -> PlanDrawing:
    """The plan of a furnished home; ``judge`` gives the referee's report."""
    scene = scene_of_rooms(solution, made)
    turns = turning_of(judge()) if solution.brief.accessible else {}
    return plan(scene, catalog_of(solution.brief.catalogs), overlay_of(turns))


def overlay_of(turns: Turns) -> Overlay:
    """What homes add to a plan: circles where wheelchairs turn."""

    def circles(view: PaperView, storey: Storey) -> list[PlanLayer]:
        here = [turns[space.id] for space in storey.scene.spaces if space.id in turns]
        return [PlanLayer("Turning circles", turning_mark(view, here))]

    return Overlay(over=circles)
