"""What a thing's name says it is: the longest phrase of a table of words in several languages.

The phrases are those of the rows of kinds (:mod:`scenewright.catalog.kinds`), and of what is no
furniture of ours. A language more is one more keyword of a row's ``words``.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from functools import cache, lru_cache
from typing import NamedTuple

from scenewright.catalog.kinds import KINDS
from scenewright.catalog.kinds.other_words import GENERIC, NO_KIND
from scenewright.text import fold_letters

HEAD_LAST = ("en", "de")
"""Languages in which the last noun says what a thing is: a *piano bench* is a bench."""
COMPOUND = 5
"""Letters from which a German word counts at the end of a longer one (Kleider*schrank*)."""
SIGN = 4
"""What one Chinese or Japanese sign counts, in letters; and the least a word does (TV)."""
ASIDE = frozenset(
    ["with", "without", "under", "on", "for", "avec", "sans", "mit", "ohne", "con", "sin"]
)
"""What follows such a word does not say what a thing is."""


class Phrase(NamedTuple):
    """Words that name one of ``kinds`` (none: no furniture of ours)."""

    kinds: tuple[str, ...]
    language: str
    words: tuple[str, ...]


class NameMatch(NamedTuple):
    """What a name says: the kinds it may be, by which words, and whether these are all of it."""

    kinds: tuple[str, ...]
    words: tuple[str, ...]
    whole: bool


@lru_cache(maxsize=4096)
def match(name: str) -> NameMatch | None:
    """The longest phrase of the table in a name; of equally long ones the noun's; else None.

    In a name of several words a phrase is words in a row; in one word such as a file's name
    (``lampRoundFloor``) it is words in any order, and the noun is likely the first.

    >>> match("Office desk lamp").kinds, match("tableCoffeeGlass").kinds
    (('desk_lamp',), ('coffee_table',))
    >>> match("Kleiderschrank").kinds, match("Thingamajig")
    (('wardrobe',), None)
    """
    tokens = _said(tokens_of(name))
    loose = " " not in name.strip()
    found = [(p, at) for p in _candidates(tokens) if (at := _place(p, tokens, loose)) is not None]
    if not found:
        return None

    def worth(one: tuple[Phrase, int]) -> tuple[int, int]:
        noun = loose and _says(tokens[0], _noun(one[0]), one[0].language)
        return _letters(one[0]) + SIGN * noun, _later(*one)

    phrase, _ = max(found, key=worth)
    whole = sum(len(word) for word in phrase.words) >= sum(len(t) for t in tokens) - 2
    return NameMatch(phrase.kinds, phrase.words, whole)


def tokens_of(name: str) -> tuple[str, ...]:
    """The words of a name: small letters without accents, parted where capitals begin.

    >>> tokens_of("bookcaseClosedDoors_2"), tokens_of("Canapé d'angle")
    (('bookcase', 'closed', 'doors'), ('canape', 'd', 'angle'))
    """
    text = unicodedata.normalize("NFKC", name)
    text = fold_letters(re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text))
    return tuple(re.sub(r"[\W\d_]+", " ", text).split())


def _said(tokens: tuple[str, ...]) -> tuple[str, ...]:
    """What comes before a *with* or the like."""
    ends = (k for k, token in enumerate(tokens) if k and token in ASIDE)
    return tokens[: next(ends, len(tokens))]


@cache
def phrases() -> tuple[Phrase, ...]:
    """Every phrase of the table: those of the kinds, of several kinds, and of none.

    >>> next(phrase for phrase in phrases() if phrase.kinds == ("piano",)).words
    ('piano',)
    """
    named = [(kind.category, said) for kind in KINDS.values() for said in kind.words]
    named += [(name, generic.words) for name, generic in GENERIC.items()]
    named += [("", said) for said in NO_KIND]
    return tuple(
        Phrase(tuple(filter(None, (category, *said.also))), language, tokens_of(text))
        for category, said in named
        for language, texts in said.phrases
        for text in texts
    )


@cache
def _by_word() -> dict[str, tuple[Phrase, ...]]:
    """Phrases by their first word; those found within words under an empty one."""
    found: dict[str, list[Phrase]] = {}
    for phrase in phrases():
        first = phrase.words[0]
        found.setdefault(first, []).append(phrase)
        if not first.isascii() or (phrase.language == "de" and len(first) >= COMPOUND):
            found.setdefault("", []).append(phrase)
    return {word: tuple(own) for word, own in found.items()}


def _candidates(tokens: tuple[str, ...]) -> Iterator[Phrase]:
    table = _by_word()
    for token in dict.fromkeys(form for t in tokens for form in _forms(t)):
        yield from table.get(token, ())
    yield from table[""]


def _forms(token: str) -> tuple[str, ...]:
    """A word and what it may be the plural of."""
    return (token, *(token[: -len(end)] for end in ("s", "es") if token.endswith(end)))


def _place(phrase: Phrase, tokens: tuple[str, ...], loose: bool) -> int | None:
    """Where the last word of a phrase is in a name, None if it does not say the phrase."""
    words = phrase.words
    if len(words) == 1 and not words[0].isascii():
        return next((k for k, token in enumerate(tokens) if words[0] in token), None)
    if loose:
        places = [_at(word, phrase.language, tokens) for word in words]
        return None if None in places else max(place for place in places if place is not None)
    for start in range(len(tokens) - len(words) + 1):
        row = tokens[start : start + len(words)]
        if all(_says(t, w, phrase.language) for t, w in zip(row, words, strict=True)):
            return start + len(words) - 1
    return None


def _at(word: str, language: str, tokens: tuple[str, ...]) -> int | None:
    found = [k for k, token in enumerate(tokens) if _says(token, word, language)]
    return found[-1] if found else None


def _says(token: str, word: str, language: str) -> bool:
    """Whether a word of a name is a word of the table, in plural or at a compound's end."""
    compound = language == "de" and len(word) >= COMPOUND and token.endswith(word)
    return word in _forms(token) or compound


def _letters(phrase: Phrase) -> int:
    words = phrase.words
    return sum(max(len(word), SIGN) if word.isascii() else SIGN * len(word) for word in words)


def _noun(phrase: Phrase) -> str:
    return phrase.words[-1 if phrase.language in HEAD_LAST else 0]


def _later(phrase: Phrase, place: int) -> int:
    """The noun is the last in some languages and the first in others."""
    return place if phrase.language in HEAD_LAST else -place
