"""What a planner sets right once everything has found a place: seats, the main exhibit, details."""

from __future__ import annotations

from scenewright.core.solution import LeftOut
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.retouch import retouch_layout
from scenewright.domains.hall.retouch.place_exhibit import place_exhibit
from scenewright.domains.hall.search import HallSearch
from scenewright.domains.hall.seats.seat_audiences import seat_audiences
from scenewright.domains.hall.solvers.outcome import MeasuredLayout


def compose(
    search: HallSearch, fitted: Fitted, layout: MeasuredLayout, missing: tuple[LeftOut, ...]
) -> tuple[Fitted, MeasuredLayout, tuple[LeftOut, ...]]:
    """The layout with seats before what they look at, its main exhibit in its place and what
    retouching mends, and what is ``missing`` with the seats that no rows hold."""
    if search.passes.cancelled():
        return fitted, layout, missing
    fitted, layout, unseated = seat_audiences(search, fitted, layout)
    layout = place_exhibit(search, fitted, layout)
    layout = retouch_layout(fitted.problem, layout, search.passes, search.hall.space.id)
    return fitted, layout, (*missing, *unseated)
