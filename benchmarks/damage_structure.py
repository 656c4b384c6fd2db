"""Damage that keeps what a file is made of: lines, elements of XML, packed streams, blocks.

Bytes turned over are refused by the first check of a parser. What stays well formed comes further:
a reference to another entity, an element in another's place, a number that is a word.
"""

from __future__ import annotations

import bz2
import copy
import gzip
import re
import zlib
from collections.abc import Callable
from xml.etree import ElementTree

from benchmarks.damage import Damage, Draw, damage_bytes, damage_json, damage_text

WORD = re.compile(r"#?-?[\w.]+|'[^']*'|\$|\*")
ODD_WORDS = (
    "$", "*", "0", "-1", "1e38", "1e-300", "nan", "inf", "1e999", "9" * 400, "", "x", "''", "#1",
    "#0", "#99999999", ".T.", "()", "(" * 3000, "'" + "y" * 70_000 + "'", "\\X2\\D83D\\X0\\",
    "\x00", "-0.0", "4294967296", "2147483647", "../../x", "-2147483649", "0.0000001",
)  # fmt: skip
STREAM = re.compile(
    rb"/Length\s+(\d+)(?P<head>[^>]{0,200}>>\s*stream\r?\n)(?P<body>.*?)endstream", re.S
)
Packing = tuple[Callable[[bytes], bytes], Callable[[bytes], bytes]]
GZIP: Packing = (gzip.decompress, lambda data: gzip.compress(data, 1))
BZIP: Packing = (bz2.decompress, lambda data: bz2.compress(data, 1))


def damage_lines(data: bytes, draw: Draw) -> bytes:
    """Lines left out, repeated or exchanged, and words in them by others; or text damaged."""
    if draw.random() < 0.25:
        return damage_text(data, draw)
    lines = data.decode("latin-1").splitlines()
    for _ in range(draw.randint(1, 5)):
        _change_line(lines, draw)
    return "\n".join(lines).encode("latin-1", "replace")


def _change_line(lines: list[str], draw: Draw) -> None:
    if not lines:
        return
    kind, at, other = draw.randrange(12), draw.randrange(len(lines)), draw.randrange(len(lines))
    if kind == 0:
        del lines[at : at + draw.choice((1, 1, 2, 30))]
    elif kind == 1:
        lines[at:at] = lines[other : other + draw.choice((1, 2, 40))] * draw.choice((1, 1, 50))
    elif kind == 2:
        lines[at], lines[other] = lines[other], lines[at]
    else:
        words = list(WORD.finditer(lines[at]))
        others = WORD.findall(lines[other])
        if words:
            word = draw.choice(words)
            new = draw.choice(others) if others and draw.random() < 0.4 else draw.choice(ODD_WORDS)
            lines[at] = lines[at][: word.start()] + new + lines[at][word.end() :]


def damage_xml(data: bytes, draw: Draw) -> bytes:
    """Elements left out, repeated, moved or emptied and attributes changed, still XML; or text
    damaged."""
    if draw.random() < 0.25:
        return damage_text(data, draw)
    try:
        root = ElementTree.fromstring(data)
    except ElementTree.ParseError:
        return damage_text(data, draw)
    try:
        for _ in range(draw.randint(1, 5)):
            _change_element(root, draw)
        return ElementTree.tostring(root, "utf-8", xml_declaration=True)
    except RecursionError:  # nested twice
        return damage_text(data, draw)


def _change_element(root: ElementTree.Element, draw: Draw) -> None:
    parents = [one for one in root.iter() if len(one)]
    parent = draw.choice(parents) if parents else root
    child = parent[draw.randrange(len(parent))] if len(parent) else root
    kind = draw.randrange(10)
    if child is root and kind < 5:
        return
    if kind == 0:
        parent.remove(child)
    elif kind == 1:
        parent.extend([copy.copy(child) for _ in range(draw.choice((1, 2, 300)))])
    elif kind == 2:
        child.extend([copy.deepcopy(draw.choice(parents))])
    elif kind == 3:
        child.clear()
    elif kind == 4:
        _nest(child, draw.choice((3, 100, 600)))
    elif kind < 7 and child.text and child.text.strip():
        child.text = _change_words(child.text, draw)
    elif child.attrib:
        key = draw.choice(sorted(child.attrib))
        child.set(key, _change_words(child.get(key, ""), draw))


def _nest(element: ElementTree.Element, depth: int) -> None:
    for _ in range(depth):
        element = ElementTree.SubElement(element, element.tag)


def _change_words(text: str, draw: Draw) -> str:
    """A text with a word exchanged, of letters that XML may hold."""
    words = list(WORD.finditer(text))
    new = draw.choice(ODD_WORDS).replace("\x00", "\t")
    if not words or draw.random() < 0.2:
        return new
    word = draw.choice(words)
    return text[: word.start()] + new + text[word.end() :]


def damage_streams(data: bytes, draw: Draw) -> bytes:
    """The content of a packed stream of a PDF damaged within it; or words of the file."""
    streams = list(STREAM.finditer(data))
    if not streams or draw.random() < 0.5:
        return (damage_lines if draw.random() < 0.6 else damage_bytes)(data, draw)
    one = draw.choice(streams)
    try:
        body = zlib.decompress(one["body"])
    except zlib.error:
        return damage_bytes(data, draw)
    packed = zlib.compress((damage_lines if b"\x00" not in body else damage_bytes)(body, draw))
    stated = b"/Length %d" % len(packed)
    return data[: one.start()] + stated + one["head"] + packed + b"\nendstream" + data[one.end() :]


def damage_packed(inner: Damage, packing: Packing) -> Damage:
    """The content of a packed file damaged by ``inner``; or the packed bytes."""
    unpack, pack = packing

    def damage(data: bytes, draw: Draw) -> bytes:
        if draw.random() < 0.3:
            return damage_bytes(data, draw)
        return pack(inner(unpack(data), draw))

    return damage


def damage_json_lines(data: bytes, draw: Draw) -> bytes:
    """One line of JSON among others damaged; or lines exchanged."""
    if draw.random() < 0.3:
        return damage_lines(data, draw)
    lines = data.split(b"\n")
    at = draw.randrange(len(lines))
    lines[at] = damage_json(lines[at], draw)
    return b"\n".join(lines)
