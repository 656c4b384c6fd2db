"""What a room is for, read from its name in any of fifteen languages: English, French, German,
Spanish, Italian, Portuguese, Dutch, Swedish, Polish, Czech, Turkish, Russian, Chinese, Japanese
and Korean.

A name may hold several functions ("Wohn-/Esszimmer", "LDK", "客餐厅"). Case, accents, numbers,
plurals and a slip of the pen in a long word do not matter.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from functools import cache
from typing import NamedTuple

from scenewright.building.room_words import FIRST, LAST, SIGNS
from scenewright.text import fold_letters

OPEN_PLAN = frozenset({"living", "dining", "kitchen"})


class RoomNameMatch(NamedTuple):
    """A phrase found in a name: where it starts, its functions, whether it leads (French)."""

    start: int
    functions: tuple[str, ...]
    leads: bool


def functions_from_name(name: str) -> tuple[str, ...]:
    """Functions of a room by its name; ``('other',)`` if the name says nothing.

    >>> functions_from_name("Cuisine ouverte / salon"), functions_from_name("主卧")
    (('kitchen', 'living'), ('double_bedroom',))
    """
    return sort_functions(functions for part in _parts(name) for functions in _of_part(part))


def _parts(name: str) -> list[str]:
    plain = fold_letters(name).replace("'s", "s").replace("’s", "s")
    return re.split(r"[/+&,;()|·・、]|\b(?:and|et|und|y|e|i|och|ve|и)\b|\s[-–]\s", plain)


def says_nothing(name: str) -> bool:
    """Whether a room's name tells nothing of its use.

    >>> says_nothing("Zzyzx"), says_nothing("Garage"), says_nothing("Kitchen")
    (True, False, False)
    """
    return not any(map(_of_part, _parts(name)))


def sort_functions(functions: Iterable[str]) -> tuple[str, ...]:
    """Without doubles, and without the vague ones beside something more exact.

    >>> sort_functions(["bedroom", "child_bedroom", "other"])
    ('child_bedroom',)
    """
    found = list(dict.fromkeys(functions))
    vague = {"other"} if len(found) > 1 else set()
    if any(function.endswith("_bedroom") for function in found):
        vague.add("bedroom")
    if "bathroom" in found:
        vague |= {"toilet", "washroom"}
    return tuple(function for function in found if function not in vague) or ("other",)


def _of_part(part: str) -> tuple[str, ...]:
    """Functions of one part of a name: all of an open plan, else of the noun that counts."""
    found = sorted(_signs(part) + _words(part))
    functions = tuple(function for match in found for function in match.functions)
    if len(found) < 2 or OPEN_PLAN.issuperset(functions):
        return functions
    return found[0].functions if all(match.leads for match in found) else found[-1].functions


def _signs(part: str) -> list[RoomNameMatch]:
    found = []
    for phrase, functions in _sign_table():
        start = part.find(phrase)
        if start >= 0:
            found.append(RoomNameMatch(start, functions, False))
            part = part.replace(phrase, "\0" * len(phrase))
    return found


def _words(part: str) -> list[RoomNameMatch]:
    words = [_correct_spelling(word) for word in re.findall(r"[a-zа-я]+", part)]
    table = _word_table()
    found, i = [], 0
    while i < len(words):
        for length in range(min(4, len(words) - i), 0, -1):
            hit = table.get(" ".join(words[i : i + length]))
            if hit is not None:
                found.append(RoomNameMatch(i, hit[0], hit[1]))
                i += length - 1
                break
        i += 1
    return found


@cache
def _correct_spelling(word: str) -> str:
    """The word as the table has it: as it is, singular, its known ending, or one slip away."""
    vocabulary = _vocabulary()
    if word in vocabulary or len(word) < 3:
        return word
    for ending in ("s", "es", "n", "e"):
        if word.endswith(ending) and word.removesuffix(ending) in vocabulary:
            return word.removesuffix(ending)
    for start in range(1, len(word) - 5):
        if word[start:] in vocabulary:
            return word[start:]
    close = difflib.get_close_matches(word, vocabulary, 1, 0.9) if len(word) > 5 else []
    return close[0] if close else word


@cache
def _word_table() -> dict[str, tuple[tuple[str, ...], bool]]:
    table: dict[str, tuple[tuple[str, ...], bool]] = {}
    for leads, rows in ((True, FIRST), (False, LAST)):
        for functions, phrases in rows.items():
            for phrase in phrases.split(";"):
                words = " ".join(_singular(word) for word in phrase.split())
                table[words] = table[phrase.strip()] = (tuple(functions.split()), leads)
    return table


def _singular(word: str) -> str:
    return word[:-1] if word.endswith("s") and len(word) > 4 else word


@cache
def _vocabulary() -> frozenset[str]:
    return frozenset(word for phrase in _word_table() for word in phrase.split())


@cache
def _sign_table() -> tuple[tuple[str, tuple[str, ...]], ...]:
    rows = ((sign, tuple(f.split())) for f, signs in SIGNS.items() for sign in signs.split())
    return tuple(sorted(rows, key=lambda row: -len(row[0])))
