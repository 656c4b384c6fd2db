"""Seats for three in a living room that has fewer, at places past which one walks.

Of the better forms only a few are tried where they cost least, and in a narrow room all of these
may bar a way; a sofa for three with a side table may still have a place elsewhere.
"""

from __future__ import annotations

from scenewright.domains.home.attempt import RoomTask
from scenewright.domains.home.composing.case_faults import MANY, count_seats
from scenewright.domains.home.composing.forms import SEATS_FROM, list_forms
from scenewright.domains.home.composing.judging import JudgedRoom, judge_of
from scenewright.domains.home.composing.placed_faults import measure_before_doors
from scenewright.domains.home.composing.trials import take_best
from scenewright.domains.home.composing.walked_places import try_places
from scenewright.domains.home.groups.living import plain_sofa

SEATED_FROM = 11.0
"""From so many square metres on a living room has seats for three where that costs little."""
WORTH = 4.8
"""What they are worth in a room that is not roomy: less than what stands before a wide door."""


def seat_three(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with a sofa for three, or more seats, in a room from :data:`SEATED_FROM` square
    metres on that has fewer, before no more of a wide door than now, or as they were."""
    at = next((i for i, p in enumerate(best.placed) if p.wish.group == "seating"), None)
    if at is None or task.ground.area < SEATED_FROM or task.cancelled():
        return best
    seats, own = best.placed[at], task.library.own
    if seats.wish.group in own or count_seats(seats.dressed.case) >= MANY:
        return best
    forms = (f for f in (*list_forms(task, seats), plain_sofa()) if count_seats(f) >= MANY)
    worth = WORTH if task.ground.area < SEATS_FROM else 0.0
    most = best.cost + worth - task.preset.settings.composing.least
    found = try_places(judge_of(task, best.placed), best.placed, at, forms, most)
    metres = measure_before_doors(seats, task.ground)
    free = (j for j in found if measure_before_doors(j.placed[at], task.ground) <= metres)
    return take_best(task, best, free, barred, -worth)
