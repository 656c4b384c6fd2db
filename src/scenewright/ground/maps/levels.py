"""Levels of a building named in words, as numbers: "EG", "1. OG", "Ground floor", "RdC", "B1F".

A row of a table says how a language counts: from the ground up, from the ground down, or with the
ground as its first. The attic lies on the highest level that the map names.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterable
from typing import NamedTuple

from scenewright.ground.maps.features import LEVEL, RANGE, Feature

KEYS = ("level", "repeat_on")
ATTIC = math.inf
_ORDINALS = {
    "first erster erste erstes premier première primer primera primo prima primeiro": 1,
    "second zweiter zweite zweites deuxième segundo segunda secondo seconda": 2,
    "third dritter dritte drittes troisième tercer tercera terzo terza terceiro": 3,
    "fourth vierter vierte viertes quatrième cuarto cuarta quarto quarta": 4,
    "fifth fünfter fünfte fünftes cinquième quinto quinta": 5,
}
_FLOORS = (
    "og|obergescho(?:ss|ß)|stock(?:werk)?|etage|étage|floor|storey|story|piso|planta|andar|piano|"
    "verdieping|etaj|piętro|pietro|patro|poschodie|sal|kat|emelet|kerrosta|geschoss|level"
)
_CELLARS = (
    "ug|kg|untergeschoss|kellergeschoss|keller|sous-sol|sótano|sotano|basement|cellar|kelder|"
    "källare|kælder|interrato|podziemie|suterén|bodrum|b|u|ss|ps"
)


class _Row(NamedTuple):
    """Words that name a level: a pattern whose group, if it has one, is a number ``n``; the level
    is ``base + step · n``."""

    words: re.Pattern[str]
    base: float
    step: int = 0


def _row(pattern: str, base: float, step: int = 0) -> _Row:
    return _Row(re.compile(pattern), base, step)


ROWS = (
    _row(
        "e|eg|erdgescho(?:ss|ß)|parterre|ground|ground ?floor|gf|g|street(?: level)?|rdc|r ?d ?c|"
        "rez|rez de chaussée|rez de chaussee|pb|planta baja|bajo|baja|pt|piano terra|terra|"
        "pianterreno|bg|bgg|begane grond|parter|přízemí|přizemi|prizemie|bv|bottenvåning|"
        "entréplan|st|stuen|stue|zemin|zemin kat|földszint|pohjakerros|térreo|terreo|rés do chão|"
        "r/c|erd",
        0,
    ),
    _row("m|mezz|mezzanine|zg|zwischengeschoss|entresol|ammezzato|mezzanino|hp|hochparterre", 0.5),
    _row("upper ground|upper ground floor", 0.5),
    _row(
        f"(?:{_CELLARS}|tg|tiefgarage|souterrain|lg|lower ground(?: floor)?|seminterrato|"
        "scantinato|piwnica|suterena|подвал|цоколь|цокольный этаж|sousol|cave|kellar|地下)",
        -1,
    ),
    _row(
        "dg|dachgeschoss|dach|attic|loft|combles|ático|atico|mansarda|sottotetto|zolder|poddasze|"
        "vind|roof|rooftop|terrasse|spitzboden|мансарда|чердак",
        ATTIC,
    ),
    _row("og|obergeschoss|upstairs|upper floor", 1),
    _row(
        r"(?:r ?\+ ?|\+|ebene|niveau|nivel|livello|level|lvl|lev|l|plan|og|etage|étage|floor|"
        r"stock|piso|planta|piano|e|niv|poziom|seviye|kat)[ #]?(\d{1,2})",
        0,
        1,
    ),
    _row(r"(?:r ?- ?|ebene ?-|niveau ?-|level ?-|lvl ?-|l-|plan ?-|nivel ?-|e-)(\d{1,2})", 0, -1),
    _row(rf"(\d{{1,2}})(?:st|nd|rd|th|er|ère|e|ème|eme|º|ª|°|o|a|ste|de|\.)? ?(?:{_FLOORS})", 0, 1),
    _row(rf"(\d{{1,2}})(?:st|nd|rd|th|er|e|ème|º|°|\.)? ?(?:{_CELLARS})", 0, -1),
    _row(rf"(?:{_CELLARS})[ -]?(\d{{1,2}})f?", 0, -1),
    _row(r"(?:地下|지하) ?(\d{1,2})(?:階|层|楼|층)?", 0, -1),
    _row(r"(\d{1,2})(?:f|층|楼|階|层|\. ?etasje|\. ?kerros|\. ?våning|-?й? ?этаж)", -1, 1),
)
"""Longer rows come after those of single words; the first that fits counts."""


def level_number(text: str) -> float | None:
    """The level that words name, the ground being 0; infinite for the attic, ``None`` where they
    are not known.

    >>> [level_number(w) for w in ("EG", "1. OG", "2.UG", "Ground floor", "RdC", "B1F", "3e étage")]
    [0.0, 1.0, -2.0, 0.0, 0.0, -1.0, 3.0]
    >>> level_number("2F"), level_number("first floor"), level_number("Piazza")
    (1.0, 1.0, None)
    """
    words = " ".join(text.casefold().replace("_", " ").split()).strip(" .")
    for listed, number in _ORDINALS.items():
        head, _, rest = words.partition(" ")
        words = f"{number}. {rest}" if rest and head in listed.split() else words
    spelled = (words, words.replace("-", " "), words.replace(". ", ".").replace(".", ""))
    for row in ROWS:
        found = next((m for m in map(row.words.fullmatch, spelled) if m), None)
        if found:
            return row.base + (row.step * float(found[1]) if row.step else 0.0)
    return None


def number_levels(features: Iterable[Feature]) -> tuple[tuple[Feature, ...], dict[float, str]]:
    """Features whose tags name their levels by numbers, and the words that the map has for those
    levels. Words that are not known stay, unless they are the only level there is: then that is
    the ground."""
    listed = tuple(features)
    parts = [part for f in listed for key in KEYS for part in _parts(f.tags.get(key, ""))]
    words = {part: level_number(part) for part in dict.fromkeys(parts) if not _is_number(part)}
    if not words:
        return listed, {}
    known = [value for value in words.values() if value is not None and value != ATTIC]
    known += [float(number) for part in parts if LEVEL.fullmatch(part) for number in [part]]
    if len(words) == 1 and not known:
        words = dict.fromkeys(words, 0.0)
    attic = math.floor(max(known, default=0.0)) + 1.0
    numbers = {
        part: attic if value == ATTIC else value
        for part, value in words.items()
        if value is not None
    }
    named: dict[float, Counter[str]] = {}
    for part in parts:
        if part in numbers:
            named.setdefault(numbers[part], Counter())[part] += 1
    turned = tuple(feature._replace(tags=_numbered(feature.tags, numbers)) for feature in listed)
    return turned, {level: count.most_common(1)[0][0] for level, count in named.items()}


def _parts(text: str) -> list[str]:
    return [part for part in (part.strip() for part in text.replace(",", ";").split(";")) if part]


def _is_number(part: str) -> bool:
    return bool(LEVEL.fullmatch(part) or RANGE.fullmatch(part))


def _numbered(tags: dict[str, str], numbers: dict[str, float]) -> dict[str, str]:
    """Tags with the words for levels as numbers."""
    found = dict(tags)
    for key in KEYS:
        parts = _parts(tags.get(key, ""))
        if any(part in numbers for part in parts):
            found[key] = ";".join(f"{numbers[p]:g}" if p in numbers else p for p in parts)
    return found
