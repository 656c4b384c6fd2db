"""Names of drawn rooms: the words in each that no size, note or number is."""

from __future__ import annotations

import re
from collections.abc import Sequence

from shapely import Point, Polygon, prepare

from scenewright.building.drawn.drawing import Word
from scenewright.building.room_names import says_nothing

CODES = re.compile(r"%%[uocdp]|\\[A-Za-z][^;]*;|[{}]", re.IGNORECASE)
SIZE = re.compile(r"\d\s*['\"′″x×*]|\d\s*(?:m²|m2|mm|cm|sq|qm|кв)|^[\W\d]+$", re.IGNORECASE)
LONGEST_WORDS = 30
LARGER = 1.25
"""How much larger a name is than what else is written in a room."""
MOST_NAMES = 4
"""Names that an open plan may have."""


def clean_words(words: str) -> str:
    """Words without codes of CAD programs.

    >>> clean_words("%%uGREAT ROOM"), clean_words("{\\\\fArial;Bad}")
    ('GREAT ROOM', 'Bad')
    """
    return " ".join(CODES.sub("", words).split())


def is_name(words: str) -> bool:
    """Whether words may name a room.

    >>> [is_name(w) for w in ("KITCHEN", "13'8 x 14'", "2668", "5.3 m²", "n=1 r=2")]
    [True, False, False, False, False]
    """
    letters = sum(letter.isalpha() for letter in words)
    short = letters >= 2 and len(words) <= LONGEST_WORDS and "=" not in words
    plain = letters >= 0.7 * len(words.replace(" ", ""))
    return short and plain and SIZE.search(words) is None


def name_rooms(words: Sequence[Word], rooms: Sequence[Polygon]) -> list[str]:
    """The name of each room; empty where no words in it are one. Lines that stand close above each
    other are one name; where names are known words for rooms, others are left aside; where none is,
    the largest words are the name."""
    lines = [word._replace(words=clean_words(word.words)) for word in words]
    lines = _join_lines([line for line in lines if is_name(line.words)])
    found = []
    for room in rooms:
        prepare(room)
        inside = [line for line in lines if room.contains(Point(line.x, line.y))]
        known = [line.words for line in inside if not says_nothing(line.words)]
        names = list(dict.fromkeys(known or _largest(inside)))
        found.append(" / ".join(names[:MOST_NAMES])[:80])
    return found


def _largest(lines: Sequence[Word]) -> list[str]:
    """The words clearly larger than all others, if there are such."""
    sizes: dict[str, float] = {}
    for line in lines:
        sizes[line.words] = max(line.size, sizes.get(line.words, 0.0))
    ranked = sorted(sizes, key=lambda words: -sizes[words])
    alone = len(ranked) == 1 or (ranked and sizes[ranked[0]] >= LARGER * sizes[ranked[1]])
    return ranked[:1] if alone else []


def _join_lines(lines: list[Word]) -> list[Word]:
    """Lines of one size close below each other as one, if they say no more alone."""
    found: list[Word] = []
    for line in sorted(lines, key=lambda word: -word.y):
        above = next((k for k, word in enumerate(found) if _is_below(line, word)), None)
        if above is None:
            found.append(line)
        else:
            joined = f"{found[above].words} {line.words}"
            found[above] = found[above]._replace(words=joined, y=line.y)
    return found


def _is_below(line: Word, above: Word) -> bool:
    size = max(line.size, 1e-9)
    close = 0 < above.y - line.y <= 2.2 * size and abs(above.x - line.x) <= 4 * size
    alike = abs(above.size - line.size) < 0.1 * size
    both = not says_nothing(line.words) and not says_nothing(above.words)
    short = len(f"{above.words} {line.words}") <= LONGEST_WORDS
    return short and close and alike and not (both and len(above.words.split()) > 1)
