"""The plan on a page: which pens draw walls, and the scale, by what is written and by doors."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from typing import Any

import numpy as np

from scenewright.building.drawn.drawing import Drawn
from scenewright.building.drawn.layers import kind_of_layer
from scenewright.building.drawn.paper import DARK_FILLS, LIGHT_FILLS, PAGE_FRAME, Paper, sheet_of
from scenewright.building.drawn.plan import plan_layers
from scenewright.building.drawn.sheet import Layer
from scenewright.building.drawn.units import (
    UNITS,
    USUAL_LEAF,
    UnitFound,
    fits_building,
    median_leaf,
)
from scenewright.core.errors import InputError

SCALE = re.compile(r"(?<![\d.,:/])1\s*[:∶/]\s*(\d{1,4})(?![\d.,:/])")
SCALES = (20, 25, 40, 50, 75, 100, 125, 150, 200, 250, 300, 400, 500)
"""Scales that plans are printed at."""
FEWEST, MOST_PENS = 8, 4
"""Lines that may be walls, and how many of the widest pens are tried apart."""


def plan_page(paper: Paper, scale: float = 1.0) -> dict[str, Any]:
    """The plan of a page (:func:`scenewright.building.drawn.plan.plan_sheet`): walls are what is
    dark, else what lies on layers named so, else what the widest pens draw.

    Raises :class:`InputError` where none of these makes a plan, as the last of them is refused: it
    has the most lines.
    """
    sheet, pens = sheet_of(paper)
    refusal: InputError | None = None
    for kinds in _choices(sheet.layers, pens):
        try:
            filled = kinds[DARK_FILLS] == "wall"
            chosen = sheet if filled else sheet._replace(solid=None)
            return plan_layers(chosen, kinds, lambda drawn: list_scales(drawn, paper, scale))
        except InputError as error:
            refusal = error
    raise refusal or InputError("holds no lines that may be walls", "give the plan of a storey")


def _choices(layers: dict[str, Layer], pens: dict[str, float]) -> Iterator[dict[str, str]]:
    """What lies on each layer, the likeliest choice of walls first."""
    others = dict.fromkeys(layers, "mark")
    others |= {name: "aside" for name in (LIGHT_FILLS, PAGE_FRAME) if name in layers}
    named = {name: kind_of_layer(name) for name in pens}
    aside = {name: "aside" for name, kind in named.items() if kind == "other"}
    sets = [{DARK_FILLS}, {name for name, kind in named.items() if kind == "wall"}]
    widths = sorted({round(pens[name], 2) for name in pens if name not in aside}, reverse=True)
    for width in [*widths[:MOST_PENS], *widths[MOST_PENS:][-1:]]:
        sets.append({name for name in pens if pens[name] >= width - 0.01 and name not in aside})
    tried: list[set[str]] = []
    for walls in sets:
        if walls not in tried and sum(len(layers[name].lines) for name in walls) >= FEWEST:
            tried.append(walls)
            yield others | aside | dict.fromkeys(walls, "wall")


def list_scales(drawn: Drawn, paper: Paper, scale: float) -> list[UnitFound]:
    """Metres a unit of the page may be: as asked, as written (1:50), else by the leaves of doors.

    Raises :class:`InputError` where nothing tells.
    """
    if scale != 1.0:
        return [UnitFound(f"1:{scale:g}", paper.metres * scale, True)]
    written = written_scales(paper)
    if written:
        return [UnitFound(f"1:{number}", paper.metres * number, True) for number in written]
    leaf = median_leaf(drawn)
    if leaf is None:
        raise InputError(
            "names no scale such as 1:50, and has no leaves of doors to tell it by",
            "give --scale 50 for a plan at 1:50 (of a screen: at 96 px an inch)",
        )
    rows = [(f"1:{number}", paper.metres * number) for number in SCALES]
    if not paper.printed:
        rows = [*UNITS, ("by its doors", USUAL_LEAF / leaf)]
    fitting = [UnitFound(*row, False) for row in rows if fits_building(drawn, row[1])]
    if paper.printed:
        fitting.sort(key=lambda unit: abs(np.log(leaf * unit.metres / USUAL_LEAF)))
    return fitting


def written_scales(paper: Paper) -> list[int]:
    """The scales that words of a page name, the 50 of 1:50, the most frequent first."""
    numbers = [int(m) for word in paper.words for m in SCALE.findall(word.words)]
    return [number for number, _ in Counter(n for n in numbers if 5 <= n <= 1000).most_common(4)]
