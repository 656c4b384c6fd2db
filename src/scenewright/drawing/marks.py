"""Marks on paper: the few SVG elements a plan is made of, in millimetres, as text.

Paper runs x to the right and y down from the upper left corner; plans run y up. A
:class:`PaperView` takes one to the other.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple
from xml.sax.saxutils import escape, quoteattr

import numpy as np
from numpy.typing import ArrayLike, NDArray

CUT, OUTLINE, LINE, FINE = 0.5, 0.35, 0.18, 0.1
"""Pens in millimetres: cut walls, frames, edges of things, details."""

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


def tag(name: str, content: str = "", **attributes: str | float) -> str:
    """One element; underscores in attribute names stand for hyphens, values are escaped.

    >>> tag("circle", r=2.50, stroke_width=0.1)
    '<circle r="2.5" stroke-width="0.1"/>'
    """
    pairs = "".join(
        f" {key.rstrip('_').replace('_', '-')}={quoteattr(_text(value))}"
        for key, value in attributes.items()
    )
    return f"<{name}{pairs}>{content}</{name}>" if content else f"<{name}{pairs}/>"


def group(marks: Iterable[str], **attributes: str | float) -> str:
    """Marks that share their attributes; nothing at all if there are none."""
    content = "\n".join(mark for mark in marks if mark)
    return tag("g", f"\n{content}\n", **attributes) if content else ""


def outline(points: ArrayLike, closed: bool = True) -> str:
    """Path data through paper points ``(k, 2)``."""
    steps = " ".join(f"{number(x)},{number(y)}" for x, y in np.asarray(points, dtype=float))
    return f"M{steps}{'Z' if closed else ''}"


def shape(rings: Sequence[ArrayLike], **attributes: str | float) -> str:
    """One filled path of several rings; inner rings are holes."""
    return tag("path", "", d="".join(outline(ring) for ring in rings), **attributes)


def line(points: ArrayLike, **attributes: str | float) -> str:
    """An open line through paper points."""
    return tag("path", "", d=outline(points, closed=False), **attributes)


def text(
    words: str, at: ArrayLike, size: float, turn: float = 0.0, **attributes: str | float
) -> str:
    """Text centred at a paper point (its middle height), turned by degrees counter-clockwise."""
    x, y = np.asarray(at, dtype=float)
    place: dict[str, str | float] = {"x": x, "y": y, "dy": 0.35 * size}
    if turn:
        place["transform"] = f"rotate({number(-turn)} {number(x)} {number(y)})"
    style: dict[str, str | float] = {"font_size": size, "text_anchor": "middle"}
    return tag("text", escape(clean(words, 120)), **(place | style | attributes))


def plate(words: str, at: ArrayLike, size: float, **attributes: str | float) -> str:
    """Text over a white halo, to stand on lines and tints."""
    halo: dict[str, str | float] = {
        "stroke": "#ffffff",
        "stroke_width": 0.45 * size,
        "stroke_linejoin": "round",
    }
    turn = float(attributes.pop("turn", 0.0))
    plain: dict[str, str | float] = attributes | {"stroke": "none"}
    return text(words, at, size, turn, **(attributes | halo)) + text(words, at, size, turn, **plain)


def arrow_head(tip: ArrayLike, way: ArrayLike, size: float) -> NDArray[np.float64]:
    """Corners of a slender triangle ``size`` long whose tip points along ``way``, on paper."""
    point, ahead = np.asarray(tip, dtype=float), np.asarray(way, dtype=float)
    ahead = ahead / max(float(np.hypot(*ahead)), 1e-12)
    side = 0.36 * size * np.array([-ahead[1], ahead[0]])
    foot = point - size * ahead
    return np.array([point, foot + side, foot - side])


def title(words: str) -> str:
    """The words a viewer shows when the pointer rests on the group this stands in."""
    return tag("title", escape(clean(words)))


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


def number(value: float) -> str:
    """A length to a hundredth of a millimetre, short.

    >>> [number(v) for v in (1.0, -0.001, 12.345)]
    ['1', '0', '12.35']
    """
    short = f"{float(value):.2f}".rstrip("0").rstrip(".")
    return "0" if short == "-0" else short


def _text(value: str | float) -> str:
    return value if isinstance(value, str) else number(value)
