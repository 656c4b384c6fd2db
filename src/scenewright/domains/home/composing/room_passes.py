"""The passes that compose a room, as rows of tables, in the order they run in."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from scenewright.core.layout import REPAIR
from scenewright.core.passes import Pass, run_passes
from scenewright.domains.home.attempts.attempt import RoomAnswer, RoomTask
from scenewright.domains.home.attempts.picturing import show_change
from scenewright.domains.home.composing.anew import compose_anew
from scenewright.domains.home.composing.bedrooms.beds import restore_double_bed
from scenewright.domains.home.composing.comparing import compare_answers, compare_judged
from scenewright.domains.home.composing.filling.adding import add_groups
from scenewright.domains.home.composing.filling.bare_floor import furnish_bare_floor
from scenewright.domains.home.composing.filling.bare_walls import furnish_bare_walls
from scenewright.domains.home.composing.filling.wet_rooms import fill_wet_room
from scenewright.domains.home.composing.filling.widening import widen_groups
from scenewright.domains.home.composing.freeing import free_ways
from scenewright.domains.home.composing.improve import improve_groups
from scenewright.domains.home.composing.judging import JudgedRoom
from scenewright.domains.home.composing.kitchens.islands import add_island
from scenewright.domains.home.composing.kitchens.reform import reform_kitchen
from scenewright.domains.home.composing.kitchens.slits import close_slits
from scenewright.domains.home.composing.seats.lounges import gather_seats

Barred = frozenset[str]
AnswerPass = Callable[[RoomTask, RoomAnswer, Barred], RoomAnswer]
JudgedPass = Callable[[RoomTask, JudgedRoom, Barred], JudgedRoom]


def _free(task: RoomTask, answer: RoomAnswer, _: Barred) -> RoomAnswer:
    return answer._replace(placed=free_ways(task, answer.placed))


OPENING: tuple[Pass[AnswerPass], ...] = (
    Pass("free ways", "opening", _free, "what bars a way is pushed along its wall"),
)
"""Before it is known which ways are barred."""
LACKING: tuple[Pass[AnswerPass], ...] = (
    Pass("add lacking", "opening", partial(add_groups, lacking=True), "what was given up, back in"),
)
RESTORING: tuple[Pass[JudgedPass], ...] = (
    Pass("restore double bed", "mending", restore_double_bed, "a bed for two in a room for two"),
)
MENDING: tuple[Pass[JudgedPass], ...] = (
    Pass("improve groups", "mending", improve_groups, "faulty groups in other forms and places"),
    Pass("reform kitchen", "mending", reform_kitchen, "a faulty kitchen made to measure"),
    Pass("gather seats", "mending", gather_seats, "seats, screen and table round one middle"),
    Pass("compose anew", "mending", compose_anew, "the room laid out from its kitchen or bed on"),
)
"""Only in rooms with a fault."""
FILLING: tuple[Pass[AnswerPass], ...] = (
    Pass("add groups", "filling", add_groups, "worktop, seats and shelves that still fit"),
    Pass("add island", "filling", add_island, "an island in a large kitchen"),
    Pass("bare floor", "filling", furnish_bare_floor, "a second zone in a bare half of a room"),
    Pass("bare walls", "filling", furnish_bare_walls, "storage at long bare walls"),
    Pass("close slits", "filling", close_slits, "slits at the ends of a kitchen run closed"),
    Pass("fill wet room", "filling", fill_wet_room, "storage in bathrooms that hold it"),
    Pass("widen groups", "filling", widen_groups, "storage as wide as its wall allows"),
)
ROOM_PASSES: tuple[Pass[Any], ...] = (*OPENING, *LACKING, *RESTORING, *MENDING, *FILLING)


def complete_room(
    task: RoomTask, answer: RoomAnswer, passes: Sequence[Pass[AnswerPass]], barred: Barred
) -> RoomAnswer:
    """The answer after passes over it that bar no further way than those ``barred``."""

    def apply(run: AnswerPass, now: RoomAnswer) -> RoomAnswer:
        return run(task, now, barred)

    def show(reason: str, old: RoomAnswer, new: RoomAnswer) -> None:
        show_change(task, old.placed, new.placed, REPAIR, reason)

    compare = partial(compare_answers, task)
    return run_passes(passes, answer, task.passes, apply, compare, show)


def mend_room(
    task: RoomTask, best: JudgedRoom, passes: Sequence[Pass[JudgedPass]], barred: Barred
) -> JudgedRoom:
    """The groups after passes over them, as :func:`complete_room`."""

    def apply(run: JudgedPass, now: JudgedRoom) -> JudgedRoom:
        return run(task, now, barred)

    def show(reason: str, old: JudgedRoom, new: JudgedRoom) -> None:
        show_change(task, old.placed, new.placed, REPAIR, reason)

    compare = partial(compare_judged, task)
    return run_passes(passes, best, task.passes, apply, compare, show)
