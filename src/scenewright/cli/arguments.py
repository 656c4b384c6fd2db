"""The words of the command line, as the system passes them on."""

from __future__ import annotations

import sys

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
