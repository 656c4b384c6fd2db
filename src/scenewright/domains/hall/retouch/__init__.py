"""Retouching: what a planner sets right once everything stands.

Each touch is a row: it counts a fault in metres and proposes layouts with less of it. One verdict
weighs the energy and the faults of all rows, one loop (:mod:`.loop`) keeps what is better by it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from scenewright.core.layout import Boxes
from scenewright.core.passes import ALL_PASSES, Pass, PassChange, PassOptions, PassRun
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch.audience import propose_audiences, sit_aside
from scenewright.domains.hall.retouch.bands import measure_bands, propose_bands
from scenewright.domains.hall.retouch.banquets import measure_banquets, propose_banquets
from scenewright.domains.hall.retouch.bare import find_floor, measure_bare, propose_moves
from scenewright.domains.hall.retouch.columns import find_columns, propose_pitches, stand_in_aisles
from scenewright.domains.hall.retouch.desk_groups import find_desks, first_desks, other_desks
from scenewright.domains.hall.retouch.desks import desks_adrift, propose_desks
from scenewright.domains.hall.retouch.exhibit import (
    charge_hiding,
    find_exhibit,
    find_placed,
    propose_places,
    stand_aside,
)
from scenewright.domains.hall.retouch.gates import (
    find_gates,
    forgive_doors,
    gates_adrift,
    propose_gates,
)
from scenewright.domains.hall.retouch.lecterns import lecterns_adrift, propose_lecterns
from scenewright.domains.hall.retouch.loop import Show, list_runs, mend_layout
from scenewright.domains.hall.retouch.mending import Retouch, SeenTouch
from scenewright.domains.hall.retouch.queues import measure_queues, propose_queues
from scenewright.domains.hall.retouch.ropes import propose_ropes, ropes_adrift
from scenewright.domains.hall.retouch.row_moves import (
    fill_free,
    hold_rows,
    nudge_or_slide,
    set_among_columns,
    turn_aside,
    turn_round,
)
from scenewright.domains.hall.retouch.runs import measure_runs, propose_runs
from scenewright.domains.hall.retouch.spread import measure_spread, propose_spread
from scenewright.domains.hall.retouch.tills import find_tills, propose_tills, tills_adrift
from scenewright.domains.hall.retouch.waiting import forgive_backs, measure_waiting, propose_waiting
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.engine.draws import streams

LEFT = "faults left"
"""What is heard last: the metres of fault that no touch has mended, less than 0."""


def _whole(problem: HallProblem) -> HallProblem:
    return problem


RETOUCHES: tuple[Pass[Retouch], ...] = (
    Pass(
        "columns",
        "rows",
        Retouch(find_columns, stand_in_aisles, propose_pitches),
        "columns stand in the lines of rows, not in their aisles",
    ),
    Pass(
        "audience",
        "seating",
        Retouch(_whole, sit_aside, propose_audiences),
        "an audience sits on the axis of its stage, in sight of it",
    ),
    Pass(
        "banquets",
        "seating",
        Retouch(_whole, measure_banquets, propose_banquets),
        "tables stand before the stage of their zone",
    ),
    Pass(
        "lecterns",
        "seating",
        Retouch(_whole, lecterns_adrift, propose_lecterns),
        "a lectern stands at the side of what is shown",
    ),
    Pass(
        "bands",
        "rows",
        Retouch(_whole, measure_bands, propose_bands),
        "a stage nobody has a seat before stands at the middle of a wall",
    ),
    Pass(
        "exhibit",
        "exhibits",
        Retouch(find_exhibit, stand_aside, propose_places, charge_hiding, find_placed),
        "the main exhibit stands in the middle of its zone or on the axis of the entrance",
    ),
    Pass(
        "stands",
        "exhibits",
        hold_rows("stand_away", moves=(turn_round,)),
        "stands turn their fronts to the entrance",
    ),
    Pass(
        "gates",
        "service",
        Retouch(_whole, gates_adrift, propose_gates, forgive_doors, find_gates),
        "gates stand across the way they control",
    ),
    Pass(
        "desks",
        "service",
        Retouch(first_desks, desks_adrift, propose_desks, place=find_desks),
        "the first desk stands at a wall beside the way in",
    ),
    Pass(
        "counters",
        "service",
        Retouch(other_desks, desks_adrift, propose_desks, place=find_desks),
        "counters stand at walls with room for staff",
    ),
    Pass(
        "waiting",
        "seating",
        Retouch(_whole, measure_waiting, propose_waiting, forgive_backs),
        "who waits sits near a desk, on its visitors' side",
    ),
    Pass(
        "tills",
        "service",
        Retouch(_whole, tills_adrift, propose_tills, place=find_tills),
        "tills stand across the flow before a way out",
    ),
    Pass(
        "queues",
        "service",
        Retouch(_whole, measure_queues, propose_queues, make_room=False),
        "floor before tills is free to queue on",
    ),
    Pass(
        "ropes",
        "service",
        Retouch(_whole, ropes_adrift, propose_ropes),
        "ropes guide to the desk people queue at",
    ),
    Pass(
        "gazes",
        "seating",
        hold_rows("seats_look_at_wall", "seat_back", moves=(turn_round, turn_aside)),
        "lounge seats look into the hall, not at a wall close before, and turn no back to a door",
    ),
    Pass(
        "bare",
        "floor",
        Retouch(find_floor, measure_bare, propose_moves),
        "no large circle of floor is empty",
    ),
    Pass(
        "spread",
        "floor",
        Retouch(find_columns, measure_spread, propose_spread, make_room=False),
        "groups take all of their zone",
    ),
    Pass(
        "runs",
        "rows",
        Retouch(_whole, measure_runs, propose_runs, make_room=False),
        "rows too long to walk round get aisles",
    ),
    Pass(
        "outer rows",
        "rows",
        hold_rows("slot_before_rows", "slot_behind_rows", moves=(fill_free,), make_room=False),
        "an aisle lies between outer rows and the wall",
    ),
    Pass(
        "nearness",
        "exhibits",
        hold_rows(
            "exhibit_at_column",
            "seat_crowded",
            moves=(nudge_or_slide, set_among_columns),
            make_room=False,
        ),
        "exhibits and seats keep clear of columns and other groups",
    ),
)
"""What is heard of them is in this order."""
_BY_NAME = {each.name: each.run for each in RETOUCHES}


def retouch_named(name: str) -> Retouch:
    """The touch of a row of :data:`RETOUCHES`."""
    return _BY_NAME[name]


def retouch_layout(
    problem: HallProblem,
    layout: MeasuredLayout,
    passes: PassOptions = ALL_PASSES,
    space: str = "",
    show: Show | None = None,
) -> MeasuredLayout:
    """A layout of patterns with as little of each fault as it costs no more to mend; ``passes``
    switches touches off or hears what each changed in the hall ``space``; ``show`` gets the purpose
    of each change as it is made, and what makes the boxes that stand then."""
    if layout.loose or not len(layout.boxes) or passes.cancelled():
        return layout
    made = [each for each in RETOUCHES if not {each.name, each.group} & passes.off]
    touches = {each.name: SeenTouch(each.run, each.run.look(problem)) for each in made}
    told = None if show is None else partial(_tell_purpose, show)
    mended = mend_layout(problem, layout.kept, touches, passes.cancelled, told)
    if mended.found.steps:
        layout = layout_of(begin_chain(problem, mended.found.state, streams(0, 1)[0]))
    if passes.hear is not None:
        for run in list_runs(mended, space):
            passes.hear(run)
        left = PassChange(space, 0.0, -measure_faults(problem, layout), 0)
        passes.hear(PassRun(LEFT, 0.0, (left,)))
    return layout


def _tell_purpose(show: Show, name: str, boxes: Callable[[], Boxes]) -> None:
    purpose = next(each.purpose for each in RETOUCHES if each.name == name)
    show(f"{name}: {purpose}", boxes)


def measure_faults(problem: HallProblem, layout: MeasuredLayout) -> float:
    """Metres of all faults of a layout, whether their touches are made or not."""
    seen = (SeenTouch(each.run, each.run.look(problem)) for each in RETOUCHES)
    return sum(one.fault(layout.kept, layout.boxes) for one in seen)
