"""What is easier to use from a wheelchair: showers for baths, beds and showers of full width."""

from __future__ import annotations

import numpy as np

from scenewright.core.brief import Room
from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import RoomTask
from scenewright.domains.home.cases.library import Library, cases, subset
from scenewright.domains.home.furnishing.furnish import SLACK
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.wished.wishes import groups_of, list_barred_groups

INSTEAD = {"bunk": "single", "bath": "shower"}
ROOMY = {"single": ("single_bed", 0.9), "shower": ("shower", 0.9)}
"""Least widths, taken wherever the room holds them, metres."""


def keep_roomy(library: Library) -> Library:
    """A library with single beds and showers of the usual width, as far as it has such."""
    own = dict(library.own)
    for function, (category, least) in ROOMY.items():
        known = cases(function, library)
        wide = np.array([_width_of(case, category) >= least - SLACK for case in known.groups])
        if wide.any() and not wide.all():
            own[function] = subset(known, wide)
    return library._replace(own=own)


def _width_of(case: Group, category: str) -> float:
    """The least side of the main piece of a case, metres; 0 without one."""
    return min((min(m.size[:2]) for m in case.members if m.category == category), default=0.0)


def _list_named(room: Room | None) -> frozenset[str]:
    """The groups that are asked or wished for in a room by name."""
    if room is None:
        return frozenset()
    named = [*(a.group for a in room.ask or ()), *(w.what for w in room.wishes if not w.forbid)]
    return frozenset(group for what in named for group in groups_of(what))


def prefer_easy(task: RoomTask, wishes: tuple[Wish, ...]) -> tuple[Wish, ...]:
    """Wishes with what is easier to use in the place of what is not, unless that is wished for."""
    kept = _list_named(task.asked)
    barred = list_barred_groups(task.asked, task.library) if task.asked else frozenset()
    have = {w.group: w for w in wishes}
    easier = {
        w.group: INSTEAD[w.group]
        for w in wishes
        if w.group in INSTEAD
        and not w.required
        and w.group not in kept
        and INSTEAD[w.group] not in barred
    }
    if "bunk" in easier and "single" in have:
        del easier["bunk"]
    taken = frozenset(easier.values())
    return tuple(
        have.get(easier[w.group], w)._replace(group=easier[w.group], rank=w.rank, core=w.core)
        if w.group in easier
        else w
        for w in wishes
        if w.group not in taken
    )
