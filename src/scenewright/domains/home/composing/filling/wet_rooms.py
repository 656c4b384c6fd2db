"""Bathrooms and washrooms once they stand: machines, cabinets and baskets in their niches.

In a tight room the search ends with the smallest forms, wherever they fit. Here a machine of
0.48 m becomes one of 0.6 m, and a cabinet goes where it touches its neighbours on both sides, as
wide as that niche, where nothing else has to move and no way is barred.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from itertools import groupby
from math import hypot
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.composing.filling.beside_others import (
    list_others,
    list_taken_beside,
    take_first_place,
)
from scenewright.domains.home.composing.places.flush import WIDEST
from scenewright.domains.home.composing.places.moving import stand_at
from scenewright.domains.home.composing.places.wall_stretch import (
    FreeStretch,
    find_stretch,
    list_free_stretches,
    measure_front,
)
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.groups.bath import (
    basket,
    fitted_cabinets,
    fitted_closets,
    fitted_machines,
)
from scenewright.domains.home.measures import HAIR
from scenewright.domains.home.problem import Ground

Floats = NDArray[np.float64]

ROOMS = frozenset(("bathroom", "washroom"))


class Movable(NamedTuple):
    """Forms of what may stand anywhere in a bathroom, and what a metre of width is worth."""

    forms: Callable[[], Iterator[Group]]
    gain: float


MOVED = {
    "washer": Movable(fitted_machines, 2.0),
    "linen": Movable(fitted_cabinets, 0.5),
    "wardrobe": Movable(fitted_closets, 0.5),
    "basket": Movable(basket, 0.0),
}
"""By group, in the order in which they are moved; a machine once more when all others stand."""
TOUCHES_WITHIN = 0.06  # a side nearer than this to a wall or a neighbour touches it, metres
TOUCHING = 0.15  # what a side that touches something is worth
SLOT = 0.5  # what a metre of slots beside it costs
FRONT = 0.5  # free before what is used from its front, metres
PAST, STAND = 0.2, 0.55  # how far past its front a neighbour may end; room to stand, metres
HUNG = 1.0  # what hangs higher is no bar, metres
LESS, TALL = 0.2, 0.6  # steps between widths that are tried, and the least of them, metres
TRIED = 16  # places that are furnished
BETTER = 0.05  # by how much a place is better at least


class Niche(NamedTuple):
    """A form on a box (5,), and what it is worth there."""

    form: Group
    box: Floats
    worth: float


def fill_wet_room(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer for a room with its machine, its cabinet and its basket in larger forms or in
    niches, where that bars no way."""
    if not ROOMS.intersection(task.space.functions):
        return answer
    for name in (*MOVED, "washer"):
        for group in answer.placed:
            fits = group.wish.group == name and len(group.pieces) == 1
            if fits and group.wish.most is None and not task.cancelled():
                placed, standing = answer.placed, list_others(task, answer.placed, group)
                taken = list_taken_beside(task, placed, group, standing)
                found = _list_niches(task, group, standing, taken)
                placed = take_first_place(task, placed, group, found, standing, barred, tried=TRIED)
                answer = answer._replace(placed=placed)
    return answer


@cache
def _list_forms(name: str) -> tuple[tuple[Group, ...], ...]:
    """The forms of a group by their depth, the shallowest first, of each the widest first."""
    forms = sorted(MOVED[name].forms(), key=lambda form: (form.depth, -form.width))
    return tuple(tuple(alike) for _, alike in groupby(forms, key=lambda form: form.depth))


def _list_niches(
    task: RoomTask, group: FurnishedGroup, standing: StandingObstacles, taken: Floats
) -> Iterator[tuple[Group, Floats]]:
    """Where a group is worth more than where it stands, on free floor, the best first."""
    name, (x, y, _, width, depth) = group.wish.group, group.dressed.box.tolist()
    here = find_stretch(task.ground, group.dressed.box, depth, taken)
    now = 0.0
    if here is not None:
        now = float(_measure_worth(name, here, np.array([here.at - width / 2]), width)[0])
    found: list[Niche] = []
    for forms in _list_forms(name):
        for stretch in list_free_stretches(task.ground, forms[-1].depth, taken, forms[-1].width):
            for form in _pick_forms(forms, stretch.length):
                starts = np.array([0.0, stretch.length - form.width])
                worth = _measure_worth(name, stretch, starts, form.width)
                if worth.max() > now + BETTER:
                    boxes = stretch.boxes_at(starts, form)
                    found += [Niche(form, b, w) for b, w in zip(boxes, worth.tolist(), strict=True)]
    found = [niche for niche in found if niche.worth > now + BETTER]
    found.sort(key=lambda n: (-round(n.worth, 2), hypot(n.box[0] - x, n.box[1] - y)))
    for niche in found:
        free = len(stand_at(task, niche.form, niche.box[None], standing))
        if free and can_stand_before(task.ground, niche.box, standing):
            yield niche.form, niche.box


def _pick_forms(forms: tuple[Group, ...], length: float) -> list[Group]:
    """Of ``forms``, the widest first: the widest that fits ``length`` metres, then ones narrower
    by :data:`LESS` each down to :data:`TALL`, as the widest may bar what others do not."""
    widest = next(form for form in forms if form.width <= length)
    narrower = (widest.width - k * LESS for k in range(1, 4))
    wanted = [wide for wide in narrower if wide >= TALL - HAIR]
    return [widest, *(next(f for f in forms if f.width <= wide + HAIR) for wide in wanted)]


def can_stand_before(ground: Ground, box: Floats, standing: StandingObstacles) -> bool:
    """Whether one can stand before a box (5,): no wall is near, and its neighbours do not
    end far beyond its front."""
    depth, low = float(box[4]), standing.spans[:, 0] < HUNG
    before = find_stretch(ground, box, depth + FRONT, standing.boxes[low], depth + PAST)
    wide = before is not None and before.length >= STAND
    return wide and measure_front(ground, box) >= FRONT


def _measure_worth(name: str, stretch: FreeStretch, starts: Floats, width: float) -> Floats:
    """What places (n,) along a stretch are worth to a group of ``width``: its width, the sides that
    touch something, less the slots beside it."""
    gaps = np.column_stack([starts, stretch.length - width - starts])
    slots = np.where((gaps > TOUCHES_WITHIN) & (gaps < WIDEST), gaps, 0.0).sum(1)
    touching = (gaps <= TOUCHES_WITHIN).sum(1)
    return np.asarray(MOVED[name].gain * width + TOUCHING * touching - SLOT * slots)
