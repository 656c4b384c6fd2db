"""Java properties: ``key = value`` lines, ISO-8859-1 with ``\\\\uXXXX``, lines that go on.

As java.util.Properties reads them (Java SE API).
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from scenewright.core.document_faults import BROKEN
from scenewright.core.errors import InputError
from scenewright.text import is_whole

MOST_ENTRIES = 200_000
LONGEST = 20_000
SIGNS = {"t": "\t", "n": "\n", "r": "\r", "f": "\f"}


def properties(content: bytes) -> dict[str, str]:
    """All entries; of equal keys the last counts.

    >>> properties(b"# a note\\nname#1 = Caf\\\\u00e9\\nlong: one \\\\\\n   two\\nid=SweetHome3D#A")
    {'name#1': 'Café', 'long': 'one two', 'id': 'SweetHome3D#A'}
    """
    found: dict[str, str] = {}
    for line in _lines(content.decode("latin-1")):
        key, value = _split(line)
        found[_plain(key)] = _plain(value)
        if len(found) > MOST_ENTRIES:
            raise InputError(f"has more than {MOST_ENTRIES:,} entries", "split the library")
    return found


def _lines(text: str) -> Iterator[str]:
    """Lines that say something, with those that go on put together."""
    parts: list[str] = []
    for raw in re.split(r"\r\n|\n|\r", text):
        line = raw.lstrip(" \t\f")
        if not parts and (not line or line[0] in "#!"):
            continue
        goes_on = (len(line) - len(line.rstrip("\\"))) % 2 == 1
        parts.append(line[:-1] if goes_on else line)
        if goes_on:
            continue
        yield "".join(parts)
        parts = []
    if parts:
        yield "".join(parts)


def _split(line: str) -> tuple[str, str]:
    """Key and value: parted by the first ``=``, ``:`` or space that is not escaped."""
    if len(line) > LONGEST:
        raise InputError(f"a line is longer than {LONGEST:,} signs", "shorten it")
    end = re.match(r"(?:\\.|[^\\=: \t\f])*", line)
    key = end.group(0) if end else line
    rest = line[len(key) :].lstrip(" \t\f")
    if rest[:1] in ("=", ":"):
        rest = rest[1:].lstrip(" \t\f")
    return key, rest


def _plain(text: str) -> str:
    """The text with its escapes resolved."""

    def sign(match: re.Match[str]) -> str:
        code = match.group(1)
        if len(code) == 5:
            return chr(int(code[1:], 16))
        return SIGNS.get(code, code)

    found = re.sub(r"\\(u[0-9a-fA-F]{4}|.)", sign, text)
    joined = found.encode("utf-16", "surrogatepass").decode("utf-16", "surrogatepass")
    if not is_whole(joined):
        raise InputError(BROKEN[0], f"give {BROKEN[1]}", place=joined)
    return joined
