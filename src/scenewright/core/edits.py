"""Changes made by hand: what is moved, swapped, locked, let go or done again."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from scenewright.core.solution import Solution


class Edits(NamedTuple):
    """Changes by the names of pieces or groups: ``move`` to (x, y) or (x, y, heading) in metres
    and radians, ``swap`` pairs, ``lock`` and ``unlock``, and rooms to furnish ``again``."""

    move: Mapping[str, tuple[float, ...]] = {}
    swap: tuple[tuple[str, str], ...] = ()
    lock: tuple[str, ...] = ()
    unlock: tuple[str, ...] = ()
    again: tuple[str, ...] = ()


class Change(NamedTuple):
    """One piece that is not as it was: its id (``was`` that before, empty if new), whether it is
    ``moved``, ``new`` or ``gone``, its room, and why."""

    piece: str
    was: str
    change: str
    room: str
    reason: str


class Adjusted(NamedTuple):
    """A home changed by hand and solved again, and every change with its reason."""

    solution: Solution
    changes: tuple[Change, ...]
