"""A plan as drawn: a sheet of paper with named layers of marks, the lowest first."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from scenewright.drawing.marks import Definition, Mark, PaperView, group, is_blank
from scenewright.drawing.sheet import PaperSheet


class PlanLayer(NamedTuple):
    """What can be shown or hidden separately: a name people read, and a mark."""

    name: str
    mark: Mark


class PlanDrawing(NamedTuple):
    """A plan to print, of any kind of scene: its name, the sheet, what is defined once, and its
    layers in the order they are drawn. ``view`` takes the plan's metres to this sheet, where one
    does for all that is drawn."""

    name: str
    sheet: PaperSheet
    definitions: tuple[Definition, ...]
    layers: tuple[PlanLayer, ...]
    view: PaperView | None = None


def merge_layers(parts: Iterable[Sequence[PlanLayer]]) -> tuple[PlanLayer, ...]:
    """The layers of drawings that lie beside each other on a sheet, each name once: storeys and
    sites share their layers. A layer keeps its place in the order; the empty are left out.

    >>> from scenewright.drawing.marks import NOTHING, line
    >>> one, two = [PlanLayer(n, line([(0, 0), (1, 0)])) for n in ("Floors", "Walls")]
    >>> doors = PlanLayer("Doors", NOTHING)
    >>> [layer.name for layer in merge_layers([[one, two], [one, doors, two]])]
    ['Floors', 'Walls']
    """
    merged: dict[str, list[Mark]] = {}
    for layer in (layer for part in parts for layer in part):
        merged.setdefault(layer.name, []).append(layer.mark)
    found = [PlanLayer(name, group(marks)) for name, marks in merged.items()]
    return tuple(layer for layer in found if not is_blank(layer.mark))
