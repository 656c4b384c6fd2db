"""Small objects that belong to something: planters, trees in pots, totems, baskets, racks for
coats, ropes round and benches before exhibits, litter bins, bar stools.

Where they stand follows from what is already there, so they are set once everything else stands:
planters and trees in pairs beside a way in or a stage, at ends of benches, in corners, at walls;
totems before those who come in, beside the door and off their way, and beside islands; baskets and
racks for coats at the wall next to the entrance; benches before pictures and islands, ropes round
islands; bins beside doors and where one eats; bar stools at counters and high tables. Those whose
place or pattern a brief states are laid out with the rest.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from scenewright.core.scene import Size
from scenewright.domains.hall.accessories.baskets import find_basket_spots
from scenewright.domains.hall.accessories.benches import find_bench_spots, may_look
from scenewright.domains.hall.accessories.bins import find_bin_spots
from scenewright.domains.hall.accessories.planters import find_planter_spots
from scenewright.domains.hall.accessories.ropes import find_rope_spots, may_guard
from scenewright.domains.hall.accessories.setting import Setting
from scenewright.domains.hall.accessories.spots import Spots
from scenewright.domains.hall.accessories.stools import find_stool_spots, may_sit_high
from scenewright.domains.hall.accessories.totems import find_totem_spots
from scenewright.domains.hall.demands.holdings import HallDemand

MANY = 24
"""More of one kind than this are no accessories but a group of their own."""


class Accessory(NamedTuple):
    """Where one kind of small object may stand (``spots``), in which ``turn`` it is set, and metres
    that stay free before it, and ``around`` it where one goes past it on all sides. One that is
    ``used_at`` another stands on the free floor of that; ``belongs`` tells of a demand whether it
    is set so beside some others; where no spot is free one stands ``adrift`` or is left out."""

    spots: Callable[[Setting, Size], Spots]
    turn: int
    free: float
    around: float = 0.0
    used_at: bool = False
    belongs: Callable[[HallDemand, list[HallDemand]], bool] | None = None
    adrift: bool = True


ACCESSORIES: dict[str, Accessory] = {
    "sign_totem": Accessory(find_totem_spots, 0, 0.9, 1.25),
    "basket_stack": Accessory(find_basket_spots, 1, 0.9),
    "coat_rack": Accessory(find_basket_spots, 2, 0.9),
    "rope_barrier": Accessory(find_rope_spots, 2, 0.0, belongs=may_guard, adrift=False),
    "bench": Accessory(find_bench_spots, 3, 1.2, 0.9, belongs=may_look),
    "litter_bin": Accessory(find_bin_spots, 3, 1.2),
    "planter": Accessory(find_planter_spots, 4, 1.2),
    "potted_tree": Accessory(find_planter_spots, 4, 0.9),
    "bar_stool": Accessory(
        find_stool_spots, 5, 0.0, used_at=True, belongs=may_sit_high, adrift=False
    ),
}
"""By category."""


def split_accessories(
    wishes: list[HallDemand], together: bool, there: list[HallDemand]
) -> tuple[list[HallDemand], list[HallDemand]]:
    """Demands that are laid out by patterns, and those of small objects that are ``set_last``, once
    these and those ``there`` already stand; none where all are laid out ``together`` or nothing
    else is asked for."""
    small = [
        wish
        for wish in wishes
        if wish.unstated
        and wish.category in ACCESSORIES
        and len(wish.sizes) <= MANY
        and _belongs(wish, [*wishes, *there])
    ]
    rest = [wish for wish in wishes if wish not in small]
    if together or not rest:
        return wishes, []
    small.sort(key=lambda wish: ACCESSORIES[wish.category].turn)
    return rest, [wish._replace(set_last=True) for wish in small]


def _belongs(wish: HallDemand, wishes: list[HallDemand]) -> bool:
    belongs = ACCESSORIES[wish.category].belongs
    return belongs is None or belongs(wish, wishes)


def count_groups(small: list[HallDemand]) -> int:
    """How many groups some demands would be if they were laid out with the rest: as much is
    searched without them."""
    return sum(len(wish.sizes) if wish.patterns == ("single",) else 1 for wish in small)
