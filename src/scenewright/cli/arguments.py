"""The words of the command line, as the system passes them on."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from math import isfinite
from typing import Any

from scenewright.core.errors import InputError
from scenewright.text import is_whole


def check_words(arguments: list[str] | None) -> None:
    """Raise :class:`InputError` for a word that is no text, as the name of a file may be.

    >>> check_words(["arrange", "K\\udcfcche.json"])
    Traceback (most recent call last):
    scenewright.core.errors.InputError: 'K\ufffdche.json' is not valid Unicode; rename the file or correct it
    """  # noqa: E501
    for word in sys.argv[1:] if arguments is None else arguments:
        if not is_whole(word):
            raise InputError(f"'{word}' is not valid Unicode", "rename the file or correct it")


def check_repeated(words: Iterable[str], command: Any) -> None:
    """Raise :class:`InputError` for an option of one value that the ``words`` after the name of
    the program give twice; ``command`` is what parses them. Of two values only the last would
    count, without a word on the first."""
    waiting, seen = iter(words), set[str]()
    for word in waiting:
        if word == "--":
            return
        if word in getattr(command, "commands", {}):
            command = command.commands[word]
            continue
        name, attached = _split_option(word)
        option = next((one for one in command.params if name in one.opts), None)
        if option is None or getattr(option, "is_flag", True):
            continue
        if option.name in seen and not option.multiple:
            raise InputError(f"{name} is given twice", "give it once")
        seen.add(option.name)
        if not attached:
            next(waiting, None)


def _split_option(word: str) -> tuple[str, bool]:
    """The name of an option, and whether its value is part of the word.

    >>> _split_option("--seed=3"), _split_option("--seed"), _split_option("-oplan.svg")
    (('--seed', True), ('--seed', False), ('-o', True))
    """
    if word.startswith("--"):
        name, equals, _ = word.partition("=")
        return name, bool(equals)
    return word[:2], len(word) > 2


def check_budget(seconds: float | None, counts: dict[str, int | None]) -> None:
    """InputError unless at most one limit of the search is given, and it is positive."""
    given = [f"--{name}" for name, count in counts.items() if count is not None]
    given = ["--seconds"] * (seconds is not None) + given
    if len(given) > 1:
        raise InputError(f"{given[0]} and {given[1]} exclude each other", "give one of them")
    if seconds is not None and not (isfinite(seconds) and seconds > 0):
        raise InputError(f"--seconds {seconds:g} is not possible", "give a positive number")
    for name, count in counts.items():
        if count is not None and count <= 0:
            raise InputError(f"--{name} {count} is not possible", "give a positive whole number")
