"""Changes made by hand: what is moved, swapped, locked, let go or done again."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import isfinite, tau
from typing import NamedTuple

from scenewright.core.document_faults import RADIANS
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution

Cancel = Callable[[], bool] | None
"""Asked while something is solved again; where it says so, that ends early."""


class Edits(NamedTuple):
    """Changes by the names of pieces or groups: ``move`` to (x, y) or (x, y, heading) in metres
    and radians, ``swap`` pairs, ``lock`` and ``unlock``, and rooms to furnish ``again``. What is
    solved again ends early once ``cancel`` says so."""

    move: Mapping[str, tuple[float, ...]] = {}
    swap: tuple[tuple[str, str], ...] = ()
    lock: tuple[str, ...] = ()
    unlock: tuple[str, ...] = ()
    again: tuple[str, ...] = ()
    cancel: Cancel = None


class Addition(NamedTuple):
    """A model of the catalog, by id or name, to be put at (x, y), metres, of a space (left out: the
    one that is there), looking along ``heading`` (left out: with its back to the nearest wall)."""

    asset: str
    x: float
    y: float
    heading: float | None = None
    space: str = ""


class PieceEdits(NamedTuple):
    """Changes of single pieces: those to ``remove``, to ``exchange`` for another model, to
    ``resize`` to width, depth and height in metres, to ``restyle`` by the models of a style (a
    piece, or all of a space), to ``duplicate``, and what to ``add``."""

    remove: Sequence[str] = ()
    exchange: Mapping[str, str] = {}
    resize: Mapping[str, Sequence[float]] = {}
    restyle: Mapping[str, str] = {}
    duplicate: Sequence[str] = ()
    add: Sequence[Addition] = ()


class Change(NamedTuple):
    """One piece that is not as it was: its id (``was`` that before, empty if new), whether it is
    ``moved``, ``new``, ``gone`` or ``exchanged``, its room, and why."""

    piece: str
    was: str
    change: str
    room: str
    reason: str


class Adjusted(NamedTuple):
    """A home changed by hand and solved again, and every change with its reason."""

    solution: Solution
    changes: tuple[Change, ...]


def check_moves(move: Mapping[str, tuple[float, ...]]) -> None:
    """InputError for a place that is not (x, y) or (x, y, heading) in metres and radians: a
    heading of 90 is meant in degrees.

    >>> check_moves({"bed": (1.0, 2.0, 90.0)})
    Traceback (most recent call last):
    scenewright.core.errors.InputError: move 'bed': 90 is no heading; headings are radians, \
-6.283 to 6.283: 1.5708 is a quarter turn
    """
    for name, place in move.items():
        if len(place) not in (2, 3) or not all(map(isfinite, place)):
            raise InputError(
                f"move '{name}': {place} is not a place", "give (x, y) or (x, y, heading)"
            )
        if len(place) > 2 and abs(place[2]) > tau:
            raise InputError(f"move '{name}': {place[2]:g} is no heading", RADIANS)
