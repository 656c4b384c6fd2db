"""Retouching: what a planner sets right once everything stands.

Each touch counts a fault in metres and proposes layouts with less of it. The one of them that costs
least, its fault included, is kept if the route misses no more and no passage narrows.
"""

from __future__ import annotations

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
from scenewright.domains.hall.retouch.parted import measure_parted, propose_sides
from scenewright.domains.hall.retouch.poufs import forgive_poufs, measure_fences, propose_circles
from scenewright.domains.hall.retouch.queues import measure_queues, propose_queues
from scenewright.domains.hall.retouch.rings import propose_rings, rings_off
from scenewright.domains.hall.retouch.ropes import forgive_queues, propose_ropes, ropes_adrift
from scenewright.domains.hall.retouch.runs import measure_runs, propose_runs
from scenewright.domains.hall.retouch.seats import propose_rows, sit_too_near
from scenewright.domains.hall.retouch.seatways import (
    forgive_floor,
    measure_seatways,
    propose_seatways,
)
from scenewright.domains.hall.retouch.spread import measure_spread, propose_spread
from scenewright.domains.hall.retouch.square import measure_askew, propose_squared
from scenewright.domains.hall.retouch.stands import measure_backs, propose_turns
from scenewright.domains.hall.retouch.tills import find_tills, propose_tills, tills_adrift
from scenewright.domains.hall.retouch.waiting import forgive_backs, measure_waiting, propose_waiting
from scenewright.domains.hall.solvers.outcome import MeasuredLayout

ROUNDS = 4
"""How often a touch is made at most: each proposal changes one group."""


def _whole(problem: HallProblem) -> HallProblem:
    return problem


RETOUCHES: dict[str, Retouch] = {
    "columns": Retouch(find_columns, stand_in_aisles, propose_pitches, forgive_columns),
    "audience": Retouch(_whole, sit_aside, propose_audiences),
    "banquets": Retouch(_whole, measure_banquets, propose_banquets),
    "bands": Retouch(_whole, measure_bands, propose_bands),
    "seats": Retouch(_whole, sit_too_near, propose_rows),
    "lecterns": Retouch(_whole, lecterns_adrift, propose_lecterns),
    "exhibit": Retouch(find_exhibit, stand_aside, propose_places, charge_hiding, find_placed),
    "rings": Retouch(_whole, rings_off, propose_rings),
    "stands": Retouch(_whole, measure_backs, propose_turns),
    "gates": Retouch(_whole, gates_adrift, propose_gates, forgive_doors, find_gates),
    "desks": Retouch(first_desks, desks_adrift, propose_desks, mind_order, find_desks),
    "counters": Retouch(other_desks, desks_adrift, propose_desks, forgive_walls, find_desks),
    "waiting": Retouch(_whole, measure_waiting, propose_waiting, forgive_backs),
    "tills": Retouch(_whole, tills_adrift, propose_tills, mind_order, find_tills),
    "queues": Retouch(_whole, measure_queues, propose_queues, make_room=False),
    "ropes": Retouch(_whole, ropes_adrift, propose_ropes, forgive_queues),
    "parted": Retouch(_whole, measure_parted, propose_sides, make_room=False),
    "poufs": Retouch(_whole, measure_fences, propose_circles, forgive_poufs, make_room=False),
    "gazes": Retouch(_whole, measure_gazes, propose_views),
    "companies": Retouch(_whole, measure_apart, propose_companies),
    "bare": Retouch(find_floor, measure_bare, propose_moves),
    "runs": Retouch(_whole, measure_runs, propose_runs, make_room=False),
    "spread": Retouch(find_columns, measure_spread, propose_spread, make_room=False),
    "outer rows": Retouch(_whole, measure_slots, propose_lines, make_room=False),
    "seatways": Retouch(_whole, measure_seatways, propose_seatways, forgive_floor),
    "square": Retouch(_whole, measure_askew, propose_squared, make_room=False),
    "nearness": Retouch(find_company, measure_nearness, propose_distances, make_room=False),
}
"""In the order in which they are made."""


def retouch_layout(problem: HallProblem, layout: MeasuredLayout) -> MeasuredLayout:
    """A layout of patterns with as little of each fault as it costs no more to mend."""
    if layout.loose or not len(layout.boxes):
        return layout
    touches = [SeenTouch(touch, touch.look(problem)) for touch in RETOUCHES.values()]
    for number, one in enumerate(touches):
        for _ in range(ROUNDS):
            if one.fault(layout) <= LEAST:
                break
            before, layout = layout, mend(problem, layout, touches, number)
            if layout is before:
                break
    return layout
