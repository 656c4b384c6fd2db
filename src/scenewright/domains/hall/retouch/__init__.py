"""Retouching: what a planner sets right once everything stands.

Each touch counts a fault in metres and proposes layouts with less of it. The one of them that costs
least, its fault included, is kept if the route misses no more and no passage narrows.
"""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.core.passes import ALL_PASSES, Pass, PassChange, PassOptions, PassRun, run_passes
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch.audience import propose_audiences, sit_aside
from scenewright.domains.hall.retouch.bands import measure_bands, propose_bands
from scenewright.domains.hall.retouch.banquets import measure_banquets, propose_banquets
from scenewright.domains.hall.retouch.bare import find_floor, measure_bare, propose_moves
from scenewright.domains.hall.retouch.columns import (
    find_columns,
    forgive_columns,
    propose_pitches,
    stand_in_aisles,
)
from scenewright.domains.hall.retouch.companies import measure_apart, propose_companies
from scenewright.domains.hall.retouch.desks import (
    desks_adrift,
    find_desks,
    first_desks,
    forgive_walls,
    mind_order,
    other_desks,
    propose_desks,
)
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
from scenewright.domains.hall.retouch.gazes import measure_gazes, propose_views
from scenewright.domains.hall.retouch.lecterns import lecterns_adrift, propose_lecterns
from scenewright.domains.hall.retouch.mending import LEAST, Retouch, SeenTouch, mend
from scenewright.domains.hall.retouch.nearness import (
    find_company,
    measure_nearness,
    propose_distances,
)
from scenewright.domains.hall.retouch.outer_rows import measure_slots, propose_lines
from scenewright.domains.hall.retouch.queues import measure_queues, propose_queues
from scenewright.domains.hall.retouch.ropes import forgive_queues, propose_ropes, ropes_adrift
from scenewright.domains.hall.retouch.runs import measure_runs, propose_runs
from scenewright.domains.hall.retouch.spread import measure_spread, propose_spread
from scenewright.domains.hall.retouch.stands import measure_backs, propose_turns
from scenewright.domains.hall.retouch.tills import find_tills, propose_tills, tills_adrift
from scenewright.domains.hall.retouch.waiting import forgive_backs, measure_waiting, propose_waiting
from scenewright.domains.hall.solvers.outcome import MeasuredLayout

ROUNDS = 4
"""How often a touch is made at most: each proposal changes one group."""
LEFT = "faults left"
"""What is heard last: the metres of fault that no touch has mended, less than 0."""


def _whole(problem: HallProblem) -> HallProblem:
    return problem


RETOUCHES: tuple[Pass[Retouch], ...] = (
    Pass(
        "columns",
        "rows",
        Retouch(find_columns, stand_in_aisles, propose_pitches, forgive_columns),
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
        "bands",
        "rows",
        Retouch(_whole, measure_bands, propose_bands),
        "a stage nobody has a seat before stands amid a wall",
    ),
    Pass(
        "lecterns",
        "seating",
        Retouch(_whole, lecterns_adrift, propose_lecterns),
        "a lectern stands at the side of what is shown",
    ),
    Pass(
        "exhibit",
        "exhibits",
        Retouch(find_exhibit, stand_aside, propose_places, charge_hiding, find_placed),
        "the main exhibit stands amid its zone or on the axis of the entrance",
    ),
    Pass(
        "stands",
        "exhibits",
        Retouch(_whole, measure_backs, propose_turns),
        "stands show who comes in their fronts",
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
        Retouch(first_desks, desks_adrift, propose_desks, mind_order, find_desks),
        "the first desk stands at a wall beside the way in",
    ),
    Pass(
        "counters",
        "service",
        Retouch(other_desks, desks_adrift, propose_desks, forgive_walls, find_desks),
        "counters stand at walls with room for who serves",
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
        Retouch(_whole, tills_adrift, propose_tills, mind_order, find_tills),
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
        Retouch(_whole, ropes_adrift, propose_ropes, forgive_queues),
        "ropes guide to the desk people queue at",
    ),
    Pass(
        "gazes",
        "seating",
        Retouch(_whole, measure_gazes, propose_views),
        "lounge seats look into the hall, not at a wall close before",
    ),
    Pass(
        "companies",
        "seating",
        Retouch(_whole, measure_apart, propose_companies),
        "lounge seats stand round low tables",
    ),
    Pass(
        "bare",
        "floor",
        Retouch(find_floor, measure_bare, propose_moves),
        "no large circle of floor is empty",
    ),
    Pass(
        "runs",
        "rows",
        Retouch(_whole, measure_runs, propose_runs, make_room=False),
        "rows too long to walk round get aisles",
    ),
    Pass(
        "spread",
        "floor",
        Retouch(find_columns, measure_spread, propose_spread, make_room=False),
        "groups take all of their zone",
    ),
    Pass(
        "outer rows",
        "rows",
        Retouch(_whole, measure_slots, propose_lines, make_room=False),
        "an aisle lies between outer rows and the wall",
    ),
    Pass(
        "nearness",
        "exhibits",
        Retouch(find_company, measure_nearness, propose_distances, make_room=False),
        "exhibits and seats keep clear of columns and other groups",
    ),
)
"""In the order in which they are made."""
_BY_NAME = {each.name: each.run for each in RETOUCHES}


def retouch_named(name: str) -> Retouch:
    """The touch of a row of :data:`RETOUCHES`."""
    return _BY_NAME[name]


def retouch_layout(
    problem: HallProblem, layout: MeasuredLayout, passes: PassOptions = ALL_PASSES, space: str = ""
) -> MeasuredLayout:
    """A layout of patterns with as little of each fault as it costs no more to mend; ``passes``
    switches touches off or hears what each changed in the hall ``space``."""
    if layout.loose or not len(layout.boxes):
        return layout
    made = [each for each in RETOUCHES if not {each.name, each.group} & passes.off]
    touches = [SeenTouch(each.run, each.run.look(problem)) for each in made]
    numbers = {id(each.run): number for number, each in enumerate(made)}

    def apply(touch: Retouch, now: MeasuredLayout) -> MeasuredLayout:
        return _touch_up(problem, now, touches, numbers[id(touch)])

    def compare(before: MeasuredLayout, after: MeasuredLayout) -> Iterator[PassChange]:
        if after is not before:
            old, new = (measure_faults(problem, each) for each in (before, after))
            yield PassChange(space, before.energy - after.energy, old - new, 0)

    layout = run_passes(made, layout, passes, apply, compare)
    if passes.hear is not None:
        left = PassChange(space, 0.0, -measure_faults(problem, layout), 0)
        passes.hear(PassRun(LEFT, 0.0, (left,)))
    return layout


def measure_faults(problem: HallProblem, layout: MeasuredLayout) -> float:
    """Metres of all faults of a layout, whether their touches are made or not."""
    seen = (SeenTouch(each.run, each.run.look(problem)) for each in RETOUCHES)
    return sum(one.fault(layout) for one in seen)


def _touch_up(
    problem: HallProblem, layout: MeasuredLayout, touches: list[SeenTouch], number: int
) -> MeasuredLayout:
    """The layout with one of the touches made as often as it helps."""
    for _ in range(ROUNDS):
        if touches[number].fault(layout) <= LEAST:
            break
        before, layout = layout, mend(problem, layout, touches, number)
        if layout is before:
            break
    return layout
