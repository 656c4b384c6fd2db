"""Where seats stand before a screen or a fireplace: the places of the screen along the walls, and
those of the seats that look at it from the distance its width asks for, free-standing if need be.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, islice
from math import atan2, cos, pi, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import SOFAS
from scenewright.core.catalog import Group, Member
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.case_faults import MANY, count_seats, is_hung
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, RoomJudge
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.composing.places.moving import dress_group, find_places
from scenewright.domains.home.composing.views import cost_of_view
from scenewright.domains.home.furnishing.obstacles import StandingObstacles, flat_kinds, standing_of
from scenewright.domains.home.furnishing.whole import list_grounded
from scenewright.domains.home.grounds.wall_places import stand_free
from scenewright.domains.home.measures import ROUNDING

Floats = NDArray[np.float64]

AWAY = (2.1, 2.5, 2.9)  # from the screen to the sofa, metres
FIRE_TO_SOFA = (1.8, 2.2, 2.6)  # from the front of a fireplace to it
FIRE_TO_SOFA_ACROSS = 3.6  # to a sofa with its back at the wall across, at most
SPACED = 0.8  # between places of the screen that are tried, metres
STANDS, HUNG, SCREENS, SEATS = 4, 1, 6, 10
"""Forms of the screen on stands and on walls, places of each, and forms of the seats that are
tried."""
SEATED = 8  # places of the seats before one place of a screen
TWO, SMALL, BLIND = 2, 4, 22.0
"""Seats that are enough where those of the room see nothing of the screen, how many of the smallest
forms are tried there, and what that costs."""
UNLIKE = 0.15  # forms that differ by more than this in width or depth are unlike, metres


def list_lounges(judge: RoomJudge, pair: Placed) -> Iterator[JudgedRoom]:
    """Screen and seats by themselves, the cheapest first, or the seats before a fireplace; seats
    that see nothing of the screen may be fewer elsewhere."""
    task, seating = judge.task, pair[-1]
    blind = cost_of_view(pair, task.preset.settings.composing.costs) > BLIND
    least = min(count_seats(seating.dressed.case), TWO if blind else MANY)
    known = (form for form in list_forms(task, seating) if count_seats(form) >= least)
    seats = list(_pick_unlike(known, UNLIKE))
    if blind:
        small = sorted(seats[SEATS - SMALL :], key=lambda form: form.width * form.depth)
        seats[SEATS - SMALL :] = small
    seats = seats[:SEATS]
    found = [
        judged
        for screen, spot in _list_spots(task, pair[:-1])
        for judged in _seat_before(judge, screen, spot, seating, seats)
    ]
    yield from sorted(found, key=lambda judged: judged.cost)


def _list_spots(task: RoomTask, screens: Placed) -> Iterator[tuple[Placed, Floats]]:
    """What seats may look at: the screen at its places, each as it stands there with its box, or
    the fireplaces of the room, which need no group."""
    if not screens:
        for x, y, c, s in task.ground.hearths:
            yield (), np.array([x, y, atan2(s, c)])
        return
    empty = standing_of((*task.fixed, *task.beside), flat_kinds(task.catalog))
    forms = list(list_forms(task, screens[0]))
    kinds = ([f for f in forms if is_hung(f) == hung] for hung in (False, True))
    stands, hung = (_pick_unlike(iter(kind), 2 * UNLIKE) for kind in kinds)
    each = ((stands, STANDS), (hung, HUNG))
    places = (islice(find_places(task, some, empty, screens[0]), most) for some, most in each)
    for case, boxes in chain.from_iterable(places):
        for box in _space_out(boxes):
            screen = dress_group(task, screens[0], case, box, empty)
            if screen is not None:
                yield (screen,), screen.dressed.box[:3]


def _pick_unlike(forms: Iterator[Group], unlike: float) -> Iterator[Group]:
    """The forms that differ in size, or in where the main piece is, from all before them."""
    kept: list[tuple[float, float, float]] = []
    for form in forms:
        size = (form.width, form.depth, form.members[0].x)
        if all(max(abs(a - b) for a, b in zip(size, k, strict=True)) > unlike for k in kept):
            kept.append(size)
            yield form


def _space_out(boxes: Floats) -> list[Floats]:
    """At most :data:`SCREENS` of the boxes (n, 5) of a screen, :data:`SPACED` metres apart."""
    kept, left = list[Floats](), np.ones(len(boxes), bool)
    while left.any():
        kept.append(boxes[left.argmax()])
        left &= np.hypot(*(boxes[:, :2] - kept[-1][:2]).T) >= SPACED
    return kept[:: -(-len(kept) // SCREENS) or 1]


def _seat_before(
    judge: RoomJudge, screen: Placed, spot: Floats, seating: FurnishedGroup, forms: list[Group]
) -> list[JudgedRoom]:
    """The seats in the forms and at the distances that cost least before a ``spot`` (x, y, heading)
    of a screen, in each form before a fireplace; empty where they stand nowhere before it."""
    task = judge.task
    pieces = (*task.fixed, *task.beside, *(piece for group in screen for piece in group.pieces))
    standing = standing_of(pieces, flat_kinds(task.catalog))
    found = []
    for case in forms:
        boxes = _look_at(spot, case, _list_distances(task, spot, case) if screen else FIRE_TO_SOFA)
        boxes = boxes[_stand(task, case, boxes, standing)]
        seated = (dress_group(task, seating, case, box, standing) for box in boxes)
        each = judge.cost_each([(*screen, seats) for seats in seated if seats is not None])
        found += sorted(each, key=lambda judged: judged.cost)[: len(boxes) if screen else 1]
    return sorted(found, key=lambda judged: judged.cost)[:SEATED] if screen else found


def _list_distances(task: RoomTask, spot: Floats, case: Group) -> tuple[float, ...]:
    """How far from a spot (x, y, heading) of a screen seats are tried: at :data:`AWAY`, and with
    their back at the wall across where that is no farther than :data:`FIRE_TO_SOFA_ACROSS`."""
    sofa = _find_sofa(case)
    across = _measure_across(spot, task.ground.walls) - sofa.y - case.depth / 2
    near = all(abs(across - away) > UNLIKE for away in AWAY)
    return (*AWAY, across) if AWAY[0] / 2 < across < FIRE_TO_SOFA_ACROSS and near else AWAY


def _measure_across(spot: Floats, walls: Floats) -> float:
    """Metres from a spot (x, y, heading) straight ahead to the next of walls (w, 4)."""
    (x, y), ahead = spot[:2], np.array([cos(spot[2]), sin(spot[2])])
    ways, starts = walls[:, 2:] - walls[:, :2], walls[:, :2] - (x, y)
    turn = ahead[0] * ways[:, 1] - ahead[1] * ways[:, 0]
    turn = np.where(np.abs(turn) < ROUNDING, np.inf, turn)
    reach = (starts[:, 0] * ways[:, 1] - starts[:, 1] * ways[:, 0]) / turn
    share = (starts[:, 0] * ahead[1] - starts[:, 1] * ahead[0]) / turn
    met = (share >= 0.0) & (share <= 1.0) & (reach > UNLIKE)
    return float(reach[met].min(initial=np.inf))


def _find_sofa(case: Group) -> Member:
    return next((m for m in case.members if m.category in SOFAS), case.members[0])


def _look_at(spot: Floats, case: Group, distances: tuple[float, ...]) -> Floats:
    """Boxes (n, 5) of seats whose sofa looks straight at a spot from each of the distances."""
    x, y, heading = spot.tolist()
    sofa = _find_sofa(case)
    facing = heading + pi
    rows = []
    for away in distances:
        ahead = away + sofa.y
        rows.append(
            (
                x + cos(heading) * ahead - sin(facing) * sofa.x,
                y + sin(heading) * ahead + cos(facing) * sofa.x,
                facing,
                case.width,
                case.depth,
            )
        )
    return np.array(rows)


def _stand(
    task: RoomTask, case: Group, boxes: Floats, standing: StandingObstacles
) -> NDArray[np.bool_]:
    """On which of the boxes (n, 5) all of a case stands free."""
    height = task.space.height
    return stand_free(boxes, case, list_grounded(case), task.ground, standing, task.catalog, height)
