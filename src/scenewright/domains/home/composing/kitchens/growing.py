"""Runs that grow into the free wall at their ends, up to what their room asks for.

A kitchen is put together while a room is composed, beside all that might still stand there. When
the home is furnished, what is left of its wall gets cabinets: worktop to put things down on beside
sink, hob and fridge (NKBA, Kitchen Planning Guidelines, 11, 16 and 17), then what the room asks.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, sin

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.composing.case_faults import find_neighbour
from scenewright.domains.home.composing.filling.beside_others import list_others
from scenewright.domains.home.composing.homewide.settling import list_sound, try_in_home
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.kitchens.free_walls import floor_length
from scenewright.domains.home.composing.kitchens.slits import (
    SLIT,
    Slit,
    belongs,
    is_unit,
    list_ends,
    may_grow,
)
from scenewright.domains.home.composing.modest import EXPECTED
from scenewright.domains.home.composing.places.moving import dress_group
from scenewright.domains.home.composing.spacing.rules import measure_closeness
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.groups.kitchen import fill, hang_above
from scenewright.domains.home.least_sizes import CABINET
from scenewright.domains.home.measures import HAIR
from scenewright.domains.home.walking.remove_blockers import Opened

LANDING = {"sink_cabinet": 0.6, "hob_cabinet": 0.4, "fridge": 0.4}
"""Metres of worktop beside what a run ends with, at least (NKBA 11: 24, 17: 15, 16: 15 inches)."""
FRONT_LIVED_IN = 3.0
"""Metres of front up to which a kitchen grows where people live in its room as well."""
PARTS = 3
"""Lengths that are tried at one end: all there is, and ever less."""


def grow_kitchens(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with kitchens grown at their ends where nothing stands worse for it."""
    found = answers
    for room, task in enumerate(tasks):
        for side in (-1, 1) if task.preset.settings.exact and not task.accessible else ():
            for placed in _list_grown(task, found[room], side):
                trial = try_in_home(room, found[room]._replace(placed=placed), found, opened)
                if trial is not None:
                    found = trial
                    break
    return found


def _list_grown(task: RoomTask, answer: RoomAnswer, side: int) -> Iterator[Placed]:
    """The groups of a room with a kitchen grown at one end, the longest first."""
    run = next((p for p in answer.placed if p.wish.group in RUNS and p.pieces), None)
    if run is None or not may_grow(task, run):
        return
    rest = tuple(p for p in answer.placed if p is not run)
    standing = list_others(task, answer.placed, run)
    near = measure_closeness(answer.placed, task.fixed, task.ground)
    for end in list_ends(task, answer, run):
        for wide in _list_lengths(task, run, end) if end.side == side else ():
            case = lengthen(run.dressed.case, end, wide)
            grown = case and dress_group(task, run, case, run.dressed.box, standing)
            for placed in list_sound(task, answer.placed, rest, (grown,)) if grown else ():
                if measure_closeness(placed, task.fixed, task.ground) <= near + HAIR:
                    yield placed


def _list_lengths(task: RoomTask, run: FurnishedGroup, end: Slit) -> Iterator[float]:
    """Metres by which a run may grow at an end."""
    asked = max(v for start, v in EXPECTED["kitchen"].rows if start <= max(task.ground.area, 7.0))
    if not set(task.space.functions) <= {"kitchen", "hall"}:
        asked = FRONT_LIVED_IN
    short = asked - EXPECTED["kitchen"].measure(run.dressed.case)
    most = min(end.gap, max(short, LANDING.get(end.unit.category, 0.0)))
    most = end.gap if end.gap - most < SLIT[1] else floor_length(most)
    for part in range(PARTS):
        wide = most * (PARTS - part) / PARTS
        if wide >= CABINET.width - HAIR:
            yield wide


def lengthen(case: Group, end: Slit, wide: float) -> Group | None:
    """A case with ``wide`` metres of cabinets more at an end, before a fridge that stands there;
    None where there is nothing but that."""
    units = [m for m in case.members if is_unit(m)]
    moved, at = list[Member](), end.unit
    while at.category == "fridge":
        moved.append(at)
        following = find_neighbour(at, units, -end.side)
        if following is None:
            return None
        at = following
    c, s = cos(at.heading), sin(at.heading)
    by = end.side * wide
    members = [
        m._replace(x=m.x + c * by, y=m.y + s * by) if any(belongs(m, u) for u in moved) else m
        for m in case.members
    ]
    back, aside = -at.size.depth / 2, at.size.width / 2
    for category, width in fill(wide):
        x = end.side * (aside + width / 2)
        low = Member(category, x, 0.0, 0, 0, Size(width, at.size.depth, at.size.height))
        for m in (low, *hang_above(category, x, width, back)):
            turned = (at.x + c * m.x - s * m.y, at.y + s * m.x + c * m.y)
            members.append(m._replace(x=turned[0], y=turned[1], heading=at.heading))
        aside += width
    return case._replace(members=tuple(members))
