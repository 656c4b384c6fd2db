"""Whether a person could use a case: it is tried in an empty room of its own."""

from __future__ import annotations

from math import pi

import numpy as np

from scenewright.building.plan import spaces
from scenewright.core.brief import Brief, Door, Room
from scenewright.core.catalog import Catalog, Group
from scenewright.domains.home.furnishing.furnish import FurnishedPatch, pieces_of
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.walking.ways import find_unreached

BACKED = 0.5
"""How much a group belongs to a wall (its row's ``back``) from which it is tried at one."""
AROUND = 1.5
"""Free floor before and beside a case on trial, in metres."""


def usable(case: Group, catalog: Catalog, route: float = 0.6) -> bool:
    """Whether a route of ``route`` metres reaches every piece of a case in an otherwise empty room,
    with its back at the wall if it belongs there.

    >>> from scenewright.catalog.assets import shipped
    >>> from scenewright.domains.home.cases.library import cases
    >>> usable(cases("dining").groups[3], shipped())
    True
    """
    wide, deep = case.width + 2 * AROUND, case.depth + 2 * AROUND
    room = Room(
        id="trial",
        function="other",
        outline=[(0, 0), (wide, 0), (wide, deep), (0, deep)],
        doors=[Door(at=(0.6, deep), width=0.8)],
    )
    space = spaces(Brief(rooms=[room]))[0]
    at_wall = GROUPS[case.function].back >= BACKED
    y = case.depth / 2 + (0.01 if at_wall else AROUND)
    box = np.array([wide / 2, y, pi / 2, case.width, case.depth])
    furnished = FurnishedPatch(case, box, (True,) * len(case.members), 0)
    pieces = pieces_of(furnished, "trial", "trial/case", case.function, catalog)
    return not find_unreached(ground_of(space, (), wide * deep), pieces, catalog, route)
