"""What a planner sets right once everything has found a place: seats, the main exhibit, details."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from scenewright.core.layout import REPAIR, Boxes
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.retouch import retouch_layout
from scenewright.domains.hall.retouch.place_exhibit import place_exhibit
from scenewright.domains.hall.search import HallSearch, show_objects
from scenewright.domains.hall.seats.seat_audiences import seat_audiences
from scenewright.domains.hall.solvers.outcome import MeasuredLayout


def compose(
    search: HallSearch, fitted: Fitted, layout: MeasuredLayout, missing: tuple[LeftOut, ...]
) -> tuple[Fitted, MeasuredLayout, tuple[LeftOut, ...]]:
    """The layout with seats before what they look at, its main exhibit in its place and what
    retouching mends, and what is ``missing`` with the seats that no rows hold."""
    if search.passes.cancelled():
        return fitted, layout, missing

    def show(reason: str, boxes: Callable[[], Boxes]) -> None:
        show_objects(search, fitted, boxes, REPAIR, reason)

    before = layout
    fitted, layout, unseated = seat_audiences(search, fitted, layout)
    if layout is not before:
        show("seats stand before what they look at", partial(_boxes, layout))
    before, layout = layout, place_exhibit(search, fitted, layout)
    if layout is not before:
        show("the main exhibit stands in its place", partial(_boxes, layout))
    space = search.hall.space.id
    layout = retouch_layout(fitted.problem, layout, search.passes, space, show)
    return fitted, layout, (*missing, *unseated)


def _boxes(layout: MeasuredLayout) -> Boxes:
    return layout.boxes
