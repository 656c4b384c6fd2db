"""The elements of a ``Home.xml`` that are read, counted while they are parsed.

Only known elements and attributes are kept. Document types and entities are refused, so nothing
can expand or reach outside the file; so is a single tag longer than any program writes. What a
hostile file costs is bounded before it is held.
"""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple
from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

from scenewright.core.errors import InputError

LINE = "#line"
NUMBER = "#number"
"""Keys added to every element that is read: the line it begins on, and how many began before."""
PIECES = ("pieceOfFurniture", "doorOrWindow", "light", "shelfUnit", "furnitureGroup")
_PIECE = frozenset(
    (
        "angle",
        "catalogId",
        "depth",
        "depthInPlan",
        "elevation",
        "height",
        "heightInPlan",
        "level",
        "modelMirrored",
        "movable",
        "name",
        "pitch",
        "roll",
        "visible",
        "width",
        "widthInPlan",
        "x",
        "y",
    )
)
KEPT: dict[str, frozenset[str]] = {
    "home": frozenset(("name", "wallHeight")),
    "level": frozenset(("id", "name", "elevation", "height", "visible", "viewable")),
    "wall": frozenset(
        (
            "id",
            "level",
            "xStart",
            "yStart",
            "xEnd",
            "yEnd",
            "height",
            "heightAtEnd",
            "thickness",
            "arcExtent",
            "wallAtStart",
            "wallAtEnd",
        )
    ),
    "room": frozenset(("id", "name", "level")),
    "point": frozenset(("x", "y")),
    "sash": frozenset(("xAxis", "yAxis", "width", "startAngle", "endAngle")),
    **dict.fromkeys(PIECES, _PIECE),
}
"""Elements that are read, each with its attributes; all others are passed over."""
MOST = {
    "home": 1,
    "level": 200,
    "wall": 20_000,
    "room": 5_000,
    "point": 200_000,
    "sash": 50_000,
    "doorOrWindow": 5_000,
}
MOST_PIECES = 20_000
MOST_ELEMENTS = 1_000_000
"""Elements of all kinds, read or passed over."""
MOST_ATTRIBUTES = 2_500_000
DEEPEST = 50
PORTION = 1 << 16
LONGEST_TAG = 1 << 20
"""Bytes of one tag or comment."""
LONGEST_NAME = 1000
"""Letters of an attribute that is kept; longer ones are cut."""


PICTURE = "backgroundImage"


class Document(NamedTuple):
    """The root element with what is read of it, and how many of its other elements were passed
    over, by tag."""

    root: Element
    passed: Counter[str]


class _Reading:
    """What has been parsed so far: the builder, counts by element, and how deep it stands."""

    def __init__(self) -> None:
        self.parser = expat.ParserCreate()
        self.builder = TreeBuilder()
        self.counts: Counter[str] = Counter()
        self.others: Counter[str] = Counter()
        self.depth = self.elements = self.attributes = self.passed = 0
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.StartDoctypeDeclHandler = _refuse
        self.parser.EntityDeclHandler = _refuse

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """An element begins; what lies in one that is not read is passed over too."""
        self.depth, self.elements = self.depth + 1, self.elements + 1
        if self.depth > DEEPEST:
            raise InputError("is nested too deeply", "save the home again")
        self.attributes += len(attributes)
        _check(self.elements, MOST_ELEMENTS, "elements")
        _check(self.attributes, MOST_ATTRIBUTES, "attributes")
        if self.passed or (tag not in KEPT and self.depth > 1):
            if not self.passed and (self.depth == 2 or tag == PICTURE):
                self.others[tag[:LONGEST_NAME]] += 1
            self.passed += 1
            return
        self.counts.update((tag, "piece") if tag in PIECES else (tag,))
        self._check_counts(tag)
        known = KEPT.get(tag, frozenset())
        kept = {key: text[:LONGEST_NAME] for key, text in attributes.items() if key in known}
        self.builder.start(tag, kept | self._place())

    def end(self, tag: str) -> None:
        """An element ends."""
        self.depth -= 1
        if self.passed:
            self.passed -= 1
        else:
            self.builder.end(tag)

    def _place(self) -> dict[str, str]:
        return {LINE: str(self.parser.CurrentLineNumber), NUMBER: str(self.elements)}

    def _check_counts(self, tag: str) -> None:
        if tag in PIECES:
            _check(self.counts["piece"], MOST_PIECES, "pieces")
        if tag in MOST:
            _check(self.counts[tag], MOST[tag], f"<{tag}> elements")


def tree(content: bytes) -> Document:
    """What is read of a ``Home.xml``; InputError if it is broken."""
    if not content.strip():
        raise InputError("is empty", "save the home again", place="Home.xml")
    reading = _Reading()
    try:
        _feed(reading.parser, content)
    except expat.ExpatError as error:
        where = f"Home.xml line {error.lineno}, column {error.offset + 1}"
        reason = expat.ErrorString(error.code)
        raise InputError(f"broken XML: {reason}", "save the home again", place=where) from None
    except (LookupError, UnicodeError, ValueError) as error:
        if isinstance(error, InputError):
            raise error.located(place="Home.xml") from None
        raise InputError("has an unknown encoding", "save it as UTF-8", place="Home.xml") from None
    return Document(reading.builder.close(), reading.others)


def _feed(parser: expat.XMLParserType, content: bytes) -> None:
    """Parse by portions; a tag without an end in sight is refused before it is held whole."""
    for start in range(0, len(content), PORTION):
        parser.Parse(content[start : start + PORTION], False)
        waiting = start + PORTION - max(parser.CurrentByteIndex, 0)
        if waiting > LONGEST_TAG:
            fault = f"holds a tag longer than {LONGEST_TAG // 2**20} MiB"
            raise InputError(fault, "save the home again")
    parser.Parse(b"", True)


def _check(count: int, most: int, what: str) -> None:
    if count > most:
        raise InputError(f"holds more than {most:,} {what}", "split the home into several files")


def _refuse(*_: object) -> None:
    raise InputError("has a document type or entities", "leave out the <!DOCTYPE>")
