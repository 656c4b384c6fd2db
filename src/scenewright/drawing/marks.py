"""Marks on paper: the few things a plan is made of, in millimetres, as plain values.

Lines, filled shapes, curves, discs, words and groups of them; what file they become is not said
here (:mod:`scenewright.drawing.svg` writes them). Paper runs x to the right and y down from the
upper left corner; plans run y up. A :class:`PaperView` takes one to the other.

A style holds the pen and fill by the names of SVG's presentation attributes with underscores:
``stroke``, ``stroke_width``, ``stroke_dasharray``, ``fill``, ``fill_rule``, ``font_weight`` …; what
a mark does not say it takes from the groups it is in.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.core.space import Points
from scenewright.drawing.meanings import Meaning

CUT, OUTLINE, LINE, FINE = 0.5, 0.5, 0.25, 0.13
"""Pens in millimetres, three of them: what is cut and what frames the sheet, edges that are seen,
thin lines (ISO 128-23 draws building plans in groups of 0.5, 0.25 and 0.13)."""

INK, GREY, PALE, POCHE = "#1f2226", "#6d7278", "#c9c7c1", "#34383e"
ROUTE, WARNING, EXIT = "#0064a8", "#c24a00", "#007a4d"
"""Colours that stay apart in grey and for colour-blind readers (after Okabe and Ito, 2008)."""

_UNPRINTABLE = re.compile(
    "[\x00-\x1f\x7f-\x9f\u2028-\u202e\u2066-\u2069\ud800-\udfff\ufdd0-\ufdef\ufffe\uffff]"
)


class PaperView(NamedTuple):
    """Paper millimetres a metre, and where the plan's origin falls on the paper."""

    scale: float
    x: float
    y: float


def to_paper(view: PaperView, points: ArrayLike) -> NDArray[np.float64]:
    """Plan points ``(..., 2)`` in metres as paper points in millimetres.

    >>> to_paper(PaperView(20.0, 10.0, 100.0), [[1.0, 2.0]]).tolist()
    [[30.0, 60.0]]
    """
    return np.asarray(points, dtype=float) * (view.scale, -view.scale) + (view.x, view.y)


Style = Mapping[str, str | float]


class PathMark(NamedTuple):
    """Rings ``(k, 2)`` filled as one shape, inner rings holes; one open line if not ``closed``."""

    rings: tuple[Points, ...]
    closed: bool
    style: Style


class CurveMark(NamedTuple):
    """Cubic pieces through ``points`` (3 k + 1, 2): an end, two handles, an end, …"""

    points: Points
    style: Style


class ArcMark(NamedTuple):
    """The shorter arc of a circle from ``start`` to ``end``, clockwise on paper or not."""

    start: tuple[float, float]
    end: tuple[float, float]
    radius: float
    clockwise: bool
    style: Style


class DiscMark(NamedTuple):
    """A circle around a point."""

    x: float
    y: float
    radius: float
    style: Style


class TextMark(NamedTuple):
    """Words ``size`` high with their middle height at a point, turned by degrees
    counter-clockwise; where they are anchored is in the style (``middle`` unless stated)."""

    words: str
    x: float
    y: float
    size: float
    turn: float
    style: Style


class NoteMark(NamedTuple):
    """Words a viewer shows when the pointer rests on the group this stands in."""

    words: str


class CopyMark(NamedTuple):
    """A :class:`Stencil` at a point, turned by degrees clockwise, with the words of a note."""

    stencil: str
    x: float
    y: float
    turn: float
    note: NoteMark


class GroupMark(NamedTuple):
    """Marks that share a style."""

    marks: tuple[Mark, ...]
    style: Style


class MeantMark(NamedTuple):
    """A mark with what it stands for (:mod:`scenewright.drawing.meanings`)."""

    mark: Mark
    meaning: Meaning


class PictureMark(NamedTuple):
    """Pixels ``(height, width, 3)`` in a box: its upper left corner and its size."""

    pixels: NDArray[np.uint8]
    x: float
    y: float
    width: float
    height: float


Mark = (
    PathMark
    | CurveMark
    | ArcMark
    | DiscMark
    | TextMark
    | NoteMark
    | CopyMark
    | GroupMark
    | MeantMark
    | PictureMark
)

NOTHING = GroupMark((), {})
"""The mark that leaves the paper as it is."""


class Stencil(NamedTuple):
    """Marks around the origin that are drawn more than once, by their id."""

    id: str
    marks: tuple[Mark, ...]


class FillPattern(NamedTuple):
    """A tile, ``width`` by ``height``, that fills shapes by its id, turned by degrees clockwise;
    ``paper`` is the colour under its marks, if any."""

    id: str
    width: float
    height: float
    turn: float
    paper: str
    marks: tuple[Mark, ...]


Definition = Stencil | FillPattern


def group(marks: Iterable[Mark], **style: str | float) -> Mark:
    """Marks that share a style; nothing at all if there are none."""
    drawn = tuple(mark for mark in marks if not is_blank(mark))
    return GroupMark(drawn, style) if drawn else NOTHING


def is_blank(mark: Mark) -> bool:
    """Whether a mark leaves the paper as it is."""
    if isinstance(mark, MeantMark):
        return is_blank(mark.mark)
    return isinstance(mark, GroupMark) and not mark.marks


def shape(rings: Sequence[ArrayLike], **style: str | float) -> Mark:
    """One filled shape of several rings ``(k, 2)``; inner rings are holes."""
    return PathMark(tuple(np.asarray(ring, dtype=float) for ring in rings), True, style)


def line(points: ArrayLike, **style: str | float) -> Mark:
    """An open line through paper points ``(k, 2)``."""
    return PathMark((np.asarray(points, dtype=float),), False, style)


def disc(at: ArrayLike, radius: float, **style: str | float) -> Mark:
    """A circle around a paper point."""
    x, y = np.asarray(at, dtype=float).tolist()
    return DiscMark(x, y, radius, style)


def text(words: str, at: ArrayLike, size: float, turn: float = 0.0, **style: str | float) -> Mark:
    """Text centred at a paper point (its middle height), turned by degrees counter-clockwise."""
    x, y = np.asarray(at, dtype=float).tolist()
    return TextMark(clean(words, 120), x, y, size, turn, style)


def plate(words: str, at: ArrayLike, size: float, **attributes: str | float) -> Mark:
    """Text over a white halo, to stand on lines and tints."""
    halo: dict[str, str | float] = {
        "stroke": "#ffffff",
        "stroke_width": 0.45 * size,
        "stroke_linejoin": "round",
    }
    turn = float(attributes.pop("turn", 0.0))
    plain: dict[str, str | float] = attributes | {"stroke": "none"}
    both = (attributes | halo, plain)
    return group([text(words, at, size, turn, **style) for style in both])


def arrow_head(tip: ArrayLike, way: ArrayLike, size: float) -> NDArray[np.float64]:
    """Corners of a slender triangle ``size`` long whose tip points along ``way``, on paper."""
    point, ahead = np.asarray(tip, dtype=float), np.asarray(way, dtype=float)
    ahead = ahead / max(float(np.hypot(*ahead)), 1e-12)
    side = 0.36 * size * np.array([-ahead[1], ahead[0]])
    foot = point - size * ahead
    return np.array([point, foot + side, foot - side])


def title(words: str) -> Mark:
    """The words a viewer shows when the pointer rests on the group this stands in."""
    return NoteMark(clean(words))


def clean(words: str, longest: int = 48) -> str:
    """Words fit to print: one line, no control or direction characters, not too long.

    >>> clean("Kitchen\\n\\x00<b>")
    'Kitchen <b>'
    """
    plain = " ".join(_UNPRINTABLE.sub(" ", words).split())
    return plain if len(plain) <= longest else plain[: longest - 1].rstrip() + "…"


def text_width(words: str, size: float) -> float:
    """A fair guess of the width of printed words: wide scripts take a full em a character."""
    return size * sum(1.0 if ord(letter) > 0x2E7F else 0.58 for letter in words)


def fit_text(
    words: str, size: float, room: float, smallest: float = 0.65, wide: float = 1.0
) -> tuple[str, float]:
    """The words and the text height at which they fit into ``room`` millimetres: as large as
    possible, from ``smallest`` times the size on cut short. ``wide`` is for bold letters.

    >>> fit_text("Kitchen", 2.0, 100.0)
    ('Kitchen', 2.0)
    >>> fit_text("Kitchen and dining room", 2.0, 15.0)
    ('Kitchen and dining…', 1.3)
    """
    need = wide * text_width(words, size)
    if need <= room:
        return words, size
    size *= max(smallest, room / need)
    count = len(words)
    while count > 1 and wide * text_width(clean(words, count), size) > room + 1e-6:
        count -= 1
    return clean(words, count), size
