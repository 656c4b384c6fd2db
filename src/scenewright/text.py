"""Text from outside: what is no text at all, and what must not be shown as it is.

Half of a surrogate pair (U+D800 to U+DFFF alone) is no character: UTF-8 cannot hold it. Control,
escape and bidirectional characters are text, but a terminal obeys them. A spreadsheet takes a cell
that begins with ``=``, ``+``, ``-`` or ``@`` for a formula.
"""

from __future__ import annotations

import re
import unicodedata

JOINERS = "\u200c\u200d"
"""Invisible characters that scripts and emoji need, and that only join their neighbours."""
HALF = re.compile(r"\\u[dD][89a-fA-F]")
"""A surrogate as JSON escapes it, alone or half of a pair."""
FORMULA = ("=", "+", "-", "@", "\t", "\r")
STROKES = str.maketrans({"ł": "l", "ø": "o", "đ": "d", "ı": "i", "æ": "ae", "œ": "oe", "ё": "е"})
"""Letters that are no plain one with an accent, as people write them without."""
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def is_whole(text: str) -> bool:
    """Whether a text can be written as UTF-8: no half of a surrogate pair is in it.

    >>> is_whole("Küche"), is_whole("K\\ud800che")
    (True, False)
    """
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True


def fold_letters(text: str) -> str:
    """Small letters without accents, as names are compared: full-width letters become plain, and
    the signs of other scripts stay as they are.

    >>> fold_letters("Küche ＷＣ"), fold_letters("ベッド")
    ('kuche wc', 'ベッド')
    """
    small = unicodedata.normalize("NFKC", text).casefold().translate(STROKES)
    return "".join(
        unicodedata.normalize("NFD", sign)[0] if ord(sign) < 0x250 else sign for sign in small
    )


def plural(word: str) -> str:
    """The plural of a name.

    >>> [plural(word) for word in ("showcase", "fridge shelf", "box", "bench", "lockers")]
    ['showcases', 'fridge shelves', 'boxes', 'benches', 'lockers']
    >>> plural("category"), plural("free bay"), plural("building"), plural("shelving")
    ('categories', 'free bays', 'buildings', 'shelving')
    """
    if word.endswith("shelf"):
        return word[:-1] + "ves"
    if word.endswith("y") and word[-2:-1] not in tuple("aeiou"):
        return word[:-1] + "ies"
    if word.endswith(("ss", "x", "ch", "sh")):
        return word + "es"
    alike = word.endswith(("s", "ing")) and not word.endswith("building")
    return word if alike else word + "s"


def quantity(count: int, word: str) -> str:
    """A number of things in words.

    >>> quantity(1, "tree"), quantity(0, "tree"), quantity(1200, "new building")
    ('1 tree', '0 trees', '1,200 new buildings')
    """
    return f"{count:,} {word if count == 1 else plural(word)}"


def printable(text: str) -> str:
    """A text on one line, without what a terminal would obey: runs of white space become a space,
    control, escape and bidirectional characters the sign U+FFFD.

    >>> printable("a\\nb\\x1b[31m"), printable("abc\\u202e")
    ('a b\ufffd[31m', 'abc\ufffd')
    """
    return printable_lines(" ".join(text.split()))


def printable_lines(text: str) -> str:
    """As :func:`printable`, but as long as before, and its line feeds stay."""
    if text.isascii() and text.isprintable():
        return text
    return "".join(map(_replace_character, text))


def escape_unprintable(json_text: str) -> str:
    """The text of a JSON document with the same content, whose strings a terminal prints as they
    are: what it would obey is escaped.

    >>> escape_unprintable('["a\\x9b", "b"]')
    '["a\\\\u009b", "b"]'
    """
    if json_text.isascii() and "\x7f" not in json_text:
        return json_text
    return "".join(
        c if c == "\n" or c.isprintable() or c in JOINERS else _escape_character(c)
        for c in json_text
    )


def neutralize_cell(cell: object) -> object:
    """A cell of a CSV table that no spreadsheet takes for a formula: text that begins like one
    gets an apostrophe in front. Numbers stay.

    >>> [neutralize_cell(cell) for cell in ("=1+1", "-2.5", "sofa", 3)]
    ["'=1+1", '-2.5', 'sofa', 3]
    """
    plain = not isinstance(cell, str) or not cell.startswith(FORMULA) or NUMBER.fullmatch(cell)
    return cell if plain else f"'{cell}"


def restore_cell(cell: str) -> str:
    """The cell before :func:`neutralize_cell`.

    >>> restore_cell("'=1+1"), restore_cell("'s-Graveland")
    ('=1+1', "'s-Graveland")
    """
    return cell[1:] if cell.startswith("'") and cell[1:].startswith(FORMULA) else cell


def _replace_character(character: str) -> str:
    if character == "\n" or character.isprintable() or character in JOINERS:
        return character
    return " " if character.isspace() else "\ufffd"


def _escape_character(character: str) -> str:
    """A character as JSON escapes it, of two halves above U+FFFF."""
    data = character.encode("utf-16-be", "surrogatepass")
    return "".join(f"\\u{data[k]:02x}{data[k + 1]:02x}" for k in range(0, len(data), 2))
