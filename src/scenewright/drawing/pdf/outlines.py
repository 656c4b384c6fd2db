"""The outlines of letters as paths of PDF."""

from __future__ import annotations

from typing import Any

from fontTools.pens.basePen import BasePen


class PathPen(BasePen):
    """Collects the operators of outlines, scaled and moved."""

    def __init__(self, glyphs: Any, scale: float) -> None:
        super().__init__(glyphs)
        self.scale, self.x, self.y = scale, 0.0, 0.0
        self.operators: list[str] = []

    def _at(self, point: tuple[float, float]) -> str:
        return f"{self.x + point[0] * self.scale:.3f} {self.y + point[1] * self.scale:.3f}"

    def _moveTo(self, point: tuple[float, float]) -> None:  # noqa: N802
        self.operators.append(f"{self._at(point)} m")

    def _lineTo(self, point: tuple[float, float]) -> None:  # noqa: N802
        self.operators.append(f"{self._at(point)} l")

    def _curveToOne(self, *points: tuple[float, float]) -> None:  # noqa: N802
        self.operators.append(" ".join(map(self._at, points)) + " c")

    def _closePath(self) -> None:  # noqa: N802
        self.operators.append("h")


def outline_words(font: Any, words: str, size: float, x: float, y: float) -> str:
    """The outlines of words ``size`` points high whose baseline starts at a point."""
    glyphs, names = font.ttfont.getGlyphSet(), font.ttfont.getBestCmap()
    scale = size / font.ttfont["head"].unitsPerEm
    pen = PathPen(glyphs, scale)
    pen.x, pen.y = x, y
    for letter in words:
        glyph = glyphs[names.get(ord(letter), ".notdef")]
        glyph.draw(pen)
        pen.x += glyph.width * scale
    return " ".join(pen.operators)
