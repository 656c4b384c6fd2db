"""Halls of two zones, and halls in a row, for the tests of the referee."""

from __future__ import annotations

from hypothesis import strategies as st
from tests.judged_halls import answer, box, hall_brief, piece, wall, zone

SOUTH_DOOR = {"at": [3, 0], "width": 1.6, "swing": "none"}


EAST_DOOR = {"at": [12, 3], "width": 1.6, "swing": "none", "use": "exit"}


WEST_ZONE, EAST_ZONE = zone("west", box(0, 0, 6, 6)), zone("east", box(6, 0, 12, 6))


def two_zones(*pieces, width=1.2, groups=(), tours=(), **more):
    """A hall 12 m by 6 m of two linked zones, entered from the south, left to the east."""
    brief = hall_brief(box(0, 0, 12, 6), (SOUTH_DOOR, EAST_DOOR), **more)
    links = (("west", "east", width),)
    return answer(brief, pieces, (WEST_ZONE, EAST_ZONE), links, groups, tours)


def gap(width: float):
    """Partitions along the border that leave a gap from y = 2 on."""
    return wall(6, 0, 6, 2), wall(6, 2 + width, 6, 6)


def figures(report):
    return report.figures["halls"]["h"]


def grid(n: int = 2, pitch: float = 2.0, at=(2.0, 2.0), size: float = 1.0):
    return tuple(
        piece("case", at[0] + pitch * i, at[1] + pitch * j, size, size)
        for i in range(n)
        for j in range(n)
    )


odd = st.one_of(st.floats(-5, 15), st.sampled_from([0.0, 1e-9, 1e4, 6.0]), st.floats())


rings = st.lists(st.tuples(odd, odd), max_size=6)
