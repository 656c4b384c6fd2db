"""The bed of a room is the one that is wished for there, not another beside the usual one."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.core.brief import Room
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.groups.classes import BED_GROUPS
from scenewright.domains.home.programme import Wish


def list_wished_beds(room: Room) -> tuple[str, ...]:
    """The groups of beds that are wished for in a room, by their name or that of the bed.

    >>> wished = Room.model_validate({"outline": [[0, 0], [3, 0], [3, 3]],
    ...     "wishes": [{"what": "bunk_bed"}, {"what": "nightstand"}]})
    >>> list_wished_beds(wished)
    ('bunk',)
    """
    names = {wish.what for wish in room.wishes if not wish.forbid}
    return tuple(bed for bed in BED_GROUPS if names.intersection((bed, *GROUPS[bed].essential)))


def take_wished_bed(usual: Sequence[Wish], room: Room) -> tuple[Wish, ...]:
    """The programme of a room with the bed that is wished for in place of its usual one, of several
    the last; further beds that are wished for are added to it later."""
    wished = list_wished_beds(room)
    beds = [k for k, wish in enumerate(usual) if wish.group in BED_GROUPS]
    if not wished or not beds or any(usual[k].group in wished for k in beds):
        return tuple(usual)
    taken = usual[beds[-1]]._replace(group=wished[0])
    return (*usual[: beds[-1]], taken, *usual[beds[-1] + 1 :])
