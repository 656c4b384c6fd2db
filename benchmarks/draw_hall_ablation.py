"""Draws ``docs/hall-ablation.png``: plans with all four energies and without each in turn.

``python -m benchmarks.draw_hall_ablation [file]``: a row for the hall made for it and one for a
shipped sample in which a wall is generated. Each plan is the run of :mod:`.hall_ablation` whose
failing figure is the median of the seeds, so none is picked by hand.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from PIL import Image, ImageDraw, ImageFont

from benchmarks.hall_ablation import CASE, FIGURES, VARIANTS, Ablated, ablated, brief_of
from scenewright.core.layout import corners
from scenewright.domains.hall.problem import Floats, HallProblem

SEEDS, SOLVER = 8, "anneal"
FINE = 3
"""Drawn so many times larger, then reduced."""
PANEL, TOP, GAP = 352, 66, 16
CASES = (CASE, "sample:hall-reading-room")
INK, GREY, LINE = (38, 44, 52), (110, 118, 128), (70, 78, 88)
ZONES = ((237, 242, 247), (244, 240, 231), (238, 245, 238), (245, 238, 243))
CLEAR, BOX, COVERED, BORDER = (188, 211, 232), (62, 98, 138), (214, 92, 74), (214, 140, 40)
TITLES = {
    "all": ("all four energies", ""),
    "space": ("without space", "clearances covered: {:.0%}"),
    "fill": ("without fill", "emptiest zone: {:.0%} in use"),
    "access": ("without access", "passage {:.2f} of the width asked for"),
    "proportion": ("without proportion", "widest gap {:.1f} times the wished one"),
}
OTHERS = "covered {covered:.0%}, in use {use:.0%}, passage {passage:.2f}, gap {gap:.1f}"


def main(path: Path) -> None:
    """Run, draw and write the picture."""
    rows = [[panel(case, without) for without in VARIANTS] for case in CASES]
    heights = [row[0].height + GAP for row in rows]
    width = len(VARIANTS) * (PANEL + GAP) + GAP
    sheet = Image.new("RGB", (width, sum(heights) + GAP), "white")
    for number, row in enumerate(rows):
        for k, image in enumerate(row):
            sheet.paste(image, (GAP + k * (PANEL + GAP), GAP + sum(heights[:number])))
    sheet.save(path, optimize=True)


def panel(case: str, without: str) -> Image.Image:
    """One plan with its caption."""
    found = usual(case, without)
    title, told = TITLES[without]
    below = (
        told.format(found.figures[FIGURES[without][0]]) if told else OTHERS.format(**found.figures)
    )
    x0, y0, x1, y1 = found.problem.ground.bounds
    height = round(float((y1 - y0) * PANEL / (x1 - x0))) + TOP + 6
    image = Image.new("RGB", (PANEL * FINE, height * FINE), "white")
    draw = ImageDraw.Draw(image)
    draw.text((6 * FINE, 2 * FINE), title, INK, ImageFont.load_default(22 * FINE))
    draw.text((6 * FINE, 34 * FINE), below, GREY, ImageFont.load_default(16 * FINE))
    plan(draw, found)
    return image.resize((PANEL, height), Image.Resampling.LANCZOS)


def usual(case: str, without: str) -> Ablated:
    """The run whose failing figure is the median of the seeds (all weights: of the passages)."""
    brief = brief_of(case)
    found = [ablated(brief, without, seed, SOLVER) for seed in range(SEEDS)]
    name = FIGURES.get(without, ("passage", ""))[0]
    return sorted(found, key=lambda run: run.figures[name])[SEEDS // 2]


def plan(draw: Any, found: Ablated) -> None:
    """Zones, clearances, what of them is covered, footprints, walls generated, passages."""
    problem, boxes = found.problem, found.layout.boxes
    zones = [_ring(problem, k) for k in range(len(problem.zone_names))]
    for k, zone in enumerate(zones):
        draw.polygon(_at(problem, zone), fill=ZONES[k % len(ZONES)])
    clears = [shapely.Polygon(ring) for ring in corners(grown(problem, boxes))]
    for shape in clears:
        draw.polygon(_at(problem, shapely.get_coordinates(shape)), fill=CLEAR)
    floor = shapely.union_all([shapely.Polygon(zone) for zone in zones])
    for shape in covered(clears, floor):
        draw.polygon(_at(problem, shapely.get_coordinates(shape)), fill=COVERED)
    for ring in corners(boxes):
        draw.polygon(_at(problem, ring), fill=BOX)
    for zone in zones:
        draw.line(_at(problem, np.vstack([zone, zone[:1]])), fill=LINE, width=2 * FINE)
    for border in linked_borders(problem):
        draw.line(_at(problem, border), fill=BORDER, width=4 * FINE)
    for host, (low, high) in zip(problem.ground.hosts, found.layout.kept.walls, strict=True):
        start, along = host[:2], (host[2:4] - host[:2]) / np.hypot(*(host[2:4] - host[:2]))
        if high > low:
            ends = np.array([start + low * along, start + high * along])
            draw.line(_at(problem, ends), fill=INK, width=4 * FINE)


def linked_borders(problem: HallProblem) -> list[Floats]:
    """The stretches (2, 2) of the common borders of linked zones."""
    borders = np.asarray(problem.ground.borders, np.float64)
    return [row[:4].reshape(2, 2) for row in borders]


def covered(clears: list[Any], floor: Any) -> list[Any]:
    """Where clearances meet each other or leave the hall."""
    meets = [a.intersection(b) for k, a in enumerate(clears) for b in clears[:k]]
    outside = [shape.difference(floor) for shape in clears]
    parts = shapely.get_parts(np.array(meets + outside))
    return [part for part in parts if part.geom_type == "Polygon" and part.area > 0.005]


def grown(problem: HallProblem, boxes: Floats) -> Floats:
    """Boxes (n, 5) of the clearances."""
    front, left, back, right = problem.units.clear.T
    x, y, heading, width, depth = boxes.T
    ahead, aside = (front - back) / 2, (left - right) / 2
    cos, sin = np.cos(heading), np.sin(heading)
    return np.stack(
        [
            x + cos * ahead - sin * aside,
            y + sin * ahead + cos * aside,
            heading,
            width + left + right,
            depth + front + back,
        ],
        1,
    )


def _ring(problem: HallProblem, zone: int) -> Floats:
    first, last = problem.ground.zone_spans[zone]
    return np.asarray(problem.ground.zone_edges)[first:last, :2]


def _at(problem: HallProblem, points: Floats) -> list[tuple[float, float]]:
    """Metres to dots: y goes down, the hall stands below its caption."""
    x0, _, x1, y1 = problem.ground.bounds
    metre = (PANEL - 8) / (x1 - x0)
    return [
        (FINE * (4 + metre * float(x - x0)), FINE * (TOP + metre * float(y1 - y)))
        for x, y in points
    ]


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/hall-ablation.png"))
