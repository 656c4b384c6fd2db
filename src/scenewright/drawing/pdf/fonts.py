"""Fonts for PDF: Noto Sans, Noto Sans CJK where it is needed, then fonts of the system.

The first two come with the extra ``pdf``, so that a drawing is the same wherever it is made. Bold
letters are drawn with an outline: no font need be embedded twice.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

SYSTEM = (
    "/usr/share/fonts",
    "/usr/local/share/fonts",
    "/System/Library/Fonts",
    "/Library/Fonts",
    os.path.join(os.environ.get("WINDIR", r"C:\Windows"), "Fonts"),
)
PACKED = (("fontpkg_noto_sans", "NotoSans[[]*.ttf"), ("noto_cjk_sans_jp_regular", "*.otf"))
"""Packages of fonts and the file of each, in the order they are tried."""
MOST_FILES = 400
MISSING = "?"
"""The substitute for letters that no font has."""


class Run(NamedTuple):
    """Words of one font, and the family it is known by."""

    family: str
    words: str


class Fonts:
    """The fonts of a document; further ones are added when letters need them."""

    def __init__(self, pdf: Any) -> None:
        self._pdf = pdf
        self._files = _files()
        self._families: list[tuple[str, frozenset[int]]] = []
        self._lacking: set[int] = set()

    def runs(self, words: str) -> list[Run]:
        """Words parted by font; letters that no font has become question marks."""
        found: list[Run] = []
        for letter in words:
            family = self._family_of(ord(letter))
            written = letter if family else MISSING
            family = family or self._families[0][0]
            if found and found[-1].family == family:
                found[-1] = Run(family, found[-1].words + written)
            else:
                found.append(Run(family, written))
        return found

    def _family_of(self, code: int) -> str:
        for family, codes in self._families:
            if code in codes:
                return family
        if code in self._lacking:
            return ""
        for path in self._files:
            self._add(path)
            if self._families and code in self._families[-1][1]:
                return self._families[-1][0]
        self._lacking.add(code)
        return ""

    def _add(self, path: Path) -> None:
        family = f"f{len(self._families)}"
        try:
            self._pdf.add_font(family, fname=str(path))
        except Exception:  # a broken or unusual font of the system is passed over
            return
        self._families.append((family, frozenset(self._pdf.fonts[family].cmap)))


def _files() -> Iterator[Path]:
    for package, pattern in PACKED:
        found = find_spec(package)
        for folder in (found.submodule_search_locations or []) if found else []:
            yield from sorted(Path(folder).rglob(pattern))
    count = 0
    for folder in SYSTEM:
        for path in sorted(Path(folder).rglob("*.ttf")) if os.path.isdir(folder) else []:
            count += 1
            if count > MOST_FILES:
                return
            yield path


def name_missing() -> ModuleNotFoundError | None:
    """The error of a missing package of fonts, if the base font is not installed."""
    return (
        None
        if find_spec(PACKED[0][0]) or "pyodide" in sys.modules
        else (ModuleNotFoundError("no fonts", name=PACKED[0][0]))
    )
