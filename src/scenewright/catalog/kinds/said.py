"""The words of kinds in six languages, from ``words.csv``."""

from __future__ import annotations

import csv
from functools import cache
from importlib.resources import files

from scenewright.core.kind import Words, words


@cache
def said_words() -> dict[str, tuple[Words, ...]]:
    """Words by category, those of no kind under an empty name: a row for each meaning, with the
    kinds it may mean ``also``, a column for each language, phrases parted by commas.

    >>> said_words()["gondola"][0].phrases[1]
    ('fr', ('gondole de magasin',))
    """
    text = files("scenewright.catalog.kinds").joinpath("words.csv").read_text(encoding="utf-8")
    found: dict[str, tuple[Words, ...]] = {}
    for row in csv.DictReader(text.splitlines()):
        category, also = row.pop("category"), row.pop("also")
        phrases = {language: said for language, said in row.items() if said}
        found[category] = (*found.get(category, ()), words(also, **phrases))
    return found
