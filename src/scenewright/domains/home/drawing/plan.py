"""The plan of a home to print: its rooms, and where wheelchairs turn."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence

from scenewright.building.shell import scene_of_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.scene import STAIRS, Piece, Scene
from scenewright.core.solution import Solution
from scenewright.domains.home.drawing.turning import Turns, turning_mark, turning_of
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.legend import LegendRow
from scenewright.drawing.marks import PaperView
from scenewright.drawing.rooms import Overlay, Storey, plan
from scenewright.drawing.sheet import title_of


def draw(solution: Solution, made: Plan, judge: Callable[[], Report]) -> PlanDrawing:
    """The plan of a furnished home; ``judge`` gives the referee's report."""
    scene = scene_of_rooms(solution, made)
    turns = turning_of(judge()) if solution.brief.accessible else {}
    catalog = catalog_of(solution.brief.catalogs)
    return plan(scene, catalog, overlay_of(turns, catalog)._replace(title=title_of(solution.brief)))


def overlay_of(turns: Turns, catalog: Catalog) -> Overlay:
    """What homes add to a plan: circles where wheelchairs turn, and a schedule of furniture."""

    def circles(view: PaperView, storey: Storey) -> list[PlanLayer]:
        here = [turns[space.id] for space in storey.scene.spaces if space.id in turns]
        return [PlanLayer("Turning circles", turning_mark(view, here))]

    def schedule(scene: Scene, storeys: Sequence[Storey]) -> list[LegendRow]:
        del storeys
        return list_furniture(scene.pieces, catalog)

    return Overlay(over=circles, legend=schedule)


def list_furniture(pieces: Sequence[Piece], catalog: Catalog) -> list[LegendRow]:
    """The schedule: of each kind that stands on the floor how many there are and how large, width
    by depth in metres, where all are alike; kinds by their names."""
    sizes: dict[str, Counter[str]] = {}
    for piece in pieces:
        kind = catalog.kinds.get(piece.category)
        if piece.function == STAIRS or kind is None or kind.support != "floor":
            continue
        words = f"{piece.size.width:.2f} × {piece.size.depth:.2f}"
        sizes.setdefault(kind.name[:1].upper() + kind.name[1:], Counter())[words] += 1
    rows = [
        LegendRow("letter", name, next(iter(found)) if len(found) == 1 else "", str(found.total()))
        for name, found in sorted(sizes.items())
    ]
    return [LegendRow("heading", "Furniture"), *rows] if rows else []
