"""What a person types at the prompt of ``evolve``, and what it means.

Candidates are called by their place on the sheet, from 1.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from scenewright.core.errors import InputError
from scenewright.engine.preference.events import (
    Event,
    Keep,
    Lock,
    Pick,
    Prefer,
    Reason,
    Stars,
    Worst,
)
from scenewright.text import quantity

if TYPE_CHECKING:
    from scenewright.workflow.evolve import Evolution

HELP = """\
3            the best of the sheet         3 > 7        3 is better than 7
worst 5      the worst of the sheet        3=5          five stars for 3
why 3 WORDS  what 3 lacks: too dense …     reasons      the words there are
lock NAME    keep a piece of the champion  undo         take back what was said last
keep [3]     the champion, until another   auto 3       let the model rate three rounds
next, Enter  the next sheet                done         write the champion and end
best         the best bred so far          quit         end; the log keeps all
move 3 NAME X,Y[,DEGREES]                  change 3 by hand
names        what of the champion can be locked or moved, and where it stands"""
FORMS = "3 · 3 > 7 · worst 5 · 3=5 · why 3 too dense · lock sofa · undo · keep · next · done"
VERBS = ("next", "done", "quit", "undo", "help", "reasons", "best", "names")


class Command(NamedTuple):
    """What is to be done besides hearing events: ``next``, ``done``, ``quit``, ``undo``, ``help``,
    ``reasons``, ``best``, ``names``, ``auto`` (``number`` rounds), or ``move`` (candidate
    ``number``, piece ``name`` to ``place`` in metres and degrees)."""

    verb: str
    number: int = 0
    name: str = ""
    place: tuple[float, ...] = ()


def parse_line(
    line: str,
    shown: Sequence[int],
    screen: int,
    said: Sequence[Event],
    reasons: Collection[str],
    champion: int | None = None,
) -> tuple[Event, ...] | Command:
    """The events of a line, or what is to be done; InputError, in one line, for what is neither.

    ``shown`` are the candidates in their places on sheet ``screen``, ``said`` the events said of
    it so far: a second best is picked from those not yet placed.

    >>> parse_line("3 > 1", [10, 11, 12], 0, (), ())
    (Prefer(one=12, other=10),)
    """
    text = " ".join(line.lower().split())
    if text in ("", "n"):
        return Command("next")
    if text in VERBS:
        return Command(text)
    if text == "?":
        return Command("help")
    left = remaining(shown, said)
    if re.fullmatch(r"\d+", text):
        best = _at(text, shown)
        return (Pick(best, _among(best, left, shown)),)
    if re.fullmatch(r"\d+( ?> ?\d+)+", text):
        order = [_at(word, shown) for word in text.split(">")]
        return tuple(Prefer(one, other) for one, other in pairwise(order))
    if found := re.fullmatch(r"(\d+) ?= ?(\d+)", text):
        return (Stars(_at(found[1], shown), int(found[2]), screen),)
    if found := re.fullmatch(r"worst (\d+)", text):
        worst = _at(found[1], shown)
        return (Worst(worst, _among(worst, left, shown)),)
    if found := re.fullmatch(r"why (\d+) (.+)", text):
        return (Reason(_at(found[1], shown), match_reason(found[2], reasons)),)
    if found := re.fullmatch(r"auto (\d{1,2})", text):
        return Command("auto", int(found[1]))
    return _parse_rest(line.strip(), text, shown, champion)


def _parse_rest(
    line: str, text: str, shown: Sequence[int], champion: int | None
) -> tuple[Event, ...] | Command:
    """Lines with names of pieces, and ``keep``."""
    if found := re.fullmatch(r"lock (.+)", line, re.IGNORECASE):
        return (Lock(found[1].strip()),)
    if found := re.fullmatch(r"keep( \d+)?", text):
        if found[1] is None and champion is None:
            raise InputError("there is no champion yet", "say which: keep 3")
        return (Keep(_at(found[1], shown) if found[1] else champion or 0),)
    move = re.fullmatch(r"move (\d+) (\S+) ([-\d.]+,[-\d.]+(?:,[-\d.]+)?)", line, re.IGNORECASE)
    if move:
        try:
            place = tuple(float(part) for part in move[3].split(","))
        except ValueError:
            raise InputError(f"'{move[3]}' is not a place", "give X,Y as 1.2,3.4") from None
        return Command("move", _at(move[1], shown), move[2], place)
    raise InputError(f"cannot read '{line[:60]}'", f"say {FORMS}")


def remaining(shown: Sequence[int], said: Sequence[Event]) -> tuple[int, ...]:
    """Candidates of a sheet that were neither picked nor called the worst of it."""
    placed = {e.best for e in said if isinstance(e, Pick)}
    placed |= {e.worst for e in said if isinstance(e, Worst)}
    return tuple(number for number in shown if number not in placed)


def match_reason(words: str, reasons: Collection[str]) -> str:
    """The reason that words mean: the one they are, or the only one they begin or are part of.

    >>> match_reason("dense", ["too dense", "more sun"])
    'too dense'
    """
    for test in (str.__eq__, str.startswith, str.__contains__):
        fit = [reason for reason in reasons if test(reason, words)]
        if len(fit) == 1:
            return fit[0]
    known = ", ".join(reasons) or "none: this kind of scene has no reasons"
    raise InputError(f"unknown reason '{words[:40]}'", f"use one of: {known}")


def _at(word: str, shown: Sequence[int]) -> int:
    """The candidate at a place."""
    place = int(word.strip()[:6])
    if not 1 <= place <= len(shown):
        raise InputError(f"there is no {place} on the sheet", f"say 1 to {len(shown)}")
    return shown[place - 1]


def _among(one: int, left: tuple[int, ...], shown: Sequence[int]) -> tuple[int, ...]:
    """What a candidate was chosen from: those not yet placed, or all if it was."""
    return left if one in left and len(left) > 1 else tuple(shown)


def list_names(evolution: Evolution, first: int) -> list[str]:
    """What of the champion, or of the first candidate while there is none, can be locked or moved:
    a line a space, each piece by the end of its name with where it stands in metres."""
    from scenewright.engine.preference.features import stands_on_floor

    champion = evolution.champion
    solution = evolution.solution_of(first) if champion is None else champion.solution
    found: dict[str, list[str]] = {}
    for piece in solution.pieces:
        if stands_on_floor(piece) and piece.function not in ("landmark", "trees"):
            short = piece.id.rpartition("/")[2]
            place = f"{short} {piece.pose.x:.1f},{piece.pose.y:.1f}"
            found.setdefault(piece.space, []).append(place)
    return [f"{space}: {' · '.join(places)}" for space, places in found.items()]


def describe_event(event: Event, shown: list[int]) -> str:
    """What was understood, by places on the sheet (candidates of earlier sheets by number)."""
    from scenewright.engine.preference import events as said

    def place(number: int) -> str:
        return str(shown.index(number) + 1) if number in shown else f"candidate {number}"

    match event:
        case said.Pick(best, among):
            return f"{place(best)} is the best of {len(among)}"
        case said.Worst(worst, among):
            return f"{place(worst)} is the worst of {len(among)}"
        case said.Prefer(one, other):
            return f"{place(one)} is better than {place(other)}"
        case said.Stars(candidate, stars, _):
            return f"{place(candidate)}: {quantity(stars, 'star')}"
        case said.Reason(candidate, reason):
            return f"{place(candidate)}: {reason}"
        case said.Lock(name):
            return f"{name} stays as in the champion"
        case said.Keep(candidate):
            return f"{place(candidate)} is the champion until another is better"
        case _:
            return "changed by hand"
