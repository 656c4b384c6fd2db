"""The plan of a home to print: its rooms, and where wheelchairs turn."""

from __future__ import annotations

from scenewright.building.shell import scene_of_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.home.drawing.turning import Turns, turning_mark, turning_of
from scenewright.drawing.marks import PaperView
from scenewright.drawing.rooms import Overlay, Storey, plan


def draw(solution: Solution, made: Plan) -> str:
    """The SVG text of a furnished home."""
    scene = scene_of_rooms(solution, made)
    return plan(scene, catalog_of(solution.brief.catalogs), overlay_of(turning_of(solution, made)))


def overlay_of(turns: Turns) -> Overlay:
    """What homes add to a plan: circles where wheelchairs turn."""

    def circles(view: PaperView, storey: Storey) -> str:
        return turning_mark(view, [turns[s.id] for s in storey.scene.spaces if s.id in turns])

    return Overlay(over=circles)
