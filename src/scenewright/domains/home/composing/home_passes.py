"""The passes over a whole home whose ways are open, as rows of tables, in the order they run in."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from scenewright.core.layout import REPAIR
from scenewright.core.passes import ALL_PASSES, Pass, run_passes
from scenewright.domains.home.attempts.attempt import RoomAnswer, RoomTask
from scenewright.domains.home.attempts.picturing import show_home
from scenewright.domains.home.composing.alignment.homes import align_rooms
from scenewright.domains.home.composing.comparing import compare_homes
from scenewright.domains.home.composing.filling.widening import widen_storage
from scenewright.domains.home.composing.homewide.bedsides import add_nightstands
from scenewright.domains.home.composing.homewide.settling import HomeState
from scenewright.domains.home.composing.kitchens.growing import grow_kitchens
from scenewright.domains.home.composing.kitchens.mend import mend_kitchens
from scenewright.domains.home.composing.mend_rooms import mend_rooms
from scenewright.domains.home.needs.laundry import add_washing_machine
from scenewright.domains.home.needs.outlook import add_screen
from scenewright.domains.home.needs.settle import (
    add_kitchen_tables,
    add_soft_seat,
    hang_clothes,
    set_table,
)
from scenewright.domains.home.walking.remove_blockers import Opened

Answers = list[RoomAnswer]


HomePass = Callable[[HomeState, Answers], Answers]


def _of_rooms(run: Callable[[Sequence[RoomTask], Answers, Opened], Answers]) -> HomePass:
    """A pass over rooms and their ways that asks for nothing else of the home."""
    return lambda home, answers: run(home.tasks, answers, home.opened)


MENDING: tuple[Pass[HomePass], ...] = tuple(
    Pass(name, "home mending", _of_rooms(run), purpose)
    for name, run, purpose in (
        ("mend kitchens", mend_kitchens, "kitchens without worktop made to measure again"),
        ("add nightstands", add_nightstands, "a nightstand at each bed for one"),
    )
)
"""What is dropped as a whole where the home then lacks more of what its household needs."""
SETTLING: tuple[Pass[HomePass], ...] = (
    Pass("set table", "home settling", set_table, "a table for all who live in the home"),
    Pass("kitchen tables", "home settling", add_kitchen_tables, "one in bare kitchens"),
    Pass("soft seat", "home settling", add_soft_seat, "one in a home without any"),
    Pass("hang clothes", "home settling", hang_clothes, "wider wardrobes for all who live there"),
)
ALIGNING: tuple[Pass[HomePass], ...] = (
    Pass("mend rooms", "home aligning", _of_rooms(mend_rooms), "the worst row, its moves, again"),
    Pass("grow kitchens", "home aligning", _of_rooms(grow_kitchens), "cabinets at their free ends"),
    Pass("widen storage", "home aligning", _of_rooms(widen_storage), "as wide as its wall allows"),
    Pass("screen", "home aligning", add_screen, "one before a seat in a home without any"),
    Pass("align rooms", "home aligning", _of_rooms(align_rooms), "groups on axes, no odd gaps"),
    Pass("washing machine", "home aligning", add_washing_machine, "one in a home without any"),
)
HOME_PASSES = (*MENDING, *SETTLING, *ALIGNING)


def finish_home(home: HomeState, answers: Answers, passes: Sequence[Pass[HomePass]]) -> Answers:
    """The answers for all rooms after passes that leave the ways of the home open."""

    def apply(run: HomePass, now: Answers) -> Answers:
        return run(home, now)

    def show(reason: str, old: Answers, new: Answers) -> None:
        show_home(home.tasks, old, new, REPAIR, reason)

    options = home.tasks[0].passes if home.tasks else ALL_PASSES
    return run_passes(passes, answers, options, apply, partial(compare_homes, home.tasks), show)
