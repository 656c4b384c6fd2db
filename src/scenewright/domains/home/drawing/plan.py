"""The plan of a home to print: its rooms, and where wheelchairs turn."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence

from scenewright.building.shell import scene_of_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.scene import STAIRS, Piece, Scene, Size
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains.home.drawing.short_names import short_names_mark, with_letters
from scenewright.domains.home.drawing.turning import Turns, turning_mark, turning_of
from scenewright.drawing.filled_sheet import arrange_filled, enlarge_names
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.legend import LegendRow
from scenewright.drawing.marks import PaperView
from scenewright.drawing.rooms import Overlay, Storey, plan, split_levels
from scenewright.drawing.sheet import TitleBlock, number_sheets, title_of

OUTLETS = {"power": "Socket", "antenna": "Antenna", "data": "Data", "water": "Tap and drain"}
"""What the symbols of outlets stand for."""


def draw(solution: Solution, made: Plan, judge: Callable[[], Report]) -> PlanDrawing:
    """The plan of a furnished home; ``judge`` gives the referee's report."""
    return _draw_scene(scene_of_rooms(solution, made), solution, judge, title_of(solution.brief))


def draw_levels(
    solution: Solution, made: Plan, judge: Callable[[], Report]
) -> tuple[PlanDrawing, ...]:
    """A sheet for each level."""
    levels = split_levels(scene_of_rooms(solution, made))
    blocks = number_sheets(title_of(solution.brief), len(levels))
    return tuple(
        _draw_scene(level, solution, judge, title)
        for level, title in zip(levels, blocks, strict=True)
    )


def _draw_scene(
    scene: Scene, solution: Solution, judge: Callable[[], Report], title: TitleBlock
) -> PlanDrawing:
    turns = turning_of(judge()) if solution.brief.accessible else {}
    catalog = catalog_of(solution.brief.catalogs)
    return plan(scene, catalog, overlay_of(turns, catalog)._replace(title=title))


def overlay_of(turns: Turns, catalog: Catalog) -> Overlay:
    """What homes add to a plan: circles where wheelchairs turn, and a schedule of furniture."""

    def circles(view: PaperView, storey: Storey) -> list[PlanLayer]:
        here = [turns[space.id] for space in storey.scene.spaces if space.id in turns]
        letters = short_names_mark(view, storey.scene.pieces)
        return [
            PlanLayer("Turning circles", turning_mark(view, here)),
            PlanLayer("Short names", letters),
        ]

    def schedule(scene: Scene, storeys: Sequence[Storey]) -> list[LegendRow]:
        del storeys
        return [*list_furniture(scene.pieces, catalog), *list_outlets(scene.spaces)]

    return Overlay(over=circles, legend=schedule, arrange=arrange_filled, enlarge=enlarge_names)


def list_furniture(pieces: Sequence[Piece], catalog: Catalog) -> list[LegendRow]:
    """The schedule: of each kind that stands on the floor how many there are and how large, width
    by depth in metres, from the least to the largest; kinds by their names."""
    sizes: dict[str, list[Size]] = {}
    for piece in pieces:
        kind = catalog.kinds.get(piece.category)
        if piece.function == STAIRS or kind is None or kind.support != "floor":
            continue
        name = with_letters(piece.category, kind.name[:1].upper() + kind.name[1:])
        sizes.setdefault(name, []).append(piece.size)
    rows = [
        LegendRow("letter", name, size_words(found), str(len(found)))
        for name, found in sorted(sizes.items())
    ]
    return [LegendRow("heading", "Furniture"), *rows] if rows else []


def list_outlets(spaces: Sequence[Space]) -> list[LegendRow]:
    """The key to the symbols of outlets, with how many of each there are."""
    counts = Counter(outlet.kind for space in spaces for outlet in space.outlets)
    rows = [
        LegendRow("outlet", words, str(counts[kind]), kind)
        for kind, words in OUTLETS.items()
        if kind in counts
    ]
    return [LegendRow("heading", "Outlets"), *rows] if rows else []


def size_words(sizes: Sequence[Size]) -> str:
    """Width by depth in metres; a range where one differs, of the widths only where both do.

    >>> size_words([Size(0.5, 0.6, 0.9)]), size_words([Size(0.5, 0.6, 0.9), Size(0.45, 0.6, 2.0)])
    ('0.50 × 0.60', '0.45–0.50 × 0.60')
    >>> size_words([Size(0.5, 0.6, 0.9), Size(0.45, 0.4, 0.9)])
    '0.45–0.50 wide'
    """
    sides = [(s.width for s in sizes), (s.depth for s in sizes)]
    ranges = [sorted({f"{side:.2f}" for side in found}, key=float) for found in sides]
    width, depth = ("–".join(dict.fromkeys((found[0], found[-1]))) for found in ranges)
    return f"{width} wide" if "–" in width and "–" in depth else f"{width} × {depth}"
