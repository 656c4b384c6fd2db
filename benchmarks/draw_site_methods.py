"""Draws ``docs/site-methods.svg``: how every method fares as the scene grows.

``python -m benchmarks.draw_site_methods ROWS.json [FILE.svg]``, with rows of
:mod:`.site_methods`: ``python -m benchmarks.draw_site_methods --measure SEEDS ROWS.json``. Medians
over the seeds with their quartiles; above at equal evaluations, below at equal wall time.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.site_methods import BUDGETS, EVALUATIONS, SECONDS, chosen, rows
from scenewright.drawing.marks import GREY, INK, PALE, Mark, group, line, shape, text
from scenewright.drawing.svg import mark_text, number, tag

Row = dict[str, Any]
FONT = "Helvetica, Arial, 'DejaVu Sans', sans-serif"
COLOURS = {
    "default": ("ours", "#0b6e4f"),
    "paper": ("the paper's", "#8c1d18"),
    "vp": ("vp, repaired", "#d9602b"),
    "sga": ("sga", "#d99000"),
    "sa": ("sa", "#0064a8"),
    "sa-free": ("sa-free", "#6aa5cf"),
    "pso": ("pso", "#8a4fa3"),
    "random": ("random", "#6d7278"),
}
"""The methods drawn, their names on the sheet and colours; other presets of ours lie on ours."""
PANELS = (
    ("value", "F_eva (22)", 1.0),
    ("left_out", "buildings left out", 100.0),
    ("seen", "quality seen along the ways", 1.0),
    ("sun", "hours of winter sun on fronts", 1.0),
)
"""Figure, title, and what it is multiplied by (100: per cent)."""
WIDE, HIGH, LEFT, TOP, GAP, NAMES = 62.0, 50.0, 11.0, 17.0, 15.0, 24.0
"""Millimetres: of a panel, before and above the first, between panels, for names at the right."""


def main(arguments: list[str]) -> None:
    """Measure, or draw what was measured."""
    if arguments[0] == "--measure":
        found = rows(int(arguments[1]))
        Path(arguments[2]).write_text(json.dumps(found))
        return
    found = json.loads(Path(arguments[0]).read_text())
    path = Path(arguments[1] if len(arguments) > 1 else "docs/site-methods.svg")
    path.write_text(sheet(found), encoding="utf-8")


def sheet(found: list[Row]) -> str:
    """The SVG text."""
    width = LEFT + len(PANELS) * (WIDE + GAP) - GAP + NAMES
    height = TOP + len(BUDGETS) * (HIGH + GAP) - GAP + 6.0
    seeds = len({row["seed"] for row in found})
    told = f"Scenes of 6 to 120 buildings, {seeds} seeds: medians and quartiles"
    marks = [
        shape([[(0, 0), (width, 0), (width, height), (0, height)]], fill="#ffffff"),
        text(told, (LEFT, 5.0), 3.6, text_anchor="start", font_weight="bold"),
    ]
    names = {"evaluations": f"{EVALUATIONS} evaluations", "seconds": f"{SECONDS:g} s each"}
    for j, equal in enumerate(BUDGETS):
        for k, panel in enumerate(PANELS):
            corner = (LEFT + k * (WIDE + GAP), TOP + j * (HIGH + GAP))
            marks.append(_panel(found, equal, panel, corner, k == len(PANELS) - 1))
        marks.append(
            text(
                names[equal],
                (LEFT, TOP + j * (HIGH + GAP) - 6.2),
                2.9,
                text_anchor="start",
                fill=GREY,
            )
        )
    return tag(
        "svg",
        "\n".join(map(mark_text, marks)),
        xmlns="http://www.w3.org/2000/svg",
        version="1.1",
        width=f"{width:g}mm",
        height=f"{height:g}mm",
        viewBox=f"0 0 {width:g} {height:g}",
        font_family=FONT,
        fill=INK,
    )


def _panel(
    found: list[Row],
    equal: str,
    panel: tuple[str, str, float],
    corner: tuple[float, float],
    named: bool,
) -> Mark:
    """One figure of all methods over the size of the scene."""
    name, words, times = panel
    sizes = sorted({row["buildings"] for row in found})
    curves = {
        method: times
        * np.array(
            [
                np.percentile(
                    [
                        row[name]
                        for row in chosen(found, equal=equal, method=method, buildings=size)
                    ],
                    (25, 50, 75),
                )
                for size in sizes
            ]
        )
        for method in COLOURS
    }
    every = times * np.array([row[name] for row in found if row["method"] in COLOURS])
    step = _step(float(np.percentile(every, 98)))
    top = step * np.ceil(max(float(c.max()) for c in curves.values()) / step)
    x = corner[0] + np.log(np.array(sizes) / sizes[0]) / np.log(sizes[-1] / sizes[0]) * WIDE

    def paper(values: Any) -> Any:
        return corner[1] + HIGH * (1.0 - np.asarray(values) / top)

    title = words + (", %" if times == 100.0 else "")
    marks = [text(title, (corner[0], corner[1] - 2.4), 2.9, text_anchor="start")]
    for value in np.arange(0.0, top + step / 2, step):
        y = float(paper(value))
        marks += [
            line([(corner[0], y), (corner[0] + WIDE, y)], stroke=PALE, stroke_width=0.15),
            text(number(float(value)), (corner[0] - 1.2, y), 2.3, text_anchor="end", fill=GREY),
        ]
    marks += [
        text(str(size), (at, corner[1] + HIGH + 2.6), 2.3, fill=GREY)
        for size, at in zip(sizes, x, strict=True)
    ]
    for method, (_, colour) in reversed(COLOURS.items()):
        low, middle, high = (paper(row) for row in curves[method].T)
        band = np.concatenate([np.stack([x, low], 1), np.stack([x, high], 1)[::-1]])
        marks += [
            shape([band], fill=colour, fill_opacity=0.13),
            line(
                np.stack([x, middle], 1),
                stroke=colour,
                fill="none",
                stroke_width=0.75 if method == "default" else 0.4,
            ),
        ]
    if named:
        ends = {method: float(paper(curve[-1, 1])) for method, curve in curves.items()}
        marks += _names(ends, corner[0] + WIDE + 1.5)
    return group(marks)


def _step(most: float) -> float:
    """A round distance of grid lines, about five up to some value."""
    rough = max(most, 1e-6) / 5.0
    unit = 10.0 ** np.floor(np.log10(rough))
    return float(unit * min((m for m in (1, 2, 5, 10) if m * unit >= rough), default=10))


def _names(ends: dict[str, float], x: float) -> list[Mark]:
    """The methods' names beside the ends of their curves, moved apart where they would meet."""
    order = sorted(ends, key=lambda method: ends[method])
    places = [ends[method] for method in order]
    for k in range(1, len(places)):
        places[k] = max(places[k], places[k - 1] + 3.2)
    return [
        text(
            COLOURS[method][0],
            (x, place),
            2.7,
            text_anchor="start",
            fill=COLOURS[method][1],
            font_weight="bold" if method == "default" else "normal",
        )
        for method, place in zip(order, places, strict=True)
    ]


if __name__ == "__main__":
    main(sys.argv[1:])
